//! The fault table of `docs/safety.md`: each row is a fault in a phase of a flight, tried on the very image that gets flashed,
//! and the document's table is checked against this one.
//!
//! A virtual vehicle is brought into each phase once; every row breaks a copy of it. Then the row says in which state it must
//! end and how soon, how soon no speed controller is told to turn its motor, and what the vehicle says of it. In each row
//! whose motors stop arming stays blocked until a person has acknowledged, and nothing starts them again by itself.

mod bench;
mod fault_rows;

use fault_rows::{Fault, Phase, Row};
use mintime_firmware::supervisor::{Conditions, States, TRANSITIONS, Transition};
use mintime_shared::messages::FlightState;

/// Declares the rows and a test for each. `off` is when the motors stand, `told` what is said.
macro_rules! rows {
    ($($name:ident: $fault:ident in $phase:ident => $ends:ident $(within $ms:literal)? $(off $off:literal)? $(told $told:ident)?;)*) => {
        const ROWS: &[Row] = &[$(Row {
            fault: Fault::$fault,
            phase: Phase::$phase,
            ends_in: FlightState::$ends,
            within_ms: 0 $(+ $ms)?,
            off_ms: rows!(@some $($off)?),
            told: rows!(@text $($told)?),
        }),*];
        $(
            #[test]
            fn $name() {
                let row = ROWS.iter().find(|row| row.fault == Fault::$fault && row.phase == Phase::$phase);
                row.expect("declared above").check();
            }
        )*
    };
    (@some) => { None };
    (@some $value:literal) => { Some($value) };
    (@text) => { None };
    (@text $value:ident) => { Some(stringify!($value)) };
}

