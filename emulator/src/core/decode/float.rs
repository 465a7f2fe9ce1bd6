//! Coprocessor space: FPv4-SP is coprocessors 10 and 11 (ARMv7-M ARM A5.3.18, A6.3 to A6.7).
use super::{bits, reg};
use crate::core::op::{Float2, Float3, Op};

/// Any encoding with coprocessor form.
pub(super) fn coprocessor(pc: u32, a: u32, b: u32) -> Op {
    let op1 = bits(a, 4, 6);
    if op1 & 0b11_0000 == 0b11_0000 {
        // Advanced SIMD on other profiles.
        return Op::Undefined;
    }
    let number = bits(b, 8, 4);
    if number & 0b1110 != 0b1010 || bits(a, 12, 1) == 1 {
        return if number & 0b1110 == 0b1010 { Op::Undefined } else { Op::NoCoprocessor };
    }
    let double = number == 11;
    match op1 {
        0 | 1 => Op::Undefined,
        4 | 5 => pair(a, b, double),
        2..32 => transfer(pc, a, b, double),
        _ if bits(b, 4, 1) == 1 => move_one(a, b, double),
        // FPv4-SP has no double-precision arithmetic (A2.5).
        _ if double => Op::Undefined,
        _ => arithmetic(a, b),
    }
}

/// Single register number from a field of four bits and the bit that extends it below.
fn single(field: u32, low: u32) -> u8 {
    (field << 1 | low) as u8
}

/// A6.7: two core registers and two single (or one double) registers.
fn pair(a: u32, b: u32, double: bool) -> Op {
    if bits(b, 4, 4) & 0b1101 != 1 {
        return Op::Undefined;
    }
    let (field, low) = (bits(b, 0, 4), bits(b, 5, 1));
    let m = if double { ((low << 4 | field) << 1) as u8 } else { single(field, low) };
    if m >= 31 {
        return Op::Undefined;
    }
    Op::VmovPair { m, rt: reg(b, 12), rt2: reg(a, 0), to_core: bits(a, 4, 1) == 1 }
}

/// A6.5: loads and stores of extension registers.
fn transfer(pc: u32, a: u32, b: u32, double: bool) -> Op {
    let (rn, imm8) = (reg(a, 0), bits(b, 0, 8));
    let (p, u, w, load) = (bits(a, 8, 1), bits(a, 7, 1), bits(a, 5, 1), bits(a, 4, 1) == 1);
    let (field, low) = (bits(b, 12, 4), bits(a, 6, 1));
    let d = if double { (low << 4 | field) * 2 } else { field << 1 | low };
    if d > 31 {
        return Op::Undefined;
    }
    let d = d as u8;
    if p == 1 && w == 0 {
        let offset = (imm8 * 4) as i16;
        let imm = if u == 1 { offset } else { -offset };
        // Literals count from the aligned PC.
        let imm = if rn == 15 { imm - (pc & 2) as i16 } else { imm };
        return if load { Op::Vldr { d, double, rn, imm } } else { Op::Vstr { d, double, rn, imm } };
    }
    // FSTMX and FLDMX (odd count with double registers) move an even number all the same.
    let count = if double { imm8 & !1 } else { imm8 };
    if p == u || count == 0 || u32::from(d) + count > 32 {
        return Op::Undefined;
    }
    let (count, before, writeback) = (count as u8, p == 1, w == 1);
    if load {
        Op::Vldm { rn, d, count, before, writeback }
    } else {
        Op::Vstm { rn, d, count, before, writeback }
    }
}

