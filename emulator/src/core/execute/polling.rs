//! Loops that ask a register of a peripheral again and again: what cannot see anything new is passed over.
//!
//! Nothing is guessed. A turn of the loop is tried, twice, with the value that has just been read; only where it comes back
//! to the load with everything as it was, but for a count that goes down, do turns follow one another until something
//! happens outside. Time, instructions and the count then move on by whole turns, and the last turns before the event run
//! as ever, so that the caches too stand as they would.
use crate::{
    bus::{Cycle, Peripherals},
    core::{
        Core, Timing, cost,
        op::{Op, Slot},
    },
    memory::Memory,
};

/// Instructions of a loop at most.
const LONGEST: u64 = 12;
/// Cycles until the next event that are worth a look at least.
const WORTHWHILE: Cycle = 40;

/// A load that may be part of such a loop.
#[derive(Clone, Copy)]
pub(super) struct Poll {
    /// The load.
    pub(super) pc: u32,
    /// What it read.
    pub(super) address: u32,
    /// What it got.
    pub(super) value: u32,
}

/// One turn, from load to load.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Turn {
    cycles: Cycle,
    instructions: u64,
    /// The register that counts down by one.
    counter: Option<u8>,
}

/// What a turn changes of the core.
#[derive(Clone, Copy, PartialEq, Eq)]
struct State {
    r: [u32; 16],
    flags: [bool; 4],
}

/// Whether an address is one of a peripheral (B3.1, table B3-1).
#[inline(always)]
pub(super) fn is_peripheral(address: u32) -> bool {
    address >> 29 == 2
}

impl Core {
    /// A load has read a register of a peripheral and not yet changed its target: moves on by as many turns of the loop
    /// around it as end before anything happens, if it is such a loop.
    #[inline(never)]
    pub(super) fn pass_over_polls<P: Peripherals>(
        &mut self,
        memory: &Memory,
        peripherals: &P,
        slots: &[Slot],
        poll: Poll,
    ) {
        let left = self.deadline.saturating_sub(self.cycle);
        if left < WORTHWHILE || self.it != 0 || !peripherals.rests(poll.address, self.cycle) {
            return;
        }
        let wait = if self.timing == Timing::Pessimistic { peripherals.wait_states(poll.address) } else { 0 };
        let before = self.state();
        let first = self.try_turn(memory, slots, poll, wait).map(|turn| (turn, self.state()));
        let second =
            first.and_then(|_| self.try_turn(memory, slots, poll, wait)).map(|turn| (turn, self.state()));
        self.restore(&before);
        let (Some((turn, mut after)), Some((again, mut next))) = (first, second) else { return };
        if turn != again {
            return;
        }
        // The last turn before anything happens runs as ever.
        let mut turns = (left / turn.cycles).saturating_sub(1);
        if let Some(counter) = turn.counter {
            let counter = usize::from(counter & 15);
            let count = before.r[counter];
            // Counting down to one, from what is not negative, gives the same flags each time.
            if count > i32::MAX as u32 {
                return;
            }
            turns = turns.min(u64::from(count.saturating_sub(1)));
            (after.r[counter], next.r[counter]) = (count - turns as u32, count - turns as u32);
        }
        if after != next || turns == 0 {
            return;
        }
        self.restore(&after);
        self.cycle += turns * turn.cycles;
        self.counters.instructions += turns * turn.instructions;
    }

    /// One turn from behind the load until it has loaded the same again; none if there is anything in it but tests of
    /// what was read, branches, and one count.
    fn try_turn(&mut self, memory: &Memory, slots: &[Slot], poll: Poll, wait: Cycle) -> Option<Turn> {
        let pessimistic = self.timing == Timing::Pessimistic;
        let alias = self.flash_alias;
        let slot_at = |pc: u32| slots.get(((pc ^ alias) >> 1) as usize).copied();
        let mut slot = slot_at(poll.pc)?;
        let Op::LdrImm { rt, rn: base, .. } = slot.op else { return None };
        if rt == base {
            return None;
        }
        // The load takes a second cycle: a branch stands between it and the one before.
        let mut turn = Turn { cycles: 1 + wait, instructions: 0, counter: None };
        let mut shifted = 0_u16;
        let mut pc = poll.pc;
        loop {
            if pessimistic && !memory.flash_interface.holds_instructions(pc ^ alias) {
                return None;
            }
            turn.cycles += Cycle::from(slot.cost);
            turn.instructions += 1;
            if turn.instructions > LONGEST {
                return None;
            }
            let mut branch = None;
            match slot.op {
                Op::LdrImm { .. } if pc == poll.pc => self.r[usize::from(rt & 15)] = poll.value,
                Op::SubsImm { rd, rn, imm: 1 }
                    if rd == rn && rd != rt && rd != base && turn.counter.is_none() =>
                {
                    self.r[usize::from(rd & 15)] = self.subtract(self.r[usize::from(rn & 15)], 1);
                    turn.counter = Some(rd & 15);
                }
                Op::LslsImm { rd, rm, n } if rm == rt && rd != base => {
                    self.r[usize::from(rd & 15)] = self.shift_left(self.r[usize::from(rm & 15)], n);
                    shifted |= 1 << (rd & 15);
                }
                Op::LsrsImm { rd, rm, n } if rm == rt && rd != base => {
                    self.r[usize::from(rd & 15)] = self.shift_right(self.r[usize::from(rm & 15)], n);
                    shifted |= 1 << (rd & 15);
                }
                Op::CmpImm { rn, imm } if rn == rt => {
                    self.subtract(self.r[usize::from(rn & 15)], imm);
                }
                Op::B { target } => branch = Some(target),
                Op::Beq { target } => branch = self.z.then_some(target),
                Op::Bne { target } => branch = (!self.z).then_some(target),
                Op::Bcs { target } => branch = self.c.then_some(target),
                Op::Bcc { target } => branch = (!self.c).then_some(target),
                Op::Bmi { target } => branch = self.n.then_some(target),
                Op::Bpl { target } => branch = (!self.n).then_some(target),
                _ => return None,
            }
            pc = branch.unwrap_or(pc.wrapping_add(u32::from(slot.len)));
            if branch.is_some() {
                turn.cycles += cost::refill(pessimistic);
            }
            if pc == poll.pc {
                break;
            }
            slot = slot_at(pc)?;
        }
        turn.counter.is_none_or(|counter| shifted >> counter & 1 == 0).then_some(turn)
    }

    fn state(&self) -> State {
        State { r: self.r, flags: [self.n, self.z, self.c, self.v] }
    }

    fn restore(&mut self, state: &State) {
        self.r = state.r;
        [self.n, self.z, self.c, self.v] = state.flags;
    }
}
