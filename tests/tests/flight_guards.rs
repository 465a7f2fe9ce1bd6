//! The flight logic tick by tick: each guard of a flight at its very bound, one tick before it and when it must not act.

mod logic;

use logic::{BOTH, Bench, FRESH_TICKS, HOVER, TICK_US, table};
use mintime_firmware::config::{Capabilities, RUNAWAY_TICKS, SATURATED_TICKS, VehicleConfig};
use mintime_firmware::flight::FlightLogic;
use mintime_firmware::gyro::ImuSample;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, IncidentCause, KillSwitch, Purpose, RECORD_BYTES, RecordedTick,
    Refusal, Reply, Request, Setpoint, record_flags,
};
use mintime_shared::settings::Settings;
use mintime_shared::table::LinkPolicy;

/// Where a maneuver that is given up leads to, and why, with a host or without one.
fn check_given_up(bench: &mut Bench, host: bool, why: AbortReason) {
    let want = if host { FlightState::Tracking } else { FlightState::Recovery };
    assert_eq!(bench.logic.state(), want, "{why:?}");
    let telemetry = bench.telemetry();
    assert_eq!(telemetry.abort, Some(why));
    assert!(!telemetry.maneuver_complete);
}

/// In a maneuver, with a host that streams or without one for so long that its setpoints are stale.
fn maneuver(host: bool) -> Bench {
    let mut bench = Bench::maneuver();
    if !host {
        bench.stream = None;
        bench.run(FRESH_TICKS + 10);
    }
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
    bench
}

/// Samples lost here and there are flown through, up to the 24th of the maneuver; those before it do not count.
#[test]
fn scattered_lost_samples_end_the_maneuver() {
    for host in [true, false] {
        let mut bench = Bench::in_state(FlightState::Tracking);
        for _ in 0..30 {
            bench.tick_with(None, TICK_US, &[]);
            bench.tick(&[]);
        }
        assert_eq!(bench.trigger(), Reply::Done);
        if !host {
            bench.stream = None;
            bench.run(FRESH_TICKS + 10);
        }
        for lost in 1..=24 {
            assert_eq!(bench.logic.state(), FlightState::Maneuver, "{lost}");
            bench.tick(&[]);
            bench.tick_with(None, TICK_US, &[]);
        }
        check_given_up(&mut bench, host, AbortReason::LostSamples);
    }
}

/// A battery below its critical voltage for 160 ticks in a row ends the maneuver, a dip does not.
#[test]
fn a_sagging_battery_ends_the_maneuver() {
    for host in [true, false] {
        let mut bench = maneuver(host);
        let critical_v = VehicleConfig::REFERENCE.battery_critical_v;
        for (volts, ticks) in [(critical_v, 200), (critical_v - 0.01, 159), (critical_v, 1)] {
            bench.battery_v = Some(volts);
            bench.run(ticks);
            assert_eq!(bench.logic.state(), FlightState::Maneuver, "{volts} V");
        }
        bench.battery_v = Some(critical_v - 0.01);
        bench.run(159);
        assert_eq!(bench.logic.state(), FlightState::Maneuver);
        bench.run(1);
        check_given_up(&mut bench, host, AbortReason::BatterySag);
    }
}

/// Rotors at their limit for 120 ticks in a row end the maneuver; those of the flight before it do not count.
#[test]
fn saturated_rotors_end_the_maneuver() {
    // Rotors with little more than the plan asks for.
    let weak =
        VehicleConfig { rotor_thrust_max_n: 4.3, plan_thrust_max_mps2: 20.0, ..VehicleConfig::REFERENCE };
    for before in [HOVER, Setpoint { thrust_mps2: 60.0, ..HOVER }] {
        let mut bench = Bench::of(FlightLogic::new(Some(weak), BOTH, vec![[0; RECORD_BYTES]; 3200]));
        bench.run(900);
        let mut table = table();
        table.vehicle = weak.hash();
        bench.commit(&table);
        bench.arm();
        bench.stream = Some(before);
        bench.run(200);
        assert_eq!(bench.ask(Request::Trigger { checksum: table.checksum() }), Reply::Done);
        for _ in 0..400 {
            if bench.logic.state() != FlightState::Maneuver {
                break;
            }
            let mut sample = bench.sample();
            sample.gyro_radps[1] += 4.0;
            bench.tick_with(Some(sample), TICK_US, &[]);
        }
        check_given_up(&mut bench, true, AbortReason::MotorsSaturated);
        let record = bench.record();
        let saturates = |tick: &&RecordedTick| tick.flags & record_flags::SATURATED != 0;
        assert_eq!(record.iter().rev().take_while(saturates).count(), SATURATED_TICKS as usize);
        assert!(record.first().is_some_and(|tick| saturates(&tick)));
    }
}

