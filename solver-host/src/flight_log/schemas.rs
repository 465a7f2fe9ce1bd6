//! The topics of a flight log and the JSON schema of each. The `foxglove.*` schemas are the published ones of
//! <https://docs.foxglove.dev/docs/sdk/schemas>, so that Foxglove's 3D, map and log panels know them.

use serde_json::{Value, json};

/// One topic. At equal times messages are in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Topic {
    Tf,
    Truth,
    Mocap,
    Gyro,
    Setpoint,
    Motors,
    Battery,
    Plan,
    Record,
    Events,
}

impl Topic {
    pub(super) const ALL: [Self; 10] = [
        Self::Tf,
        Self::Truth,
        Self::Mocap,
        Self::Gyro,
        Self::Setpoint,
        Self::Motors,
        Self::Battery,
        Self::Plan,
        Self::Record,
        Self::Events,
    ];

    /// Topic name, schema name.
    pub(super) fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Tf => ("/tf", "foxglove.FrameTransform"),
            Self::Truth => ("/truth", "mintime.Truth"),
            Self::Mocap => ("/mocap", "foxglove.PoseInFrame"),
            Self::Gyro => ("/gyro", "mintime.BodyRates"),
            Self::Setpoint => ("/setpoint", "mintime.Setpoint"),
            Self::Motors => ("/motors", "mintime.Motors"),
            Self::Battery => ("/battery", "mintime.Battery"),
            Self::Plan => ("/plan", "mintime.Plan"),
            Self::Record => ("/record", "mintime.Record"),
            Self::Events => ("/events", "foxglove.Log"),
        }
    }

    /// JSON schema of its messages.
    pub(super) fn schema(self) -> Value {
        let (_, name) = self.names();
        match self {
            Self::Tf => object(
                name,
                "A transform between two reference frames in 3D space",
                &[
                    ("timestamp", time()),
                    ("parent_frame_id", string("Name of the parent frame")),
                    ("child_frame_id", string("Name of the child frame")),
                    ("translation", vector("Position of the child frame's origin in the parent frame, m")),
                    ("rotation", quaternion("Attitude of the child frame in the parent frame")),
                ],
            ),
            Self::Truth => object(
                name,
                "True motion of the vehicle, in space and in the plane of the maneuver",
                &[
                    ("phase", string("Phase of the flight")),
                    ("position_m", vector("World frame: x along the maneuver's plane, y left, z up; m")),
                    ("velocity_mps", vector("World frame, m/s")),
                    ("attitude", quaternion("Body to world; body x forward, y left, z up")),
                    ("body_rates", rates("Body frame, rad/s")),
                    ("thrust_mps2", number("Collective thrust per mass, m/s²")),
                    ("planar", state()),
                ],
            ),
            Self::Mocap => object(
                name,
                "A timestamped pose for an object or reference frame in 3D space",
                &[
                    ("timestamp", time()),
                    ("frame_id", string("Frame of reference for pose position and orientation")),
                    (
                        "pose",
                        object(
                            "foxglove.Pose",
                            "Pose in 3D space",
                            &[
                                ("position", vector("Point denoting position in 3D space")),
                                ("orientation", quaternion("Quaternion denoting orientation in 3D space")),
                            ],
                        ),
                    ),
                ],
            ),
            Self::Gyro => rates("What the vehicle's gyro delivered, rad/s, body frame"),
            Self::Setpoint => object(
                name,
                "What the rate controller was asked for",
                &[
                    ("rates", rates("Commanded body rates, rad/s")),
                    ("thrust_mps2", number("Commanded collective thrust per mass, m/s²")),
                ],
            ),
            Self::Motors => object(name, "Commands to the motors", &[("throttle", throttle())]),
            Self::Battery => object(name, "Battery", &[("voltage_v", number("Voltage, V"))]),
            Self::Plan => object(
                name,
                "The planned maneuver, relative to its start",
                &[
                    ("t_s", number("Time from the start of the maneuver, s")),
                    ("state", state()),
                    ("rate_radps", number("Pitch rate, rad/s")),
                    ("thrust_mps2", number("Collective thrust per mass, m/s²")),
                    (
                        "phi_r",
                        number("Switching function of the pitch rate, dimensionless; null if there is none"),
                    ),
                    (
                        "phi_t",
                        number("Switching function of the thrust, dimensionless; null if there is none"),
                    ),
                ],
            ),
            Self::Record => object(
                name,
                "One tick of the record that the vehicle keeps, by the vehicle's own clock",
                &[
                    ("t_us", number("Time since the record's first tick, µs")),
                    ("gyro", rates("Measured body rates, rad/s")),
                    ("commanded_rate_radps", number("Commanded pitch rate, rad/s")),
                    ("commanded_thrust_mps2", number("Commanded collective thrust per mass, m/s²")),
                    ("throttle", throttle()),
                ],
            ),
            Self::Events => object(
                name,
                "A log message",
                &[
                    ("timestamp", time()),
                    ("level", log_level()),
                    ("message", string("Log message")),
                    ("name", string("Process or node name")),
                    ("file", string("Filename")),
                    (
                        "line",
                        json!({"type": "integer", "minimum": 0, "description": "Line number in the file"}),
                    ),
                ],
            ),
        }
    }
}

