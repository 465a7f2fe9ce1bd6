//! What a control tick got and gave, in one place in memory with a fixed layout: for a debug probe's live view, and for
//! tests that feed the very same inputs to the flight logic on the host.
//!
//! Little-endian words in the order of [`Watch`]'s fields, [`WATCH_BYTES`] in all, at the symbol [`WATCH_SYMBOL`].

use mintime_shared::messages::{FlightState, KillSwitch, Setpoint};

use crate::config::{BoardStatus, MOTOR_COUNT, StoreStatus};
use crate::flight::{TickInput, TickOutput};
use crate::gyro::ImuSample;

/// Name of the symbol in the board's image.
pub const WATCH_SYMBOL: &str = "MINTIME_WATCH";
/// Link bytes that a tick takes in at most.
pub const RECEIVE_BYTES: usize = 128;
/// Size of [`Watch`].
pub const WATCH_BYTES: usize = 92 + RECEIVE_BYTES;

/// One tick. Everything is a word of four bytes or made of them, so that the layout is the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Watch {
    /// Ticks so far; changes last.
    pub ticks: u32,
    /// [`TickInput::now_us`], low word and high word.
    pub now_us: [u32; 2],
    /// Bits of [`flags`].
    pub flags: u32,
    /// [`ImuSample::gyro_radps`].
    pub gyro_radps: [f32; 3],
    /// [`ImuSample::accel_mps2`].
    pub accel_mps2: [f32; 3],
    /// [`TickInput::battery_v`].
    pub battery_v: f32,
    /// [`TickOutput::throttle`].
    pub throttle: [f32; MOTOR_COUNT],
    /// [`Setpoint::rates_radps`].
    pub rates_radps: [f32; 3],
    /// [`Setpoint::thrust_mps2`].
    pub thrust_mps2: f32,
    /// What the supervisor does after the tick, as the number that goes over the wire.
    pub state: u32,
    /// [`StoreStatus::finished`].
    pub stored: u32,
    /// Link bytes that there was room to send.
    pub room: u32,
    /// How many of [`Self::received`] are new.
    pub received_len: u32,
    /// Link bytes given to the flight logic after the tick.
    pub received: [u8; RECEIVE_BYTES],
}

/// Bits of [`Watch::flags`].
pub mod flags {
    /// There was an IMU sample.
    pub const IMU: u32 = 1;
    /// The battery voltage was known.
    pub const BATTERY: u32 = 1 << 1;
    /// The kill switch was heard: silent, stop or run by the next two.
    pub const KILL_HEARD: u32 = 1 << 2;
    /// The motors are on.
    pub const MOTORS: u32 = 1 << 3;
    /// The board can measure rates.
    pub const CAN_MEASURE: u32 = 1 << 4;
    /// The board can drive motors.
    pub const CAN_DRIVE: u32 = 1 << 5;
    /// The board is still starting.
    pub const STARTING: u32 = 1 << 6;
    /// The kill switch said stop.
    pub const KILL_STOP: u32 = 1 << 7;
    /// The kill switch let the motors run.
    pub const KILL_RUN: u32 = 1 << 8;
    /// The board has a store.
    pub const STORE: u32 = 1 << 9;
    /// It is at work.
    pub const STORE_BUSY: u32 = 1 << 10;
    /// Its last job failed.
    pub const STORE_FAILED: u32 = 1 << 11;
}

impl Watch {
    /// Before the first tick.
    pub const fn new() -> Self {
        Self {
            ticks: 0,
            now_us: [0; 2],
            flags: 0,
            gyro_radps: [0.0; 3],
            accel_mps2: [0.0; 3],
            battery_v: 0.0,
            throttle: [0.0; MOTOR_COUNT],
            rates_radps: [0.0; 3],
            thrust_mps2: 0.0,
            state: 0,
            stored: 0,
            room: 0,
            received_len: 0,
            received: [0; RECEIVE_BYTES],
        }
    }

