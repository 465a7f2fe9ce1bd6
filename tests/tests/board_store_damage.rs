//! What the image tells of a store in which a bit has flipped while the board was off.

use emulator::boards::SpeedyBeeF405V3;
use emulator::chip::Chip;
use emulator::core::Timing;
use emulator::{Machine, Stop};
use mintime::firmware_image::FirmwareImage;
use mintime_firmware::store::{Flash, FlashFault, Key, SECTOR_BYTES, Sector, Store};
use mintime_shared::framing::Decoder;
use mintime_shared::messages::{Downlink, IncidentCause, Message};
use mintime_shared::settings::Settings;

/// The store's sectors in the chip's flash (RM0090 table 5).
const SECTORS: [u32; 2] = [0x0800_4000, 0x0800_8000];
/// Of what is kept under a key, its first byte.
const LAYOUT: u8 = 1;
/// 50 ms of the clock after the start-up, and more of the one before.
const CYCLES: u64 = 168_000 * 50;

struct Cells([Vec<u8>; 2]);

impl Flash for Cells {
    fn read(&mut self, sector: Sector, offset: usize, into: &mut [u8]) -> Result<(), FlashFault> {
        into.copy_from_slice(&self.0[sector as usize][offset..offset + into.len()]);
        Ok(())
    }
    fn program(&mut self, sector: Sector, offset: usize, word: u32) -> Result<(), FlashFault> {
        for (cell, byte) in self.0[sector as usize][offset..].iter_mut().zip(word.to_le_bytes()) {
            *cell &= byte;
        }
        Ok(())
    }
    fn erase(&mut self, sector: Sector) -> Result<(), FlashFault> {
        self.0[sector as usize].fill(0xFF);
        Ok(())
    }
}

/// What waits to be acknowledged after a start with this store.
fn incident(cells: &Cells) -> Option<IncidentCause> {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    let mut machine = Machine::new(Chip::new(SpeedyBeeF405V3::new()), Timing::Optimistic, 1);
    machine.semihosting = false;
    machine.load_elf(image.elf()).expect("an image");
    for (address, cells) in SECTORS.into_iter().zip(&cells.0) {
        machine.memory.place(address, cells).expect("flash");
    }
    assert_eq!(machine.run_until(CYCLES), Stop::ReachedTime);
    let mut decoder = Decoder::new();
    let said: Vec<Downlink> =
        machine.peripherals.link_take().filter_map(|byte| decoder.push(byte.byte)?.ok()).collect();
    let Some(Downlink { message: Message::Telemetry(telemetry), .. }) = said.into_iter().next_back() else {
        panic!("no telemetry");
    };
    telemetry.incident.map(|incident| incident.cause)
}

#[test]
fn a_flipped_bit_in_what_was_written_last_is_an_incident() {
    let mut store = Store::new(Cells([vec![0xFF; SECTOR_BYTES], vec![0xFF; SECTOR_BYTES]]));
    for recovery_ms in [900, 1200] {
        let settings = Settings { recovery_ms, ..Settings::DEFAULT };
        let mut buffer = [0; 64];
        let value = postcard::to_slice(&(LAYOUT, settings), &mut buffer).expect("room");
        store.write(Key::Settings, value).expect("room");
    }
    assert_eq!(incident(store.flash()), None);

    // The second value ends before its checksum and its confirmation.
    let cells = &mut store.flash().0[0];
    let end = cells.iter().rposition(|byte| *byte != 0xFF).expect("records") + 1;
    cells[end - 12] ^= 0x10;
    assert_eq!(incident(store.flash()), Some(IncidentCause::StoreDamaged));
    // The start of a table that a power cut has ended is none.
    let cells = &mut store.flash().0[0];
    cells[end - 12] ^= 0x10;
    cells[end..end + 4].copy_from_slice(&0xFFFF_10F0_u32.to_le_bytes());
    assert_eq!(incident(store.flash()), None);
}