/// Armed motors stop when nothing was heard of the host for longer than its timeout.
#[test]
fn a_silent_host_disarms() {
    let mut bench = Bench::armed();
    bench.heartbeat = false;
    bench.run(usize::from(Settings::DEFAULT.heartbeat_ms) * 1000 / TICK_US as usize);
    assert_eq!(bench.logic.state(), FlightState::Armed);
    bench.run(1);
    assert_eq!((bench.logic.state(), bench.out.throttle), (FlightState::Disarmed, None));
    assert_eq!(bench.abort(), Some(AbortReason::HeartbeatLost));
}

/// A maneuver whose table says so is abandoned with the first tick without a fresh setpoint.
#[test]
fn a_lost_link_ends_a_maneuver_that_is_to_be_abandoned() {
    let mut table = table();
    table.link = LinkPolicy::Abandon;
    let mut bench = Bench::ready();
    bench.commit(&table);
    bench.arm();
    bench.stream = Some(HOVER);
    bench.run(60);
    assert_eq!(bench.ask(Request::Trigger { checksum: table.checksum() }), Reply::Done);
    bench.run(100);
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
    let setpoint = bench.setpoint(HOVER);
    bench.stream = None;
    bench.tick(&[setpoint]);
    bench.run(FRESH_TICKS);
    assert_eq!(bench.logic.state(), FlightState::Maneuver);
    bench.run(1);
    check_given_up(&mut bench, false, AbortReason::LinkLost);
}

/// Motors that idle follow nothing yet: a hand that turns the vehicle is no runaway.
#[test]
fn an_armed_vehicle_does_not_run_away() {
    let mut bench = Bench::armed();
    for _ in 0..200 {
        let mut sample = bench.sample();
        sample.gyro_radps[2] += 10.0;
        bench.tick_with(Some(sample), TICK_US, &[Request::Heartbeat]);
    }
    assert_eq!(bench.logic.state(), FlightState::Armed);
}

/// The bench's cap stands in for a kill switch: with one it does not hold, without one no planned thrust passes it.
#[test]
fn the_bench_cap_holds_without_a_kill_switch_only() {
    let capped = Settings { bench_thrust_mps2: 4.0, ..Settings::DEFAULT };
    for (kill, thrust_mps2) in [(KillSwitch::Run, HOVER.thrust_mps2), (KillSwitch::Absent, 4.0)] {
        let mut bench = Bench::ready();
        bench.kill = kill;
        bench.stands = true;
        assert_eq!(bench.ask(Request::WriteSettings(capped)), Reply::Done);
        bench.commit(&table());
        bench.arm();
        bench.stream = Some(HOVER);
        bench.run(60);
        assert_eq!(bench.out.setpoint, Setpoint { thrust_mps2, ..HOVER }, "{kill:?}");
        let want = match kill {
            KillSwitch::Run => Reply::Done,
            _ => Reply::Refused(Refusal::BatteryThrust),
        };
        assert_eq!(bench.trigger(), want, "{kill:?}");
    }
}

/// A vehicle that does not know which way is up is not armed, though its gyro is calibrated.
#[test]
fn without_gravity_nothing_is_armed() {
    let mut bench = Bench::new();
    for _ in 0..1200 {
        let sample = ImuSample { accel_mps2: [0.0; 3], ..bench.sample() };
        bench.tick_with(Some(sample), TICK_US, &[]);
    }
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    let sample = ImuSample { accel_mps2: [0.0; 3], ..bench.sample() };
    bench.tick_with(Some(sample), TICK_US, &[Request::Arm(Purpose::Flight)]);
    let blocked = Refusal::ArmingBlocked(ArmingBlock::NOT_CALIBRATED.0);
    assert_eq!(bench.answer(bench.number), Some(Reply::Refused(blocked)));
}

