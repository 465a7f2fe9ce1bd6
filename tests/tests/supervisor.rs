//! The supervisor's table of transitions, tried in every state with every set of the conditions that its rows look at,
//! against rules that are written here a second time; and those rules tried on tables with a fault in each row.

use mintime_firmware::supervisor::{Conditions, States, Supervisor, TRANSITIONS, Transition};
use mintime_shared::messages::{AbortReason, FlightState};

use AbortReason as R;
use Conditions as C;
use FlightState as S;

/// What a table does: the state that follows and the reason given, or nothing.
type Step = Option<(FlightState, Option<AbortReason>)>;

/// The row that a table takes, by the words of its documentation: the first that applies.
fn row_taken(table: &[Transition], state: FlightState, conditions: Conditions) -> Option<usize> {
    table.iter().position(|row| {
        row.from.contains(States::from(state))
            && row.when.iter().all(|c| conditions.contains(c))
            && row.unless.iter().all(|c| !conditions.contains(c))
    })
}

fn step(table: &[Transition], state: FlightState, conditions: Conditions) -> Step {
    row_taken(table, state, conditions).map(|row| (table[row].to, table[row].reason))
}

/// All conditions that a row of this state looks at: no other can matter there.
fn mentioned(table: &[Transition], state: FlightState) -> Conditions {
    let rows = table.iter().filter(|row| row.from.contains(States::from(state)));
    rows.fold(C::empty(), |all, row| all | row.when | row.unless)
}

/// Every subset, the empty one first.
fn subsets(of: Conditions) -> impl Iterator<Item = Conditions> {
    let bits: Vec<Conditions> = of.iter().collect();
    (0u32..1 << bits.len()).map(move |mask| {
        let chosen = bits.iter().enumerate().filter(|(i, _)| mask & 1 << i != 0);
        chosen.fold(C::empty(), |all, (_, c)| all | *c)
    })
}

/// Conditions that a person or a bad sensor brings about, with their reasons, the gravest first. In every state with motors
/// on each ends the flight for good.
const FATAL: [(Conditions, AbortReason); 8] = [
    (C::EMERGENCY_STOP, R::EmergencyStop),
    (C::KILL, R::KillSwitch),
    (C::KILL_LOST, R::KillLost),
    (C::CLOCK, R::Clock),
    (C::GYRO_MISSING, R::GyroMissing),
    (C::GYRO_FROZEN, R::GyroFrozen),
    (C::GYRO_SATURATED, R::GyroSaturated),
    (C::RUNAWAY, R::Runaway),
];

/// Conditions that end a maneuver of a vehicle that can still be flown, the gravest first.
const SPOILT: [(Conditions, AbortReason); 5] = [
    (C::LATE_TICKS, R::LateTicks),
    (C::LOST_SAMPLES, R::LostSamples),
    (C::OFF_PLAN, R::OffPlan),
    (C::SATURATED, R::MotorsSaturated),
    (C::BATTERY_SAG, R::BatterySag),
];

