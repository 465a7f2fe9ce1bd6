//! Who decides whether the motors turn: conditions, one table of transitions, and the state that follows.
//!
//! Every tick the flight logic gathers [`Conditions`] and the first row of [`TRANSITIONS`] that applies is taken. The
//! rows stand in the order of severity, so that of several faults at once the gravest is acted on and reported, and
//! no row below can undo one above. Whatever no row covers stays as it is; power-up, reset and panic lead to
//! `Disarmed`.

use bitflags::bitflags;
use mintime_shared::messages::{AbortReason, FlightState};

bitflags! {
    /// What is true this tick.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Conditions: u32 {
        /// The kill switch is on.
        const KILL = 1 << 0;
        /// The host asked for an emergency stop.
        const EMERGENCY_STOP = 1 << 1;
        /// The host asked to disarm.
        const DISARM = 1 << 2;
        /// Gyro samples stay away.
        const GYRO_MISSING = 1 << 3;
        /// The gyro repeats itself.
        const GYRO_FROZEN = 1 << 4;
        /// The gyro is at the end of its range.
        const GYRO_SATURATED = 1 << 5;
        /// The vehicle does not follow its controls.
        const RUNAWAY = 1 << 6;
        /// Ticks come too late.
        const LATE_TICKS = 1 << 7;
        /// The maneuver left its envelope.
        const OFF_PLAN = 1 << 8;
        /// No setpoint for so long that nobody can be flying.
        const LINK_DEAD = 1 << 9;
        /// The last setpoint is fresh.
        const FRESH = 1 << 10;
        /// The last setpoint asks for thrust.
        const LIFTS = 1 << 11;
        /// The maneuver's duration has passed.
        const OVER = 1 << 12;
        /// The host triggered a maneuver that may be flown.
        const TRIGGER = 1 << 13;
        /// The host asked to arm and nothing blocks it.
        const ARM = 1 << 14;
        /// Armed and idle for too long.
        const IDLE_TOO_LONG = 1 << 15;
        /// The clock ran backwards.
        const CLOCK = 1 << 16;
    }

    /// Sets of flight states.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct States: u8 {
        /// Motors off.
        const DISARMED = 1 << 0;
        /// Motors idle.
        const ARMED = 1 << 1;
        /// Following setpoints.
        const FLYING = 1 << 2;
        /// Replaying.
        const MANEUVER = 1 << 3;
        /// Sinking without setpoints.
        const LINK_LOST = 1 << 4;
        /// Stopped until cleared.
        const STOPPED = 1 << 5;
        /// Motors turning at any speed.
        const MOTORS_ON = Self::ARMED.bits() | Self::FLYING.bits() | Self::MANEUVER.bits() | Self::LINK_LOST.bits();
        /// In the air.
        const AIRBORNE = Self::FLYING.bits() | Self::MANEUVER.bits() | Self::LINK_LOST.bits();
    }
}

impl From<FlightState> for States {
    fn from(state: FlightState) -> Self {
        match state {
            FlightState::Disarmed => Self::DISARMED,
            FlightState::Armed => Self::ARMED,
            FlightState::Flying => Self::FLYING,
            FlightState::Maneuver => Self::MANEUVER,
            FlightState::LinkLost => Self::LINK_LOST,
            FlightState::Stopped => Self::STOPPED,
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
pub const TRANSITIONS: [Transition; 21] = {
    use Conditions as C;
    use FlightState::{Armed, Disarmed, Flying, LinkLost, Maneuver, Stopped};
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
        // A person said stop.
        row(
            States::all().difference(States::STOPPED),
            C::EMERGENCY_STOP,
            NONE,
            Stopped,
            Some(AbortReason::EmergencyStop),
        ),
        row(ON, C::KILL, NONE, Stopped, Some(AbortReason::KillSwitch)),
        // An emergency stop that arrives together with a disarm outlasts it.
        row(
            States::all().difference(States::DISARMED),
            C::DISARM,
            C::KILL.union(C::EMERGENCY_STOP),
            Disarmed,
            None,
        ),
        // Every timeout hangs on the clock.
        row(ON, C::CLOCK, NONE, Stopped, Some(AbortReason::Clock)),
        // Nothing can be controlled without rates.
        row(ON, C::GYRO_MISSING, NONE, Stopped, Some(AbortReason::GyroMissing)),
        row(ON, C::GYRO_FROZEN, NONE, Stopped, Some(AbortReason::GyroFrozen)),
        row(ON, C::GYRO_SATURATED, NONE, Stopped, Some(AbortReason::GyroSaturated)),
        row(ON, C::RUNAWAY, NONE, Stopped, Some(AbortReason::Runaway)),
        // Nobody is flying.
        row(States::LINK_LOST, C::LINK_DEAD, C::FRESH, Stopped, Some(AbortReason::LinkLost)),
        // The maneuver failed but the vehicle is controllable: back to the host if it is there. If not, nobody knows which
        // way is up: motors off.
        row(States::MANEUVER, C::LATE_TICKS.union(C::FRESH), NONE, Flying, Some(AbortReason::LateTicks)),
        row(States::MANEUVER, C::LATE_TICKS, NONE, Stopped, Some(AbortReason::LateTicks)),
        row(States::MANEUVER, C::OFF_PLAN.union(C::FRESH), NONE, Flying, Some(AbortReason::OffPlan)),
        row(States::MANEUVER, C::OFF_PLAN, NONE, Stopped, Some(AbortReason::OffPlan)),
        row(States::ARMED, C::IDLE_TOO_LONG, NONE, Disarmed, Some(AbortReason::IdleTimeout)),
        // The ordinary course of a flight.
        row(States::MANEUVER, C::OVER.union(C::FRESH), NONE, Flying, None),
        row(States::MANEUVER, C::OVER, NONE, LinkLost, None),
        row(States::FLYING, NONE, C::FRESH, LinkLost, None),
        row(States::LINK_LOST, C::FRESH, NONE, Flying, None),
        row(States::FLYING, C::TRIGGER.union(C::FRESH), NONE, Maneuver, None),
        row(States::ARMED, C::FRESH.union(C::LIFTS), NONE, Flying, None),
        row(States::DISARMED, C::ARM, C::KILL.union(C::DISARM), Armed, None),
    ]
};

/// The state and why the last flight was cut short.
#[derive(Clone, Copy, Debug, Default)]
pub struct Supervisor {
    state: FlightState,
    abort: Option<AbortReason>,
}

impl Supervisor {
    /// Disarmed.
    pub const fn new() -> Self {
        Self { state: FlightState::Disarmed, abort: None }
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
