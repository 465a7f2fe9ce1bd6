//! From encodings to [`Op`]: the 16-bit ones here (ARMv7-M ARM A5.2), the 32-bit ones in the submodules.
mod data;
mod float;
mod memory;
mod wide;

use crate::core::{
    cost,
    op::{Alu, Barrier, Op, Shift, Size, Slot},
};

/// Whether a halfword starts a 32-bit encoding (A5.1).
pub(crate) fn is_wide(first: u16) -> bool {
    first >= 0xE800
}

/// Decodes the instruction at `pc`; `second` counts only when `first` starts a 32-bit encoding.
pub(crate) fn decode(pc: u32, first: u16, second: u16) -> Slot {
    let (op, len, narrow_flags) = if is_wide(first) {
        (wide::decode(pc, u32::from(first), u32::from(second)), 4, false)
    } else {
        let (op, narrow_flags) = narrow(pc, u32::from(first));
        (op, 2, narrow_flags)
    };
    Slot { op, len, cost: cost::fixed(op), narrow_flags }
}

/// Bits `low + width - 1 ..= low`.
fn bits(word: u32, low: u32, width: u32) -> u32 {
    (word >> low) & ((1 << width) - 1)
}

/// A register number.
fn reg(word: u32, low: u32) -> u8 {
    bits(word, low, 4) as u8
}

/// A register number of three bits.
fn reg3(word: u32, low: u32) -> u8 {
    bits(word, low, 3) as u8
}

/// Sign-extends the low `width` bits.
fn sign_extend(value: u32, width: u32) -> u32 {
    (((value << (32 - width)) as i32) >> (32 - width)) as u32
}

/// The conditional branch for `cond`, 0..=13.
fn branch_if(cond: u32, target: u32) -> Op {
    match cond {
        0 => Op::Beq { target },
        1 => Op::Bne { target },
        2 => Op::Bcs { target },
        3 => Op::Bcc { target },
        4 => Op::Bmi { target },
        5 => Op::Bpl { target },
        6 => Op::Bvs { target },
        7 => Op::Bvc { target },
        8 => Op::Bhi { target },
        9 => Op::Bls { target },
        10 => Op::Bge { target },
        11 => Op::Blt { target },
        12 => Op::Bgt { target },
        _ => Op::Ble { target },
    }
}

/// The operation and whether its flags depend on being outside an IT block.
fn narrow(pc: u32, w: u32) -> (Op, bool) {
    match w >> 10 {
        0..16 => (shift_add_compare(w), w >> 11 != 0b00101),
        16 => data_processing(w),
        17 => (special(w), false),
        18 | 19 => {
            let address = (pc.wrapping_add(4) & !3).wrapping_add(bits(w, 0, 8) * 4);
            (Op::LdrLit { rt: reg3(w, 8), address }, false)
        }
        20..40 => (load_store(w), false),
        40 | 41 => {
            let address = (pc.wrapping_add(4) & !3).wrapping_add(bits(w, 0, 8) * 4);
            (Op::MovImm { rd: reg3(w, 8), imm: address }, false)
        }
        42 | 43 => (Op::AddImm { rd: reg3(w, 8), rn: 13, imm: bits(w, 0, 8) * 4 }, false),
        44..48 => (miscellaneous(pc, w), false),
        48..52 => {
            let (rn, list) = (reg3(w, 8), bits(w, 0, 8) as u16);
            let op = if bits(w, 11, 1) == 0 {
                Op::Stm { rn, list, before: false, writeback: true }
            } else {
                Op::Ldm { rn, list, before: false, writeback: list & (1 << rn) == 0 }
            };
            (op, false)
        }
        52..56 => {
            let op = match bits(w, 8, 4) {
                14 => Op::Undefined,
                15 => Op::Svc,
                cond => branch_if(cond, pc.wrapping_add(4).wrapping_add(sign_extend(bits(w, 0, 8), 8) << 1)),
            };
            (op, false)
        }
        _ => (Op::B { target: pc.wrapping_add(4).wrapping_add(sign_extend(bits(w, 0, 11), 11) << 1) }, false),
    }
}

