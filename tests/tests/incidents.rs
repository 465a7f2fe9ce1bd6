//! What a person must have read of before the motors turn again: in which order it is told, and what its acknowledgement does.

mod logic;

use logic::Bench;
use mintime_firmware::config::INCIDENTS;
use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, Happening, IncidentCause, KillSwitch, Purpose, Refusal, Reply,
    Request,
};

/// An incident is acknowledged by its number, once; a newer one waits in its turn.
#[test]
fn incidents_are_acknowledged_by_number() {
    let mut bench = Bench::ready();
    let causes = [IncidentCause::Panic(7), IncidentCause::Watchdog, IncidentCause::StoreDamaged];
    for cause in causes {
        bench.logic.report(cause);
    }
    for (cause, number) in causes.into_iter().zip(1..) {
        assert_eq!(
            bench.refusal(Request::Arm(Purpose::Flight)),
            Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0)
        );
        let incident = bench.telemetry().incident.expect("it waits");
        assert_eq!((incident.cause, incident.number), (cause, number));
        for wrong in [0, number + 1, u16::MAX] {
            assert_eq!(bench.refusal(Request::Acknowledge { incident: wrong }), Refusal::NoSuchIncident);
        }
        let right = Request::Acknowledge { incident: incident.number };
        assert_eq!(bench.ask(right.clone()), Reply::Done);
        assert_ne!(bench.telemetry().incident.map(|incident| incident.number), Some(number));
        assert_eq!(bench.ask(right), Reply::Done, "its answer was lost and it comes again");
    }
    assert_eq!(bench.telemetry().incident, None);
    bench.arm();
}

/// The log begins with the start, whatever is known of what was before, and tells when the bias was learned.
#[test]
fn the_log_begins_with_the_start() {
    use Happening::{Calibrated, Entered, Incident, Started};
    let mut bench = Bench::new();
    bench.logic.report(IncidentCause::Watchdog);
    bench.run(900);
    assert_eq!(bench.ask(Request::Calibrate), Reply::Pending);
    bench.run(900);
    let Reply::Events(log) = bench.ask(Request::ReadEvents { first: 0 }) else { panic!("no events") };
    let (learns, rests) = (Entered(FlightState::Calibrating), Entered(FlightState::Disarmed));
    let told: Vec<_> = log.events.iter().map(|event| event.what).collect();
    let incident = Incident(IncidentCause::Watchdog);
    assert_eq!(told, [Started, incident, learns, Calibrated, rests, learns, Calibrated, rests]);
    assert_eq!((log.first, log.newest), (1, 8));
}

/// What waits from before does not stand for the emergency: only the acknowledgement of that one leads out, and what has
/// come since still blocks arming.
#[test]
fn only_its_own_acknowledgement_ends_an_emergency() {
    let mut bench = Bench::ready();
    let stopped = |bench: &mut Bench| bench.telemetry().incident.map(|incident| incident.cause);
    bench.logic.report(IncidentCause::Watchdog);
    assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
    bench.logic.report(IncidentCause::StoreDamaged);
    assert_eq!(stopped(&mut bench), Some(IncidentCause::Watchdog));
    let block = ArmingBlock(bench.telemetry().arming_block);
    assert!(block.contains(ArmingBlock::TERMINATED) && block.contains(ArmingBlock::INCIDENT), "{block}");
    // The switch is asked for by the one that leads out.
    bench.kill = KillSwitch::Stop;
    assert_eq!(bench.acknowledge(), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    assert_eq!(stopped(&mut bench), Some(IncidentCause::Terminated(AbortReason::EmergencyStop)));
    assert_eq!(bench.acknowledge(), Reply::Refused(Refusal::KillSwitch));
    bench.kill = KillSwitch::Run;
    assert_eq!(bench.acknowledge(), Reply::Done);
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    assert_eq!(bench.refusal(Request::Arm(Purpose::Flight)), Refusal::ArmingBlocked(ArmingBlock::INCIDENT.0));
    assert_eq!(bench.acknowledge(), Reply::Done);
    bench.arm();
}

/// A host that asks twice in one tick has not acknowledged what comes next, and a stop that comes with it waits in its turn.
#[test]
fn an_acknowledgement_counts_for_one_incident() {
    let mut bench = Bench::ready();
    bench.logic.report(IncidentCause::Watchdog);
    bench.logic.report(IncidentCause::BrownOut);
    let acknowledge = Request::Acknowledge { incident: 1 };
    bench.tick(&[acknowledge.clone(), acknowledge.clone(), Request::EmergencyStop]);
    for number in [bench.number - 2, bench.number - 1, bench.number] {
        assert_eq!(bench.answer(number), Some(Reply::Done));
    }
    assert_eq!(bench.logic.state(), FlightState::Terminated);
    for cause in [IncidentCause::BrownOut, IncidentCause::Terminated(AbortReason::EmergencyStop)] {
        assert_eq!(bench.telemetry().incident.map(|incident| incident.cause), Some(cause));
        assert_eq!(bench.acknowledge(), Reply::Done);
    }
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
}

/// However many there are, the oldest is told first and the emergency is among them.
#[test]
fn of_many_incidents_the_emergency_is_kept() {
    let mut bench = Bench::ready();
    for line in 0..9 {
        bench.logic.report(IncidentCause::Panic(line));
    }
    assert_eq!(bench.ask(Request::EmergencyStop), Reply::Done);
    bench.logic.report(IncidentCause::Watchdog);
    let terminated = IncidentCause::Terminated(AbortReason::EmergencyStop);
    // The oldest that find room beside it.
    let oldest = (0..INCIDENTS as u32 - 1).map(IncidentCause::Panic);
    for cause in oldest.chain([terminated]) {
        assert_eq!(bench.logic.state(), FlightState::Terminated);
        assert_eq!(bench.telemetry().incident.map(|incident| incident.cause), Some(cause));
        assert_eq!(bench.acknowledge(), Reply::Done);
    }
    assert_eq!(bench.logic.state(), FlightState::Disarmed);
    bench.arm();
}
