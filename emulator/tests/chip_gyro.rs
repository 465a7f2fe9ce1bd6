//! The gyro on SPI1, by polling and by DMA.

mod rig;

use emulator::boards::SpeedyBeeF405V3;
use emulator::bus::Peripherals;
use emulator::chip::Pin;
use rig::*;

const CR1: u32 = SPI1;
const CR2: u32 = SPI1 + 4;
const SR: u32 = SPI1 + 8;
const DR: u32 = SPI1 + 0xC;
const MASTER: u32 = 1 << 9 | 1 << 8 | 1 << 2;
/// 84 MHz / 16: 5.25 MHz.
const RATE: u32 = 3 << 3;
const BUFFER: u32 = 0x2000_3000;
const CONFIGURATION: &[u8] = include_bytes!("../../firmware/vendor/bosch-bmi270/config_file.bin");

fn board(rate: u32) -> Rig<SpeedyBeeF405V3> {
    let mut rig = speedybee();
    rig.start_clocks();
    rig.write(GPIOA + 0x18, 1 << 4);
    rig.mode(GPIOA, 4, 1);
    for pin in 5..8 {
        rig.alternate(GPIOA, pin, 5);
    }
    rig.write(CR1, MASTER | rate);
    rig.set(CR1, 1 << 6);
    rig
}

fn exchange(rig: &mut Rig<SpeedyBeeF405V3>, byte: u8) -> u8 {
    rig.wait_for(SR, 2);
    rig.write(DR, byte.into());
    rig.wait_for(SR, 1);
    rig.read(DR) as u8
}

fn select(rig: &mut Rig<SpeedyBeeF405V3>, on: bool) {
    rig.write(GPIOA + 0x18, if on { 1 << 20 } else { 1 << 4 });
    rig.pass(US);
}

fn read_register(rig: &mut Rig<SpeedyBeeF405V3>, address: u8) -> u8 {
    select(rig, true);
    exchange(rig, address | 0x80);
    exchange(rig, 0);
    let value = exchange(rig, 0);
    select(rig, false);
    value
}

fn write_register(rig: &mut Rig<SpeedyBeeF405V3>, address: u8, value: u8) {
    select(rig, true);
    exchange(rig, address);
    exchange(rig, value);
    select(rig, false);
    rig.pass(2 * US);
}

/// The upload of a driver that goes by the data sheet.
fn bring_up(rig: &mut Rig<SpeedyBeeF405V3>, bytes: usize) {
    upload(rig, &CONFIGURATION[..bytes], |chunk| chunk * 128);
}

/// An upload of 256 bytes at a time, each to the word that `place` says.
fn upload(rig: &mut Rig<SpeedyBeeF405V3>, bytes: &[u8], place: impl Fn(usize) -> usize) {
    rig.pass(5 * MS);
    read_register(rig, 0);
    write_register(rig, 0x7C, 0);
    rig.pass(450 * US);
    write_register(rig, 0x59, 0);
    for (chunk, bytes) in bytes.chunks(256).enumerate() {
        let word = place(chunk);
        select(rig, true);
        exchange(rig, 0x5B);
        exchange(rig, (word & 15) as u8);
        exchange(rig, (word >> 4) as u8);
        select(rig, false);
        rig.pass(2 * US);
        select(rig, true);
        exchange(rig, 0x5E);
        for byte in bytes {
            exchange(rig, *byte);
        }
        select(rig, false);
        rig.pass(2 * US);
    }
    write_register(rig, 0x59, 1);
}

fn enable(rig: &mut Rig<SpeedyBeeF405V3>) {
    write_register(rig, 0x42, 0xAB);
    write_register(rig, 0x40, 0xAB);
    write_register(rig, 0x43, 0x08);
    write_register(rig, 0x41, 0x03);
    // Data ready on INT1, active high, push-pull.
    write_register(rig, 0x53, 0x0A);
    write_register(rig, 0x58, 0x04);
    write_register(rig, 0x7D, 0x0E);
}

#[test]
fn the_first_edge_of_chip_select_chooses_spi() {
    let mut rig = board(RATE);
    rig.pass(5 * MS);
    assert_eq!(read_register(&mut rig, 0), 0xFF);
    assert_eq!(read_register(&mut rig, 0), 0x24);
    write_register(&mut rig, 0x7E, 0xB6);
    rig.pass(2 * MS);
    assert_eq!(read_register(&mut rig, 0), 0xFF, "again after a soft reset");
    assert_eq!(read_register(&mut rig, 0), 0x24);
}

