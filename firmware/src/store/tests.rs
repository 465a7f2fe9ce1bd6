use proptest::prelude::*;
use std::vec::Vec;

use super::{
    Damage, Flash, FlashFault, HEADER_BYTES, Key, SECTOR_BYTES, Sector, Store, StoreError, VALUE_BYTES,
};

extern crate std;

/// Flash whose supply can fail at any step: a word being programmed then has some of its bits, a sector being erased is a
/// patchwork of old, blank and arbitrary words.
#[derive(Clone)]
struct Mock {
    sectors: [Vec<u8>; 2],
    /// Steps (words programmed, sectors erased) until the supply fails.
    steps_left: Option<u32>,
    off: bool,
    noise: u64,
    steps: u32,
    erases: u32,
}

impl Mock {
    fn new(noise: u64) -> Self {
        let blank = || std::vec![0xFF; SECTOR_BYTES];
        Self {
            sectors: [blank(), blank()],
            steps_left: None,
            off: false,
            noise: noise | 1,
            steps: 0,
            erases: 0,
        }
    }

    fn random(&mut self) -> u64 {
        self.noise ^= self.noise << 13;
        self.noise ^= self.noise >> 7;
        self.noise ^= self.noise << 17;
        self.noise
    }

    /// Whether this step is cut short.
    fn cut(&mut self) -> Result<bool, FlashFault> {
        if self.off {
            return Err(FlashFault::Busy);
        }
        self.steps += 1;
        self.off = self.steps_left == Some(0);
        self.steps_left = self.steps_left.map(|left| left.saturating_sub(1));
        Ok(self.off)
    }

    fn power_up(&mut self) {
        (self.off, self.steps_left) = (false, None);
    }
}

impl Flash for Mock {
    fn read(&mut self, sector: Sector, offset: usize, into: &mut [u8]) -> Result<(), FlashFault> {
        if self.off {
            return Err(FlashFault::Busy);
        }
        let from = self.sectors[sector as usize].get(offset..offset + into.len());
        into.copy_from_slice(from.ok_or(FlashFault::Place)?);
        Ok(())
    }

    fn program(&mut self, sector: Sector, offset: usize, word: u32) -> Result<(), FlashFault> {
        assert!(offset.is_multiple_of(4) && offset + 4 <= SECTOR_BYTES);
        let cut = self.cut()?;
        let some = self.random() as u32;
        let cell = &mut self.sectors[sector as usize][offset..offset + 4];
        let old = u32::from_le_bytes(cell.try_into().expect("four bytes"));
        assert_eq!(!old & word, 0, "a bit has to rise");
        let new = if cut { old & (word | some) } else { word };
        cell.copy_from_slice(&new.to_le_bytes());
        if cut { Err(FlashFault::Busy) } else { Ok(()) }
    }

    fn erase(&mut self, sector: Sector) -> Result<(), FlashFault> {
        let cut = self.cut()?;
        self.erases += 1;
        let mut content = std::mem::take(&mut self.sectors[sector as usize]);
        // How much is still as it was differs from cut to cut.
        let old_part = self.random() % 17;
        for word in content.chunks_mut(4) {
            let random = self.random();
            if !cut || random % 16 >= old_part {
                word.fill(0xFF);
                if cut && random >> 8 & 3 == 0 {
                    word.copy_from_slice(&(random as u32).to_le_bytes());
                }
            }
        }
        self.sectors[sector as usize] = content;
        if cut { Err(FlashFault::Busy) } else { Ok(()) }
    }
}

#[derive(Clone, Copy, Debug)]
enum Act {
    Write(usize, usize, u8),
    Remove(usize),
    Format,
}

fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        12 => (0..Key::ALL.len(), 0..=VALUE_BYTES, any::<u8>()).prop_map(|(k, n, b)| Act::Write(k, n, b)),
        2 => (0..Key::ALL.len()).prop_map(Act::Remove),
        1 => Just(Act::Format),
    ]
}

