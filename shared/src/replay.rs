//! Replay: from the time to the commanded pitch rate and thrust, tick by tick.
//!
//! A flight controller updates its motors at 800 Hz, while switches fall anywhere between ticks. Sampling the plan at
//! the ticks would end a maneuver 20 cm off. So each tick commands the *integral* of the plan up to the next expected
//! tick, less what has been commanded already, divided by the time until then: the exact average over the tick. What
//! was commanded follows from the clock, never from counting ticks, so a late, early or missed tick leaves a debt that
//! the next command pays. The last command covers \[t_n, T\] only.
//!
//! Deadline and cost: one [`Replay::tick`] visits the segments that the tick touches, at most all
//! [`MAX_SEGMENTS`] of them; no allocation, no unbounded loop, finite output for every input.

use crate::messages::Setpoint;
use crate::model::{Limits, Segment, State};
use crate::motion::{self, Turn};
use crate::plane::Plane;
use crate::real::{at_least, at_most};
use crate::table::{self, ArcProfile, MAX_SEGMENTS, ManeuverTable};
use heapless::Vec;

/// Nominal tick period, µs: 800 Hz.
pub const TICK_PERIOD_US: u32 = 1250;

/// A command may exceed the plan's rate limit by this factor to pay a debt. A missed tick between opposite bangs owes
/// two ticks' worth of the limit on top of the plan's own: three times the limit repays it within one tick.
const RATE_HEADROOM: f32 = 3.0;
/// Likewise for the thrust; a missed tick before a switch from the lowest to the highest thrust owes less than one.
const THRUST_HEADROOM: f32 = 2.0;
/// Debts are repaid over no less than this part of a tick, so that a sliver of time before T asks for no absurd rate.
const SHORTEST_REPAYMENT_S: f32 = 50.0e-6;

/// What the vehicle is to do until the next tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Rate of turn in the maneuver's plane, rad/s: positive tips the thrust towards the plane's heading. Straight ahead
    /// that is nose-down (+ω_y). [`Plane::turn`] makes body rates of it.
    pub rate_radps: f32,
    /// Collective thrust per mass, m/s².
    pub thrust_mps2: f32,
}

/// A table's segments on the time axis.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Each segment with the time at which it ends, s from the start.
    segments: Vec<(f32, Segment<f32>), MAX_SEGMENTS>,
    arcs: Option<ArcProfile>,
    limits: Limits<f32>,
    start: State<f32>,
    plane: Plane,
}

impl Plan {
    /// Lays a checked table out in time.
    pub fn new(table: &ManeuverTable) -> Self {
        let mut segments = Vec::new();
        let mut end_s = 0.0;
        for segment in table.segments() {
            end_s += segment.duration;
            // Both hold at most MAX_SEGMENTS, so there is always room.
            let _ = segments.push((end_s, segment));
        }
        let plane = Plane::new(table.heading_rad);
        Self { segments, arcs: table.arcs, limits: table.limits, start: table.start, plane }
    }

    /// The vertical plane it lies in.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// Duration T, s.
    pub fn duration_s(&self) -> f32 {
        self.segments.last().map_or(0.0, |(end_s, _)| *end_s)
    }

    /// The parts of segments that lie in \[from, to\]: inputs, begin and length of each part.
    fn parts(&self, from_s: f32, to_s: f32) -> impl Iterator<Item = (&Segment<f32>, f32, f32)> {
        let mut segment_begin = 0.0_f32;
        self.segments.iter().filter_map(move |(end, segment)| {
            let begin = core::mem::replace(&mut segment_begin, *end);
            // Most segments are over or still to come: two comparisons each.
            if *end <= from_s || begin >= to_s {
                return None;
            }
            let begin = at_least(begin, from_s);
            let length = at_most(*end, to_s) - begin;
            (length > 0.0).then_some((segment, begin, length))
        })
    }

    fn turn(&self, segment: &Segment<f32>, begin_s: f32, length_s: f32) -> Turn<f32> {
        table::turn(segment.inputs.rate, self.limits.rate_max_radps, self.arcs, begin_s, length_s)
    }

    fn thrust(&self, segment: &Segment<f32>) -> f32 {
        self.limits.thrust(segment.inputs.thrust)
    }

    /// Planned change of pitch (rad) and impulse per mass (m/s) between two times, s from the start.
    pub fn integrals(&self, from_s: f32, to_s: f32) -> (f32, f32) {
        self.parts(from_s, to_s).fold((0.0, 0.0), |(angle, impulse), (segment, begin, length)| {
            let turned = match (segment.inputs.rate.sign::<f32>(), self.arcs) {
                (None, Some(profile)) => profile.entered_at(begin).angle_at(length),
                (sign, _) => sign.unwrap_or(0.0) * self.limits.rate_max_radps * length,
            };
            (angle + turned, impulse + self.thrust(segment) * length)
        })
    }

    /// Planned state at a time, s from the start, by the exact motion.
    pub fn state_at(&self, time_s: f32) -> State<f32> {
        self.parts(0.0, time_s).fold(self.start, |state, (segment, begin, length)| {
            let turn = self.turn(segment, begin, length);
            motion::advance(state, self.thrust(segment), self.limits.gravity_mps2, length, &turn)
        })
    }
}

