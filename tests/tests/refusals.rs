//! Every refusal and every reason that blocks arming, provoked: each comes when it must, changes nothing, and is gone with
//! its cause.

mod logic;

use logic::{
    BOTH, Bench, FRESH_TICKS, HOVER, TICK_US, bytes_of, chunk, made_for, name, status, table, table_of,
};
use mintime_firmware::config::{BoardStatus, Capabilities, StoreStatus, VehicleConfig};
use mintime_firmware::flight::FlightLogic;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::keeping::Key;
use mintime_firmware::store::Damage;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::{Decoder, encode};
use mintime_shared::messages::{
    ArmingBlock, CalibrationError, Downlink, FlightState, IncidentCause, KillSwitch, Message,
    PROTOCOL_VERSION, Purpose, RECORD_BYTES, REQUEST_AGE_MS, Refusal, Reply, Request, STORED_TABLES,
    Setpoint, Uplink,
};
use mintime_shared::settings::{Settings, SettingsError};
use mintime_shared::table::TableError;
use mintime_shared::vehicle::VehicleError;

const ARM: Request = Request::Arm(Purpose::Flight);

// ---------------------------------------------------------------------------------------------------------- refusals

/// Number of a refusal's kind. A new kind does not compile until it is here, and then it must be provoked.
fn kind(refusal: &Refusal) -> usize {
    match refusal {
        Refusal::ProtocolVersion => 0,
        Refusal::MotorsOn => 1,
        Refusal::WrongState(_) => 2,
        Refusal::ArmingBlocked(_) => 3,
        Refusal::Table(_) => 4,
        Refusal::NotStaged => 5,
        Refusal::NotCommitted => 6,
        Refusal::StaleSetpoint => 7,
        Refusal::BatteryLow => 8,
        Refusal::NotFinite => 9,
        Refusal::NoRecord => 10,
        Refusal::OutOfRange => 11,
        Refusal::BatteryThrust => 12,
        Refusal::OutsideGate => 13,
        Refusal::Gap { .. } => 14,
        Refusal::Vehicle(_) => 15,
        Refusal::Settings(_) => 16,
        Refusal::NoSuchTable => 17,
        Refusal::StoreFull => 18,
        Refusal::StoreFailed => 19,
        Refusal::NoSuchIncident => 20,
        Refusal::KillSwitch => 21,
        Refusal::NotSealed => 22,
        Refusal::Calibration(_) => 23,
        Refusal::OtherPurpose => 24,
        Refusal::Late => 25,
    }
}

const KINDS: usize = 26;

/// What a refusal must leave as it was.
fn fingerprint(bench: &mut Bench) -> String {
    let table = bench.read_table();
    let ask = |bench: &mut Bench, request| format!("{:?}", bench.ask(request));
    let kept = [Request::ReadSettings, Request::ReadVehicle, Request::ListTables].map(|r| ask(bench, r));
    format!("{:?} {:?} {table:?} {kept:?}", bench.logic.state(), bench.logic.pairing())
}

/// A request that is refused, and what makes the very same request one that is taken.
struct Case {
    bench: Bench,
    request: Request,
    want: Refusal,
    mend: fn(&mut Bench),
    /// The answer afterwards; any but a refusal if there is none.
    then: Option<Reply>,
}

fn case(bench: Bench, request: Request, want: Refusal, mend: fn(&mut Bench)) -> Case {
    Case { bench, request, want, mend, then: None }
}

fn disarm(bench: &mut Bench) {
    bench.stream = None;
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
}

