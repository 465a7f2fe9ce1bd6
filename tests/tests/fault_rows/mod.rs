//! One row of the fault table: a fault, a phase, and how that ends.

mod fault;
mod phase;
mod rig;
mod sabotage;
mod store;

pub(crate) use fault::Fault;
pub(crate) use phase::Phase;

use mintime_shared::messages::{
    ArmingBlock, FlightState, IncidentCause, KillSwitch, Purpose, Refusal, Reply, Request, Telemetry,
};
use rig::{Host, MS, Rig};
use store::KEPT_SETTINGS;

/// Watched for this long beyond the longest bound, ms.
const BEYOND_MS: u64 = 150;
/// The gyro cannot be set up any faster, ms.
const GYRO_SET_UP_MS: u64 = 80;
/// Where nothing shall happen, nothing happens for this long, ms.
const CALM_MS: u64 = 300;

/// A fault in a phase.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) fault: Fault,
    pub(crate) phase: Phase,
    /// The state that it ends in, `Boot` where that is a reset, ...
    pub(crate) ends_in: FlightState,
    /// ... reached within this after the fault, ms; 0 where it never leaves the state it was in.
    pub(crate) within_ms: u32,
    /// No motor turns after this, by what its speed controller is told or misses, ms; `None` where they turn on, or never
    /// did.
    pub(crate) off_ms: Option<u32>,
    /// The reason or incident told.
    pub(crate) told: Option<&'static str>,
}

impl Row {
    /// As a line of the document's table.
    pub(crate) fn line(&self) -> String {
        let ms = |ms: Option<u32>| ms.map_or("–".to_owned(), |ms| format!("{ms} ms"));
        format!(
            "| {} | {} | {} | {} | {} | {} |",
            self.fault.name(),
            self.phase.name(),
            if self.resets() { "reset".to_owned() } else { format!("`{:?}`", self.ends_in) },
            ms(Some(self.within_ms).filter(|ms| *ms > 0)),
            ms(self.off_ms),
            self.told.map_or("–".to_owned(), |told| format!("`{told}`")),
        )
    }

    fn resets(&self) -> bool {
        self.ends_in == FlightState::Boot
    }

    /// Breaks a vehicle in the phase and sees how it ends.
    pub(crate) fn check(&self) {
        let mut rig = Rig::in_phase(self.phase);
        // So that each motor has been heard of.
        rig.pass_ms(5);
        let mut kept = None;
        let broken_ns = match self.fault.cuts_store() {
            Some(in_erase) => {
                kept = Some(store::cut_store(&mut rig, in_erase));
                rig.vehicle.now_ns()
            }
            None => self.fault.inject(&mut rig),
        };
        let longest_ms = u64::from(self.within_ms.max(self.off_ms.unwrap_or(0)));
        let shows_ms = self.fault.shows_after_ms();
        let end_ns = broken_ns + (longest_ms + BEYOND_MS).max(CALM_MS).max(shows_ms) * MS;
        while rig.vehicle.now_ns() < end_ns {
            rig.step();
        }

        // Where it ended, and how soon.
        let since: Vec<_> = rig.vehicle.states().iter().filter(|(ns, _)| *ns > broken_ns).copied().collect();
        let ms = |ns: u64| ns.saturating_sub(broken_ns) as f64 * 1e-6;
        let last = if self.resets() { since.first() } else { since.last() };
        let reached_ms = last.map(|(ns, _)| ms(*ns));
        let stopped_ns = rig.stopped_ns();
        let off_ms = stopped_ns.filter(|_| rig.ever_turned()).map(ms);
        println!("{}: reached {reached_ms:.1?} ms, motors off {off_ms:.2?} ms, {since:?}", self.line());
        if self.resets() {
            assert_started_anew(&since);
        } else {
            assert_eq!(rig.state(), self.ends_in, "{since:?}");
        }
        if self.within_ms == 0 {
            assert_eq!(since, [], "it left its state");
        } else {
            let reached_ms = reached_ms.expect("it reached it");
            assert!(reached_ms <= f64::from(self.within_ms), "{reached_ms} ms");
        }
        match self.off_ms {
            Some(bound) => {
                let off_ms = off_ms.expect("they turned, and stand");
                assert!(off_ms <= f64::from(bound), "{off_ms} ms");
            }
            None if self.ends_in.motors_on() => assert_eq!(stopped_ns, None, "they stand"),
            None => assert!(!rig.ever_turned(), "they turned"),
        }

        let telemetry = rig.status();
        assert_eq!(told(&telemetry).as_deref(), self.told, "{telemetry:?}");
        self.assert_struck(&telemetry);
        if let Some(kept) = kept {
            store::check_store(&mut rig, kept);
        }
        if self.ends_in.motors_on() {
            self.fault.mend(&mut rig);
            rig.pass_ms(CALM_MS);
            assert!(rig.state().motors_on(), "it goes on");
        } else {
            self.check_stays_off(&mut rig, &telemetry);
        }
        self.assert_stayed(&mut rig);
        let bugs = rig.bugs();
        let expected = |bug: &String| self.fault.expected_bug().is_some_and(|part| bug.contains(part));
        // Whatever ends a run may cut the frame that is on the wire; its checksum tells the speed controller.
        let torn =
            |bug: &String| self.ends_in == FlightState::Boot && bug.contains("a DShot frame ends after");
        assert!(bugs.iter().all(|bug| expected(bug) || torn(bug)), "{bugs:?}");
    }

