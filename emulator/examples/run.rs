//! Runs a bare-metal ELF, linked at 0 or at 0x0800_0000, and prints what it says. `--help` tells how.
use std::{fmt, io::Write, process::ExitCode, time::Instant};

use emulator::chip::{BareBoard, Chip};
use emulator::{Machine, Stop, core::Timing, log::Log};

const USAGE: &str = "\
Runs a bare-metal ELF on a virtual STM32F405 with an 8 MHz crystal and nothing else around it.

Usage: run [OPTIONS] FILE.elf

  --seconds N     stop after N seconds of virtual time [default: 60]
  --pessimistic   wait states and slow buses instead of the best case
  --statistics    say at the end how much was executed
  --help          this text

What the program writes through semihosting or SEGGER RTT (defmt included) goes to standard output, mistakes that
the emulator saw to standard error.

Exit codes: the program's own where it ends by semihosting; 2 for wrong arguments or a file that cannot be run; 101 where it
ended in a fault or in something that is not emulated; 124 where time was up.";

/// Output is shown this often in virtual time, ns.
const LOOK_NS: u64 = 10_000_000;
/// Virtual time ends somewhere, s.
const MOST_SECONDS: f64 = 1e8;
const REFUSED: u8 = 2;
const FAULTED: u8 = 101;
const TIME_UP: u8 = 124;

struct Arguments {
    file: String,
    seconds: f64,
    timing: Timing,
    statistics: bool,
}

/// What the user is to do about it.
struct Refusal(String);

impl fmt::Debug for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl<T: fmt::Display> From<T> for Refusal {
    fn from(error: T) -> Self {
        Self(error.to_string())
    }
}

/// `None` asks for help.
fn arguments(mut given: impl Iterator<Item = String>) -> Result<Option<Arguments>, Refusal> {
    let (mut file, mut seconds, mut timing, mut statistics) = (None, 60.0, Timing::Optimistic, false);
    while let Some(argument) = given.next() {
        match argument.as_str() {
            "--help" | "-h" => return Ok(None),
            "--seconds" => {
                let text = given.next().ok_or("--seconds needs a number")?;
                let number = text.parse().ok().filter(|n| *n > 0.0 && *n <= MOST_SECONDS);
                seconds = number.ok_or(format!(
                    "--seconds takes a number above 0 and up to {MOST_SECONDS}, not `{text}`"
                ))?;
            }
            "--pessimistic" => timing = Timing::Pessimistic,
            "--statistics" => statistics = true,
            option if option.starts_with('-') => Err(format!("there is no option `{option}`"))?,
            _ if file.is_some() => Err(format!("one ELF at a time; what is `{argument}`?"))?,
            _ => file = Some(argument),
        }
    }
    let file = file.ok_or("which ELF?")?;
    Ok(Some(Arguments { file, seconds, timing, statistics }))
}

fn main() -> ExitCode {
    let done = match arguments(std::env::args().skip(1)) {
        Ok(Some(arguments)) => run(&arguments),
        Ok(None) => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Err(Refusal(why)) => Err(Refusal(format!("{why}\n\n{USAGE}"))),
    };
    done.map_or_else(
        |Refusal(why)| {
            eprintln!("error: {why}");
            ExitCode::from(REFUSED)
        },
        ExitCode::from,
    )
}

fn run(arguments: &Arguments) -> Result<u8, Refusal> {
    let file = &arguments.file;
    let elf = std::fs::read(file).map_err(|error| format!("{file}: {error}"))?;
    let mut machine = Machine::new(Chip::new(BareBoard::default()), arguments.timing, 1);
    machine.stop_at_lockups = true;
    machine.load_elf(&elf).map_err(|error| format!("{file}: {error}"))?;
    if !machine.has_rtt() {
        eprintln!("note: {file} has no symbol _SEGGER_RTT; only what it writes through semihosting is shown");
    }
    let mut log = Log::new(&elf);
    let begun = Instant::now();
    let end_ns = (arguments.seconds * 1e9) as u64;
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
    if arguments.statistics {
        let (host, core) = (begun.elapsed().as_secs_f64(), &machine.core);
        let instructions = core.counters.instructions;
        eprintln!(
            "{instructions} instructions, {} cycles awake, {} asleep; {:.1} million instructions/s",
            core.clocked(),
            core.counters.asleep,
            instructions as f64 / host * 1e-6
        );
        eprintln!("ended at {:#010x} in exception {}", core.register(15), core.exception_number());
    }
    Ok(match (stop, machine.standing_fault()) {
        (Stop::Exit(code), _) => u8::try_from(code).unwrap_or(1),
        (Stop::ReachedTime, Some(fault)) => {
            eprintln!("the program stands in the handler of a fault: {fault}");
            FAULTED
        }
        (Stop::ReachedTime, None) => {
            eprintln!("time is up: the program still ran after {} s of virtual time", arguments.seconds);
            TIME_UP
        }
        (other, _) => {
            eprintln!("{other}");
            FAULTED
        }
    })
}
