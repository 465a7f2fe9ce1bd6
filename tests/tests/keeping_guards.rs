//! What is kept and calibrated, at bad moments: guided turns that a flight comes between, flash that fails, values that were
//! damaged.

mod logic;

use logic::{BOTH, Bench, Store, TICK_US, name, status, table};
use mintime_firmware::config::{BoardStatus, StoreStatus, VehicleConfig};
use mintime_firmware::keeping::Key;
use mintime_firmware::store::Damage;
use mintime_shared::messages::{
    ArmingBlock, CalibrationError, FlightState, Purpose, Refusal, Reply, Request,
};
use mintime_shared::settings::Settings;

/// A store that is there and does nothing by itself.
const IDLE_STORE: StoreStatus = StoreStatus { present: true, busy: false, finished: 0, failed: false };

/// Guided turns asked for under another number are other ones; none ends them.
#[test]
fn guided_turns_belong_to_their_request() {
    let mut bench = Bench::ready();
    let turns = Request::CalibrateScale { axis: 2, turns: 1 };
    assert_eq!(bench.ask(turns.clone()), Reply::Pending);
    let number = bench.number;
    bench.run(900);
    let mut reply = Reply::Pending;
    for _ in 0..20 {
        bench.run(1000);
        reply = bench.ask_as(number, turns.clone());
    }
    assert_eq!(reply, Reply::Refused(Refusal::Calibration(CalibrationError::NotTurned)));
    assert_eq!(bench.ask(turns), Reply::Pending);
    assert_eq!(bench.ask(Request::CalibrateScale { axis: 2, turns: 0 }), Reply::Done);
}

/// The angle that passes while the gyro is silent is nobody's guess; a sample or two that are lost cost nothing.
#[test]
fn a_gyro_that_falls_silent_ends_guided_turns() {
    let lost = Reply::Refused(Refusal::Calibration(CalibrationError::SamplesLost));
    for (silent_ticks, expected) in [(6, Reply::Pending), (10, lost)] {
        let mut bench = Bench::ready();
        let turns = Request::CalibrateScale { axis: 2, turns: 1 };
        assert_eq!(bench.ask(turns.clone()), Reply::Pending);
        let number = bench.number;
        bench.run(900);
        for tick in 0..400 {
            let mut sample = bench.sample();
            sample.gyro_radps[2] += 2.0;
            let seen = Some(sample).filter(|_| !(200..200 + silent_ticks).contains(&tick));
            bench.tick_with(seen, TICK_US, &[]);
        }
        assert_eq!(bench.ask_as(number, turns), expected, "{silent_ticks} ticks");
    }
}

const ONE_TURN: Request = Request::CalibrateScale { axis: 2, turns: 1 };

/// A hand turns the vehicle about its up axis; the gyro tells 2 % too much. Then it stands for a while.
fn turn(bench: &mut Bench, turns: f32) {
    const TICKS: usize = 800;
    let rate_radps = turns * core::f32::consts::TAU * 1.02 / (TICKS as f32 * 1.25e-3);
    for _ in 0..TICKS {
        let mut sample = bench.sample();
        sample.gyro_radps[2] += rate_radps;
        bench.tick_with(Some(sample), TICK_US, &[]);
    }
    bench.run(1300);
}

/// Begins guided turns at a multiple of the noise's period, so that the same turns find the very same scale.
fn begin_turns(bench: &mut Bench) -> u16 {
    while !bench.ticks.is_multiple_of(17 * 8) {
        bench.run(1);
    }
    assert_eq!(bench.ask(ONE_TURN), Reply::Pending);
    let number = bench.number;
    bench.run(500);
    number
}

/// The answer to guided turns once it is more than that they are under way.
fn found(bench: &mut Bench, number: u16) -> Reply {
    for _ in 0..50 {
        match bench.ask_as(number, ONE_TURN) {
            Reply::Pending => {}
            reply => return reply,
        }
    }
    Reply::Pending
}

/// Turns that a flight came between are none: what was turned before it does not count.
#[test]
fn arming_ends_guided_turns() {
    for armed in [false, true] {
        let mut bench = Bench::ready();
        let number = begin_turns(&mut bench);
        turn(&mut bench, 0.5);
        if armed {
            bench.arm();
            bench.disarm();
        }
        turn(&mut bench, 0.5);
        let scale = if armed { 1.0 } else { 1.0 / 1.02 };
        assert_eq!(found(&mut bench, number), if armed { Reply::Pending } else { Reply::Done });
        assert!((bench.logic.settings().gyro_scale[2] - scale).abs() < 1e-4);
    }
}