/// A5.2.1: shift (immediate), add, subtract, move and compare.
fn shift_add_compare(w: u32) -> Op {
    let (rd, rn, rm) = (reg3(w, 0), reg3(w, 3), reg3(w, 6));
    let n = bits(w, 6, 5) as u8;
    let (r8, imm8) = (reg3(w, 8), bits(w, 0, 8));
    match bits(w, 9, 5) {
        0..4 if n == 0 => Op::AluReg { op: Alu::Mov, s: true, rd, rn: 0, rm: rn, shift: Shift::Lsl, n: 0 },
        0..4 => Op::LslsImm { rd, rm: rn, n },
        4..8 if n != 0 => Op::LsrsImm { rd, rm: rn, n },
        4..8 => Op::AluReg { op: Alu::Mov, s: true, rd, rn: 0, rm: rn, shift: Shift::Lsr, n: 32 },
        8..12 => {
            let n = if n == 0 { 32 } else { n };
            Op::AluReg { op: Alu::Mov, s: true, rd, rn: 0, rm: rn, shift: Shift::Asr, n }
        }
        12 => Op::AddsReg { rd, rn, rm },
        13 => Op::SubsReg { rd, rn, rm },
        14 => Op::AddsImm { rd, rn, imm: u32::from(rm) },
        15 => Op::SubsImm { rd, rn, imm: u32::from(rm) },
        16..20 => Op::MovsImm { rd: r8, imm: imm8 },
        20..24 => Op::CmpImm { rn: r8, imm: imm8 },
        24..28 => Op::AddsImm { rd: r8, rn: r8, imm: imm8 },
        _ => Op::SubsImm { rd: r8, rn: r8, imm: imm8 },
    }
}

/// A5.2.2.
fn data_processing(w: u32) -> (Op, bool) {
    let (rd, rm) = (reg3(w, 0), reg3(w, 3));
    let plain = |op| Op::AluReg { op, s: true, rd, rn: rd, rm, shift: Shift::Lsl, n: 0 };
    let shift = |shift| Op::ShiftReg { shift, s: true, rd, rn: rd, rm };
    let op = match bits(w, 6, 4) {
        0 => plain(Alu::And),
        1 => plain(Alu::Eor),
        2 => shift(Shift::Lsl),
        3 => shift(Shift::Lsr),
        4 => shift(Shift::Asr),
        5 => plain(Alu::Adc),
        6 => plain(Alu::Sbc),
        7 => shift(Shift::Ror),
        8 => return (plain(Alu::Tst), false),
        9 => Op::AluImm { op: Alu::Rsb, s: true, carry: 2, rd, rn: rm, imm: 0 },
        10 => return (Op::CmpReg { rn: rd, rm }, false),
        11 => return (plain(Alu::Cmn), false),
        12 => plain(Alu::Orr),
        13 => Op::Muls { rd, rn: rm, rm: rd },
        14 => plain(Alu::Bic),
        _ => plain(Alu::Mvn),
    };
    (op, true)
}

/// A5.2.3: high registers, and branch and exchange.
fn special(w: u32) -> Op {
    let (rd, rm) = ((bits(w, 7, 1) << 3 | bits(w, 0, 3)) as u8, reg(w, 3));
    match bits(w, 8, 2) {
        0 if rd == 15 => Op::AddPc { rm },
        0 => Op::AddReg { rd, rn: rd, rm },
        1 => Op::CmpReg { rn: rd, rm },
        2 if rd == 15 => Op::MovPc { rm },
        2 => Op::MovReg { rd, rm },
        _ if bits(w, 7, 1) == 1 => Op::Blx { rm },
        _ => Op::Bx { rm },
    }
}