/// The rules as prose would put them, state by state. It knows nothing of rows and their order.
fn ruled(state: FlightState, c: Conditions) -> Step {
    let fresh = c.contains(C::FRESH);
    let host_or_alone = if fresh { S::Tracking } else { S::Recovery };
    let disarms = c.contains(C::DISARM);
    if state == S::Terminated {
        let stays = !c.contains(C::ACKNOWLEDGE) || c.intersects(C::KILL | C::EMERGENCY_STOP);
        let next = if c.contains(C::CALIBRATED) { S::Disarmed } else { S::Calibrating };
        return (!stays).then_some((next, None));
    }
    if c.contains(C::EMERGENCY_STOP) {
        return Some((S::Terminated, Some(R::EmergencyStop)));
    }
    if state.motors_on() {
        let fatal = FATAL.iter().find(|(condition, _)| c.contains(*condition));
        // A disarm is a person's word as well; the switch and the emergency stop stand above it, the sensors below.
        if disarms && !c.intersects(C::KILL | C::KILL_LOST) {
            return Some((S::Disarmed, None));
        }
        if let Some((_, reason)) = fatal {
            return Some((S::Terminated, Some(*reason)));
        }
    }
    match state {
        S::Boot => (!c.contains(C::STARTING)).then_some((S::Calibrating, None)),
        S::Calibrating => c.contains(C::CALIBRATED).then_some((S::Disarmed, None)),
        S::Disarmed if !c.contains(C::CALIBRATED) => Some((S::Calibrating, None)),
        S::Disarmed => {
            let may = c.contains(C::ARM) && !disarms && !c.intersects(C::KILL | C::KILL_LOST | C::CLOCK);
            may.then_some((S::Armed, None))
        }
        S::Armed if c.contains(C::HOST_SILENT) => Some((S::Disarmed, Some(R::HeartbeatLost))),
        S::Armed if c.contains(C::IDLE_TOO_LONG) => Some((S::Disarmed, Some(R::IdleTimeout))),
        S::Armed => c.contains(C::FRESH | C::LIFTS).then_some((S::Tracking, None)),
        S::Tracking if !fresh => Some((S::Recovery, None)),
        S::Tracking => c.contains(C::TRIGGER).then_some((S::Maneuver, None)),
        S::Maneuver => {
            if c.contains(C::ABANDON) && !fresh {
                return Some((S::Recovery, Some(R::LinkLost)));
            }
            if let Some((_, reason)) = SPOILT.iter().find(|(condition, _)| c.contains(*condition)) {
                return Some((host_or_alone, Some(*reason)));
            }
            c.contains(C::OVER).then_some((host_or_alone, None))
        }
        S::Recovery if fresh => Some((S::Tracking, None)),
        S::Recovery if c.contains(C::TOUCHED_DOWN) => Some((S::Landed, Some(R::LinkLost))),
        S::Recovery => c.contains(C::RECOVERY_OVER).then_some((S::Terminated, Some(R::LinkLost))),
        S::Landed => disarms.then_some((S::Disarmed, None)),
        S::Terminated => None,
    }
}

/// What must hold of any step whatever the table: the promises of safety, each by itself.
fn promises(from: FlightState, c: Conditions, taken: Step) -> Result<(), &'static str> {
    let (to, reason) = taken.map_or((from, None), |(to, reason)| (to, reason));
    let ensure = |holds: bool, promise: &'static str| if holds { Ok(()) } else { Err(promise) };
    let fatal = FATAL.iter().fold(C::empty(), |all, (condition, _)| all | *condition);
    ensure(
        !c.contains(C::EMERGENCY_STOP) || to == S::Terminated,
        "an emergency stop terminates from anywhere",
    )?;
    ensure(!(from.motors_on() && c.intersects(fatal | C::DISARM) && to.motors_on()), "a stop stops")?;
    let kill = c.intersects(C::KILL | C::KILL_LOST);
    ensure(!(from.motors_on() && kill) || to == S::Terminated, "the kill switch terminates")?;
    ensure(!(to.motors_on() && kill), "no motor turns against the kill switch")?;
    let starts = to.motors_on() && !from.motors_on();
    ensure(!starts || (from, to) == (S::Disarmed, S::Armed), "motors start from disarmed to armed alone")?;
    ensure(!starts || c.contains(C::ARM | C::CALIBRATED), "motors start on request, with a known bias")?;
    ensure(
        !(from == S::Terminated && to != from) || (c.contains(C::ACKNOWLEDGE) && !to.motors_on()),
        "only an acknowledgement leads out of the end, and to motors off",
    )?;
    ensure(
        !(from == S::Boot && to != from) || matches!(to, S::Calibrating | S::Terminated),
        "what starts learns its bias first",
    )?;
    ensure(
        !(to == S::Tracking && from != to) || c.contains(C::FRESH),
        "nobody follows setpoints that are old",
    )?;
    ensure(
        !(to == S::Maneuver && from != to) || (from == S::Tracking && c.contains(C::TRIGGER | C::FRESH)),
        "a maneuver begins on request, from a flight that is followed",
    )?;
    ensure(
        !(from == S::Tracking && to == from) || c.contains(C::FRESH),
        "a flight that nobody leads is recovered",
    )?;
    ensure(
        !(from == S::Maneuver && to == from && c.contains(C::ABANDON)) || c.contains(C::FRESH),
        "a maneuver to be given up without its link is",
    )?;
    ensure(!(from == S::Recovery && to == from && c.contains(C::RECOVERY_OVER)), "a recovery ends in time")?;
    ensure(to != S::Terminated || from == to || reason.is_some(), "whoever is terminated is told why")?;
    // Of several reasons the gravest that holds, and none that does not. A person's own wish needs none.
    let asked = reason.is_none() && c.contains(C::DISARM) && to == S::Disarmed;
    if from.motors_on() && !asked {
        let worst = FATAL.iter().chain(&SPOILT[..if from == S::Maneuver { 5 } else { 0 }]);
        let worst = worst.filter(|(condition, _)| c.contains(*condition)).map(|(_, reason)| *reason).max();
        ensure(reason >= worst, "the gravest reason is reported")?;
        let known = FATAL.iter().chain(&SPOILT).find(|(_, r)| Some(*r) == reason);
        ensure(known.is_none_or(|(condition, _)| c.contains(*condition)), "a reason given is true")?;
    }
    Ok(())
}