/// Estimates the true tick period from the clock: gyros run up to a few per cent fast or slow.
#[derive(Clone, Copy, Debug)]
pub struct TickPeriod {
    estimate_us: f32,
}

impl TickPeriod {
    /// Share of a new interval in the estimate.
    const GAIN: f32 = 1.0 / 16.0;
    /// Intervals further than this from nominal are late or missed ticks, not the gyro's clock.
    const PLAUSIBLE: f32 = 0.06;

    /// Starts at the nominal period.
    pub const fn new() -> Self {
        Self { estimate_us: TICK_PERIOD_US as f32 }
    }

    /// Takes the interval between two ticks into account.
    pub fn observe(&mut self, interval_us: u64) {
        let nominal = TICK_PERIOD_US as f32;
        // In 32 bits: the processor converts those by itself.
        let interval = interval_us.min(u64::from(TICK_PERIOD_US) * 16) as u32 as f32;
        if (interval - nominal).abs() <= Self::PLAUSIBLE * nominal {
            self.estimate_us += Self::GAIN * (interval - self.estimate_us);
        }
    }

    /// The period, s.
    pub fn period_s(&self) -> f32 {
        self.estimate_us * 1.0e-6
    }
}

impl Default for TickPeriod {
    fn default() -> Self {
        Self::new()
    }
}

/// A maneuver being flown.
#[derive(Clone, Debug)]
pub struct Replay {
    plan: Plan,
    start_us: u64,
    /// Until when the plan has been accounted for, s from the start.
    settled_s: f32,
    last: Command,
    /// Planned less commanded up to `settled_s`: rad and m/s.
    owed_angle_rad: f32,
    owed_impulse_mps: f32,
}

/// What a tick of the replay says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Fly this until the next tick.
    Fly(Command),
    /// T has passed.
    Over,
}

impl Replay {
    /// Starts a maneuver: time zero is `start_us` on the vehicle's clock.
    pub fn new(plan: Plan, start_us: u64) -> Self {
        Self {
            plan,
            start_us,
            settled_s: 0.0,
            last: Command::default(),
            owed_angle_rad: 0.0,
            owed_impulse_mps: 0.0,
        }
    }

    /// The same maneuver from its beginning, at `start_us`.
    pub fn restart(&mut self, start_us: u64) {
        self.start_us = start_us;
        self.settled_s = 0.0;
        self.last = Command::default();
        self.owed_angle_rad = 0.0;
        self.owed_impulse_mps = 0.0;
    }

    /// The plan being flown.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Time since the start, s. Zero before it.
    pub fn elapsed_s(&self, now_us: u64) -> f32 {
        // A maneuver lasts at most 10 s: microseconds fit f32 to better than 1 µs, and the cap keeps a wild clock finite.
        now_us.saturating_sub(self.start_us).min(100_000_000) as u32 as f32 * 1.0e-6
    }

    /// The command from now until the next tick, expected one `period` later.
    pub fn tick(&mut self, now_us: u64, period: &TickPeriod) -> Step {
        let now_s = self.elapsed_s(now_us);
        let duration_s = self.plan.duration_s();
        // A clock that ran backwards ends it too: nothing is known any more.
        if now_s >= duration_s || now_s < self.settled_s {
            return Step::Over;
        }
        self.settle(now_s);
        let next_s = at_most(now_s + period.period_s(), duration_s);
        let span_s = next_s - now_s;
        let (angle, impulse) = self.plan.integrals(now_s, next_s);
        let repayment_s = at_least(span_s, SHORTEST_REPAYMENT_S);
        // span_s is above zero: now_s is below T, and a period is far above the resolution of f32 there; a span that
        // rounds to nothing would give the default command.
        let average = |integral: f32, owed: f32| {
            if span_s > 0.0 { integral / span_s + owed / repayment_s } else { 0.0 }
        };
        let Limits { rate_max_radps, thrust_max_mps2, .. } = self.plan.limits;
        // Nor beyond what any setpoint may ask for: a debt that is larger is paid over some ticks.
        let rate_bound =
            at_most(RATE_HEADROOM * rate_max_radps, at_least(Setpoint::RATE_MAX_RADPS, rate_max_radps));
        let thrust_bound =
            at_most(THRUST_HEADROOM * thrust_max_mps2, at_least(Setpoint::THRUST_MAX_MPS2, thrust_max_mps2));
        self.last = Command {
            rate_radps: at_most(at_least(average(angle, self.owed_angle_rad), -rate_bound), rate_bound),
            thrust_mps2: at_most(at_least(average(impulse, self.owed_impulse_mps), 0.0), thrust_bound),
        };
        Step::Fly(self.last)
    }

    /// Brings the account up to `now_s`: what the plan asked since the last tick, less what the last command gave.
    fn settle(&mut self, now_s: f32) {
        let held_s = now_s - self.settled_s;
        if held_s <= 0.0 {
            return;
        }
        let (angle, impulse) = self.plan.integrals(self.settled_s, now_s);
        self.owed_angle_rad += angle - self.last.rate_radps * held_s;
        self.owed_impulse_mps += impulse - self.last.thrust_mps2 * held_s;
        self.settled_s = now_s;
    }
}
