//! 32-bit encodings: the first split, branches and system instructions (ARMv7-M ARM A5.3, A5.3.4).
use super::{barrier, bits, branch_if, data, float, memory, reg, sign_extend};
use crate::core::op::Op;

/// Decodes the encoding `first`:`second` at `pc`.
pub(super) fn decode(pc: u32, a: u32, b: u32) -> Op {
    match (bits(a, 11, 2), bits(a, 4, 7)) {
        (1, op) if op & 0b110_0100 == 0 => memory::multiple(a, b),
        (1, op) if op & 0b110_0100 == 0b000_0100 => memory::dual_or_exclusive(pc, a, b),
        (1, op) if op & 0b110_0000 == 0b010_0000 => data::shifted_register(a, b),
        (1 | 3, op) if op & 0b100_0000 != 0 => float::coprocessor(pc, a, b),
        (2, _) if b & 0x8000 != 0 => branch_or_system(pc, a, b),
        (2, op) if op & 0b010_0000 == 0 => data::modified_immediate(a, b),
        (2, _) => data::plain_immediate(pc, a, b),
        (3, op) if op & 0b111_0001 == 0 => memory::store(a, b),
        (3, op) if op & 0b110_0001 == 0b000_0001 => memory::load(pc, a, b),
        (3, op) if op & 0b111_0000 == 0b010_0000 => data::register(a, b),
        (3, op) if op & 0b111_1000 == 0b011_0000 => data::multiply(a, b),
        (3, op) if op & 0b111_1000 == 0b011_1000 => data::long_multiply(a, b),
        _ => Op::Undefined,
    }
}

/// A5.3.4.
fn branch_or_system(pc: u32, a: u32, b: u32) -> Op {
    let (s, j1, j2) = (bits(a, 10, 1), bits(b, 13, 1), bits(b, 11, 1));
    let next = pc.wrapping_add(4);
    if bits(b, 12, 1) == 1 {
        // B.W (T4) and BL: I1 = NOT(J1 EOR S).
        let (i1, i2) = (!(j1 ^ s) & 1, !(j2 ^ s) & 1);
        let offset = s << 24 | i1 << 23 | i2 << 22 | bits(a, 0, 10) << 12 | bits(b, 0, 11) << 1;
        let target = next.wrapping_add(sign_extend(offset, 25));
        return if bits(b, 14, 1) == 1 { Op::Bl { target } } else { Op::B { target } };
    }
    if bits(b, 14, 1) == 1 {
        // BLX (immediate) would leave Thumb state: undefined here.
        return Op::Undefined;
    }
    let op = bits(a, 4, 7);
    if op & 0b011_1000 != 0b011_1000 {
        let offset = s << 20 | j2 << 19 | j1 << 18 | bits(a, 0, 6) << 12 | bits(b, 0, 11) << 1;
        return branch_if(bits(a, 6, 4), next.wrapping_add(sign_extend(offset, 21)));
    }
    match op {
        0b011_1000 | 0b011_1001 => {
            Op::Msr { rn: reg(a, 0), mask: bits(b, 10, 2) as u8, sysm: bits(b, 0, 8) as u8 }
        }
        0b011_1010 if bits(b, 8, 3) == 0 => match bits(b, 0, 8) {
            2 => Op::Wfe,
            3 => Op::Wfi,
            4 => Op::Sev,
            _ => Op::Nop,
        },
        0b011_1011 => barrier(bits(b, 4, 4)),
        0b011_1110 | 0b011_1111 => Op::Mrs { rd: reg(b, 8), sysm: bits(b, 0, 8) as u8 },
        _ => Op::Undefined,
    }
}
