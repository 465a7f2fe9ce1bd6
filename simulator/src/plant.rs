//! The vehicle in motion: which equations apply, the ground under it, and the turns it has made.

use nalgebra::{UnitQuaternion, Vector3};

use crate::{
    parameters::{Ground, Model, VehicleParameters},
    planning::{self, RATE_MAX_RADPS, THRUST_MAX_MPS2},
    rigid_body::{BodyState, RigidBody},
    simulator::Command,
    truth::{Contact, Truth, nearest_turn},
};

/// The physical vehicle, without sensors.
#[derive(Clone, Debug)]
pub(crate) struct Plant {
    model: Model,
    body: RigidBody,
    ground: Ground,
    ground_z_m: f64,
    gravity_mps2: f64,
    state: BodyState,
    /// Throttles as applied, each 0 to 1.
    throttle: [f64; 4],
    /// Commands of the planning model, held inside its range.
    rates: Vector3<f64>,
    thrust_mps2: f64,
    on_ground: bool,
    crashed: bool,
    contacts: u32,
    last_contact: Option<Contact>,
    turn_rad: [f64; 2],
}

impl Plant {
    /// A vehicle at rest, level, with its rotors stopped; on the ground unless it starts above it.
    pub(crate) fn new(
        parameters: &VehicleParameters,
        seed: u64,
        ground_z_m: f64,
        position: Vector3<f64>,
        heading_rad: f64,
    ) -> Self {
        Self {
            model: parameters.model,
            body: RigidBody::new(parameters, seed),
            ground: parameters.ground.clone(),
            ground_z_m,
            gravity_mps2: parameters.gravity_mps2,
            state: BodyState::at_rest(position, level(heading_rad), parameters.battery.charge),
            throttle: [0.0; 4],
            rates: Vector3::zeros(),
            thrust_mps2: 0.0,
            on_ground: position.z <= ground_z_m,
            crashed: false,
            contacts: 0,
            last_contact: None,
            turn_rad: [0.0; 2],
        }
    }

    /// Takes another attitude at once, at rest in the air, and counts its turns afresh.
    pub(crate) fn let_go(&mut self, attitude: UnitQuaternion<f64>) {
        self.state.attitude = attitude.into_inner();
        self.state.velocity = Vector3::zeros();
        self.state.rates = Vector3::zeros();
        self.turn_rad = [0.0; 2];
        self.count_turns();
    }

    /// Takes a command. Whatever is not a number counts as zero; whatever is out of range is cut off.
    pub(crate) fn apply(&mut self, command: &Command) {
        let within = |value: f32, low: f64, high: f64| {
            if value.is_nan() { 0.0 } else { f64::from(value).clamp(low, high) }
        };
        self.throttle = command.throttle.map(|u| within(u, 0.0, 1.0));
        let motors_off = self.throttle.iter().all(|u| *u == 0.0);
        self.thrust_mps2 = if motors_off { 0.0 } else { within(command.thrust_mps2, 0.0, THRUST_MAX_MPS2) };
        self.rates = if motors_off {
            Vector3::zeros()
        } else {
            Vector3::from(command.rates_radps.map(|w| within(w, -RATE_MAX_RADPS, RATE_MAX_RADPS)))
        };
        self.follow_rates();
    }

    /// In the planning model body rates follow their command at once.
    fn follow_rates(&mut self) {
        if self.model == Model::Planning {
            self.state.rates = if self.on_ground { Vector3::zeros() } else { self.rates };
        }
    }

    /// A short time passes, at the end of which it is `now_ns`. Dead rotors get no throttle.
    pub(crate) fn step(&mut self, step_s: f64, now_ns: u64, dead_rotors: [bool; 4]) {
        if self.on_ground && !self.crashed && self.lifts() {
            self.on_ground = false;
            self.follow_rates();
        }
        let next = match self.model {
            Model::RigidBody => {
                let throttle = core::array::from_fn(|i| if dead_rotors[i] { 0.0 } else { self.throttle[i] });
                self.body.step(&self.state, &throttle, self.on_ground, step_s)
            }
            Model::Planning if self.on_ground => self.state,
            Model::Planning => planning::step(&self.state, self.thrust_mps2, self.gravity_mps2, step_s),
        };
        if next.is_sound() {
            self.state = next;
        } else {
            // Parameters at the edge of what is accepted can spin a body up without bound. That is a crash too.
            self.crashed = true;
            self.rest(self.state.rotation());
        }
        if !self.on_ground && self.state.position.z <= self.ground_z_m && self.state.velocity.z < 0.0 {
            self.touch_down(now_ns);
        }
        self.count_turns();
    }

