//! 32-bit loads and stores (ARMv7-M ARM A5.3.5 to A5.3.10).
use super::{bits, reg};
use crate::core::op::{Index, Op, Size};

/// A5.3.5: load and store multiple.
pub(super) fn multiple(a: u32, b: u32) -> Op {
    let (rn, list, writeback) = (reg(a, 0), b as u16, bits(a, 5, 1) == 1);
    match (bits(a, 7, 2), bits(a, 4, 1)) {
        (1, 1) if rn == 13 && writeback => Op::Pop { list },
        (1, 1) => Op::Ldm { rn, list, before: false, writeback: writeback && list & (1 << rn) == 0 },
        (2, 1) => Op::Ldm { rn, list, before: true, writeback: writeback && list & (1 << rn) == 0 },
        (1, _) => Op::Stm { rn, list, before: false, writeback },
        (2, _) if rn == 13 && writeback => Op::Push { list },
        (2, _) => Op::Stm { rn, list, before: true, writeback },
        _ => Op::Undefined,
    }
}

/// A5.3.6: load and store dual or exclusive, table branch.
pub(super) fn dual_or_exclusive(pc: u32, a: u32, b: u32) -> Op {
    let (rn, rt, rt2) = (reg(a, 0), reg(b, 12), reg(b, 8));
    let (p, u, w, load) = (bits(a, 8, 1), bits(a, 7, 1), bits(a, 5, 1), bits(a, 4, 1) == 1);
    if p == 0 && w == 0 {
        let rd = reg(b, 0);
        return match (u, load, bits(b, 4, 4)) {
            (0, false, _) => Op::Strex { size: Size::Word, rd: rt2, rt, rn, imm: (bits(b, 0, 8) * 4) as u16 },
            (0, true, _) => Op::Ldrex { size: Size::Word, rt, rn, imm: (bits(b, 0, 8) * 4) as u16 },
            (1, false, 4) => Op::Strex { size: Size::Byte, rd, rt, rn, imm: 0 },
            (1, false, 5) => Op::Strex { size: Size::Half, rd, rt, rn, imm: 0 },
            (1, true, 0) => Op::TableBranch { rn, rm: rd, half: false },
            (1, true, 1) => Op::TableBranch { rn, rm: rd, half: true },
            (1, true, 4) => Op::Ldrex { size: Size::Byte, rt, rn, imm: 0 },
            (1, true, 5) => Op::Ldrex { size: Size::Half, rt, rn, imm: 0 },
            _ => Op::Undefined,
        };
    }
    let offset = (bits(b, 0, 8) * 4) as i16;
    let imm = if u == 1 { offset } else { -offset };
    let index = index(p, w);
    match (load, rn) {
        (true, 15) => Op::Ldrd { rt, rt2, rn, imm: literal_skew(pc, imm), index: Index::Offset },
        (true, _) => Op::Ldrd { rt, rt2, rn, imm, index },
        (false, 15) => Op::Undefined,
        (false, _) => Op::Strd { rt, rt2, rn, imm, index },
    }
}

/// Offset from the unaligned PC (address + 4) for a literal that counts from the aligned one.
fn literal_skew(pc: u32, imm: i16) -> i16 {
    imm - (pc & 2) as i16
}

fn index(p: u32, w: u32) -> Index {
    match (p, w) {
        (0, _) => Index::Post,
        (_, 0) => Index::Offset,
        _ => Index::Pre,
    }
}

