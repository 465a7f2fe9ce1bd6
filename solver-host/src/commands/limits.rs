//! The options that say what a vehicle can do, and how it may turn.

use clap::Args;
use mintime::solver::Turns;
use mintime_shared::model::Limits;

use super::numbers;

/// Limits and windings, the same for every command that plans.
#[derive(Args)]
pub(crate) struct PlanArguments {
    /// Planned collective thrust per mass, m/s²
    #[arg(long, value_name = "MIN,MAX", value_parser = numbers::list::<2>, allow_hyphen_values = true,
          default_value = "1,20")]
    thrust_per_mass: [f64; 2],
    /// Planned pitch rate, rad/s
    #[arg(long, value_name = "W", value_parser = numbers::finite, allow_hyphen_values = true,
          default_value = "10")]
    max_body_rate: f64,
    /// Full turns k on the way; the end angle is θ_T + 2πk: a whole number, or `any` for the fastest
    #[arg(long, value_name = "K|any", value_parser = numbers::turns, allow_hyphen_values = true,
          default_value = "any")]
    pub(crate) turns: Turns,
}

impl PlanArguments {
    /// The limits with a gravity, m/s².
    pub(crate) fn limits(&self, gravity_mps2: f64) -> Limits<f64> {
        let [thrust_min_mps2, thrust_max_mps2] = self.thrust_per_mass;
        Limits { thrust_min_mps2, thrust_max_mps2, rate_max_radps: self.max_body_rate, gravity_mps2 }
    }
}
