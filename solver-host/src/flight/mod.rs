//! A whole flight: upload, arm, take off, hover to the gate, trigger, catch, land, download.
//!
//! The host flies by setpoints from motion capture before and after the maneuver; during it the vehicle is on its own
//! with its gyro. Setpoints keep streaming all the while, so that the vehicle falls back to them at once when the
//! maneuver ends, whether at its end or before.

mod client;
mod connection;
mod estimator;
mod hops;
mod hosted;
mod outcome;
mod position_control;
mod seal_counter;
mod virtual_board;
mod world;

pub(crate) use client::download_record;
pub use client::{Client, ClientError};
pub use connection::{Connection, ConnectionError, Line, Phase, Pose};
pub use estimator::{Calmness, Estimate, Estimator};
pub use hops::{Hop, HopFlight, HopPlan, fly_hops};
pub use hosted::HostedVehicle;
pub use outcome::{FlightError, FlightPlan, FlightResult, Outcome, Sight, Witness};
pub use position_control::{Reference, control};
pub use seal_counter::SealsUsedUp;
pub use virtual_board::{BoardReport, VirtualBoardError, VirtualVehicle};
pub use world::{Scene, Trace};

use std::time::{Duration, Instant};

use mintime_shared::messages::{
    AbortReason, ArmingBlock, FlightState, Identity, Purpose, RecordedTick, Refusal, Reply, Request,
    STAGE_CHUNK_BYTES, Setpoint,
};
use mintime_shared::replay::Plan;
use mintime_shared::table::{MAX_TABLE_BYTES, ManeuverTable, TableError};
use nalgebra::{UnitQuaternion, Vector3};

use crate::pack::for_vehicle;

/// The gate: largest tilt at which a maneuver is triggered, rad. The vehicle must stand on level ground before take-off:
/// that is where the cameras learn what level is. A tilt δθ at the start moves the end of (5, 5) by
/// 14.8 m/rad · δθ: 5 cm are 3.4 mrad.
pub const GATE_TILT_RAD: f64 = 2.0e-3;
/// The gate: largest speed at which a maneuver is triggered, m/s.
pub const GATE_SPEED_MPS: f64 = 2.0e-2;
/// The gate must hold for this long, s.
const GATE_HOLD_S: f64 = 0.3;
/// The vehicle hovers at least this long before the gate is looked at, s: the climb has died away.
const HOVER_SETTLE_S: f64 = 2.5;
/// The gate is given up after this long, s.
const GATE_TIMEOUT_S: f64 = 20.0;
/// At the gate the vehicle is where it should be within this, m.
const GATE_POSITION_M: f64 = 0.05;
/// Where the nose points all flight long, rad from world x: maneuvers go in any direction without yaw.
pub const HEADING_RAD: f64 = 0.0;
/// Speed of take-off, m/s.
const CLIMB_MPS: f64 = 1.0;
/// Speed of landing, m/s, ...
const DESCENT_MPS: f64 = 1.0;
/// ... and of its last metre, m/s.
const TOUCH_DOWN_MPS: f64 = 0.25;
/// Caught: within this of the end, m, ...
const CAUGHT_POSITION_M: f64 = 0.10;
/// ... and slower than this, m/s.
const CAUGHT_SPEED_MPS: f64 = 0.10;
/// A vehicle that is not caught by then is landed where it is, s.
const CATCH_TIMEOUT_S: f64 = 10.0;
/// Sensors settle and the gyro calibrates for this long at most, s.
const READY_TIMEOUT_S: f64 = 10.0;
/// After the trigger the vehicle reports a maneuver within this, s.
const TRIGGER_TIMEOUT_S: f64 = 0.5;
/// Height above the ground at which the motors stop, m.
const LANDED_HEIGHT_M: f64 = 0.02;
/// A touch-down takes no longer than this, s.
const LAND_TIMEOUT_S: f64 = 60.0;

