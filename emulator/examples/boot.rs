use emulator::Machine;
use emulator::boards::SpeedyBeeF405V3;
use emulator::chip::Chip;
use emulator::core::Timing;
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let seconds: f64 = std::env::args().nth(2).map_or(1.0, |s| s.parse().unwrap());
    let elf = std::fs::read(path).unwrap();
    let mut machine = Machine::new(Chip::new(SpeedyBeeF405V3::new()), Timing::Pessimistic, 1);
    machine.load_elf(&elf).unwrap();
    let start = std::time::Instant::now();
    let mut ns = 0u64;
    let mut last = 0;
    while (ns as f64) < seconds * 1e9 {
        ns += 1_250_000;
        let p = &mut machine.peripherals;
        p.imu_sample(&mut machine.memory, ns, [0.0; 3], [0.0, 0.0, 9.81]);
        loop {
            let now = machine.time();
            let limit = machine.peripherals.clock().cycle(ns);
            if limit <= now {
                break;
            }
            let stop = machine.run_until(limit);
            if stop != emulator::Stop::ReachedTime {
                println!("{ns} {stop}");
                return;
            }
        }
        let bugs = &machine.memory.bugs;
        for b in &bugs[last..] {
            println!("BUG at {} pc {:#x}: {}", b.at, b.pc, b.what);
        }
        last = bugs.len();
        for b in machine.peripherals.link_take() {
            if ns < 300_000_000 {
                print!("{:02x}", b.byte);
            }
        }
    }
    println!();
    println!("{:?} fault {:?}", machine.core.counters, machine.last_fault);
    println!("real time factor {}", ns as f64 * 1e-9 / start.elapsed().as_secs_f64());
    println!("{:?}", machine.peripherals.motors(ns));
    println!("{:?}", machine.peripherals.board().latency.summary());
}
