//! Runs a bare-metal ELF, linked at 0 or at 0x0800_0000, and prints what it says.
//!
//! ```text
//! cargo run --release -p emulator --example run -- FILE.elf [--seconds N] [--pessimistic]
//! ```
//!
//! The chip is an STM32F405 on a board with an 8 MHz crystal and nothing else. Ends with the program's own exit code (semihosting), 0 when time is up, or 101 after a lock-up.
use std::{io::Write, process::ExitCode, time::Instant};

use emulator::chip::{BareBoard, Chip};
use emulator::{Machine, Stop, core::Timing, log::Log};

/// Output is shown this often in virtual time, ns.
const LOOK_NS: u64 = 10_000_000;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let (mut file, mut seconds, mut timing, mut verbose) = (None, 60.0, Timing::Optimistic, false);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--seconds" => seconds = arguments.next().ok_or("--seconds needs a number")?.parse()?,
            "--pessimistic" => timing = Timing::Pessimistic,
            "--statistics" => verbose = true,
            _ => file = Some(argument),
        }
    }
    let elf = std::fs::read(file.ok_or("which ELF?")?)?;
    let mut machine = Machine::new(Chip::new(BareBoard::default()), timing, 1);
    machine.load_elf(&elf)?;
    let mut log = Log::new(&elf);
    let begun = Instant::now();
    let end_ns = (seconds * 1e9) as u64;
    let mut now_ns = 0;
    let stop = loop {
        now_ns = end_ns.min(now_ns + LOOK_NS);
        // The firmware may change its clocks on the way.
        let limit = machine.peripherals.clock().cycle(now_ns);
        let stop = machine.run_until(limit);
        std::io::stdout().write_all(&std::mem::take(&mut machine.output))?;
        let logged = log.decode(&machine.read_rtt());
        std::io::stdout().write_all(logged.as_bytes())?;
        std::io::stdout().flush()?;
        if stop != Stop::ReachedTime || now_ns >= end_ns {
            break stop;
        }
    };
    for bug in &machine.memory.bugs {
        eprintln!("{:#010x} at cycle {}: {}", bug.pc, bug.at, bug.what);
    }
    if verbose {
        let (host, core) = (begun.elapsed().as_secs_f64(), &machine.core);
        let instructions = core.counters.instructions;
        eprintln!(
            "{instructions} instructions, {} cycles awake, {} asleep; {:.1} million instructions/s",
            core.clocked(),
            core.counters.asleep,
            instructions as f64 / host * 1e-6
        );
        eprintln!(
            "ended at {:#010x} in exception {}, last fault {:x?}",
            core.register(15),
            core.exception_number(),
            machine.last_fault
        );
    }
    Ok(match stop {
        Stop::Exit(code) => ExitCode::from(u8::try_from(code).unwrap_or(1)),
        Stop::ReachedTime => ExitCode::SUCCESS,
        other => {
            eprintln!("{other}; last fault: {:?}", machine.last_fault);
            ExitCode::from(101)
        }
    })
}
