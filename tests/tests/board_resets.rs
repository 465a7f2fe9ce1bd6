//! What a board knows after a reset of how it came to it, on the very image that gets flashed.

mod bench;

use bench::{Bench, wake};
use emulator::bus::Peripherals;
use emulator::chip::RngDefect;
use mintime::flight::Client;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, Incident, IncidentCause, Purpose, Refusal, Reply, Request,
};
use mintime_shared::seal::PairingKey;

/// From power-up or a reset until the gyro's bias is known, ms.
const STARTS_MS: u64 = 1500;
/// Nothing lies there.
const NOWHERE: u32 = 0x3000_0000;
/// RAM that the firmware leaves alone.
const SPARE_RAM: u32 = 0x2001_8000;

const STOPPED: IncidentCause = IncidentCause::Terminated(AbortReason::EmergencyStop);

impl Bench {
    fn started() -> Self {
        let mut bench = Self::real(31);
        bench.pass_ms(STARTS_MS);
        assert_eq!(bench.waits(), None);
        bench
    }

    fn waits(&mut self) -> Option<IncidentCause> {
        self.status().incident.map(|incident| incident.cause)
    }

    fn acknowledge(&mut self) -> IncidentCause {
        let Incident { number, cause } = self.status().incident.expect("it waits");
        assert_eq!(self.ask(&Request::Acknowledge { incident: number }), Reply::Done);
        cause
    }

    fn reset(&mut self) {
        self.board().peripherals.request_reset();
        self.pass_ms(STARTS_MS);
    }

    /// A jump to where nothing lies.
    fn crash(&mut self) {
        self.crash_at(NOWHERE);
    }

    fn crash_at(&mut self, address: u32) {
        wake(self.board());
        self.board().core.set_register(15, address);
        self.pass_ms(STARTS_MS);
    }

    /// An index out of bounds, in an eighth line.
    fn panic(&mut self) {
        let panics = self.symbol("panic_bounds_check") & !1;
        let (file, location) = (SPARE_RAM, SPARE_RAM + 0x100);
        let words = [file, 8, 8, 1].map(u32::to_le_bytes);
        wake(self.board());
        let board = self.board();
        board.memory.place(file, b"lost.rs ").expect("RAM");
        board.memory.place(location, words.as_flattened()).expect("RAM");
        for (register, value) in [(0, 3), (1, 2), (2, location), (15, panics)] {
            board.core.set_register(register, value);
        }
        self.pass_ms(STARTS_MS);
    }

    /// The control tick finds nothing to run, and the watchdog bites.
    fn starve(&mut self) {
        let handle = self.symbol("5board7control6HANDLE");
        self.board().memory.place(handle, &[0; 4]).expect("RAM");
        self.pass_ms(STARTS_MS);
    }

    fn assert_blocked(&mut self, block: ArmingBlock) {
        match self.ask(&Request::Arm(Purpose::Flight)) {
            Reply::Refused(Refusal::ArmingBlocked(bits)) => assert!(ArmingBlock(bits).contains(block)),
            other => panic!("{other:?}"),
        }
    }
}

/// An emergency is over when a person says so, not when somebody presses reset.
#[test]
fn an_emergency_outlives_resets_until_it_is_acknowledged() {
    let mut bench = Bench::started();
    assert_eq!(bench.ask(&Request::EmergencyStop), Reply::Done);
    bench.assert_blocked(ArmingBlock::TERMINATED);
    for _ in 0..2 {
        bench.reset();
        assert_eq!(bench.status().state, FlightState::Disarmed);
        assert_eq!(bench.waits(), Some(STOPPED));
        bench.assert_blocked(ArmingBlock::INCIDENT);
    }
    // Another one while the first still waits: both are told, the later one again after a reset.
    assert_eq!(bench.ask(&Request::EmergencyStop), Reply::Done);
    bench.acknowledge();
    assert_eq!((bench.status().state, bench.waits()), (FlightState::Terminated, Some(STOPPED)));
    bench.reset();
    assert_eq!(bench.acknowledge(), STOPPED);
    assert_eq!(bench.waits(), None);
    bench.reset();
    assert_eq!(bench.waits(), None);
}

