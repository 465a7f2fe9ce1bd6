#!/usr/bin/env python3
"""Writes src/groups.s: every instruction form as assembly text, so that the assembler, not this project, encodes it.

Each case is a header halfword (length in halfwords) and the instructions; cases of a kind form a group. Registers:
r0..r6 hold operands, r7 points into a buffer, r8 holds a small index, r9..r12 and lr hold operands.
"""
import itertools
import random

random.seed(1)
groups = []


def group(name, cases):
    groups.append((name, list(cases)))


def wide(name, immediate):
    """The assembler takes .w only where a narrow form exists."""
    return ".w" if name in ("add", "sub", "cmp", "mov") else ""


def it(condition, *instructions):
    return "\n".join([condition, *instructions])


LOW = ["r0", "r1", "r2", "r3", "r4"]
ANY = ["r0", "r3", "r5", "r9", "r10", "r11", "r12", "lr"]
CONDITIONS = "eq ne cs cc mi pl vs vc hi ls ge lt gt le".split()
IMMEDIATES = ["#0", "#1", "#0xff", "#0x00ab00ab", "#0xcd00cd00", "#0x5e5e5e5e", "#0x80000000", "#0xff000000",
              "#0x3fc00", "#0x104", "#0x7f8", "#0x000001fe"]
SHIFTS = ["", ", lsl #1", ", lsl #7", ", lsl #31", ", lsr #1", ", lsr #32", ", lsr #13", ", asr #1", ", asr #32",
          ", asr #20", ", ror #1", ", ror #31", ", rrx"]


def three():
    return random.choice(ANY), random.choice(ANY), random.choice(ANY)


for name in "and bic orr orn eor add adc sbc sub rsb".split():
    group(f"{name}_imm", (f"{name}{s}{wide(name, i)} {d}, {n}, {i}" for s in ("", "s") for i in IMMEDIATES for d, n, _ in [three()]))
    group(f"{name}_reg", (f"{name}{s}.w {d}, {n}, {m}{sh}" for s in ("", "s") for sh in SHIFTS for d, n, m in [three()]))
for name in "mov mvn".split():
    group(f"{name}_imm", (f"{name}{s}.w {d}, {i}" for s in ("", "s") for i in IMMEDIATES for d, _, _ in [three()]))
    group(f"{name}_reg", (f"{name}{s}.w {d}, {m}{sh}" for s in ("", "s") for sh in (SHIFTS if name == "mvn" else [""])
                          for d, _, m in [three()]))
for name in "tst teq cmp cmn".split():
    group(f"{name}_imm", (f"{name}{wide(name, i)} {n}, {i}" for i in IMMEDIATES for _, n, _ in [three()]))
    group(f"{name}_reg", (f"{name}.w {n}, {m}{sh}" for sh in SHIFTS for _, n, m in [three()]))
group("shift_wide_imm", (f"{op}{s}.w {d}, {m}, #{n}" for op in ("lsl", "lsr", "asr", "ror") for s in ("", "s")
                         for n in (1, 2, 15, 30, 31) for d, _, m in [three()]))
group("shift_wide_reg", (f"{op}{s}.w {d}, {n}, {m}" for op in ("lsl", "lsr", "asr", "ror") for s in ("", "s")
                         for m in ("r8", "r3", "r11") for d, n, _ in [three()]))
group("plain_imm", [f"addw {d}, {n}, #{i}" for i in (0, 1, 0x7ff, 0xfff) for d, n, _ in [three()]]
      + [f"subw {d}, {n}, #{i}" for i in (0, 1, 0x7ff, 0xfff) for d, n, _ in [three()]]
      + [f"movw {d}, #{i}" for i in (0, 1, 0xa5a5, 0xffff) for d, _, _ in [three()]]
      + [f"movt {d}, #{i}" for i in (0, 1, 0xa5a5, 0xffff) for d, _, _ in [three()]]
      + ["adr.w r3, . + 40", "adr r2, . + 20", "nop\nadr r2, . + 22", "nop\nadr.w r5, . + 18", "adr.w r4, . - 20"])