/// Telemetry that is on its way while the answer to `Arm` comes may tell of the state before.
const STILL_ARMING: [FlightState; 4] =
    [FlightState::Armed, FlightState::Tracking, FlightState::Disarmed, FlightState::Calibrating];

/// How a maneuver ended.
enum Ended {
    /// At T.
    Complete,
    /// Before, by the vehicle.
    Aborted(AbortReason),
    /// It never began.
    Refused(Refusal),
}

/// Whether arming may work a moment later without anybody's doing: the gyro calibrates, the vehicle comes to rest, the
/// board's drivers start and its battery has not been measured yet. For everything else a person is asked; a vehicle must
/// not arm because somebody let go of a switch.
fn passes_by_itself(refusal: Refusal) -> bool {
    use ArmingBlock as B;
    let Refusal::ArmingBlocked(bits) = refusal else { return false };
    let mut passing = B::NOT_CALIBRATED.0 | B::MOVING.0 | B::GYRO_SILENT.0 | B::STARTING.0 | B::STORING.0;
    if bits & B::STARTING.0 != 0 {
        passing |= B::BATTERY_UNKNOWN.0;
    }
    bits & !passing == 0
}

/// A flight under way.
struct Flight<'a, C, W> {
    connection: &'a mut C,
    witness: &'a mut W,
    client: Client,
    estimator: Estimator,
    estimate: Option<Estimate>,
    calmness: Calmness,
    /// Where to be; `None` while the vehicle stands with its motors off.
    reference: Option<Reference>,
    /// The plan and when it was triggered, while the vehicle flies it.
    playing: Option<(Plan, f64)>,
    now_s: f64,
    /// Attitudes as the cameras saw them while the vehicle stood.
    standing: Vec<UnitQuaternion<f64>>,
    /// Undoes the tilt of the camera's markers on the vehicle.
    level: UnitQuaternion<f64>,
    /// The last pose that differed from the one before.
    fresh_pose: Option<Pose>,
    phase: Phase,
    /// What the vehicle was told at the last pose.
    said: Option<Setpoint>,
    /// Thrust per mass asked for instead of what position control wants, m/s²: hops are not for it to undo.
    thrust_mps2: Option<f32>,
    /// Flies back to the start before it lands.
    returns: bool,
}

/// The very same pose for this long, in the air, is not a measurement, s: cameras have noise and vehicles move.
const FROZEN_POSE_S: f64 = 0.2;
/// A vehicle that is left alone has switched off by then: its own recovery lasts 5 s at most.
const RECOVERY_TIMEOUT: Duration = Duration::from_secs(7);
/// Times an emergency stop is sent.
const STOP_TRIES: u32 = 100;
/// What passes at least between two of them where no pose tells the time.
const STOP_PERIOD: Duration = Duration::from_millis(10);

/// Flies a table. The vehicle stands on the ground, level, below the start.
///
/// # Errors
/// [`FlightError`] where the flight could not take place or lost its vehicle. The motors are off then, or the vehicle
/// has been told to switch them off.
pub fn fly(
    connection: &mut impl Connection,
    plan: &FlightPlan,
    witness: &mut impl Witness,
) -> Result<FlightResult, FlightError> {
    let mut flight = Flight::new(connection, witness);
    let result = flight.run(plan);
    flight.end(&result);
    result
}

/// The same, but it flies back before it lands: the vehicle stands below the start again.
///
/// # Errors
/// Those of [`fly`].
pub fn fly_and_return(
    connection: &mut impl Connection,
    plan: &FlightPlan,
    witness: &mut impl Witness,
) -> Result<FlightResult, FlightError> {
    let mut flight = Flight { returns: true, ..Flight::new(connection, witness) };
    let result = flight.run(plan);
    flight.end(&result);
    result
}

