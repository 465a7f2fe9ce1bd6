//! Who decides whether the motors turn: conditions, one table of transitions, and the state that follows.
//!
//! Every tick the flight logic gathers [`Conditions`] and the first row of [`TRANSITIONS`] that applies is taken. The
//! rows stand in the order of severity, so that of several faults at once the gravest is acted on and reported, and
//! no row below can undo one above. Whatever no row covers stays as it is; power-up, reset and panic lead to `Boot`, and
//! from there no way leads past `Disarmed`. `Terminated` is final: no row leads from it to a state in which a motor turns,
//! and the only one that leaves it is a person's acknowledgement.

use bitflags::bitflags;
use mintime_shared::messages::{AbortReason, FlightState};

bitflags! {
    /// What is true this tick.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Conditions: u32 {
        /// The kill switch says stop.
        const KILL = 1 << 0;
        /// The kill switch's radio is silent.
        const KILL_LOST = 1 << 1;
        /// The host asked for an emergency stop.
        const EMERGENCY_STOP = 1 << 2;
        /// The host asked to disarm.
        const DISARM = 1 << 3;
        /// The host acknowledged the incident that waits.
        const ACKNOWLEDGE = 1 << 4;
        /// The clock ran backwards.
        const CLOCK = 1 << 5;
        /// Gyro samples stay away.
        const GYRO_MISSING = 1 << 6;
        /// The gyro repeats itself.
        const GYRO_FROZEN = 1 << 7;
        /// The gyro is at the end of its range.
        const GYRO_SATURATED = 1 << 8;
        /// The vehicle does not follow its controls.
        const RUNAWAY = 1 << 9;
        /// Nothing was heard of the host for too long.
        const HOST_SILENT = 1 << 10;
        /// The maneuver is one to be given up when the link is lost.
        const ABANDON = 1 << 11;
        /// Ticks come too late.
        const LATE_TICKS = 1 << 12;
        /// Too many samples of this maneuver were lost.
        const LOST_SAMPLES = 1 << 13;
        /// The maneuver left its envelope.
        const OFF_PLAN = 1 << 14;
        /// The rotors have been at their limit for too long.
        const SATURATED = 1 << 15;
        /// The battery fell below its critical voltage.
        const BATTERY_SAG = 1 << 16;
        /// The last setpoint is fresh.
        const FRESH = 1 << 17;
        /// The last setpoint asks for thrust.
        const LIFTS = 1 << 18;
        /// The maneuver's duration has passed.
        const OVER = 1 << 19;
        /// The host triggered a maneuver that may be flown.
        const TRIGGER = 1 << 20;
        /// The host asked to arm and nothing blocks it.
        const ARM = 1 << 21;
        /// Armed and idle for too long.
        const IDLE_TOO_LONG = 1 << 22;
        /// Drivers are at work on their set-up.
        const STARTING = 1 << 23;
        /// The gyro's bias is known and no calibration is under way.
        const CALIBRATED = 1 << 24;
        /// The recovering vehicle stands on something.
        const TOUCHED_DOWN = 1 << 25;
        /// The recovery has lasted long enough.
        const RECOVERY_OVER = 1 << 26;
    }

    /// Sets of flight states.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct States: u16 {
        /// Starting.
        const BOOT = 1 << 0;
        /// Learning the gyro's bias or scale.
        const CALIBRATING = 1 << 1;
        /// Motors off.
        const DISARMED = 1 << 2;
        /// Motors idle.
        const ARMED = 1 << 3;
        /// Following setpoints.
        const TRACKING = 1 << 4;
        /// Replaying.
        const MANEUVER = 1 << 5;
        /// Levelling and sinking.
        const RECOVERY = 1 << 6;
        /// Down after a recovery.
        const LANDED = 1 << 7;
        /// Stopped for good.
        const TERMINATED = 1 << 8;
        /// Motors turning at any speed.
        const MOTORS_ON =
            Self::ARMED.bits() | Self::TRACKING.bits() | Self::MANEUVER.bits() | Self::RECOVERY.bits();
    }
}

impl From<FlightState> for States {
    fn from(state: FlightState) -> Self {
        match state {
            FlightState::Boot => Self::BOOT,
            FlightState::Calibrating => Self::CALIBRATING,
            FlightState::Disarmed => Self::DISARMED,
            FlightState::Armed => Self::ARMED,
            FlightState::Tracking => Self::TRACKING,
            FlightState::Maneuver => Self::MANEUVER,
            FlightState::Recovery => Self::RECOVERY,
            FlightState::Landed => Self::LANDED,
            FlightState::Terminated => Self::TERMINATED,
        }
    }
}

