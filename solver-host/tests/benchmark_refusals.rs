//! Flights that have no score: wrong units, motion that is no planar quadrotor's, states that do not occur, gaps.

mod logged;

use std::f64::consts::PI;
use std::fmt::Write as _;

use logged::{RATE_HZ, csv, flight, maneuver, measured};
use mintime::benchmark::{BenchmarkError, Flight, Goal, Remark, Rules, Sample, Score, read_csv, score};
use mintime_shared::model::State;

type Asked = (Flight, Option<(Goal, Goal)>, Rules);

/// The flight with its numbers multiplied, and what is asked of it.
fn scaled_by(time: f64, length: f64, speed: f64, angle: f64) -> Asked {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    for (t, State { x, vx, z, vz, theta }) in flight() {
        let cells = [t * time, x * length, vx * speed, z * length, vz * speed, theta * angle];
        let _ = writeln!(text, "{}", cells.map(|v| v.to_string()).join(","));
    }
    let rules = Rules { largest_gap_s: 1e9, dwell_s: 0.3 * time.min(1.0), ..Rules::default() };
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0 * length, 0.0, length])));
    (read_csv(text.as_bytes()).expect("CSV"), ends, rules)
}

fn scaled(time: f64, length: f64, speed: f64, angle: f64) -> Result<Score, BenchmarkError> {
    let (flight, ends, rules) = scaled_by(time, length, speed, angle);
    score(&flight, ends, &rules)
}

/// Units that a header gets wrong show in physics.
#[test]
fn confused_units_are_told() {
    assert!(scaled(1.0, 1.0, 1.0, 1.0).is_ok_and(|s| s.remarks.is_empty()));
    // Time in ms or µs, called s; the reverse; positions in mm or cm, called m.
    for (time, length) in [(1e3, 1.0), (1e6, 1.0), (1e-3, 1.0), (1.0, 1e3), (1.0, 100.0)] {
        let refused = scaled(time, length, 1.0, 1.0);
        assert!(matches!(refused, Err(BenchmarkError::Velocities { .. })), "{time} {length}: {refused:?}");
    }
    // Without velocities to contradict: consistent, and beyond any vehicle.
    for (time, length) in [(0.1, 1.0), (1.0, 100.0)] {
        let refused = scaled(time, length, length / time, 1.0);
        let thrust = matches!(refused, Err(BenchmarkError::Thrust { .. }));
        assert!(
            thrust || matches!(refused, Err(BenchmarkError::NeverThere(_))),
            "{time} {length}: {refused:?}"
        );
    }
}

/// A motion that the thrust does not explain is refused, with the reason; the option lets it through with a note, and
/// what drag explains passes without.
#[test]
fn motion_across_the_thrust_is_refused() {
    // The pitch of aeroplanes, nose up.
    let mirrored = || scaled_by(1.0, 1.0, 1.0, -1.0);
    // Time stretched a hundredfold, with the velocities that belong to it: a vehicle that tilts and does not move.
    let slow = || scaled_by(100.0, 1.0, 0.01, 1.0);
    // The pitch in degrees, called rad.
    let degrees = || scaled_by(1.0, 1.0, 1.0, 1f64.to_degrees());
    for (scaled, sign) in [(mirrored(), true), (slow(), false), (degrees(), false)] {
        let (flight, ends, rules) = scaled;
        let refused = score(&flight, ends, &rules).expect_err("no score");
        let BenchmarkError::Across { across_mps2, most_mps2, mirrored } = refused else {
            panic!("{refused}")
        };
        // 6 m/s², and what drag makes at the speed of this flight.
        let (speeds, count) = flight
            .samples()
            .iter()
            .fold((0.0, 0.0), |(sum, n), s| (sum + s.velocity_mps.norm_squared(), n + 1.0));
        let about = 6.0 + 0.4 * f64::sqrt(speeds / count);
        assert!(
            across_mps2 > most_mps2 && (most_mps2 - about).abs() < 1.5 && most_mps2 >= 6.0,
            "{refused} {about}"
        );
        assert_eq!(mirrored, sign, "{refused}");
        let told = refused.to_string();
        assert!(told.contains("--across") && told.contains("nose-down") == sign, "{told}");
        let free = Rules { across_mps2: 1e9, ..rules };
        let remarks = score(&flight, ends, &free).expect("a score").remarks;
        let noted = |r: &Remark| matches!(r, Remark::Misaligned { mirrored, .. } if *mirrored == sign);
        assert!(remarks.iter().any(noted), "{remarks:?}");
    }
}