fn cases() -> Vec<Case> {
    let trigger = Request::Trigger { checksum: table().checksum() };
    let other = table_of("horizontal_5");
    let mut all = Vec::new();

    // Motors on: everything that would change what is flown, or write to flash.
    let mut other_settings = Settings::DEFAULT;
    other_settings.heartbeat_ms = 700;
    let mut heavier = VehicleConfig::REFERENCE;
    heavier.mass_kg = 0.8;
    for state in FlightState::ALL.into_iter().filter(|s| s.motors_on()) {
        for request in [
            chunk(100, 0, &[1; 50]),
            Request::CommitTable { checksum: table().checksum() },
            Request::StoreTable { name: name("flip"), checksum: table().checksum() },
            Request::DeleteTable { name: name("flip") },
            Request::WriteVehicle(heavier),
            Request::WriteSettings(other_settings),
            Request::Pair(Some([7; 16])),
        ] {
            all.push(case(Bench::in_state(state), request, Refusal::MotorsOn, disarm));
        }
    }
    let mut stored = Bench::ready();
    stored.commit(&table());
    stored.ask(Request::StoreTable { name: name("flip"), checksum: table().checksum() });
    stored.arm();
    all.push(case(stored, Request::LoadTable { name: name("flip") }, Refusal::MotorsOn, disarm));
    let mut told = Bench::ready();
    told.logic.report(IncidentCause::Watchdog);
    let incident = told.telemetry().incident.expect("it waits").number;
    told.acknowledge();
    told.arm();
    all.push(case(told, Request::Acknowledge { incident }, Refusal::MotorsOn, disarm));

    // Wrong state.
    let wrong = |state| Refusal::WrongState(state);
    use FlightState::{Armed, Calibrating, Disarmed, Landed, Maneuver, Recovery, Terminated, Tracking};
    fn rest(bench: &mut Bench) {
        disarm(bench);
        bench.run(900);
    }
    for state in [Tracking, Maneuver, Recovery] {
        all.push(case(Bench::in_state(state), ARM, wrong(state), rest));
    }
    for state in [Armed, Tracking, Landed] {
        all.push(case(Bench::in_state(state), Request::Calibrate, wrong(state), disarm));
        let turns = Request::CalibrateScale { axis: 2, turns: 1 };
        all.push(case(Bench::in_state(state), turns, wrong(state), disarm));
    }
    let turns = Request::CalibrateScale { axis: 2, turns: 1 };
    all.push(case(Bench::in_state(Calibrating), turns, wrong(Calibrating), |bench| bench.run(900)));
    all.push(case(Bench::in_state(Terminated), Request::Disarm, wrong(Terminated), |bench| {
        assert_eq!(bench.acknowledge(), Reply::Done);
    }));
    all.push(case(Bench::in_state(Armed), trigger.clone(), wrong(Armed), |bench| {
        bench.stream = Some(HOVER);
        bench.run(60);
    }));
    all.push(case(Bench::in_state(Armed), Request::Record, wrong(Armed), |bench| {
        bench.stream = Some(HOVER);
        bench.run(20);
    }));
    all.push(case(Bench::in_state(Maneuver), Request::ReadRecord { first: 0 }, wrong(Maneuver), |bench| {
        bench.run_while(FlightState::Maneuver, 2000);
    }));
    let test = Request::TestMotor { motor: 1, throttle: 0.1, duration_ms: 100 };
    all.push(case(Bench::in_state(Disarmed), test.clone(), wrong(Disarmed), |bench| {
        assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    }));

    // Arming: each reason below.
    let mut low = Bench::ready();
    low.battery_v = Some(13.9);
    all.push(case(low, ARM, Refusal::ArmingBlocked(ArmingBlock::BATTERY_LOW.0), |bench| {
        bench.battery_v = Some(15.5);
    }));

    // Tables.
    let mut foreign = Bench::ready();
    let (bytes, checksum) = made_for(0xdead_beef);
    foreign.stage(&bytes);
    all.push(Case {
        bench: foreign,
        request: Request::CommitTable { checksum },
        want: Refusal::Table(TableError::OtherVehicle),
        mend: |bench| {
            // The same checksum cannot be made for this vehicle: another table must take its place.
            bench.stage(&bytes_of(&table()));
        },
        then: Some(Reply::Refused(Refusal::NotStaged)),
    });
    let mut nothing = Bench::ready();
    nothing.commit(&other);
    let commit = Request::CommitTable { checksum: table().checksum() };
    all.push(case(nothing, commit, Refusal::NotStaged, |bench| {
        bench.stage(&bytes_of(&table()));
    }));
    let mut half = Bench::ready();
    let whole = bytes_of(&table());
    half.ask(chunk(whole.len(), 0, &whole[..60]));
    let gap = Refusal::Gap { expected: 60 };
    all.push(case(half, chunk(whole.len(), 90, &whole[90..]), gap, |bench| {
        let whole = bytes_of(&table());
        bench.ask(chunk(whole.len(), 60, &whole[60..90]));
    }));
    let mut half = Bench::ready();
    half.ask(chunk(whole.len(), 0, &whole[..60]));
    let commit = Request::CommitTable { checksum: table().checksum() };
    all.push(case(half, commit, gap, |bench| {
        let whole = bytes_of(&table());
        bench.ask(chunk(whole.len(), 60, &whole[60..]));
    }));
    let mut bench = Bench::ready();
    bench.commit(&other);
    let store = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    all.push(case(bench, store, Refusal::NotCommitted, |bench| bench.commit(&table())));
    let store = Request::StoreTable { name: name(""), checksum: table().checksum() };
    let mut bench = Bench::ready();
    bench.commit(&table());
    all.push(Case {
        then: Some(Reply::Refused(Refusal::NotCommitted)),
        ..case(bench, store, Refusal::NotCommitted, |_| ())
    });
    all.push(case(
        Bench::ready(),
        Request::LoadTable { name: name("flip") },
        Refusal::NoSuchTable,
        |bench| {
            bench.commit(&table());
            bench.ask(Request::StoreTable { name: name("flip"), checksum: table().checksum() });
        },
    ));
    let mut full = Bench::ready();
    full.commit(&table());
    for n in 0..STORED_TABLES {
        let store = Request::StoreTable { name: name(&format!("t{n}")), checksum: table().checksum() };
        assert_eq!(full.ask(store), Reply::Done);
    }
    let store = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    all.push(case(full, store, Refusal::StoreFull, |bench| {
        assert_eq!(bench.ask(Request::DeleteTable { name: name("t3") }), Reply::Done);
    }));

    // The trigger.
    let flying = |checksum_known: bool| {
        let mut bench = Bench::ready();
        bench.commit(&if checksum_known { table() } else { table_of("horizontal_5") });
        bench.arm();
        bench.stream = Some(HOVER);
        bench.run(60);
        bench
    };
    all.push(case(flying(false), trigger.clone(), Refusal::NotCommitted, |bench| {
        disarm(bench);
        bench.commit(&table());
        bench.run(900);
        bench.arm();
        bench.stream = Some(HOVER);
        bench.run(60);
    }));
    let mut low = flying(true);
    low.battery_v = None;
    all.push(case(low, trigger.clone(), Refusal::BatteryLow, |bench| bench.battery_v = Some(15.5)));
    // Rotors that are weak for their weight: enough for the plan at the nominal voltage, not at a lower one.
    let mut weak = VehicleConfig::REFERENCE;
    weak.rotor_thrust_max_n = 4.3;
    weak.plan_thrust_max_mps2 = 20.0;
    weak.battery_low_v = 13.0;
    assert_eq!(weak.check(), Ok(()));
    let mut bench = Bench::of(FlightLogic::new(Some(weak), BOTH, vec![[0; RECORD_BYTES]; 10]));
    bench.run(900);
    let mut its_own = table();
    its_own.vehicle = weak.hash();
    bench.commit(&its_own);
    bench.arm();
    bench.stream = Some(HOVER);
    bench.run(60);
    bench.battery_v = Some(13.1);
    let its_trigger = Request::Trigger { checksum: its_own.checksum() };
    all.push(case(bench, its_trigger, Refusal::BatteryThrust, |bench| bench.battery_v = Some(15.5)));
    let mut tilted = flying(true);
    tilted.stream = Some(Setpoint { rates_radps: [0.0, 0.5, 0.0], ..HOVER });
    tilted.run(320);
    tilted.stream = Some(HOVER);
    tilted.run(60);
    all.push(case(tilted, trigger.clone(), Refusal::OutsideGate, |bench| {
        bench.stream = Some(Setpoint { rates_radps: [0.0, -0.5, 0.0], ..HOVER });
        bench.run(320);
        bench.stream = Some(HOVER);
        bench.run(60);
    }));
    let later_trigger = trigger.clone();
    let mut turning = flying(true);
    turning.stream = Some(Setpoint { rates_radps: [0.0, 0.0, 0.8], ..HOVER });
    turning.run(100);
    all.push(case(turning, trigger, Refusal::OutsideGate, |bench| {
        bench.stream = Some(HOVER);
        bench.run(60);
    }));

    // Numbers.
    let wild = |rate: f32| Request::Setpoint {
        sequence: 900,
        setpoint: Setpoint { rates_radps: [rate; 3], ..HOVER },
    };
    let stays = |request, want| Case {
        then: Some(Reply::Refused(want)),
        ..case(Bench::flying(), request, want, |_| ())
    };
    all.push(stays(wild(f32::NAN), Refusal::NotFinite));
    all.push(stays(wild(f32::INFINITY), Refusal::NotFinite));
    all.push(stays(wild(35.1), Refusal::OutOfRange));
    all.push(stays(Request::SetTelemetry { period_ms: 4 }, Refusal::OutOfRange));
    all.push(stays(Request::SetTelemetry { period_ms: 101 }, Refusal::OutOfRange));
    for (motor, throttle, duration_ms) in
        [(4, 0.1, 10), (0, 0.151, 10), (0, -0.01, 10), (0, f32::NAN, 10), (0, 0.1, 2001)]
    {
        let mut bench = Bench::ready();
        bench.ask(Request::Arm(Purpose::MotorTest));
        let request = Request::TestMotor { motor, throttle, duration_ms };
        all.push(Case { bench, ..stays(request, Refusal::OutOfRange) });
    }
    all.push(stays(Request::ReadRecord { first: 1 }, Refusal::NoRecord));

    // Vehicle and settings.
    let mut lead = VehicleConfig::REFERENCE;
    lead.mass_kg = 21.0;
    all.push(Case {
        bench: Bench::ready(),
        ..stays(Request::WriteVehicle(lead), Refusal::Vehicle(VehicleError::Mass))
    });
    let mut hasty = Settings::DEFAULT;
    hasty.heartbeat_ms = 100;
    let refused = Refusal::Settings(SettingsError::Timeouts);
    all.push(Case { bench: Bench::ready(), ..stays(Request::WriteSettings(hasty), refused) });

    // What came too late: the next one is in time.
    let in_time = |bench: &mut Bench| bench.age_ms = 0;
    let late = |bench: Bench| bench.aged(REQUEST_AGE_MS + 1);
    all.push(case(late(Bench::ready()), ARM, Refusal::Late, in_time));
    // Of a start before this one, when it had been on for a minute.
    all.push(case(Bench::ready().aged(0u32.wrapping_sub(60_000)), ARM, Refusal::Late, in_time));
    let mut tested = Bench::ready();
    tested.ask(Request::Arm(Purpose::MotorTest));
    all.push(case(late(tested), test.clone(), Refusal::Late, in_time));
    all.push(case(late(flying(true)), later_trigger, Refusal::Late, in_time));

    // Incidents and the kill switch.
    all.push(stays(Request::Acknowledge { incident: 3 }, Refusal::MotorsOn));
    let mut told = Bench::ready();
    told.logic.report(IncidentCause::Watchdog);
    let incident = told.telemetry().incident.expect("it waits").number;
    all.push(case(told, Request::Acknowledge { incident: incident + 1 }, Refusal::NoSuchIncident, |bench| {
        bench.logic.report(IncidentCause::BrownOut);
        assert_eq!(bench.acknowledge(), Reply::Done);
    }));
    for kill in [KillSwitch::Stop, KillSwitch::Lost] {
        let mut bench = Bench::in_state(Terminated);
        let incident = bench.telemetry().incident.expect("it waits").number;
        bench.kill = kill;
        let acknowledge = Request::Acknowledge { incident };
        all.push(case(bench, acknowledge, Refusal::KillSwitch, |bench| bench.kill = KillSwitch::Run));
    }

    // Calibration.
    for (axis, turns) in [(3, 1), (0, 5), (0, -5), (255, 1)] {
        let request = Request::CalibrateScale { axis, turns };
        let refused = Refusal::Calibration(CalibrationError::Turns);
        all.push(Case { bench: Bench::ready(), ..stays(request, refused) });
    }

    // Armed for something else.
    fn rearm(bench: &mut Bench, purpose: Purpose) {
        disarm(bench);
        bench.run(900);
        assert_eq!(bench.ask(Request::Arm(purpose)), Reply::Done);
    }
    all.push(case(Bench::armed(), test, Refusal::OtherPurpose, |bench| rearm(bench, Purpose::MotorTest)));
    all.push(case(Bench::armed(), Request::Arm(Purpose::MotorTest), Refusal::OtherPurpose, rest));
    let mut bench = Bench::ready();
    bench.ask(Request::Arm(Purpose::MotorTest));
    all.push(case(bench, ARM, Refusal::OtherPurpose, rest));
    all
}

