//! The STM32F405 board: start-up order and the tasks.
#![allow(deprecated, reason = "the early hook needs no memory; in assembly it would repeat the pins")]

mod battery;
mod control;
mod copy;
mod core_setup;
mod critical;
mod dshot;
mod entropy;
mod facts;
mod fault;
mod flash;
mod idle;
mod imu;
mod link;
mod motors;
mod receiver;
mod ring;
mod spi;
mod stack;
mod storage;
mod supervision;
mod supply;
mod tick_source;
mod vehicle;
mod watchdog;

use defmt_rtt as _;
use embassy_executor::Spawner;
use embassy_stm32::gpio::Output;
use embassy_stm32::mode::Async;
use embassy_stm32::usart::UartTx;
use mintime_firmware::receiver::KillSwitchConfig;
use mintime_firmware::store::Key;
use mintime_shared::messages::IncidentCause;

/// Before anything else after a reset, memory included: filling that takes 4 ms on the internal oscillator, and floating
/// lines are no signal that anybody chose.
#[allow(unsafe_code)]
#[cortex_m_rt::pre_init]
unsafe fn before_memory() {
    // Registers only: no static of the program is read or written.
    motors::force_low();
}

/// Start-up, in the order that leaves no moment unguarded: motors low, watchdog, clocks, then everything else.
#[cortex_m_rt::entry]
fn start() -> ! {
    let tasks = set_up();
    idle::run(|spawner| tasks.spawn(spawner))
}

/// What the tasks in thread mode begin with.
struct Tasks {
    gyro: facts::GyroParts,
    transmitter: UartTx<'static, Async>,
    battery: battery::Battery,
    led: Output<'static>,
    crashed: bool,
    store: storage::BoardStore,
}

impl Tasks {
    fn spawn(self, spawner: Spawner) {
        let (Ok(gyro), Ok(transmit), Ok(supervise), Ok(keep)) = (
            imu::set_up(self.gyro),
            link::transmit(self.transmitter),
            supervision::run(self.battery, self.led, self.crashed),
            storage::run(self.store),
        ) else {
            fault::set_up_failed(line!())
        };
        spawner.spawn(gyro);
        spawner.spawn(transmit);
        spawner.spawn(supervise);
        spawner.spawn(keep);
    }
}

/// Everything up to the first control tick. Apart from what never returns, or the 4 KB that this needs of the stack would
/// never be free again.
#[inline(never)]
fn set_up() -> Tasks {
    motors::force_low();
    watchdog::start();
    let cause = fault::take_reset_cause();
    fault::note_reset(cause);
    let crashes = fault::kept();

    let peripherals = embassy_stm32::init(facts::clocks());
    core_setup::enable_flash_caches();
    core_setup::enable_clock_monitor();
    core_setup::pause_watchdog_in_debug();
    core_setup::prepare_core();
    facts::set_priorities();
    supply::watch();

    let run = entropy::draw(cortex_m::peripheral::DWT::cycle_count());
    defmt::info!("mintime firmware {=str}, reset by {}", env!("CARGO_PKG_VERSION"), cause);
    defmt::info!("run {=u64:016x}, random: {=bool}", run.bits, run.random);
    for crash in crashes.iter().flatten() {
        defmt::error!("the last run crashed: {}", crash);
    }
    let termination = fault::kept_termination();

    let mut store = storage::open();
    let vehicle = vehicle::take();
    // Half of the number: the other half is nobody's business.
    vehicle.set_session(run.bits as u32);
    let crash_numbers = crashes.map(|crash| Some(vehicle.report(incident(&crash?)?)));
    if let Some(reason) = termination {
        vehicle.report(IncidentCause::Terminated(reason));
    }
    // A whole table that another firmware has laid out otherwise is no damage.
    let damage =
        storage::each(&mut store, |key, value| vehicle.restore(key, value) || matches!(key, Key::Table(_)));
    vehicle.note_damage(damage);
    // A seal of an earlier start must not count in this one.
    if !run.random && vehicle.is_paired() {
        vehicle.report(IncidentCause::SetUp(line!()));
    }
    let parts = facts::Parts::new(peripherals);
    let battery = battery::Battery::new(parts.battery);
    let led = supervision::led(parts.led);
    let Ok((receiver, transmitter)) = link::open(parts.link) else { fault::set_up_failed(line!()) };

    let radio = receiver::RadioReceiver::new(parts.receiver, KillSwitchConfig::DEFAULT);
    let motors = dshot::Motors::new(parts.motors);
    let earlier = control::Earlier { crashes: crash_numbers, termination };
    let late_timer = tick_source::LateTimer::new(parts.late_timer);
    control::start(vehicle, earlier, run.random, receiver, radio, motors, late_timer);
    let crashed = crashes.iter().any(Option::is_some) || termination.is_some();
    Tasks { gyro: parts.gyro, transmitter, battery, led, crashed, store }
}

/// What a person must hear of before the motors turn again: how the last run ended.
fn incident(crash: &fault::Crash) -> Option<IncidentCause> {
    use fault::Kind;
    Some(match crash.kind {
        Kind::Panic => IncidentCause::Panic(crash.line),
        Kind::HardFault => IncidentCause::HardFault { pc: crash.pc, cfsr: crash.cfsr },
        Kind::StackOverflow => IncidentCause::StackOverflow,
        Kind::ClockLost => IncidentCause::ClockLost,
        Kind::UnexpectedInterrupt => IncidentCause::UnexpectedInterrupt(crash.pc),
        Kind::SetUp => IncidentCause::SetUp(crash.line),
        Kind::BrownOut => IncidentCause::BrownOut,
        Kind::Watchdog => IncidentCause::Watchdog,
        // Kept by itself: its run did not end.
        Kind::Terminated => return None,
    })
}