#[test]
fn the_configuration_must_be_complete_and_takes_its_time() {
    let mut rig = board(RATE);
    bring_up(&mut rig, 8192);
    assert_eq!(read_register(&mut rig, 0x21) & 15, 0, "not at once");
    rig.pass(20 * MS);
    assert_eq!(read_register(&mut rig, 0x21) & 15, 1);
    let upload = rig.chip.board().gyro.uploaded().unwrap();
    assert_eq!(upload.bytes, 8192);
    rig.assert_no_bugs();

    let mut rig = board(RATE);
    bring_up(&mut rig, 8192 - 256);
    rig.pass(20 * MS);
    assert_eq!(read_register(&mut rig, 0x21) & 15, 2);
    assert!(rig.has_bug("7936 bytes of configuration"), "{:?}", rig.bugs());
    let other = rig.chip.board().gyro.uploaded().unwrap();
    assert_ne!(other.hash, upload.hash);
}

/// The chip checks what it is given.
#[test]
fn a_configuration_must_be_the_makers_and_lie_where_it_belongs() {
    let mut changed = CONFIGURATION.to_vec();
    changed[4000] ^= 1;
    for (bytes, factor, swapped) in [(&changed[..], 128, 0), (CONFIGURATION, 0, 0), (CONFIGURATION, 128, 1)] {
        let mut rig = board(RATE);
        upload(&mut rig, bytes, |chunk| (chunk ^ swapped) * factor);
        rig.pass(20 * MS);
        assert_eq!(read_register(&mut rig, 0x21) & 15, 2);
        assert!(rig.has_bug("does not lie where it belongs"), "{:?}", rig.bugs());
    }
}

#[test]
fn samples_come_after_the_dummy_byte_at_their_edge() {
    let mut rig = board(RATE);
    bring_up(&mut rig, 8192);
    rig.pass(25 * MS);
    enable(&mut rig);
    assert_eq!(rig.chip.board().gyro.gyro_rate_hz(), Some(800.0));
    rig.write(SYSCFG + 0x0C, 2);
    rig.write(EXTI + 0x08, 1 << 4);
    rig.write(EXTI, 1 << 4);
    let one_dps = 1_f64.to_radians();
    let start = rig.ns();
    for tick in 1..=40_u64 {
        let due = start + tick * 1_250_000;
        // Past the end of the pulse before.
        rig.pass(due - 100 * US - rig.ns());
        let Rig { chip, memory, .. } = &mut rig;
        chip.imu_sample(memory, due, [100.0 * one_dps, -2500.0 * one_dps, 0.0], [0.0, 9.806_65, -19.6133]);
        let edge = rig.chip.next_event();
        assert_eq!(edge, rig.chip.clock().cycle(due));
        rig.chip.advance(&mut rig.memory, edge - 1);
        assert!(!rig.irq(10));
        rig.chip.advance(&mut rig.memory, edge);
        rig.at = edge;
        assert!(rig.irq(10) && rig.chip.level(Pin::new('C', 4)));
        rig.write(EXTI + 0x14, 1 << 4);
        select(&mut rig, true);
        exchange(&mut rig, 0x0C | 0x80);
        exchange(&mut rig, 0);
        let bytes: [u8; 12] = std::array::from_fn(|_| exchange(&mut rig, 0));
        select(&mut rig, false);
        let words: [i16; 6] = std::array::from_fn(|n| i16::from_le_bytes([bytes[2 * n], bytes[2 * n + 1]]));
        let gyro = if tick * 1_250 < 45_000 { [0; 3] } else { [1638, -32768, 0] };
        let accel = if tick * 1_250 < 2_000 { [0; 3] } else { [0, 2048, -4096] };
        assert_eq!(words[3..], gyro, "{tick}");
        assert_eq!(words[..3], accel, "{tick}");
        assert_eq!(read_register(&mut rig, 0x03) & 0xC0, 0, "reading takes data ready back");
    }
    assert!(rig.chip.level(Pin::new('C', 4)));
    rig.pass(MS);
    assert!(!rig.chip.level(Pin::new('C', 4)));
    rig.assert_no_bugs();
}

/// A line that rings rises as often as told, and rests where the sensor holds it.
#[test]
fn a_data_ready_line_rings_until_it_is_told_not_to() {
    let mut rig = board(RATE);
    bring_up(&mut rig, 8192);
    rig.pass(25 * MS);
    enable(&mut rig);
    rig.write(SYSCFG + 0x0C, 2);
    rig.write(EXTI + 0x08, 1 << 4);
    let from_ns = rig.ns() + 10 * US;
    let Rig { chip, memory, .. } = &mut rig;
    chip.ring_data_ready(memory, from_ns, Some(3 * US));
    for edge in 0..20 {
        rig.pass(from_ns + edge * 3 * US - rig.ns());
        assert_eq!(rig.read(EXTI + 0x14), 1 << 4, "edge {edge}");
        assert!(!rig.chip.level(Pin::new('C', 4)));
        rig.write(EXTI + 0x14, 1 << 4);
        rig.pass(2 * US);
        assert_eq!(rig.read(EXTI + 0x14), 0, "edge {edge}");
    }
    let Rig { chip, memory, .. } = &mut rig;
    chip.ring_data_ready(memory, from_ns, None);
    rig.pass(MS);
    assert_eq!(rig.read(EXTI + 0x14), 0);
}