/// It is kept in the very tick in which the motors stop.
#[test]
fn an_emergency_outlives_a_reset_right_behind_it() {
    let mut bench = Bench::started();
    let now_s = bench.vehicle.now_ns() as f64 * 1e-9;
    let mut client = Client::default();
    client.ask(&mut bench.vehicle, Request::EmergencyStop, now_s).expect("a line");
    let state = |bench: &Bench| bench.vehicle.states().last().map(|(_, state)| *state);
    for step in 0.. {
        assert!(step < 100, "it does not stop");
        let later = bench.vehicle.now_ns() + 100_000;
        bench.vehicle.advance_to(later).expect("time goes on");
        if state(&bench) == Some(FlightState::Terminated) {
            break;
        }
    }
    // The tick ends, and the next one is far.
    let later = bench.vehicle.now_ns() + 400_000;
    bench.vehicle.advance_to(later).expect("time goes on");
    bench.reset();
    assert_eq!(bench.waits(), Some(STOPPED));
}

/// One that was acknowledged in its own run is none of the next.
#[test]
fn an_acknowledged_emergency_is_forgotten() {
    let mut bench = Bench::started();
    assert_eq!(bench.ask(&Request::EmergencyStop), Reply::Done);
    bench.acknowledge();
    bench.reset();
    assert_eq!(bench.waits(), None);
}

/// A reset that says less does not take the place of a crash that nobody has read of.
#[test]
fn a_crash_is_told_whatever_resets_follow() {
    let mut bench = Bench::started();
    bench.crash();
    assert!(matches!(bench.waits(), Some(IncidentCause::HardFault { pc: NOWHERE, .. })));
    bench.starve();
    assert!(matches!(bench.waits(), Some(IncidentCause::HardFault { pc: NOWHERE, .. })));
    bench.board().peripherals.set_supply_v(2.8);
    bench.pass_ms(2);
    bench.board().peripherals.set_supply_v(3.3);
    bench.pass_ms(STARTS_MS);
    assert!(matches!(bench.acknowledge(), IncidentCause::HardFault { pc: NOWHERE, .. }));
    let log = bench.log();
    assert_eq!(log.crashes(), ["HardFault"; 3]);
    // They were counted.
    assert!(log.says("count: 3"), "{:?}", log.0);
    assert_eq!(bench.waits(), None);
    // And what comes after it is told as ever.
    bench.starve();
    assert_eq!(bench.waits(), Some(IncidentCause::Watchdog));
}

/// What says no more than another counts as much as it.
#[test]
fn a_supply_that_falls_after_a_watchdog_reset_is_told_too() {
    let mut bench = Bench::started();
    bench.starve();
    bench.board().peripherals.set_supply_v(2.8);
    bench.pass_ms(2);
    bench.board().peripherals.set_supply_v(3.3);
    bench.pass_ms(STARTS_MS);
    assert_eq!(bench.acknowledge(), IncidentCause::Watchdog);
    assert_eq!(bench.acknowledge(), IncidentCause::BrownOut);
    assert_eq!(bench.waits(), None);
}

/// The first crash is the cause, and stays the first to be told of; the latest is told behind it.
#[test]
fn the_first_and_the_latest_crash_are_told() {
    let mut bench = Bench::started();
    bench.crash();
    bench.panic();
    assert!(matches!(bench.waits(), Some(IncidentCause::HardFault { pc: NOWHERE, .. })));
    // A third takes the second one's place, and what says less no place at all.
    bench.crash_at(NOWHERE + 0x100);
    bench.starve();
    assert!(matches!(bench.acknowledge(), IncidentCause::HardFault { pc: NOWHERE, .. }));
    // What waits on outlives a reset without the first, and stands before what comes after it.
    bench.panic();
    assert!(matches!(
        bench.acknowledge(),
        IncidentCause::HardFault { pc, .. } if pc == NOWHERE + 0x100
    ));
    bench.reset();
    assert_eq!(bench.acknowledge(), IncidentCause::Panic(8));
    assert_eq!(bench.waits(), None);
    assert!(bench.log().says("count: 5"), "{:?}", bench.log().0);
    bench.reset();
    assert_eq!(bench.waits(), None);
}

