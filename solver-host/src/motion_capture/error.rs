//! Why a pose cannot be had or cannot be believed.

/// What is wrong with motion capture. Every text says what to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CaptureError {
    /// Not the name of a source.
    #[error(
        "{spec:?} is no source of poses: give udp:ADDRESS:PORT to listen on, such as udp:0.0.0.0:5005, or - for standard input"
    )]
    Name {
        /// What was given.
        spec: String,
    },
    /// The address cannot be listened on.
    #[error(
        "poses cannot be received at {spec} ({reason}): choose a free port and an address of this computer"
    )]
    Listen {
        /// Where.
        spec: String,
        /// What the system said.
        reason: String,
    },
    /// The sender closed its end, or reading failed.
    #[error("the source of poses has ended ({reason}): start it again")]
    Ended {
        /// What the system said.
        reason: String,
    },
    /// A line that is too long to be a pose.
    #[error("a line of {length} bytes is no pose: send one JSON object of at most {most} bytes a line", most = super::MAX_LINE_BYTES)]
    TooLong {
        /// Its length.
        length: usize,
    },
    /// Not the JSON that is expected.
    #[error("a pose cannot be read ({reason}): the format is in docs/motion-capture.md")]
    Format {
        /// What the parser said.
        reason: String,
    },
    /// A number that cannot be a time or a place.
    #[error("{field} = {value} is out of range: seconds and metres are meant")]
    Range {
        /// Which.
        field: &'static str,
        /// What it was.
        value: f64,
    },
    /// A quaternion that is no rotation.
    #[error("attitude_wxyz has the norm {norm:.4}: send a unit quaternion, w first")]
    NotUnit {
        /// Its norm.
        norm: f64,
    },
    /// Two bodies, and nobody said which one flies.
    #[error("poses of {first:?} and {second:?} arrive: say which one flies with --mocap-name")]
    SeveralBodies {
        /// One.
        first: String,
        /// The other.
        second: String,
    },
    /// The capture's clock did not go forward.
    #[error(
        "the capture's clock went from {before_s:.6} s to {after_s:.6} s: send poses in order, each with the time of its picture"
    )]
    Backwards {
        /// Newest time before.
        before_s: f64,
        /// Time of this one.
        after_s: f64,
    },
    /// Nothing arrives.
    #[error(
        "no pose for {silent_s:.2} s: check the cameras, the network, and whether the vehicle is in view"
    )]
    Stale {
        /// For how long.
        silent_s: f64,
    },
    /// The very same pose again and again in flight.
    #[error("the capture repeats one pose for {frozen_s:.2} s: its server has stopped tracking, restart it")]
    Frozen {
        /// For how long.
        frozen_s: f64,
    },
    /// The vehicle cannot have moved so far.
    #[error(
        "the pose jumped {distance_m:.2} m in {interval_s:.4} s: markers are mixed up or another body is tracked"
    )]
    PositionJump {
        /// How far.
        distance_m: f64,
        /// In how long.
        interval_s: f64,
    },
    /// The vehicle cannot have turned so far.
    #[error(
        "the attitude jumped {angle_rad:.2} rad in {interval_s:.4} s: the markers' pattern is symmetric or partly hidden"
    )]
    AttitudeJump {
        /// How far.
        angle_rad: f64,
        /// In how long.
        interval_s: f64,
    },
    /// Outside the room that was declared.
    #[error(
        "the vehicle is outside the room: {axis} = {value_m:.2} m is not within {least_m:.2} to {most_m:.2} m"
    )]
    OutsideRoom {
        /// Which axis.
        axis: char,
        /// Where it is.
        value_m: f64,
        /// Least allowed.
        least_m: f64,
        /// Greatest allowed.
        most_m: f64,
    },
}
