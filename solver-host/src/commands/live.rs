//! `mintime fly --vehicle PORT`: a real vehicle and real cameras.

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use mintime::flight::{Connection as _, ConnectionError, FlightPlan, Phase, Pose, Witness, fly};
use mintime::mission::{Flown, Mission, Prepared, Room, prepare_for};
use mintime::motion_capture::{Capture, CaptureOptions, Volume};
use mintime::vehicle::{LiveOptions, LiveVehicle, PortLink, Session, read_key};
use mintime_shared::vehicle::VehicleConfig;
use nalgebra::Vector3;

use super::keyboard::Keyboard;
use super::seen::Seen;

/// Where a real vehicle is seen.
#[derive(Args)]
pub(crate) struct MocapArguments {
    /// Where poses come from, for a real vehicle: JSON lines over UDP (udp:ADDRESS:PORT to listen on) or standard input (-).
    /// The format is in docs/motion-capture.md
    #[arg(long, value_name = "udp:0.0.0.0:5005|-")]
    mocap: Option<String>,
    /// The body that flies, where motion capture sends several
    #[arg(long, value_name = "NAME", requires = "mocap")]
    mocap_name: Option<String>,
    /// Shortest time from the cameras' picture until its pose is here, s
    #[arg(long, value_name = "S", default_value_t = 0.005, requires = "mocap")]
    mocap_latency: f64,
}

/// What a flight of a real vehicle needs besides.
#[derive(Args)]
pub(crate) struct LiveArguments {
    #[command(flatten)]
    eyes: MocapArguments,
    /// The pairing key, where the vehicle is paired: a file with 32 hexadecimal digits
    #[arg(long, value_name = "FILE", requires = "mocap")]
    key: Option<PathBuf>,
}

/// What is flown where.
pub(crate) struct Live {
    link: PortLink,
    prepared: Prepared,
    room: Room,
    key: Option<[u8; 16]>,
}

impl Live {
    pub(crate) fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    pub(crate) fn prepared_mut(&mut self) -> &mut Prepared {
        &mut self.prepared
    }
}

impl MocapArguments {
    /// Whether any of them was given.
    pub(crate) fn are_given(&self) -> bool {
        self.mocap.is_some()
    }

    /// What can be refused before anything is opened. Returns the room, which must be known on all sides.
    pub(crate) fn check(&self, room: Option<Room>) -> Result<Room, Box<dyn Error>> {
        if self.mocap.is_none() {
            return Err("a real vehicle needs eyes: say where poses come from with --mocap".into());
        }
        if !(0.0..=0.2).contains(&self.mocap_latency) {
            return Err("--mocap-latency must be between 0 and 0.2 s".into());
        }
        let known = room.filter(|room| room.y_m.is_some()).ok_or(
            "a real vehicle flies only in a room that is known: give --room with six numbers, \
             XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX from the start of the maneuver",
        )?;
        Ok(known)
    }

    /// Opens the cameras and the keyboard, finds the vehicle and confines it to the room, which is seen from the start: above
    /// the vehicle by the room's depth.
    pub(crate) fn watch(
        &self,
        link: PortLink,
        options: LiveOptions,
        room: &Room,
    ) -> Result<Watched, Box<dyn Error>> {
        let source = self.mocap.as_deref().unwrap_or_default();
        let capture =
            CaptureOptions { name: self.mocap_name.clone(), room: None, latency_s: self.mocap_latency };
        let capture = Capture::open(source, capture, link.began())?;
        let keyboard = Keyboard::watch(&options.stop)?;
        let keys = if keyboard.hears() { "any key" } else { "Ctrl-C" };
        eprintln!("mintime: {keys} switches the motors off; the vehicle then falls");
        let mut vehicle = LiveVehicle::new(link, capture, options);

        let ground = first_pose(&mut vehicle)?.position_m;
        let start_m = ground - Vector3::z() * room.z_m.0;
        let around = |centre_m: f64, (low, high): (f64, f64)| (centre_m + low, centre_m + high);
        let (low, high) = around(start_m.z, room.z_m);
        vehicle.confine(Volume {
            range_m: [
                around(start_m.x, room.x_m),
                around(start_m.y, room.y_m.unwrap_or((f64::NEG_INFINITY, f64::INFINITY))),
                // The floor is where it stands: cameras have noise.
                (low - FLOOR_MARGIN_M, high),
            ],
        });
        Ok(Watched { vehicle, start_m, _keyboard: keyboard })
    }
}