type Values = [Option<Vec<u8>>; Key::ALL.len()];

fn bytes(length: usize, first: u8) -> Vec<u8> {
    (0..length).map(|n| first.wrapping_add((n as u8).wrapping_mul(7))).collect()
}

fn apply(store: &mut Store<Mock>, act: Act) -> Result<(), StoreError> {
    match act {
        Act::Write(key, length, first) => store.write(Key::ALL[key], &bytes(length, first)),
        Act::Remove(key) => store.remove(Key::ALL[key]),
        Act::Format => store.format(),
    }
}

fn expected(values: &Values, act: Act) -> Values {
    let mut values = values.clone();
    match act {
        Act::Write(key, length, first) => values[key] = Some(bytes(length, first)),
        Act::Remove(key) => values[key] = None,
        Act::Format => values = Values::default(),
    }
    values
}

fn values(store: &mut Store<Mock>) -> Values {
    let mut buffer = [0; VALUE_BYTES];
    Key::ALL.map(|key| {
        let length = store.read(key, &mut buffer).expect("flash that works");
        length.map(|length| buffer[..length].to_vec())
    })
}

/// Runs `acts` with the supply failing at step `cut`, then the rest of them with power. Answers whether it failed.
fn survive(acts: &[Act], cut: u32, noise: u64) -> bool {
    let mut store = Store::new(Mock::new(noise));
    store.flash().steps_left = Some(cut);
    let mut known = Values::default();
    let mut failed = false;
    for &act in acts {
        let next = expected(&known, act);
        let result = apply(&mut store, act);
        if result.is_ok() {
            known = next;
            continue;
        }
        assert!(store.flash().off && !failed, "{act:?}: {result:?}");
        failed = true;
        store.flash().power_up();
        let found = values(&mut store);
        for (n, value) in found.iter().enumerate() {
            assert!(*value == known[n] || *value == next[n], "{:?} after {act:?}: {value:?}", Key::ALL[n]);
        }
        assert!(!any_damaged(&mut store), "after {act:?}");
        known = found;
        // It stays usable.
        apply(&mut store, act).expect("the power is back");
        known = expected(&known, act);
    }
    assert_eq!(values(&mut store), known);
    assert!(!any_damaged(&mut store));
    failed
}

fn damage(store: &mut Store<Mock>) -> Damage {
    store.damage().expect("flash that works")
}

