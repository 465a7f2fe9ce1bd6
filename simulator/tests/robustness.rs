//! Whatever the parameters accept, the simulation must survive.

use mintime_simulator::{Command, Simulator, Start, VehicleParameters};
use proptest::prelude::*;
use toml::{Table, Value};

/// Multiplies the number (or each number of the vector) that a walk over the table meets in `index`-th place.
fn scale(table: &mut Table, index: &mut usize, factor: f64) {
    for (_, value) in table.iter_mut() {
        match value {
            Value::Table(inner) => scale(inner, index, factor),
            Value::Float(number) => {
                if *index == 0 {
                    *number *= factor;
                }
                *index = index.wrapping_sub(1);
            }
            Value::Array(numbers) => {
                for number in numbers.iter_mut() {
                    if let (0, Value::Float(number)) = (*index, number) {
                        *number *= factor;
                    }
                }
                *index = index.wrapping_sub(1);
            }
            _ => {}
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn extreme_vehicles_fly_or_crash_but_never_yield_nan(
        changes in prop::collection::vec((0usize..50, -12.0f64..12.0), 1..6),
        throttle in prop::array::uniform4(0.0f32..=1.0),
    ) {
        let mut table: Table = VehicleParameters::nominal().to_toml().unwrap().parse().unwrap();
        for (index, exponent) in changes {
            scale(&mut table, &mut { index }, 10.0_f64.powf(exponent));
        }
        let Ok(vehicle) = VehicleParameters::from_toml(&table.to_string()) else { return Ok(()) };
        let start = Start { height_m: 3.0, ..Start::default() };
        let mut simulator = Simulator::new(&vehicle, 1, 0.0, start).unwrap();
        simulator.apply(Command { throttle, ..Command::OFF });
        simulator.advance_to(300_000_000);
        while simulator.next_event_time_ns() <= simulator.now_ns() {
            prop_assert!(simulator.next_event().is_some());
        }
        let truth = simulator.truth();
        let numbers = [truth.position_m, truth.velocity_mps, truth.rates_radps];
        prop_assert!(numbers.iter().flatten().chain(&truth.attitude).chain(&truth.rotor_speeds_radps)
            .all(|v| v.is_finite()), "{truth:?}");
        prop_assert!(truth.battery_v.is_finite());
    }
}