/// A5.3.10: store single data item.
pub(super) fn store(a: u32, b: u32) -> Op {
    let (rn, rt) = (reg(a, 0), reg(b, 12));
    let size = match bits(a, 5, 2) {
        0 => Size::Byte,
        1 => Size::Half,
        2 => Size::Word,
        _ => return Op::Undefined,
    };
    if rn == 15 {
        return Op::Undefined;
    }
    let plain = |imm| match size {
        Size::Byte => Op::StrbImm { rt, rn, imm },
        Size::Half => Op::StrhImm { rt, rn, imm },
        _ => Op::StrImm { rt, rn, imm },
    };
    if bits(a, 7, 1) == 1 {
        return plain(bits(b, 0, 12));
    }
    if bits(b, 6, 6) == 0 {
        let (rm, n) = (reg(b, 0), bits(b, 4, 2) as u8);
        return match size {
            Size::Word => Op::StrReg { rt, rn, rm, n },
            _ => Op::StoreReg { size, rt, rn, rm, n },
        };
    }
    match immediate8(b) {
        Some((imm, Index::Offset)) => plain(i32::from(imm) as u32),
        Some((imm, index)) => Op::Store { size, rt, rn, imm, index },
        None => Op::Undefined,
    }
}

/// The eight-bit forms: negative offset, pre- and post-indexed, unprivileged.
fn immediate8(b: u32) -> Option<(i16, Index)> {
    if b & 0x800 == 0 {
        return None;
    }
    let offset = bits(b, 0, 8) as i16;
    let imm = if bits(b, 9, 1) == 1 { offset } else { -offset };
    match bits(b, 8, 3) {
        // LDRT and its like: no MPU stands between privileged and not.
        0b110 => Some((imm, Index::Offset)),
        0b100 => Some((imm, Index::Offset)),
        0b101 | 0b111 => Some((imm, Index::Pre)),
        0b001 | 0b011 => Some((imm, Index::Post)),
        _ => None,
    }
}

/// A5.3.7 to A5.3.9: loads and memory hints.
pub(super) fn load(pc: u32, a: u32, b: u32) -> Op {
    let (rn, rt) = (reg(a, 0), reg(b, 12));
    let size = match (bits(a, 5, 2), bits(a, 8, 1)) {
        (0, 0) => Size::Byte,
        (1, 0) => Size::Half,
        (2, 0) => Size::Word,
        (0, _) => Size::SignedByte,
        (1, _) => Size::SignedHalf,
        _ => return Op::Undefined,
    };
    // Loads of a byte or half into the PC are PLD, PLI and unallocated hints.
    let hint = rt == 15 && size != Size::Word;
    if rn == 15 {
        let base = pc.wrapping_add(4) & !3;
        let offset = bits(b, 0, 12);
        let address = if bits(a, 7, 1) == 1 { base.wrapping_add(offset) } else { base.wrapping_sub(offset) };
        return match size {
            _ if hint => Op::Nop,
            Size::Word if rt != 15 => Op::LdrLit { rt, address },
            _ => Op::LoadLit { size, rt, address },
        };
    }
    let plain = |imm: i16| {
        let (wide, index) = (i32::from(imm) as u32, Index::Offset);
        match size {
            _ if hint => Op::Nop,
            Size::Byte => Op::LdrbImm { rt, rn, imm: wide },
            Size::Half => Op::LdrhImm { rt, rn, imm: wide },
            Size::Word if rt != 15 => Op::LdrImm { rt, rn, imm: wide },
            _ => Op::Load { size, rt, rn, imm, index },
        }
    };
    if bits(a, 7, 1) == 1 {
        return plain(bits(b, 0, 12) as i16);
    }
    if bits(b, 6, 6) == 0 {
        let (rm, n) = (reg(b, 0), bits(b, 4, 2) as u8);
        return match size {
            _ if hint => Op::Nop,
            Size::Byte => Op::LdrbReg { rt, rn, rm, n },
            Size::Word if rt != 15 => Op::LdrReg { rt, rn, rm, n },
            _ => Op::LoadReg { size, rt, rn, rm, n },
        };
    }
    match immediate8(b) {
        Some((imm, Index::Offset)) => plain(imm),
        Some(_) if hint => Op::Undefined,
        Some((imm, index)) => Op::Load { size, rt, rn, imm, index },
        None => Op::Undefined,
    }
}
