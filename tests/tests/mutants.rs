//! Firmware with a mistake in it must be caught: by the emulator, by the flight logic, or by a budget.
//!
//! Each mutant is the firmware with one line changed. All are copied into a workspace of their own and built at once, beside
//! the real image, whose dependencies they share.

mod bench;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use bench::{Bench, image};
use emulator::core::Timing;
use emulator::{Machine, Stop};
use mintime::flight::{FlightError, Phase};
use mintime_shared::messages::{AbortReason, ArmingBlock, FlightState, GyroFault};

const TARGET: &str = "thumbv7em-none-eabihf";

/// From the gyro's edge to the last bit of the motors' frames, at worst, ns: what a healthy image needs, with pessimistic
/// timing of the processor, and a fiftieth more.
const LATENCY_BUDGET_NS: u32 = 100_000;

/// One line of the firmware, changed.
struct Mutant {
    name: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
}

const MUTANTS: [Mutant; 12] = [
    Mutant {
        name: "register-read-without-dummy",
        file: "src/board/spi.rs",
        from: "// A dummy comes first.\n            exchange(0)?;",
        to: "",
    },
    Mutant {
        name: "burst-without-dummy",
        file: "src/board/spi.rs",
        from: "for _ in 0..2 {",
        to: "for _ in 0..1 {",
    },
    Mutant { name: "spi-too-fast", file: "src/board/spi.rs", from: "Br::DIV16;", to: "Br::DIV8;" },
    Mutant {
        name: "reload-plus-one",
        file: "src/board/dshot.rs",
        from: "set_arr(BIT_COUNTS - 1)",
        to: "set_arr(BIT_COUNTS)",
    },
    Mutant {
        name: "wrong-stream",
        file: "src/board/facts.rs",
        from: "MOTOR_DMA_STREAM: usize = 6;",
        to: "MOTOR_DMA_STREAM: usize = 4;",
    },
    Mutant {
        name: "unclocked-port",
        file: "src/board/motors.rs",
        from: "pac::RCC.ahb1enr().modify(|w| w.set_gpioben(true));",
        to: "",
    },
    Mutant {
        name: "swapped-motors",
        file: "src/board/control.rs",
        from: "throttle.map(Frame::throttle)",
        to: "[throttle[1], throttle[0], throttle[2], throttle[3]].map(Frame::throttle)",
    },
    Mutant {
        name: "flipped-axis",
        file: "src/board/facts.rs",
        from: "    [x, y, z]\n",
        to: "    [x, -y, z]\n",
    },
    Mutant {
        name: "caches-off",
        file: "src/board/mod.rs",
        from: "core_setup::enable_flash_caches();",
        to: "",
    },
    Mutant {
        name: "early-gyro-access",
        file: "src/bmi270.rs",
        from: "POWER_SAVE_GAP_US: u64 = 500;",
        to: "POWER_SAVE_GAP_US: u64 = 100;",
    },
    Mutant {
        name: "configuration-all-to-zero",
        file: "src/bmi270.rs",
        from: "let word = byte / 2;",
        to: "let word = byte & 0;",
    },
    Mutant {
        name: "buffer-after-enable",
        file: "src/board/dshot.rs",
        from: "fill(frames);\n        start_stream();",
        to: "start_stream();\n        fill(frames);",
    },
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace")
}

/// Writes a file unless it holds that already, so that nothing is built twice.
fn put(path: &Path, content: &[u8]) {
    if std::fs::read(path).is_ok_and(|old| old == content) {
        return;
    }
    std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    std::fs::write(path, content).expect("a writable folder");
}

/// Copies a folder, each file through `change`.
fn copy(from: &Path, to: &Path, change: &mut dyn FnMut(&Path, Vec<u8>) -> Vec<u8>) {
    for entry in std::fs::read_dir(from).unwrap_or_else(|e| panic!("{}: {e}", from.display())) {
        let (path, name) = entry.map(|e| (e.path(), e.file_name())).expect("a readable folder");
        if path.is_dir() {
            copy(&path, &to.join(name), change);
        } else {
            let content = change(&path, std::fs::read(&path).expect("a readable file"));
            put(&to.join(name), &content);
        }
    }
}

/// Replaces what must occur exactly once.
fn replace_once(text: &str, from: &str, to: &str, place: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "{place} has changed: `{from}` must occur once in it");
    text.replace(from, to)
}

