use proptest::prelude::*;
use std::vec::Vec;

use super::*;

extern crate std;

const MS: u64 = 1000;

fn frame(kind: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = std::vec![ADDRESS_FLIGHT_CONTROLLER, payload.len() as u8 + 2, kind];
    bytes.extend_from_slice(payload);
    bytes.push(crc8(&bytes[2..]));
    bytes
}

fn channels(values: [u16; CHANNELS]) -> Vec<u8> {
    let mut payload = [0; CHANNELS_BYTES];
    for (n, value) in values.into_iter().enumerate() {
        for bit in (0..CHANNEL_BITS).filter(|bit| value >> bit & 1 == 1) {
            let at = n * CHANNEL_BITS + bit;
            payload[at / 8] |= 1 << (at % 8);
        }
    }
    frame(TYPE_CHANNELS, &payload)
}

/// All channels in the middle but the switch.
fn switch(value: u16) -> Vec<u8> {
    let mut values = [992; CHANNELS];
    values[4] = value;
    channels(values)
}

fn quality(percent: u8) -> Vec<u8> {
    frame(TYPE_LINK_STATISTICS, &[90, 90, percent, 5, 0, 2, 3, 90, 100, 5])
}

const HIGH: u16 = 1811;
const MIDDLE: u16 = 992;
const LOW: u16 = 172;

/// A switch that runs.
fn running(now_us: u64) -> KillSwitch {
    let mut kill = KillSwitch::new(KillSwitchConfig::DEFAULT);
    for _ in 0..3 {
        kill.update(now_us, &switch(HIGH));
    }
    assert_eq!(kill.state(), KillState::Run);
    kill
}

/// Another channel is another switch: lost until it is heard. That there is none must not be concluded from it.
#[test]
fn a_switch_that_becomes_another_is_lost_until_it_is_heard() {
    let mut kill = running(0);
    kill.configure(KillSwitchConfig::DEFAULT);
    assert_eq!(kill.state(), KillState::Run);
    let other = KillSwitchConfig { channel: 6, ..KillSwitchConfig::DEFAULT };
    kill.configure(other);
    for ms in 0..1000 {
        assert_eq!(kill.state(), KillState::Lost);
        assert_eq!(kill.update(ms * MS, &[]), KillState::Lost);
    }
    // The old channel says run for as long as it likes: the new one counts.
    for n in 0..5 {
        assert_eq!(kill.update((1000 + n) * MS, &switch(HIGH)), KillState::Kill);
    }
    for n in 5..10 {
        let state = kill.update((1000 + n) * MS, &channels([HIGH; CHANNELS]));
        assert_eq!(state, if n < 7 { KillState::Kill } else { KillState::Run }, "{n}");
    }
    assert_eq!(kill.frames(), 10);
    let mut silent = KillSwitch::new(KillSwitchConfig::DEFAULT);
    silent.configure(other);
    assert_eq!(silent.update(0, &[]), KillState::Unknown);
}

/// The check value of CRC-8/DVB-S2 in the catalogue of CRCs.
#[test]
fn the_checksum_is_the_published_one() {
    assert_eq!(crc8(b"123456789"), 0xBC);
}

#[test]
fn channels_are_what_was_sent() {
    let values: [u16; CHANNELS] = core::array::from_fn(|n| (n as u16 * 131 + 7) & 0x7FF);
    let mut parser = Parser::new();
    let bytes = channels(values);
    assert_eq!(bytes.len(), 26);
    let frames: Vec<_> = bytes.into_iter().filter_map(|byte| parser.push(byte)).collect();
    assert_eq!(frames, [Frame::Channels(values)]);
    assert_eq!([LOW, MIDDLE, HIGH].map(pulse_us), [987, 1500, 2011]);
    assert_eq!(pulse_us(u16::MAX), 2159);
}

