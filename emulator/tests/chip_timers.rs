//! Timers: the time driver on TIM5 and the motor burst on TIM4.

mod rig;

use emulator::boards::SpeedyBeeF405V3;
use emulator::bus::Peripherals;
use rig::*;

const CR1: u32 = 0x00;
const DIER: u32 = 0x0C;
const SR: u32 = 0x10;
const EGR: u32 = 0x14;
const CNT: u32 = 0x24;
const ARR: u32 = 0x2C;
const CCR1: u32 = 0x34;
const CCR2: u32 = 0x38;
const TIM5_IRQ: u32 = 50;

/// TIM5 as the time driver sets it up: a microsecond a count, 16 bits, half period in channel 1, alarm in channel 2.
fn time_driver() -> Rig<emulator::chip::BareBoard> {
    let mut rig = bare();
    rig.start_clocks();
    rig.write_half(TIM5 + 0x28, 83);
    rig.write(TIM5 + ARR, 0xFFFF);
    rig.write(TIM5 + CR1, 4);
    rig.write(TIM5 + EGR, 1);
    rig.write(TIM5 + CR1, 0);
    assert_eq!(rig.read(TIM5 + SR) & 1, 0, "an update by software sets no flag while URS is on");
    rig.write(TIM5 + CCR1, 0x8000);
    rig.write(TIM5 + DIER, 3);
    rig.write(TIM5 + CR1, 1);
    rig
}

#[test]
fn the_count_moves_between_two_reads() {
    let mut rig = time_driver();
    let start = rig.ns();
    rig.pass(10 * MS);
    let count = u64::from(rig.read(TIM5 + CNT));
    let elapsed = (rig.ns() - start) / 1000;
    assert!(elapsed - count <= 1, "{elapsed} {count}");
    let first = rig.read(TIM5 + CNT);
    rig.pass(3 * US);
    assert_eq!(rig.read(TIM5 + CNT) - first, 3);
}

#[test]
fn half_period_and_overflow_interrupt_on_time_and_clear_by_zero() {
    let mut rig = time_driver();
    let start = rig.ns();
    let due = rig.chip.clock().ns(rig.chip.next_event());
    assert!((32_767..=32_769).contains(&((due - start) / 1000)), "{}", due - start);
    rig.pass(due - start - US);
    assert!(!rig.irq(TIM5_IRQ));
    rig.pass(2 * US);
    assert!(rig.irq(TIM5_IRQ));
    // Channels without a value matched at count zero; the half period is channel 1.
    let flags = rig.read(TIM5 + SR);
    assert_eq!(flags & 3, 2);
    rig.write(TIM5 + SR, !flags);
    assert!(!rig.irq(TIM5_IRQ));
    assert_eq!(rig.read(TIM5 + SR), 0);
    rig.pass(32_770 * US);
    assert_eq!(rig.read(TIM5 + SR) & 3, 1);
    // Writing ones changes nothing.
    rig.write(TIM5 + SR, 0xFFFF_FFFF);
    assert!(rig.irq(TIM5_IRQ));
    rig.write(TIM5 + SR, !1);
    assert!(!rig.irq(TIM5_IRQ));
}

#[test]
fn an_alarm_flag_rises_even_with_its_interrupt_off() {
    let mut rig = time_driver();
    rig.write(TIM5 + SR, 0);
    rig.write(TIM5 + CCR2, 1000);
    rig.pass(999 * US - 10);
    let count = rig.read(TIM5 + CNT);
    assert!(count < 1000, "{count}");
    assert_eq!(rig.read(TIM5 + SR) & 4, 0);
    rig.pass(3 * US);
    assert_eq!(rig.read(TIM5 + SR) & 4, 4);
    assert!(!rig.irq(TIM5_IRQ));
    rig.set(TIM5 + DIER, 4);
    assert!(rig.irq(TIM5_IRQ));
    rig.write(TIM5 + SR, !4);
    rig.write(TIM5 + CCR2, 5000);
    assert!(!rig.irq(TIM5_IRQ));
    let at = rig.chip.clock().ns(rig.chip.next_event());
    rig.pass(at - rig.ns());
    assert!(rig.irq(TIM5_IRQ));
    assert_eq!(rig.read(TIM5 + CNT), 5000);
}

