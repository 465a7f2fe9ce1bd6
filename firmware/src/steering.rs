//! From the state to the motors: the setpoint of each state, and the throttles that bring it about.

use mintime_shared::messages::{FlightState, Purpose, Setpoint};
use mintime_shared::model::GRAVITY_MPS2;
use mintime_shared::real::{at_least, at_most};

use crate::config::{CONTROL_STEP_MAX_S, LIFTED_FORCE, MOTOR_COUNT};
use crate::flight::{FlightLogic, TickOutput};
use crate::mixer::{Demand, mix_below};
use crate::rate_control::RateInput;
use crate::recorder::RecordMemory;
use crate::sensing::interval_s;

/// A setpoint of so much thrust may lift, m/s².
const LIFTED_MPS2: f32 = LIFTED_FORCE * GRAVITY_MPS2 as f32;

impl<M: RecordMemory> FlightLogic<M> {
    /// What to fly until the next tick; `None` for motors that only idle or stand still.
    pub(crate) fn choose_setpoint(&mut self, now_us: u64) -> Option<Setpoint> {
        let setpoint = match self.state() {
            FlightState::Tracking => self.host_setpoint.map_or(Setpoint::default(), |(setpoint, _)| setpoint),
            FlightState::Maneuver => {
                let plane = self.player.plane();
                let command = self.player.command(now_us, &self.period);
                command.map_or(Setpoint::default(), |c| Setpoint {
                    rates_radps: plane.turn(c.rate_radps),
                    thrust_mps2: c.thrust_mps2,
                })
            }
            FlightState::Recovery => {
                let force_mps2 = self.accel_mps2.map(|[_, _, z]| z);
                let [_, _, up] = self.attitude.up_in_body();
                self.recovery.command(up, self.attitude.level_rates(), force_mps2, self.step_s())
            }
            _ => return None,
        };
        let thrust_mps2 =
            self.thrust_cap_mps2().map_or(setpoint.thrust_mps2, |cap| at_most(setpoint.thrust_mps2, cap));
        self.lifted |= thrust_mps2 >= LIFTED_MPS2;
        Some(Setpoint { thrust_mps2, ..setpoint })
    }

    /// Time since the last tick as the controllers believe it, s.
    fn step_s(&self) -> f32 {
        at_most(interval_s(self.interval_us), CONTROL_STEP_MAX_S)
    }

    /// Rate control, mixing, and what the motors get.
    pub(crate) fn control(&mut self, setpoint: Option<Setpoint>, now_us: u64) -> TickOutput {
        let dt_s = self.step_s();
        let Some(setpoint) = setpoint else {
            self.commanded = Setpoint::default();
            self.rate.rest(self.gyro.rates_radps());
            let off = self.drive.rest(&self.config, dt_s);
            let armed = self.state() == FlightState::Armed;
            let throttle = match self.purpose {
                _ if !armed => None,
                // Idle is zero demand: the mixer's floor keeps the rotors turning.
                Purpose::Flight => Some(self.drive.throttles(&self.config, off, self.drive_v, 0.0)),
                Purpose::MotorTest => Some(self.tested(now_us)),
            };
            return TickOutput { throttle, setpoint: self.commanded };
        };
        let thrust_mps2 = setpoint.thrust_mps2;
        let input = RateInput {
            asked: self.commanded.rates_radps,
            next: setpoint.rates_radps,
            measured: self.gyro.rates_radps(),
            thrust_mps2,
            dt_s,
            follow_angle: self.state() == FlightState::Maneuver,
        };
        let demand = Demand { thrust_mps2, acceleration_radps2: self.rate.update(&self.config, &input) };
        // The mixer lifts collective thrust for the sake of torque: on the bench no rotor gets more than its share.
        let high_n = self.rotor_cap_n().unwrap_or(self.config.rotor_thrust_max_n);
        let mixed = mix_below(&self.config, &demand, high_n);
        self.rate.limited(&mixed.saturation);
        let saturated = mixed.saturation.is_limit(thrust_mps2);
        self.saturated_ticks = if saturated { self.saturated_ticks.saturating_add(1) } else { 0 };
        let throttle = self.drive.throttles_below(&self.config, mixed.thrusts_n, self.drive_v, dt_s, high_n);
        self.commanded = setpoint;
        TickOutput { throttle: Some(throttle), setpoint }
    }

    /// A rotor's share of the thrust allowed, N, where it is capped.
    fn rotor_cap_n(&self) -> Option<f32> {
        let config = &self.config;
        self.thrust_cap_mps2().map(|cap_mps2| {
            at_least(cap_mps2 * config.mass_kg / MOTOR_COUNT as f32, config.rotor_thrust_idle_n)
        })
    }

    /// One motor turns for its time, the others stand.
    #[inline(never)]
    fn tested(&mut self, now_us: u64) -> [f32; MOTOR_COUNT] {
        let mut throttle = [0.0; MOTOR_COUNT];
        if let Some(test) = self.motor_test.filter(|test| now_us < test.until_us)
            && let Some(slot) = throttle.get_mut(usize::from(test.motor))
        {
            *slot = self.rotor_cap_n().map_or(test.throttle, |high_n| {
                at_most(test.throttle, self.drive.throttle_of(&self.config, high_n, self.drive_v))
            });
        }
        throttle
    }
}