fn object(title: &str, description: &str, properties: &[(&str, Value)]) -> Value {
    let required: Vec<&str> = properties.iter().map(|(name, _)| *name).collect();
    let properties: serde_json::Map<String, Value> =
        properties.iter().map(|(name, schema)| ((*name).to_owned(), schema.clone())).collect();
    json!({
        "title": title,
        "description": description,
        "type": "object",
        "properties": properties,
        "required": required,
    })
}

fn number(description: &str) -> Value {
    json!({"type": "number", "description": description})
}

fn string(description: &str) -> Value {
    json!({"type": "string", "description": description})
}

fn time() -> Value {
    json!({
        "type": "object",
        "title": "time",
        "description": "Virtual time from the start of the flight",
        "properties": {
            "sec": {"type": "integer", "minimum": 0},
            "nsec": {"type": "integer", "minimum": 0, "maximum": 999_999_999},
        },
    })
}

fn vector(description: &str) -> Value {
    object("foxglove.Vector3", description, &[("x", number("x")), ("y", number("y")), ("z", number("z"))])
}

fn quaternion(description: &str) -> Value {
    let parts = [("x", number("x")), ("y", number("y")), ("z", number("z")), ("w", number("w"))];
    object("foxglove.Quaternion", description, &parts)
}

fn rates(description: &str) -> Value {
    let parts = [
        ("roll_radps", number("About x (forward), rad/s")),
        ("pitch_radps", number("About y (left), positive nose-down, rad/s")),
        ("yaw_radps", number("About z (up), rad/s")),
    ];
    object("mintime.BodyRates", description, &parts)
}

fn state() -> Value {
    let parts = [
        ("x", number("Horizontal position, m")),
        ("vx", number("Horizontal velocity, m/s")),
        ("z", number("Vertical position, m")),
        ("vz", number("Vertical velocity, m/s")),
        ("theta", number("Pitch, unwrapped, positive towards +x, rad")),
    ];
    object("mintime.PlanarState", "Motion in the plane of the maneuver", &parts)
}

fn throttle() -> Value {
    json!({
        "type": "array",
        "description": "Throttle of motors 1 to 4 (rear right, front right, rear left, front left), 0 to 1",
        "items": {"type": "number"},
    })
}

fn log_level() -> Value {
    let levels = ["UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"];
    let levels: Vec<Value> =
        levels.iter().zip(0..).map(|(title, number)| json!({"title": title, "const": number})).collect();
    json!({"title": "foxglove.LogLevel", "description": "Log level", "oneOf": levels})
}