    /// Notes what a tick got and gave.
    #[inline(never)]
    pub fn note(&mut self, input: &TickInput, output: &TickOutput, state: FlightState, status: &BoardStatus) {
        let mut bits = 0;
        let mut set = |on: bool, bit: u32| bits |= if on { bit } else { 0 };
        set(input.imu.is_some(), flags::IMU);
        set(input.battery_v.is_some(), flags::BATTERY);
        set(input.kill != KillSwitch::Absent, flags::KILL_HEARD);
        set(input.kill == KillSwitch::Stop, flags::KILL_STOP);
        set(input.kill == KillSwitch::Run, flags::KILL_RUN);
        set(status.store.present, flags::STORE);
        set(status.store.busy, flags::STORE_BUSY);
        set(status.store.failed, flags::STORE_FAILED);
        set(output.throttle.is_some(), flags::MOTORS);
        set(status.capabilities.gyro, flags::CAN_MEASURE);
        set(status.capabilities.motors, flags::CAN_DRIVE);
        set(status.starting, flags::STARTING);
        let imu = input.imu.unwrap_or(ImuSample { gyro_radps: [0.0; 3], accel_mps2: [0.0; 3] });
        // The low and the high half: nothing is lost.
        self.now_us = [input.now_us as u32, (input.now_us >> 32) as u32];
        self.flags = bits;
        self.gyro_radps = imu.gyro_radps;
        self.accel_mps2 = imu.accel_mps2;
        self.battery_v = input.battery_v.unwrap_or(0.0);
        self.throttle = output.throttle.unwrap_or_default();
        self.rates_radps = output.setpoint.rates_radps;
        self.thrust_mps2 = output.setpoint.thrust_mps2;
        self.state = state as u32;
        self.stored = status.store.finished;
    }

    /// What the flight logic got.
    pub fn input(&self) -> TickInput {
        let [low, high] = self.now_us.map(u64::from);
        let has = |bit: u32| self.flags & bit != 0;
        let imu = ImuSample { gyro_radps: self.gyro_radps, accel_mps2: self.accel_mps2 };
        TickInput {
            now_us: low | high << 32,
            imu: has(flags::IMU).then_some(imu),
            battery_v: has(flags::BATTERY).then_some(self.battery_v),
            kill: match (has(flags::KILL_HEARD), has(flags::KILL_STOP), has(flags::KILL_RUN)) {
                (false, ..) => KillSwitch::Absent,
                (true, true, _) => KillSwitch::Stop,
                (true, false, true) => KillSwitch::Run,
                (true, false, false) => KillSwitch::Lost,
            },
        }
    }

    /// What it gave.
    pub fn output(&self) -> TickOutput {
        TickOutput {
            throttle: (self.flags & flags::MOTORS != 0).then_some(self.throttle),
            setpoint: Setpoint { rates_radps: self.rates_radps, thrust_mps2: self.thrust_mps2 },
        }
    }

    /// What the board said of its store.
    pub fn store(&self) -> StoreStatus {
        let has = |bit: u32| self.flags & bit != 0;
        StoreStatus {
            present: has(flags::STORE),
            busy: has(flags::STORE_BUSY),
            failed: has(flags::STORE_FAILED),
            finished: self.stored,
        }
    }

    /// The new link bytes.
    pub fn received(&self) -> &[u8] {
        self.received.get(..self.received_len as usize).unwrap_or_default()
    }

    /// From memory.
    pub fn from_bytes(bytes: &[u8; WATCH_BYTES]) -> Self {
        let (words, received) = bytes.split_at(WATCH_BYTES - RECEIVE_BYTES);
        let mut words = words.chunks_exact(4).map(|w| w.try_into().map_or(0, u32::from_le_bytes));
        let mut word = || words.next().unwrap_or(0);
        let ticks = word();
        let now_us = [word(), word()];
        let flags = word();
        let mut real = || f32::from_bits(word());
        let gyro_radps = [real(), real(), real()];
        let accel_mps2 = [real(), real(), real()];
        let battery_v = real();
        let throttle = [real(), real(), real(), real()];
        let rates_radps = [real(), real(), real()];
        let thrust_mps2 = real();
        Self {
            ticks,
            now_us,
            flags,
            gyro_radps,
            accel_mps2,
            battery_v,
            throttle,
            rates_radps,
            thrust_mps2,
            state: word(),
            stored: word(),
            room: word(),
            received_len: word(),
            received: received.try_into().unwrap_or([0; RECEIVE_BYTES]),
        }
    }
}

impl Default for Watch {
    fn default() -> Self {
        Self::new()
    }
}

const _: () = assert!(core::mem::size_of::<Watch>() == WATCH_BYTES);
