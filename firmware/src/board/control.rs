//! The control tick: 800 times a second from gyro to motors, in an interrupt of its own.
//!
//! Deadline: 1250 µs after the edge that starts it; the motors' frame is ready [`MOTOR_START_US`](super::facts) after that
//! edge and begins just then, so that its last bit ends within 100 µs; one that is late begins at once and is counted
//! among the motor errors. Order within a tick: last frame looked after, gyro read, what the flight logic commands, motors;
//! then what it does besides (requests, answers, the record: a table's check takes 0.3 ms) and at most [`BYTES_PER_TICK`] link bytes each way, a little
//! more than the line can carry, so that the link delays no motor. A tick that comes late is counted and the following
//! ones keep their times: the flight logic takes time from the clock, never from counting ticks.

use core::cell::Cell;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::DWT;
use embassy_stm32::interrupt;
use embassy_stm32::interrupt::InterruptExt;
use embassy_sync::blocking_mutex::Mutex;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_time::Instant;
use mintime_firmware::config::{BoardStatus, Capabilities, StoreStatus};
use mintime_firmware::dshot::Frame;
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::pacing::Pacer;
use mintime_firmware::receiver::KillState;
use mintime_firmware::store::Order;
use mintime_firmware::watch::{RECEIVE_BYTES, Watch};
use mintime_shared::messages::{AbortReason, BoardTelemetry, IncidentCause, KillSwitch};
use static_cell::StaticCell;

use super::dshot::Motors;
use super::facts::{CONTROL_INTERRUPT, CORE_MHZ, MOTOR_ARMING_FRAMES};
use super::imu::{self, Imu, Outcome};
use super::link::{OUTBOX, Receiver};
use super::receiver::RadioReceiver;
use super::tick_source::{self, LateTimer};
use super::vehicle::{self, BoardVehicle};
use super::watchdog::{self, Party};
use super::{battery, fault, storage, supervision};

/// Link bytes moved per tick and direction. The line carries 115.2 in a tick.
const BYTES_PER_TICK: usize = RECEIVE_BYTES;

/// Motor frames that may come to nothing in a row (10 ms), as for the gyro's samples.
const UNFINISHED_FRAMES: u32 = 8;

/// Ticks run.
pub(super) static TICKS: AtomicU32 = AtomicU32::new(0);
/// What the latest tick measured.
static TELEMETRY: Mutex<CriticalSectionRawMutex, Cell<Option<BoardTelemetry>>> = Mutex::new(Cell::new(None));

static CONTROL: StaticCell<Control> = StaticCell::new();
/// Where the two handlers, which never interrupt each other, find it.
static HANDLE: Mutex<CriticalSectionRawMutex, Cell<Option<&'static mut Control>>> =
    Mutex::new(Cell::new(None));

/// What the latest tick measured.
pub(super) fn telemetry() -> BoardTelemetry {
    TELEMETRY.lock(Cell::get).unwrap_or_default()
}

/// Everything between gyro and motors. Only the handlers below touch it.
struct Control {
    vehicle: &'static mut BoardVehicle,
    /// `None` until it is set up, for ever if it cannot be.
    imu: Option<Imu>,
    gyro_pending: bool,
    /// It has given a sample.
    gyro_seen: bool,
    receiver: Receiver,
    radio: RadioReceiver,
    motors: Motors,
    /// Whether the last frame was sent in full.
    motors_well: bool,
    /// How many were not, one after another, with the motors on.
    unfinished_frames: u32,
    /// Zero-throttle frames sent since the battery is there, up to [`MOTOR_ARMING_FRAMES`].
    arming_frames: u32,
    pacer: Pacer,
    late_timer: LateTimer,
    /// The data-ready line is closed since the last edge.
    deaf: bool,
    /// The cycle counter at the edge that the frame under way answers.
    answered_edge: Option<u32>,
    motors_on: bool,
    measured: BoardTelemetry,
    store: StoreStatus,
    /// Ticket of the last job handed to the store.
    ordered: u32,
    /// The session's number is no earlier one's: seals of earlier runs do not count in this one.
    random: bool,
    /// What is kept of incidents for the next start.
    kept: Earlier,
    bytes: [u8; BYTES_PER_TICK],
    watch: &'static mut Watch,
}

