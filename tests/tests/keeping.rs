//! What a vehicle is told and keeps: tables staged in chunks, stored by name; vehicle file, settings and pairing key; over
//! power cycles and failures of its flash.

mod logic;

use logic::{BOTH, Bench, Store, bytes_of, chunk, made_for, name, table, table_of};
use mintime_firmware::config::VehicleConfig;
use mintime_firmware::flight::FlightLogic;
use mintime_firmware::keeping::Key;
use mintime_firmware::store::Damage;
use mintime_shared::messages::{
    ArmingBlock, FlightState, Purpose, RECORD_BYTES, Refusal, Reply, Request, STORED_TABLES, StoredTable,
};
use mintime_shared::settings::Settings;
use mintime_shared::table::TableError;
use proptest::prelude::*;

fn held(length: usize) -> Reply {
    Reply::Staged { length: length as u16 }
}

fn store(text: &str) -> Request {
    Request::StoreTable { name: name(text), checksum: table().checksum() }
}

fn listed(bench: &mut Bench) -> Vec<StoredTable> {
    match bench.ask(Request::ListTables) {
        Reply::Tables(tables) => tables.to_vec(),
        other => panic!("{other:?}"),
    }
}

/// A vehicle switched on again with what its store kept; nothing else outlives the power.
fn power_cycle(old: &Bench) -> Bench {
    let mut logic = FlightLogic::new(None, BOTH, vec![[0; RECORD_BYTES]; 10]);
    let kept = old.store.as_ref().map(|s| s.kept.clone()).unwrap_or_default();
    for (key, value) in &kept {
        assert!(logic.restore(*key, value), "{key:?}");
    }
    let mut bench = Bench::of(logic);
    bench.store = Some(Store { kept, ticks: 5, ..Store::default() });
    bench.run(900);
    bench
}

// ----------------------------------------------------------------------------------------------------------- staging

#[test]
fn chunks_may_be_lost_doubled_reordered_and_overlap() {
    let bytes = bytes_of(&table());
    let n = bytes.len();
    let checksum = table().checksum();
    let mut bench = Bench::ready();
    // Lost: the next one does not join, and says where to go on.
    assert_eq!(bench.ask(chunk(n, 0, &bytes[..40])), held(40));
    assert_eq!(bench.refusal(chunk(n, 80, &bytes[80..110])), Refusal::Gap { expected: 40 });
    assert_eq!(bench.refusal(Request::CommitTable { checksum }), Refusal::Gap { expected: 40 });
    // Doubled: held as before.
    assert_eq!(bench.ask(chunk(n, 0, &bytes[..40])), held(40));
    assert_eq!(bench.ask(chunk(n, 40, &bytes[40..80])), held(80));
    assert_eq!(bench.ask(chunk(n, 40, &bytes[40..80])), held(80));
    // Late, from before: what came after it stays.
    assert_eq!(bench.ask(chunk(n, 0, &bytes[..40])), held(80));
    // Overlapping with the same bytes.
    assert_eq!(bench.ask(chunk(n, 60, &bytes[60..105])), held(105));
    assert_eq!(bench.ask(chunk(n, 100, &bytes[100..])), held(n));
    let committed = Reply::Committed { checksum, duration_s: table().duration_s() };
    assert_eq!(bench.ask(Request::CommitTable { checksum }), committed);
    assert_eq!(bench.read_table(), bytes[..]);
    // Asked again, and again after some of it was staged anew: it is so already, or the gap is told.
    assert_eq!(bench.ask(Request::CommitTable { checksum }), committed);
    assert_eq!(bench.ask(chunk(n, 0, &bytes[..40])), held(40));
    assert_eq!(bench.refusal(Request::CommitTable { checksum }), Refusal::Gap { expected: 40 });
    assert_eq!(bench.read_table(), bytes[..]);
}

