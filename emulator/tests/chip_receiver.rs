//! A radio receiver on USART2, taken by DMA1 stream 5 into a ring.

mod rig;

use emulator::devices::{CRSF_HIGH, CrsfDefect, CrsfReceiver};
use rig::*;

const USART2: u32 = 0x4000_4400;
const RING: u32 = 0x2000_1000;
const RING_BYTES: u32 = 256;

fn listening() -> Rig<emulator::boards::SpeedyBeeF405V3> {
    let mut rig = speedybee();
    rig.start_clocks();
    rig.alternate(GPIOA, 3, 7);
    // Channel 4, memory increment, circular.
    rig.stream(DMA1, 5, 4 << 25 | 1 << 10 | 1 << 8, RING_BYTES, USART2 + 4, RING);
    rig.start_stream(DMA1, 5);
    // 42 MHz / 420,000 baud.
    rig.write(USART2 + 8, 100);
    rig.write(USART2 + 0x14, 1 << 6);
    rig.write(USART2 + 0xC, 1 << 13 | 1 << 2);
    rig
}

/// Lets time pass up to `ms` after power-up: frames begin every 4 ms.
fn pass_to(rig: &mut Rig<emulator::boards::SpeedyBeeF405V3>, ms: u64) {
    let ns = (ms * MS).saturating_sub(rig.ns());
    rig.pass(ns);
}

#[test]
fn frames_arrive_in_the_ring() {
    let mut rig = listening();
    let mut receiver = CrsfReceiver::new();
    receiver.channels[4] = CRSF_HIGH;
    rig.chip.set_receiver(&mut rig.memory, Some(receiver));
    // One frame at 4 ms: 26 bytes of 23.8 µs.
    pass_to(&mut rig, 6);
    assert_eq!(rig.stream_left(DMA1, 5), RING_BYTES - 26);
    let bytes = rig.get(RING, 26);
    assert_eq!(bytes[..3], [0xC8, 24, 0x16]);
    // Channel 5 lies at bit 44 of the payload.
    let word = u32::from_le_bytes(bytes[8..12].try_into().expect("four bytes"));
    assert_eq!((word >> 4 & 0x7FF) as u16, CRSF_HIGH);
    assert_eq!(rig.read(USART2) & 0xE, 0, "no noise, no overrun, no bad stop bit");
    // Ten frames and one of link statistics (14 bytes): round the ring.
    pass_to(&mut rig, 42);
    assert_eq!(rig.stream_left(DMA1, 5), 2 * RING_BYTES - 10 * 26 - 14);
    rig.assert_no_bugs();
}

#[test]
fn a_silent_receiver_sends_nothing_and_a_broken_one_flips_a_bit() {
    let mut rig = listening();
    let mut broken = CrsfReceiver::new();
    broken.defect = CrsfDefect::Silent;
    rig.chip.set_receiver(&mut rig.memory, Some(broken));
    pass_to(&mut rig, 50);
    assert_eq!(rig.stream_left(DMA1, 5), RING_BYTES);
    let board = rig.chip.board_mut();
    board.receiver.as_mut().expect("plugged in").defect = CrsfDefect::FlippedBit;
    pass_to(&mut rig, 54);
    assert_eq!(rig.stream_left(DMA1, 5), RING_BYTES - 26);
    let whole = {
        let mut rig = listening();
        rig.chip.set_receiver(&mut rig.memory, Some(CrsfReceiver::new()));
        pass_to(&mut rig, 6);
        rig.get(RING, 26).to_vec()
    };
    let flipped: u32 = rig.get(RING, 26).iter().zip(&whole).map(|(a, b)| (a ^ b).count_ones()).sum();
    assert_eq!(flipped, 1);
}