    /// Where a fault may leave no trace in the state it must leave one in telemetry, or it was none.
    fn assert_struck(&self, telemetry: &Telemetry) {
        let board = telemetry.board.expect("a board");
        let struck = match self.fault {
            Fault::NoisyEdges => board.spurious_edges > 20,
            // A period counts once.
            Fault::Ringing10 | Fault::Ringing5 | Fault::Ringing1 => board.spurious_edges > 200,
            Fault::FlippedBits | Fault::LostBytes | Fault::LineNoise => telemetry.link_errors > 10,
            Fault::BusLoose => telemetry.missing_samples > 20,
            Fault::BusLow if self.phase == Phase::Disarmed => telemetry.missing_samples > 100,
            Fault::GyroSilent if !self.phase.state().motors_on() => {
                ArmingBlock(telemetry.arming_block).contains(ArmingBlock::GYRO_SILENT)
            }
            Fault::GyroFrozenLong => ArmingBlock(telemetry.arming_block).contains(ArmingBlock::GYRO_FROZEN),
            Fault::FrameEndsLost if self.phase == Phase::Disarmed => {
                board.motor_errors > 20
                    && ArmingBlock(telemetry.arming_block).contains(ArmingBlock::NO_MOTORS)
            }
            Fault::SenseLost => telemetry.battery_v == 0.0,
            Fault::BatterySag => (10.0..12.4).contains(&telemetry.battery_v),
            Fault::Stall => telemetry.worst_interval_us > 10_000,
            Fault::KillPressed if !self.phase.state().motors_on() => telemetry.kill == KillSwitch::Stop,
            Fault::RadioNoisy if !self.phase.state().motors_on() => telemetry.kill == KillSwitch::Lost,
            _ => true,
        };
        assert!(struck, "{telemetry:?}");
    }

    /// What must not change whatever breaks: a vehicle on the bench stays on it, and a calibration that nobody has concluded
    /// sets nothing.
    fn assert_stayed(&self, rig: &mut Rig) {
        match self.phase {
            Phase::Bench => rig.assert_stands(),
            Phase::Turned => {
                assert_eq!(rig.ask(Request::ReadSettings), Ok(Reply::Settings(KEPT_SETTINGS)));
            }
            _ => {}
        }
    }

    /// Nobody but a person starts the motors again, mended or not, whatever a host streams.
    fn check_stays_off(&self, rig: &mut Rig, telemetry: &Telemetry) {
        let ended_ns = rig.vehicle.now_ns();
        let arm = Request::Arm(Purpose::Flight);
        let wanted = match (self.ends_in, telemetry.incident) {
            (FlightState::Landed, _) => Some(ArmingBlock::LANDED),
            (FlightState::Terminated, Some(_)) => Some(ArmingBlock::TERMINATED),
            (FlightState::Terminated, None) => panic!("terminated without an incident"),
            (_, Some(_)) => Some(ArmingBlock::INCIDENT),
            (FlightState::Boot, None) => Some(ArmingBlock::STARTING),
            (_, None) => None,
        };
        let refused = |rig: &mut Rig| match rig.ask(arm.clone()) {
            Err(Refusal::ArmingBlocked(bits)) => ArmingBlock(bits),
            other => panic!("armed: {other:?}"),
        };
        if let Some(block) = wanted {
            assert!(refused(rig).contains(block));
        }
        let kill = matches!(
            self.fault,
            Fault::KillPressed | Fault::RadioSilent | Fault::RadioNoisy | Fault::RadioLost
        );
        let acknowledge = telemetry.incident.map(|i| Request::Acknowledge { incident: i.number });
        if let Some(acknowledge) = acknowledge.clone().filter(|_| kill) {
            assert_eq!(rig.ask(acknowledge), Err(Refusal::KillSwitch));
        }
        self.fault.mend(rig);
        rig.host = Host::Flies;
        rig.pass_ms(CALM_MS);
        if let Some(block) = wanted {
            assert!(refused(rig).contains(block));
        }
        if let Some(acknowledge) = acknowledge {
            assert_eq!(rig.ask(acknowledge), Ok(Reply::Done));
            if self.phase == Phase::Terminated && self.told != Some("EmergencyStop") {
                // What it was stopped for waits behind what came then.
                let earlier = rig.status();
                assert_eq!(told(&earlier).as_deref(), Some("EmergencyStop"), "{earlier:?}");
                let incident = earlier.incident.map_or(0, |incident| incident.number);
                assert_eq!(rig.ask(Request::Acknowledge { incident }), Ok(Reply::Done));
            }
            assert_eq!(rig.status().incident, None);
            rig.pass_ms(50);
        }
        assert!(!rig.state().motors_on());
        assert!(!rig.turned_after(ended_ns));
    }
}

/// It starts once, keeps to `Boot` while its gyro is being set up, and goes no further by itself than to be disarmed.
fn assert_started_anew(since: &[(u64, FlightState)]) {
    let mut states = since.iter().map(|(_, state)| *state);
    assert_eq!(states.next(), Some(FlightState::Boot), "{since:?}");
    assert!(states.all(|s| matches!(s, FlightState::Calibrating | FlightState::Disarmed)), "{since:?}");
    if let [(boot_ns, _), (next_ns, _), ..] = since {
        assert!(next_ns - boot_ns > GYRO_SET_UP_MS * MS, "{since:?}");
    }
}

/// What a vehicle says of the fault: what waits to be acknowledged, or else why it gave something up.
fn told(telemetry: &Telemetry) -> Option<String> {
    let name = |text: String| text.split([' ', '(']).next().unwrap_or_default().to_owned();
    match telemetry.incident {
        Some(incident) => Some(match incident.cause {
            IncidentCause::Terminated(reason) => format!("{reason:?}"),
            cause => name(format!("{cause:?}")),
        }),
        None => telemetry.abort.map(|reason| format!("{reason:?}")),
    }
}
