//! What rotors of a given lag make of the thrust commanded, seen through the firmware's own rotor drive.
//!
//! The firmware does not send the thrust it is asked for: it overshoots by a lead, computed from the lag in its vehicle file
//! (`mintime_firmware::mixer::RotorDrive`). With the file's lag τ_f, the response it aims at ε and the vehicle's lag τ, speed
//! follows its wish as (1 + τ_f s) / ((1 + ε s)(1 + τ s)). So the drive is run here exactly as the vehicle runs it, and only
//! the rotor behind it is unknown.

use mintime_firmware::config::ROTOR_RESPONSE_S;
use mintime_shared::replay::TICK_PERIOD_US;
use mintime_shared::vehicle::{MOTOR_COUNT, VehicleConfig};

/// Thrust per mass commanded from a time on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Command {
    pub(super) time_s: f64,
    pub(super) thrust_mps2: f64,
    /// Cosine of the tilt: what part of it is vertical.
    pub(super) upright: f64,
}

/// Where the vehicle is at one instant by its commands alone, less the steady climb that the mean command would give.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) time_s: f64,
    /// Departure of vertical thrust per mass from the base, m/s².
    pub(super) acceleration_mps2: f64,
    /// Its integral, m/s, ...
    pub(super) velocity_mps: f64,
    /// ... the integral of that, m, ...
    pub(super) position_m: f64,
    /// ... and of that, m s.
    pub(super) area_ms: f64,
}

/// Drive and rotor of one airframe.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drive {
    /// Thrust per mass at full throttle, m/s².
    full_mps2: f64,
    /// The lag of the vehicle file, s.
    file_lag_s: f64,
    lead: f64,
    idle: f64,
}

impl Drive {
    pub(super) fn new(file: &VehicleConfig) -> Self {
        let file_lag_s = f64::from(file.rotor_lag_s);
        Self {
            full_mps2: f64::from(file.rotor_thrust_max_n) * MOTOR_COUNT as f64 / f64::from(file.mass_kg),
            file_lag_s,
            lead: (file_lag_s / f64::from(ROTOR_RESPONSE_S)).max(1.0),
            idle: f64::from(file.rotor_thrust_idle_n / file.rotor_thrust_max_n).sqrt(),
        }
    }

    /// The motion that commands make with rotors of a lag, relative to a steady thrust, from the first command until
    /// `end_s`. Rotors have settled on the first command.
    pub(super) fn motion(&self, commands: &[Command], base_mps2: f64, end_s: f64, lag_s: f64) -> Vec<Node> {
        const TICK_S: f64 = TICK_PERIOD_US as f64 * 1e-6;
        let Some(first) = commands.first() else { return Vec::new() };
        let wish = |c: &Command| (c.thrust_mps2 / self.full_mps2).max(0.0).sqrt();
        let thrust = |speed: f64, c: &Command| speed * speed * self.full_mps2 * c.upright - base_mps2;
        let (mut model, mut rotor) = (wish(first), wish(first));
        let mut node = Node {
            time_s: first.time_s,
            acceleration_mps2: thrust(rotor, first),
            velocity_mps: 0.0,
            position_m: 0.0,
            area_ms: 0.0,
        };
        let mut nodes = vec![node];
        let ends = commands.iter().skip(1).map(|c| c.time_s).chain([end_s]);
        for (command, until_s) in commands.iter().zip(ends) {
            while node.time_s < until_s - 1e-9 {
                // A new command is taken as a new tick: what that is early is part of the dead time.
                let dt = TICK_S.min(until_s - node.time_s);
                let throttle = (model + self.lead * (wish(command) - model)).clamp(self.idle, 1.0);
                model += (dt / self.file_lag_s).min(1.0) * (throttle - model);
                rotor = throttle + (rotor - throttle) * (-dt / lag_s).exp();
                let (a, b) = (node.acceleration_mps2, thrust(rotor, command));
                node = Node {
                    time_s: node.time_s + dt,
                    acceleration_mps2: b,
                    velocity_mps: node.velocity_mps + dt * (a + b) / 2.0,
                    position_m: node.position_m + dt * (node.velocity_mps + dt * (2.0 * a + b) / 6.0),
                    area_ms: node.area_ms + dt * (node.position_m + dt * node.velocity_mps / 2.0),
                };
                nodes.push(node);
            }
        }
        nodes
    }
}

/// The motion at a time between its nodes.
pub(super) fn at(nodes: &[Node], time_s: f64) -> Option<Node> {
    let after = nodes.partition_point(|n| n.time_s <= time_s);
    let n = nodes.get(after.checked_sub(1)?)?;
    let dt = time_s - n.time_s;
    Some(Node {
        time_s,
        acceleration_mps2: n.acceleration_mps2,
        velocity_mps: n.velocity_mps + dt * n.acceleration_mps2,
        position_m: n.position_m + dt * (n.velocity_mps + dt * n.acceleration_mps2 / 2.0),
        area_ms: n.area_ms + dt * (n.position_m + dt * n.velocity_mps / 2.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_right_lag_behind_its_lead_is_the_response_the_firmware_aims_at() {
        let drive = Drive::new(&VehicleConfig::REFERENCE);
        let command = |time_s: f64, thrust_mps2| Command { time_s, thrust_mps2, upright: 1.0 };
        let commands = [command(0.0, 9.81), command(0.05, 11.81)];
        let delay = |lag_s: f64| {
            let nodes = drive.motion(&commands, 9.81, 0.5, lag_s);
            let end = at(&nodes, 0.4999).expect("within");
            // A step that comes late by d gains 2 m/s² · (t − d).
            0.4499 - end.velocity_mps / 2.0
        };
        // The first moment: the firmware's response (less half a tick, for it steps), and what the lead does not cover.
        assert!((delay(0.033) - 0.0095).abs() < 1e-3, "{}", delay(0.033));
        assert!((delay(0.050) - delay(0.033) - 0.017).abs() < 1e-3);
        assert!((delay(0.020) - delay(0.033) + 0.013).abs() < 1e-3);
    }
}
