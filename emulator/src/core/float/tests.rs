//! The host's shortcut against the exact path, and the corners of the flags.
use super::*;

/// SplitMix64, with exponents drawn to a middle where shortcuts apply.
fn operands(state: &mut u64) -> [u32; 3] {
    std::array::from_fn(|_| {
        *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (*state ^ (*state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let bits = ((z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB) >> 16) as u32;
        if z & 3 == 0 { bits } else { bits & 0x87FF_FFFF | 0x3C00_0000 }
    })
}

#[test]
fn the_host_and_the_exact_path_agree() {
    let mut state = 1;
    for _ in 0..200_000 {
        let [a, b, c] = operands(&mut state);
        // With Inexact raised the shortcut is open; without it, it is not.
        let both = |operation: &dyn Fn(&mut Context) -> u32| {
            let (mut fast, mut exact) = (Context::new(IXC), Context::new(0));
            let results = (operation(&mut fast), operation(&mut exact));
            assert_eq!(results.0, results.1, "{a:08x} {b:08x} {c:08x}");
            assert_eq!(fast.fpscr, exact.fpscr | IXC);
        };
        both(&|context| add(context, a, b));
        both(&|context| subtract(context, a, b));
        both(&|context| multiply(context, a, b));
        both(&|context| divide(context, a, b));
        both(&|context| square_root(context, a));
        both(&|context| fused(context, a, b, c));
    }
}

fn with(fpscr: u32, operation: impl Fn(&mut Context) -> u32) -> (u32, u32) {
    let mut context = Context::new(fpscr);
    let result = operation(&mut context);
    (result, context.fpscr & !fpscr)
}

#[test]
fn tininess_is_found_before_rounding() {
    // The largest number below the smallest normal one, times the next above one, rounds up to normal.
    let (tiny, above) = (0x007F_FFFF, 0x3F80_0001);
    assert_eq!(with(0, |context| multiply(context, tiny, above)), (0x0080_0000, UFC | IXC));
    assert_eq!(with(FZ, |context| multiply(context, 0x0080_0000, 0x3F00_0000)), (0, UFC));
    assert_eq!(with(FZ, |context| add(context, tiny, 0)), (0, IDC));
}

#[test]
fn overflow_goes_where_rounding_points() {
    let largest = 0x7F7F_FFFF;
    for (mode, result) in [(0, INFINITY), (1, INFINITY), (2, largest), (3, largest)] {
        assert_eq!(with(mode << 22, |context| add(context, largest, largest)), (result, OFC | IXC));
    }
}

#[test]
fn nans_keep_or_lose_their_payload() {
    let (signaling, quiet) = (0x7F80_0001, 0xFFC0_0002);
    assert_eq!(with(0, |context| add(context, quiet, signaling)), (0x7FC0_0001, IOC));
    assert_eq!(with(0, |context| add(context, quiet, 0)), (quiet, 0));
    assert_eq!(with(DN, |context| add(context, quiet, 0)), (DEFAULT_NAN, 0));
    // Infinity times zero plus a quiet NaN is invalid and forgets the NaN.
    assert_eq!(with(0, |context| fused(context, INFINITY, 0, quiet)), (DEFAULT_NAN, IOC));
}