#[test]
fn a_hand_turns_the_sensor_on_top_of_all_else() {
    let mut rig = board(RATE);
    bring_up(&mut rig, 8192);
    rig.pass(25 * MS);
    enable(&mut rig);
    rig.pass(50 * MS);
    rig.chip.board_mut().gyro.hand_radps = [0.0, 0.0, 2.0];
    let now = rig.ns();
    let Rig { chip, memory, .. } = &mut rig;
    chip.imu_sample(memory, now + MS, [0.1, 0.2, 0.3], [0.0, 0.0, 9.806_65]);
    rig.pass(MS + US);
    let z = i16::from_le_bytes([read_register(&mut rig, 0x16), read_register(&mut rig, 0x17)]);
    assert_eq!(z, (2.3_f64.to_degrees() * 16.384).round() as i16);
}

#[test]
fn mistakes_with_the_gyro_are_told() {
    // 84 MHz / 8 = 10.5 MHz.
    let mut rig = board(2 << 3);
    rig.pass(5 * MS);
    read_register(&mut rig, 0);
    assert!(rig.has_bug("SPI runs at 10500000 Hz"), "{:?}", rig.bugs());

    let mut rig = board(RATE | 1);
    rig.pass(5 * MS);
    read_register(&mut rig, 0);
    assert!(rig.has_bug("SPI mode 1"), "{:?}", rig.bugs());

    let mut rig = board(RATE);
    rig.pass(5 * MS);
    read_register(&mut rig, 0);
    assert_eq!(read_register(&mut rig, 0x12), 0);
    assert!(rig.has_bug("data are read before INTERNAL_STATUS"), "{:?}", rig.bugs());
    write_register(&mut rig, 0x7C, 0);
    read_register(&mut rig, 0x21);
    assert!(rig.has_bug("within 450 µs of leaving"), "{:?}", rig.bugs());
    write_register(&mut rig, 0x7E, 0xA0);
    assert!(rig.has_bug("trim memory"), "{:?}", rig.bugs());
}

#[test]
fn two_streams_exchange_a_burst_at_the_rate_of_the_divider() {
    let mut rig = board(RATE);
    bring_up(&mut rig, 8192);
    rig.pass(25 * MS);
    enable(&mut rig);
    rig.pass(50 * MS);
    let now = rig.ns();
    let Rig { chip, memory, .. } = &mut rig;
    chip.imu_sample(memory, now + MS, [0.1, 0.2, 0.3], [0.0, 0.0, 9.806_65]);
    rig.pass(MS + US);
    rig.put(BUFFER, &[0; 14]);
    rig.put(BUFFER, &[0x8C]);
    // As the HAL does it: off, receive request, both streams, transmit request, on.
    rig.clear(CR1, 1 << 6);
    rig.set(CR2, 1);
    select(&mut rig, true);
    rig.stream(DMA2, 0, 3 << 25 | 1 << 10 | 1 << 4, 14, DR, BUFFER + 0x40);
    rig.start_stream(DMA2, 0);
    rig.stream(DMA2, 3, 3 << 25 | 1 << 10 | 1 << 6, 14, DR, BUFFER);
    rig.start_stream(DMA2, 3);
    rig.set(CR2, 2);
    let start = rig.ns();
    rig.set(CR1, 1 << 6);
    assert_eq!(rig.read(SR) & 0x80, 0x80);
    while rig.stream_on(DMA2, 0) {}
    let took = rig.ns() - start;
    // 14 bytes at 5.25 MHz.
    assert!((21_333..21_500).contains(&took), "{took}");
    assert_eq!(rig.read(SR) & 0x80, 0);
    select(&mut rig, false);
    let bytes = rig.get(BUFFER + 0x40, 14);
    let z = i16::from_le_bytes([bytes[12], bytes[13]]);
    assert_eq!(z, (0.3_f64.to_degrees() * 16.384).round() as i16);
    assert_eq!(i16::from_le_bytes([bytes[6], bytes[7]]), 2048);
    assert!(rig.irq(56));
    rig.assert_no_bugs();
}

#[test]
fn a_word_nobody_takes_is_overrun() {
    let mut rig = board(RATE);
    rig.write(DR, 1);
    rig.pass(2 * US);
    rig.write(DR, 2);
    rig.pass(2 * US);
    assert_eq!(rig.read(SR) & 0x41, 0x41);
    rig.read(DR);
    rig.read(SR);
    assert_eq!(rig.read(SR) & 0x41, 0);
}