/// A real vehicle that is seen, while a key stops it.
pub(crate) struct Watched {
    pub(crate) vehicle: LiveVehicle,
    /// Where the maneuver starts, world frame, m.
    pub(crate) start_m: Vector3<f64>,
    _keyboard: Keyboard,
}

impl Watched {
    /// The link, for somebody else; keys mean nothing any more.
    pub(crate) fn into_link(self) -> PortLink {
        self.vehicle.into_link()
    }
}

/// A vehicle that has said what it is.
struct Asked {
    link: PortLink,
    config: VehicleConfig,
    key: Option<[u8; 16]>,
}

impl LiveArguments {
    /// Asks the vehicle what it is and finds it with the cameras, for several flights in a row. Nothing moves. Returns the
    /// vehicle, what it is, and the room.
    pub(crate) fn watch(
        &self,
        port: &str,
        room: Option<Room>,
    ) -> Result<(Watched, VehicleConfig, Room), Box<dyn Error>> {
        let room = self.eyes.check(room)?;
        let Asked { link, config, key } = self.ask(port)?;
        let options = LiveOptions { key, ..LiveOptions::default() };
        Ok((self.eyes.watch(link, options, &room)?, config, room))
    }

    /// The link to a vehicle that knows what it is.
    fn ask(&self, port: &str) -> Result<Asked, Box<dyn Error>> {
        let key = self.key.as_deref().map(read_key).transpose()?;
        let mut session = Session::begin(PortLink::open(port)?, key)?;
        let config = session.vehicle()?.ok_or(
            "the vehicle does not know what it is: write its file with `mintime vehicle PORT params --file` first",
        )?;
        Ok(Asked { link: session.into_link(), config, key })
    }

    /// Whether any of them was given.
    pub(crate) fn are_given(&self) -> bool {
        self.eyes.are_given()
    }

    /// Asks the vehicle what it is, and plans for it. Nothing moves.
    pub(crate) fn prepare(&self, port: &str, mission: &Mission) -> Result<Live, Box<dyn Error>> {
        let room = self.eyes.check(mission.room)?;
        let Asked { link, config, key } = self.ask(port)?;
        let prepared = prepare_for(&mission.source, Some(&room), &config)?;
        Ok(Live { link, prepared, room, key })
    }

    /// Flies. The vehicle stands below the start; the start is above it by the room's depth.
    pub(crate) fn fly(&self, live: Live, witness: &mut impl Witness) -> Result<Flown, Box<dyn Error>> {
        let Live { link, prepared, room, key } = live;
        let clock = Instant::now();
        let maneuver_s = f64::from(prepared.table.duration_s());
        let options = LiveOptions { maneuver_s, key, ..LiveOptions::default() };
        let mut watched = self.eyes.watch(link, options, &room)?;
        let plan = FlightPlan::new(prepared.table.clone(), watched.start_m, None).along(prepared.heading_rad);
        let mut seen = Seen::new(witness, prepared.heading_rad);
        let flight = fly(&mut watched.vehicle, &plan, &mut seen);
        let trace = seen.into_trace();
        drop(watched);
        let wall_time_s = clock.elapsed().as_secs_f64();
        Ok(Flown {
            prepared,
            flight,
            vehicle: "real",
            emulated: None,
            trace,
            virtual_time_s: wall_time_s,
            wall_time_s,
        })
    }
}

/// A vehicle that stands may seem to stand this much below where it was seen first, m.
const FLOOR_MARGIN_M: f64 = 0.1;

/// Where the vehicle stands.
fn first_pose(vehicle: &mut LiveVehicle) -> Result<Pose, ConnectionError> {
    vehicle.enter(Phase::Prepare);
    loop {
        match vehicle.next_pose() {
            Err(ConnectionError::Blind) => {}
            pose => return pose,
        }
    }
}