#[test]
fn the_limit_and_compare_values_wait_for_the_update_where_preloaded() {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(TIM2 + 0x28, 83);
    rig.write(TIM2 + ARR, 99);
    rig.write(TIM2 + EGR, 1);
    rig.write(TIM2 + CR1, 1 << 7 | 1);
    rig.write(TIM2 + SR, 0);
    rig.pass(50 * US);
    rig.write(TIM2 + ARR, 199);
    rig.pass(55 * US);
    assert_eq!(rig.read(TIM2 + SR) & 1, 1, "the old limit ended this period");
    rig.write(TIM2 + SR, 0);
    rig.pass(150 * US);
    assert_eq!(rig.read(TIM2 + SR) & 1, 0, "the new limit is longer");
    // One pulse.
    rig.write(TIM2 + CR1, 1 << 3 | 1);
    rig.pass(300 * US);
    assert_eq!((rig.read(TIM2 + CR1) & 1, rig.read(TIM2 + CNT)), (0, 0));
    // A free-running timer that nobody watches makes no events.
    rig.write(TIM2 + CR1, 1);
    assert_eq!(rig.chip.next_event(), emulator::bus::NEVER);
    rig.pass(1000 * MS);
    assert_eq!(rig.read(TIM2 + SR) & 1, 1);
    rig.assert_no_bugs();
}

const BUFFER: u32 = 0x2000_1000;
/// Sixteen bits and two slots of silence, for four motors.
const SLOTS: usize = 18;

/// TIM4 on PB6..PB9 with a burst of four compare values per update from DMA1 stream 6.
fn motors(counts: u32) -> Rig<SpeedyBeeF405V3> {
    let mut rig = speedybee();
    rig.start_clocks();
    for pin in 6..10 {
        rig.alternate(GPIOB, pin, 2);
    }
    rig.write(TIM4 + CR1, 1 << 7);
    rig.write(TIM4 + ARR, counts - 1);
    // PWM mode 1 with preload on all channels.
    rig.write(TIM4 + 0x18, 0x6868);
    rig.write(TIM4 + 0x1C, 0x6868);
    rig.write(TIM4 + 0x20, 0x1111);
    // Four values from CCR1 on.
    rig.write(TIM4 + 0x48, 3 << 8 | 13);
    rig.write(TIM4 + EGR, 1);
    rig
}

fn frame(value: u16) -> u16 {
    let payload = value << 1;
    payload << 4 | (payload ^ payload >> 4 ^ payload >> 8) & 15
}

/// Puts a frame for each motor into memory.
fn fill(rig: &mut Rig<SpeedyBeeF405V3>, values: [u16; 4], counts: u32) {
    for slot in 0..SLOTS {
        for (motor, value) in values.into_iter().enumerate() {
            let high = match slot {
                16.. => 0,
                _ if frame(value) >> (15 - slot) & 1 == 1 => counts * 3 / 4,
                _ => counts * 3 / 8,
            };
            rig.put(BUFFER + 8 * slot as u32 + 2 * motor as u32, &(high as u16).to_le_bytes());
        }
    }
}

/// Sends what lies in memory.
fn send(rig: &mut Rig<SpeedyBeeF405V3>, stream: u32, channel: u32) {
    // Halves, memory increments, memory to peripheral.
    let cr = channel << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6;
    rig.stream(DMA1, stream, cr, 4 * SLOTS as u32, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, stream);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(60 * US);
}

