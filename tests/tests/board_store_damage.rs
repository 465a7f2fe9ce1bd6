//! What the image tells of a store in which a bit has flipped while the board was off.

use emulator::boards::SpeedyBeeF405V3;
use emulator::chip::Chip;
use emulator::core::Timing;
use emulator::{Machine, Stop};
use mintime::firmware_image::FirmwareImage;
use mintime_firmware::store::{Flash, FlashFault, Key, SECTOR_BYTES, Sector, Store};
use mintime_shared::framing::{Decoder, Frame};
use mintime_shared::messages::{
    ArmingBlock, Downlink, IncidentCause, Message, PROTOCOL_VERSION, Refusal, Reply, Request, Telemetry,
    Uplink,
};
use mintime_shared::settings::Settings;
use mintime_shared::vehicle::VehicleConfig;

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

struct Board {
    machine: Machine<Chip<SpeedyBeeF405V3>>,
    decoder: Decoder,
    number: u16,
}

impl Board {
    /// Just switched on, with this store.
    fn new(cells: &Cells) -> Self {
        let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
        let mut machine = Machine::new(Chip::new(SpeedyBeeF405V3::new()), Timing::Optimistic, 1);
        machine.semihosting = false;
        machine.load_elf(image.elf()).expect("an image");
        for (address, cells) in SECTORS.into_iter().zip(&cells.0) {
            machine.memory.place(address, cells).expect("flash");
        }
        Self { machine, decoder: Decoder::new(), number: 0 }
    }

    /// The store as it is now.
    fn cells(&self) -> Cells {
        let peek = |address| self.machine.memory.peek(address, SECTOR_BYTES as u32).expect("flash");
        Cells(SECTORS.map(peek).map(Vec::from))
    }

    /// What it says in 50 ms.
    fn listen(&mut self) -> Vec<Message> {
        let until = self.machine.time() + CYCLES;
        assert_eq!(self.machine.run_until(until), Stop::ReachedTime);
        let decoder = &mut self.decoder;
        let said = self.machine.peripherals.link_take();
        said.filter_map(|byte| decoder.push(byte.byte)?.ok()).map(|said: Downlink| said.message).collect()
    }

    fn telemetry(&mut self) -> Telemetry {
        let telemetry = self.listen().into_iter().rev().find_map(|message| match message {
            Message::Telemetry(telemetry) => Some(telemetry),
            Message::Reply { .. } => None,
        });
        telemetry.expect("telemetry")
    }

    fn ask(&mut self, request: &Request) -> Reply {
        self.number += 1;
        let number = self.number;
        for _ in 0..60 {
            let mut frame = Frame::new();
            let uplink = Uplink { version: PROTOCOL_VERSION, number, request: request.clone(), heard_ms: 0 };
            frame.fill(&uplink).expect("a frame");
            let now_ns = self.machine.peripherals.clock().ns(self.machine.time());
            self.machine.peripherals.link_send(now_ns, &[&[0], frame.as_bytes()].concat());
            for message in self.listen() {
                match message {
                    Message::Reply { number: n, reply } if n == number && reply != Reply::Pending => {
                        return reply;
                    }
                    _ => {}
                }
            }
        }
        panic!("no answer to {request:?}");
    }

    fn acknowledge(&mut self) -> Reply {
        let incident = self.telemetry().incident.expect("an incident waits").number;
        self.ask(&Request::Acknowledge { incident })
    }
}

/// What waits to be acknowledged after a start with this store; arming is blocked by it.
fn incident(cells: &Cells) -> Option<IncidentCause> {
    let telemetry = Board::new(cells).telemetry();
    let blocks = telemetry.arming_block & ArmingBlock::INCIDENT.0 != 0;
    assert_eq!(blocks, telemetry.incident.is_some());
    telemetry.incident.map(|incident| incident.cause)
}

fn value(content: &impl serde::Serialize) -> Vec<u8> {
    let mut buffer = [0; 256];
    postcard::to_slice(&(LAYOUT, content), &mut buffer).expect("room").to_vec()
}