/// Bytes that differ from what is held begin a new end: nothing of the old one survives behind them.
#[test]
fn other_bytes_replace_what_follows() {
    let (bytes, other) = (bytes_of(&table()), bytes_of(&table_of("horizontal_5")));
    let mut bench = Bench::ready();
    assert_eq!(bench.stage(&bytes), held(bytes.len()));
    // Another table from its beginning, of another length or the same.
    assert_eq!(bench.ask(chunk(other.len(), 0, &other[..64])), held(64));
    let commit = Request::CommitTable { checksum: table().checksum() };
    assert_eq!(bench.refusal(commit.clone()), Refusal::Gap { expected: 64 });
    assert_eq!(bench.stage(&other), held(other.len()));
    assert_eq!(bench.refusal(commit.clone()), Refusal::NotStaged);
    let checksum = table_of("horizontal_5").checksum();
    assert!(matches!(bench.ask(Request::CommitTable { checksum }), Reply::Committed { .. }));
    // A byte patched in the middle cuts there.
    assert_eq!(bench.stage(&bytes), held(bytes.len()));
    assert_eq!(bench.ask(chunk(bytes.len(), 70, &[bytes[70] ^ 1])), held(71));
    assert_eq!(bench.refusal(commit.clone()), Refusal::Gap { expected: 71 });
    // A total that changes on the way, chunks beyond it, and nothing at all are no chunks.
    for bad in [
        chunk(bytes.len() + 1, 71, &bytes[71..90]),
        chunk(bytes.len(), 71, &[bytes[71..].to_vec(), vec![0]].concat()),
        chunk(bytes.len(), 71, &[]),
        chunk(205, 0, &bytes[..10]),
        chunk(10, 0, &bytes[..20]),
        chunk(usize::from(u16::MAX), 0, &bytes[..10]),
    ] {
        assert_eq!(bench.refusal(bad), Refusal::Table(TableError::Length));
    }
    assert_eq!(bench.refusal(chunk(bytes.len(), 90, &bytes[90..100])), Refusal::Gap { expected: 71 });
    assert_eq!(bench.stage(&bytes), held(bytes.len()));
    assert!(matches!(bench.ask(commit), Reply::Committed { .. }));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Pieces of two tables in any order: what is committed is one of them, whole, or nothing.
    #[test]
    fn any_chunks_commit_a_whole_table_or_none(
        pieces in prop::collection::vec((any::<bool>(), 0usize..200, 1usize..=128, prop::option::weighted(0.05, any::<u8>())), 1..40),
    ) {
        let tables = [table(), table_of("horizontal_5")];
        let mut bench = Bench::new();
        for (which, at, length, patch) in pieces {
            let table = &tables[usize::from(which)];
            let bytes = bytes_of(table);
            let at = at.min(bytes.len() - 1);
            let mut piece = bytes[at..bytes.len().min(at + length)].to_vec();
            if let Some(patch) = patch {
                piece[0] = patch;
            }
            bench.ask(chunk(bytes.len(), at, &piece));
            bench.ask(Request::CommitTable { checksum: table.checksum() });
            let now = bench.read_table();
            prop_assert!(now.is_empty() || tables.iter().any(|t| bytes_of(t)[..] == now[..]));
        }
        // And the way back to a known state is always open.
        prop_assert_eq!(bench.stage(&bytes_of(&tables[0])), held(bytes_of(&tables[0]).len()));
        let committed = bench.ask(Request::CommitTable { checksum: tables[0].checksum() });
        prop_assert!(matches!(committed, Reply::Committed { .. }), "{:?}", committed);
    }
}

// ------------------------------------------------------------------------------------------------------------- store