/// A new state has its whole time to be followed: what ran away before it counts no more.
#[test]
fn a_runaway_is_counted_anew_in_each_state() {
    let mut bench = Bench::flying();
    let last = bench.setpoint(HOVER);
    bench.stream = None;
    bench.tick(&[last]);
    bench.run(FRESH_TICKS - 40);
    let mut ticks_in = |state: FlightState| {
        for ticks in 0.. {
            if bench.logic.state() != state {
                return ticks;
            }
            let mut sample = bench.sample();
            sample.gyro_radps[2] += 12.0;
            bench.tick_with(Some(sample), TICK_US, &[]);
        }
        0
    };
    assert_eq!(ticks_in(FlightState::Tracking), 41);
    assert_eq!(ticks_in(FlightState::Recovery), RUNAWAY_TICKS);
    assert_eq!(bench.abort(), Some(AbortReason::Runaway));
}

/// A cap below what four rotors give at idle leaves them at idle, in flight and in a test of one.
#[test]
fn a_bench_cap_below_idle_leaves_the_rotors_at_idle() {
    let config = VehicleConfig::REFERENCE;
    let idle_mps2 = 4.0 * config.rotor_thrust_idle_n / config.mass_kg;
    // Where the throttle is the speed, at the voltage that the thrust map holds for.
    assert_eq!(config.thrust_linear_share, 0.0);
    let idle = (config.rotor_thrust_idle_n / config.rotor_thrust_max_n).sqrt();
    for part in [0.2, 1.0] {
        let mut bench = Bench::ready();
        bench.battery_v = Some(config.battery_nominal_v);
        bench.kill = KillSwitch::Absent;
        bench.stands = true;
        let settings = Settings { bench_thrust_mps2: part * idle_mps2, ..Settings::DEFAULT };
        assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Done);
        let check = |throttle: f32| assert!((throttle - idle).abs() < 1e-6, "{part}: {throttle} for {idle}");
        assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
        let test = Request::TestMotor { motor: 0, throttle: 0.1, duration_ms: 100 };
        assert_eq!(bench.ask(test), Reply::Done);
        check(bench.out.throttle.expect("motors on").into_iter().fold(0.0, f32::max));
        assert_eq!(bench.ask(Request::Disarm), Reply::Done);
        bench.run(900);
        bench.arm();
        bench.stream = Some(HOVER);
        bench.run(60);
        assert_eq!(bench.logic.state(), FlightState::Tracking);
        bench.out.throttle.expect("motors on").into_iter().for_each(check);
    }
}

/// What stopped the motors in an earlier run blocks arming in this one, which has not stopped any.
#[test]
fn a_termination_of_an_earlier_run_blocks_arming() {
    let mut bench = Bench::ready();
    bench.logic.report(IncidentCause::Terminated(AbortReason::KillSwitch));
    let blocked = Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), blocked);
    assert_eq!(bench.acknowledge(), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    bench.arm();
}

/// A gyro that is not there is not silent and not uncalibrated: one bit tells what to look at.
#[test]
fn a_gyro_that_is_not_there_is_that_and_nothing_else() {
    let mut bench = Bench::with(Capabilities { gyro: false, motors: true });
    for _ in 0..900 {
        bench.tick_with(None, TICK_US, &[]);
    }
    assert_eq!(ArmingBlock(bench.telemetry().arming_block), ArmingBlock::NO_GYRO);
}

/// As long as no sample has come the gyro is silent: nobody waits for that to be found out.
#[test]
fn a_gyro_that_has_not_been_heard_is_silent() {
    let mut bench = Bench::new();
    let silent = |bench: &mut Bench| {
        let Some(Reply::Status(status)) = bench.answer(bench.number) else { panic!("no status") };
        ArmingBlock(status.arming_block).contains(ArmingBlock::GYRO_SILENT)
    };
    bench.tick_with(None, TICK_US, &[Request::Status]);
    assert!(silent(&mut bench));
    bench.tick(&[Request::Status]);
    assert!(!silent(&mut bench));
    bench.tick_with(None, TICK_US, &[Request::Status]);
    assert!(!silent(&mut bench));
}