/// Whether a table keeps every promise and every rule, in these states.
fn judge(table: &[Transition], states: States) -> Result<(), String> {
    for state in S::ALL.into_iter().filter(|s| states.contains(States::from(*s))) {
        for c in subsets(mentioned(table, state) | mentioned(&TRANSITIONS, state)) {
            let taken = step(table, state, c);
            promises(state, c, taken).map_err(|promise| format!("{state:?}, {c:?}: {promise}"))?;
            if taken != ruled(state, c) {
                return Err(format!("{state:?}, {c:?}: {taken:?} where the rule is {:?}", ruled(state, c)));
            }
        }
    }
    Ok(())
}

/// Every state with every set of conditions that it looks at.
#[test]
fn the_table_keeps_every_promise_and_every_rule() {
    judge(&TRANSITIONS, States::all()).expect("the table is sound");
    let cases: usize = S::ALL.iter().map(|s| 1usize << mentioned(&TRANSITIONS, *s).iter().count()).sum();
    assert!(cases > 100_000, "{cases} cases");
    // Each condition matters somewhere.
    let all = S::ALL.iter().fold(C::empty(), |all, s| all | mentioned(&TRANSITIONS, *s));
    assert_eq!(all, C::all());
}

/// The supervisor does what its table says, and conditions that no row of a state mentions change nothing in it.
#[test]
fn the_supervisor_takes_the_first_row_that_applies() {
    for state in S::ALL {
        let looks_at = mentioned(&TRANSITIONS, state);
        let others = C::all().difference(looks_at);
        for (n, c) in subsets(looks_at).enumerate() {
            // Others come and go without an order.
            let noise = C::from_bits_truncate((n as u32).wrapping_mul(2_654_435_761).rotate_left(7)) & others;
            for conditions in [c, c | others, c | noise] {
                let mut supervisor = Supervisor::in_state(state);
                let taken = supervisor.step(conditions);
                let expected = step(&TRANSITIONS, state, c);
                assert_eq!(taken, expected.map(|(_, reason)| (state, reason)), "{state:?}, {conditions:?}");
                assert_eq!(
                    supervisor.state(),
                    expected.map_or(state, |(to, _)| to),
                    "{state:?}, {conditions:?}"
                );
            }
        }
    }
}

/// Whether conditions exist for which this one row decides.
fn decides(table: &[Transition], row: usize) -> bool {
    S::ALL
        .into_iter()
        .filter(|s| table[row].from.contains(States::from(*s)))
        .any(|state| subsets(mentioned(table, state)).any(|c| row_taken(table, state, c) == Some(row)))
}