#[test]
fn tables_are_stored_listed_loaded_and_deleted_by_name() {
    let mut bench = Bench::with_store();
    assert_eq!(listed(&mut bench), []);
    bench.commit(&table());
    let (reply, pending) = bench.settle(&store("flip"));
    assert_eq!(reply, Reply::Done);
    assert!((5..12).contains(&pending), "under way for {pending} ticks");
    let listing = |text: &str, t: &mintime_shared::table::ManeuverTable| StoredTable {
        name: name(text),
        checksum: t.checksum(),
        duration_s: t.duration_s(),
    };
    assert_eq!(listed(&mut bench), [listing("flip", &table())]);
    // Asked again it is so, and flash is left alone.
    let jobs = bench.store.as_ref().expect("a store").jobs;
    assert_eq!(bench.ask(store("flip")), Reply::Done);
    bench.run(20);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, jobs);
    // Another one beside it, then in its place.
    let other = table_of("horizontal_5");
    bench.commit(&other);
    let store_other = |text: &str| Request::StoreTable { name: name(text), checksum: other.checksum() };
    assert_eq!(bench.settle(&store_other("away")).0, Reply::Done);
    assert_eq!(listed(&mut bench), [listing("flip", &table()), listing("away", &other)]);
    assert_eq!(bench.settle(&store_other("flip")).0, Reply::Done);
    assert_eq!(listed(&mut bench), [listing("flip", &other), listing("away", &other)]);
    bench.commit(&table());
    assert_eq!(bench.settle(&store("flip")).0, Reply::Done);
    bench.commit(&other);
    // Loaded, read back whole, and again.
    for _ in 0..2 {
        let loaded = bench.ask(Request::LoadTable { name: name("flip") });
        let duration_s = table().duration_s();
        assert_eq!(loaded, Reply::Committed { checksum: table().checksum(), duration_s });
        assert_eq!(bench.read_table(), bytes_of(&table())[..]);
    }
    // Deleted: gone from the list, not from what is committed; and deleting twice is harmless.
    for _ in 0..2 {
        assert_eq!(bench.settle(&Request::DeleteTable { name: name("flip") }).0, Reply::Done);
        assert_eq!(listed(&mut bench), [listing("away", &other)]);
    }
    assert_eq!(bench.read_table(), bytes_of(&table())[..]);
    assert_eq!(bench.refusal(Request::LoadTable { name: name("flip") }), Refusal::NoSuchTable);
    // Over a power cycle the rest is there and nothing is committed.
    let mut again = power_cycle(&bench);
    assert_eq!(listed(&mut again), [listing("away", &other)]);
    assert_eq!(again.read_table(), [0; 0]);
    assert!(matches!(again.ask(Request::LoadTable { name: name("away") }), Reply::Committed { .. }));
    assert_eq!(again.read_table(), bytes_of(&other)[..]);
}

#[test]
fn eight_places_and_no_ninth() {
    let mut bench = Bench::with_store();
    bench.commit(&table());
    for n in 0..STORED_TABLES {
        assert_eq!(bench.settle(&store(&format!("table {n}"))).0, Reply::Done);
    }
    assert_eq!(listed(&mut bench).len(), STORED_TABLES);
    assert_eq!(bench.refusal(store("one more")), Refusal::StoreFull);
    assert_eq!(bench.ask(store("table 7")), Reply::Done);
    assert_eq!(bench.settle(&Request::DeleteTable { name: name("table 2") }).0, Reply::Done);
    assert_eq!(bench.settle(&store("one more")).0, Reply::Done);
    assert_eq!(listed(&mut power_cycle(&bench)).len(), STORED_TABLES);
}

/// A store that fails says so once for each try, and what was there before stays, in memory and after a power cycle.
#[test]
fn a_failing_store_changes_nothing() {
    let mut bench = Bench::with_store();
    bench.commit(&table());
    assert_eq!(bench.settle(&store("flip")).0, Reply::Done);
    let settings = Settings { heartbeat_ms: 700, ..Settings::DEFAULT };
    let heavier = VehicleConfig { mass_kg: 0.8, ..VehicleConfig::REFERENCE };
    bench.store.as_mut().expect("a store").fails = true;
    for request in [
        store("again"),
        Request::DeleteTable { name: name("flip") },
        Request::WriteSettings(settings),
        Request::WriteVehicle(heavier),
        Request::Pair(Some([9; 16])),
    ] {
        for _ in 0..2 {
            let (reply, pending) = bench.settle(&request);
            assert!(pending > 0, "{request:?} is tried anew");
            assert_eq!(reply, Reply::Refused(Refusal::StoreFailed), "{request:?}");
        }
    }
    let check = |bench: &mut Bench| {
        assert_eq!(listed(bench).len(), 1);
        assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(Settings::DEFAULT));
        assert_eq!(bench.logic.pairing(), None);
        assert_eq!(bench.logic.config().mass_kg, VehicleConfig::REFERENCE.mass_kg);
    };
    check(&mut bench);
    check(&mut power_cycle(&bench));
    bench.store.as_mut().expect("a store").fails = false;
    assert_eq!(bench.settle(&Request::WriteSettings(settings)).0, Reply::Done);
    assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(settings));
}

