//! 32-bit data processing and multiplication (ARMv7-M ARM A5.3.1 to A5.3.3, A5.3.11 to A5.3.17).
use super::{bits, reg};
use crate::core::{
    alu,
    op::{Alu, Dsp, Lanes, Long, Op, Parallel, Saturating, Shift},
};

/// Operation number of A5.3.1 and A5.3.11, with the forms that have no destination or no first operand.
fn operation(number: u32, s: bool, rd: u8, rn: u8) -> Option<Alu> {
    Some(match number {
        0 if rd == 15 && s => Alu::Tst,
        0 => Alu::And,
        1 => Alu::Bic,
        2 if rn == 15 => Alu::Mov,
        2 => Alu::Orr,
        3 if rn == 15 => Alu::Mvn,
        3 => Alu::Orn,
        4 if rd == 15 && s => Alu::Teq,
        4 => Alu::Eor,
        8 if rd == 15 && s => Alu::Cmn,
        8 => Alu::Add,
        10 => Alu::Adc,
        11 => Alu::Sbc,
        13 if rd == 15 && s => Alu::Cmp,
        13 => Alu::Sub,
        14 => Alu::Rsb,
        _ => return None,
    })
}

/// A5.3.1: data processing (modified immediate).
pub(super) fn modified_immediate(a: u32, b: u32) -> Op {
    let (rn, rd, s) = (reg(a, 0), reg(b, 8), bits(a, 4, 1) == 1);
    let Some(op) = operation(bits(a, 5, 4), s, rd, rn) else { return Op::Undefined };
    let code = bits(a, 10, 1) << 11 | bits(b, 12, 3) << 8 | bits(b, 0, 8);
    let (imm, carry) = alu::expand_immediate(code);
    match (op, s) {
        (Alu::Mov, false) => Op::MovImm { rd, imm },
        (Alu::Mvn, false) => Op::MovImm { rd, imm: !imm },
        (Alu::Add, false) => Op::AddImm { rd, rn, imm },
        (Alu::Sub, false) => Op::AddImm { rd, rn, imm: imm.wrapping_neg() },
        (Alu::Add, true) => Op::AddsImm { rd, rn, imm },
        (Alu::Sub, true) => Op::SubsImm { rd, rn, imm },
        (Alu::Cmp, _) => Op::CmpImm { rn, imm },
        (Alu::And, false) => Op::AndImm { rd, rn, imm },
        (Alu::Orr, false) => Op::OrrImm { rd, rn, imm },
        (Alu::Bic, false) => Op::BicImm { rd, rn, imm },
        _ => Op::AluImm { op, s, carry, rd, rn, imm },
    }
}

/// A5.3.3: data processing (plain binary immediate).
pub(super) fn plain_immediate(pc: u32, a: u32, b: u32) -> Op {
    let (rn, rd) = (reg(a, 0), reg(b, 8));
    let imm12 = bits(a, 10, 1) << 11 | bits(b, 12, 3) << 8 | bits(b, 0, 8);
    let imm16 = bits(a, 0, 4) << 12 | imm12;
    let (shift, field) = ((bits(b, 12, 3) << 2 | bits(b, 6, 2)) as u8, bits(b, 0, 5) as u8);
    let base = pc.wrapping_add(4) & !3;
    match bits(a, 4, 5) {
        0 if rn == 15 => Op::MovImm { rd, imm: base.wrapping_add(imm12) },
        0 => Op::AddImm { rd, rn, imm: imm12 },
        4 => Op::MovImm { rd, imm: imm16 },
        10 if rn == 15 => Op::MovImm { rd, imm: base.wrapping_sub(imm12) },
        10 => Op::AddImm { rd, rn, imm: imm12.wrapping_neg() },
        12 => Op::MovTop { rd, imm: imm16 << 16 },
        16 => Op::Ssat { rd, rn, bits: field + 1, asr: false, n: shift },
        18 if shift == 0 => Op::Ssat16 { rd, rn, bits: (field & 15) + 1 },
        18 => Op::Ssat { rd, rn, bits: field + 1, asr: true, n: shift },
        20 => Op::Sbfx { rd, rn, lsb: shift, width: field + 1 },
        // The most significant bit below the least: UNPREDICTABLE, here of width 0.
        22 => Op::Bfi { rd, rn, lsb: shift, width: (field + 1).saturating_sub(shift) },
        24 => Op::Usat { rd, rn, bits: field, asr: false, n: shift },
        26 if shift == 0 => Op::Usat16 { rd, rn, bits: field & 15 },
        26 => Op::Usat { rd, rn, bits: field, asr: true, n: shift },
        28 => Op::Ubfx { rd, rn, lsb: shift, width: field + 1 },
        _ => Op::Undefined,
    }
}