/// A5.2.4.
fn load_store(w: u32) -> Op {
    let (rt, rn, rm, imm5) = (reg3(w, 0), reg3(w, 3), reg3(w, 6), bits(w, 6, 5));
    let n = 0;
    match w >> 9 {
        0b010_1000 => Op::StrReg { rt, rn, rm, n },
        0b010_1001 => Op::StoreReg { size: Size::Half, rt, rn, rm, n },
        0b010_1010 => Op::StoreReg { size: Size::Byte, rt, rn, rm, n },
        0b010_1011 => Op::LoadReg { size: Size::SignedByte, rt, rn, rm, n },
        0b010_1100 => Op::LdrReg { rt, rn, rm, n },
        0b010_1101 => Op::LoadReg { size: Size::Half, rt, rn, rm, n },
        0b010_1110 => Op::LdrbReg { rt, rn, rm, n },
        0b010_1111 => Op::LoadReg { size: Size::SignedHalf, rt, rn, rm, n },
        _ => match w >> 11 {
            0b01100 => Op::StrImm { rt, rn, imm: imm5 * 4 },
            0b01101 => Op::LdrImm { rt, rn, imm: imm5 * 4 },
            0b01110 => Op::StrbImm { rt, rn, imm: imm5 },
            0b01111 => Op::LdrbImm { rt, rn, imm: imm5 },
            0b10000 => Op::StrhImm { rt, rn, imm: imm5 * 2 },
            0b10001 => Op::LdrhImm { rt, rn, imm: imm5 * 2 },
            0b10010 => Op::StrImm { rt: reg3(w, 8), rn: 13, imm: bits(w, 0, 8) * 4 },
            _ => Op::LdrImm { rt: reg3(w, 8), rn: 13, imm: bits(w, 0, 8) * 4 },
        },
    }
}

/// A5.2.5.
fn miscellaneous(pc: u32, w: u32) -> Op {
    let (rd, rm) = (reg3(w, 0), reg3(w, 3));
    match bits(w, 8, 4) {
        0 => {
            let imm = bits(w, 0, 7) * 4;
            let imm = if bits(w, 7, 1) == 0 { imm } else { imm.wrapping_neg() };
            Op::AddImm { rd: 13, rn: 13, imm }
        }
        1 | 3 | 9 | 11 => {
            let offset = (bits(w, 9, 1) << 6) | (bits(w, 3, 5) << 1);
            let target = pc.wrapping_add(4).wrapping_add(offset);
            if bits(w, 11, 1) == 0 { Op::Cbz { rn: rd, target } } else { Op::Cbnz { rn: rd, target } }
        }
        2 => match bits(w, 6, 2) {
            0 => Op::Sxth { rd, rm },
            1 => Op::Sxtb { rd, rm },
            2 => Op::Uxth { rd, rm },
            _ => Op::Uxtb { rd, rm },
        },
        4 | 5 => Op::Push { list: (bits(w, 0, 8) | bits(w, 8, 1) << 14) as u16 },
        6 if bits(w, 5, 3) == 0b011 => Op::Cps { disable: bits(w, 4, 1) == 1, masks: bits(w, 0, 2) as u8 },
        10 => match bits(w, 6, 2) {
            0 => Op::Rev { rd, rm },
            1 => Op::Rev16 { rd, rm },
            3 => Op::Revsh { rd, rm },
            _ => Op::Undefined,
        },
        12 | 13 => Op::Pop { list: (bits(w, 0, 8) | bits(w, 8, 1) << 15) as u16 },
        14 => Op::Bkpt { imm: bits(w, 0, 8) as u8 },
        15 if bits(w, 0, 4) != 0 => Op::It { state: bits(w, 0, 8) as u8 },
        15 => match bits(w, 4, 4) {
            2 => Op::Wfe,
            3 => Op::Wfi,
            4 => Op::Sev,
            _ => Op::Nop,
        },
        _ => Op::Undefined,
    }
}