/// One job at a time, the motors off as long; what is asked meanwhile waits its turn, an emergency stop does not.
#[test]
fn while_flash_is_written_nothing_arms() {
    let mut bench = Bench::with_store();
    bench.store.as_mut().expect("a store").ticks = 40;
    let settings = Settings { heartbeat_ms: 700, ..Settings::DEFAULT };
    assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Pending);
    assert_eq!(bench.ask(Request::Pair(Some([1; 16]))), Reply::Pending);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::STORING.0));
    assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(Settings::DEFAULT), "not before it is kept");
    assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(bench.settle(&Request::WriteSettings(settings)).0, Reply::Done);
    assert_eq!(bench.settle(&Request::Pair(Some([1; 16]))).0, Reply::Done);
    assert_eq!(bench.logic.pairing(), Some(&[1; 16]));
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.arm();
    assert!(bench.logic.job().is_none());
}

#[test]
fn vehicle_settings_and_key_outlive_the_power() {
    let mut bench = Bench::of(FlightLogic::new(None, BOTH, vec![[0; RECORD_BYTES]; 10]));
    bench.store = Some(Store { ticks: 5, ..Store::default() });
    bench.run(900);
    assert_eq!(bench.ask(Request::ReadVehicle), Reply::Vehicle(None));
    assert_eq!(
        bench.refusal(Request::Arm(Purpose::Flight)),
        Refusal::ArmingBlocked(ArmingBlock::NO_VEHICLE.0)
    );
    let vehicle =
        VehicleConfig { mass_kg: 0.7, outputs: [2, 0, 3, 1], reversed: true, ..VehicleConfig::REFERENCE };
    let settings = Settings {
        gyro_scale: [1.01, 0.99, 1.02],
        kill_channel: 7,
        recovery_ms: 900,
        bench_thrust_mps2: 3.0,
        ..Settings::DEFAULT
    };
    for request in
        [Request::WriteVehicle(vehicle), Request::WriteSettings(settings), Request::Pair(Some([4; 16]))]
    {
        assert_eq!(bench.settle(&request).0, Reply::Done);
        // Asked again it is so at once.
        assert_eq!(bench.ask(request), Reply::Done);
    }
    let mut again = power_cycle(&bench);
    for bench in [&mut bench, &mut again] {
        assert_eq!(bench.ask(Request::ReadVehicle), Reply::Vehicle(Some(vehicle)));
        assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(settings));
        assert_eq!(bench.logic.pairing(), Some(&[4; 16]));
        match bench.ask(Request::Identify) {
            Reply::Identity(identity) => {
                assert_eq!((identity.vehicle, identity.paired), (vehicle.hash(), true));
            }
            other => panic!("{other:?}"),
        }
    }
    again.arm();
    disarm(&mut again);
    assert_eq!(again.settle(&Request::Pair(None)).0, Reply::Done);
    assert_eq!(power_cycle(&again).logic.pairing(), None);
}

fn disarm(bench: &mut Bench) {
    assert_eq!(bench.ask(Request::Disarm), Reply::Done);
}

/// What is not one of its own values, or is one that would be refused, is not restored.
#[test]
fn damaged_values_are_not_restored() {
    let mut bench = Bench::with_store();
    bench.commit(&table());
    for request in [
        store("flip"),
        Request::WriteVehicle(VehicleConfig { mass_kg: 0.7, ..VehicleConfig::REFERENCE }),
        Request::WriteSettings(Settings { recovery_ms: 900, ..Settings::DEFAULT }),
        Request::Pair(Some([4; 16])),
    ] {
        assert_eq!(bench.settle(&request).0, Reply::Done);
    }
    let kept = bench.store.as_ref().expect("a store").kept.clone();
    assert_eq!(kept.len(), 4);
    for (key, value) in &kept {
        let fresh = || FlightLogic::new(None, BOTH, vec![[0; RECORD_BYTES]; 1]);
        assert!(fresh().restore(*key, value));
        for length in 0..value.len() {
            assert!(!fresh().restore(*key, &value[..length]), "{key:?} cut to {length}");
        }
        assert!(!fresh().restore(*key, &[&value[..], &[0]].concat()), "{key:?} with more behind it");
        let mut layout = value.clone();
        layout[0] ^= 2;
        assert!(!fresh().restore(*key, &layout), "{key:?} of another layout");
        // Under another key it is something else.
        for other in [Key::Vehicle, Key::Settings, Key::Pairing, Key::Table(0)] {
            let same_kind = matches!((key, other), (Key::Table(_), Key::Table(_))) || *key == other;
            assert_eq!(fresh().restore(other, value), same_kind, "{key:?} as {other:?}");
        }
        // Any byte of it changed: refused, or something that passes every check there is.
        for place in 0..value.len() {
            let mut changed = value.clone();
            changed[place] = !changed[place];
            let mut logic = fresh();
            logic.restore(*key, &changed);
            assert_eq!(logic.settings().check(), Ok(()));
            assert_eq!(logic.config().check(), Ok(()));
        }
    }
}

