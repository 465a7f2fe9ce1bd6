//! The store and its flash driver on the emulated chip: at work, and with the power cut anywhere.

use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

use emulator::chip::{BareBoard, Chip};
use emulator::core::Timing;
use emulator::machine::symbol_address;
use emulator::{Machine, Stop};

const KEYS: usize = mintime_firmware::store::Key::ALL.len();
/// The internal oscillator.
const CYCLES_PER_MS: u64 = 16_000;

fn elf() -> &'static [u8] {
    static ELF: OnceLock<Vec<u8>> = OnceLock::new();
    ELF.get_or_init(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a workspace");
        let target = "thumbv7em-none-eabihf";
        let folder = root.join("target/firmware");
        let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .current_dir(root)
            .args(["build", "--quiet", "--profile", "firmware", "--package", "mintime-firmware"])
            .args(["--features", "store-check", "--bin", "store-check", "--target", target, "--target-dir"])
            .arg(&folder)
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("CARGO_BUILD_TARGET")
            .output()
            .expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        std::fs::read(folder.join(target).join("firmware/store-check")).expect("an image")
    })
}

struct Board {
    machine: Machine<Chip<BareBoard>>,
    report: u32,
}

#[derive(Debug)]
struct Report {
    stage: u32,
    bad: u32,
    found: [u32; KEYS],
    confirmed: [u32; KEYS],
    write_us: u32,
    move_us: u32,
    writes: u32,
    moves: u32,
}

impl Board {
    fn new(timing: Timing, slowness: f64, lsi_hz: u32) -> Self {
        let report = symbol_address(elf(), "REPORT").expect("the report");
        let mut machine = Machine::new(Chip::new(BareBoard::default()), timing, 7);
        machine.peripherals.set_flash_slowness(slowness);
        machine.peripherals.set_lsi_hz(lsi_hz);
        machine.load_elf(elf()).expect("an image");
        Self { machine, report }
    }

    fn run(&mut self, cycles: u64) {
        let limit = self.machine.time() + cycles;
        assert_eq!(self.machine.run_until(limit), Stop::ReachedTime);
    }

    fn report(&self) -> Report {
        let bytes = self.machine.memory.peek(self.report, 4 * (6 + 2 * KEYS as u32)).expect("RAM");
        let words: Vec<u32> = bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
        let keys = |from: usize| std::array::from_fn(|key| words[from + key]);
        let [write, moved, writes, moves] = std::array::from_fn(|n| words[2 + 2 * KEYS + n]);
        Report {
            stage: words[0],
            bad: words[1],
            found: keys(2),
            confirmed: keys(2 + KEYS),
            write_us: write / 16,
            move_us: moved / 16,
            writes,
            moves,
        }
    }

    fn assert_no_bugs(&self) {
        assert!(self.machine.memory.bugs.is_empty(), "{:?}", self.machine.memory.bugs);
    }
}

/// At both ends of the watchdog's oscillator and of the erase's time: nothing fails, nothing is reset, no cache is stale.
#[test]
fn the_store_works_on_the_chip() {
    for (slowness, lsi_hz) in [(0.0, 32_000), (1.0, 47_000), (1.0, 17_000)] {
        let mut board = Board::new(Timing::Pessimistic, slowness, lsi_hz);
        board.run(3_000 * CYCLES_PER_MS);
        let report = board.report();
        println!("{report:?}");
        assert_eq!((report.stage, report.bad), (1, 0), "{report:?}");
        assert_eq!(report.found, [0; KEYS], "no reset");
        assert!(report.moves >= 2 && report.writes > 100, "{report:?}");
        let longest_ms = if slowness > 0.0 { 620 } else { 370 };
        assert!(report.move_us < longest_ms * 1000, "{report:?}");
        // A write without a move programs its words and nothing else: 0.1 ms each at most.
        assert!(report.write_us < 10_000, "{report:?}");
        board.assert_no_bugs();
    }
}

/// Wherever the power fails, each key has the value that was confirmed last or the one that was being written.
#[test]
fn a_power_cut_anywhere_costs_no_value() {
    let mut board = Board::new(Timing::Optimistic, 0.0, 32_000);
    let mut random = 0x9E37_79B9_7F4A_7C15_u64;
    let mut before = [0; KEYS];
    for cut in 0..60 {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        // Most of these fall into an erase or a word.
        board.run(random % (580 * CYCLES_PER_MS));
        let confirmed = board.report().confirmed;
        let known: [u32; KEYS] = std::array::from_fn(|key| confirmed[key].max(before[key]));
        board.machine.peripherals.cut_power(&mut board.machine.memory, random);
        // Looking at all keys takes up to 40 ms at this clock.
        board.run(60 * CYCLES_PER_MS);
        let report = board.report();
        assert_eq!((report.stage, report.bad), (1, 0), "cut {cut}: {report:?}");
        let newest = known.iter().max().copied().unwrap_or(0);
        for (key, (found, known)) in report.found.into_iter().zip(known).enumerate() {
            assert!(found == known || found == newest + 1, "cut {cut}, key {key}: {known} became {found}");
        }
        before = report.found;
    }
    println!("{before:?} after 60 cuts");
    assert!(before.iter().all(|n| *n > 10), "{before:?}");
    board.assert_no_bugs();
}