/// A helix about the straight way: within any distance from the plane that is allowed, and yet no planar maneuver.
#[test]
fn motion_across_the_plane_is_refused() {
    let circling = |radius_m: f64| {
        let rate_radps: f64 = 12.0;
        let samples = flight().into_iter().map(|(t_s, state)| {
            let mut sample = Sample::planar(t_s, state, 0.0);
            let within = ((t_s - 0.5) / maneuver().duration_s()).clamp(0.0, 1.0);
            // Grows and shrinks smoothly, so that both ends are at rest.
            let grown = radius_m * (PI * within).sin().powi(2);
            let slope = radius_m * (2.0 * PI * within).sin() * PI / maneuver().duration_s();
            let (sin, cos) = (rate_radps * t_s).sin_cos();
            let inside = within > 0.0 && within < 1.0;
            sample.position_m.y = grown * sin;
            sample.velocity_mps.y = if inside { slope * sin + grown * rate_radps * cos } else { 0.0 };
            sample
        });
        Flight::new(samples.collect()).expect("a flight")
    };
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
    let rules = Rules { out_of_plane_m: 1.0, ..Rules::default() };
    // 144 times the radius, at its middle.
    assert!(score(&circling(0.01), ends, &rules).is_ok_and(|s| s.remarks.is_empty()));
    let refused = score(&circling(0.2), ends, &rules);
    assert!(matches!(refused, Err(BenchmarkError::Across { mirrored: false, .. })), "{refused:?}");
    assert!(score(&circling(0.2), ends, &Rules { across_mps2: 30.0, ..rules }).is_ok());
}

#[test]
fn states_that_do_not_occur_are_told_with_the_nearest() {
    let flight = read_csv(csv().as_bytes()).expect("CSV");
    let rules = Rules::default();
    let (start, end) = (Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0]));
    let never = score(&flight, Some((start, Goal::hover([4.3, 0.0, 1.0]))), &rules).expect_err("not there");
    assert!(never.to_string().contains("0.300 m"), "{never}");
    let exchanged = score(&flight, Some((end, start)), &rules).expect_err("the wrong way round");
    assert!(exchanged.to_string().contains("exchange"), "{exchanged}");
    // A tenth of a second after the arrival the log ends.
    let early = flight.window(0.0, 0.6 + maneuver().duration_s()).expect("a window");
    let cut = score(&early, Some((start, end)), &rules).map(|s| s.leg.arrival_s);
    assert!(matches!(cut, Err(BenchmarkError::NotHeld { arrived_s: Some(_), .. })), "{cut:?}");
    assert!(matches!(flight.window(9.0, 10.0), Err(BenchmarkError::Window { .. })));
    let same = score(&flight, Some((start, Goal::hover([0.05, 0.0, 0.0]))), &rules);
    assert!(matches!(same, Err(BenchmarkError::SameStates)));
}

#[test]
fn gaps_and_repeated_flights_are_told() {
    let mut text = String::from("t_s,x_m,vx_mps,z_m,vz_mps,theta_rad\n");
    let mut holed = text.clone();
    let (_, last) = *flight().last().expect("samples");
    let duration_s = flight().len() as f64 / RATE_HZ;
    for round in 0..2 {
        for (t, State { x, vx, z, vz, theta }) in flight() {
            let line = format!("{},{x},{vx},{z},{vz},{theta}\n", t + 2.0 * duration_s * f64::from(round));
            text += &line;
            if round == 0 && !(1.0..1.12).contains(&t) {
                holed += &line;
            }
        }
        // Carried back by hand, slowly.
        for i in 0..200 {
            let t = duration_s * (1.0 + f64::from(i) / 200.0 + 2.0 * f64::from(round));
            let part = 1.0 - f64::from(i) / 200.0;
            text += &format!("{t},{},{},{},{},0\n", last.x * part, -0.5, last.z * part, 0.0);
        }
    }
    let ends = Some((Goal::hover([0.0; 3]), Goal::hover([4.0, 0.0, 1.0])));
    let flight = read_csv(text.as_bytes()).expect("CSV");
    let Err(BenchmarkError::SeveralLegs(legs)) = score(&flight, ends, &Rules::default()) else {
        panic!("two flights")
    };
    assert_eq!(legs.len(), 2);
    for leg in legs {
        let part = flight.window(leg.departure_s - 0.1, leg.arrival_s + 0.6).expect("a window");
        assert!((measured(&part).score - 1.0).abs() < 5e-4);
    }
    let holed = read_csv(holed.as_bytes()).expect("CSV");
    let refused = score(&holed, ends, &Rules::default());
    assert!(matches!(refused, Err(BenchmarkError::Gap { .. })), "{refused:?}");
}
