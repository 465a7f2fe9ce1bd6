//! The pilot's kill switch and a supply that falls, on the very image that gets flashed.

mod bench;

use bench::{Bench, Board};
use emulator::bus::Peripherals;
use emulator::devices::{CRSF_HIGH, CRSF_LOW, CrsfDefect, CrsfReceiver};
use mintime::flight::{Outcome, Phase, VirtualVehicle};
use mintime_shared::messages::{AbortReason, FlightState, IncidentCause, Reply, Request};

/// Into the hover of each flight that breaks there, ms.
const IN_HOVER_MS: u64 = 300;

/// A receiver whose switch says run.
fn running() -> CrsfReceiver {
    let mut receiver = CrsfReceiver::new();
    receiver.channels[4] = CRSF_HIGH;
    receiver
}

fn plug_in(board: &mut Board) {
    board.peripherals.set_receiver(&mut board.memory, Some(running()));
}

fn change(vehicle: &mut VirtualVehicle, act: impl Fn(&mut CrsfReceiver)) {
    let board = vehicle.machine_mut();
    board.peripherals.with_board(&mut board.memory, |board, _| board.receiver.as_mut().map(&act));
}

/// Breaks in the hover; answers after how many ms the first motor was told to stop.
fn killed_after_ms(reason: AbortReason, act: impl Fn(&mut CrsfReceiver) + Copy + 'static) -> f64 {
    let mut bench = Bench::real(11)
        .at_power_up(plug_in)
        .then(Phase::Hover, IN_HOVER_MS, move |vehicle| change(vehicle, act));
    assert_eq!(bench.assert_lost(), (FlightState::Terminated, Some(reason)));
    assert_eq!(bench.bugs(), [""; 0]);
    bench.stopped_after_ms()
}

#[test]
fn a_flight_with_a_receiver_is_a_flight() {
    let mut bench = Bench::real(11).at_power_up(plug_in);
    let result = bench.fly().expect("a flight to its end");
    assert_eq!(result.outcome, Outcome::Completed, "{:?}", result.reason);
    let board = bench.status().board.expect("a board");
    assert_eq!((board.motor_errors, board.missed_ticks), (0, 0), "{board:?}");
    assert_eq!(bench.bugs(), [""; 0]);
}

#[test]
fn the_switch_stops_the_motors() {
    let after_ms = killed_after_ms(AbortReason::KillSwitch, |receiver| receiver.channels[4] = CRSF_LOW);
    println!("kill switch: motors off after {after_ms:.2} ms");
    // A period of the receiver, a frame on the wire, two ticks.
    assert!(after_ms < 4.0 + 0.7 + 2.5 + 0.2, "{after_ms} ms");
}

#[test]
fn a_receiver_that_is_not_heard_any_more_stops_the_motors() {
    for defect in [CrsfDefect::Silent, CrsfDefect::FlippedBit] {
        let after_ms = killed_after_ms(AbortReason::KillLost, move |receiver| receiver.defect = defect);
        println!("{defect:?}: motors off after {after_ms:.1} ms");
        assert!((244.0..257.0).contains(&after_ms), "{defect:?}: {after_ms} ms");
    }
    let after_ms = killed_after_ms(AbortReason::KillLost, |receiver| receiver.link_quality = 0);
    println!("link lost: motors off after {after_ms:.1} ms");
    assert!(after_ms < 10.0 * 4.0 + 1.1 + 2.7, "{after_ms} ms");
}

/// What stopped a flight is told over any resets, and before what stopped the vehicle that lay there.
#[test]
fn the_first_of_two_emergencies_outlives_a_reset() {
    let mut bench = Bench::real(11).at_power_up(plug_in).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        change(vehicle, |receiver| receiver.channels[4] = CRSF_LOW);
    });
    assert_eq!(bench.assert_lost(), (FlightState::Terminated, Some(AbortReason::KillSwitch)));
    let causes = [AbortReason::KillSwitch, AbortReason::EmergencyStop].map(IncidentCause::Terminated);
    for _ in 0..2 {
        bench.board().peripherals.request_reset();
        bench.pass_ms(1500);
        assert_eq!(bench.status().incident.map(|incident| incident.cause), Some(causes[0]));
        assert_eq!(bench.ask(&Request::EmergencyStop), Reply::Done);
    }
    change(&mut bench.vehicle, |receiver| receiver.channels[4] = CRSF_HIGH);
    bench.pass_ms(100);
    for cause in causes {
        let incident = bench.status().incident.expect("it waits");
        assert_eq!(incident.cause, cause);
        assert_eq!(bench.ask(&Request::Acknowledge { incident: incident.number }), Reply::Done);
    }
    bench.board().peripherals.request_reset();
    bench.pass_ms(1500);
    assert_eq!(bench.status().incident, None);
}

/// The detector's interrupt stops the motors; the board stays at its start until the supply is back, and is disarmed then.
#[test]
fn a_supply_that_falls_stops_the_motors() {
    let mut bench = Bench::real(12).then(Phase::Hover, IN_HOVER_MS, |vehicle| {
        vehicle.machine_mut().peripherals.set_supply_v(2.8);
        let board = vehicle.machine_mut();
        let until = board.time() + board.peripherals.clock().cycles_for(2_000_000);
        board.run_until(until);
        board.peripherals.set_supply_v(3.3);
    });
    assert_eq!(bench.assert_lost().0, FlightState::Boot);
    let after_ms = bench.stopped_after_ms();
    println!("supply: motors off after {after_ms:.2} ms");
    assert!(after_ms < 0.5, "{after_ms} ms");
    bench.pass_ms(300);
    let log = bench.log();
    assert_eq!(log.reset_causes(), ["PowerOn", "Software"]);
    assert_eq!(log.crashes(), ["BrownOut"]);
    assert!(!bench.status().state.motors_on());
}