impl<'a, C: Connection, W: Witness> Flight<'a, C, W> {
    fn new(connection: &'a mut C, witness: &'a mut W) -> Self {
        let client = Client::with_key(connection.key());
        Self {
            connection,
            witness,
            client,
            estimator: Estimator::new(),
            estimate: None,
            calmness: Calmness::Grounded,
            reference: None,
            playing: None,
            now_s: 0.0,
            standing: Vec::new(),
            level: UnitQuaternion::identity(),
            fresh_pose: None,
            phase: Phase::Prepare,
            said: None,
            thrust_mps2: None,
            returns: false,
        }
    }

    /// Sees to it that a flight that failed does not go on.
    fn end<T>(&mut self, result: &Result<T, FlightError>) {
        match result {
            Ok(_) => {}
            // The vehicle can come down without the host, but not the host without seeing it.
            Err(FlightError::Connection(ConnectionError::Capture(_))) => self.leave_alone(),
            Err(_) => self.stop(),
        }
    }

    fn run(&mut self, plan: &FlightPlan) -> Result<FlightResult, FlightError> {
        self.enter(Phase::Prepare);
        let ground = self.step()?.position_m;
        let mut identity = self.identify()?;
        if let Some(vehicle) = plan.vehicle.filter(|vehicle| vehicle.hash() != identity.vehicle) {
            self.call("telling the vehicle what it is", Request::WriteVehicle(vehicle))?;
            identity = self.identify()?;
        }
        let checksum = self.upload(&for_vehicle(&plan.table, &identity)?)?;
        self.arm()?;
        self.level();

        self.enter(Phase::TakeOff);
        self.move_to(ground, plan.start_m, CLIMB_MPS)?;
        self.enter(Phase::Hover);
        let mut reason = self.hover_to_gate(&Reference::hold(plan.start_m, HEADING_RAD))?;
        let mut outcome = Outcome::NotTriggered;
        let mut flown_duration_s = 0.0;
        if reason.is_none() {
            self.enter(Phase::Maneuver);
            match self.maneuver(plan, checksum)? {
                // The vehicle said no and hovers: bring it down in peace.
                Ended::Refused(refusal) => reason = Some(refusal.to_string()),
                Ended::Aborted(abort) => {
                    (outcome, reason) = (Outcome::Aborted, Some(abort.to_string()));
                }
                Ended::Complete => outcome = Outcome::Completed,
            }
        }
        let mut counts = (0, 0);
        if outcome != Outcome::NotTriggered {
            if let Some(t) = self.client.telemetry() {
                flown_duration_s = f64::from(t.maneuver_s);
                counts = (t.maneuver_ticks, t.maneuver_missed_ticks);
            }
            self.enter(Phase::Catch);
            let target = Reference::hold(plan.end_m(), HEADING_RAD);
            if !self.catch(&target)? && outcome == Outcome::Completed {
                outcome = Outcome::NotCaught;
                reason = Some(format!(
                    "the vehicle did not come to rest at the end within {CATCH_TIMEOUT_S} s of the maneuver"
                ));
            }
        }
        let (ticks, missed_ticks) = counts;
        self.enter(Phase::Land);
        if self.returns {
            let here = self.step()?.position_m;
            self.move_to(here, plan.start_m, CLIMB_MPS)?;
        }
        self.land(ground.z)?;
        self.enter(Phase::Download);
        let record = if outcome == Outcome::NotTriggered { Vec::new() } else { self.download()? };
        if (record.len() as u32) < ticks {
            let text =
                format!("the vehicle's recorder was full: {} of {ticks} ticks are recorded", record.len());
            self.witness.event(self.now_s, &text);
        }
        let board = self.client.telemetry().and_then(|t| t.board);
        Ok(FlightResult { outcome, reason, identity, flown_duration_s, record, ticks, missed_ticks, board })
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
        self.connection.enter(phase);
        self.witness.phase(phase, self.now_s);
    }