group("narrow_shift", [f"{op}s {d}, {m}, #{n}" for op in ("lsl", "lsr", "asr") for n in (1, 7, 31) for d in LOW[:2]
                       for m in LOW[2:4]] + ["lsrs r0, r1, #32", "asrs r1, r2, #32", "movs r3, r4"])
group("narrow_arithmetic", [f"{op}s {d}, {n}, {m}" for op in ("add", "sub") for d, n, m in
                            [("r0", "r1", "r2"), ("r3", "r3", "r4"), ("r5", "r6", "r5")]]
      + [f"{op}s r1, r2, #{i}" for op in ("add", "sub") for i in (0, 1, 7)]
      + [f"{op}s r{d}, #{i}" for op in ("add", "sub", "mov") for d in (0, 5) for i in (0, 1, 128, 255)]
      + [f"cmp r{d}, #{i}" for d in (0, 5) for i in (0, 1, 128, 255)])
group("narrow_data", [f"{op} {d}, {m}" for op in ("ands", "eors", "lsls", "lsrs", "asrs", "adcs", "sbcs", "rors",
                                                   "tst", "cmp", "cmn", "orrs", "bics", "mvns")
                      for d, m in (("r0", "r1"), ("r4", "r2"), ("r3", "r3"))]
      + ["rsbs r0, r1, #0", "rsbs r2, r2, #0", "muls r0, r1, r0", "muls r3, r4, r3"])
group("narrow_special", ["add r0, r9", "add r10, r3", "add r12, lr", "cmp r0, r9", "cmp r11, r2", "cmp r12, r9",
                         "mov r0, r12", "mov r9, r3", "add r1, sp, #0", "mov r2, sp", "add r3, sp", "add sp, #16\nsub sp, #16",
                         "add r4, pc", "mov r6, pc", "cmp r3, pc" if False else "nop"])
for name in ("uxtb", "uxth", "sxtb", "sxth"):
    group(name, [f"{name} r0, r1", f"{name} r4, r3"]
          + [f"{name}.w {d}, {m}, ror #{r}" for r in (0, 8, 16, 24) for d, _, m in [three()]])
for name in ("uxtb16", "sxtb16"):
    group(name, (f"{name} {d}, {m}, ror #{r}" for r in (0, 8, 16, 24) for d, _, m in [three()]))
for name in ("uxtab", "uxtah", "sxtab", "sxtah", "uxtab16", "sxtab16"):
    group(name, (f"{name} {d}, {n}, {m}, ror #{r}" for r in (0, 8, 16, 24) for d, n, m in [three(), three()]))
FIELDS = [(0, 1), (0, 32), (31, 1), (5, 7), (16, 16), (1, 31), (24, 8), (3, 20)]
group("bitfield", [f"{op} {d}, {n}, #{l}, #{w}" for op in ("ubfx", "sbfx", "bfi") for l, w in FIELDS
                   for d, n, _ in [three()]] + [f"bfc {d}, #{l}, #{w}" for l, w in FIELDS for d, _, _ in [three()]])
group("count_reverse", [f"{op} {d}, {m}" for op in ("clz", "rbit", "rev.w", "rev16.w", "revsh.w") for d, _, m in
                        (three(), three())] + [f"{op} r{d}, r{m}" for op in ("rev", "rev16", "revsh") for d, m in
                                               ((0, 1), (4, 2))])
group("sel", (f"sel {d}, {n}, {m}" for d, n, m in (three() for _ in range(6))))
group("ssat", [f"ssat {d}, #{b}, {n}{s}" for b in (1, 2, 8, 16, 31, 32) for s in ("", ", lsl #1", ", lsl #31", ", asr #1", ", asr #31")
               for d, n, _ in [three()]])
group("usat", [f"usat {d}, #{b}, {n}{s}" for b in (0, 1, 8, 16, 31) for s in ("", ", lsl #1", ", lsl #31", ", asr #1", ", asr #31")
               for d, n, _ in [three()]])
group("sat16", [f"ssat16 {d}, #{b}, {n}" for b in (1, 2, 8, 15, 16) for d, n, _ in [three()]]
      + [f"usat16 {d}, #{b}, {n}" for b in (0, 1, 8, 15) for d, n, _ in [three()]])
