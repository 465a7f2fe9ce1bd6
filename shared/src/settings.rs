//! What is adjusted on one flight controller and is no property of the vehicle: calibration, kill switch, timeouts.

use serde::{Deserialize, Serialize};

/// The settings, kept in flash.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// True rate over measured rate about forward, left, up: what a guided turn found.
    pub gyro_scale: [f32; 3],
    /// Cutoff of the gyro's low-pass in the rate loop, Hz.
    pub gyro_cutoff_hz: f32,
    /// Channel of the receiver that is the kill switch, from 1.
    pub kill_channel: u8,
    /// The motors may turn while that channel is above this, µs; at it and below they must not.
    pub kill_run_us: u16,
    /// Highest collective thrust per mass without a kill switch, m/s²: for work on the bench. 0: never without one.
    pub bench_thrust_mps2: f32,
    /// The host counts as gone when nothing was heard of it for this long, ms.
    pub heartbeat_ms: u16,
    /// How long a recovery may last before the motors stop, ms.
    pub recovery_ms: u16,
}

/// Why settings are unusable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum SettingsError {
    /// A number is NaN or infinite.
    #[error("a number is not finite")]
    NotFinite,
    /// Gyro scale beyond 5 %.
    #[error("gyro_scale must be within 0.95 to 1.05 on each axis")]
    GyroScale,
    /// Cutoff out of range.
    #[error("gyro_cutoff_hz must be 40 to 350")]
    GyroCutoff,
    /// Kill switch out of range.
    #[error("the kill switch: channel 1 to 16, and 1000 < kill_run_us < 2000")]
    KillSwitch,
    /// A bench thrust that flies.
    #[error("bench_thrust_mps2 must be 0, or at most 5: a vehicle on the bench must not fly")]
    BenchThrust,
    /// Timeouts out of range.
    #[error("heartbeat_ms must be 150 to 2000, recovery_ms 500 to 5000")]
    Timeouts,
}

impl Settings {
    /// What a flight controller starts with.
    pub const DEFAULT: Self = Self {
        gyro_scale: [1.0; 3],
        gyro_cutoff_hz: 150.0,
        kill_channel: 5,
        kill_run_us: 1700,
        bench_thrust_mps2: 0.0,
        heartbeat_ms: 500,
        recovery_ms: 2000,
    };
    /// Highest thrust that counts as work on the bench, m/s²: half a g lifts nothing.
    pub const BENCH_THRUST_MAX_MPS2: f32 = 5.0;

    /// Whether these numbers are usable.
    ///
    /// # Errors
    /// The first reason in the order of [`SettingsError`].
    pub fn check(&self) -> Result<(), SettingsError> {
        use SettingsError as E;
        let ensure = |holds: bool, error: E| if holds { Ok(()) } else { Err(error) };
        let [x, y, z] = self.gyro_scale;
        let finite = [x, y, z, self.gyro_cutoff_hz, self.bench_thrust_mps2].iter().all(|n| n.is_finite());
        ensure(finite, E::NotFinite)?;
        ensure(self.gyro_scale.iter().all(|s| (0.95..=1.05).contains(s)), E::GyroScale)?;
        ensure((40.0..=350.0).contains(&self.gyro_cutoff_hz), E::GyroCutoff)?;
        // Within what a channel can say: a switch that could never stop is none.
        let range = 1000 < self.kill_run_us && self.kill_run_us < 2000;
        ensure((1..=16).contains(&self.kill_channel) && range, E::KillSwitch)?;
        ensure((0.0..=Self::BENCH_THRUST_MAX_MPS2).contains(&self.bench_thrust_mps2), E::BenchThrust)?;
        let timeouts = (150..=2000).contains(&self.heartbeat_ms) && (500..=5000).contains(&self.recovery_ms);
        ensure(timeouts, E::Timeouts)
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self::DEFAULT
    }
}
