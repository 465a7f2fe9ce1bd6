//! Axes and signs, stated once.
//!
//! World frame: z up, x along the body's forward axis at the start of a maneuver, y to the left of it. A maneuver's plane
//! may have any heading in it: see [`crate::plane`].
//! Body frame: x forward, y left, z up (FLU); the gyro of the reference board is mounted so that its own axes are these.
//! Rotations are right-handed, so
//! +ω_y is **nose-down**: it turns the thrust axis from z towards x and is the paper's +θ. +ω_x rolls to the right,
//! +ω_z yaws to the left (counter-clockwise seen from above).
//!
//! Motors are numbered as on the flight controller's pads (Betaflight's "quad X"). Seen from above:
//!
//! ```text
//!        front (+x)
//!     4 ↻       ↺ 2
//!         \   /
//! left      X      right        ↻ clockwise, ↺ counter-clockwise
//! (+y)    /   \
//!     3 ↺       ↻ 1
//! ```
//!
//! A rotor that turns clockwise pushes the body counter-clockwise: +ω_z.

/// One corner of the vehicle: where it is and which way it yaws the body when its thrust grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MotorPlace {
    /// +1 in front, −1 behind.
    pub forward: i8,
    /// +1 on the left, −1 on the right.
    pub left: i8,
    /// Sign of the reaction torque about +z: +1 for a rotor that turns clockwise seen from above.
    pub yaw: i8,
}

/// Motors 1 to 4 in the order of their outputs: rear right, front right, rear left, front left.
pub const MOTORS: [MotorPlace; 4] = [
    MotorPlace { forward: -1, left: -1, yaw: 1 },
    MotorPlace { forward: 1, left: -1, yaw: -1 },
    MotorPlace { forward: -1, left: 1, yaw: -1 },
    MotorPlace { forward: 1, left: 1, yaw: 1 },
];