#[test]
fn a_burst_makes_frames_at_exactly_600_kbit_and_leaves_the_line_low() {
    let mut rig = motors(140);
    fill(&mut rig, [0, 48, 1047, 2047], 140);
    send(&mut rig, 6, 2);
    assert!(!rig.stream_on(DMA1, 6));
    assert_eq!(rig.stream_flags(DMA1, 6), 0x30);
    let board = rig.chip.board_mut();
    for (n, value) in [0, 48, 1047, 2047].into_iter().enumerate() {
        let esc = &board.escs[n];
        assert_eq!((esc.frames, esc.bad_frames, esc.value()), (1, 0, value));
        assert!((esc.rate - 600_000.0).abs() < 1.0, "{}", esc.rate);
    }
    assert_eq!(board.drain_motor_updates().count(), 4);
    for channel in 0..4 {
        assert_eq!(rig.read(TIM4 + CCR1 + 4 * channel), 0);
    }
    // The next frame, after silence.
    rig.write(TIM4 + DIER, 0);
    rig.write(TIM4 + CR1, 1 << 7);
    fill(&mut rig, [100; 4], 140);
    send(&mut rig, 6, 2);
    assert!(rig.chip.board().escs.iter().all(|esc| esc.frames == 2 && esc.value() == 100));
    rig.assert_no_bugs();
}

#[test]
fn a_limit_one_too_large_is_told_as_a_wrong_rate() {
    let mut rig = motors(141);
    fill(&mut rig, [0; 4], 141);
    send(&mut rig, 6, 2);
    assert!(rig.has_bug("motor 1: DShot bits come at 595.7 kbit/s"), "{:?}", rig.bugs());
    // PX4's slip: 21 counts of 12 MHz.
    let mut rig = motors(147);
    fill(&mut rig, [0; 4], 147);
    send(&mut rig, 6, 2);
    assert!(rig.has_bug("571.4 kbit/s"), "{:?}", rig.bugs());
}