    /// One pose: estimate, steer, and listen. Returns the estimate.
    fn step(&mut self) -> Result<Estimate, FlightError> {
        let mut pose = loop {
            match self.connection.next_pose() {
                Err(ConnectionError::Blind) => self.client.heartbeat(self.connection)?,
                pose => break pose?,
            }
        };
        self.now_s = pose.arrived_s;
        self.check_fresh(&pose)?;
        if self.reference.is_none() && self.calmness == Calmness::Grounded {
            self.standing.push(pose.attitude);
        }
        pose.attitude *= self.level;
        if let Some((plan, since_s)) = &self.playing {
            let elapsed = (self.now_s - since_s) as f32;
            let (angle, impulse) = plan.integrals(elapsed, elapsed + 1e-3);
            let rates_radps = plan.plane().turn(angle * 1e3);
            let planned = Setpoint { rates_radps, thrust_mps2: impulse * 1e3 };
            if elapsed < plan.duration_s() {
                self.estimator.note_command(self.now_s, planned);
            }
        }
        let estimate = self.estimator.update(&pose, self.calmness);
        self.estimate = Some(estimate);
        self.said = self.reference.as_ref().map(|reference| {
            let wanted = control(&estimate, reference);
            Setpoint { thrust_mps2: self.thrust_mps2.unwrap_or(wanted.thrust_mps2), ..wanted }
        });
        if let Some(setpoint) = self.said {
            self.client.stream(self.connection, setpoint)?;
            if self.playing.is_none() {
                self.estimator.note_command(self.now_s, setpoint);
            }
        }
        self.witness.saw(&Sight {
            pose,
            phase: self.phase,
            setpoint: self.said,
            maneuver_since_s: self.playing.as_ref().map(|(_, since_s)| *since_s),
            battery_v: self.client.telemetry().map(|t| t.battery_v),
            telemetry_count: self.client.telemetry_count(),
        });
        Ok(estimate)
    }

    /// A pose that never changes while the vehicle flies is none.
    fn check_fresh(&mut self, pose: &Pose) -> Result<(), ConnectionError> {
        let same = |last: &Pose| last.position_m == pose.position_m && last.attitude == pose.attitude;
        match &self.fresh_pose {
            Some(last) if same(last) && self.reference.is_some() && self.calmness != Calmness::Grounded => {
                if pose.arrived_s - last.arrived_s > FROZEN_POSE_S {
                    return Err(ConnectionError::FrozenPose);
                }
            }
            _ => self.fresh_pose = Some(*pose),
        }
        Ok(())
    }

    /// Says nothing more, so that the vehicle levels, descends and switches off by itself, and watches it do so.
    fn leave_alone(&mut self) {
        let since = Instant::now();
        let mut heard = self.client.telemetry_count();
        while since.elapsed() < RECOVERY_TIMEOUT {
            // Time passes in here, with a pose or without.
            match self.connection.next_pose() {
                Ok(pose) => self.now_s = pose.arrived_s,
                Err(ConnectionError::Stopped) => return self.stop(),
                Err(_) => {}
            }
            let _ = self.client.poll(self.connection, self.now_s);
            let count = self.client.telemetry_count();
            let Some(state) = self.client.telemetry().map(|t| t.state).filter(|_| count > heard) else {
                continue;
            };
            heard = count;
            if state == FlightState::Armed {
                // It stands: nothing falls.
                let _ = self.client.ask(self.connection, Request::Disarm, self.now_s);
            } else if !state.motors_on() {
                let text = format!("left alone, the vehicle is {} now", connection::describe(state));
                self.witness.event(self.now_s, &text);
                return;
            }
        }
    }

