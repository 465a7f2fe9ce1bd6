//! The supervisor's table of transitions, tried with every combination of conditions in every state.

use mintime_firmware::supervisor::{Conditions, States, Supervisor, TRANSITIONS};
use mintime_shared::messages::{AbortReason, FlightState};

const STATES: [FlightState; 6] = [
    FlightState::Disarmed,
    FlightState::Armed,
    FlightState::Tracking,
    FlightState::Maneuver,
    FlightState::Recovery,
    FlightState::Terminated,
];

/// A supervisor in a state, led there by conditions alone.
fn in_state(state: FlightState) -> Supervisor {
    use Conditions as C;
    let flying = [C::ARM, C::FRESH | C::LIFTS];
    let path: Vec<Conditions> = match state {
        FlightState::Disarmed => vec![],
        FlightState::Armed => vec![C::ARM],
        FlightState::Tracking => flying.to_vec(),
        FlightState::Maneuver => [&flying[..], &[C::TRIGGER | C::FRESH]].concat(),
        FlightState::Recovery => [&flying[..], &[C::empty()]].concat(),
        FlightState::Terminated => vec![C::ARM, C::KILL],
    };
    let mut supervisor = Supervisor::new();
    for conditions in path {
        assert!(supervisor.step(conditions).is_some(), "{conditions:?} on the way to {state:?}");
    }
    assert_eq!(supervisor.state(), state);
    supervisor
}

/// Calls with every state, every set of conditions, and the supervisor after the step.
fn every_step(mut look: impl FnMut(FlightState, Conditions, &Supervisor)) {
    assert_eq!(Conditions::all().bits(), 0x1_ffff, "the sweep below covers every condition");
    for from in STATES {
        let before = in_state(from);
        for bits in 0..=0x1_ffff {
            let conditions = Conditions::from_bits_retain(bits);
            let mut after = before;
            let moved = after.step(conditions);
            assert!(moved.is_none_or(|(old, _)| old == from));
            if moved.is_none() {
                assert_eq!(after.state(), from);
            }
            look(from, conditions, &after);
        }
    }
}

#[test]
fn a_stop_by_a_person_always_stops() {
    every_step(|from, conditions, after| {
        if conditions.contains(Conditions::EMERGENCY_STOP) {
            assert_eq!(after.state(), FlightState::Terminated, "{from:?}, {conditions:?}");
        }
        if conditions.contains(Conditions::KILL) && from.motors_on() {
            assert_eq!(after.state(), FlightState::Terminated, "{from:?}, {conditions:?}");
        }
        if conditions.contains(Conditions::DISARM) {
            assert!(!after.state().motors_on(), "{from:?}, {conditions:?}");
        }
    });
}

#[test]
fn without_rates_no_motor_turns() {
    use Conditions as C;
    let blind = C::GYRO_MISSING | C::GYRO_FROZEN | C::GYRO_SATURATED | C::RUNAWAY;
    every_step(|from, conditions, after| {
        if conditions.intersects(blind) && from.motors_on() {
            assert!(!after.state().motors_on(), "{from:?}, {conditions:?}");
        }
    });
}

#[test]
fn only_a_disarm_clears_a_stop_and_only_arming_starts_motors() {
    use Conditions as C;
    every_step(|from, conditions, after| {
        let to = after.state();
        if from == FlightState::Terminated && to != from {
            assert_eq!(to, FlightState::Disarmed);
            assert!(conditions.contains(C::DISARM) && !conditions.intersects(C::KILL | C::EMERGENCY_STOP));
        }
        if from == FlightState::Disarmed && to.motors_on() {
            assert_eq!(to, FlightState::Armed);
            assert!(conditions.contains(C::ARM) && !conditions.intersects(C::KILL | C::EMERGENCY_STOP));
        }
        if to == FlightState::Maneuver && from != to {
            assert_eq!(from, FlightState::Tracking);
            assert!(conditions.contains(C::TRIGGER | C::FRESH));
        }
        if to == FlightState::Tracking && from != to {
            assert!(
                conditions.contains(C::FRESH),
                "nobody flies without a setpoint: {from:?}, {conditions:?}"
            );
        }
    });
}