#[test]
fn a_frame_without_trailing_silence_is_told() {
    let mut rig = motors(140);
    fill(&mut rig, [100; 4], 140);
    let cr = 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6;
    rig.stream(DMA1, 6, cr, 4 * 16, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(60 * US);
    assert!(rig.has_bug("goes on after its sixteenth bit"), "{:?}", rig.bugs());
}

#[test]
fn the_wrong_stream_or_channel_gets_nothing() {
    for (stream, channel) in [(5, 2), (6, 3), (6, 1)] {
        let mut rig = motors(140);
        fill(&mut rig, [0; 4], 140);
        send(&mut rig, stream, channel);
        assert_eq!(rig.stream_left(DMA1, stream), 4 * SLOTS as u32, "{stream} {channel}");
        assert_eq!(rig.chip.board().escs[0].frames, 0);
    }
}

#[test]
fn a_request_latched_while_the_stream_is_off_is_served_at_once() {
    let mut rig = motors(140);
    fill(&mut rig, [7; 4], 140);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(10 * US);
    // Stopped: no further update can come, and four requests of one burst wait.
    rig.write(TIM4 + CR1, 1 << 7);
    rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    assert_eq!(rig.stream_left(DMA1, 6), 68);
    assert_eq!(rig.read(TIM4 + CCR1), 140 * 3 / 8);
    // Switching a stream off by hand completes it.
    rig.clear(DMA1 + 0x10 + 0x18 * 6, 1);
    assert_eq!(rig.stream_flags(DMA1, 6) & 0x20, 0x20);
    // Without its enable bit the request goes.
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(10 * US);
    rig.write(TIM4 + CR1, 1 << 7);
    rig.write(TIM4 + DIER, 0);
    rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    assert_eq!(rig.stream_left(DMA1, 6), 72);
    // Unless the chip keeps it.
    rig.chip.set_sticky_timer_requests(true);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.stream(DMA1, 6, 0, 0, TIM4 + 0x4C, BUFFER);
    rig.pass(10 * US);
    rig.write(TIM4 + CR1, 1 << 7);
    rig.write(TIM4 + DIER, 0);
    rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    assert_eq!(rig.stream_left(DMA1, 6), 72);
    rig.write(TIM4 + DIER, 1 << 8);
    assert_eq!(rig.stream_left(DMA1, 6), 68);
}

#[test]
fn a_pin_of_the_same_port_may_change_in_the_middle_of_a_frame() {
    let mut rig = motors(140);
    fill(&mut rig, [1047; 4], 140);
    rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(10 * US);
    rig.mode(GPIOB, 0, 1);
    rig.mode(GPIOB, 9, 1);
    rig.pass(50 * US);
    let escs = &rig.chip.board().escs;
    assert_eq!([escs[0].frames, escs[1].frames, escs[2].frames, escs[3].frames], [1, 1, 1, 0]);
    rig.assert_no_bugs();
}

#[test]
fn timers_that_share_an_interrupt_hold_it_together() {
    const TIM10: u32 = 0x4001_4400;
    const TIM1: u32 = 0x4001_0000;
    let mut rig = bare();
    rig.start_clocks();
    for timer in [TIM1, TIM10] {
        rig.write(timer + DIER, 1);
        rig.write(timer + EGR, 1);
    }
    assert!(rig.irq(25));
    rig.write(TIM1 + SR, 0);
    assert!(rig.irq(25));
    rig.write(TIM10 + SR, 0);
    assert!(!rig.irq(25));
}

#[test]
fn a_burst_from_core_coupled_memory_fails_and_is_told() {
    let mut rig = motors(140);
    rig.write(TIM4 + DIER, 1 << 8);
    let cr = 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6 | 1 << 2;
    rig.stream(DMA1, 6, cr, 72, TIM4 + 0x4C, 0x1000_0000);
    rig.start_stream(DMA1, 6);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(10 * US);
    assert_eq!(rig.stream_flags(DMA1, 6) & 8, 8);
    assert!(!rig.stream_on(DMA1, 6));
    assert!(rig.irq(17));
    assert!(rig.has_bug("DMA1 stream 6 is pointed at core-coupled memory"), "{:?}", rig.bugs());
}

#[test]
fn motors_arm_after_zeros_and_stop_when_the_pins_are_forced_low() {
    let mut rig = motors(140);
    for tick in 0..300 {
        fill(&mut rig, if tick < 260 { [0; 4] } else { [1047; 4] }, 140);
        let start = rig.ns();
        send(&mut rig, 6, 2);
        rig.write(TIM4 + DIER, 0);
        rig.write(TIM4 + CR1, 1 << 7);
        rig.pass(1_250_000 - (rig.ns() - start));
    }
    let motors = rig.chip.motors(rig.ns());
    assert!(motors.iter().all(|motor| motor.armed && motor.throttle == Some(0.5)), "{motors:?}");
    // Force the pins low in the middle of a frame.
    rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
    rig.start_stream(DMA1, 6);
    rig.write(TIM4 + DIER, 1 << 8);
    rig.write(TIM4 + CR1, 1 << 7 | 1);
    rig.pass(10 * US);
    for pin in 6..10 {
        rig.mode(GPIOB, pin, 1);
    }
    rig.pass(98 * MS);
    assert!(rig.chip.motors(rig.ns())[0].armed);
    rig.pass(3 * MS);
    assert!(rig.chip.motors(rig.ns()).iter().all(|motor| !motor.armed && motor.throttle.is_none()));
}

/// A flag of an update that stands when requests are enabled may make one at once.
#[test]
fn a_standing_update_flag_may_ask_at_once() {
    for (standing, cleared, left) in [(false, false, 72), (true, false, 68), (true, true, 72)] {
        let mut rig = motors(140);
        rig.chip.set_standing_timer_requests(standing);
        fill(&mut rig, [0; 4], 140);
        rig.stream(DMA1, 6, 2 << 25 | 1 << 13 | 1 << 11 | 1 << 10 | 1 << 6, 72, TIM4 + 0x4C, BUFFER);
        rig.start_stream(DMA1, 6);
        rig.write(TIM4 + EGR, 1);
        if cleared {
            rig.write(TIM4 + SR, 0);
        }
        rig.write(TIM4 + DIER, 1 << 8);
        assert_eq!(rig.stream_left(DMA1, 6), left);
    }
}

#[test]
fn a_break_input_is_told() {
    let mut rig = bare();
    rig.start_clocks();
    rig.write(0x4001_0044, 1 << 12);
    assert!(rig.has_bug("TIM1 lets a break input"), "{:?}", rig.bugs());
}
