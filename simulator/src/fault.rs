//! Things that break, and when.

use core::ops::Range;

/// Something that breaks. [`Simulator::inject`](crate::Simulator::inject) says when.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Gyro and accelerometer deliver no samples. A window as short as one sample loses that sample.
    ImuSilent,
    /// Gyro and accelerometer repeat their last counts.
    ImuStuck,
    /// The gyro's counts have the wrong sign.
    GyroReversed,
    /// A rotor gets no current: its motor by index, 0 to 3 for motors 1 to 4. It spins down.
    RotorDead(u8),
    /// The motion capture repeats its last pose, with new times.
    MotionCaptureFrozen,
    /// The motion capture delivers nothing.
    MotionCaptureSilent,
}

/// Why a fault cannot be injected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FaultError {
    /// The index of the rotor is not 0, 1, 2 or 3.
    #[error("there is no rotor {0}: rotors are numbered 0 to 3")]
    NoSuchRotor(u8),
}

/// All faults of a flight.
#[derive(Clone, Debug, Default)]
pub(crate) struct Faults {
    windows: Vec<(Fault, Range<u64>)>,
}

impl Faults {
    pub(crate) fn add(&mut self, fault: Fault, when_ns: Range<u64>) -> Result<(), FaultError> {
        if let Fault::RotorDead(rotor) = fault
            && rotor > 3
        {
            return Err(FaultError::NoSuchRotor(rotor));
        }
        self.windows.push((fault, when_ns));
        Ok(())
    }

    pub(crate) fn active(&self, fault: Fault, now_ns: u64) -> bool {
        self.windows.iter().any(|(f, when)| *f == fault && when.contains(&now_ns))
    }

    /// The first time from `from_ns` on at which a fault is not active; `u64::MAX` where it never ends.
    pub(crate) fn free_from_ns(&self, fault: Fault, from_ns: u64) -> u64 {
        let mut time = from_ns;
        // Each round leaves at least one window behind for good, so there are at most as many rounds as windows.
        while let Some((_, window)) =
            self.windows.iter().find(|(f, when)| *f == fault && when.contains(&time))
        {
            time = window.end;
        }
        time
    }

    /// The first time after `now_ns` at which a window of the rotors opens or closes: the motion is not smooth there.
    pub(crate) fn next_rotor_change_ns(&self, now_ns: u64) -> u64 {
        let edges = self.windows.iter().filter(|(f, _)| matches!(f, Fault::RotorDead(_)));
        edges.flat_map(|(_, w)| [w.start, w.end]).filter(|&t| t > now_ns).min().unwrap_or(u64::MAX)
    }

    /// Which rotors are dead.
    pub(crate) fn dead_rotors(&self, now_ns: u64) -> [bool; 4] {
        core::array::from_fn(|rotor| self.active(Fault::RotorDead(rotor as u8), now_ns))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlapping_windows_are_one_silence() {
        let mut faults = Faults::default();
        for window in [20..40, 10..20, 35..50] {
            faults.add(Fault::ImuSilent, window).unwrap();
        }
        assert_eq!(faults.free_from_ns(Fault::ImuSilent, 5), 5);
        assert_eq!(faults.free_from_ns(Fault::ImuSilent, 15), 50);
        faults.add(Fault::ImuSilent, 45..u64::MAX).unwrap();
        assert_eq!(faults.free_from_ns(Fault::ImuSilent, 15), u64::MAX);
        assert_eq!(faults.add(Fault::RotorDead(4), 0..1), Err(FaultError::NoSuchRotor(4)));
    }
}
