//! SpeedyBee F405 V3: BMI270 on SPI1, four DShot speed controllers on TIM4, link on USART1, battery on PC0.
//!
//! | function | pins |
//! |---|---|
//! | gyro BMI270 | SPI1 (PA5 SCK, PA6 MISO, PA7 MOSI), chip select PA4, data ready PC4 |
//! | motors 1..4 | PB6, PB7, PB8, PB9 |
//! | link | USART1 (PA9 TX, PA10 RX) |
//! | radio receiver, if one is plugged in | USART2 (PA3 RX) |
//! | battery, current | PC0, PC1 |
//! | LED, beeper | PC8 (low lights), PC5 |
//!
//! In a closed loop the world advances the machine to the time of a sample, gives it with [`Chip::imu_sample`], goes on,
//! and reads [`Chip::motors`] or drains the updates.

use std::collections::VecDeque;

use crate::chip::{Board, Chip, Effects, Pin, Pulse, SerialByte, SpiWord};
use crate::devices::{Battery, Bmi270, CRSF_BAUD, CrsfReceiver, DshotEsc, Latency};
use crate::memory::Memory;

const GYRO_SELECT: Pin = Pin::new('A', 4);
const GYRO_READY: Pin = Pin::new('C', 4);
const MOTORS: [Pin; 4] = [Pin::new('B', 6), Pin::new('B', 7), Pin::new('B', 8), Pin::new('B', 9)];
const LED: Pin = Pin::new('C', 8);
const BATTERY: Pin = Pin::new('C', 0);
const CURRENT: Pin = Pin::new('C', 1);
const GYRO_BUS: u8 = 1;
const LINK: u8 = 1;
const RECEIVER: u8 = 2;
/// Motor updates kept while nobody drains them: a second of frames for four motors, and some.
const MOST_UPDATES: usize = 4096;

/// The board.
#[derive(Clone, Debug)]
pub struct SpeedyBeeF405V3 {
    /// The gyro and accelerometer.
    pub gyro: Bmi270,
    /// The speed controllers of motors 1..4.
    pub escs: [DshotEsc; 4],
    /// The battery.
    pub battery: Battery,
    /// The radio receiver, none at first.
    pub receiver: Option<CrsfReceiver>,
    /// Voltage of the current sensor (V).
    pub current_sensor_v: f64,
    /// From data ready to the end of the motor frames.
    pub latency: Latency,
    /// Frequency of the crystal (Hz).
    pub crystal_hz: u32,
    led_driven_low: bool,
    ready_level: Option<bool>,
    ringing: Option<Ringing>,
    updates: VecDeque<MotorUpdate>,
}

/// Edges on the data-ready line that nobody meant.
#[derive(Clone, Copy, Debug)]
struct Ringing {
    period_ns: u64,
    next_ns: u64,
}

/// What a motor does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorSignal {
    /// Its controller would spin it.
    pub armed: bool,
    /// 0..=1; none while not armed.
    pub throttle: Option<f64>,
    /// End of the last bit of the last valid frame (ns).
    pub last_bit_ns: Option<u64>,
}

/// A valid frame came for a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorUpdate {
    /// End of its last bit (ns).
    pub ns: u64,
    /// 0..=3 for motors 1..4.
    pub motor: usize,
    /// 0..=1 from now on; none while not armed.
    pub throttle: Option<f64>,
    /// The value of the frame.
    pub value: u16,
}

impl SpeedyBeeF405V3 {
    /// The board at power-up, with a full battery of four cells.
    pub fn new() -> Self {
        Self {
            gyro: Bmi270::new(),
            escs: std::array::from_fn(|n| DshotEsc::new(&format!("motor {}", n + 1))),
            battery: Battery { volts: 16.8, divider: 11.0 },
            receiver: None,
            current_sensor_v: 0.0,
            latency: Latency::default(),
            crystal_hz: 8_000_000,
            led_driven_low: false,
            ready_level: None,
            ringing: None,
            updates: VecDeque::with_capacity(MOST_UPDATES),
        }
    }

    /// Whether the LED is lit.
    pub fn led(&self) -> bool {
        self.led_driven_low
    }

    /// The motors at `ns`.
    pub fn motors(&self, ns: u64) -> [MotorSignal; 4] {
        std::array::from_fn(|n| {
            let esc = &self.escs[n];
            MotorSignal { armed: esc.armed(ns), throttle: esc.throttle(ns), last_bit_ns: esc.last_frame_ns() }
        })
    }

    /// Takes the frames that came since the last call, in order.
    pub fn drain_motor_updates(&mut self) -> impl Iterator<Item = MotorUpdate> + '_ {
        self.updates.drain(..)
    }

    /// Lets the data-ready line rise once more where it rings; it then rests where the gyro holds it.
    fn ring(&mut self, ns: u64, effects: &mut Effects) {
        let Some(ringing) = self.ringing.as_mut().filter(|ringing| ringing.next_ns <= ns) else { return };
        ringing.next_ns = ns + ringing.period_ns;
        let levels = [Some(false), Some(true), self.ready_level];
        effects.levels.extend(levels.map(|level| (GYRO_READY, level)));
    }

    /// Passes a change of the data-ready line on to the chip.
    fn follow_ready(&mut self, effects: &mut Effects) {
        let level = self.gyro.interrupt_pin();
        if level != self.ready_level {
            self.ready_level = level;
            effects.levels.push((GYRO_READY, level));
        }
    }
}

