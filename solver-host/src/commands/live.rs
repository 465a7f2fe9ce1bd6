//! `mintime fly --vehicle PORT`: a real vehicle and real cameras.

use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Args;
use mintime::flight::{Connection as _, ConnectionError, FlightPlan, Phase, Pose, Trace, Witness, fly};
use mintime::mission::{Flown, Mission, Prepared, Room, prepare_for};
use mintime::motion_capture::{Capture, CaptureOptions, Volume};
use mintime::vehicle::{LiveOptions, LiveVehicle, PortLink, Session, read_key};
use nalgebra::Vector3;

use super::keyboard::Keyboard;

/// What a flight of a real vehicle needs besides.
#[derive(Args)]
pub(crate) struct LiveArguments {
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

impl LiveArguments {
    /// Whether any of them was given.
    pub(crate) fn are_given(&self) -> bool {
        self.mocap.is_some()
    }

    /// Asks the vehicle what it is, and plans for it. Nothing moves.
    pub(crate) fn prepare(&self, port: &str, mission: &Mission) -> Result<Live, Box<dyn Error>> {
        if self.mocap.is_none() {
            return Err("a real vehicle needs eyes: say where poses come from with --mocap".into());
        }
        if !(0.0..=0.2).contains(&self.mocap_latency) {
            return Err("--mocap-latency must be between 0 and 0.2 s".into());
        }
        let room = mission.room.filter(|room| room.y_m.is_some()).ok_or(
            "a real vehicle flies only in a room that is known: give --room with six numbers, \
             XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX from the start of the maneuver",
        )?;
        let key = self.key.as_deref().map(read_key).transpose()?;
        let mut session = Session::begin(PortLink::open(port)?, key)?;
        let config = session.vehicle()?.ok_or(
            "the vehicle does not know what it is: write its file with `mintime vehicle PORT params --file` first",
        )?;
        let prepared = prepare_for(&mission.source, Some(&room), &config)?;
        Ok(Live { link: session.into_link(), prepared, room, key })
    }

    /// Flies. The vehicle stands below the start; the start is above it by the room's depth.
    pub(crate) fn fly(&self, live: Live, witness: &mut impl Witness) -> Result<Flown, Box<dyn Error>> {
        let Live { link, prepared, room, key } = live;
        let clock = Instant::now();
        let source = self.mocap.as_deref().unwrap_or_default();
        let options =
            CaptureOptions { name: self.mocap_name.clone(), room: None, latency_s: self.mocap_latency };
        let capture = Capture::open(source, options, link.began())?;
        let stop = Arc::new(AtomicBool::new(false));
        let keyboard = Keyboard::watch(&stop)?;
        let keys = if keyboard.hears() { "any key" } else { "Ctrl-C" };
        eprintln!("mintime: {keys} switches the motors off; the vehicle then falls");
        let maneuver_s = f64::from(prepared.table.duration_s());
        let mut vehicle = LiveVehicle::new(link, capture, LiveOptions { maneuver_s, stop, key });

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
        let plan = FlightPlan { table: prepared.table.clone(), start_m, vehicle: None };
        let flight = fly(&mut vehicle, &plan, witness);
        drop(keyboard);
        let wall_time_s = clock.elapsed().as_secs_f64();
        Ok(Flown {
            prepared,
            flight,
            vehicle: "real",
            emulated: None,
            trace: Trace::default(),
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