    /// Whatever went wrong: motors off. Needs no working cameras; the vehicle's own timeouts stand behind this.
    fn stop(&mut self) {
        for _ in 0..STOP_TRIES {
            // One number for all of them: the answer to the first may come when the last is said.
            let _ = if self.client.is_waiting_for(&Request::EmergencyStop) {
                self.client.insist(self.connection, self.now_s)
            } else {
                self.client.ask(self.connection, Request::EmergencyStop, self.now_s)
            };
            // Time passes in here, with a pose; without one it may not.
            self.now_s = match self.connection.next_pose() {
                Ok(pose) => pose.arrived_s,
                Err(_) => {
                    std::thread::sleep(STOP_PERIOD);
                    self.now_s + STOP_PERIOD.as_secs_f64()
                }
            };
            if matches!(self.client.poll(self.connection, self.now_s), Ok(Some(_))) {
                return;
            }
        }
    }

    /// Asks and steers on until the answer comes.
    fn call(&mut self, during: &'static str, request: Request) -> Result<Reply, FlightError> {
        let failed = |source| FlightError::Client { during, source };
        self.client.ask(self.connection, request, self.now_s)?;
        loop {
            self.step()?;
            if let Some(reply) = self.client.poll(self.connection, self.now_s).map_err(failed)? {
                return Ok(reply);
            }
        }
    }

    /// One step while nothing is asked; returns the estimate and what the vehicle last said of its state.
    fn watch(&mut self, during: &'static str, expected: &[FlightState]) -> Result<Estimate, FlightError> {
        let estimate = self.step()?;
        self.client
            .poll(self.connection, self.now_s)
            .map_err(|source| FlightError::Client { during, source })?;
        if let Some(t) = self.client.telemetry()
            && !expected.contains(&t.state)
        {
            return Err(FlightError::Lost { during, state: t.state, reason: t.abort });
        }
        Ok(estimate)
    }

    fn identify(&mut self) -> Result<Identity, FlightError> {
        match self.call("identifying the vehicle", Request::Identify)? {
            Reply::Identity(identity) => Ok(identity),
            _ => Err(mismatch("identifying the vehicle")),
        }
    }

    /// Stages, commits and reads back. Returns the checksum that names the table.
    fn upload(&mut self, table: &ManeuverTable) -> Result<u32, FlightError> {
        const DURING: &str = "uploading the table";
        let mut buffer = [0; MAX_TABLE_BYTES];
        let length = table.encode(&mut buffer)?;
        let bytes = &buffer[..length];
        let checksum = table.checksum();
        for (index, chunk) in bytes.chunks(STAGE_CHUNK_BYTES).enumerate() {
            let chunk = heapless::Vec::from_slice(chunk).map_err(|_| TableError::Length)?;
            // A table is far shorter than 64 KiB.
            let (total, offset) = (length as u16, (index * STAGE_CHUNK_BYTES) as u16);
            self.call(DURING, Request::Stage { total, offset, bytes: chunk })?;
        }
        self.call(DURING, Request::CommitTable { checksum })?;
        match self.call(DURING, Request::ReadTable)? {
            Reply::Table(back) if back == bytes => Ok(checksum),
            _ => Err(FlightError::ReadBack),
        }
    }

    /// Arms; waits for what passes by itself, such as the gyro's calibration.
    fn arm(&mut self) -> Result<(), FlightError> {
        let since = self.now_s;
        loop {
            match self.call("arming", Request::Arm(Purpose::Flight)) {
                Ok(_) => return Ok(()),
                Err(FlightError::Client { source: ClientError::Refused(refusal), .. }) => {
                    if !passes_by_itself(refusal) || self.now_s - since > READY_TIMEOUT_S {
                        return Err(FlightError::NotReady(refusal));
                    }
                }
                Err(error) => return Err(error),
            }
        }
    }

