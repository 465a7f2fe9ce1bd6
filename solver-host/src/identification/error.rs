//! Why a vehicle cannot be identified, and what to do.

use mintime_shared::vehicle::VehicleError;

use super::{FREE_M, HEIGHT_MIN_M, HOPS_MIN, HOVER_MIN_S};

/// Why a flight says nothing about the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum IdentificationError {
    /// Hover too short.
    #[error("a hover of {hover_s:.1} s says too little: hover for {HOVER_MIN_S} to 120 s")]
    ShortHover {
        /// Its length, s.
        hover_s: f64,
    },
    /// Too few hops.
    #[error(
        "{hops} hops say too little: fly {HOPS_MIN} to 100 (each that leaves its place by too much counts as none)"
    )]
    FewHops {
        /// How many.
        hops: u32,
    },
    /// Steps that cannot be flown or seen.
    #[error(
        "steps must be 0.5 to 4 m/s² high and 0.05 to 0.25 s long: 2 m/s² for 0.15 s is seen well and leads 5 cm"
    )]
    Step,
    /// Too near to the ground.
    #[error(
        "a hover at {height_m:.2} m is too low: the ground's cushion carries a part of the vehicle; give it {HEIGHT_MIN_M} m \
         at least"
    )]
    Low {
        /// Height, m.
        height_m: f64,
    },
    /// Walls or ceiling too near.
    #[error("the room is too small: {free_m:.2} m are free on one side of the hover, {FREE_M} m are needed")]
    Room {
        /// Free there, m.
        free_m: f64,
    },
    /// Carried away.
    #[error(
        "the vehicle was carried {drift_m:.2} m from its place in hover: calm the air (fans, open doors), check the balance"
    )]
    Drift {
        /// How far, m.
        drift_m: f64,
    },
    /// Leaning into something.
    #[error(
        "the vehicle hovered with a lean of {tilt_rad:.3} rad: there is wind, or its markers are askew; calm the air"
    )]
    Lean {
        /// Tilt, rad.
        tilt_rad: f64,
    },
    /// Cameras saw too little.
    #[error(
        "the cameras gave {poses} poses where {needed} are needed: check that they see the vehicle all the way"
    )]
    Poses {
        /// Came.
        poses: u32,
        /// Needed.
        needed: u32,
    },
    /// The thrust that hovers wandered.
    #[error(
        "the thrust scale is known to {:.2} % only: the command that hovers wanders; calm the air, hover longer (--hover)",
        std * 100.0
    )]
    ScaleUncertain {
        /// Standard error.
        std: f64,
    },
    /// The hops do not look like a rotor's.
    #[error(
        "the hops' paths depart from the model by {:.1} mm: check the cameras' calibration and the link, fly in calm air",
        residual_m * 1e3
    )]
    Residual {
        /// Root of the mean square, m.
        residual_m: f64,
    },
    /// Lag not seen well enough.
    #[error("the rotor lag is known to {:.1} ms only: fly more hops (--hops) or higher steps (--step)", std_s * 1e3)]
    LagUncertain {
        /// Standard error, s.
        std_s: f64,
    },
    /// No lag fits.
    #[error(
        "no rotor lag between 2 and 150 ms explains the hops: check that poses carry the time of their picture, and the link's delay"
    )]
    NoLag,
    /// What was found is no vehicle.
    #[error(
        "what was found makes no usable vehicle file ({0}): check mass and rotors in the file on the vehicle first"
    )]
    Vehicle(#[from] VehicleError),
}