/// One row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Transition {
    /// In any of these states,
    pub from: States,
    /// when all of these hold
    pub when: Conditions,
    /// and none of these,
    pub unless: Conditions,
    /// go there
    pub to: FlightState,
    /// and report this.
    pub reason: Option<AbortReason>,
}

/// All transitions, gravest first.
pub const TRANSITIONS: [Transition; 36] = {
    use AbortReason as R;
    use Conditions as C;
    use FlightState::{Armed, Calibrating, Disarmed, Landed, Maneuver, Recovery, Terminated, Tracking};
    use States as S;
    const fn row(
        from: States,
        when: Conditions,
        unless: Conditions,
        to: FlightState,
        reason: Option<AbortReason>,
    ) -> Transition {
        Transition { from, when, unless, to, reason }
    }
    const ON: States = States::MOTORS_ON;
    const NONE: Conditions = Conditions::empty();
    [
        // A person said stop, or can no longer say it.
        row(S::all().difference(S::TERMINATED), C::EMERGENCY_STOP, NONE, Terminated, Some(R::EmergencyStop)),
        row(ON, C::KILL, NONE, Terminated, Some(R::KillSwitch)),
        row(ON, C::KILL_LOST, NONE, Terminated, Some(R::KillLost)),
        row(ON.union(S::LANDED), C::DISARM, NONE, Disarmed, None),
        // Every timeout hangs on the clock.
        row(ON, C::CLOCK, NONE, Terminated, Some(R::Clock)),
        // Nothing can be controlled without rates.
        row(ON, C::GYRO_MISSING, NONE, Terminated, Some(R::GyroMissing)),
        row(ON, C::GYRO_FROZEN, NONE, Terminated, Some(R::GyroFrozen)),
        row(ON, C::GYRO_SATURATED, NONE, Terminated, Some(R::GyroSaturated)),
        row(ON, C::RUNAWAY, NONE, Terminated, Some(R::Runaway)),
        // Nobody is there.
        row(S::ARMED, C::HOST_SILENT, NONE, Disarmed, Some(R::HeartbeatLost)),
        row(S::MANEUVER, C::ABANDON, C::FRESH, Recovery, Some(R::LinkLost)),
        row(S::RECOVERY, C::TOUCHED_DOWN, C::FRESH, Landed, Some(R::LinkLost)),
        row(S::RECOVERY, C::RECOVERY_OVER, C::FRESH, Terminated, Some(R::LinkLost)),
        // The maneuver failed but the vehicle is controllable: back to the host if it is there, else down on its own.
        row(S::MANEUVER, C::LATE_TICKS.union(C::FRESH), NONE, Tracking, Some(R::LateTicks)),
        row(S::MANEUVER, C::LATE_TICKS, NONE, Recovery, Some(R::LateTicks)),
        row(S::MANEUVER, C::LOST_SAMPLES.union(C::FRESH), NONE, Tracking, Some(R::LostSamples)),
        row(S::MANEUVER, C::LOST_SAMPLES, NONE, Recovery, Some(R::LostSamples)),
        row(S::MANEUVER, C::OFF_PLAN.union(C::FRESH), NONE, Tracking, Some(R::OffPlan)),
        row(S::MANEUVER, C::OFF_PLAN, NONE, Recovery, Some(R::OffPlan)),
        row(S::MANEUVER, C::SATURATED.union(C::FRESH), NONE, Tracking, Some(R::MotorsSaturated)),
        row(S::MANEUVER, C::SATURATED, NONE, Recovery, Some(R::MotorsSaturated)),
        row(S::MANEUVER, C::BATTERY_SAG.union(C::FRESH), NONE, Tracking, Some(R::BatterySag)),
        row(S::MANEUVER, C::BATTERY_SAG, NONE, Recovery, Some(R::BatterySag)),
        row(S::ARMED, C::IDLE_TOO_LONG, NONE, Disarmed, Some(R::IdleTimeout)),
        // The ordinary course of a flight.
        row(S::MANEUVER, C::OVER.union(C::FRESH), NONE, Tracking, None),
        row(S::MANEUVER, C::OVER, NONE, Recovery, None),
        row(S::TRACKING, NONE, C::FRESH, Recovery, None),
        row(S::RECOVERY, C::FRESH, NONE, Tracking, None),
        row(S::TRACKING, C::TRIGGER.union(C::FRESH), NONE, Maneuver, None),
        row(S::ARMED, C::FRESH.union(C::LIFTS), NONE, Tracking, None),
        row(S::DISARMED, NONE, C::CALIBRATED, Calibrating, None),
        row(S::DISARMED, C::ARM, C::KILL.union(C::KILL_LOST).union(C::DISARM).union(C::CLOCK), Armed, None),
        // From power-up.
        row(S::BOOT, NONE, C::STARTING, Calibrating, None),
        row(S::CALIBRATING, C::CALIBRATED, NONE, Disarmed, None),
        // The way out of the end.
        row(
            S::TERMINATED,
            C::ACKNOWLEDGE.union(C::CALIBRATED),
            C::KILL.union(C::EMERGENCY_STOP),
            Disarmed,
            None,
        ),
        row(S::TERMINATED, C::ACKNOWLEDGE, C::KILL.union(C::EMERGENCY_STOP), Calibrating, None),
    ]
};