#[test]
fn every_refusal_comes_when_it_must_and_changes_nothing() {
    let mut provoked = [false; KINDS];
    for Case { mut bench, request, want, mend, then } in cases() {
        let before = fingerprint(&mut bench);
        assert_eq!(bench.ask(request.clone()), Reply::Refused(want), "{request:?}");
        assert_eq!(fingerprint(&mut bench), before, "{request:?} was refused and changed something");
        provoked[kind(&want)] = true;
        mend(&mut bench);
        let reply = bench.ask(request.clone());
        match then {
            Some(then) => assert_eq!(reply, then, "{request:?}"),
            None => {
                assert!(
                    !matches!(reply, Reply::Refused(_)),
                    "{request:?} after its cause is gone: {reply:?}"
                );
            }
        }
    }
    // These need more than one request to one flight logic: below.
    for elsewhere in
        [stale_setpoint(), setpoint_to_a_motor_test(), failing_store(), other_protocol(), not_sealed()]
    {
        provoked[kind(&elsewhere)] = true;
    }
    let missing: Vec<usize> = (0..KINDS).filter(|n| !provoked[*n]).collect();
    assert_eq!(missing, [0; 0], "never given");
}

/// In the very tick in which the setpoint grows stale the vehicle still tracks.
fn stale_setpoint() -> Refusal {
    let mut bench = Bench::in_state(FlightState::Tracking);
    bench.run(60);
    bench.stream = None;
    bench.run(FRESH_TICKS / 2 + 8);
    assert_eq!(bench.logic.state(), FlightState::Tracking);
    let sample = bench.sample();
    bench.tick_with(Some(sample), 60_000, &[Request::Trigger { checksum: table().checksum() }]);
    match bench.answer(bench.number) {
        Some(Reply::Refused(refusal @ Refusal::StaleSetpoint)) => refusal,
        other => panic!("{other:?}"),
    }
}