group("pkh", [f"pkhbt {d}, {n}, {m}{s}" for s in ("", ", lsl #1", ", lsl #16", ", lsl #31") for d, n, m in [three()]]
      + [f"pkhtb {d}, {n}, {m}{s}" for s in (", asr #1", ", asr #16", ", asr #32") for d, n, m in [three()]])
group("qadd", (f"{op} {d}, {m}, {n}" for op in ("qadd", "qsub", "qdadd", "qdsub") for d, n, m in (three(), three(), three())))
for lanes in "add8 add16 asx sax sub8 sub16".split():
    group(f"parallel_{lanes}", (f"{p}{lanes} {d}, {n}, {m}" for p in "s q sh u uq uh".split()
                                for d, n, m in (three(), three())))
group("mul", [f"{op} {d}, {n}, {m}, r6" for op in ("mla", "mls") for d, n, m in (three(), three(), three())]
      + [f"mul {d}, {n}, {m}" for d, n, m in (three(), three(), three())])
group("long_mul", (f"{op} r0, r5, {n}, {m}" for op in ("umull", "smull", "umlal", "smlal", "umaal")
                   for _, n, m in (three(), three(), three())))
group("dsp16", [f"smul{x}{y} {d}, {n}, {m}" for x in "bt" for y in "bt" for d, n, m in (three(), three())]
      + [f"smla{x}{y} {d}, {n}, {m}, r6" for x in "bt" for y in "bt" for d, n, m in (three(), three())]
      + [f"smulw{y} {d}, {n}, {m}" for y in "bt" for d, n, m in (three(), three())]
      + [f"smlaw{y} {d}, {n}, {m}, r6" for y in "bt" for d, n, m in (three(), three())]
      + [f"smlal{x}{y} r0, r5, {n}, {m}" for x in "bt" for y in "bt" for _, n, m in (three(), three())])
group("dsp_dual", [f"{op}{x} {d}, {n}, {m}" for op in ("smuad", "smusd") for x in ("", "x") for d, n, m in (three(), three())]
      + [f"{op}{x} {d}, {n}, {m}, r6" for op in ("smlad", "smlsd") for x in ("", "x") for d, n, m in (three(), three())]
      + [f"{op}{x} r0, r5, {n}, {m}" for op in ("smlald", "smlsld") for x in ("", "x") for _, n, m in (three(), three())])
group("dsp_high", [f"smmul{r} {d}, {n}, {m}" for r in ("", "r") for d, n, m in (three(), three())]
      + [f"{op}{r} {d}, {n}, {m}, r6" for op in ("smmla", "smmls") for r in ("", "r") for d, n, m in (three(), three())]
      + [f"usad8 {d}, {n}, {m}" for d, n, m in (three(), three())]
      + [f"usada8 {d}, {n}, {m}, r6" for d, n, m in (three(), three())])
group("div", (f"{op} {d}, {n}, {m}" for op in ("udiv", "sdiv") for d, n, m in (three() for _ in range(6))))
group("branch", [f"b{c} 1f\nmovs r0, #1\n1: nop" for c in CONDITIONS] + [f"b{c}.w 1f\nmovs r0, #1\n1: nop" for c in CONDITIONS]
      + ["b 1f\nmovs r0, #1\n1: nop", "b.w 1f\nmovs r0, #1\n1: nop", "cbz r0, 1f\nmovs r1, #1\n1: nop",
         "cbnz r0, 1f\nmovs r1, #1\n1: nop", "cbz r2, 1f\nmovs r1, #1\n1: nop", "bl 1f\nmovs r0, #1\n1: nop",
         "adr r0, 1f\nadds r0, #1\nbx r0\nmovs r1, #9\n.balign 4\n1: nop", "adr r0, 1f\nadds r0, #1\nblx r0\nmovs r1, #9\n.balign 4\n1: nop",
         "movs r0, #1\ntbb [pc, r0]\n.byte 2, 3\nmovs r1, #9\nmovs r2, #8\nmovs r3, #7",
         "movs r0, #1\ntbh [pc, r0, lsl #1]\n.hword 2, 3\nmovs r1, #9\nmovs r2, #8\nmovs r3, #7"])
