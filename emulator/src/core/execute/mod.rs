//! The interpreter: one loop, one match. What is frequent stands here; the rest in the submodules.
mod fetch;
mod flags;
mod float;
mod logic;
mod multiple;
mod polling;
mod rare;

use crate::{
    bus::Peripherals,
    core::{
        Core, Fault, Sleep, access, alu,
        cost::{self, Timing},
        float::{Simple, compare_numbers, simple},
        op::{Float2, Op, Slot},
    },
    memory::{LINE, Memory},
};
use polling::{Poll, is_peripheral};

/// Why the inner loop ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Time is up, or something wants a look from outside.
    Deadline,
    /// The instruction at `pc` did not complete.
    Fault(Fault),
    /// SVC; `pc` is the next instruction.
    SupervisorCall,
    /// BKPT; `pc` is its own address.
    Breakpoint(u8),
    /// A branch to an EXC_RETURN value.
    ExceptionReturn(u32),
    /// An encoding this emulator does not have, at `pc`.
    Unimplemented,
}

/// Places for instructions in a line of flash.
const LINE_SLOTS: usize = LINE as usize / 2;
/// No line of flash.
const NO_LINE: [Slot; LINE_SLOTS] = [Slot::EMPTY; LINE_SLOTS];

impl Core {
    /// Executes until [`Exit`]; never beyond the deadline by more than one instruction.
    pub(crate) fn run<P: Peripherals>(&mut self, memory: &mut Memory, peripherals: &mut P) -> Exit {
        match self.timing {
            Timing::Optimistic => self.run_timed::<P, false>(memory, peripherals),
            Timing::Pessimistic => self.run_timed::<P, true>(memory, peripherals),
        }
    }

