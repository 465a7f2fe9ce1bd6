//! Serial ports and the streams that serve them.

mod rig;

use emulator::chip::BareBoard;
use rig::*;

const SR: u32 = USART1;
const DR: u32 = USART1 + 4;
const BRR: u32 = USART1 + 8;
const CR1: u32 = USART1 + 0xC;
const CR3: u32 = USART1 + 0x14;
const IRQ: u32 = 37;
const UE: u32 = 1 << 13;
const RING: u32 = 0x2000_2000;
/// A frame of ten bits at 84 MHz / 91.
const FRAME_NS: u64 = 10_833;

fn port() -> Rig<BareBoard> {
    let mut rig = bare();
    rig.start_clocks();
    rig.alternate(GPIOA, 9, 7);
    rig.alternate(GPIOA, 10, 7);
    rig.write(BRR, 91);
    rig.write(CR1, UE | 1 << 3 | 1 << 2);
    // The preamble of the sender, and the receiver's first idle frame.
    rig.pass(20 * US);
    assert_eq!(rig.read(SR), 0xD0);
    rig.read(DR);
    rig
}

#[test]
fn bytes_leave_back_to_back_at_the_speed_of_the_divider() {
    let mut rig = port();
    assert_eq!(rig.read(SR), 0xC0);
    rig.write(DR, 0x11);
    assert_eq!(rig.read(SR), 0x80, "the shift register took the first");
    rig.write(DR, 0x22);
    assert_eq!(rig.read(SR), 0, "the second waits");
    rig.pass(FRAME_NS + 200);
    assert_eq!(rig.read(SR), 0x80);
    rig.pass(FRAME_NS);
    assert_eq!(rig.read(SR), 0xC0);
    let sent: Vec<_> = rig.chip.serial_take(1).collect();
    assert_eq!(sent.iter().map(|byte| byte.byte).collect::<Vec<_>>(), [0x11, 0x22]);
    assert!((923_076..=923_077).contains(&sent[0].baud));
    assert!(sent[1].ns - sent[0].ns - FRAME_NS <= 1);
    rig.assert_no_bugs();
}

#[test]
fn the_line_is_idle_once_one_frame_after_the_last_byte() {
    let mut rig = port();
    rig.write(CR1, UE | 1 << 3 | 1 << 2 | 1 << 4);
    let start = rig.ns();
    rig.chip.serial_send(1, start, b"ab");
    rig.pass(10_400);
    assert_eq!(rig.read(SR) & 0x20, 0x20);
    assert_eq!(rig.read(DR), u32::from(b'a'));
    assert_eq!(rig.read(SR) & 0x20, 0);
    rig.pass(10_850);
    assert_eq!(rig.read(SR) & 0x38, 0x20, "no idle line between the two");
    assert_eq!(rig.read(DR), u32::from(b'b'));
    let end = start + 2 * 10_850;
    let wait = end + FRAME_NS - 300 - rig.ns();
    rig.pass(wait);
    assert!(!rig.irq(IRQ));
    rig.pass(600);
    assert!(rig.irq(IRQ));
    // Reading DR alone does not clear it; SR and then DR does.
    rig.read(DR);
    assert!(rig.irq(IRQ));
    assert_eq!(rig.read(SR) & 0x10, 0x10);
    rig.read(DR);
    assert!(!rig.irq(IRQ));
    rig.pass(50 * FRAME_NS);
    assert_eq!(rig.read(SR) & 0x10, 0, "told once");
    rig.assert_no_bugs();
}

#[test]
fn a_gap_shorter_than_a_frame_is_not_idle() {
    let mut rig = port();
    let start = rig.ns();
    rig.chip.serial_send(1, start, b"a");
    rig.chip.serial_pause(1, start, 5_000);
    rig.chip.serial_send(1, start, b"b");
    rig.pass(11 * US);
    rig.read(DR);
    rig.pass(16 * US);
    assert_eq!(rig.read(SR) & 0x30, 0x20);
}

#[test]
fn a_byte_that_nobody_takes_is_overrun_by_the_next() {
    let mut rig = port();
    let now = rig.ns();
    rig.chip.serial_send(1, now, b"abc");
    rig.pass(100 * US);
    assert_eq!(rig.read(SR) & 0x28, 0x28);
    assert_eq!(rig.read(DR), u32::from(b'a'));
    assert_eq!(rig.read(SR) & 0x28, 0);
}

#[test]
fn a_wrong_speed_noise_and_a_break_are_errors() {
    let mut rig = port();
    rig.chip.set_host_baud(1, 900_000);
    let now = rig.ns();
    rig.chip.serial_send(1, now, &[0x55]);
    rig.pass(50 * US);
    assert_eq!(rig.read(SR) & 2, 2);
    rig.read(DR);
    rig.chip.set_host_baud(1, 460_800);
    let now = rig.ns();
    rig.chip.serial_send(1, now, &[0x55]);
    rig.pass(50 * US);
    rig.read(SR);
    assert_ne!(rig.read(DR), 0x55);
    rig.chip.set_host_baud(1, 921_600);
    let now = rig.ns();
    rig.chip.serial_send_noisy(1, now, 0x55);
    rig.pass(50 * US);
    assert_eq!(rig.read(SR) & 6, 4);
    assert_eq!(rig.read(DR), 0x55);
    let now = rig.ns();
    rig.chip.serial_break(1, now, 20 * US);
    rig.pass(50 * US);
    assert_eq!(rig.read(SR) & 0x22, 0x22);
    assert_eq!(rig.read(DR), 0);
    assert_eq!(rig.read(SR) & 0x2F, 0);
}