fn setpoint_to_a_motor_test() -> Refusal {
    let mut bench = Bench::ready();
    assert_eq!(bench.ask(Request::Arm(Purpose::MotorTest)), Reply::Done);
    let request = bench.setpoint(HOVER);
    let refusal = bench.refusal(request);
    assert_eq!(refusal, Refusal::OtherPurpose);
    bench.run(10);
    assert_eq!((bench.logic.state(), bench.out.throttle), (FlightState::Armed, Some([0.0; 4])));
    refusal
}

fn failing_store() -> Refusal {
    let mut bench = Bench::with_store();
    bench.store.as_mut().expect("a store").fails = true;
    let mut settings = Settings::DEFAULT;
    settings.heartbeat_ms = 700;
    let write = Request::WriteSettings(settings);
    let (reply, pending) = bench.settle(&write);
    assert!(pending > 0);
    assert_eq!(reply, Reply::Refused(Refusal::StoreFailed));
    assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(Settings::DEFAULT));
    bench.store.as_mut().expect("a store").fails = false;
    assert_eq!(bench.settle(&write).0, Reply::Done);
    assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(settings));
    Refusal::StoreFailed
}

/// Through the line, for the flight logic is not asked at all.
fn line(vehicle: &mut Vehicle<Vec<[u8; RECORD_BYTES]>>, bytes: &[u8]) -> Vec<(u16, Reply)> {
    vehicle.receive(bytes);
    let imu = Some(ImuSample { gyro_radps: [0.0; 3], accel_mps2: [0.0, 0.0, 9.81] });
    vehicle.tick(&mintime_firmware::flight::TickInput {
        now_us: 1,
        imu,
        battery_v: Some(15.0),
        kill: KillSwitch::Run,
    });
    let mut out = [0; 4000];
    let length = vehicle.transmit(&mut out);
    let mut decoder = Decoder::new();
    let said =
        out[..length].iter().filter_map(|b| decoder.push::<Downlink>(*b)).map(|m| m.expect("sound").message);
    said.filter_map(|m| match m {
        Message::Reply { number, reply } => Some((number, reply)),
        Message::Telemetry(_) => None,
    })
    .collect()
}