impl Default for SpeedyBeeF405V3 {
    fn default() -> Self {
        Self::new()
    }
}

impl Board for SpeedyBeeF405V3 {
    fn crystal_hz(&self) -> Option<u32> {
        Some(self.crystal_hz)
    }

    fn output(&mut self, ns: u64, pin: Pin, level: Option<bool>, effects: &mut Effects) {
        match pin {
            // A select line that floats rests high.
            GYRO_SELECT => {
                self.gyro.select(ns, level == Some(false), &mut effects.bugs);
                self.follow_ready(effects);
            }
            LED => self.led_driven_low = level == Some(false),
            _ => {}
        }
    }

    fn pulse(&mut self, _: u64, pin: Pin, pulse: Pulse, effects: &mut Effects) {
        let Some(motor) = MOTORS.iter().position(|&line| line == pin) else { return };
        let esc = &mut self.escs[motor];
        if let Some(frame) = esc.pulse(pulse, &mut effects.bugs)
            && let Some(value) = frame.value
        {
            self.latency.frame(motor, frame.start_ns, frame.end_ns);
            let throttle = esc.throttle(frame.end_ns);
            if self.updates.len() == MOST_UPDATES {
                self.updates.pop_front();
            }
            self.updates.push_back(MotorUpdate { ns: frame.end_ns, motor, throttle, value });
        }
    }

    fn spi(&mut self, ns: u64, bus: u8, word: SpiWord, effects: &mut Effects) -> u16 {
        if bus != GYRO_BUS {
            return 0xFFFF;
        }
        let answer = self.gyro.exchange(ns, word, &mut effects.bugs);
        self.follow_ready(effects);
        answer
    }

    fn analog_v(&mut self, _: u64, pin: Pin) -> f64 {
        match pin {
            BATTERY => self.battery.pin_v(),
            CURRENT => self.current_sensor_v,
            _ => 0.0,
        }
    }

    fn next_event_ns(&self) -> u64 {
        let receiver_ns = self.receiver.as_ref().map_or(u64::MAX, CrsfReceiver::next_event_ns);
        let ringing_ns = self.ringing.map_or(u64::MAX, |ringing| ringing.next_ns);
        self.gyro.next_event_ns().min(receiver_ns).min(ringing_ns)
    }

    fn advance(&mut self, ns: u64, effects: &mut Effects) {
        if let Some(edge_ns) = self.gyro.advance(ns, &mut effects.bugs) {
            self.latency.edge(edge_ns);
        }
        self.follow_ready(effects);
        self.ring(ns, effects);
        if let Some(bytes) = self.receiver.as_mut().and_then(|receiver| receiver.advance(ns)) {
            effects.serial.push((RECEIVER, CRSF_BAUD, bytes));
        }
    }
}

/// The board's side of a closed loop. Times are nanoseconds since power-up.
impl Chip<SpeedyBeeF405V3> {
    /// Motion at `ns` (now or ahead, never before a sample already given) in axes of the sensor: rates (rad/s) and
    /// specific force (m/s²). The data-ready edge comes at that very time.
    pub fn imu_sample(&mut self, memory: &mut Memory, ns: u64, rates_radps: [f64; 3], accel_mps2: [f64; 3]) {
        self.with_board(memory, |board, _| board.gyro.sample(ns, rates_radps, accel_mps2));
    }

    /// Voltage of the battery (V).
    pub fn set_battery_v(&mut self, memory: &mut Memory, volts: f64) {
        self.with_board(memory, |board, _| board.battery.volts = volts);
    }

    /// Plugs a radio receiver in, or pulls it out.
    pub fn set_receiver(&mut self, memory: &mut Memory, receiver: Option<CrsfReceiver>) {
        self.with_board(memory, |board, _| board.receiver = receiver);
    }

    /// Lets the data-ready line ring from `ns` on, a rising edge every `period_ns` besides the gyro's own; `None` ends it.
    pub fn ring_data_ready(&mut self, memory: &mut Memory, ns: u64, period_ns: Option<u64>) {
        let ringing = period_ns.map(|period_ns| Ringing { period_ns: period_ns.max(1), next_ns: ns });
        self.with_board(memory, |board, _| board.ringing = ringing);
    }

    /// Bytes that the host sends over the link, from `ns` on, back to back.
    pub fn link_send(&mut self, ns: u64, bytes: &[u8]) {
        self.serial_send(LINK, ns, bytes);
    }

    /// What the firmware has sent over the link since the last call.
    pub fn link_take(&mut self) -> impl Iterator<Item = SerialByte> + '_ {
        self.serial_take(LINK)
    }

    /// The motors at `ns`.
    pub fn motors(&self, ns: u64) -> [MotorSignal; 4] {
        self.board().motors(ns)
    }

    /// Whether the LED is lit.
    pub fn led(&self) -> bool {
        self.board().led()
    }
}