rows! {
    // The gyro.
    silent_gyro_disarmed: GyroSilent in Disarmed => Disarmed;
    silent_gyro_armed: GyroSilent in Armed => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_tracking: GyroSilent in Tracking => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_maneuver: GyroSilent in Maneuver => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_recovery: GyroSilent in Recovery => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_hop: GyroSilent in Hop => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_bench: GyroSilent in Bench => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_motor_test: GyroSilent in MotorTest => Terminated within 12 off 12 told GyroMissing;
    silent_gyro_turned: GyroSilent in Turned => Disarmed;
    frozen_gyro_disarmed: GyroFrozenLong in Disarmed => Disarmed;
    frozen_gyro_tracking: GyroFrozen in Tracking => Terminated within 35 off 35 told GyroFrozen;
    frozen_gyro_maneuver: GyroFrozen in Maneuver => Terminated within 35 off 35 told GyroFrozen;
    saturated_gyro_tracking: GyroSaturated in Tracking => Terminated within 8 off 8 told GyroSaturated;
    saturated_gyro_maneuver: GyroSaturated in Maneuver => Terminated within 8 off 8 told GyroSaturated;
    reversed_gyro_tracking: GyroReversed in Tracking => Terminated within 600 off 600 told GyroSaturated;
    reversed_gyro_maneuver: GyroReversed in Maneuver => Terminated within 100 off 100 told GyroSaturated;
    bus_high_tracking: BusHigh in Tracking => Terminated within 12 off 12 told GyroMissing;
    bus_low_tracking: BusLow in Tracking => Terminated within 12 off 12 told GyroMissing;
    bus_low_disarmed: BusLow in Disarmed => Disarmed;
    loose_bus_tracking: BusLoose in Tracking => Tracking;
    loose_bus_maneuver: BusLoose in Maneuver => Tracking within 160 told LostSamples;
    noisy_edges_tracking: NoisyEdges in Tracking => Tracking;
    noisy_edges_maneuver: NoisyEdges in Maneuver => Tracking within 490;
    ringing_10_us_disarmed: Ringing10 in Disarmed => Disarmed;
    ringing_10_us_tracking: Ringing10 in Tracking => Tracking;
    ringing_10_us_maneuver: Ringing10 in Maneuver => Tracking within 490;
    ringing_5_us_disarmed: Ringing5 in Disarmed => Disarmed;
    ringing_5_us_tracking: Ringing5 in Tracking => Tracking;
    ringing_5_us_maneuver: Ringing5 in Maneuver => Tracking within 490;
    ringing_1_us_disarmed: Ringing1 in Disarmed => Disarmed;
    ringing_1_us_tracking: Ringing1 in Tracking => Tracking;
    ringing_1_us_maneuver: Ringing1 in Maneuver => Tracking within 490;
    ringing_silent_tracking: RingingSilent in Tracking => Terminated within 35 off 35 told GyroFrozen;
    ringing_silent_maneuver: RingingSilent in Maneuver => Terminated within 35 off 35 told GyroFrozen;
    // The link and the host.
    flipped_bits_tracking: FlippedBits in Tracking => Tracking;
    lost_bytes_tracking: LostBytes in Tracking => Tracking;
    line_noise_tracking: LineNoise in Tracking => Tracking;
    line_noise_disarmed: LineNoise in Disarmed => Disarmed;
    full_load_tracking: FullLoad in Tracking => Tracking;
    full_load_maneuver: FullLoad in Maneuver => Tracking within 490;
    link_cut_disarmed: LinkCut in Disarmed => Disarmed;
    link_cut_armed: LinkCut in Armed => Disarmed within 505 off 505 told HeartbeatLost;
    link_cut_tracking: LinkCut in Tracking => Terminated within 2110 off 2110 told LinkLost;
    link_cut_low: LinkCut in Low => Landed within 2100 off 2100 told LinkLost;
    link_cut_maneuver: LinkCut in Maneuver => Recovery within 490;
    link_cut_abandon: LinkCut in Abandon => Recovery within 110 told LinkLost;
    link_cut_recovery: LinkCut in Recovery => Terminated within 1910 off 1910 told LinkLost;
    link_cut_hop: LinkCut in Hop => Terminated within 2110 off 2110 told LinkLost;
    link_cut_bench: LinkCut in Bench => Landed within 1050 off 1050 told LinkLost;
    link_cut_motor_test: LinkCut in MotorTest => Disarmed within 505 off 505 told HeartbeatLost;
    link_cut_turned: LinkCut in Turned => Disarmed;
    link_cut_boot: LinkCut in Boot => Disarmed within 600;
    link_cut_calibrating: LinkCut in Calibrating => Disarmed within 450;
    link_cut_landed: LinkCut in Landed => Landed told LinkLost;
    link_cut_terminated: LinkCut in Terminated => Terminated told EmergencyStop;
    setpoints_stop_armed: SetpointsStop in Armed => Armed;
    setpoints_stop_tracking: SetpointsStop in Tracking => Terminated within 2110 off 2110 told LinkLost;
    cameras_silent_tracking: CamerasSilent in Tracking => Terminated within 1010 off 1010 told EmergencyStop;
    cameras_silent_maneuver: CamerasSilent in Maneuver => Terminated within 1010 off 1010 told EmergencyStop;
    emergency_stop_armed: EmergencyStop in Armed => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_disarmed: EmergencyStop in Disarmed => Terminated within 5 told EmergencyStop;
    emergency_stop_tracking: EmergencyStop in Tracking => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_maneuver: EmergencyStop in Maneuver => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_recovery: EmergencyStop in Recovery => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_hop: EmergencyStop in Hop => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_bench: EmergencyStop in Bench => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_motor_test: EmergencyStop in MotorTest => Terminated within 5 off 5 told EmergencyStop;
    emergency_stop_turned: EmergencyStop in Turned => Terminated within 5 told EmergencyStop;
    disarm_tracking: Disarm in Tracking => Disarmed within 5 off 5;
    disarm_maneuver: Disarm in Maneuver => Disarmed within 5 off 5;
    disarm_motor_test: Disarm in MotorTest => Disarmed within 5 off 5;
    // Motors and battery.
    dead_motor_tracking: DeadMotor in Tracking => Terminated within 300 off 300 told Runaway;
    dead_motor_maneuver: DeadMotor in Maneuver => Terminated within 300 off 300 told Runaway;
    dead_signal_tracking: DeadSignal in Tracking => Terminated within 400 off 400 told Runaway;
    dead_signal_maneuver: DeadSignal in Maneuver => Terminated within 400 off 400 told Runaway;
    frame_ends_lost_disarmed: FrameEndsLost in Disarmed => Disarmed;
    frame_ends_lost_armed: FrameEndsLost in Armed => Boot within 13 off 12 told SetUp;
    frame_ends_lost_tracking: FrameEndsLost in Tracking => Boot within 13 off 12 told SetUp;
    frame_ends_lost_maneuver: FrameEndsLost in Maneuver => Boot within 13 off 12 told SetUp;
    battery_sag_tracking: BatterySag in Tracking => Tracking;
    battery_sag_maneuver: BatterySag in Maneuver => Tracking within 260 told BatterySag;
    sense_lost_disarmed: SenseLost in Disarmed => Disarmed;
    sense_lost_tracking: SenseLost in Tracking => Tracking;
    sense_lost_maneuver: SenseLost in Maneuver => Tracking within 490;
    // The processor.
    slow_lsi_tracking: LsiSlow in Tracking => Tracking;
    fast_lsi_tracking: LsiFast in Tracking => Tracking;
    stall_tracking: Stall in Tracking => Tracking;
    stall_maneuver: Stall in Maneuver => Tracking within 20 told LateTicks;
    stall_recovery: Stall in Recovery => Terminated within 1910 off 1910 told LinkLost;
    dead_tick_armed: TickDead in Armed => Boot within 120 off 125 told Watchdog;
    dead_tick_tracking: TickDead in Tracking => Boot within 120 off 125 told Watchdog;
    dead_tick_slow_lsi: TickDeadLsiSlow in Tracking => Boot within 205 off 101 told Watchdog;
    dead_tick_fast_lsi: TickDeadLsiFast in Tracking => Boot within 90 off 100 told Watchdog;
    dead_tick_maneuver: TickDead in Maneuver => Boot within 120 off 125 told Watchdog;
    dead_tick_motor_test: TickDead in MotorTest => Boot within 120 off 125 told Watchdog;
    dead_supervision_tracking: SupervisionDead in Tracking => Boot within 120 off 125 told Watchdog;
    dead_supervision_armed: SupervisionDead in Armed => Boot within 120 off 125 told Watchdog;
    dead_supervision_maneuver: SupervisionDead in Maneuver => Boot within 120 off 125 told Watchdog;
    dead_link_task_tracking: LinkTaskDead in Tracking => Boot within 120 off 125 told Watchdog;
    hanging_tasks_maneuver: TasksHang in Maneuver => Boot within 120 off 125 told Watchdog;
    stack_overflow_tracking: StackOverflow in Tracking => Boot within 12 off 1 told StackOverflow;
    stack_overflow_armed: StackOverflow in Armed => Boot within 12 off 1 told StackOverflow;
    stack_overflow_maneuver: StackOverflow in Maneuver => Boot within 12 off 1 told StackOverflow;
    panic_tracking: Panic in Tracking => Boot within 12 off 1 told Panic;
    panic_armed: Panic in Armed => Boot within 12 off 1 told Panic;
    panic_maneuver: Panic in Maneuver => Boot within 12 off 1 told Panic;
    panic_motor_test: Panic in MotorTest => Boot within 12 off 1 told Panic;
    panic_disarmed: Panic in Disarmed => Boot within 12 told Panic;
    hard_fault_armed: HardFault in Armed => Boot within 12 off 1 told HardFault;
    hard_fault_tracking: HardFault in Tracking => Boot within 12 off 1 told HardFault;
    hard_fault_maneuver: HardFault in Maneuver => Boot within 12 off 1 told HardFault;
    hard_fault_recovery: HardFault in Recovery => Boot within 12 off 1 told HardFault;
    double_fault_tracking: DoubleFault in Tracking => Boot within 120 off 125 told Watchdog;
    double_fault_armed: DoubleFault in Armed => Boot within 120 off 125 told Watchdog;
    double_fault_maneuver: DoubleFault in Maneuver => Boot within 120 off 125 told Watchdog;
    stray_interrupt_tracking: StrayInterrupt in Tracking => Boot within 12 off 1 told UnexpectedInterrupt;
    crystal_disarmed: CrystalLost in Disarmed => Boot within 12 told ClockLost;
    crystal_armed: CrystalLost in Armed => Boot within 12 off 1 told ClockLost;
    crystal_tracking: CrystalLost in Tracking => Boot within 12 off 1 told ClockLost;
    crystal_maneuver: CrystalLost in Maneuver => Boot within 12 off 1 told ClockLost;
    crystal_recovery: CrystalLost in Recovery => Boot within 12 off 1 told ClockLost;
    brown_out_armed: BrownOut in Armed => Boot within 12 off 1 told BrownOut;
    brown_out_tracking: BrownOut in Tracking => Boot within 12 off 1 told BrownOut;
    brown_out_maneuver: BrownOut in Maneuver => Boot within 12 off 1 told BrownOut;
    brown_out_recovery: BrownOut in Recovery => Boot within 12 off 1 told BrownOut;
    brown_out_disarmed: BrownOut in Disarmed => Boot within 12 told BrownOut;
    brown_out_boot: BrownOut in Boot => Boot within 12 told BrownOut;
    brown_out_calibrating: BrownOut in Calibrating => Boot within 12 told BrownOut;
    brown_out_landed: BrownOut in Landed => Boot within 12 told BrownOut;
    brown_out_terminated: BrownOut in Terminated => Boot within 12 told BrownOut;
    brown_out_hop: BrownOut in Hop => Boot within 12 off 1 told BrownOut;
    brown_out_bench: BrownOut in Bench => Boot within 12 off 1 told BrownOut;
    brown_out_motor_test: BrownOut in MotorTest => Boot within 12 off 1 told BrownOut;
    brown_out_turned: BrownOut in Turned => Boot within 12 told BrownOut;
    reset_tracking: Reset in Tracking => Boot within 12 off 12;
    reset_maneuver: Reset in Maneuver => Boot within 12 off 12;
    reset_disarmed: Reset in Disarmed => Boot within 12;
    reset_armed: Reset in Armed => Boot within 12 off 12;
    reset_recovery: Reset in Recovery => Boot within 12 off 12;
    reset_landed: Reset in Landed => Boot within 12;
    reset_terminated: Reset in Terminated => Boot within 12 told EmergencyStop;
    reset_boot: Reset in Boot => Boot within 12;
    reset_calibrating: Reset in Calibrating => Boot within 12;
    power_cut_tracking: PowerCut in Tracking => Boot within 12 off 12;
    cut_in_write_disarmed: CutInWrite in Disarmed => Boot within 12;
    cut_in_erase_disarmed: CutInErase in Disarmed => Boot within 12;
    decayed_store_disarmed: StoreDecays in Disarmed => Boot within 12 told StoreDamaged;
    // The kill switch.
    kill_disarmed: KillPressed in Disarmed => Disarmed;
    kill_armed: KillPressed in Armed => Terminated within 8 off 8 told KillSwitch;
    kill_tracking: KillPressed in Tracking => Terminated within 8 off 8 told KillSwitch;
    kill_maneuver: KillPressed in Maneuver => Terminated within 8 off 8 told KillSwitch;
    kill_recovery: KillPressed in Recovery => Terminated within 8 off 8 told KillSwitch;
    kill_hop: KillPressed in Hop => Terminated within 8 off 8 told KillSwitch;
    kill_motor_test: KillPressed in MotorTest => Terminated within 8 off 8 told KillSwitch;
    kill_turned: KillPressed in Turned => Disarmed;
    radio_silent_tracking: RadioSilent in Tracking => Terminated within 257 off 257 told KillLost;
    radio_silent_maneuver: RadioSilent in Maneuver => Terminated within 257 off 257 told KillLost;
    radio_noisy_tracking: RadioNoisy in Tracking => Terminated within 257 off 257 told KillLost;
    radio_noisy_disarmed: RadioNoisy in Disarmed => Disarmed;
    radio_noisy_armed: RadioNoisy in Armed => Terminated within 257 off 257 told KillLost;
    radio_noisy_maneuver: RadioNoisy in Maneuver => Terminated within 257 off 257 told KillLost;
    radio_noisy_motor_test: RadioNoisy in MotorTest => Terminated within 257 off 257 told KillLost;
    radio_lost_tracking: RadioLost in Tracking => Terminated within 45 off 45 told KillLost;
}