group("it", [it(f"it {c}", f"mov{c} r0, r9") for c in CONDITIONS]
      + [it(f"ite {c}", f"add{c} r0, r1, r2", f"sub{o} r0, r1, r2") for c, o in zip(CONDITIONS[::2], CONDITIONS[1::2])]
      + [it(f"itt {c}", f"lsl{c} r0, r1, #3", f"add{c} r3, #200") for c in CONDITIONS]
      + [it(f"ittee {c}", f"cmp{c} r0, r1", f"mul{c} r2, r3, r2", f"and{o} r4, r5", f"adc{o} r0, r1")
         for c, o in zip(CONDITIONS[::2], CONDITIONS[1::2])]
      + [it(f"itet {c}", f"ands{c}.w r0, r1, r2", f"rsb{o} r3, r4, #0", f"mvn{c} r5, r6")
         for c, o in zip(CONDITIONS[::2], CONDITIONS[1::2])]
      + [it(f"itttt {c}", f"lsr{c} r0, r3", f"movs{c}.w r1, #0", f"eor{c} r2, r3", f"mov{c} r4, #77") for c in CONDITIONS])
OFFSETS = [0, 1, 2, 4, 31, 60]
group("load_imm", [f"{op}{'' if o < 0 else '.w'} {d}, [r7, #{o}]" for op in ("ldr", "ldrb", "ldrh", "ldrsb", "ldrsh") for o in OFFSETS + [-1, -4, -13, -32]
                   for d in random.sample(ANY, 1)])
group("store_imm", [f"{op}{'' if o < 0 else '.w'} {d}, [r7, #{o}]" for op in ("str", "strb", "strh") for o in OFFSETS + [-1, -4, -13, -32]
                    for d in random.sample(ANY, 1)])
group("load_index", [f"{op} {d}, {a}" for op in ("ldr", "ldrb", "ldrh", "ldrsb", "ldrsh")
                     for a in ("[r7, #4]!", "[r7, #-7]!", "[r7], #9", "[r7], #-4") for d in random.sample(ANY, 1)])
group("store_index", [f"{op} {d}, {a}" for op in ("str", "strb", "strh")
                      for a in ("[r7, #4]!", "[r7, #-7]!", "[r7], #9", "[r7], #-4") for d in random.sample(ANY, 1)])
group("load_reg", [f"{op}.w {d}, [r7, r8{s}]" for op in ("ldr", "ldrb", "ldrh", "ldrsb", "ldrsh")
                   for s in ("", ", lsl #1", ", lsl #2") for d in random.sample(ANY, 1)])
group("store_reg", [f"{op}.w {d}, [r7, r8{s}]" for op in ("str", "strb", "strh")
                    for s in ("", ", lsl #1", ", lsl #2") for d in random.sample(ANY, 1)])