/// Where the session may repeat nobody arms, whatever is replayed; who is not paired has nothing to lose by it.
#[test]
fn a_paired_vehicle_without_random_numbers_is_not_armed() {
    const KEY: PairingKey = *b"a secret of both";
    for defect in [RngDefect::Seed, RngDefect::Clock, RngDefect::Silent] {
        for paired in [false, true] {
            let mut bench = Bench::started();
            let mut client = Client::with_key(paired.then_some(KEY));
            if paired {
                // The answer may be that it is under way.
                for _ in 0..10 {
                    bench.ask(&Request::Pair(Some(KEY)));
                    bench.pass_ms(10);
                    if bench.ask(&Request::Status) == Reply::Refused(Refusal::NotSealed) {
                        break;
                    }
                }
            }
            bench.board().peripherals.set_rng_defect(defect);
            bench.board().peripherals.request_reset();
            let ask_as = |client: &mut Client, bench: &mut Bench, request: Request| {
                for _ in 0..20 {
                    let now_s = bench.vehicle.now_ns() as f64 * 1e-9;
                    client.ask(&mut bench.vehicle, request.clone(), now_s).expect("a line");
                    for _ in 0..20 {
                        bench.pass_ms(5);
                        let now_s = bench.vehicle.now_ns() as f64 * 1e-9;
                        if let Ok(Some(reply)) = client.poll(&mut bench.vehicle, now_s) {
                            return reply;
                        }
                    }
                }
                panic!("{request:?}: no answer");
            };
            let mut ask = |bench: &mut Bench, request: Request| ask_as(&mut client, bench, request);
            bench.pass_ms(5000);
            ask(&mut bench, Request::Identify);
            let status = |reply| match reply {
                Reply::Status(telemetry) => telemetry,
                other => panic!("{other:?}"),
            };
            let telemetry = status(ask(&mut bench, Request::Status));
            let block = ArmingBlock(telemetry.arming_block);
            assert!(!block.contains(ArmingBlock::STARTING), "{block}");
            let Some(Incident { number, cause }) = telemetry.incident else {
                assert!(!paired && !block.contains(ArmingBlock::NO_MOTORS), "{block}");
                // Nor may it be paired now and armed.
                while bench.ask(&Request::Status) != Reply::Refused(Refusal::NotSealed) {
                    bench.ask(&Request::Pair(Some(KEY)));
                    bench.pass_ms(10);
                }
                let mut host = Client::with_key(Some(KEY));
                ask_as(&mut host, &mut bench, Request::Identify);
                let telemetry = status(ask_as(&mut host, &mut bench, Request::Status));
                assert!(ArmingBlock(telemetry.arming_block).contains(ArmingBlock::NO_MOTORS));
                continue;
            };
            assert!(paired && matches!(cause, IncidentCause::SetUp(_)), "{cause:?}");
            assert!(
                block.contains(ArmingBlock::INCIDENT) && block.contains(ArmingBlock::NO_MOTORS),
                "{block}"
            );
            assert_eq!(ask(&mut bench, Request::Acknowledge { incident: number }), Reply::Done);
            let telemetry = status(ask(&mut bench, Request::Status));
            assert_eq!(telemetry.incident, None);
            assert!(ArmingBlock(telemetry.arming_block).contains(ArmingBlock::NO_MOTORS));
        }
    }
}

/// Neither a crash nor an emergency displaces the other.
#[test]
fn a_crash_and_an_emergency_are_both_told() {
    let mut bench = Bench::started();
    assert_eq!(bench.ask(&Request::EmergencyStop), Reply::Done);
    bench.crash();
    bench.reset();
    assert!(matches!(bench.acknowledge(), IncidentCause::HardFault { .. }));
    bench.reset();
    assert_eq!(bench.acknowledge(), STOPPED);
    bench.reset();
    assert_eq!(bench.waits(), None);
}