#[test]
fn a_ring_counts_down_and_around_with_half_and_full_flags() {
    let mut rig = port();
    // Channel 4, circular, memory increments, half and full interrupts.
    rig.stream(DMA2, 2, 4 << 25 | 1 << 10 | 1 << 8 | 1 << 4 | 1 << 3, 8, DR, RING);
    rig.start_stream(DMA2, 2);
    rig.set(CR3, 1 << 6);
    let now = rig.ns();
    rig.chip.serial_send(1, now, b"0123456789");
    rig.pass(3 * 10_850 + 5_000);
    assert_eq!((rig.stream_left(DMA2, 2), rig.stream_flags(DMA2, 2)), (5, 0));
    assert!(!rig.irq(58));
    rig.pass(10_850);
    assert_eq!((rig.stream_left(DMA2, 2), rig.stream_flags(DMA2, 2)), (4, 0x10));
    assert!(rig.irq(58));
    rig.pass(4 * 10_850);
    assert_eq!((rig.stream_left(DMA2, 2), rig.stream_flags(DMA2, 2)), (8, 0x30));
    rig.write(DMA2 + 0x08, 0x3D << 16);
    assert!(!rig.irq(58));
    rig.pass(100 * US);
    assert_eq!(rig.stream_left(DMA2, 2), 6);
    assert_eq!(rig.get(RING, 8), b"89234567");
    assert!(rig.stream_on(DMA2, 2));
    assert_eq!(rig.read(SR) & 0x38, 0x10, "DMA read every byte; the line is idle");
    rig.assert_no_bugs();
}

#[test]
fn a_stream_sends_a_buffer_and_switches_itself_off() {
    let mut rig = port();
    rig.put(RING, b"time-optimal");
    rig.write(SR, !(1 << 6));
    rig.set(CR3, 1 << 7);
    rig.stream(DMA2, 7, 4 << 25 | 1 << 10 | 1 << 6 | 1 << 4, 12, DR, RING);
    rig.start_stream(DMA2, 7);
    assert_eq!(rig.stream_left(DMA2, 7), 10, "one in the shift register, one waiting");
    rig.pass(12 * FRAME_NS + 1_000);
    assert!(!rig.stream_on(DMA2, 7) && rig.irq(70));
    assert_eq!(rig.read(SR) & 0xC0, 0xC0);
    let sent: Vec<u8> = rig.chip.serial_take(1).map(|byte| byte.byte).collect();
    assert_eq!(sent, b"time-optimal");
    rig.assert_no_bugs();
}

#[test]
fn a_stream_of_another_peripheral_gets_nothing() {
    let mut rig = port();
    rig.set(CR3, 1 << 7 | 1 << 6);
    // USART6 sends on stream 7 channel 5; USART1 on channel 4.
    rig.stream(DMA2, 7, 5 << 25 | 1 << 10 | 1 << 6, 12, DR, RING);
    rig.start_stream(DMA2, 7);
    rig.pass(100 * US);
    assert_eq!(rig.stream_left(DMA2, 7), 12);
    assert_eq!(rig.chip.serial_take(1).count(), 0);
}

#[test]
fn bytes_do_not_arrive_while_the_pin_leads_elsewhere() {
    let mut rig = port();
    rig.mode(GPIOA, 10, 0);
    let now = rig.ns();
    rig.chip.serial_send(1, now, b"a");
    rig.pass(50 * US);
    assert_eq!(rig.read(SR) & 0x20, 0);
}

#[test]
fn memory_is_copied_by_dma2_only() {
    let mut rig = bare();
    rig.start_clocks();
    rig.put(RING, b"abcdefgh");
    // Memory to memory, both sides increment, words out.
    rig.stream(DMA2, 0, 2 << 6 | 1 << 10 | 1 << 9 | 2 << 13, 8, RING, RING + 0x100);
    rig.start_stream(DMA2, 0);
    rig.pass(US);
    assert_eq!(rig.get(RING + 0x100, 8), b"abcdefgh");
    assert!(!rig.stream_on(DMA2, 0));
    rig.assert_no_bugs();
    rig.stream(DMA1, 0, 2 << 6 | 1 << 10 | 1 << 9, 8, RING, RING + 0x100);
    rig.start_stream(DMA1, 0);
    assert_eq!(rig.stream_flags(DMA1, 0), 8);
    assert!(rig.has_bug("DMA1 cannot copy"));
}

/// RM0090 section 30.6.1: by reading SR and then writing DR, or by writing zero.
#[test]
fn the_end_of_a_transmission_is_forgotten_by_its_sequence_only() {
    let mut rig = port();
    rig.write(DR, 1);
    rig.pass(20 * US);
    assert_eq!(rig.read(SR) & 0x40, 0x40);
    rig.write(DR, 2);
    assert_eq!(rig.read(SR) & 0x40, 0, "read, then written");
    rig.pass(20 * US);
    rig.write(DR, 3);
    assert_eq!(rig.read(SR) & 0x40, 0x40, "written without reading");
    rig.write(SR, !0x40);
    assert_eq!(rig.read(SR) & 0x40, 0, "zero written");
}

#[test]
fn modes_that_are_not_emulated_are_told() {
    for (register, bits, what) in [
        (CR1, UE | 2, "RWU"),
        (CR1 + 4, 1 << 14, "LINEN"),
        (CR1 + 4, 1 << 11, "CLKEN"),
        (CR3, 2, "IREN"),
        (CR3, 8, "HDSEL"),
        (CR3, 0x20, "SCEN"),
        (CR3, 0x200, "CTSE"),
    ] {
        let mut rig = port();
        rig.write(register, bits);
        assert!(rig.has_bug(what) && rig.has_bug("USART1"), "{what}: {:?}", rig.bugs());
    }
}