/// A vehicle with a store, switched on with this damage.
fn damaged(keys: &[Key]) -> Bench {
    let mut old = Bench::with_store();
    for request in [
        Request::WriteVehicle(VehicleConfig { mass_kg: 0.75, ..VehicleConfig::REFERENCE }),
        Request::WriteSettings(Settings { recovery_ms: 900, ..Settings::DEFAULT }),
    ] {
        assert_eq!(old.settle(&request).0, Reply::Done);
    }
    let mut bench = power_cycle(&old);
    let mut damage = Damage::NONE;
    for key in keys {
        damage.set(*key, true);
    }
    bench.logic.note_damage(damage);
    bench
}

/// Nothing is written over what nobody has read of.
#[test]
fn damage_that_waits_to_be_acknowledged_keeps_the_store_as_it_is() {
    let mut bench = damaged(&[Key::Settings]);
    let mut own = table();
    own.vehicle = bench.logic.config().hash();
    bench.commit(&own);
    let heavier = VehicleConfig { mass_kg: 0.8, ..VehicleConfig::REFERENCE };
    let writes = [
        Request::StoreTable { name: name("flip"), checksum: own.checksum() },
        Request::WriteVehicle(heavier),
        Request::WriteSettings(Settings::DEFAULT),
        Request::Pair(Some([7; 16])),
    ];
    let jobs = bench.store.as_ref().expect("a store").jobs;
    for write in &writes {
        let waits = Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0);
        assert_eq!(bench.refusal(write.clone()), waits, "{write:?}");
    }
    bench.run(20);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, jobs);
    assert_eq!(bench.acknowledge(), Reply::Done);
    for write in &writes {
        assert_eq!(bench.settle(write).0, Reply::Done, "{write:?}");
    }
}

/// The value in force may be an older one: told again, it goes to the store, once.
#[test]
fn what_is_damaged_is_written_anew_though_it_reads_the_same() {
    let mut bench = damaged(&[Key::Vehicle, Key::Settings, Key::Pairing]);
    assert_eq!(bench.acknowledge(), Reply::Done);
    let settings = *bench.logic.settings();
    let writes =
        [Request::WriteVehicle(*bench.logic.config()), Request::WriteSettings(settings), Request::Pair(None)];
    let jobs = bench.store.as_ref().expect("a store").jobs;
    for pass in 0..2 {
        for (write, n) in writes.iter().zip(1..) {
            assert_eq!(bench.settle(write).0, Reply::Done, "{write:?}");
            let done = bench.store.as_ref().expect("a store").jobs - jobs;
            assert_eq!(done, if pass == 0 { n } else { writes.len() }, "{write:?}");
        }
    }
}

/// A damaged table of which none is left has no name to be mended by: its place is freed once a person has read of it.
#[test]
fn the_places_of_lost_tables_are_freed() {
    let mut bench = damaged(&[Key::Table(0), Key::Table(5)]);
    bench.store.as_mut().expect("a store").kept.push((Key::Table(5), vec![1; 20]));
    let jobs = bench.store.as_ref().expect("a store").jobs;
    bench.run(50);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, jobs, "before it is acknowledged");
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.run(50);
    assert_eq!(bench.store.as_ref().expect("a store").jobs, jobs + 2);
    assert!(bench.store.as_ref().expect("a store").kept.iter().all(|(key, _)| *key != Key::Table(5)));
    assert_eq!(bench.telemetry().arming_block, 0);
}