/// What nobody has acknowledged and the next start must know of.
#[derive(Clone, Copy)]
pub(super) struct Earlier {
    /// Numbers of the incidents in which earlier runs ended, by the places of [`fault::kept`].
    pub(super) crashes: [Option<u16>; fault::CRASH_COUNT],
    /// Why the motors were stopped for good, in this run or before.
    pub(super) termination: Option<AbortReason>,
}

/// Starts the control tick. Where the session may be one that was already (not `random`) no motor output is offered while the
/// vehicle is paired, whatever is acknowledged: what is replayed from an earlier run would count.
#[allow(unsafe_code)]
pub(super) fn start(
    vehicle: &'static mut BoardVehicle,
    earlier: Earlier,
    random: bool,
    receiver: Receiver,
    radio: RadioReceiver,
    motors: Motors,
    late_timer: LateTimer,
) {
    let now_us = Instant::now().as_micros();
    let control = CONTROL.init_with(|| Control {
        vehicle,
        imu: None,
        gyro_pending: true,
        gyro_seen: false,
        receiver,
        radio,
        motors,
        motors_well: false,
        unfinished_frames: 0,
        arming_frames: 0,
        pacer: Pacer::new(now_us),
        late_timer,
        deaf: false,
        answered_edge: None,
        motors_on: false,
        measured: BoardTelemetry::default(),
        store: StoreStatus { present: true, busy: false, finished: 0, failed: false },
        ordered: 0,
        random,
        kept: earlier,
        bytes: [0; BYTES_PER_TICK],
        watch: vehicle::watch(),
    });
    // Before the first tick, or the flight logic would take the board for one that has started.
    control.publish();
    control.arm_timer();
    HANDLE.lock(|handle| handle.set(Some(control)));
    // SAFETY: the handlers have what they need; nothing relies on these interrupts being masked.
    unsafe {
        CONTROL_INTERRUPT.enable();
        interrupt::TIM7.enable();
    }
}

/// The gyro's edge, pended by its handler.
#[allow(unsafe_code)]
#[interrupt]
unsafe fn I2C3_ER() {
    with_control(Control::edge);
}

/// The next edge may come, or it stays away.
#[allow(unsafe_code)]
#[interrupt]
unsafe fn TIM7() {
    with_control(Control::timer);
}

fn with_control(run: impl FnOnce(&mut Control)) {
    if let Some(control) = HANDLE.lock(Cell::take) {
        run(control);
        HANDLE.lock(|handle| handle.set(Some(control)));
    }
}

impl Control {
    fn edge(&mut self) {
        self.deaf = true;
        let edge = tick_source::edge_cycles();
        let begin = DWT::cycle_count();
        let age_us = u64::from(begin.wrapping_sub(edge) / CORE_MHZ);
        let at_us = Instant::now().as_micros().saturating_sub(age_us);
        if let Some(now_us) = self.pacer.edge(at_us) {
            self.finish_frame();
            let sample = self.imu.as_mut().and_then(Imu::sample);
            // The sensor's first samples after it is switched on are zeros: none, but no errors either.
            self.gyro_seen |= sample.is_some();
            let failed = u32::from(sample.is_none() && self.gyro_seen);
            self.measured.gyro_errors = self.measured.gyro_errors.saturating_add(failed);
            self.tick(now_us, sample, Some(edge));
            self.keep_run_time(begin);
        }
        self.arm_timer();
    }

    fn timer(&mut self) {
        let begin = DWT::cycle_count();
        self.late_timer.clear();
        let now_us = Instant::now().as_micros();
        if self.deaf {
            if self.pacer.deaf_us(now_us) == 0 {
                self.deaf = false;
                self.pacer.note_noise(tick_source::listen());
            }
        } else if let Some(now_us) = self.pacer.timer(now_us) {
            self.finish_frame();
            self.tick(now_us, None, None);
            self.keep_run_time(begin);
        }
        self.arm_timer();
    }