    /// Whether the forces carry the vehicle off the ground.
    fn lifts(&self) -> bool {
        let force = match self.model {
            Model::RigidBody => self.body.specific_force(&self.state),
            Model::Planning => Vector3::z() * self.thrust_mps2,
        };
        (self.state.rotation() * force).z > self.gravity_mps2
    }

    fn touch_down(&mut self, now_ns: u64) {
        let attitude = self.state.rotation();
        let up = attitude * Vector3::z();
        let tilt_rad = libm::atan2(libm::hypot(up.x, up.y), up.z);
        let speed_mps = -self.state.velocity.z;
        let crash = speed_mps > self.ground.crash_speed_mps || tilt_rad > self.ground.crash_tilt_rad;
        self.contacts = self.contacts.saturating_add(1);
        self.last_contact = Some(Contact { time_ns: now_ns, speed_mps, tilt_rad, crash });
        self.crashed |= crash;
        self.state.position.z = self.ground_z_m;
        let forward = attitude * Vector3::x();
        // Landed upright it settles level on its feet; crashed it lies as it fell.
        self.rest(if crash { attitude } else { level(libm::atan2(forward.y, forward.x)) });
    }

    fn rest(&mut self, attitude: UnitQuaternion<f64>) {
        self.on_ground = true;
        self.state.velocity = Vector3::zeros();
        self.state.rates = Vector3::zeros();
        self.state.attitude = attitude.into_inner();
    }

    fn count_turns(&mut self) {
        let up = self.state.rotation() * Vector3::z();
        for (turn, component) in self.turn_rad.iter_mut().zip([up.x, up.y]) {
            *turn = nearest_turn(libm::atan2(component, up.z), *turn);
        }
    }

    /// Body rates, rad/s.
    pub(crate) fn rates(&self) -> Vector3<f64> {
        self.state.rates
    }

    /// Rotor speeds, rad/s.
    pub(crate) fn rotors(&self) -> [f64; 4] {
        self.state.rotors.into()
    }

    pub(crate) fn position(&self) -> Vector3<f64> {
        self.state.position
    }

    pub(crate) fn attitude(&self) -> UnitQuaternion<f64> {
        self.state.rotation()
    }

    /// Specific force in the body frame, m/s²: what an accelerometer at the centre of mass feels.
    pub(crate) fn specific_force(&self) -> Vector3<f64> {
        match self.model {
            _ if self.on_ground => {
                self.state.rotation().inverse_transform_vector(&(Vector3::z() * self.gravity_mps2))
            }
            Model::RigidBody => self.body.specific_force(&self.state),
            Model::Planning => Vector3::z() * self.thrust_mps2,
        }
    }

    /// Battery voltage under load, V. The planning model draws nothing.
    pub(crate) fn battery_v(&self) -> f64 {
        self.body.battery_v(&self.state)
    }

    pub(crate) fn truth(&self, time_ns: u64) -> Truth {
        let q = self.state.attitude;
        Truth {
            time_ns,
            position_m: self.state.position.into(),
            velocity_mps: self.state.velocity.into(),
            attitude: [q.w, q.i, q.j, q.k],
            rates_radps: self.state.rates.into(),
            rotor_speeds_radps: self.state.rotors.into(),
            thrust_mps2: match self.model {
                Model::RigidBody => self.body.thrust_mps2(&self.state),
                Model::Planning => self.thrust_mps2,
            },
            battery_v: self.battery_v(),
            on_ground: self.on_ground,
            crashed: self.crashed,
            contacts: self.contacts,
            last_contact: self.last_contact,
            turn_rad: self.turn_rad,
        }
    }
}

/// Level, with the body x axis at a heading (rad from world x towards world y).
fn level(heading_rad: f64) -> UnitQuaternion<f64> {
    planning::turned(UnitQuaternion::identity(), Vector3::z() * heading_rad)
}
