//! Noise on the gyro's data-ready line, on the very image that gets flashed.

mod bench;

use bench::{Board, image};
use emulator::boards::SpeedyBeeF405V3;
use emulator::chip::{Chip, Pin};
use emulator::core::Timing;
use emulator::{Machine, Stop};

const READY: Pin = Pin::new('C', 4);
const PERIOD_NS: u64 = 1_250_000;
/// Length of the sensor's pulse, ns.
const PULSE_NS: u64 = 156_250;
/// Until the gyro is set up its edges are nobody's business, periods.
const SETTLED: u64 = 200;

/// A board alone, whose gyro samples on time.
struct Line {
    board: Board,
    watch: u32,
    ns: u64,
}

impl Line {
    fn new(timing: Timing) -> Self {
        let mut board: Board = Machine::new(Chip::new(SpeedyBeeF405V3::new()), timing, 1);
        board.semihosting = false;
        board.load_elf(image().elf()).expect("an image");
        let watch = emulator::machine::symbol_address(image().elf(), "MINTIME_WATCH").expect("a symbol");
        let mut line = Self { board, watch, ns: 0 };
        for _ in 0..SETTLED {
            line.period(None);
        }
        line
    }

    fn run_to(&mut self, ns: u64) {
        let limit = self.board.peripherals.clock().cycle(ns);
        // The firmware may change its clocks on the way.
        while self.board.time() < limit && self.board.peripherals.clock().ns(self.board.time()) < ns {
            assert_eq!(self.board.run_until(limit), Stop::ReachedTime);
        }
    }

    /// One period that begins with a true edge, with another one so long after it.
    fn period(&mut self, noise_ns: Option<u64>) {
        self.ns += PERIOD_NS;
        let edge_ns = self.ns;
        self.board.peripherals.imu_sample(&mut self.board.memory, edge_ns, [0.0; 3], [0.0, 0.0, 9.81]);
        if let Some(noise_ns) = noise_ns {
            self.run_to(edge_ns + noise_ns);
            self.board.peripherals.with_board(&mut self.board.memory, |_, effects| {
                effects.levels.extend([(READY, Some(false)), (READY, Some(true))]);
            });
            if noise_ns > PULSE_NS {
                // The sensor's own pulse was over.
                self.run_to(edge_ns + noise_ns + 500);
                let memory = &mut self.board.memory;
                self.board
                    .peripherals
                    .with_board(memory, |_, effects| effects.levels.push((READY, Some(false))));
            }
        }
        // Short of the next edge.
        self.run_to(edge_ns + PERIOD_NS - 100_000);
    }

    /// Frames that the first motor got.
    fn frames(&self) -> u64 {
        self.board.peripherals.board().escs[0].frames
    }

    /// Ticks so far, and the time of the latest, µs.
    fn ticks(&self) -> (u32, u64) {
        let word = |at: u32| {
            let bytes = self.board.memory.peek(self.watch + at, 4).expect("RAM");
            u32::from_le_bytes(bytes.try_into().expect("four"))
        };
        (word(0), u64::from(word(4)) | u64::from(word(8)) << 32)
    }
}

/// The edge's handler interrupts whatever asks for its stamp: wherever the noise meets it, a period is one tick, and its
/// time is the edge's.
#[test]
fn noise_right_after_an_edge_starts_no_tick_of_its_own() {
    for timing in [Timing::Optimistic, Timing::Pessimistic] {
        let mut line = Line::new(timing);
        for noise_ns in (20..2_000).step_by(4) {
            let (ticks, time_us) = line.ticks();
            line.period(Some(noise_ns));
            let (ticks_then, time_then_us) = line.ticks();
            assert_eq!(ticks_then, ticks + 1, "{timing:?}: noise {noise_ns} ns after the edge");
            let passed_us = time_then_us.saturating_sub(time_us);
            assert!(
                passed_us.abs_diff(PERIOD_NS / 1000) <= 4,
                "{timing:?}: noise {noise_ns} ns after the edge: the clock went from {time_us} to {time_then_us} µs"
            );
        }
        assert_eq!(line.board.memory.bugs, []);
    }
}

/// Anywhere else in the first four fifths of the period it is no tick either.
#[test]
fn noise_between_two_edges_is_no_tick() {
    let mut line = Line::new(Timing::Pessimistic);
    for noise_us in [5, 30, 63, 90, 160, 400, 626, 700, 900, 1000] {
        let (ticks, time_us) = line.ticks();
        line.period(Some(noise_us * 1000));
        line.period(None);
        let (ticks_then, time_then_us) = line.ticks();
        assert_eq!(ticks_then, ticks + 2, "noise {noise_us} µs after the edge");
        assert!(
            (time_then_us - time_us).abs_diff(2 * PERIOD_NS / 1000) <= 4,
            "noise {noise_us} µs after the edge"
        );
    }
}

/// However fast the line rings, a tick comes no sooner than an edge of the gyro's might, and each has its motor frames; when it
/// is over there is a tick a period again.
#[test]
fn a_line_that_rings_starts_a_tick_when_an_edge_may_come() {
    const PERIODS: u32 = 80;
    let mut line = Line::new(Timing::Pessimistic);
    for ringing_ns in [10_000, 5_000, 2_000, 1_000, 700] {
        let (ticks, _) = line.ticks();
        let frames = line.frames();
        let (from_ns, memory) = (line.ns + PERIOD_NS / 2, &mut line.board.memory);
        line.board.peripherals.ring_data_ready(memory, from_ns, Some(ringing_ns));
        for _ in 0..PERIODS {
            line.period(None);
        }
        line.board.peripherals.ring_data_ready(&mut line.board.memory, from_ns, None);
        let ringing_ticks = line.ticks().0 - ticks;
        println!("{ringing_ns} ns: {ringing_ticks} ticks in {PERIODS} periods");
        // 85 % of a period that is taken for 5 % shorter than it is.
        assert!((PERIODS..=PERIODS * 100 / 80).contains(&ringing_ticks), "{ringing_ns} ns: {ringing_ticks}");
        assert!(line.frames().abs_diff(frames + u64::from(ringing_ticks)) <= 1, "{ringing_ns} ns");
        // The period is learned again.
        for _ in 0..20 {
            line.period(None);
        }
        let (ticks, _) = line.ticks();
        for _ in 0..PERIODS {
            line.period(None);
        }
        assert_eq!(line.ticks().0 - ticks, PERIODS, "{ringing_ns} ns");
        assert_eq!(line.board.memory.bugs, []);
    }
}