fn other_protocol() -> Refusal {
    let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 1]);
    let stop = |version| Uplink { version, number: 4, request: Request::EmergencyStop, heard_ms: 0 };
    let said = line(&mut vehicle, encode(&stop(PROTOCOL_VERSION - 1)).expect("it fits").as_bytes());
    assert_eq!(said, [(4, Reply::Refused(Refusal::ProtocolVersion))]);
    assert_eq!(vehicle.state(), FlightState::Calibrating);
    assert_eq!(
        line(&mut vehicle, encode(&stop(PROTOCOL_VERSION)).expect("it fits").as_bytes()),
        [(4, Reply::Done)]
    );
    assert_eq!(vehicle.state(), FlightState::Terminated);
    Refusal::ProtocolVersion
}

fn not_sealed() -> Refusal {
    let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 1]);
    let ask = |number, request| {
        encode(&Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 0 }).expect("it fits")
    };
    let said = line(&mut vehicle, ask(1, Request::Pair(Some([3; 16]))).as_bytes());
    assert_eq!(said, [(1, Reply::Done)]);
    let said = line(&mut vehicle, ask(2, Request::EmergencyStop).as_bytes());
    assert_eq!(said, [(2, Reply::Refused(Refusal::NotSealed))]);
    assert_ne!(vehicle.state(), FlightState::Terminated);
    Refusal::NotSealed
}

