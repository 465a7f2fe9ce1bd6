//! What a stream reads when, and how long it takes.

mod rig;

use emulator::bus::Peripherals;
use rig::*;

const DR: u32 = USART1 + 4;
const CR1: u32 = USART1 + 0xC;
const CR3: u32 = USART1 + 0x14;
const BUFFER: u32 = 0x2000_1000;
/// To USART1 by bytes, memory increments.
const OUT: u32 = 4 << 25 | 1 << 10 | 1 << 6;

/// A sender whose requests are off.
fn port() -> Rig<emulator::chip::BareBoard> {
    let mut rig = bare();
    rig.start_clocks();
    rig.alternate(GPIOA, 9, 7);
    rig.write(USART1 + 8, 91);
    rig.write(CR1, 1 << 13 | 1 << 3);
    rig.pass(20 * US);
    rig
}

fn sent(rig: &mut Rig<emulator::chip::BareBoard>) -> Vec<u8> {
    rig.pass(MS);
    rig.chip.serial_take(1).map(|byte| byte.byte).collect()
}

/// RM0090 section 10.3.7: one item in direct mode; as much as the buffer holds without it.
#[test]
fn a_stream_to_a_peripheral_reads_ahead_when_it_is_switched_on() {
    for (fcr, ahead) in [(0, 1), (1 << 2 | 3, 16)] {
        let mut rig = port();
        rig.put(BUFFER, &[b'a'; 20]);
        rig.stream(DMA2, 7, OUT, 20, DR, BUFFER);
        rig.write(DMA2 + 0x10 + 0x18 * 7 + 0x14, fcr);
        rig.start_stream(DMA2, 7);
        rig.put(BUFFER, &[b'b'; 20]);
        rig.set(CR3, 1 << 7);
        let sent = sent(&mut rig);
        assert_eq!(sent.iter().filter(|byte| **byte == b'a').count(), ahead);
        assert_eq!(sent.len(), 20);
        assert!(!rig.stream_on(DMA2, 7));
        rig.assert_no_bugs();
    }
}

/// And again behind every item, in a ring across its end.
#[test]
fn a_ring_is_read_ahead_across_its_end() {
    let mut rig = port();
    rig.put(BUFFER, b"abc");
    rig.stream(DMA2, 7, OUT | 1 << 8, 3, DR, BUFFER);
    rig.start_stream(DMA2, 7);
    rig.set(CR3, 1 << 7);
    let sent = sent(&mut rig);
    assert!(sent.len() > 80 && sent.chunks_exact(3).all(|round| round == b"abc"), "{sent:?}");
}

/// RM0090 section 10.5.6.
#[test]
fn a_stream_switched_on_again_starts_over() {
    let mut rig = port();
    rig.set(CR3, 1 << 7);
    rig.put(BUFFER, b"again");
    rig.stream(DMA2, 7, OUT, 5, DR, BUFFER);
    rig.start_stream(DMA2, 7);
    assert_eq!(sent(&mut rig), b"again");
    assert_eq!(rig.stream_left(DMA2, 7), 0);
    rig.write(DMA2 + 0x0C, 0x3D << 22);
    rig.start_stream(DMA2, 7);
    assert_eq!(sent(&mut rig), b"again");
    rig.assert_no_bugs();
    // With nothing ever written there is nothing to do.
    rig.write(DMA2 + 0x0C, 0x3D << 22);
    rig.stream(DMA2, 6, OUT, 0, DR, BUFFER);
    rig.start_stream(DMA2, 6);
    assert!(!rig.stream_on(DMA2, 6) && rig.has_bug("nothing to transfer"));
}

/// A burst of four words takes four times an item, in pessimistic timing.
#[test]
fn items_take_their_time() {
    for (pessimistic, least, most) in [(false, 0, 20), (true, 45, 120)] {
        let mut rig = bare();
        rig.chip.set_pessimistic(pessimistic);
        rig.start_clocks();
        rig.write(TIM4 + 0x2C, 9999);
        rig.write(TIM4 + 0x48, 3 << 8 | 13);
        rig.stream(DMA1, 6, 2 << 25 | 2 << 13 | 2 << 11 | 1 << 10 | 1 << 6, 4, TIM4 + 0x4C, BUFFER);
        rig.start_stream(DMA1, 6);
        rig.write(TIM4 + 0x0C, 1 << 8);
        let start = rig.at;
        rig.write(TIM4 + 0x14, 1);
        while rig.stream_on(DMA1, 6) {
            rig.at -= 3;
        }
        let took = rig.at - start;
        assert!((least..=most).contains(&took), "{took} cycles");
        rig.assert_no_bugs();
    }
}