fn any_damaged(store: &mut Store<Mock>) -> bool {
    damage(store).is_any()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn each_key_has_its_old_or_its_new_value_after_a_power_cut(
        acts in prop::collection::vec(act(), 1..200), cut in 0_u32..6000, noise: u64,
    ) {
        survive(&acts, cut, noise);
    }

    /// A second cut, in what the first one left.
    #[test]
    fn two_cuts_in_a_row_are_survived(
        acts in prop::collection::vec(act(), 1..120), cuts in prop::array::uniform2(0_u32..4000), noise: u64,
    ) {
        let mut store = Store::new(Mock::new(noise));
        let mut known = Values::default();
        let mut cuts = cuts.into_iter();
        store.flash().steps_left = cuts.next();
        for act in acts {
            for _ in 0..3 {
                let next = expected(&known, act);
                if apply(&mut store, act).is_ok() {
                    known = next;
                    break;
                }
                store.flash().power_up();
                let found = values(&mut store);
                for (n, value) in found.iter().enumerate() {
                    prop_assert!(*value == known[n] || *value == next[n]);
                }
                prop_assert!(!any_damaged(&mut store));
                known = found;
                store.flash().steps_left = cuts.next().map(|cut| cut % 300);
            }
        }
        store.flash().power_up();
        prop_assert_eq!(values(&mut store), known);
    }

    #[test]
    fn whatever_flash_holds_it_can_be_used(noise: u64, header: bool, act in act()) {
        let mut flash = Mock::new(noise);
        for sector in 0..2 {
            let content: Vec<u8> = (0..SECTOR_BYTES).map(|_| (flash.random() >> 24) as u8).collect();
            flash.sectors[sector] = content;
        }
        let mut store = Store::new(flash);
        if header {
            // A good header before garbage.
            let mut good = Store::new(Mock::new(1));
            good.write(Key::Vehicle, &[1, 2, 3]).expect("a value");
            store.flash().sectors[1][..HEADER_BYTES].copy_from_slice(&good.flash().sectors[0][..HEADER_BYTES]);
        }
        prop_assert_eq!(values(&mut store), Values::default());
        apply(&mut store, act).expect("room");
        prop_assert_eq!(values(&mut store), expected(&Values::default(), act));
    }

    /// Bits flip anywhere, most of them where something is written: whatever is not read as it was is told, and written anew it
    /// is well again.
    #[test]
    fn damage_that_changes_what_is_read_is_told(
        acts in prop::collection::vec(act(), 1..150), noise: u64,
        flips in prop::collection::vec((any::<bool>(), any::<prop::sample::Index>(), 0..8_u32), 1..4),
        headers in prop::collection::vec((any::<bool>(), 0..20_usize, 0..8_u32), 0..2),
    ) {
        let mut store = Store::new(Mock::new(noise));
        let mut known = Values::default();
        for act in acts {
            apply(&mut store, act).expect("room");
            known = expected(&known, act);
        }
        for (second, place, bit) in flips {
            let sector = &mut store.flash().sectors[usize::from(second)];
            let used = sector.iter().rposition(|byte| *byte != 0xFF).map_or(SECTOR_BYTES, |last| last + 1);
            sector[place.index(used)] ^= 1 << bit;
        }
        for (second, place, bit) in headers {
            store.flash().sectors[usize::from(second)][place] ^= 1 << bit;
        }
        let mut found = values(&mut store);
        for (n, key) in Key::ALL.into_iter().enumerate() {
            prop_assert!(found[n] == known[n] || damage(&mut store).of(key), "{:?}", key);
        }
        for (n, key) in Key::ALL.into_iter().enumerate() {
            match &known[n] {
                Some(value) => store.write(key, value).expect("room"),
                None => store.remove(key).expect("room"),
            }
        }
        found = values(&mut store);
        prop_assert_eq!(found, known);
        prop_assert!(!any_damaged(&mut store));
    }

    #[test]
    fn a_flipped_bit_never_makes_a_value(bit in 0..SECTOR_BYTES * 8) {
        let mut store = Store::new(Mock::new(3));
        let both = [bytes(100, 1), bytes(200, 9)];
        for value in &both {
            store.write(Key::Table(3), value).expect("room");
        }
        store.flash().sectors[0][bit / 8] ^= 1 << (bit % 8);
        let found = values(&mut store)[5].clone();
        prop_assert!(found.is_none_or(|found| both.contains(&found)));
    }
}

/// Every step of a sequence that moves twice, formats and removes.
#[test]
fn every_single_step_can_be_the_last() {
    let mut acts: Vec<Act> = (0..150).map(|n| Act::Write(n % 10, (n * 37) % 257, n as u8)).collect();
    acts.extend([Act::Remove(3), Act::Format, Act::Write(0, 90, 4), Act::Remove(0), Act::Write(1, 8, 8)]);
    let mut cut = 0;
    while survive(&acts, cut, 0x1234_5678 + u64::from(cut)) {
        cut += 1;
    }
    assert!(cut > 5000, "{cut}");
}

#[test]
fn a_value_that_is_there_is_not_written_again() {
    let mut store = Store::new(Mock::new(1));
    store.write(Key::Settings, &[5; 30]).expect("room");
    let steps = store.flash().steps;
    store.write(Key::Settings, &[5; 30]).expect("room");
    store.remove(Key::Vehicle).expect("nothing to do");
    assert_eq!(store.flash().steps, steps);
    assert_eq!(store.write(Key::Settings, &[0; 257]), Err(StoreError::TooLong));
    assert_eq!(store.read(Key::Settings, &mut [0; 10]), Err(StoreError::Buffer(30)));
}

