//! Decoded instructions: what the interpreter runs, with every field taken out of the encoding once.

/// Operation of a data-processing instruction (ARMv7-M ARM, A5.3.1 and A5.3.11).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alu {
    And,
    Bic,
    Orr,
    Orn,
    Eor,
    Add,
    Adc,
    Sbc,
    Sub,
    Rsb,
    Mov,
    Mvn,
    Tst,
    Teq,
    Cmn,
    Cmp,
}

/// Kind of a shift (A7.4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shift {
    Lsl,
    Lsr,
    Asr,
    Ror,
    Rrx,
}

/// What one load or store moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    Byte,
    Half,
    Word,
    SignedByte,
    SignedHalf,
}

/// How a base register is indexed (A4.6.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Index {
    /// `[Rn, #imm]`.
    Offset,
    /// `[Rn, #imm]!`.
    Pre,
    /// `[Rn], #imm`.
    Post,
}

/// Prefix of a parallel addition or subtraction (A5.3.14).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parallel {
    Signed,
    Saturating,
    SignedHalving,
    Unsigned,
    UnsignedSaturating,
    UnsignedHalving,
}

/// Lanes of a parallel addition or subtraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lanes {
    Add8,
    Add16,
    Asx,
    Sax,
    Sub8,
    Sub16,
}

/// Multiplications of the DSP extension (A5.3.16, A5.3.17).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dsp {
    /// SMULxy, SMLAxy; the halves are bits 1 (first operand) and 0 (second).
    Smla,
    /// SMULWy, SMLAWy.
    Smlaw,
    /// SMUAD, SMLAD; bit 0 swaps the halves of the second operand.
    Smlad,
    /// SMUSD, SMLSD.
    Smlsd,
    /// SMMUL, SMMLA; bit 0 rounds.
    Smmla,
    /// SMMLS.
    Smmls,
    /// USAD8, USADA8.
    Usada8,
}

/// Long multiplications (A5.3.17).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Long {
    Umaal,
    /// SMLALxy.
    Smlal16,
    Smlald,
    Smlsld,
}

/// Saturating additions (A5.3.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Saturating {
    Qadd,
    Qdadd,
    Qsub,
    Qdsub,
}

/// Floating-point instructions with three registers (A6.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Float3 {
    Mla,
    Mls,
    Nmla,
    Nmls,
    Nmul,
    Div,
    Fma,
    Fms,
    Fnma,
    Fnms,
}

/// Floating-point instructions with two registers (A6.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Float2 {
    Mov,
    Abs,
    Neg,
    Sqrt,
    /// Half to single, bottom or top half.
    FromHalf(bool),
    /// Single to half, bottom or top half.
    ToHalf(bool),
    FromUnsigned,
    FromSigned,
    /// VCVTR: rounding of FPSCR.
    ToUnsigned,
    ToSigned,
    /// VCVT: towards zero.
    ToUnsignedZero,
    ToSignedZero,
}

/// Barriers, and what needs none (A7.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Barrier {
    Data,
    Instruction,
}