/// What a state looks out for: no row applies in a tick without one of `present` and with all of `absent`. Most ticks are
/// like that, and the table lies in flash, which is slow.
#[derive(Clone, Copy)]
struct Lookout {
    present: Conditions,
    absent: Conditions,
}

#[expect(clippy::indexing_slicing, reason = "evaluated by the compiler only")]
const LOOKOUTS: [Lookout; FlightState::ALL.len()] = {
    // What is so for long stretches of an ordinary flight says nothing.
    const LASTING: Conditions =
        Conditions::FRESH.union(Conditions::LIFTS).union(Conditions::CALIBRATED).union(Conditions::ABANDON);
    let mut lookouts =
        [Lookout { present: Conditions::empty(), absent: Conditions::empty() }; FlightState::ALL.len()];
    let mut state = 0;
    while state < lookouts.len() {
        let here = States::from_bits_retain(1 << state);
        let mut row = 0;
        while row < TRANSITIONS.len() {
            let Transition { from, when, unless, .. } = TRANSITIONS[row];
            if from.contains(here) {
                let sudden = when.difference(LASTING);
                // The row applies only if one of these is so.
                if !sudden.is_empty() {
                    lookouts[state].present = lookouts[state].present.union(sudden);
                } else if !unless.is_empty() {
                    lookouts[state].absent = lookouts[state].absent.union(unless);
                } else {
                    lookouts[state].present = lookouts[state].present.union(when);
                }
            }
            row += 1;
        }
        state += 1;
    }
    lookouts
};

/// The state and why the last flight was cut short.
#[derive(Clone, Copy, Debug, Default)]
pub struct Supervisor {
    state: FlightState,
    abort: Option<AbortReason>,
}

impl Supervisor {
    /// Just switched on.
    pub const fn new() -> Self {
        Self { state: FlightState::Boot, abort: None }
    }

    /// A supervisor in a state, for tests of single transitions.
    pub const fn in_state(state: FlightState) -> Self {
        Self { state, abort: None }
    }

    /// The state.
    pub fn state(&self) -> FlightState {
        self.state
    }

    /// Why the last flight or maneuver was cut short, since arming.
    pub fn abort(&self) -> Option<AbortReason> {
        self.abort
    }

    /// Takes the first transition that applies. `Some` with the old state and the reason where there was one.
    pub fn step(&mut self, conditions: Conditions) -> Option<(FlightState, Option<AbortReason>)> {
        // States are numbered as on the wire, and so are their bits.
        let Lookout { present, absent } = *LOOKOUTS.get(self.state as usize)?;
        if !conditions.intersects(present) && conditions.contains(absent) {
            return None;
        }
        let here = States::from(self.state);
        let row = TRANSITIONS.iter().find(|row| {
            row.from.contains(here) && conditions.contains(row.when) && !conditions.intersects(row.unless)
        })?;
        let old = core::mem::replace(&mut self.state, row.to);
        match row.reason {
            // The gravest reason stays: an off-plan maneuver that ends in a kill was killed.
            Some(reason) => self.abort = self.abort.max(Some(reason)),
            None if row.to == FlightState::Armed => self.abort = None,
            None => {}
        }
        Some((old, row.reason))
    }
}