/// The firmware under another name, with one line changed.
fn write_mutant(workspace: &Path, mutant: &Mutant) {
    let source = root().join("firmware");
    let mut applied = false;
    copy(&source, &workspace.join(mutant.name), &mut |path, content| {
        let inside = path.strip_prefix(&source).expect("inside");
        if inside == Path::new("Cargo.toml") {
            let text = String::from_utf8(content).expect("text");
            let bin = "[[bin]]\nname = \"mintime-firmware\"";
            let text =
                replace_once(&text, bin, &format!("[[bin]]\nname = \"{}\"", mutant.name), "Cargo.toml");
            let package = "[package]\nname = \"mintime-firmware\"";
            let renamed =
                format!("[lib]\nname = \"mintime_firmware\"\n\n[package]\nname = \"{}\"", mutant.name);
            return replace_once(&text, package, &renamed, "Cargo.toml").into_bytes();
        }
        if inside == Path::new(mutant.file) {
            applied = true;
            let text = String::from_utf8(content).expect("text");
            return replace_once(&text, mutant.from, mutant.to, mutant.file).into_bytes();
        }
        content
    });
    assert!(applied, "there is no {}", mutant.file);
}

/// Builds all mutants, once; answers the folder of their images.
fn mutants() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        // Its dependencies are theirs.
        image();
        let workspace = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutants");
        for file in ["Cargo.lock", "memory.x", "rust-toolchain.toml", ".cargo/config.toml"] {
            put(&workspace.join(file), &std::fs::read(root().join(file)).expect("a file of the workspace"));
        }
        copy(&root().join("shared"), &workspace.join("shared"), &mut |_, content| content);
        let manifest = std::fs::read_to_string(root().join("Cargo.toml")).expect("the workspace");
        let names: String = MUTANTS.iter().map(|m| format!(", \"{}\"", m.name)).collect();
        let lines = manifest.lines().map(|line| match line.split_once(" = ") {
            Some(("members", _)) => format!("members = [\"shared\"{names}]\n"),
            Some(("default-members", _)) => String::new(),
            _ => format!("{line}\n"),
        });
        let manifest: String = lines.collect();
        // Profiles of packages that are not here.
        let (before, release) = manifest.split_once("[profile.dev.").expect("profiles");
        let release = release.split_once("[profile.release]").expect("a release profile").1;
        put(&workspace.join("Cargo.toml"), format!("{before}[profile.release]{release}").as_bytes());
        for mutant in &MUTANTS {
            write_mutant(&workspace, mutant);
        }
        let target = root().join("target/firmware");
        let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .current_dir(&workspace)
            .args([
                "build",
                "--profile",
                "firmware",
                "--quiet",
                "--workspace",
                "--exclude",
                "mintime-shared",
                "--bins",
            ])
            .args(["--target", TARGET, "--target-dir"])
            .arg(&target)
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("CARGO_BUILD_TARGET")
            .output()
            .expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        target.join(TARGET).join("firmware")
    })
}

fn mutant(name: &str) -> Bench {
    let elf = std::fs::read(mutants().join(name)).expect("an image");
    Bench::new(&elf, 1)
}

/// What every mutant is held against: the same flight, by the same checks.
#[test]
fn the_real_image_passes_every_check() {
    let mut bench = Bench::real(1);
    bench.assert_flies();
    println!("{:?}", bench.vehicle.report());
    assert_eq!(bench.bugs(), [""; 0]);
    assert!(worst_latency_ns(&bench) < LATENCY_BUDGET_NS, "{} ns", worst_latency_ns(&bench));
}

fn worst_latency_ns(bench: &Bench) -> u32 {
    let (median, spread) = bench.vehicle.report().latency_ns.expect("it flew");
    median + spread
}

#[test]
fn a_register_read_without_its_dummy_byte_finds_no_gyro() {
    let mut bench = mutant("register-read-without-dummy");
    bench.assert_not_armed(ArmingBlock::NO_GYRO);
    let board = bench.status().board.expect("a board");
    assert_eq!(board.gyro_fault, Some(GyroFault::Identity(0)));
}

#[test]
fn a_burst_without_its_dummy_byte_is_not_armed() {
    let mut bench = mutant("burst-without-dummy");
    let block = bench.assert_not_armed(ArmingBlock::NOT_CALIBRATED);
    assert!(!block.contains(ArmingBlock::NO_GYRO), "{block}");
}

#[test]
fn a_bus_too_fast_for_the_gyro_is_a_bug() {
    let mut bench = mutant("spi-too-fast");
    bench.pass_ms(200);
    bench.assert_bug("SPI runs at 10500000 Hz, above its limit of 10 MHz");
}

#[test]
fn a_reload_value_off_by_one_is_a_wrong_rate() {
    let mut bench = mutant("reload-plus-one");
    bench.pass_ms(200);
    bench.assert_bug("DShot bits come at 595.7 kbit/s");
}

/// The stream that nobody asks raises an interrupt that nobody handles, as it is taken back.
#[test]
fn a_wrong_stream_moves_no_motor() {
    let mut bench = mutant("wrong-stream");
    bench.pass_ms(300);
    bench.assert_bug("no peripheral asks on DMA1 stream 4 channel 2");
    let log = bench.log();
    assert!(log.crashes().contains(&"UnexpectedInterrupt"), "{:?}", log.0);
    assert!(!bench.ever_turned());
}