/// A maneuver does not outlive what ends it, and one that nothing ends goes on.
#[test]
fn a_maneuver_ends_when_it_must_and_not_before() {
    use Conditions as C;
    let ends = C::KILL
        | C::EMERGENCY_STOP
        | C::DISARM
        | C::CLOCK
        | C::GYRO_MISSING
        | C::GYRO_FROZEN
        | C::GYRO_SATURATED
        | C::RUNAWAY
        | C::LATE_TICKS
        | C::OFF_PLAN
        | C::OVER;
    every_step(|from, conditions, after| {
        if from == FlightState::Maneuver {
            assert_eq!(after.state() == from, !conditions.intersects(ends), "{conditions:?}");
        }
    });
}

/// Of several faults the gravest is reported, in the order that the reasons themselves have.
#[test]
fn severity_is_one_order() {
    let reasons: Vec<AbortReason> = TRANSITIONS.iter().filter_map(|row| row.reason).collect();
    assert!(reasons.is_sorted_by(|graver, lesser| graver >= lesser), "{reasons:?}");
    assert_eq!(reasons.last(), Some(&AbortReason::IdleTimeout));

    let condition_of = |reason| match reason {
        AbortReason::IdleTimeout => Conditions::IDLE_TOO_LONG,
        AbortReason::OffPlan => Conditions::OFF_PLAN,
        AbortReason::LateTicks => Conditions::LATE_TICKS,
        AbortReason::LinkLost => Conditions::LINK_DEAD,
        AbortReason::Runaway => Conditions::RUNAWAY,
        AbortReason::GyroSaturated => Conditions::GYRO_SATURATED,
        AbortReason::GyroFrozen => Conditions::GYRO_FROZEN,
        AbortReason::GyroMissing => Conditions::GYRO_MISSING,
        AbortReason::Clock => Conditions::CLOCK,
        AbortReason::KillSwitch => Conditions::KILL,
        AbortReason::EmergencyStop => Conditions::EMERGENCY_STOP,
    };
    every_step(|from, conditions, after| {
        let Some(abort) = after.abort() else { return };
        // What is reported is true, or was on the way to the state.
        assert!(conditions.contains(condition_of(abort)) || from == FlightState::Terminated);
        // And nothing graver that this state looks at was passed over.
        for row in TRANSITIONS.iter().filter(|row| row.from.contains(States::from(from))) {
            let holds = conditions.contains(row.when) && !conditions.intersects(row.unless);
            if let Some(reason) = row.reason.filter(|_| holds) {
                let disarmed = after.state() == FlightState::Disarmed;
                assert!(abort >= reason || disarmed, "{from:?}, {conditions:?}: {abort:?}");
            }
        }
    });
}

/// The gravest reason since arming stays until the next arming.
#[test]
fn reports_last_until_the_next_arming() {
    use Conditions as C;
    let mut supervisor = in_state(FlightState::Maneuver);
    supervisor.step(C::OFF_PLAN | C::FRESH);
    assert_eq!((supervisor.state(), supervisor.abort()), (FlightState::Tracking, Some(AbortReason::OffPlan)));
    supervisor.step(C::KILL);
    assert_eq!(
        (supervisor.state(), supervisor.abort()),
        (FlightState::Terminated, Some(AbortReason::KillSwitch))
    );
    supervisor.step(C::DISARM);
    assert_eq!(
        (supervisor.state(), supervisor.abort()),
        (FlightState::Disarmed, Some(AbortReason::KillSwitch))
    );
    supervisor.step(C::ARM);
    assert_eq!((supervisor.state(), supervisor.abort()), (FlightState::Armed, None));
}

/// Each row decides somewhere: none is shadowed by those above it.
#[test]
fn every_row_is_taken() {
    let mut taken = [false; TRANSITIONS.len()];
    every_step(|from, conditions, after| {
        let first = TRANSITIONS.iter().position(|row| {
            row.from.contains(States::from(from))
                && row.when.iter().all(|c| conditions.contains(c))
                && row.unless.iter().all(|c| !conditions.contains(c))
        });
        assert_eq!(first.map_or(from, |row| TRANSITIONS[row].to), after.state(), "{from:?}, {conditions:?}");
        if let Some(row) = first {
            taken[row] = true;
        }
    });
    let unreachable: Vec<usize> = (0..taken.len()).filter(|&row| !taken[row]).collect();
    assert!(unreachable.is_empty(), "rows {unreachable:?}");
}