#[test]
fn wear_is_spread() {
    let mut store = Store::new(Mock::new(1));
    for n in 0..10_000_u32 {
        store.write(Key::Vehicle, &n.to_le_bytes()).expect("room");
    }
    // 16 bytes a record in 16 KiB.
    assert_eq!(store.flash().erases, 10_000 / ((SECTOR_BYTES as u32 - 20) / 16) + 1);
}

/// Every bit of a store with a move behind it, one at a time.
#[test]
fn every_single_flipped_bit_that_matters_is_told() {
    let mut store = Store::new(Mock::new(7));
    for n in 0..70_u8 {
        store.write(Key::Table(n % 8), &bytes(250, n)).expect("room");
    }
    store.remove(Key::Table(1)).expect("room");
    assert_eq!(store.flash().erases, 2);
    let known = values(&mut store);
    let (mut told, mut changed) = (0, 0);
    for sector in 0..2 {
        // Of the sector left behind the header and what stands next to it.
        let bytes = if sector == 0 { 64 } else { SECTOR_BYTES };
        for bit in (0..bytes * 8).filter(|bit| *bit < 4096 || bit % 7 == 0) {
            store.flash().sectors[sector][bit / 8] ^= 1 << (bit % 8);
            let found = values(&mut store);
            for (n, key) in Key::ALL.into_iter().enumerate() {
                let damaged = damage(&mut store).of(key);
                assert!(damaged || found[n] == known[n], "{key:?}: bit {bit} of sector {sector}");
                assert!(!damaged || sector == 1, "{key:?}: bit {bit} of what was left behind");
                told += u32::from(damaged);
                changed += u32::from(found[n] != known[n]);
            }
            store.flash().sectors[sector][bit / 8] ^= 1 << (bit % 8);
        }
    }
    assert!(told >= changed && changed > 1000, "{told} {changed}");
}

#[test]
fn a_value_written_again_is_damaged_no_more() {
    let mut store = Store::new(Mock::new(1));
    store.write(Key::Settings, &[1; 30]).expect("room");
    store.write(Key::Settings, &[2; 30]).expect("room");
    // A bit of the second value.
    store.flash().sectors[0][HEADER_BYTES + 44 + 10] ^= 1;
    assert!(damage(&mut store).of(Key::Settings));
    assert!(!damage(&mut store).of(Key::Vehicle));
    assert_eq!(store.read(Key::Settings, &mut [0; 30]), Ok(Some(30)));
    // Also where it is the very value that counts now.
    store.write(Key::Settings, &[1; 30]).expect("room");
    assert!(!damage(&mut store).of(Key::Settings));
}

/// Damaged settings are told over moves, and over power cuts at any step of them.
#[test]
fn writing_another_key_mends_nothing() {
    let mut damaged = Store::new(Mock::new(1));
    damaged.write(Key::Settings, &[1; 30]).expect("room");
    damaged.write(Key::Settings, &[2; 30]).expect("room");
    damaged.flash().sectors[0][HEADER_BYTES + 44 + 10] ^= 1;
    // The header of the only sector, or of the latest one.
    let mut first = damaged.clone();
    first.flash().sectors[0][5] ^= 1;
    let mut second = damaged.clone();
    while second.flash().erases < 2 {
        let n = second.flash().steps as u8;
        second.write(Key::Vehicle, &[n; 200]).expect("room");
    }
    second.flash().sectors[1][5] ^= 1;
    for mut store in [damaged, first, second] {
        for n in 0..200 {
            let before = store.clone();
            let steps = store.flash().steps;
            assert!(damage(&mut store).of(Key::Settings), "before write {n}");
            store.write(Key::Vehicle, &bytes(250, n)).expect("room");
            assert!(damage(&mut store).of(Key::Settings), "after write {n}");
            assert!(!damage(&mut store).of(Key::Vehicle), "after write {n}");
            for cut in 0..store.flash().steps - steps {
                let mut store = before.clone();
                store.flash().steps_left = Some(cut);
                store.write(Key::Vehicle, &bytes(250, n)).expect_err("the power is cut");
                store.flash().power_up();
                assert!(damage(&mut store).of(Key::Settings), "write {n} cut at step {cut}");
            }
        }
        for key in Key::ALL.into_iter().filter(|key| *key != Key::Vehicle) {
            store.remove(key).expect("room");
        }
        assert!(!any_damaged(&mut store));
    }
}