/// A store with two settings, the second of them damaged.
fn with_damaged_settings() -> Cells {
    let mut store = Store::new(Cells([vec![0xFF; SECTOR_BYTES], vec![0xFF; SECTOR_BYTES]]));
    for recovery_ms in [900, 1200] {
        let settings = Settings { recovery_ms, ..Settings::DEFAULT };
        store.write(Key::Settings, &value(&settings)).expect("room");
    }
    let cells = &mut store.flash().0[0];
    let end = cells.iter().rposition(|byte| *byte != 0xFF).expect("records") + 1;
    cells[end - 12] ^= 0x10;
    Cells(store.flash().0.clone())
}

/// Told at each start, written only after somebody has read of it, and mended by the very key alone.
#[test]
fn damage_is_told_until_the_very_value_is_written_anew() {
    let mut board = Board::new(&with_damaged_settings());
    assert_eq!(board.telemetry().incident.map(|i| i.cause), Some(IncidentCause::StoreDamaged));
    let waits = Reply::Refused(Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0));
    let older = Settings { recovery_ms: 900, ..Settings::DEFAULT };
    assert_eq!(board.ask(&Request::ReadSettings), Reply::Settings(older));
    for request in
        [Request::WriteVehicle(VehicleConfig::REFERENCE), Request::WriteSettings(Settings::DEFAULT)]
    {
        assert_eq!(board.ask(&request), waits);
    }
    assert_eq!(board.acknowledge(), Reply::Done);
    assert_eq!(board.ask(&Request::WriteVehicle(VehicleConfig::REFERENCE)), Reply::Done);
    // After a reset the damage is told again, also after its sector was given up.
    let mut store = Store::new(board.cells());
    assert!(store.flash().0[1][20..].iter().all(|byte| *byte == 0xFF));
    for n in 0..100_u8 {
        store.write(Key::Table(1), &[n; 200]).expect("room");
    }
    assert!(store.flash().0[1][20..].iter().any(|byte| *byte != 0xFF));
    store.remove(Key::Table(1)).expect("room");
    let mut board = Board::new(store.flash());
    assert_eq!(board.telemetry().incident.map(|i| i.cause), Some(IncidentCause::StoreDamaged));
    assert_eq!(board.acknowledge(), Reply::Done);
    // Read of, and yet not to be flown with: another kill channel than the one that is connected may be in force.
    let blocks = |board: &mut Board| board.telemetry().arming_block & ArmingBlock::DAMAGED_SETTINGS.0 != 0;
    assert!(blocks(&mut board));
    // What is in force already is written all the same.
    assert_eq!(board.ask(&Request::WriteSettings(older)), Reply::Done);
    assert!(!blocks(&mut board));
    assert_eq!(incident(&board.cells()), None);
}

/// A table that another firmware has laid out otherwise is whole: no damage, and nothing to acknowledge at each start.
#[test]
fn a_table_of_another_layout_is_no_incident() {
    let mut store = Store::new(Cells([vec![0xFF; SECTOR_BYTES], vec![0xFF; SECTOR_BYTES]]));
    store.write(Key::Table(2), &value(&("flip", [7_u8; 32]))).expect("room");
    assert_eq!(incident(store.flash()), None);
    // Settings that cannot be read are told: those in force are others.
    store.write(Key::Settings, &value(&[7_u8; 3])).expect("room");
    assert_eq!(incident(store.flash()), Some(IncidentCause::StoreDamaged));
}

/// What was kept by a firmware whose store was laid out otherwise, the pairing key above all, does not vanish silently.
#[test]
fn an_earlier_store_is_an_incident() {
    let mut cells = Cells([vec![0xFF; SECTOR_BYTES], vec![0xFF; SECTOR_BYTES]]);
    let header = [*b"MTS1", 1_u32.to_le_bytes()].concat();
    let check = mintime_shared::crc32(&header).to_le_bytes();
    cells.0[0][..12].copy_from_slice(&[&header[..], &check].concat());
    assert_eq!(incident(&cells), Some(IncidentCause::StoreDamaged));
}

#[test]
fn a_flipped_bit_in_what_was_written_last_is_an_incident() {
    let mut store = Store::new(Cells([vec![0xFF; SECTOR_BYTES], vec![0xFF; SECTOR_BYTES]]));
    for recovery_ms in [900, 1200] {
        let settings = Settings { recovery_ms, ..Settings::DEFAULT };
        store.write(Key::Settings, &value(&settings)).expect("room");
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