group("narrow_memory", [f"{op} r1, [r7, #{o}]" for op, step in (("ldr", 4), ("ldrh", 2), ("ldrb", 1), ("str", 4), ("strh", 2), ("strb", 1))
                        for o in (0, step, 31 * step // 2 // step * step)]
      + [f"mov r6, r8\n{op} r2, [r7, r6]" for op in ("ldr", "ldrh", "ldrb", "ldrsh", "ldrsb", "str", "strh", "strb")]
      + ["str r3, [sp, #-64]\nsub sp, #64\nldr r0, [sp, #0]\nadd sp, #64", "sub sp, #8\nstr r4, [sp, #4]\nldr r2, [sp, #4]\nadd sp, #8"])
group("literal", ["ldr r0, 1f\nb 2f\n.balign 4\n1: .word 0x12345678\n2: nop", "ldr.w r9, 1f\nb 2f\n.balign 4\n1: .word 0x9abcdef0\n2: nop",
                  "ldrb.w r9, 1f\nb 2f\n.balign 4\n1: .word 0x9abcdef0\n2: nop", "ldrsh.w r3, 1f\nb 2f\n.balign 4\n1: .word 0x9abcdef0\n2: nop",
                  "nop\nldr r1, 1f\nb 2f\n.balign 4\n1: .word 0x0badcafe\n2: nop",
                  "ldrd r2, r3, 1f\nb 2f\n.balign 4\n1: .word 0x11223344, 0x55667788\n2: nop",
                  "vldr s4, 1f\nb 2f\n.balign 4\n1: .word 0x3f800001\n2: nop",
                  "nop\nvldr d4, 1f\nb 2f\n.balign 4\n1: .word 0x3f800001, 0x40490fdb\n2: nop"])
group("dual", [f"{op} r{a}, r{b}, {m}" for op in ("ldrd", "strd") for a, b in ((0, 1), (5, 3), (9, 12))
               for m in ("[r7]", "[r7, #8]", "[r7, #-16]", "[r7, #4]!", "[r7, #-4]!", "[r7], #12", "[r7], #-8")])
LISTS = ["{r0, r1}", "{r2, r3, r4}", "{r0, r5, r9, r12}", "{r0-r6}", "{r1, r10, r11, lr}"]
group("multiple", [f"{op}.w {base}, {l}" for op in ("ldmia", "ldmdb", "stmia", "stmdb") for base in ("r7", "r7!") for l in LISTS]
      + ["ldmia r7!, {r0, r1, r2}", "stmia r7!, {r0, r1, r2}", "ldmia r7, {r0, r7}", "push {r0, r3, lr}\npop {r1, r2, r3}",
         "push.w {r0, r9, r12}\npop.w {r1, r10, r11}", "push {r5}\npop {r6}", "adr r0, 1f\nadds r0, #1\npush {r0, r1}\npop {r0, r1}\npush {r0}\npop {pc}\n.balign 4\n1: nop"])
group("exclusive", ["ldrex r0, [r7]\nstrex r1, r2, [r7]", "ldrex r0, [r7, #8]\nstrex r1, r2, [r7, #8]",
                    "ldrexb r0, [r7]\nstrexb r1, r2, [r7]", "ldrexh r0, [r7]\nstrexh r1, r2, [r7]",
                    "clrex\nstrex r1, r2, [r7]", "ldrex r0, [r7]\nclrex\nstrex r1, r2, [r7]",
                    "ldrex r0, [r7]\nstrex r1, r2, [r7]\nstrex r3, r4, [r7]"])
group("hints", ["nop", "nop.w", "yield", "sev\nwfe", "dmb", "dsb", "isb", "pld [r7]", "pld [r7, #-4]", "pli [r7]", "dbg #1"])
group("special", ["mrs r0, apsr", "msr apsr_nzcvq, r1", "msr apsr_g, r1", "msr apsr_nzcvqg, r1", "msr basepri, r1\nmrs r0, basepri\nmovs r2, #0\nmsr basepri, r2\nand r0, r0, #0xf0",
                  "movs r0, #1\nmsr primask, r0\nmrs r1, primask\ncpsie i\nmrs r2, primask", "cpsid f\nmrs r0, faultmask\ncpsie f\nmrs r1, faultmask",
                  "cpsid i\nmrs r0, primask\ncpsie i", "mrs r0, ipsr", "mrs r0, control", "mrs r0, msp", "mrs r0, xpsr", "mrs r0, eapsr",
                  "movs r0, #0x80\nmsr basepri_max, r0\nmovs r1, #0xa0\nmsr basepri_max, r1\nmrs r2, basepri\nmovs r1, #0x40\nmsr basepri_max, r1\nmrs r3, basepri\nmovs r1, #0\nmsr basepri, r1"])


def floats():
    return [f"s{random.randrange(32)}" for _ in range(3)]


for name in "vadd vsub vmul vnmul vdiv vmla vmls vnmla vnmls vfma vfms vfnma vfnms".split():
    group(name, (f"{name}.f32 {d}, {n}, {m}" for d, n, m in (floats() for _ in range(24))))
for name in "vabs vneg vsqrt".split():
    group(name, (f"{name}.f32 {d}, {m}" for d, _, m in (floats() for _ in range(16))))
group("vcmp", (f"{op}.f32 {d}, {m}\nvmrs apsr_nzcv, fpscr" for op in ("vcmp", "vcmpe") for d, _, m in (floats() for _ in range(16))))
group("vcmp_zero", (f"{op}.f32 {d}, #0" for op in ("vcmp", "vcmpe") for d, _, _ in (floats() for _ in range(16))))
group("vmov", [f"vmov.f32 {d}, {m}" for d, _, m in (floats() for _ in range(4))] + [f"vmov.f32 {d}, #{v}" for v in
      ("1.0", "-2.0", "0.125", "31.0", "1.9375", "-0.2421875") for d, _, _ in [floats()]]
      + ["vmov r0, s3", "vmov s31, r9", "vmov r0, r1, s4, s5", "vmov s30, s31, r5, r6", "vmov r2, r3, d7", "vmov d15, r4, r12",
         "vmov.32 r0, d3[1]", "vmov.32 d4[0], r1", "vmov.32 d4[1], r2", "vmrs r0, fpscr", "vmsr fpscr, r1\nvmrs r2, fpscr"])
group("vcvt_int", (f"{op} {d}, {m}" for op in ("vcvt.f32.s32", "vcvt.f32.u32", "vcvt.s32.f32", "vcvt.u32.f32", "vcvtr.s32.f32", "vcvtr.u32.f32")
                   for d, _, m in (floats() for _ in range(16))))
for t in ("s16", "u16", "s32", "u32"):
    group(f"vcvt_fixed_{t}", [f"vcvt.{a} {d}, {d}, #{f}" for a in (f"f32.{t}", f"{t}.f32")
                              for f in ((1, 7, 15, 16) if "16" in t else (1, 7, 16, 31, 32)) for d, _, _ in (floats() for _ in range(3))])
group("vcvt_half", (f"{op} {d}, {m}" for op in ("vcvtb.f32.f16", "vcvtt.f32.f16", "vcvtb.f16.f32", "vcvtt.f16.f32")
                    for d, _, m in (floats() for _ in range(16))))
group("vload", [f"vldr s{n}, [r7, #{o}]" for n, o in ((0, 0), (31, 60), (7, -32))] + [f"vldr d{n}, [r7, #{o}]" for n, o in ((0, 0), (15, 32), (7, -32))]
      + [f"vldm{m} {b}, {l}" for m, b in (("ia", "r7"), ("ia", "r7!"), ("db", "r7!")) for l in ("{s0}", "{s3-s9}", "{d2-d4}", "{s31}")]
      + ["vpush {s0-s3}\nvpop {s4-s7}", "vpush {d8-d9}\nvpop {d1-d2}"])
group("vstore", [f"vstr s{n}, [r7, #{o}]" for n, o in ((0, 0), (31, 60), (7, -32))] + [f"vstr d{n}, [r7, #{o}]" for n, o in ((0, 0), (15, 32), (7, -32))]
      + [f"vstm{m} {b}, {l}" for m, b in (("ia", "r7"), ("ia", "r7!"), ("db", "r7!")) for l in ("{s0}", "{s3-s9}", "{d2-d4}", "{s31}")])

with open("src/groups.s", "w") as out:
    out.write("@ Written by generate.py; do not edit.\n.syntax unified\n.section .rodata.groups, \"a\"\n")
    count = itertools.count()
    for name, cases in groups:
        out.write(f".balign 4\ngroup_{name}:\n")
        for case in cases:
            n = next(count)
            out.write(f".balign 4\n.hword (.Le{n} - .Lb{n}) / 2, 0\n.Lb{n}:\n{case}\n.Le{n}:\n")
        out.write(".balign 4\n.hword 0xffff, 0\n")
    out.write(".balign 4\n.global groups\ngroups:\n")
    for name, _ in groups:
        out.write(f".word .Ln_{name}, {len(name)}, group_{name}\n")
    out.write(".word 0, 0, 0\n")
    for name, _ in groups:
        out.write(f".Ln_{name}: .ascii \"{name}\"\n")
print(sum(len(c) for _, c in groups), "cases in", len(groups), "groups")