    fn run_timed<P: Peripherals, const PESSIMISTIC: bool>(
        &mut self,
        memory: &mut Memory,
        peripherals: &mut P,
    ) -> Exit {
        let refill = cost::refill(PESSIMISTIC);
        let contention = cost::contention(PESSIMISTIC);
        // Out of `self`, so that a slot can be looked at while the core changes; put back below.
        let mut slots = std::mem::take(&mut self.flash_slots);
        let mut pc = self.pc;
        // As well, so that it stays in a register of the host; what may look at it goes through `outside`. It wraps, for a
        // check at each step costs more than 2^64 cycles are worth: 3,500 years.
        let mut cycle = self.cycle;
        let mut executed = 0_u64;
        let mut scratch;
        let alias = self.flash_alias;
        // The line of flash that instructions come from, and its number.
        let (mut line, mut line_at) = (&NO_LINE, u32::MAX);

        macro_rules! r {
            ($n:expr) => {
                self.r[($n & 15) as usize]
            };
        }
        macro_rules! s {
            ($n:expr) => {
                self.s[($n & 31) as usize]
            };
        }
        macro_rules! outside {
            ($call:expr) => {{
                self.cycle = cycle;
                let result = $call;
                cycle = self.cycle;
                result
            }};
        }
        macro_rules! check {
            ($result:expr) => {
                match $result {
                    Ok(value) => value,
                    Err(fault) => break Exit::Fault(fault),
                }
            };
        }
        macro_rules! nz {
            ($value:expr) => {{
                let value: u32 = $value;
                self.n = (value as i32) < 0;
                self.z = value == 0;
                value
            }};
        }
        macro_rules! jump {
            ($target:expr) => {{
                pc = $target;
                cycle = cycle.wrapping_add(refill);
                continue;
            }};
        }
        // Branch and exchange: EXC_RETURN values in handler mode, bit 0 to EPSR.T.
        macro_rules! exchange {
            ($target:expr) => {{
                let target: u32 = $target;
                cycle = cycle.wrapping_add(refill);
                if target >> 28 == 15 && self.ipsr != 0 {
                    break Exit::ExceptionReturn(target);
                }
                pc = target & !1;
                if target & 1 == 0 {
                    self.thumb = false;
                    break Exit::Deadline;
                }
                continue;
            }};
        }
        // ExecuteFPCheck (B1.5.7), where it could do something.
        macro_rules! ready_float {
            () => {
                if !self.fp_ready {
                    check!(outside!(self.prepare_float(memory, peripherals)));
                }
            };
        }
        // Most arithmetic of single precision; the rest outside.
        macro_rules! simple_float {
            ($op:expr, $operation:expr, $d:expr, $n:expr, $m:expr) => {{
                ready_float!();
                if let Some(bits) = simple(self.fpscr, $operation, s!($n), s!($m)) {
                    s!($d) = bits;
                } else {
                    self.execute_float($op);
                }
            }};
        }
        macro_rules! branch_if {
            ($condition:expr, $target:expr) => {
                if $condition {
                    jump!($target);
                }
            };
        }
        // SRAM at once, everything else outside.
        macro_rules! load {
            ($bytes:literal, $address:expr) => {{
                let address: u32 = $address;
                if let Some(value) = access::load_sram::<$bytes>(memory, address) {
                    cycle = cycle.wrapping_add(contention);
                    value
                } else {
                    check!(outside!(self.read::<$bytes, P>(memory, peripherals, address)))
                }
            }};
        }
        macro_rules! store {
            ($bytes:literal, $address:expr, $value:expr) => {{
                let (address, value): (u32, u32) = ($address, $value);
                if access::store_sram::<$bytes>(memory, address, value) {
                    cycle = cycle.wrapping_add(contention);
                } else {
                    check!(outside!(self.write::<$bytes, P>(memory, peripherals, address, value)));
                }
            }};
        }
        // A load takes a second cycle unless it follows another at once.
        macro_rules! read {
            ($bytes:literal, $address:expr) => {{
                if self.pipelined.wrapping_add(1) != cycle {
                    cycle = cycle.wrapping_add(1);
                }
                let value = load!($bytes, $address);
                self.pipelined = cycle;
                value
            }};
        }
        macro_rules! write {
            ($bytes:literal, $address:expr, $value:expr) => {{
                store!($bytes, $address, $value);
                self.pipelined = cycle;
            }};
        }

        let exit = loop {
            if cycle >= self.deadline {
                break Exit::Deadline;
            }
            let offset = pc ^ alias;
            let mut slot: &Slot = if offset / LINE == line_at {
                &line[(offset / 2) as usize % LINE_SLOTS]
            } else if let Some(next) = slots.as_chunks().0.get((offset / LINE) as usize) {
                (line, line_at) = (next, offset / LINE);
                if PESSIMISTIC && line_at != self.fetch_line {
                    self.fetch_line = line_at;
                    cycle = cycle.wrapping_add(memory.flash_interface.fetch(line_at, cycle));
                }
                &line[(offset / 2) as usize % LINE_SLOTS]
            } else {
                std::hint::cold_path();
                match outside!(self.fetch_from_ram(memory, pc)) {
                    Ok(slot) => {
                        scratch = slot;
                        &scratch
                    }
                    Err(exit) => break exit,
                }
            };
            self.r[15] = pc.wrapping_add(4);
            if self.it != 0 {
                std::hint::cold_path();
                if slot.op == Op::Undecoded {
                    let decoded = outside!(self.decode_from_flash(memory, pc, offset));
                    (line, line_at) = (&NO_LINE, u32::MAX);
                    if let Some(slot) = slots.get_mut((offset / 2) as usize) {
                        *slot = decoded;
                    }
                    continue;
                }
                self.it_before = self.it;
                self.it_pc = pc;
                let condition = self.it >> 4;
                self.it = if self.it & 7 == 0 { 0 } else { self.it & 0xE0 | self.it << 1 & 0x1F };
                if !self.passes(condition) {
                    executed = executed.wrapping_add(1);
                    cycle = cycle.wrapping_add(1);
                    pc = pc.wrapping_add(u32::from(slot.len));
                    continue;
                }
                if slot.narrow_flags {
                    scratch = Slot { op: slot.op.without_flags(), ..*slot };
                    slot = &scratch;
                }
            }
            executed = executed.wrapping_add(1);
            cycle = cycle.wrapping_add(u64::from(slot.cost));
            match slot.op {
                Op::Undecoded => {
                    executed = executed.wrapping_sub(1);
                    let decoded = outside!(self.decode_from_flash(memory, pc, offset));
                    (line, line_at) = (&NO_LINE, u32::MAX);
                    if let Some(slot) = slots.get_mut((offset / 2) as usize) {
                        *slot = decoded;
                    }
                    continue;
                }
                Op::Undefined => break Exit::Fault(Fault::Undefined),
                Op::NoCoprocessor => break Exit::Fault(Fault::NoCoprocessor),
                Op::Nop => {}
                Op::It { state } => {
                    // A single instruction that is not to run: past it at once.
                    let next = offset.wrapping_add(2);
                    let skipped = &line[(next / 2) as usize % LINE_SLOTS];
                    if state & 7 == 0
                        && !self.passes(state >> 4)
                        && cycle < self.deadline
                        && next / LINE == line_at
                        && skipped.op != Op::Undecoded
                    {
                        executed = executed.wrapping_add(1);
                        cycle = cycle.wrapping_add(1);
                        pc = pc.wrapping_add(2 + u32::from(skipped.len));
                        continue;
                    }
                    self.it = state;
                }

                Op::MovImm { rd, imm } => r!(rd) = imm,
                Op::MovsImm { rd, imm } => r!(rd) = nz!(imm),
                Op::MovReg { rd, rm } => {
                    let value = r!(rm);
                    r!(rd) = if rd == 13 { value & !3 } else { value };
                }
                Op::MovPc { rm } => jump!(r!(rm) & !1),
                Op::AddPc { rm } => jump!(self.r[15].wrapping_add(r!(rm)) & !1),
                Op::MovTop { rd, imm } => r!(rd) = r!(rd) & 0xFFFF | imm,
                Op::AddImm { rd, rn, imm } => {
                    let value = r!(rn).wrapping_add(imm);
                    r!(rd) = if rd == 13 { value & !3 } else { value };
                }
                Op::AddsImm { rd, rn, imm } => {
                    let (value, c, v) = alu::add_with_carry(r!(rn), imm, false);
                    (self.c, self.v) = (c, v);
                    r!(rd) = nz!(value);
                }
                Op::SubsImm { rd, rn, imm } => r!(rd) = self.subtract(r!(rn), imm),
                Op::CmpImm { rn, imm } => {
                    self.subtract(r!(rn), imm);
                }
                Op::CmpReg { rn, rm } => {
                    self.subtract(r!(rn), r!(rm));
                }
                Op::AddReg { rd, rn, rm } => {
                    let value = r!(rn).wrapping_add(r!(rm));
                    r!(rd) = if rd == 13 { value & !3 } else { value };
                }
                Op::AddsReg { rd, rn, rm } => {
                    let (value, c, v) = alu::add_with_carry(r!(rn), r!(rm), false);
                    (self.c, self.v) = (c, v);
                    r!(rd) = nz!(value);
                }
                Op::SubReg { rd, rn, rm } => {
                    let value = r!(rn).wrapping_sub(r!(rm));
                    r!(rd) = if rd == 13 { value & !3 } else { value };
                }
                Op::SubsReg { rd, rn, rm } => r!(rd) = self.subtract(r!(rn), r!(rm)),
                Op::AddLsl { rd, rn, rm, n } => r!(rd) = r!(rn).wrapping_add(r!(rm) << (n & 31)),
                Op::AndImm { rd, rn, imm } => r!(rd) = r!(rn) & imm,
                Op::OrrImm { rd, rn, imm } => r!(rd) = r!(rn) | imm,
                Op::BicImm { rd, rn, imm } => r!(rd) = r!(rn) & !imm,
                Op::AndReg { rd, rn, rm } => r!(rd) = r!(rn) & r!(rm),
                Op::OrrReg { rd, rn, rm } => r!(rd) = r!(rn) | r!(rm),
                Op::EorReg { rd, rn, rm } => r!(rd) = r!(rn) ^ r!(rm),
                Op::BicReg { rd, rn, rm } => r!(rd) = r!(rn) & !r!(rm),
                Op::OrrLsl { rd, rn, rm, n } => r!(rd) = r!(rn) | r!(rm) << (n & 31),
                Op::LslImm { rd, rm, n } => r!(rd) = r!(rm) << (n & 31),
                Op::LsrImm { rd, rm, n } => r!(rd) = r!(rm) >> (n & 31),
                Op::AsrImm { rd, rm, n } => r!(rd) = ((r!(rm) as i32) >> (n & 31)) as u32,
                Op::LslsImm { rd, rm, n } => r!(rd) = self.shift_left(r!(rm), n),
                Op::LsrsImm { rd, rm, n } => r!(rd) = self.shift_right(r!(rm), n),
                Op::AluImm { op, s, carry, rd, rn, imm } => {
                    let carry = if carry == 2 { self.c } else { carry != 0 };
                    self.data_operation(op, s, rd, r!(rn), imm, carry);
                }
                Op::AluReg { op, s, rd, rn, rm, shift, n } => {
                    let (value, carry) = alu::shift(r!(rm), shift, n, self.c);
                    self.data_operation(op, s, rd, r!(rn), value, carry);
                }
                Op::ShiftReg { shift, s, rd, rn, rm } => {
                    let (value, carry) = alu::shift(r!(rn), shift, r!(rm) as u8, self.c);
                    r!(rd) = value;
                    if s {
                        self.c = carry;
                        nz!(value);
                    }
                }
                Op::Uxtb { rd, rm } => r!(rd) = r!(rm) & 0xFF,
                Op::Uxth { rd, rm } => r!(rd) = r!(rm) & 0xFFFF,
                Op::Sxtb { rd, rm } => r!(rd) = r!(rm) as i8 as u32,
                Op::Sxth { rd, rm } => r!(rd) = r!(rm) as i16 as u32,
                Op::Ubfx { rd, rn, lsb, width } => {
                    r!(rd) = r!(rn) >> (lsb & 31) & (u32::MAX >> ((32 - width) & 31));
                }
                Op::Bfi { rd, rn, lsb, width } => {
                    let mask = ((1_u64 << (width & 63)) - 1) as u32;
                    let value = if rn == 15 { 0 } else { r!(rn) & mask };
                    r!(rd) = r!(rd) & !(mask << (lsb & 31)) | value << (lsb & 31);
                }
                Op::Mul { rd, rn, rm } => r!(rd) = r!(rn).wrapping_mul(r!(rm)),
                Op::Muls { rd, rn, rm } => r!(rd) = nz!(r!(rn).wrapping_mul(r!(rm))),
                Op::Mla { rd, rn, rm, ra } => {
                    r!(rd) = r!(rn).wrapping_mul(r!(rm)).wrapping_add(r!(ra));
                }
                Op::Mls { rd, rn, rm, ra } => {
                    r!(rd) = r!(ra).wrapping_sub(r!(rn).wrapping_mul(r!(rm)));
                }
                Op::Umull { lo, hi, rn, rm } => {
                    let product = u64::from(r!(rn)) * u64::from(r!(rm));
                    r!(lo) = product as u32;
                    r!(hi) = (product >> 32) as u32;
                }
                Op::Smull { lo, hi, rn, rm } => {
                    let product = i64::from(r!(rn) as i32) * i64::from(r!(rm) as i32);
                    r!(lo) = product as u32;
                    r!(hi) = (product >> 32) as u32;
                }
                Op::Umlal { lo, hi, rn, rm } => {
                    let sum = u64::from(r!(hi)) << 32 | u64::from(r!(lo));
                    let sum = sum.wrapping_add(u64::from(r!(rn)) * u64::from(r!(rm)));
                    r!(lo) = sum as u32;
                    r!(hi) = (sum >> 32) as u32;
                }

                Op::B { target } => jump!(target),
                Op::Beq { target } => branch_if!(self.z, target),
                Op::Bne { target } => branch_if!(!self.z, target),
                Op::Bcs { target } => branch_if!(self.c, target),
                Op::Bcc { target } => branch_if!(!self.c, target),
                Op::Bmi { target } => branch_if!(self.n, target),
                Op::Bpl { target } => branch_if!(!self.n, target),
                Op::Bvs { target } => branch_if!(self.v, target),
                Op::Bvc { target } => branch_if!(!self.v, target),
                Op::Bhi { target } => branch_if!(self.c & !self.z, target),
                Op::Bls { target } => branch_if!(!self.c | self.z, target),
                Op::Bge { target } => branch_if!(self.n == self.v, target),
                Op::Blt { target } => branch_if!(self.n != self.v, target),
                Op::Bgt { target } => branch_if!(!self.z & (self.n == self.v), target),
                Op::Ble { target } => branch_if!(self.z | (self.n != self.v), target),
                Op::Bl { target } => {
                    r!(14) = pc.wrapping_add(4) | 1;
                    jump!(target);
                }
                Op::Bx { rm } => exchange!(r!(rm)),
                Op::Blx { rm } => {
                    let target = r!(rm);
                    r!(14) = pc.wrapping_add(2) | 1;
                    cycle = cycle.wrapping_add(refill);
                    pc = target & !1;
                    if target & 1 == 0 {
                        self.thumb = false;
                        break Exit::Deadline;
                    }
                    continue;
                }
                Op::Cbz { rn, target } => branch_if!(r!(rn) == 0, target),
                Op::Cbnz { rn, target } => branch_if!(r!(rn) != 0, target),
                Op::TableBranch { rn, rm, half } => {
                    let entries = if half {
                        read!(2, r!(rn).wrapping_add(r!(rm) << 1))
                    } else {
                        read!(1, r!(rn).wrapping_add(r!(rm)))
                    };
                    jump!(self.r[15].wrapping_add(2 * entries));
                }

                Op::LdrImm { rt, rn, imm } => {
                    let address = r!(rn).wrapping_add(imm);
                    let value = read!(4, address);
                    if is_peripheral(address) {
                        std::hint::cold_path();
                        outside!(self.pass_over_polls(
                            memory,
                            peripherals,
                            &slots,
                            Poll { pc, address, value }
                        ));
                        self.pipelined = cycle;
                    }
                    r!(rt) = value;
                }
                Op::LdrbImm { rt, rn, imm } => r!(rt) = read!(1, r!(rn).wrapping_add(imm)),
                Op::LdrhImm { rt, rn, imm } => r!(rt) = read!(2, r!(rn).wrapping_add(imm)),
                Op::LdrLit { rt, address } => r!(rt) = read!(4, address),
                Op::LdrReg { rt, rn, rm, n } => {
                    r!(rt) = read!(4, r!(rn).wrapping_add(r!(rm) << (n & 3)));
                }
                Op::LdrbReg { rt, rn, rm, n } => {
                    r!(rt) = read!(1, r!(rn).wrapping_add(r!(rm) << (n & 3)));
                }
                Op::StrImm { rt, rn, imm } => write!(4, r!(rn).wrapping_add(imm), r!(rt)),
                Op::StrbImm { rt, rn, imm } => write!(1, r!(rn).wrapping_add(imm), r!(rt)),
                Op::StrhImm { rt, rn, imm } => write!(2, r!(rn).wrapping_add(imm), r!(rt)),
                Op::StrReg { rt, rn, rm, n } => {
                    write!(4, r!(rn).wrapping_add(r!(rm) << (n & 3)), r!(rt));
                }
                Op::Load { .. } | Op::LoadReg { .. } | Op::LoadLit { .. } => {
                    if self.pipelined.wrapping_add(1) != cycle {
                        cycle = cycle.wrapping_add(1);
                    }
                    let loaded = check!(outside!(self.load(memory, peripherals, slot.op)));
                    self.pipelined = cycle;
                    if let Some(target) = loaded {
                        exchange!(target);
                    }
                }
                Op::Store { size, rt, rn, imm, index } => {
                    let (address, base) = self.index(rn, imm, index);
                    check!(outside!(self.store(memory, peripherals, size, address, r!(rt))));
                    r!(rn) = base;
                }
                Op::StoreReg { size, rt, rn, rm, n } => {
                    let address = r!(rn).wrapping_add(r!(rm) << (n & 3));
                    check!(outside!(self.store(memory, peripherals, size, address, r!(rt))));
                    self.pipelined = cycle;
                }
                Op::Push { list } => check!(outside!(self.push(memory, peripherals, list))),
                Op::Pop { list } => {
                    if let Some(target) = check!(outside!(self.pop(memory, peripherals, list))) {
                        exchange!(target);
                    }
                }
                Op::Ldm { rn, list, before, writeback } => {
                    let loaded = check!(outside!(self.load_multiple(
                        memory,
                        peripherals,
                        rn,
                        list,
                        before,
                        writeback
                    )));
                    if let Some(target) = loaded {
                        exchange!(target);
                    }
                }
                Op::Stm { rn, list, before, writeback } => {
                    check!(outside!(self.store_multiple(memory, peripherals, rn, list, before, writeback)));
                }
                Op::Ldrd { rt, rt2, rn, imm, index } => {
                    let (address, base) = self.index(rn, imm, index);
                    if address & 3 != 0 {
                        break Exit::Fault(Fault::Unaligned);
                    }
                    let low = load!(4, address);
                    let high = load!(4, address.wrapping_add(4));
                    if rn != 15 {
                        r!(rn) = base;
                    }
                    (r!(rt), r!(rt2)) = (low, high);
                }
                Op::Strd { rt, rt2, rn, imm, index } => {
                    let (address, base) = self.index(rn, imm, index);
                    if address & 3 != 0 {
                        break Exit::Fault(Fault::Unaligned);
                    }
                    store!(4, address, r!(rt));
                    store!(4, address.wrapping_add(4), r!(rt2));
                    r!(rn) = base;
                }

                Op::Svc => {
                    pc = pc.wrapping_add(2);
                    break Exit::SupervisorCall;
                }
                Op::Bkpt { imm } => break Exit::Breakpoint(imm),
                Op::Wfi => {
                    self.sleep = Sleep::Interrupt;
                    pc = pc.wrapping_add(u32::from(slot.len));
                    break Exit::Deadline;
                }
                Op::Wfe => {
                    pc = pc.wrapping_add(u32::from(slot.len));
                    if !std::mem::take(&mut self.event) {
                        self.sleep = Sleep::Event;
                        break Exit::Deadline;
                    }
                    continue;
                }

                Op::Vldr { d, double, rn, imm } => {
                    ready_float!();
                    let address = r!(rn).wrapping_add(i32::from(imm) as u32);
                    if address & 3 != 0 {
                        break Exit::Fault(Fault::Unaligned);
                    }
                    let first = load!(4, address);
                    if double {
                        s!(d + 1) = load!(4, address.wrapping_add(4));
                    }
                    s!(d) = first;
                }
                Op::Vstr { d, double, rn, imm } => {
                    ready_float!();
                    let address = r!(rn).wrapping_add(i32::from(imm) as u32);
                    if address & 3 != 0 {
                        break Exit::Fault(Fault::Unaligned);
                    }
                    store!(4, address, s!(d));
                    if double {
                        store!(4, address.wrapping_add(4), s!(d + 1));
                    }
                }
                Op::Vldm { rn, d, count, before, writeback } => {
                    ready_float!();
                    check!(outside!(self.load_floats(memory, peripherals, rn, d, count, before, writeback)));
                }
                Op::Vstm { rn, d, count, before, writeback } => {
                    ready_float!();
                    check!(outside!(self.store_floats(memory, peripherals, rn, d, count, before, writeback)));
                }
                Op::Vadd { d, n, m } => simple_float!(slot.op, Simple::Add, d, n, m),
                Op::Vsub { d, n, m } => simple_float!(slot.op, Simple::Subtract, d, n, m),
                Op::Vmul { d, n, m } => simple_float!(slot.op, Simple::Multiply, d, n, m),
                Op::Vcmp { d, m, zero, .. } => {
                    ready_float!();
                    let other = if zero { 0 } else { s!(m) };
                    if let Some(nzcv) = compare_numbers(self.fpscr, s!(d), other) {
                        self.fpscr = self.fpscr & 0x0FFF_FFFF | nzcv << 28;
                    } else {
                        self.execute_float(slot.op);
                    }
                }
                Op::VmovFromCore { n, rt } => {
                    ready_float!();
                    s!(n) = r!(rt);
                }
                Op::VmovToCore { n, rt } => {
                    ready_float!();
                    r!(rt) = s!(n);
                }
                Op::Vmrs { rt: 15 } => {
                    ready_float!();
                    self.set_nzcvq(self.fpscr & 0xF000_0000 | u32::from(self.q) << 27);
                }
                Op::Float2 { op: Float2::Mov, d, m } => {
                    ready_float!();
                    s!(d) = s!(m);
                }
                Op::Float3 { .. }
                | Op::Float2 { .. }
                | Op::VmovImm { .. }
                | Op::VcvtFixed { .. }
                | Op::VmovPair { .. }
                | Op::Vmrs { .. }
                | Op::Vmsr { .. } => {
                    ready_float!();
                    self.execute_float(slot.op);
                }
                op => match outside!(self.execute_rare::<P, PESSIMISTIC>(memory, peripherals, op)) {
                    Ok(true) => {}
                    Ok(false) => break Exit::Unimplemented,
                    Err(fault) => break Exit::Fault(fault),
                },
            }
            // A branch, which the host predicts, and no sum, for which the next instruction would wait.
            pc = if slot.len == 2 {
                pc.wrapping_add(2)
            } else {
                std::hint::cold_path();
                pc.wrapping_add(4)
            };
        };
        (self.pc, self.cycle) = (pc, cycle);
        self.counters.instructions += executed;
        if std::mem::take(&mut self.alias_changed) {
            std::mem::swap(&mut slots, &mut self.other_slots);
            if slots.is_empty() {
                slots = vec![Slot::EMPTY; self.other_slots.len()].into();
            }
        }
        self.flash_slots = slots;
        exit
    }
}
