//! The virtual vehicle: the firmware image that gets flashed, run by the emulator, in closed loop with the simulator.
//!
//! ```text
//! simulator ── IMU sample ──► BMI270 model ── edge, SPI ──► image ── DShot ──► speed controllers ── throttle ──► simulator
//! host ─────────────────────── bytes at 921600 baud ──────► image
//! ```
//!
//! Nothing of the image is known here but its pins and, to log what it did, the place in memory where it notes each tick.

use emulator::boards::{MotorUpdate, SpeedyBeeF405V3};
use emulator::chip::Chip;
use emulator::core::Timing;
use emulator::devices::{CRSF_HIGH, CRSF_LOW, CrsfReceiver};
use emulator::log::Log;
use emulator::machine::symbol_address;
use emulator::{Machine, Stop};
use mintime_firmware::watch::{WATCH_BYTES, WATCH_SYMBOL, Watch};
use mintime_shared::messages::{FlightState, Setpoint};
use mintime_simulator::{Event, ImuSample, Simulator, SimulatorError};

use super::connection::{Connection, ConnectionError, Phase, Pose};
use super::world::{POSE_TIMEOUT_NS, Scene, Tick, Trace, World, is_planning_model};

/// The image's tick is looked at this often at least, ns: shorter than a tick, so that none is missed.
const LOOK_NS: u64 = 200_000;

/// The board runs for so many cycles at most before its clock is looked at again: 19 µs in flight, 200 µs after a reset.
const STEP_CYCLES: u64 = 3200;

/// One count of the gyro at ±2000 °/s, rad/s.
const GYRO_STEP_RADPS: f64 = core::f64::consts::PI / 180.0 / 16.384;

/// Why a virtual board cannot be set up.
#[derive(Debug, thiserror::Error)]
pub enum VirtualBoardError {
    /// Parameters of the airframe.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
    /// Not a program for this chip.
    #[error("the firmware image cannot be loaded: {0}")]
    Image(#[from] emulator::machine::ImageError),
    /// A program, but not this firmware.
    #[error(
        "the firmware image has no symbol `{WATCH_SYMBOL}`: build it with `cargo firmware` and do not strip it"
    )]
    Foreign,
}

/// What was measured on the virtual board.
#[derive(Clone, Debug, Default)]
pub struct BoardReport {
    /// From data ready to the end of the last motor's frame, ns: median, and the distance from it that 99.9 % keep, since
    /// the vehicle took off.
    pub latency_ns: Option<(u32, u32)>,
    /// Instructions of a control tick, mean.
    pub tick_instructions: f64,
    /// Part of the time that the processor was awake.
    pub load: f64,
    /// Mistakes of the firmware that the emulator saw.
    pub bugs: Vec<String>,
    /// What the firmware logged, with when the emulator read it, ns.
    pub log: Vec<(u64, String)>,
}

/// Is told of each control tick.
type Observer = Box<dyn FnMut(&Watch) + Send>;

/// Is told of each frame for a motor.
type MotorObserver = Box<dyn FnMut(&MotorUpdate) + Send>;

/// A virtual flight controller with a simulated airframe around it.
pub struct VirtualVehicle {
    world: World,
    machine: Machine<Chip<SpeedyBeeF405V3>>,
    watch_at: u32,
    watch: Watch,
    /// When the last sample was given to the sensor, and the sample.
    sample: Option<(u64, ImuSample)>,
    throttle: [f32; 4],
    /// Called with each tick.
    observer: Option<Observer>,
    /// Called with each frame for a motor.
    motor_observer: Option<MotorObserver>,
    flown_ticks: u64,
    counters_at_start: (u64, u64, u64),
    decoder: Log,
    log: Vec<(u64, String)>,
    /// The airframe is the planning model, whose sensors have no noise.
    noiseless: bool,
    last_bit: f64,
    /// The firmware has cleared its memory, so that what it notes means something.
    booted: bool,
    /// States that ticks ended in, where they changed or the firmware started anew, with when, ns.
    states: Vec<(u64, FlightState)>,
}

impl std::fmt::Debug for VirtualVehicle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VirtualVehicle").field("now_ns", &self.now_ns()).finish_non_exhaustive()
    }
}