    /// Takes the attitude in which the vehicle stood as level: markers are never glued on to the milliradian.
    fn level(&mut self) {
        let Some(first) = self.standing.first() else {
            return;
        };
        let mean = self.standing.iter().map(|q| (first.inverse() * q).scaled_axis()).sum::<Vector3<f64>>()
            / self.standing.len() as f64;
        let stood = first * UnitQuaternion::from_scaled_axis(mean);
        let up = stood * Vector3::z();
        // The shortest turn that rights it; its heading stays as seen.
        let righting = UnitQuaternion::rotation_between(&up, &Vector3::z()).unwrap_or_default();
        self.level = stood.inverse() * righting * stood;
        self.estimator = Estimator::new();
        let tilt_rad = up.angle(&Vector3::z());
        self.witness
            .event(self.now_s, &format!("levelled: the markers are tilted by {:.2} mrad", tilt_rad * 1e3));
    }

    /// Moves the reference in a straight line at a speed.
    fn move_to(&mut self, from: Vector3<f64>, to: Vector3<f64>, speed_mps: f64) -> Result<(), FlightError> {
        let way = to - from;
        let duration_s = way.norm() / speed_mps;
        let velocity_mps = way.cap_magnitude(speed_mps);
        let since = self.now_s;
        loop {
            let part = ((self.now_s - since) / duration_s).min(1.0);
            if part >= 1.0 || duration_s == 0.0 {
                self.reference = Some(Reference::hold(to, HEADING_RAD));
                return Ok(());
            }
            let heading_rad = HEADING_RAD;
            self.reference = Some(Reference { position_m: from + way * part, velocity_mps, heading_rad });
            let estimate = self.watch("flying", &STILL_ARMING)?;
            if estimate.position_m.z - from.z > LANDED_HEIGHT_M && self.calmness == Calmness::Grounded {
                self.calmness = Calmness::Calm;
            }
            // The reference leaves the ground before the vehicle does: thrust builds up on it.
            if self.now_s - since > 0.5 {
                self.calmness = Calmness::Calm;
            }
        }
    }

    /// Holds the reference until the gate is open. `Some` with the reason if it never was.
    fn hover_to_gate(&mut self, reference: &Reference) -> Result<Option<String>, FlightError> {
        self.reference = Some(*reference);
        let since = self.now_s;
        let mut open_since = None;
        let (mut least_tilt, mut least_speed) = (f64::INFINITY, f64::INFINITY);
        while self.now_s - since < GATE_TIMEOUT_S {
            let estimate = self.watch("hovering", &[FlightState::Tracking])?;
            let (tilt, speed) = (estimate.tilt_rad(), estimate.velocity_mps.norm());
            let (least_t, least_s) = (least_tilt.min(tilt), least_speed.min(speed));
            (least_tilt, least_speed) = (least_t, least_s);
            let near = (estimate.position_m - reference.position_m).norm() <= GATE_POSITION_M;
            let settled = self.now_s - since >= HOVER_SETTLE_S;
            let open = settled && near && tilt <= GATE_TILT_RAD && speed <= GATE_SPEED_MPS;
            let began = if open { *open_since.get_or_insert(self.now_s) } else { f64::INFINITY };
            if !open {
                open_since = None;
            }
            if self.now_s - began >= GATE_HOLD_S {
                self.witness.event(
                    self.now_s,
                    &format!("gate open: tilt {:.2} mrad, speed {:.1} mm/s", tilt * 1e3, speed * 1e3),
                );
                return Ok(None);
            }
        }
        Ok(Some(format!(
            "the gate did not open within {GATE_TIMEOUT_S} s: smallest tilt {:.2} mrad (needed {:.0}), smallest speed \
             {:.1} mm/s (needed {:.0}); calm the air, check the balance and the cameras",
            least_tilt * 1e3,
            GATE_TILT_RAD * 1e3,
            least_speed * 1e3,
            GATE_SPEED_MPS * 1e3,
        )))
    }