/// Every row of the document is a row here, and the other way round, in this order.
#[test]
fn the_document_says_what_the_tests_check() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/safety.md");
    let document = std::fs::read_to_string(path).expect("the document");
    let head = "| fault | in | ends in | within | motors off within | told |";
    let (_, table) = document.split_once(head).unwrap_or_else(|| panic!("{path} has no table `{head}`"));
    let lines: Vec<&str> = table.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    let rows: Vec<String> = ROWS.iter().map(Row::line).collect();
    let stale: Vec<_> = lines.iter().filter(|line| !rows.iter().any(|row| row == *line)).collect();
    let missing: Vec<_> = rows.iter().filter(|row| !lines.contains(&row.as_str())).collect();
    assert!(
        stale.is_empty() && missing.is_empty(),
        "docs/safety.md says otherwise than the tests.\ntake out:\n{stale:#?}\nput in:\n{missing:#?}"
    );
    assert_eq!(lines, rows, "the same rows, in another order");
}

/// The document's table of transitions is the supervisor's.
#[test]
fn the_document_tells_the_supervisors_transitions() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/safety.md");
    let document = std::fs::read_to_string(path).expect("the document");
    let head = "| # | from | when | unless | to | reported |";
    let (_, table) = document.split_once(head).unwrap_or_else(|| panic!("{path} has no table `{head}`"));
    let lines: Vec<&str> = table.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    let rows: Vec<String> =
        TRANSITIONS.iter().zip(1..).map(|(row, number)| transition_line(number, row)).collect();
    assert_eq!(lines, rows, "put in:\n{}", rows.join("\n"));
}