impl VirtualVehicle {
    /// A board that is just switched on, with `image` in its flash.
    ///
    /// # Errors
    /// [`VirtualBoardError`].
    pub fn new(scene: &Scene<'_>, image: &[u8], timing: Timing) -> Result<Self, VirtualBoardError> {
        let mut machine = Machine::new(Chip::new(SpeedyBeeF405V3::new()), timing, scene.seed);
        machine.semihosting = false;
        machine.load_elf(image)?;
        // The person at the kill switch lets it fly.
        machine.peripherals.set_receiver(&mut machine.memory, Some(switch_at(CRSF_HIGH)));
        let watch_at = symbol_address(image, WATCH_SYMBOL).ok_or(VirtualBoardError::Foreign)?;
        Ok(Self {
            world: World::new(scene)?,
            machine,
            watch_at,
            watch: Watch::new(),
            sample: None,
            throttle: [0.0; 4],
            observer: None,
            motor_observer: None,
            flown_ticks: 0,
            counters_at_start: (0, 0, 0),
            decoder: Log::new(image),
            log: Vec::new(),
            noiseless: is_planning_model(scene.parameters),
            last_bit: 0.0,
            booted: false,
            states: Vec::new(),
        })
    }

    /// A copy that goes on by itself from this instant. Observers stay with the original.
    #[must_use]
    pub fn fork(&self) -> Self {
        Self {
            world: self.world.clone(),
            machine: self.machine.clone(),
            watch_at: self.watch_at,
            watch: self.watch,
            sample: self.sample,
            throttle: self.throttle,
            observer: None,
            motor_observer: None,
            flown_ticks: self.flown_ticks,
            counters_at_start: self.counters_at_start,
            decoder: self.decoder.clone(),
            log: self.log.clone(),
            noiseless: self.noiseless,
            last_bit: self.last_bit,
            booted: self.booted,
            states: self.states.clone(),
        }
    }

    /// States that the firmware's ticks ended in, where they changed, each with the time at which that was seen, ns: up to
    /// 0.2 ms later than it happened.
    pub fn states(&self) -> &[(u64, FlightState)] {
        &self.states
    }

    /// The person at the kill switch throws it, or lets go of it again.
    pub fn set_kill_switch(&mut self, stop: bool) {
        let value = if stop { CRSF_LOW } else { CRSF_HIGH };
        self.with_receiver(|receiver| receiver.channels[KILL_CHANNEL - 1] = value);
    }

    /// Does something to the radio receiver; nothing where none is plugged in.
    pub fn with_receiver(&mut self, change: impl FnOnce(&mut CrsfReceiver)) {
        let Machine { peripherals, memory, .. } = &mut self.machine;
        peripherals.with_board(memory, |board, _| board.receiver.as_mut().map(change));
    }

    /// Calls `observer` with what each control tick got and gave.
    pub fn observe(&mut self, observer: impl FnMut(&Watch) + Send + 'static) {
        self.observer = Some(Box::new(observer));
    }

    /// Calls `observer` with each frame that a speed controller got.
    pub fn observe_motors(&mut self, observer: impl FnMut(&MotorUpdate) + Send + 'static) {
        self.motor_observer = Some(Box::new(observer));
    }

    /// Virtual time, ns.
    pub fn now_ns(&self) -> u64 {
        self.world.simulator.now_ns()
    }

    /// The simulated world, to break something in it.
    pub fn simulator_mut(&mut self) -> &mut Simulator {
        &mut self.world.simulator
    }

    /// The virtual board, to break something on it.
    pub fn machine_mut(&mut self) -> &mut Machine<Chip<SpeedyBeeF405V3>> {
        &mut self.machine
    }

    /// What has been measured so far.
    pub fn report(&self) -> BoardReport {
        let counters = &self.machine.core.counters;
        let (instructions, asleep, cycle) = self.counters_at_start;
        let cycles = (self.machine.time() - cycle).max(1) as f64;
        let latency = self.machine.peripherals.board().latency.summary();
        BoardReport {
            latency_ns: latency.map(|l| (l.median_ns, l.jitter_p999_ns)),
            tick_instructions: (counters.instructions - instructions) as f64 / self.flown_ticks.max(1) as f64,
            load: 1.0 - (counters.asleep - asleep) as f64 / cycles,
            log: self.log.clone(),
            bugs: self.machine.memory.bugs.iter().map(|bug| bug.what.clone()).collect(),
        }
    }