/// A table of another firmware keeps its place until there is no other.
#[test]
fn a_table_of_another_layout_gives_its_place_up_last() {
    let mut bench = Bench::with_store();
    assert!(!bench.logic.restore(Key::Table(0), &[1, 2, 3]));
    bench.commit(&table());
    for n in 0..STORED_TABLES {
        assert_eq!(bench.settle(&store(&format!("t{n}"))).0, Reply::Done);
        let kept = &bench.store.as_ref().expect("a store").kept;
        let reclaimed = kept.iter().any(|(key, _)| *key == Key::Table(0));
        assert_eq!(reclaimed, n + 1 == STORED_TABLES, "{n}");
    }
    assert_eq!(bench.refusal(store("one more")), Refusal::StoreFull);
}

/// A table that was made for this vehicle is none for the one that it is told to be.
#[test]
fn another_vehicle_forgets_the_table() {
    let mut bench = Bench::with_store();
    let (bytes, checksum) = made_for(VehicleConfig::REFERENCE.hash());
    assert_eq!(bench.stage(&bytes), held(bytes.len()));
    assert!(matches!(bench.ask(Request::CommitTable { checksum }), Reply::Committed { .. }));
    let keep = Request::StoreTable { name: name("own"), checksum };
    assert_eq!(bench.settle(&keep).0, Reply::Done);
    // The same vehicle again changes nothing.
    assert_eq!(bench.settle(&Request::WriteVehicle(VehicleConfig::REFERENCE)).0, Reply::Done);
    assert_eq!(bench.read_table(), bytes);
    let heavier = VehicleConfig { mass_kg: 0.8, ..VehicleConfig::REFERENCE };
    assert_eq!(bench.settle(&Request::WriteVehicle(heavier)).0, Reply::Done);
    assert_eq!(bench.read_table(), [0; 0]);
    assert_eq!(bench.telemetry().table, 0);
    let foreign = Refusal::Table(TableError::OtherVehicle);
    assert_eq!(bench.refusal(Request::LoadTable { name: name("own") }), foreign);
    assert_eq!(bench.stage(&bytes), held(bytes.len()));
    assert_eq!(bench.refusal(Request::CommitTable { checksum }), foreign);
    // Back to what it was.
    assert_eq!(bench.settle(&Request::WriteVehicle(VehicleConfig::REFERENCE)).0, Reply::Done);
    assert!(matches!(bench.ask(Request::LoadTable { name: name("own") }), Reply::Committed { .. }));
}

/// Without a store what it is told holds until it is switched off.
#[test]
fn without_a_store_nothing_is_kept_and_nothing_waits() {
    let mut bench = Bench::ready();
    bench.commit(&table());
    assert_eq!(bench.ask(store("flip")), Reply::Done);
    assert_eq!(listed(&mut bench).len(), 1);
    let settings = Settings { recovery_ms: 900, ..Settings::DEFAULT };
    assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Done);
    assert_eq!(bench.ask(Request::ReadSettings), Reply::Settings(settings));
    assert!(bench.logic.job().is_none());
    assert_eq!(power_cycle(&bench).ask(Request::ReadSettings), Reply::Settings(Settings::DEFAULT));
}

/// A scale at either end of what settings allow is in force, not just written down.
#[test]
fn a_gyro_scale_is_in_force() {
    for scale in [0.95, 0.97, 1.03, 1.05] {
        let mut bench = Bench::ready();
        let settings = Settings { gyro_scale: [scale; 3], ..Settings::DEFAULT };
        assert_eq!(bench.ask(Request::WriteSettings(settings)), Reply::Done);
        let mut sample = bench.sample();
        sample.gyro_radps = [2.0; 3];
        bench.tick_with(Some(sample), 1250, &[Request::Status]);
        let Some(Reply::Status(telemetry)) = bench.answer(bench.number) else { panic!("no status") };
        for rate in telemetry.rates_radps {
            assert!((rate - 2.0 * scale).abs() < 2e-3, "{rate} for a scale of {scale}");
        }
    }
}