/// What a cut has left unconfirmed is made good by the next write, of whatever key: from then on a bit that flips in it is told.
#[test]
fn what_a_power_cut_left_unconfirmed_is_confirmed_by_the_next_write() {
    let mut first = Store::new(Mock::new(1));
    for (begin, key) in [(false, Key::Pairing), (true, Key::Pairing), (true, Key::Vehicle)] {
        if begin {
            first.write(Key::Pairing, &[3; 12]).expect("room");
        }
        let mut whole = first.clone();
        let steps = whole.flash().steps;
        whole.write(Key::Pairing, &[5; 16]).expect("room");
        for cut in 0..whole.flash().steps - steps {
            let mut store = first.clone();
            store.flash().steps_left = Some(cut);
            store.write(Key::Pairing, &[5; 16]).expect_err("the power is cut");
            store.flash().power_up();
            store.write(key, &[5; 16]).expect("the power is back");
            let known = values(&mut store);
            for bit in 0..2 * 256 * 8 {
                let (sector, bit) = (bit / (256 * 8), bit % (256 * 8));
                store.flash().sectors[sector][bit / 8] ^= 1 << (bit % 8);
                let told = damage(&mut store).of(Key::Pairing);
                let right = values(&mut store)[2] == known[2];
                assert!(told || right, "cut at step {cut}, bit {bit} of sector {sector}");
                store.flash().sectors[sector][bit / 8] ^= 1 << (bit % 8);
            }
        }
    }
}

/// What an earlier firmware has laid out otherwise is told, until each key has been written.
#[test]
fn an_earlier_layout_is_told() {
    for magic in [*b"MTS1", *b"MTS2"] {
        let mut store = Store::new(Mock::new(1));
        let header = [magic, 7_u32.to_le_bytes()].concat();
        let check = mintime_shared::crc32(&header).to_le_bytes();
        // Behind it records, which may read as a confirmation or not.
        for next in [0x0000_1E01_u32, 0xFFFF_FE01] {
            let sector = &mut store.flash().sectors[1];
            sector[..16].copy_from_slice(&[&header[..], &check, &next.to_le_bytes()].concat());
            assert_eq!(damage(&mut store), Damage::ALL);
        }
        assert_eq!(values(&mut store), Values::default());
        store.write(Key::Vehicle, &[1; 20]).expect("room");
        assert!(!damage(&mut store).of(Key::Vehicle));
        for key in &Key::ALL[1..] {
            assert!(damage(&mut store).of(*key), "{key:?}");
            store.remove(*key).expect("room");
        }
        assert!(!any_damaged(&mut store));
    }
}

#[test]
fn flash_that_holds_nothing_is_told() {
    /// Nothing that is written stays.
    struct Worn;
    impl Flash for Worn {
        fn read(&mut self, _: Sector, _: usize, into: &mut [u8]) -> Result<(), FlashFault> {
            into.fill(0xFF);
            Ok(())
        }
        fn program(&mut self, _: Sector, _: usize, _: u32) -> Result<(), FlashFault> {
            Ok(())
        }
        fn erase(&mut self, _: Sector) -> Result<(), FlashFault> {
            Ok(())
        }
    }
    let mut store = Store::new(Worn);
    assert_eq!(store.write(Key::Vehicle, &[1]), Err(StoreError::WornOut));
    assert_eq!(store.read(Key::Vehicle, &mut [0; 4]), Ok(None));
}