    /// What has been logged, with the truth of this instant.
    pub fn into_trace(self) -> Trace {
        self.world.into_trace()
    }

    /// Lets time pass without a host that watches.
    ///
    /// # Errors
    /// [`ConnectionError::Board`].
    pub fn advance_to(&mut self, ns: u64) -> Result<(), ConnectionError> {
        while self.world.simulator.next_event_time_ns() <= ns {
            self.run_to(self.world.simulator.next_event_time_ns())?;
            if let Some((time_ns, Event::Gyro(sample))) = self.world.simulator.next_event() {
                self.give_sample(time_ns, sample);
            }
        }
        self.run_to(ns)
    }

    /// What the firmware has logged since the last call.
    pub fn take_log(&mut self) -> Vec<(u64, String)> {
        std::mem::take(&mut self.log)
    }

    /// Runs the board up to a time and the airframe with it.
    fn run_to(&mut self, ns: u64) -> Result<(), ConnectionError> {
        loop {
            let now_ns = self.world.simulator.now_ns();
            // Truth is noted at the very end of the maneuver's time.
            let end_ns = self.world.end_ns().filter(|end| *end > now_ns && *end < ns);
            let next_ns = end_ns.unwrap_or(ns).min(now_ns + LOOK_NS);
            self.run_board_to(next_ns)?;
            self.look(next_ns);
            self.world.simulator.advance_to(next_ns);
            self.world.note_end();
            if next_ns >= ns {
                return Ok(());
            }
        }
    }

    fn run_board_to(&mut self, ns: u64) -> Result<(), ConnectionError> {
        loop {
            // Where the firmware changes its clocks on the way the number of cycles changes with them.
            let limit = self.machine.peripherals.clock().cycle(ns);
            if limit <= self.machine.time() {
                return Ok(());
            }
            // In steps, for a reset makes the clock ten times slower and what is left of them as much longer.
            let limit = limit.min(self.machine.time() + STEP_CYCLES);
            match emulator::boards::run_until(&mut self.machine, limit) {
                Stop::ReachedTime => {}
                stop => return Err(ConnectionError::Board(stop.to_string())),
            }
        }
    }

    /// Hands on what the board has done since the last look.
    fn look(&mut self, now_ns: u64) {
        let before = self.watch.ticks;
        if let Some(bytes) = self.machine.memory.peek(self.watch_at, WATCH_BYTES as u32)
            && let Ok(bytes) = bytes.try_into()
        {
            let watch = Watch::from_bytes(bytes);
            self.booted |= watch == Watch::new();
            if self.booted {
                self.watch = watch;
            }
        }
        let logged = self.machine.read_rtt();
        if !logged.is_empty() {
            let lines = self.decoder.decode(&logged);
            self.log.extend(lines.lines().map(|line| (now_ns, line.to_owned())));
        }
        // A start clears it word by word.
        let restarted = self.watch.ticks < before;
        let state = FlightState::from_index(self.watch.state).filter(|_| !restarted).unwrap_or_default();
        let changed = self.watch.ticks != before && self.states.last().is_none_or(|(_, last)| *last != state);
        if changed || restarted {
            self.states.push((now_ns, state));
        }
        let setpoint = self.watch.output().setpoint;
        let updates: Vec<MotorUpdate> = self.machine.peripherals.board_mut().drain_motor_updates().collect();
        for update in updates {
            if let Some(observer) = &mut self.motor_observer {
                observer(&update);
            }
            self.throttle[update.motor] = update.throttle.unwrap_or(0.0) as f32;
            if update.motor + 1 < self.throttle.len() {
                continue;
            }
            // All four have theirs at once.
            self.world.simulator.advance_to(update.ns.min(now_ns));
            let time_ns = self.sample.as_ref().map_or(update.ns, |(ns, _)| *ns);
            self.world.command(&Tick { time_ns, sample: None, state, setpoint, throttle: self.throttle });
        }
        self.time_out_motors(now_ns, state, setpoint);
        if self.watch.ticks == before {
            return;
        }
        let sample = self.sample.take();
        let time_ns = sample.as_ref().map_or(now_ns, |(ns, _)| *ns);
        let sample = sample.as_ref().map(|(_, sample)| sample);
        self.world.log(&Tick { time_ns, sample, state, setpoint, throttle: self.throttle });
        if state == FlightState::Tracking || state == FlightState::Maneuver {
            if self.flown_ticks == 0 {
                self.begin_measuring();
            }
            self.flown_ticks += 1;
        }
        if let Some(observer) = &mut self.observer {
            observer(&self.watch);
        }
    }