#[test]
fn a_port_without_its_clock_is_a_bug() {
    let mut bench = mutant("unclocked-port");
    bench.pass_ms(50);
    bench.assert_bug("GPIOB is written while its clock is off");
}

/// Armed in good faith, and noticed before it flies far.
#[test]
fn swapped_motors_lose_the_flight_at_take_off() {
    let mut bench = mutant("swapped-motors").then(Phase::TakeOff, 0, |_| {});
    assert_runs_away(&mut bench);
}

#[test]
fn a_flipped_axis_loses_the_flight_at_take_off() {
    let mut bench = mutant("flipped-axis").then(Phase::TakeOff, 0, |_| {});
    assert_runs_away(&mut bench);
}

fn assert_runs_away(bench: &mut Bench) {
    let (state, reason) = bench.assert_lost();
    assert_eq!(state, FlightState::Terminated);
    assert!(matches!(reason, Some(AbortReason::Runaway | AbortReason::GyroSaturated)), "{reason:?}");
    println!("stopped after {} ms", bench.stopped_after_ms());
    assert!(bench.stopped_after_ms() < 1500.0, "{}", bench.stopped_after_ms());
    assert_eq!(bench.bugs(), [""; 0]);
}

/// The chip refuses its configuration, as the real one would.
#[test]
fn a_configuration_loaded_to_one_place_finds_no_gyro() {
    let mut bench = mutant("configuration-all-to-zero");
    bench.assert_not_armed(ArmingBlock::NO_GYRO);
    bench.assert_bug("BMI270: the configuration is not the maker's, or does not lie where it belongs");
    let board = bench.status().board.expect("a board");
    assert_eq!(board.gyro_fault, Some(GyroFault::Configuration(2)));
}

/// The stream reads its first word when it is switched on, not when it is asked for it.
#[test]
fn bits_written_behind_the_streams_back_break_a_frame() {
    let mut bench = mutant("buffer-after-enable");
    bench.pass_ms(200);
    bench.assert_bug("motor 1");
}

/// Everything works, only later than it should.
#[test]
fn caches_left_off_break_the_latency_budget() {
    let mut bench = mutant("caches-off");
    let result = bench.fly();
    assert!(result.is_ok() || matches!(result, Err(FlightError::Lost { .. })), "{result:?}");
    println!("{} ns", worst_latency_ns(&bench));
    assert!(worst_latency_ns(&bench) > LATENCY_BUDGET_NS, "{} ns", worst_latency_ns(&bench));
}

#[test]
fn an_access_too_early_for_the_gyro_is_a_bug() {
    let mut bench = mutant("early-gyro-access");
    bench.pass_ms(200);
    bench.assert_bug("BMI270: an access comes within 450 µs of leaving advanced power save");
}

/// Whoever erases must empty the data cache behind it, as the store does.
#[test]
fn a_stale_cache_after_an_erase_is_a_bug() {
    let old = 0x1234_5678_u32;
    for (flush, after) in [(true, u32::MAX), (false, old)] {
        let elf = flash_erase(flush);
        let mut machine = Machine::new(
            emulator::chip::Chip::new(emulator::chip::BareBoard::default()),
            Timing::Pessimistic,
            1,
        );
        machine.memory.place(0x0800_8000, &old.to_le_bytes()).expect("flash");
        machine.load_elf(&elf).expect("an image");
        // The erase takes 0.25 s; the clock is the internal one, 16 MHz.
        assert_eq!(machine.run_until(8_000_000), Stop::ReachedTime);
        let words: Vec<u32> = machine
            .memory
            .peek(0x2000_0000, 12)
            .expect("RAM")
            .as_chunks()
            .0
            .iter()
            .map(|word| u32::from_le_bytes(*word))
            .collect();
        assert_eq!(words, [old, after, 1], "flush: {flush}");
        let bugs: Vec<&str> = machine.memory.bugs.iter().map(|bug| bug.what.as_str()).collect();
        if flush {
            assert_eq!(bugs, [""; 0]);
        } else {
            assert!(bugs.iter().any(|b| b.contains("read of 0x08008000 from a stale line")), "{bugs:?}");
        }
    }
}

fn flash_erase(flush: bool) -> Vec<u8> {
    // Installs the target where it is missing.
    image();
    let programs = Path::new(env!("CARGO_MANIFEST_DIR")).join("programs");
    let elf = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("flash_erase_{flush}"));
    let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    command.current_dir(root());
    command.args(["--edition", "2024", "--target", TARGET, "-C", "opt-level=2", "-C", "panic=abort"]);
    command
        .args(["--check-cfg", "cfg(flush)"])
        .args(flush.then_some(["--cfg", "flush"]).into_iter().flatten());
    command.arg(format!("-Clink-arg=-T{}", programs.join("flash_erase.ld").display()));
    command.arg(programs.join("flash_erase.rs")).arg("-o").arg(&elf);
    let output = command.output().expect("rustc runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(elf).expect("an image")
}