/// Shift of an operand (A7.4.2): an amount of 0 means 32, or RRX.
fn decode_shift(kind: u32, n: u8) -> (Shift, u8) {
    match (kind, n) {
        (0, _) => (Shift::Lsl, n),
        (1, 0) => (Shift::Lsr, 32),
        (1, _) => (Shift::Lsr, n),
        (2, 0) => (Shift::Asr, 32),
        (2, _) => (Shift::Asr, n),
        (_, 0) => (Shift::Rrx, 1),
        _ => (Shift::Ror, n),
    }
}

/// A5.3.11: data processing (shifted register).
pub(super) fn shifted_register(a: u32, b: u32) -> Op {
    let (rn, rd, rm, s) = (reg(a, 0), reg(b, 8), reg(b, 0), bits(a, 4, 1) == 1);
    let amount = (bits(b, 12, 3) << 2 | bits(b, 6, 2)) as u8;
    let (shift, n) = decode_shift(bits(b, 4, 2), amount);
    if bits(a, 5, 4) == 6 {
        let top = bits(b, 5, 1) == 1;
        return if bits(b, 4, 1) == 1 || s { Op::Undefined } else { Op::Pkh { rd, rn, rm, top, n } };
    }
    let Some(op) = operation(bits(a, 5, 4), s, rd, rn) else { return Op::Undefined };
    match (op, s, shift, n) {
        (Alu::Mov, false, Shift::Lsl, 0) => Op::MovReg { rd, rm },
        (Alu::Mov, false, Shift::Lsl, _) => Op::LslImm { rd, rm, n },
        (Alu::Mov, false, Shift::Lsr, 1..32) => Op::LsrImm { rd, rm, n },
        (Alu::Mov, false, Shift::Asr, 1..32) => Op::AsrImm { rd, rm, n },
        (Alu::Mov, true, Shift::Lsl, 1..32) => Op::LslsImm { rd, rm, n },
        (Alu::Mov, true, Shift::Lsr, 1..32) => Op::LsrsImm { rd, rm, n },
        (Alu::Add, false, Shift::Lsl, 0) => Op::AddReg { rd, rn, rm },
        (Alu::Add, true, Shift::Lsl, 0) => Op::AddsReg { rd, rn, rm },
        (Alu::Sub, false, Shift::Lsl, 0) => Op::SubReg { rd, rn, rm },
        (Alu::Sub, true, Shift::Lsl, 0) => Op::SubsReg { rd, rn, rm },
        (Alu::Cmp, _, Shift::Lsl, 0) => Op::CmpReg { rn, rm },
        (Alu::And, false, Shift::Lsl, 0) => Op::AndReg { rd, rn, rm },
        (Alu::Orr, false, Shift::Lsl, 0) => Op::OrrReg { rd, rn, rm },
        (Alu::Eor, false, Shift::Lsl, 0) => Op::EorReg { rd, rn, rm },
        (Alu::Bic, false, Shift::Lsl, 0) => Op::BicReg { rd, rn, rm },
        (Alu::Add, false, Shift::Lsl, _) => Op::AddLsl { rd, rn, rm, n },
        (Alu::Orr, false, Shift::Lsl, _) => Op::OrrLsl { rd, rn, rm, n },
        _ => Op::AluReg { op, s, rd, rn, rm, shift, n },
    }
}