/// The barriers of the 32-bit encodings.
fn barrier(kind: u32) -> Op {
    match kind {
        2 => Op::Clrex,
        4 | 5 => Op::Barrier { kind: Barrier::Data },
        6 => Op::Barrier { kind: Barrier::Instruction },
        _ => Op::Undefined,
    }
}

#[cfg(test)]
mod tests {
    use super::{Op, decode};
    use crate::core::op::{Alu, Shift};

    fn op(first: u16, second: u16) -> Op {
        decode(0x0800_0100, first, second).op
    }

    #[test]
    fn shifts_by_nothing_are_moves_and_right_shifts_reach_32() {
        let shift = |shift, n| Op::AluReg { op: Alu::Mov, s: true, rd: 1, rn: 0, rm: 2, shift, n };
        assert_eq!(op(0x0011, 0), shift(Shift::Lsl, 0));
        assert_eq!(op(0x0811, 0), shift(Shift::Lsr, 32));
        assert_eq!(op(0x1011, 0), shift(Shift::Asr, 32));
        // MOV.W R1, R2, RRX.
        let rrx = Op::AluReg { op: Alu::Mov, s: false, rd: 1, rn: 15, rm: 2, shift: Shift::Rrx, n: 1 };
        assert_eq!(op(0xEA4F, 0x0132), rrx);
    }

    #[test]
    fn literals_count_from_the_aligned_pc() {
        // LDR R0, [PC, #4] at an address that is, and one that is not, a multiple of four.
        assert_eq!(decode(0x0800_0100, 0x4801, 0).op, Op::LdrLit { rt: 0, address: 0x0800_0108 });
        assert_eq!(decode(0x0800_0102, 0x4801, 0).op, Op::LdrLit { rt: 0, address: 0x0800_0108 });
    }

    #[test]
    fn a_base_that_is_loaded_is_not_written_back() {
        assert_eq!(op(0xC803, 0), Op::Ldm { rn: 0, list: 3, before: false, writeback: false });
        assert_eq!(op(0xC806, 0), Op::Ldm { rn: 0, list: 6, before: false, writeback: true });
    }

    #[test]
    fn hints_do_nothing_and_holes_are_undefined() {
        assert_eq!(op(0xBF50, 0), Op::Nop);
        assert_eq!(op(0xF3AF, 0x8014), Op::Nop);
        assert_eq!(op(0xBF08, 0), Op::It { state: 0x08 });
        assert_eq!(op(0xDE00, 0), Op::Undefined);
        assert_eq!(op(0xF7F0, 0xA000), Op::Undefined);
        // BLX (immediate) would leave Thumb state.
        assert_eq!(op(0xF000, 0xE800), Op::Undefined);
    }

    #[test]
    fn coprocessors_other_than_floating_point_do_not_exist() {
        // CDP p0; VADD.F64; VADD.F32 of Advanced SIMD.
        assert_eq!(op(0xEE10, 0x2003), Op::NoCoprocessor);
        assert_eq!(op(0xEE30, 0x0B00), Op::Undefined);
        assert_eq!(op(0xEF00, 0x0D00), Op::Undefined);
        assert_eq!(op(0xEE30, 0x0A00), Op::Vadd { d: 0, n: 0, m: 0 });
    }

    #[test]
    fn lengths() {
        assert_eq!(decode(0, 0xE7FE, 0).len, 2);
        assert_eq!(decode(0, 0xE800, 0).len, 4);
        assert_eq!(decode(0, 0xF000, 0xF800).op, Op::Bl { target: 4 });
    }

    #[test]
    fn every_encoding_decodes() {
        for first in 0..=u16::MAX {
            for second in [0, 0x0F00, 0x8000, 0xF0F0, 0xFFFF, 0xBF00, 0x0A10] {
                decode(u32::MAX - 1, first, second);
            }
        }
    }
}