#[test]
fn it_takes_three_frames_to_run_and_one_to_kill() {
    let mut kill = KillSwitch::new(KillSwitchConfig::DEFAULT);
    assert_eq!(kill.update(0, &[]), KillState::Unknown);
    assert_eq!(kill.update(MS, &switch(HIGH)), KillState::Kill);
    assert_eq!(kill.update(5 * MS, &switch(HIGH)), KillState::Kill);
    assert_eq!(kill.update(9 * MS, &switch(HIGH)), KillState::Run);
    for position in [LOW, MIDDLE, 0, 1310] {
        let mut kill = running(0);
        assert_eq!(kill.update(MS, &switch(position)), KillState::Kill, "{position}");
        assert_eq!(kill.update(2 * MS, &switch(HIGH)), KillState::Kill);
        assert_eq!(kill.update(3 * MS, &switch(HIGH)), KillState::Kill);
        assert_eq!(kill.update(4 * MS, &switch(HIGH)), KillState::Run);
    }
}

#[test]
fn silence_and_a_dead_link_are_a_kill() {
    let mut kill = running(0);
    assert_eq!(kill.update(LOST_US, &[]), KillState::Run);
    assert_eq!(kill.update(LOST_US + 1, &[]), KillState::Lost);
    assert!(kill.state().kills());
    // Back, and again three frames.
    assert_eq!(kill.update(LOST_US + 2, &switch(HIGH)), KillState::Kill);

    let mut kill = running(0);
    assert_eq!(kill.update(MS, &quality(100)), KillState::Run);
    assert_eq!(kill.update(MS, &quality(0)), KillState::Lost);
    // A receiver in failsafe may go on repeating the last channels.
    for n in 2..20 {
        assert_eq!(kill.update(n * MS, &switch(HIGH)), KillState::Lost);
    }
    kill.update(20 * MS, &quality(70));
    assert_eq!(kill.update(21 * MS, &switch(HIGH)), KillState::Kill);

    // A clock that goes back.
    assert_eq!(running(10 * MS).update(9 * MS, &[]), KillState::Lost);
}

/// A switch that bounces, or bytes of many milliseconds at once.
#[test]
fn a_stop_among_frames_that_run_is_seen() {
    let back: Vec<u8> = (0..3).flat_map(|_| switch(HIGH)).collect();
    let dips = [(switch(LOW), KillState::Kill), ([quality(0), quality(90)].concat(), KillState::Lost)];
    for (dip, seen) in dips {
        let mut kill = running(0);
        assert_eq!(kill.update(MS, &[dip, back.clone()].concat()), seen);
        assert_eq!(kill.state(), seen);
        // The call after it tells how it is.
        assert_eq!(kill.update(2 * MS, &[]), KillState::Run);
        assert_eq!(kill.state(), KillState::Run);
    }
    // What never ran has not stopped.
    let mut kill = KillSwitch::new(KillSwitchConfig::DEFAULT);
    assert_eq!(kill.update(0, &[switch(LOW), back.clone()].concat()), KillState::Run);
}

#[test]
fn other_frames_and_other_channels_do_not_matter() {
    let mut kill = running(0);
    kill.update(MS, &frame(0x08, &[0; 8]));
    kill.update(MS, &frame(TYPE_CHANNELS, &[0; 10]));
    assert_eq!(kill.state(), KillState::Run);
    let config = KillSwitchConfig { channel: 17, ..KillSwitchConfig::DEFAULT };
    assert!(!config.is_valid() && KillSwitchConfig::DEFAULT.is_valid());
    for channel in [0, 17, 255] {
        let mut kill = KillSwitch::new(KillSwitchConfig { channel, ..KillSwitchConfig::DEFAULT });
        (0..9).for_each(|n| assert_eq!(kill.update(n, &channels([HIGH; 16])), KillState::Kill));
    }
}