/// A scale that turns out to be the one in force is nothing to write, unless that is an older copy of damaged settings.
#[test]
fn a_scale_found_again_is_written_where_the_settings_are_damaged() {
    let mut bench = Bench::with_store();
    let number = begin_turns(&mut bench);
    turn(&mut bench, 1.0);
    assert_eq!(found(&mut bench, number), Reply::Done);
    let kept = bench.store.expect("a store").kept;
    assert_eq!(kept.len(), 1);
    for damaged in [false, true] {
        let mut bench = Bench::ready();
        assert!(bench.logic.restore(kept[0].0, &kept[0].1));
        if damaged {
            let mut damage = Damage::NONE;
            damage.set(Key::Settings, true);
            bench.logic.note_damage(damage);
            assert_eq!(bench.acknowledge(), Reply::Done);
        }
        bench.store = Some(Store { kept: kept.clone(), ticks: 5, ..Store::default() });
        let number = begin_turns(&mut bench);
        turn(&mut bench, 1.0);
        assert_eq!(found(&mut bench, number), Reply::Done);
        let store = bench.store.as_ref().expect("a store");
        assert_eq!((store.jobs, &store.kept), (usize::from(damaged), &kept), "{damaged}");
        assert_eq!(bench.telemetry().arming_block, 0);
    }
}

/// Of flash that shall be written a board with its motors on hears nothing.
#[test]
fn nothing_is_written_while_the_motors_are_on() {
    let mut bench = with_damage(false, &[2]);
    bench.store = None;
    bench.arm();
    bench.logic.set_board_status(&BoardStatus { store: IDLE_STORE, ..status(BOTH, false) });
    bench.run(1);
    assert_eq!((bench.logic.state(), bench.logic.job()), (FlightState::Armed, None));
    bench.disarm();
    assert_eq!(bench.logic.job().map(|job| job.key), Some(Key::Table(2)));
}

/// A job that the board has not taken yet keeps the motors off as well as one that it works on.
#[test]
fn a_job_that_waits_blocks_arming() {
    let mut bench = Bench::ready();
    bench.logic.set_board_status(&BoardStatus { store: IDLE_STORE, ..status(BOTH, false) });
    let settings = Settings { heartbeat_ms: 700, ..Settings::DEFAULT };
    assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Pending);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::STORING.0));
}

/// A failure is told to who wanted that value, and is forgotten with the next one that is written.
#[test]
fn a_failure_is_told_of_its_own_value_only() {
    let mut bench = Bench::with_store();
    let settings = Request::WriteSettings(Settings { heartbeat_ms: 700, ..Settings::DEFAULT });
    bench.store.as_mut().expect("a store").fails = true;
    assert_eq!(bench.ask(settings.clone()), Reply::Pending);
    bench.run(20);
    bench.store.as_mut().expect("a store").fails = false;
    let vehicle = VehicleConfig { mass_kg: 0.75, ..VehicleConfig::REFERENCE };
    assert_eq!(bench.settle(&Request::WriteVehicle(vehicle)).0, Reply::Done);
    assert_eq!(bench.settle(&settings).0, Reply::Done);
}

/// Switched on with the tables (5, 5) and nothing else in its store, and this damage, which a person has read of.
fn with_damage(kept: bool, places: &[u8]) -> Bench {
    let mut old = Bench::with_store();
    old.commit(&table());
    let flip = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    assert_eq!(old.settle(&flip).0, Reply::Done);
    let store = old.store.expect("a store").kept.into_iter().filter(|_| kept).collect::<Vec<_>>();
    let mut bench = Bench::ready();
    for (key, value) in &store {
        assert!(bench.logic.restore(*key, value));
    }
    let mut damage = Damage::NONE;
    for place in places {
        damage.set(Key::Table(*place), true);
    }
    bench.logic.note_damage(damage);
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.store = Some(Store { kept: store, ticks: 5, ..Store::default() });
    bench
}

/// A table of which an older copy is left keeps its place, and is written anew where it is stored again.
#[test]
fn a_damaged_table_of_which_a_copy_is_left_is_kept() {
    let mut bench = with_damage(true, &[0]);
    bench.run(50);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 0);
    bench.commit(&table());
    let flip = Request::StoreTable { name: name("flip"), checksum: table().checksum() };
    assert_eq!(bench.settle(&flip).0, Reply::Done);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 1);
}

/// Places of lost tables are freed one after the other, each tried once, and only where there is a store.
#[test]
fn lost_places_are_freed_one_by_one_and_once() {
    let mut bench = with_damage(false, &[2, 6]);
    bench.store = None;
    bench.logic.set_board_status(&status(BOTH, false));
    assert_eq!(bench.logic.job(), None, "without a store");
    for _ in 0..3 {
        bench.logic.set_board_status(&BoardStatus { store: IDLE_STORE, ..status(BOTH, false) });
        assert_eq!(bench.logic.job().map(|job| job.key), Some(Key::Table(2)), "it has not been taken yet");
    }
    let mut bench = with_damage(false, &[2]);
    bench.store.as_mut().expect("a store").fails = true;
    bench.run(100);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, 1, "flash that fails is not worn further");
}