/// One decoded instruction. Registers are numbers 0..=15; immediates are expanded, targets absolute.
#[rustfmt::skip] // One line a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Op {
    /// Nothing decoded here yet.
    Undecoded,
    /// Raises UsageFault UNDEFINSTR.
    Undefined,
    /// A coprocessor that does not exist: UsageFault NOCP.
    NoCoprocessor,
    Nop,
    It {
        state: u8,
    },

    MovImm {
        rd: u8,
        imm: u32,
    },
    MovsImm {
        rd: u8,
        imm: u32,
    },
    MovReg {
        rd: u8,
        rm: u8,
    },
    MovPc {
        rm: u8,
    },
    MovTop {
        rd: u8,
        imm: u32,
    },
    AddImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    AddsImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    SubsImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    CmpImm {
        rn: u8,
        imm: u32,
    },
    CmpReg {
        rn: u8,
        rm: u8,
    },
    AddReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    AddPc {
        rm: u8,
    },
    AddsReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    SubReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    SubsReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    AddLsl {
        rd: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    AndImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    OrrImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    BicImm {
        rd: u8,
        rn: u8,
        imm: u32,
    },
    AndReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    OrrReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    EorReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    BicReg {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    OrrLsl {
        rd: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    LslImm {
        rd: u8,
        rm: u8,
        n: u8,
    },
    LsrImm {
        rd: u8,
        rm: u8,
        n: u8,
    },
    AsrImm {
        rd: u8,
        rm: u8,
        n: u8,
    },
    LslsImm {
        rd: u8,
        rm: u8,
        n: u8,
    },
    LsrsImm {
        rd: u8,
        rm: u8,
        n: u8,
    },
    /// `carry`: what C becomes in a logical operation that sets flags; 2 leaves it.
    AluImm {
        op: Alu,
        s: bool,
        carry: u8,
        rd: u8,
        rn: u8,
        imm: u32,
    },
    AluReg {
        op: Alu,
        s: bool,
        rd: u8,
        rn: u8,
        rm: u8,
        shift: Shift,
        n: u8,
    },
    ShiftReg {
        shift: Shift,
        s: bool,
        rd: u8,
        rn: u8,
        rm: u8,
    },

    Uxtb {
        rd: u8,
        rm: u8,
    },
    Uxth {
        rd: u8,
        rm: u8,
    },
    Sxtb {
        rd: u8,
        rm: u8,
    },
    Sxth {
        rd: u8,
        rm: u8,
    },
    /// `kind`: bits 2..0 of op1 in A5.3.14; `rn` = 15: none.
    Extend {
        kind: u8,
        rd: u8,
        rn: u8,
        rm: u8,
        rotate: u8,
    },
    Ubfx {
        rd: u8,
        rn: u8,
        lsb: u8,
        width: u8,
    },
    Sbfx {
        rd: u8,
        rn: u8,
        lsb: u8,
        width: u8,
    },
    Bfi {
        rd: u8,
        rn: u8,
        lsb: u8,
        width: u8,
    },
    Clz {
        rd: u8,
        rm: u8,
    },
    Rbit {
        rd: u8,
        rm: u8,
    },
    Rev {
        rd: u8,
        rm: u8,
    },
    Rev16 {
        rd: u8,
        rm: u8,
    },
    Revsh {
        rd: u8,
        rm: u8,
    },
    Sel {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    /// `bits`: saturate to this many; `n`: arithmetic right shift if `asr`, else left.
    Ssat {
        rd: u8,
        rn: u8,
        bits: u8,
        asr: bool,
        n: u8,
    },
    Usat {
        rd: u8,
        rn: u8,
        bits: u8,
        asr: bool,
        n: u8,
    },
    Ssat16 {
        rd: u8,
        rn: u8,
        bits: u8,
    },
    Usat16 {
        rd: u8,
        rn: u8,
        bits: u8,
    },
    Pkh {
        rd: u8,
        rn: u8,
        rm: u8,
        top: bool,
        n: u8,
    },
    Saturating {
        op: Saturating,
        rd: u8,
        rn: u8,
        rm: u8,
    },
    Parallel {
        prefix: Parallel,
        lanes: Lanes,
        rd: u8,
        rn: u8,
        rm: u8,
    },

    Mul {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    Muls {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    Mla {
        rd: u8,
        rn: u8,
        rm: u8,
        ra: u8,
    },
    Mls {
        rd: u8,
        rn: u8,
        rm: u8,
        ra: u8,
    },
    Dsp {
        op: Dsp,
        mode: u8,
        rd: u8,
        rn: u8,
        rm: u8,
        ra: u8,
    },
    Umull {
        lo: u8,
        hi: u8,
        rn: u8,
        rm: u8,
    },
    Smull {
        lo: u8,
        hi: u8,
        rn: u8,
        rm: u8,
    },
    Umlal {
        lo: u8,
        hi: u8,
        rn: u8,
        rm: u8,
    },
    Smlal {
        lo: u8,
        hi: u8,
        rn: u8,
        rm: u8,
    },
    Long {
        op: Long,
        mode: u8,
        lo: u8,
        hi: u8,
        rn: u8,
        rm: u8,
    },
    Udiv {
        rd: u8,
        rn: u8,
        rm: u8,
    },
    Sdiv {
        rd: u8,
        rn: u8,
        rm: u8,
    },

    B {
        target: u32,
    },
    Beq {
        target: u32,
    },
    Bne {
        target: u32,
    },
    Bcs {
        target: u32,
    },
    Bcc {
        target: u32,
    },
    Bmi {
        target: u32,
    },
    Bpl {
        target: u32,
    },
    Bvs {
        target: u32,
    },
    Bvc {
        target: u32,
    },
    Bhi {
        target: u32,
    },
    Bls {
        target: u32,
    },
    Bge {
        target: u32,
    },
    Blt {
        target: u32,
    },
    Bgt {
        target: u32,
    },
    Ble {
        target: u32,
    },
    Bl {
        target: u32,
    },
    Bx {
        rm: u8,
    },
    Blx {
        rm: u8,
    },
    Cbz {
        rn: u8,
        target: u32,
    },
    Cbnz {
        rn: u8,
        target: u32,
    },
    TableBranch {
        rn: u8,
        rm: u8,
        half: bool,
    },

    LdrImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    LdrbImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    LdrhImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    LdrLit {
        rt: u8,
        address: u32,
    },
    LdrReg {
        rt: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    LdrbReg {
        rt: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    StrImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    StrbImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    StrhImm {
        rt: u8,
        rn: u8,
        imm: u32,
    },
    StrReg {
        rt: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    Load {
        size: Size,
        rt: u8,
        rn: u8,
        imm: i16,
        index: Index,
    },
    Store {
        size: Size,
        rt: u8,
        rn: u8,
        imm: i16,
        index: Index,
    },
    LoadReg {
        size: Size,
        rt: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    StoreReg {
        size: Size,
        rt: u8,
        rn: u8,
        rm: u8,
        n: u8,
    },
    LoadLit {
        size: Size,
        rt: u8,
        address: u32,
    },
    Ldrd {
        rt: u8,
        rt2: u8,
        rn: u8,
        imm: i16,
        index: Index,
    },
    Strd {
        rt: u8,
        rt2: u8,
        rn: u8,
        imm: i16,
        index: Index,
    },
    Push {
        list: u16,
    },
    Pop {
        list: u16,
    },
    /// `before`: LDMDB; `writeback` of the base.
    Ldm {
        rn: u8,
        list: u16,
        before: bool,
        writeback: bool,
    },
    Stm {
        rn: u8,
        list: u16,
        before: bool,
        writeback: bool,
    },
    Ldrex {
        size: Size,
        rt: u8,
        rn: u8,
        imm: u16,
    },
    Strex {
        size: Size,
        rd: u8,
        rt: u8,
        rn: u8,
        imm: u16,
    },
    Clrex,

    Svc,
    Bkpt {
        imm: u8,
    },
    Wfi,
    Wfe,
    Sev,
    /// `disable`, and which of PRIMASK (bit 1) and FAULTMASK (bit 0).
    Cps {
        disable: bool,
        masks: u8,
    },
    Mrs {
        rd: u8,
        sysm: u8,
    },
    Msr {
        rn: u8,
        mask: u8,
        sysm: u8,
    },
    Barrier {
        kind: Barrier,
    },

    Vldr {
        d: u8,
        double: bool,
        rn: u8,
        imm: i16,
    },
    Vstr {
        d: u8,
        double: bool,
        rn: u8,
        imm: i16,
    },
    /// `count` single registers from `d`.
    Vldm {
        rn: u8,
        d: u8,
        count: u8,
        before: bool,
        writeback: bool,
    },
    Vstm {
        rn: u8,
        d: u8,
        count: u8,
        before: bool,
        writeback: bool,
    },
    Vadd {
        d: u8,
        n: u8,
        m: u8,
    },
    Vsub {
        d: u8,
        n: u8,
        m: u8,
    },
    Vmul {
        d: u8,
        n: u8,
        m: u8,
    },
    Float3 {
        op: Float3,
        d: u8,
        n: u8,
        m: u8,
    },
    Float2 {
        op: Float2,
        d: u8,
        m: u8,
    },
    VmovImm {
        d: u8,
        imm: u32,
    },
    /// Compare with register `m`, or with zero; `e`: quiet NaNs too raise Invalid Operation.
    Vcmp {
        d: u8,
        m: u8,
        zero: bool,
        e: bool,
    },
    VcvtFixed {
        d: u8,
        to_fixed: bool,
        half: bool,
        unsigned: bool,
        fraction: u8,
    },
    VmovFromCore {
        n: u8,
        rt: u8,
    },
    VmovToCore {
        n: u8,
        rt: u8,
    },
    /// Two registers starting with single register `m`.
    VmovPair {
        m: u8,
        rt: u8,
        rt2: u8,
        to_core: bool,
    },
    Vmrs {
        rt: u8,
    },
    Vmsr {
        rt: u8,
    },
}

/// A decoded instruction in its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Slot {
    /// What.
    pub(crate) op: Op,
    /// Bytes of the encoding: 2 or 4.
    pub(crate) len: u8,
    /// Cycles when nothing stands in the way; the executor adds what depends on data.
    pub(crate) cost: u8,
    /// A 16-bit encoding that sets flags only outside an IT block.
    pub(crate) narrow_flags: bool,
}

impl Slot {
    /// A place where nothing has been decoded.
    pub(crate) const EMPTY: Self = Self { op: Op::Undecoded, len: 2, cost: 0, narrow_flags: false };
}

impl Op {
    /// The same instruction inside an IT block, for those 16-bit encodings that set flags only outside one.
    pub(crate) fn without_flags(self) -> Self {
        match self {
            Self::MovsImm { rd, imm } => Self::MovImm { rd, imm },
            Self::AddsImm { rd, rn, imm } => Self::AddImm { rd, rn, imm },
            Self::SubsImm { rd, rn, imm } => Self::AddImm { rd, rn, imm: imm.wrapping_neg() },
            Self::AddsReg { rd, rn, rm } => Self::AddReg { rd, rn, rm },
            Self::SubsReg { rd, rn, rm } => Self::SubReg { rd, rn, rm },
            Self::LslsImm { rd, rm, n } => Self::LslImm { rd, rm, n },
            Self::LsrsImm { rd, rm, n } => Self::LsrImm { rd, rm, n },
            Self::Muls { rd, rn, rm } => Self::Mul { rd, rn, rm },
            Self::AluImm { op, carry, rd, rn, imm, .. } => Self::AluImm { op, s: false, carry, rd, rn, imm },
            Self::AluReg { op, rd, rn, rm, shift, n, .. } => {
                Self::AluReg { op, s: false, rd, rn, rm, shift, n }
            }
            Self::ShiftReg { shift, rd, rn, rm, .. } => Self::ShiftReg { shift, s: false, rd, rn, rm },
            other => other,
        }
    }
}

const _: () = assert!(size_of::<Op>() <= 12 && size_of::<Slot>() <= 16);