/// A length is that of type, payload and checksum: 2 to 62. What claims another is no beginning, and keeps nothing waiting.
#[test]
fn a_length_that_no_frame_has_begins_none() {
    for length in 0..=u8::MAX {
        let mut parser = Parser::new();
        let mut heard = |bytes: &[u8]| bytes.iter().filter_map(|byte| parser.push(*byte)).collect::<Vec<_>>();
        if (2..=62).contains(&length) {
            let bytes = frame(0x08, &std::vec![7; usize::from(length) - 2]);
            assert_eq!(bytes[1], length);
            assert_eq!(heard(&bytes), [Frame::Other], "{length}");
        } else {
            assert_eq!(heard(&[ADDRESS_FLIGHT_CONTROLLER, length, 7]), []);
        }
        assert_eq!(heard(&switch(HIGH)).len(), 1, "{length}");
    }
}

/// Link statistics have ten bytes: another frame of that type says nothing of the link.
#[test]
fn link_statistics_of_another_length_are_none() {
    for length in 3..=60 {
        let mut kill = running(0);
        let mut payload = std::vec![90; length];
        payload[LINK_QUALITY] = 0;
        let seen = kill.update(MS, &frame(TYPE_LINK_STATISTICS, &payload));
        let whole = length == STATISTICS_BYTES;
        assert_eq!(seen, if whole { KillState::Lost } else { KillState::Run }, "{length}");
        assert_eq!((kill.link_quality(), kill.errors()), (whole.then_some(0), u32::from(!whole)), "{length}");
    }
}

#[test]
fn a_frame_behind_a_broken_one_is_heard() {
    let mut kill = running(0);
    let mut bytes = switch(HIGH);
    bytes.truncate(20);
    bytes.extend(switch(LOW));
    bytes.extend(switch(LOW));
    assert_eq!(kill.update(MS, &bytes), KillState::Kill);
    assert!(kill.errors() > 0);
}

#[test]
fn every_single_flipped_bit_is_refused() {
    let good = switch(HIGH);
    for bit in 0..good.len() * 8 {
        let mut bytes = good.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let mut parser = Parser::new();
        // Enough behind it for any length that the flipped one may claim.
        let rest = [0; FRAME_BYTES];
        let heard = bytes.iter().chain(&rest).filter_map(|byte| parser.push(*byte)).count();
        assert_eq!(heard, 0, "bit {bit}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Noise of half a second, in pieces.
    #[test]
    fn noise_never_runs(pieces in prop::collection::vec(prop::collection::vec(any::<u8>(), 0..128), 0..40)) {
        let mut kill = KillSwitch::new(KillSwitchConfig::DEFAULT);
        for (n, piece) in pieces.iter().enumerate() {
            prop_assert!(kill.update(n as u64 * 1250, piece).kills());
        }
    }

    /// However the bytes are cut into calls the answer is the same.
    #[test]
    fn pieces_do_not_matter(cuts in prop::collection::vec(1_usize..30, 1..40), low: bool) {
        let mut bytes = Vec::new();
        (0..4).for_each(|_| bytes.extend(switch(HIGH)));
        bytes.extend(quality(90));
        bytes.extend(switch(if low { LOW } else { HIGH }));
        let mut kill = KillSwitch::new(KillSwitchConfig::DEFAULT);
        let mut rest = bytes.as_slice();
        for cut in cuts.into_iter().chain([usize::MAX]) {
            let (now, later) = rest.split_at(cut.min(rest.len()).min(BYTES_PER_CALL));
            kill.update(0, now);
            rest = later;
        }
        while !rest.is_empty() {
            let (now, later) = rest.split_at(rest.len().min(BYTES_PER_CALL));
            kill.update(0, now);
            rest = later;
        }
        prop_assert_eq!(kill.state(), if low { KillState::Kill } else { KillState::Run });
    }

    #[test]
    fn any_clock_and_any_settings_are_taken(
        times: Vec<u64>, channel: u8, run_above_us: u16, frames_to_run: u8, value in 0_u16..2048,
    ) {
        let config = KillSwitchConfig { channel, run_above_us, frames_to_run };
        let mut kill = KillSwitch::new(config);
        for now_us in times {
            kill.update(now_us, &switch(value));
        }
        let seen = if channel == 5 { value } else { MIDDLE };
        prop_assert!(kill.state().kills() || pulse_us(seen) > run_above_us);
    }
}
