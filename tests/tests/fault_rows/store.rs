//! The store in flash, cut off in its work or decayed.

use mintime_shared::messages::{Reply, Request};
use mintime_shared::settings::Settings;
use mintime_shared::vehicle::VehicleConfig;

use super::rig::{MS, Rig, draw};

/// The store's first sector.
const STORE: u32 = 0x0800_4000;
const STORE_BYTES: u32 = 16 * 1024;
/// Settings that the vehicle has been told before anything breaks.
pub(super) const KEPT_SETTINGS: Settings = Settings { gyro_cutoff_hz: 149.0, ..Settings::DEFAULT };

/// Flips a bit of what was kept last.
pub(super) fn decay_store(rig: &mut Rig) {
    let memory = &mut rig.board().memory;
    let cells = memory.peek(STORE, STORE_BYTES).expect("flash");
    // The last value ends before its checksum and its confirmation.
    let end = cells.iter().rposition(|byte| *byte != 0xFF).expect("records") + 1;
    let decayed = cells[end - 12] ^ 1;
    memory.place(STORE + end as u32 - 12, &[decayed]).expect("flash");
}

/// Cuts the power in a write to the store, or in the erase that makes room in it. Returns the vehicle file that was asked to
/// be kept last and the one confirmed before.
pub(super) fn cut_store(rig: &mut Rig, in_erase: bool) -> [VehicleConfig; 2] {
    let mut confirmed = VehicleConfig::REFERENCE;
    for round in 1..600_u16 {
        let mass_kg = VehicleConfig::REFERENCE.mass_kg + 1e-4 * f32::from(round);
        let wanted = VehicleConfig { mass_kg, ..VehicleConfig::REFERENCE };
        rig.begin(Request::WriteVehicle(wanted));
        for _ in 0..4000 {
            // An erase takes a quarter of a second, a word 16 µs.
            let (step_ns, at_work_ns) = if in_erase { (MS, 5 * MS) } else { (10_000, 1_000) };
            let later = rig.vehicle.now_ns() + step_ns;
            rig.vehicle.advance_to(later).expect("time goes on");
            let board = rig.board();
            let left = board.memory.flash_interface.busy_until.saturating_sub(board.time());
            if left >= board.peripherals.clock().cycles_for(at_work_ns) {
                let noise = draw(&mut rig.random);
                let board = rig.board();
                board.peripherals.cut_power(&mut board.memory, noise);
                return [wanted, confirmed];
            }
            if !in_erase {
                continue;
            }
            match rig.step() {
                Some(answer) => {
                    assert_eq!(answer, Ok(Reply::Done));
                    confirmed = wanted;
                    break;
                }
                // Sooner than the client would.
                None => rig.begin(Request::WriteVehicle(wanted)),
            }
        }
    }
    panic!("flash was never at work");
}

/// What was kept is what was confirmed or what was being written, and all else is untouched.
pub(super) fn check_store(rig: &mut Rig, [wanted, confirmed]: [VehicleConfig; 2]) {
    match rig.ask(Request::ReadVehicle) {
        Ok(Reply::Vehicle(Some(found))) => assert!(found == wanted || found == confirmed, "{found:?}"),
        other => panic!("{other:?}"),
    }
    assert_eq!(rig.ask(Request::ReadSettings), Ok(Reply::Settings(KEPT_SETTINGS)));
}