fn transition_line(number: usize, row: &Transition) -> String {
    let conditions = |set: Conditions| {
        set.iter_names().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ")
    };
    let states = |set: States| {
        let all = FlightState::ALL.into_iter().filter(|state| set.contains(States::from(*state)));
        all.map(|state| format!("`{state:?}`")).collect::<Vec<_>>().join(", ")
    };
    let from = if row.from == States::all().difference(States::TERMINATED) {
        "all but `Terminated`".to_owned()
    } else if row.from.contains(States::MOTORS_ON) {
        let others = states(row.from.difference(States::MOTORS_ON));
        if others.is_empty() { "motors on".to_owned() } else { format!("motors on, {others}") }
    } else {
        states(row.from)
    };
    let reason = row.reason.map_or(String::new(), |reason| format!("`{reason:?}`"));
    let cells = [
        number.to_string(),
        from,
        conditions(row.when),
        conditions(row.unless),
        format!("`{:?}`", row.to),
        reason,
    ];
    let cells = cells.map(|cell| if cell.is_empty() { " ".to_owned() } else { format!(" {cell} ") });
    format!("|{}|", cells.join("|"))
}

/// No fault is declared twice for one phase: only the first would be tried.
#[test]
fn no_row_is_there_twice() {
    for (index, row) in ROWS.iter().enumerate() {
        let earlier = ROWS[..index].iter().find(|r| r.fault == row.fault && r.phase == row.phase);
        assert!(earlier.is_none(), "{}", row.line());
    }
    assert!(ROWS.len() >= 40);
}
