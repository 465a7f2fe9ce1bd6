//! DShot600 frames: from throttles to pulse widths. No hardware.
//!
//! A frame is 16 bits, the highest first: 11 bits of value, a request for telemetry, 4 bits of checksum. Each bit is a
//! pulse at the beginning of its slot, long for 1 and short for 0. Values 0 (stop) and 48..=2047 (throttle) are sent;
//! 1..=47 are commands, which this firmware never sends.
//!
//! Source: the protocol as its authors published it for Betaflight; a speed controller takes 600,000 bits a second,
//! pulses of 1.25 µs and 0.625 µs.

/// Counts of an 84 MHz timer per bit: 600,000 bits a second exactly.
pub const BIT_COUNTS: u16 = 140;
/// Length of the pulse of a 1: 75 % of the slot, 1.25 µs.
pub const ONE_COUNTS: u16 = 105;
/// Length of the pulse of a 0: 37.1 % of the slot, 0.62 µs.
pub const ZERO_COUNTS: u16 = 52;
/// Bits of a frame.
pub const FRAME_BITS: usize = 16;
/// Highest value: full throttle.
pub const VALUE_MAX: u16 = 2047;
/// Lowest throttle that turns a motor.
pub const VALUE_MIN: u16 = 48;

/// One motor's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame(u16);

impl Frame {
    /// Stand still. What arms a speed controller, too.
    pub const STOP: Self = Self::of_value(0);

    /// A throttle, above 0 to 1, onto 48..=2047. Zero, less, and what is not a number stand still; more than one saturates.
    pub fn throttle(throttle: f32) -> Self {
        if throttle <= 0.0 || throttle.is_nan() {
            return Self::STOP;
        }
        let span = f32::from(VALUE_MAX - VALUE_MIN);
        // `as` saturates.
        let steps = (throttle * span + 0.5) as u16;
        Self::of_value(VALUE_MIN.saturating_add(steps).min(VALUE_MAX))
    }

    /// No telemetry asked for; the checksum is the exclusive or of the three nibbles above it.
    const fn of_value(value: u16) -> Self {
        let content = value << 1;
        let checksum = (content ^ (content >> 4) ^ (content >> 8)) & 0x0F;
        Self(content << 4 | checksum)
    }

    /// The 16 bits.
    pub const fn bits(self) -> u16 {
        self.0
    }

    /// Length of the pulse in the given slot, counts of the timer. Slots from 16 on are empty: the line stays low.
    pub const fn pulse_counts(self, slot: usize) -> u16 {
        if slot >= FRAME_BITS {
            0
        } else if self.0 >> (FRAME_BITS - 1 - slot) & 1 == 1 {
            ONE_COUNTS
        } else {
            ZERO_COUNTS
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// What a speed controller makes of a frame, written the other way round: value and telemetry bit if the checksum
    /// holds.
    fn receive(bits: u16) -> Option<(u16, bool)> {
        let nibble = |n: u16| bits >> (4 * n) & 0xF;
        (nibble(3) ^ nibble(2) ^ nibble(1) ^ nibble(0) == 0).then_some((bits >> 5, bits >> 4 & 1 == 1))
    }

    /// The widths of the pulses read as bits, the threshold half-way.
    fn sampled(frame: Frame) -> u16 {
        (0..FRAME_BITS)
            .fold(0, |bits, slot| bits << 1 | u16::from(frame.pulse_counts(slot) > BIT_COUNTS * 56 / 100))
    }

    #[test]
    fn known_frames() {
        // 1046 with telemetry off: the protocol's published example is 0x82C6.
        assert_eq!(Frame::of_value(1046).bits(), 0x82C6);
        assert_eq!(Frame::STOP.bits(), 0);
        assert_eq!(Frame::throttle(0.0), Frame::STOP);
        assert_eq!(receive(Frame::throttle(f32::MIN_POSITIVE).bits()), Some((48, false)));
        assert_eq!(receive(Frame::throttle(1.0).bits()), Some((2047, false)));
        assert_eq!(receive(Frame::throttle(0.5).bits()), Some((1048, false)));
    }

    #[test]
    fn what_is_no_throttle_saturates() {
        for (throttle, value) in
            [(-1.0, 0), (-0.0, 0), (f32::NEG_INFINITY, 0), (f32::NAN, 0), (1.5, 2047), (f32::INFINITY, 2047)]
        {
            assert_eq!(receive(Frame::throttle(throttle).bits()), Some((value, false)), "{throttle}");
        }
    }

    #[test]
    fn the_rate_and_the_pulses_are_the_protocols() {
        assert_eq!(84_000_000 / u32::from(BIT_COUNTS), 600_000);
        let part = |counts: u16| f32::from(counts) / f32::from(BIT_COUNTS);
        assert!((part(ONE_COUNTS) - 0.7485).abs() < 0.005 && (part(ZERO_COUNTS) - 0.374).abs() < 0.005);
    }

    #[test]
    fn after_the_last_bit_the_line_is_low() {
        assert!((FRAME_BITS..40).all(|slot| Frame::throttle(1.0).pulse_counts(slot) == 0));
    }

    proptest! {
        #[test]
        fn a_throttle_arrives(throttle in 0.0_f32..=1.0) {
            let (value, telemetry) = receive(Frame::throttle(throttle).bits()).expect("the checksum holds");
            prop_assert!(!telemetry);
            if throttle == 0.0 {
                prop_assert_eq!(value, 0);
                return Ok(());
            }
            let back = f32::from(value - 48) / 1999.0;
            prop_assert!((back - throttle).abs() <= 0.501 / 1999.0, "{throttle} {back}");
        }

        /// No float at all turns into a command to the speed controller.
        #[test]
        fn never_a_command(throttle: f32) {
            let (value, _) = receive(Frame::throttle(throttle).bits()).expect("the checksum holds");
            prop_assert!(value == 0 || (48..=2047).contains(&value));
            // Nor does any that is no throttle turn a motor.
            prop_assert_eq!(value == 0, throttle <= 0.0 || throttle.is_nan());
        }

        #[test]
        fn more_throttle_is_never_less(a: f32, b: f32) {
            prop_assume!(a <= b);
            prop_assert!(Frame::throttle(a).bits() >> 5 <= Frame::throttle(b).bits() >> 5);
        }

        #[test]
        fn the_pulses_are_the_bits(throttle in 0.0_f32..=1.0) {
            let frame = Frame::throttle(throttle);
            prop_assert_eq!(sampled(frame), frame.bits());
        }
    }
}