/// A5.3.12 to A5.3.15: data processing (register), parallel arithmetic, miscellaneous operations.
pub(super) fn register(a: u32, b: u32) -> Op {
    let (rn, rd, rm) = (reg(a, 0), reg(b, 8), reg(b, 0));
    let (op1, op2) = (bits(a, 4, 4), bits(b, 4, 4));
    if bits(b, 12, 4) != 15 {
        return Op::Undefined;
    }
    match (op1, op2) {
        (0..8, 0) => {
            let shift = [Shift::Lsl, Shift::Lsr, Shift::Asr, Shift::Ror][(op1 >> 1) as usize];
            Op::ShiftReg { shift, s: op1 & 1 == 1, rd, rn, rm }
        }
        (0..6, 8..16) => {
            let rotate = (op2 & 3) as u8 * 8;
            match (op1, rn, rotate) {
                (0, 15, 0) => Op::Sxth { rd, rm },
                (1, 15, 0) => Op::Uxth { rd, rm },
                (4, 15, 0) => Op::Sxtb { rd, rm },
                (5, 15, 0) => Op::Uxtb { rd, rm },
                _ => Op::Extend { kind: op1 as u8, rd, rn, rm, rotate },
            }
        }
        (8..16, 0..8) => parallel(op1, op2, rd, rn, rm),
        (8, 8..12) => {
            let op = [Saturating::Qadd, Saturating::Qdadd, Saturating::Qsub, Saturating::Qdsub]
                [(op2 & 3) as usize];
            Op::Saturating { op, rd, rn, rm }
        }
        (9, 8) => Op::Rev { rd, rm },
        (9, 9) => Op::Rev16 { rd, rm },
        (9, 10) => Op::Rbit { rd, rm },
        (9, 11) => Op::Revsh { rd, rm },
        (10, 8) => Op::Sel { rd, rn, rm },
        (11, 8) => Op::Clz { rd, rm },
        _ => Op::Undefined,
    }
}

/// A5.3.13 and A5.3.14: parallel addition and subtraction.
fn parallel(op1: u32, op2: u32, rd: u8, rn: u8, rm: u8) -> Op {
    let lanes = match op1 {
        8 => Lanes::Add8,
        9 => Lanes::Add16,
        10 => Lanes::Asx,
        12 => Lanes::Sub8,
        13 => Lanes::Sub16,
        14 => Lanes::Sax,
        _ => return Op::Undefined,
    };
    let prefix = match op2 {
        0 => Parallel::Signed,
        1 => Parallel::Saturating,
        2 => Parallel::SignedHalving,
        4 => Parallel::Unsigned,
        5 => Parallel::UnsignedSaturating,
        6 => Parallel::UnsignedHalving,
        _ => return Op::Undefined,
    };
    Op::Parallel { prefix, lanes, rd, rn, rm }
}

/// A5.3.16: multiply, multiply accumulate, absolute difference.
pub(super) fn multiply(a: u32, b: u32) -> Op {
    let (rn, rd, rm, ra) = (reg(a, 0), reg(b, 8), reg(b, 0), reg(b, 12));
    let (op1, op2) = (bits(a, 4, 3), bits(b, 4, 2));
    if bits(b, 6, 2) != 0 {
        return Op::Undefined;
    }
    let dsp = |op| Op::Dsp { op, mode: op2 as u8, rd, rn, rm, ra };
    match (op1, op2) {
        (0, 0) if ra == 15 => Op::Mul { rd, rn, rm },
        (0, 0) => Op::Mla { rd, rn, rm, ra },
        (0, 1) => Op::Mls { rd, rn, rm, ra },
        (1, _) => dsp(Dsp::Smla),
        (2, 0..2) => dsp(Dsp::Smlad),
        (3, 0..2) => dsp(Dsp::Smlaw),
        (4, 0..2) => dsp(Dsp::Smlsd),
        (5, 0..2) => dsp(Dsp::Smmla),
        (6, 0..2) => dsp(Dsp::Smmls),
        (7, 0) => dsp(Dsp::Usada8),
        _ => Op::Undefined,
    }
}

/// A5.3.17: long multiplication and division.
pub(super) fn long_multiply(a: u32, b: u32) -> Op {
    let (rn, lo, hi, rm) = (reg(a, 0), reg(b, 12), reg(b, 8), reg(b, 0));
    let (op1, op2) = (bits(a, 4, 3), bits(b, 4, 4));
    let long = |op| Op::Long { op, mode: (op2 & 3) as u8, lo, hi, rn, rm };
    match (op1, op2) {
        (0, 0) => Op::Smull { lo, hi, rn, rm },
        (1, 15) => Op::Sdiv { rd: hi, rn, rm },
        (2, 0) => Op::Umull { lo, hi, rn, rm },
        (3, 15) => Op::Udiv { rd: hi, rn, rm },
        (4, 0) => Op::Smlal { lo, hi, rn, rm },
        (4, 8..12) => long(Long::Smlal16),
        (4, 12 | 13) => long(Long::Smlald),
        (5, 12 | 13) => long(Long::Smlsld),
        (6, 0) => Op::Umlal { lo, hi, rn, rm },
        (6, 6) => long(Long::Umaal),
        _ => Op::Undefined,
    }
}
