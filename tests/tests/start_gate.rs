//! The start gate of a table that begins tilted: a vehicle that leans there is let through, one that leans anywhere else is
//! not.

mod logic;

use logic::{Bench, HOVER};
use mintime_firmware::config::{GATE_TILT_RAD, VehicleConfig};
use mintime_shared::messages::{FlightState, Refusal, Reply, Request, Setpoint};
use mintime_shared::model::{Inputs, Limits, RateMode, Segment, State, ThrustLevel};
use mintime_shared::table::{Kind, LinkPolicy, ManeuverTable, TableHeader};

const TURNS_RADPS: f32 = 1.0;
const TICKS_PER_RAD: f32 = 800.0 / TURNS_RADPS;

/// A short turn that begins tilted. Where it ends is nobody's business here.
fn tilted(theta: f32, heading_rad: f32) -> ManeuverTable {
    let start = State { theta, ..State::origin() };
    let header = TableHeader {
        vehicle: VehicleConfig::REFERENCE.hash(),
        kind: Kind::Learned,
        link: LinkPolicy::Finish,
        limits: Limits::TABLE_I.cast(),
        heading_rad,
        start,
        end: start,
    };
    let inputs = Inputs { rate: RateMode::Plus, thrust: ThrustLevel::Max };
    ManeuverTable::new(header, None, [Segment { inputs, duration: 0.05 }]).expect("a sound table")
}

/// A vehicle in the air whose thrust axis has tipped by an angle, rad, towards a heading of its own.
fn leaning(table: &ManeuverTable, tilt_rad: f32, towards_rad: f32) -> Bench {
    let mut bench = Bench::ready();
    bench.commit(table);
    bench.arm();
    bench.stream = Some(HOVER);
    // The stream speaks every eight ticks.
    while bench.logic.state() != FlightState::Tracking || !bench.ticks.is_multiple_of(8) {
        bench.run(1);
    }
    // About the level axis to the left of the heading, by the right hand.
    let (sin, cos) = towards_rad.sin_cos();
    let rate = TURNS_RADPS.copysign(tilt_rad);
    bench.stream = Some(Setpoint { rates_radps: [-sin * rate, cos * rate, 0.0], ..HOVER });
    bench.run((tilt_rad.abs() * TICKS_PER_RAD).round() as usize);
    bench.stream = Some(HOVER);
    bench.run(80);
    // What the lean makes of world-up: it moves away from the heading.
    let want = [-tilt_rad.sin() * cos, -tilt_rad.sin() * sin, tilt_rad.cos()];
    for (is, want) in bench.telemetry().up_body.into_iter().zip(want) {
        assert!((is - want).abs() < 0.03, "{is} for {want}: {tilt_rad} towards {towards_rad}");
    }
    bench
}

#[test]
fn a_tilted_start_is_met_in_its_own_direction_only() {
    const AWAY: f32 = GATE_TILT_RAD + 0.04;
    for heading in [0.0_f32, core::f32::consts::FRAC_PI_2, 2.1] {
        for theta in [0.4_f32, -0.4] {
            let table = tilted(theta, heading);
            for (tilt, towards, met) in [
                (theta, heading, true),
                (-theta, heading + core::f32::consts::PI, true),
                (theta + 0.08, heading, true),
                (theta - 0.08, heading, true),
                // The mirrored one, level, a little too much and too little, and in other planes.
                (-theta, heading, false),
                (0.0, heading, false),
                (theta + AWAY, heading, false),
                (theta - AWAY, heading, false),
                (theta, heading + 0.5, false),
                (theta, heading - 0.5, false),
                (theta, heading + core::f32::consts::FRAC_PI_2, false),
                (theta, -heading - 0.7, false),
            ] {
                let mut bench = leaning(&table, tilt, towards);
                let reply = bench.ask(Request::Trigger { checksum: table.checksum() });
                let want = if met { Reply::Done } else { Reply::Refused(Refusal::OutsideGate) };
                assert_eq!(reply, want, "{tilt} towards {towards} for {theta} towards {heading}");
                let state = if met { FlightState::Maneuver } else { FlightState::Tracking };
                assert_eq!(bench.logic.state(), state);
            }
        }
    }
}
