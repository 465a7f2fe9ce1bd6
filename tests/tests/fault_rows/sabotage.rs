//! How the virtual board is broken: registers, memory and lines, behind the firmware's back.

use emulator::chip::Pin;
use emulator::devices::Defect;

use super::rig::Rig;
use crate::bench::Board;

/// RAM that the firmware does not use.
const SPARE_RAM: u32 = 0x2001_F000;
/// Nothing lies there.
pub(super) const NOWHERE: u32 = 0x3000_0000;
/// The gyro's data-ready pin.
const DATA_READY: Pin = Pin::new('C', 4);
/// Where the firmware is made to panic.
const PANIC_LINE: u32 = 77;
/// A task begins with at most this many bytes of what the executor knows of it, where its code is among them.
const TASK_HEADER_BYTES: u32 = 64;

/// The gyro is broken so, or mended.
pub(super) fn break_gyro(rig: &mut Rig, defect: Option<Defect>) {
    rig.board().peripherals.board_mut().gyro.defect = defect;
}

/// Edges on the line without end, so long from one to the next.
pub(super) fn ring(rig: &mut Rig, period_ns: Option<u64>) {
    let now_ns = rig.vehicle.now_ns();
    let Board { peripherals, memory, .. } = rig.board();
    peripherals.ring_data_ready(memory, now_ns, period_ns);
}

/// Three pulses on the line between two samples.
pub(super) fn stray_edges(board: &mut Board) {
    for pulse in 0..6 {
        let level = pulse % 2 == 0;
        let Board { peripherals, memory, .. } = board;
        peripherals.with_board(memory, |_, effects| effects.levels.push((DATA_READY, Some(level))));
        let until = board.time() + board.peripherals.clock().cycles_for(20_000);
        board.run_until(until);
    }
}

/// One word of RAM lost: the control tick finds nothing to run.
pub(super) fn lose_tick(rig: &mut Rig) {
    let handle = rig.symbol(&["5board7control6HANDLE"]);
    // While a tick runs it is not there.
    while rig.board().core.exception_number() != 0 {
        let later = rig.vehicle.now_ns() + 500;
        rig.vehicle.advance_to(later).expect("time goes on");
    }
    rig.board().memory.place(handle, &[0; 4]).expect("RAM");
}

/// The handler at the end of the motors' stream does its work, but for telling that it was there.
pub(super) fn lose_frame_ends(rig: &mut Rig) {
    const MOTOR_TIMER_REQUESTS: u32 = 0x4000_080C;
    const STREAM_FLAGS: u32 = 0x4002_600C;
    const STREAM_6: u32 = 0x3D_0000;
    const STREAM_6_INTERRUPT: u32 = 17;
    // ldr r0, requests; movs r1, #0; str r1, [r0]; ldr r0, flags; ldr r1, stream; str r1, [r0]; bx lr
    let code: [u16; 8] = [0x4803, 0x2100, 0x6001, 0x4803, 0x4903, 0x6001, 0x4770, 0xBF00];
    let mut bytes: Vec<u8> = code.iter().flat_map(|half| half.to_le_bytes()).collect();
    bytes.extend([MOTOR_TIMER_REQUESTS, STREAM_FLAGS, STREAM_6].iter().flat_map(|word| word.to_le_bytes()));
    let vector = rig.symbol(&["__INTERRUPTS"]) + 4 * STREAM_6_INTERRUPT;
    let memory = &mut rig.board().memory;
    memory.place(SPARE_RAM, &bytes).expect("RAM");
    memory.place(vector, &(SPARE_RAM | 1).to_le_bytes()).expect("flash");
}

/// One word of RAM lost: a task's code is not found any more, and it never runs again.
pub(super) fn kill_task(rig: &mut Rig, name: &str) {
    let codes = rig.symbols_with(&["TaskStorage", "4poll"]);
    let task = rig.symbol(&[name, "4POOL"]);
    let board = rig.board();
    // bx lr
    board.memory.place(SPARE_RAM, &[0x70, 0x47]).expect("RAM");
    let words = board.memory.peek(task, TASK_HEADER_BYTES).expect("RAM").as_chunks().0.iter();
    let is_code = |word: &[u8; 4]| codes.contains(&(u32::from_le_bytes(*word) & !1));
    let places: Vec<u32> =
        (task..).step_by(4).zip(words).filter(|(_, w)| is_code(w)).map(|(at, _)| at).collect();
    let [at] = places[..] else { panic!("{name}: {places:x?}") };
    board.memory.place(at, &(SPARE_RAM | 1).to_le_bytes()).expect("RAM");
}

/// Makes thread mode go on with these instructions, registers set, interrupts on.
pub(super) fn run_instead(rig: &mut Rig, registers: &[u32], code: &[u16]) {
    // cpsie i
    let code = [0xB662].iter().chain(code);
    let bytes: Vec<u8> = code.flat_map(|half| half.to_le_bytes()).collect();
    rig.board().memory.place(SPARE_RAM, &bytes).expect("RAM");
    go_to(rig, SPARE_RAM, registers);
}

/// Makes thread mode go on there, as soon as it is awake.
pub(super) fn go_to(rig: &mut Rig, address: u32, registers: &[u32]) {
    for _ in 0..100_000 {
        let core = &mut rig.board().core;
        if !core.is_asleep() && core.exception_number() == 0 {
            for (number, value) in (0..).zip(registers) {
                core.set_register(number, *value);
            }
            core.set_register(15, address);
            return;
        }
        let later = rig.vehicle.now_ns() + 500;
        rig.vehicle.advance_to(later).expect("time goes on");
    }
    panic!("no thread mode");
}

/// Calls what a failed check of a bound calls: index, length, and where it stands in the source.
pub(super) fn panic_at(rig: &mut Rig) {
    let at = rig.symbol(&["panic_bounds_check"]) & !1;
    let (file, location) = (SPARE_RAM + 0x100, SPARE_RAM + 0x200);
    let words = [file, 8, PANIC_LINE, 1];
    let bytes: Vec<u8> = words.iter().flat_map(|word: &u32| word.to_le_bytes()).collect();
    let board = rig.board();
    board.memory.place(file, b"fault.rs").expect("RAM");
    board.memory.place(location, &bytes).expect("RAM");
    go_to(rig, at, &[3, 2, location]);
}