/// Each row decides somewhere in each of its states: none is shadowed by those above it.
#[test]
fn every_row_is_taken_in_each_of_its_states() {
    for (n, row) in TRANSITIONS.iter().enumerate() {
        for state in S::ALL.into_iter().filter(|s| row.from.contains(States::from(*s))) {
            let taken =
                subsets(mentioned(&TRANSITIONS, state)).any(|c| row_taken(&TRANSITIONS, state, c) == Some(n));
            assert!(taken, "row {n} is never taken in {state:?}");
        }
    }
    let mut shadowed = TRANSITIONS.to_vec();
    shadowed.push(TRANSITIONS[0]);
    assert!(!decides(&shadowed, TRANSITIONS.len()), "the check sees a row that is shadowed");
}

/// The order of rows is the order of the reasons themselves: one total order, and each reason has a row.
#[test]
fn severity_is_one_order() {
    let reasons: Vec<AbortReason> = TRANSITIONS.iter().filter_map(|row| row.reason).collect();
    assert!(reasons.is_sorted_by(|graver, lesser| graver >= lesser), "{reasons:?}");
    assert!(R::ALL.is_sorted_by(|lesser, graver| lesser < graver));
    for reason in R::ALL {
        assert!(reasons.contains(&reason), "{reason:?} is never given");
    }
}

/// Every way from power-up to a turning motor, over any number of steps, leads through `Disarmed` and a request to arm; and
/// every state can be reached at all.
#[test]
fn no_way_from_power_up_to_motors_but_through_arming() {
    let reachable = |without: Conditions, walls: &[FlightState]| {
        let mut found = vec![S::Boot];
        let mut next = 0;
        while let Some(&state) = found.get(next) {
            next += 1;
            for c in subsets(mentioned(&TRANSITIONS, state).difference(without)) {
                if let Some((to, _)) = step(&TRANSITIONS, state, c)
                    && !found.contains(&to)
                    && !walls.contains(&to)
                {
                    found.push(to);
                }
            }
        }
        found
    };
    for state in S::ALL {
        assert!(reachable(C::empty(), &[]).contains(&state), "{state:?}");
    }
    assert!(!reachable(C::ARM, &[]).iter().any(|s| s.motors_on()));
    assert!(!reachable(C::empty(), &[S::Disarmed]).iter().any(|s| s.motors_on()));
    // And once terminated nothing turns again without an acknowledgement.
    let mut from_the_end = subsets(mentioned(&TRANSITIONS, S::Terminated).difference(C::ACKNOWLEDGE));
    assert!(from_the_end.all(|c| step(&TRANSITIONS, S::Terminated, c).is_none()));
}

/// The gravest reason since arming stays until the next arming.
#[test]
fn reports_last_until_the_next_arming() {
    let mut supervisor = Supervisor::in_state(S::Maneuver);
    for (conditions, state, abort) in [
        (C::OFF_PLAN | C::FRESH, S::Tracking, Some(R::OffPlan)),
        (C::TRIGGER | C::FRESH, S::Maneuver, Some(R::OffPlan)),
        (C::BATTERY_SAG | C::FRESH, S::Tracking, Some(R::OffPlan)),
        (C::KILL, S::Terminated, Some(R::KillSwitch)),
        (C::CALIBRATED, S::Terminated, Some(R::KillSwitch)),
        (C::ACKNOWLEDGE | C::CALIBRATED, S::Disarmed, Some(R::KillSwitch)),
        (C::ARM | C::CALIBRATED, S::Armed, None),
    ] {
        supervisor.step(conditions);
        assert_eq!((supervisor.state(), supervisor.abort()), (state, abort), "{conditions:?}");
    }
}

/// A table that differs from the real one in one row.
struct Mutant {
    what: String,
    row: usize,
    table: Vec<Transition>,
    states: States,
    /// The difference lies in these conditions alone: the row looks at them, or looks at them no more.
    added: Conditions,
}

