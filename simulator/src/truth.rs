//! What really happens: the state of the vehicle as no sensor sees it.

use mintime_shared::model::State;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A touch-down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// When, ns of true time.
    pub time_ns: u64,
    /// Downward speed just before, m/s.
    pub speed_mps: f64,
    /// Angle between the body z axis and the vertical just before, rad, 0 to π.
    pub tilt_rad: f64,
    /// Whether it was too fast or too tilted to survive.
    pub crash: bool,
}

/// The true state of the vehicle at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// Time, ns of true time since the start.
    pub time_ns: u64,
    /// Position of the centre of mass in the world, m.
    pub position_m: [f64; 3],
    /// Velocity in the world, m/s.
    pub velocity_mps: [f64; 3],
    /// Attitude, body to world, as a unit quaternion (w, x, y, z).
    pub attitude: [f64; 4],
    /// Body rates about the body axes x (forward), y (left), z (up), rad/s.
    pub rates_radps: [f64; 3],
    /// Speed of rotors 1 to 4, rad/s. Zero in the planning model, which has none.
    pub rotor_speeds_radps: [f64; 4],
    /// Collective thrust per mass, m/s².
    pub thrust_mps2: f64,
    /// Battery voltage under load, V.
    pub battery_v: f64,
    /// Whether the vehicle stands on the ground.
    pub on_ground: bool,
    /// Whether it has crashed. It then stays where it is.
    pub crashed: bool,
    /// Number of touch-downs so far.
    pub contacts: u32,
    /// The last touch-down.
    pub last_contact: Option<Contact>,
    /// Angles of the body z axis from world z towards world x and towards world y, rad, unwrapped since the start.
    pub(crate) turn_rad: [f64; 2],
}

impl Truth {
    /// The state in the vertical plane of a heading (rad from world x towards world y): distance along the heading,
    /// height, their velocities, and θ, the angle of the body z axis from world z towards the heading.
    ///
    /// θ is unwrapped: a full forward flip leaves 2π. Turns are counted from the start in the world's x and y planes, and
    /// a plane in between takes those of the nearer one.
    pub fn planar(&self, heading_rad: f64) -> State<f64> {
        let (sin, cos) = libm::sincos(heading_rad);
        let along = |v: [f64; 3]| v[0] * cos + v[1] * sin;
        let up = thrust_axis(self.attitude);
        let wrapped = libm::atan2(along(up), up[2]);
        let [towards_x, towards_y] = self.turn_rad;
        let counted =
            if cos.abs() >= sin.abs() { towards_x * cos.signum() } else { towards_y * sin.signum() };
        State {
            x: along(self.position_m),
            vx: along(self.velocity_mps),
            z: self.position_m[2],
            vz: self.velocity_mps[2],
            theta: nearest_turn(wrapped, counted),
        }
    }

    /// Distance to the left of the vertical plane of a heading through the world's origin, m, and its rate, m/s.
    pub fn across(&self, heading_rad: f64) -> [f64; 2] {
        let (sin, cos) = libm::sincos(heading_rad);
        [self.position_m, self.velocity_mps].map(|v| v[1] * cos - v[0] * sin)
    }

    /// Angle between the body z axis and the vertical, rad, 0 to π.
    pub fn tilt_rad(&self) -> f64 {
        let [x, y, z] = thrust_axis(self.attitude);
        libm::atan2(libm::hypot(x, y), z)
    }

    /// Heading of the body x axis, rad from world x towards world y, −π to π.
    pub fn heading_rad(&self) -> f64 {
        let x = rotation(self.attitude) * Vector3::x();
        libm::atan2(x.y, x.x)
    }
}

/// The angle that equals `wrapped` up to full turns and lies nearest to `counted`.
pub(crate) fn nearest_turn(wrapped: f64, counted: f64) -> f64 {
    wrapped + core::f64::consts::TAU * libm::round((counted - wrapped) / core::f64::consts::TAU)
}

fn rotation([w, x, y, z]: [f64; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

/// The body z axis in the world.
fn thrust_axis(attitude: [f64; 4]) -> [f64; 3] {
    (rotation(attitude) * Vector3::z()).into()
}