    fn tick(&mut self, now_us: u64, imu: Option<ImuSample>, edge: Option<u32>) {
        let battery_v = battery::voltage();
        // Of the tick before: decoding must not delay the motors.
        let kill = match self.radio.switch().state() {
            KillState::Unknown => KillSwitch::Absent,
            KillState::Lost => KillSwitch::Lost,
            KillState::Kill => KillSwitch::Stop,
            KillState::Run => KillSwitch::Run,
        };
        let input = TickInput { now_us, imu, battery_v, kill };
        let output = self.vehicle.tick(&input);
        let frames = output.throttle.map_or([Frame::STOP; 4], |throttle| throttle.map(Frame::throttle));
        self.motors.send(&frames, edge);
        self.answered_edge = edge;

        // The motors have theirs; now everything that may take its time.
        self.count_arming_frames(output.throttle.is_some(), battery_v);
        self.listen(now_us);
        self.keep();
        self.take_gyro();
        let status = self.publish();
        self.watch.note(&input, &output, self.vehicle.state(), &status);
        self.move_bytes();
        self.watch.ticks = self.watch.ticks.wrapping_add(1);
        watchdog::check_in(Party::Control);
        // One writer: no read-modify-write needed.
        TICKS.store(TICKS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
    }

    /// Looks after the last tick's motor frame and measures how long after its edge it ended.
    fn finish_frame(&mut self) {
        let end = self.motors.finish();
        self.motors_well = end.is_some();
        let Some(end) = end else {
            self.miss_frame();
            return;
        };
        self.unfinished_frames = 0;
        let Some(edge) = self.answered_edge.take() else {
            return;
        };
        let latency_ns = nanoseconds(end.wrapping_sub(edge));
        let measured = &mut self.measured;
        let first = measured.latency_min_ns == 0;
        measured.latency_ns = latency_ns;
        measured.latency_min_ns = if first { latency_ns } else { measured.latency_min_ns.min(latency_ns) };
        measured.latency_max_ns = measured.latency_max_ns.max(latency_ns);
    }

    /// Counts a frame that did not end. Motors that are not told what to do are not flown: the run ends while their lines may
    /// still be driven by hand.
    #[cold]
    fn miss_frame(&mut self) {
        self.unfinished_frames = if self.motors_on { self.unfinished_frames.saturating_add(1) } else { 0 };
        if self.unfinished_frames >= UNFINISHED_FRAMES {
            fault::set_up_failed(line!());
        }
    }

    /// Speed controllers arm on zero throttle, and only once they have power.
    #[inline(never)]
    fn count_arming_frames(&mut self, motors_on: bool, battery_v: Option<f32>) {
        if motors_on != self.motors_on {
            self.motors_on = motors_on;
            if motors_on {
                self.measured.latency_min_ns = 0;
                self.measured.latency_max_ns = 0;
            }
        }
        if motors_on {
            return;
        }
        let counts = self.motors_well && self.vehicle.is_plausible_battery(battery_v);
        self.arming_frames =
            if counts { self.arming_frames.saturating_add(1).min(MOTOR_ARMING_FRAMES) } else { 0 };
    }

    /// Takes in what the radio receiver sent.
    #[inline(never)]
    fn listen(&mut self, now_us: u64) {
        if !self.motors_on {
            let (channel, run_above_us) = self.vehicle.kill_switch();
            self.radio.configure(channel, run_above_us);
        }
        self.radio.update(now_us);
    }

    /// Hands over what the flight logic wants kept, and takes the answer. Only ever with the motors off: flash stalls.
    #[inline(never)]
    fn keep(&mut self) {
        if let Some(done) = storage::take_done() {
            self.store.finished = done.number;
            self.store.failed = done.result.is_err();
        }
        self.store.busy = storage::busy();
        let Some(job) = self.vehicle.job().filter(|job| !self.motors_on && job.ticket != self.ordered) else {
            return;
        };
        let order = if job.value.is_empty() {
            Order::Remove(job.key)
        } else {
            Order::Write(job.key, job.value.clone())
        };
        if storage::submit(job.ticket, order).is_ok() {
            self.ordered = job.ticket;
            self.store.busy = true;
        }
    }

    /// Keeps over a reset what waits to be acknowledged, and forgets it once a person has read of it.
    #[inline(never)]
    fn keep_incidents(&mut self) {
        let mut waits = Earlier { crashes: [None; fault::CRASH_COUNT], termination: None };
        for incident in self.vehicle.incidents() {
            for (waits, kept) in waits.crashes.iter_mut().zip(self.kept.crashes) {
                *waits = waits.or(kept.filter(|number| *number == incident.number));
            }
            // The first of them: those behind it can only be stops of a vehicle that stood.
            if let IncidentCause::Terminated(reason) = incident.cause {
                waits.termination = waits.termination.or(Some(reason));
            }
        }
        for (place, (waits, kept)) in waits.crashes.iter().zip(&self.kept.crashes).enumerate() {
            if waits != kept {
                fault::forget(place);
            }
        }
        if waits.termination != self.kept.termination {
            fault::keep_termination(waits.termination);
        }
        self.kept = waits;
    }

    /// Takes the gyro over when its set-up has ended, well or not.
    #[inline(never)]
    fn take_gyro(&mut self) {
        if !self.gyro_pending {
            return;
        }
        match imu::take_outcome() {
            Some(Outcome::Ready(imu)) => self.imu = Some(imu),
            Some(Outcome::Failed(fault)) => self.measured.gyro_fault = Some(fault),
            None => return,
        }
        self.gyro_pending = false;
    }

    /// Hands the flight logic what the board says of itself.
    #[inline(never)]
    fn publish(&mut self) -> BoardStatus {
        let measured = &mut self.measured;
        measured.missed_ticks = self.pacer.missed();
        measured.spurious_edges = self.pacer.spurious();
        measured.motor_errors = self.motors.errors();
        measured.load_permille = supervision::LOAD_PERMILLE.load(Ordering::Relaxed);
        let stack = supervision::STACK_USED_BYTES.load(Ordering::Relaxed);
        measured.stack_used_bytes = u16::try_from(stack).unwrap_or(u16::MAX);
        let motors = self.arming_frames >= MOTOR_ARMING_FRAMES;
        let sealed = self.random || !self.vehicle.is_paired();
        let status = BoardStatus {
            capabilities: Capabilities { gyro: self.imu.is_some(), motors: motors && sealed },
            // Outputs that do not work are not starting.
            starting: self.gyro_pending || (!motors && self.motors_well),
            telemetry: *measured,
            store: self.store,
        };
        self.vehicle.set_board_status(&status);
        TELEMETRY.lock(|telemetry| telemetry.set(Some(*measured)));
        status
    }

    #[inline(never)]
    fn move_bytes(&mut self) {
        let room = OUTBOX.free_capacity().min(self.bytes.len());
        let sent = self.vehicle.transmit(self.bytes.get_mut(..room).unwrap_or_default());
        // What the rest of the tick, done by now, has reported or acknowledged is among them.
        self.keep_incidents();
        // One writer, and the room was just measured: nothing is cut short. The second write is for the wrap.
        let mut rest = self.bytes.get(..sent.min(room)).unwrap_or_default();
        for _ in 0..2 {
            let taken = OUTBOX.try_write(rest).unwrap_or(0);
            rest = rest.get(taken..).unwrap_or_default();
        }

        let received = self.receiver.take(&mut self.watch.received);
        self.watch.room = room as u32;
        self.watch.received_len = received as u32;
        self.vehicle.receive(self.watch.received());
    }

    fn keep_run_time(&mut self, begin: u32) {
        let run_ns = nanoseconds(DWT::cycle_count().wrapping_sub(begin));
        self.measured.tick_max_ns = self.measured.tick_max_ns.max(run_ns);
    }

    /// Sets the timer for when the line is opened, or else for the tick that runs if no edge comes first. A microsecond more,
    /// for a clock that counts whole ones may still show the one before.
    #[inline(never)]
    fn arm_timer(&mut self) {
        let now_us = Instant::now().as_micros();
        let delay_us = if self.deaf { self.pacer.deaf_us(now_us) } else { self.pacer.delay_us(now_us) };
        self.late_timer.arm(delay_us.saturating_add(1));
    }
}

/// Cycles as time. Saturates at 4 s. In 32 bits: the processor divides those by itself.
const fn nanoseconds(cycles: u32) -> u32 {
    let us = cycles / CORE_MHZ;
    us.saturating_mul(1000).saturating_add(cycles % CORE_MHZ * 1000 / CORE_MHZ)
}