    /// Triggers and waits for the end.
    fn maneuver(&mut self, plan: &FlightPlan, checksum: u32) -> Result<Ended, FlightError> {
        let played = Plan::new(&plan.table);
        let duration_s = f64::from(played.duration_s());
        match self.call("triggering the maneuver", Request::Trigger { checksum }) {
            Err(FlightError::Client { source: ClientError::Refused(refusal), .. }) => {
                return Ok(Ended::Refused(refusal));
            }
            result => result?,
        };
        self.calmness = Calmness::Agile;
        // The answer came within the tick that began it, and one pose ago.
        self.playing = Some((played, self.now_s - 0.005));
        self.reference = Some(Reference::hold(plan.end_m(), HEADING_RAD));
        let since = self.now_s;
        let mut seen = false;
        loop {
            self.watch(
                "in a maneuver",
                &[
                    FlightState::Tracking,
                    FlightState::Maneuver,
                    FlightState::Recovery,
                    FlightState::Terminated,
                ],
            )?;
            let Some(t) = self.client.telemetry().copied() else { continue };
            seen |= t.state == FlightState::Maneuver;
            let late = self.now_s - since > duration_s + TRIGGER_TIMEOUT_S;
            if t.state == FlightState::Terminated {
                return Err(FlightError::Lost { during: "in a maneuver", state: t.state, reason: t.abort });
            }
            if late || (seen && t.state != FlightState::Maneuver) {
                self.playing = None;
                let aborted = Ended::Aborted(t.abort.unwrap_or(AbortReason::LateTicks));
                return Ok(if t.maneuver_complete { Ended::Complete } else { aborted });
            }
        }
    }

    /// Brings the vehicle to rest at the reference. Whether it got there in time.
    fn catch(&mut self, reference: &Reference) -> Result<bool, FlightError> {
        self.reference = Some(*reference);
        let since = self.now_s;
        let mut settled_since = None;
        while self.now_s - since < CATCH_TIMEOUT_S {
            let estimate =
                self.watch("flying", &[FlightState::Tracking, FlightState::Recovery, FlightState::Maneuver])?;
            if self.now_s - since > 1.5 {
                self.calmness = Calmness::Calm;
            }
            let near = (estimate.position_m - reference.position_m).norm() <= CAUGHT_POSITION_M
                && estimate.velocity_mps.norm() <= CAUGHT_SPEED_MPS;
            let began = if near { *settled_since.get_or_insert(self.now_s) } else { f64::INFINITY };
            if !near {
                settled_since = None;
            }
            if self.now_s - began > 0.3 {
                return Ok(true);
            }
        }
        self.calmness = Calmness::Calm;
        Ok(false)
    }

    fn land(&mut self, ground_z_m: f64) -> Result<(), FlightError> {
        let here = self.step()?.position_m;
        let above = |height: f64| Vector3::new(here.x, here.y, ground_z_m + height);
        if here.z - ground_z_m > 1.0 {
            self.move_to(here, above(1.0), DESCENT_MPS)?;
        }
        let top = above((here.z - ground_z_m).clamp(0.0, 1.0));
        // The reference goes below the ground; the vehicle cannot follow, which is how it is known to stand.
        let since = self.now_s;
        while self.now_s - since < LAND_TIMEOUT_S {
            let depth = TOUCH_DOWN_MPS * (self.now_s - since);
            let velocity_mps = Vector3::new(0.0, 0.0, -TOUCH_DOWN_MPS);
            let heading_rad = HEADING_RAD;
            self.reference =
                Some(Reference { position_m: top - Vector3::z() * depth, velocity_mps, heading_rad });
            let estimate = self.watch("flying", &[FlightState::Tracking])?;
            if estimate.position_m.z - ground_z_m < LANDED_HEIGHT_M {
                break;
            }
        }
        self.reference = None;
        self.call("disarming", Request::Disarm)?;
        Ok(())
    }

    fn download(&mut self) -> Result<Vec<RecordedTick>, FlightError> {
        const DURING: &str = "downloading the record";
        download_record(|request| self.call(DURING, request), || mismatch(DURING))
    }
}

fn mismatch(during: &'static str) -> FlightError {
    FlightError::Client { during, source: ClientError::Mismatch }
}