/// A6.6: one core register and one extension or system register.
fn move_one(a: u32, b: u32, double: bool) -> Op {
    let (rt, load) = (reg(b, 12), bits(a, 4, 1) == 1);
    let (field, low) = (bits(a, 0, 4), bits(b, 7, 1));
    match (double, bits(a, 5, 3), load) {
        (false, 0, true) => Op::VmovToCore { n: single(field, low), rt },
        (false, 0, false) => Op::VmovFromCore { n: single(field, low), rt },
        (false, 7, _) if field == 1 => {
            if load {
                Op::Vmrs { rt }
            } else {
                Op::Vmsr { rt }
            }
        }
        // VMOV of one half (bit 21 of the encoding) of a double register; words only.
        (true, 0 | 1, _) if bits(b, 5, 2) == 0 && low == 0 => {
            let n = single(field, bits(a, 5, 1));
            if load { Op::VmovToCore { n, rt } } else { Op::VmovFromCore { n, rt } }
        }
        _ => Op::Undefined,
    }
}

/// A6.4: data processing.
fn arithmetic(a: u32, b: u32) -> Op {
    let d = single(bits(b, 12, 4), bits(a, 6, 1));
    let n = single(bits(a, 0, 4), bits(b, 7, 1));
    let m = single(bits(b, 0, 4), bits(b, 5, 1));
    let three = |op| Op::Float3 { op, d, n, m };
    match (bits(a, 7, 1) << 2 | bits(a, 4, 2), bits(b, 6, 1)) {
        (0, 0) => three(Float3::Mla),
        (0, _) => three(Float3::Mls),
        (1, 0) => three(Float3::Nmls),
        (1, _) => three(Float3::Nmla),
        (2, 0) => Op::Vmul { d, n, m },
        (2, _) => three(Float3::Nmul),
        (3, 0) => Op::Vadd { d, n, m },
        (3, _) => Op::Vsub { d, n, m },
        (4, 0) => three(Float3::Div),
        (5, 0) => three(Float3::Fnms),
        (5, _) => three(Float3::Fnma),
        (6, 0) => three(Float3::Fma),
        (6, _) => three(Float3::Fms),
        (7, 0) => {
            let imm8 = bits(a, 0, 4) << 4 | bits(b, 0, 4);
            // VFPExpandImm (A6.4.1): sign, NOT(b6) and b6 five times, then six bits.
            let b6 = bits(imm8, 6, 1);
            let exponent = (b6 ^ 1) << 7 | (b6 * 0b11111) << 2 | bits(imm8, 4, 2);
            Op::VmovImm { d, imm: bits(imm8, 7, 1) << 31 | exponent << 23 | bits(imm8, 0, 4) << 19 }
        }
        (7, _) => other(a, b, d, m),
        _ => Op::Undefined,
    }
}

/// Table A6-3: the rest, with two registers.
fn other(a: u32, b: u32, d: u8, m: u8) -> Op {
    let two = |op| Op::Float2 { op, d, m };
    let high = bits(b, 7, 1) == 1;
    match (bits(a, 0, 4), high) {
        (0, false) => two(Float2::Mov),
        (0, true) => two(Float2::Abs),
        (1, false) => two(Float2::Neg),
        (1, true) => two(Float2::Sqrt),
        (2, top) => two(Float2::FromHalf(top)),
        (3, top) => two(Float2::ToHalf(top)),
        (4, e) => Op::Vcmp { d, m, zero: false, e },
        (5, e) => Op::Vcmp { d, m: 0, zero: true, e },
        (8, false) => two(Float2::FromUnsigned),
        (8, true) => two(Float2::FromSigned),
        (12, false) => two(Float2::ToUnsigned),
        (12, true) => two(Float2::ToUnsignedZero),
        (13, false) => two(Float2::ToSigned),
        (13, true) => two(Float2::ToSignedZero),
        (10 | 11 | 14 | 15, word) => {
            let imm5 = bits(b, 0, 4) << 1 | bits(b, 5, 1);
            let size = if word { 32 } else { 16 };
            if imm5 > size {
                return Op::Undefined;
            }
            Op::VcvtFixed {
                d,
                to_fixed: bits(a, 2, 1) == 1,
                half: !word,
                unsigned: bits(a, 0, 1) == 1,
                fraction: (size - imm5) as u8,
            }
        }
        _ => Op::Undefined,
    }
}