    /// A speed controller that gets no frames stops its motor.
    fn time_out_motors(&mut self, now_ns: u64, state: FlightState, setpoint: Setpoint) {
        let mut silent = false;
        for (throttle, motor) in self.throttle.iter_mut().zip(self.machine.peripherals.motors(now_ns)) {
            silent |= *throttle > 0.0 && motor.throttle.is_none();
            *throttle = if motor.throttle.is_none() { 0.0 } else { *throttle };
        }
        if silent {
            self.world.simulator.advance_to(now_ns);
            self.world.command(&Tick {
                time_ns: now_ns,
                sample: None,
                state,
                setpoint,
                throttle: self.throttle,
            });
        }
    }

    /// Start-up is none of what is measured.
    fn begin_measuring(&mut self) {
        let counters = &self.machine.core.counters;
        self.counters_at_start = (counters.instructions, counters.asleep, self.machine.time());
        self.machine.peripherals.board_mut().latency.clear();
    }

    fn give_sample(&mut self, time_ns: u64, sample: ImuSample) {
        let [mut rates, force] = [sample.rates_radps, sample.specific_force_mps2].map(|v| v.map(f64::from));
        if self.noiseless {
            // The last bit of a real converter never rests, and firmware takes a sensor that repeats itself for broken.
            self.last_bit = GYRO_STEP_RADPS - self.last_bit;
            rates[2] += self.last_bit;
        }
        let battery_v = f64::from(self.world.simulator.battery_v());
        let (chip, memory) = (&mut self.machine.peripherals, &mut self.machine.memory);
        chip.set_battery_v(memory, battery_v);
        // The chip sits on the board with its axes along the body's. Time may have overshot by an instruction.
        let ns = time_ns.max(chip.clock().ns(chip.now()));
        chip.imu_sample(memory, ns, rates, force);
        self.sample = Some((time_ns, sample));
    }
}

impl Connection for VirtualVehicle {
    fn next_pose(&mut self) -> Result<Pose, ConnectionError> {
        let deadline_ns = self.now_ns() + POSE_TIMEOUT_NS;
        loop {
            let next_ns = self.world.simulator.next_event_time_ns();
            self.run_to(next_ns.min(deadline_ns))?;
            if next_ns > deadline_ns {
                return Err(ConnectionError::NoPose);
            }
            let (time_ns, event) = self.world.simulator.next_event().ok_or(ConnectionError::NoPose)?;
            match event {
                Event::Gyro(sample) => self.give_sample(time_ns, sample),
                Event::MotionCapture(pose) => return Ok(self.world.pose(time_ns, &pose)),
            }
        }
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
        let chip = &mut self.machine.peripherals;
        let ns = chip.clock().ns(chip.now());
        chip.link_send(ns, bytes);
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>) -> Result<(), ConnectionError> {
        into.extend(self.machine.peripherals.link_take().map(|byte| byte.byte));
        Ok(())
    }

    fn enter(&mut self, phase: Phase) {
        self.world.enter(phase);
    }
}

/// Channel of the kill switch, as the firmware's settings have it at first.
const KILL_CHANNEL: usize = 5;

/// A radio receiver whose pilot holds the kill switch's channel at a value.
fn switch_at(value: u16) -> CrsfReceiver {
    let mut receiver = CrsfReceiver::new();
    receiver.channels[KILL_CHANNEL - 1] = value;
    receiver
}