fn mutants() -> Vec<Mutant> {
    let mut all = Vec::new();
    for (n, row) in TRANSITIONS.iter().enumerate() {
        let mut add = |what: String, replacement: Option<Transition>| {
            let mut table = TRANSITIONS.to_vec();
            match replacement {
                Some(row) => table[n] = row,
                None => drop(table.remove(n)),
            }
            let new = replacement.unwrap_or(*row);
            let added = (new.when | new.unless).difference(row.when | row.unless);
            let what = format!("row {n}: {what}");
            all.push(Mutant { what, row: n, table, states: row.from | new.from, added });
        };
        add("removed".into(), None);
        for to in S::ALL.into_iter().filter(|to| *to != row.to) {
            add(format!("leads to {to:?}"), Some(Transition { to, ..*row }));
        }
        let reasons = R::ALL.into_iter().map(Some).chain([None]);
        for reason in reasons.filter(|reason| *reason != row.reason) {
            add(format!("reports {reason:?}"), Some(Transition { reason, ..*row }));
        }
        for state in States::all().iter() {
            add(format!("other states: {state:?}"), Some(Transition { from: row.from ^ state, ..*row }));
        }
        for c in row.when.iter() {
            add(format!("without {c:?}"), Some(Transition { when: row.when.difference(c), ..*row }));
        }
        for c in row.unless.iter() {
            add(format!("in spite of {c:?}"), Some(Transition { unless: row.unless.difference(c), ..*row }));
        }
        for c in C::all().difference(row.when | row.unless).iter() {
            add(format!("not with {c:?}"), Some(Transition { unless: row.unless | c, ..*row }));
            add(format!("only with {c:?}"), Some(Transition { when: row.when | c, ..*row }));
        }
    }
    all
}

/// Whether a row of the real table is taken with this condition, and without it.
fn taken_with_and_without(row: usize, condition: Conditions) -> (bool, bool) {
    let mut taken = (false, false);
    for state in S::ALL.into_iter().filter(|s| TRANSITIONS[row].from.contains(States::from(*s))) {
        for c in subsets(mentioned(&TRANSITIONS, state) | condition) {
            if row_taken(&TRANSITIONS, state, c) == Some(row) {
                if c.contains(condition) { taken.0 = true } else { taken.1 = true }
            }
        }
    }
    taken
}

/// A fault in any row is seen: the row gone, another target, another reason, a state more or less, a condition less, a condition
/// more by which it applies or does not.
#[test]
fn a_fault_in_any_row_breaks_a_rule() {
    let (mut harmless, mut covered) = (Vec::new(), Vec::new());
    let mut seen = 0;
    for mutant in mutants() {
        match judge(&mutant.table, mutant.states) {
            Err(_) => seen += 1,
            Ok(()) if mutant.added.is_empty() => harmless.push(mutant.what),
            Ok(()) => {
                // Rows above take whatever has this condition, or all that has it not: this row sees no difference.
                let (with, without) = taken_with_and_without(mutant.row, mutant.added);
                let wanted = mutant.table[mutant.row].when.contains(mutant.added);
                assert_eq!((with, without), (wanted, !wanted), "{}", mutant.what);
                covered.push(mutant.what);
            }
        }
    }
    println!("{seen} faulty tables seen, {} differ in nothing: {harmless:#?}, {covered:#?}", harmless.len());
    // Those that differ in nothing do so for a reason: what the row adds is covered by rows above it.
    let vain = |what: &String| what.contains("other states") || what.contains("without");
    assert!(harmless.iter().all(vain), "{harmless:#?}");
    assert!(harmless.len() <= 5 && seen > 2500, "{seen} seen, {harmless:#?}");
}

/// The promises of safety alone, without the rules state by state, see every stop that is gone.
#[test]
fn a_stop_that_is_gone_breaks_a_promise() {
    for (n, gone) in TRANSITIONS.iter().enumerate().filter(|(_, row)| row.to == S::Terminated) {
        let mut table = TRANSITIONS.to_vec();
        table.remove(n);
        let broken = S::ALL.into_iter().filter(|s| gone.from.contains(States::from(*s))).any(|state| {
            let cases = subsets(mentioned(&TRANSITIONS, state));
            cases.into_iter().any(|c| promises(state, c, step(&table, state, c)).is_err())
        });
        assert!(broken, "row {n} may go and no promise is broken");
    }
}
