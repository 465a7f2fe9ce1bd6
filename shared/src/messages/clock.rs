//! The vehicle's clock as events and requests carry it.

/// The lowest 32 bits of a time since power-up, µs, in ms: 49 days, then it starts again. By digits of 16 bits, because a vehicle
/// divides 64 bits by a routine of a kilobyte.
#[inline(never)]
pub fn milliseconds(time_us: u64) -> u32 {
    [48, 32, 16, 0]
        .iter()
        .fold((0_u32, 0_u32), |(quotient, rest), digit| {
            let part = (rest << 16) | u32::from((time_us >> digit) as u16);
            ((quotient << 16) | (part / 1000), part % 1000)
        })
        .0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn milliseconds_are_those_of_the_division() {
        let mut time_us = 1_u64;
        for step in 0..10_000_u64 {
            time_us = time_us.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            for time_us in [time_us >> (step % 64), step, u64::MAX - step, step << 32] {
                assert_eq!(milliseconds(time_us), (time_us / 1000) as u32, "{time_us}");
            }
        }
    }
}