// ------------------------------------------------------------------------------------------------------------ arming

/// What blocks arming now, by a request to arm with this sample.
fn blocked_with(bench: &mut Bench, imu: Option<ImuSample>, interval_us: u64) -> ArmingBlock {
    bench.tick_with(imu, interval_us, &[ARM]);
    assert!(!bench.logic.state().motors_on());
    match bench.answer(bench.number) {
        Some(Reply::Refused(Refusal::ArmingBlocked(bits))) => ArmingBlock(bits),
        other => panic!("{other:?}"),
    }
}

fn blocked(bench: &mut Bench) -> ArmingBlock {
    let sample = bench.sample();
    blocked_with(bench, Some(sample), TICK_US)
}

/// Provokes one reason: all that blocked then, and the bench mended.
fn provoke(reason: ArmingBlock) -> (ArmingBlock, Bench) {
    use ArmingBlock as B;
    let without = |capabilities| {
        let mut bench = Bench::with(capabilities);
        bench.run(900);
        let block = blocked(&mut bench);
        bench.logic.set_board_status(&status(BOTH, false));
        (block, bench)
    };
    match reason {
        B::NO_GYRO => without(Capabilities { gyro: false, motors: true }),
        B::NO_MOTORS => without(Capabilities { gyro: true, motors: false }),
        B::STARTING => {
            // While its drivers start a board is not called without gyro and motors yet, but it does not arm either.
            let mut bench = Bench::ready();
            bench.logic.set_board_status(&status(Capabilities { gyro: false, motors: false }, true));
            let block = blocked(&mut bench);
            bench.logic.set_board_status(&status(BOTH, false));
            (block, bench)
        }
        B::GYRO_SILENT => {
            let mut bench = Bench::ready();
            for _ in 0..7 {
                bench.tick_with(None, TICK_US, &[]);
            }
            assert_eq!(bench.telemetry().arming_block, 0, "seven samples missing, then one: well");
            for _ in 0..8 {
                bench.tick_with(None, TICK_US, &[]);
            }
            (blocked_with(&mut bench, None, TICK_US), bench)
        }
        B::NOT_CALIBRATED => {
            let mut bench = Bench::new();
            bench.run(100);
            let block = blocked(&mut bench);
            bench.run(800);
            (block, bench)
        }
        B::MOVING => {
            let mut bench = Bench::ready();
            let mut sample = bench.sample();
            sample.gyro_radps[2] += 0.5;
            let block = blocked_with(&mut bench, Some(sample), TICK_US);
            bench.run(401);
            (block, bench)
        }
        B::GYRO_FROZEN => {
            let mut bench = Bench::ready();
            let same = bench.sample();
            for _ in 0..402 {
                bench.tick_with(Some(same), TICK_US, &[]);
            }
            (blocked_with(&mut bench, Some(same), TICK_US), bench)
        }
        B::BATTERY_UNKNOWN => {
            let mut bench = Bench::ready();
            for unknown in [Some(f32::NAN), Some(0.0), Some(-3.0), Some(f32::INFINITY), Some(9e9), Some(3.0)]
            {
                bench.battery_v = unknown;
                assert_eq!(blocked(&mut bench), reason, "{unknown:?}");
            }
            bench.battery_v = None;
            let block = blocked(&mut bench);
            bench.battery_v = Some(14.0);
            (block, bench)
        }
        B::BATTERY_LOW => {
            let mut bench = Bench::ready();
            bench.battery_v = Some(13.99);
            let block = blocked(&mut bench);
            bench.battery_v = Some(14.0);
            (block, bench)
        }
        B::KILL_SWITCH | B::KILL_LOST | B::NO_KILL_SWITCH => {
            let mut bench = Bench::ready();
            bench.kill = match reason {
                B::KILL_SWITCH => KillSwitch::Stop,
                B::KILL_LOST => KillSwitch::Lost,
                _ => KillSwitch::Absent,
            };
            let block = blocked(&mut bench);
            // What waives the absence of a switch waives neither its word nor its silence.
            let waiver = Settings { bench_thrust_mps2: 2.0, ..Settings::DEFAULT };
            assert_eq!(bench.ask(Request::WriteSettings(waiver)), Reply::Done);
            if reason == B::NO_KILL_SWITCH {
                return (block, bench);
            }
            assert_eq!(blocked(&mut bench), reason);
            bench.kill = KillSwitch::Run;
            (block, bench)
        }
        B::LATE_TICKS => {
            let mut bench = Bench::ready();
            let sample = bench.sample();
            (blocked_with(&mut bench, Some(sample), 10_000), bench)
        }
        B::TERMINATED => {
            let mut bench = Bench::ready();
            assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
            let block = blocked(&mut bench);
            assert_eq!(bench.acknowledge(), Reply::Done);
            (block, bench)
        }
        B::INCIDENT => {
            let mut bench = Bench::ready();
            bench.logic.report(IncidentCause::BrownOut);
            let block = blocked(&mut bench);
            assert_eq!(bench.acknowledge(), Reply::Done);
            (block, bench)
        }
        B::TILTED => {
            let mut bench = Bench::ready();
            let lean = |bench: &Bench, angle: f32| ImuSample {
                accel_mps2: [9.81 * angle.sin(), 0.0, 9.81 * angle.cos()],
                ..bench.sample()
            };
            for _ in 0..4000 {
                bench.tick_with(Some(lean(&bench, 0.4)), TICK_US, &[Request::Heartbeat]);
            }
            let sample = lean(&bench, 0.4);
            let block = blocked_with(&mut bench, Some(sample), TICK_US);
            for _ in 0..4000 {
                bench.tick_with(Some(lean(&bench, 0.2)), TICK_US, &[Request::Heartbeat]);
            }
            (block, bench)
        }
        B::NO_VEHICLE => {
            let mut bench = Bench::of(FlightLogic::new(None, BOTH, vec![[0; RECORD_BYTES]; 1]));
            bench.run(900);
            let block = blocked(&mut bench);
            assert_eq!(bench.ask(Request::WriteVehicle(VehicleConfig::REFERENCE)), Reply::Done);
            (block, bench)
        }
        B::STORING => {
            let mut bench = Bench::ready();
            let busy = StoreStatus { present: true, busy: true, ..StoreStatus::default() };
            bench.logic.set_board_status(&BoardStatus { store: busy, ..status(BOTH, false) });
            let block = blocked(&mut bench);
            bench.logic.set_board_status(&status(BOTH, false));
            (block, bench)
        }
        B::LANDED => {
            let mut bench = Bench::in_state(FlightState::Landed);
            bench.run(401);
            let block = blocked(&mut bench);
            assert_eq!(bench.ask(Request::Disarm), Reply::Done);
            (block, bench)
        }
        B::DAMAGED_VEHICLE | B::DAMAGED_SETTINGS | B::DAMAGED_PAIRING => {
            let mut bench = Bench::ready();
            let (key, anew) = match reason {
                B::DAMAGED_VEHICLE => (Key::Vehicle, Request::WriteVehicle(VehicleConfig::REFERENCE)),
                B::DAMAGED_SETTINGS => (Key::Settings, Request::WriteSettings(*bench.logic.settings())),
                _ => (Key::Pairing, Request::Pair(None)),
            };
            let mut damage = Damage::NONE;
            damage.set(key, true);
            bench.logic.note_damage(damage);
            assert_eq!(blocked(&mut bench).0, reason.0 | B::INCIDENT.0);
            // To have read of it is not enough: nobody knows what the lost value was.
            assert_eq!(bench.acknowledge(), Reply::Done);
            let block = blocked(&mut bench);
            assert_eq!(bench.ask(anew), Reply::Done);
            (block, bench)
        }
        other => panic!("nobody provokes {other}"),
    }
}

/// Each reason that blocks arming comes alone, and with its cause gone the vehicle arms.
#[test]
fn every_reason_blocks_arming_and_no_longer_than_it_holds() {
    for (reason, text) in ArmingBlock::REASONS {
        let (block, mut bench) = provoke(reason);
        assert_eq!(block, reason, "{text}: {block}");
        bench.arm();
        // Asked twice is harmless.
        assert_eq!(bench.ask(ARM), Reply::Done, "{text}");
    }
    // The list has all bits there are, each once.
    let all = ArmingBlock::REASONS.iter().fold(0, |all, (reason, _)| all + reason.0);
    assert_eq!(all, (1 << ArmingBlock::REASONS.len()) - 1);
}
