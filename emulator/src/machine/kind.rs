//! Whether an ELF is for this machine: 32 bits, little-endian, executable, ARM.
use object::elf::{ELFCLASS32, ELFDATA2LSB, ELFMAG, EM_ARM, ET_EXEC};

use super::ImageError;

/// Says of an ELF for something else what it is.
pub(super) fn check(elf: &[u8]) -> Result<(), ImageError> {
    let (Some(ident), Some(rest)) = (elf.get(..16), elf.get(16..20)) else {
        return Err(ImageError::Kind("this is no ELF".to_owned()));
    };
    if !ident.starts_with(&ELFMAG) {
        return Err(ImageError::Kind("this is no ELF".to_owned()));
    }
    let little = ident[5] == ELFDATA2LSB;
    let half = |at: usize| {
        let bytes = [rest[at], rest[at + 1]];
        if little { u16::from_le_bytes(bytes) } else { u16::from_be_bytes(bytes) }
    };
    let (kind, machine) = (half(0), half(2));
    let what = if machine != EM_ARM {
        format!("this is an ELF for {}, not for ARM", name(machine))
    } else if ident[4] != ELFCLASS32 {
        "this is a 64-bit ELF; a Cortex-M runs 32-bit ones".to_owned()
    } else if !little {
        "this is a big-endian ELF; the STM32F405 is little-endian".to_owned()
    } else if kind != ET_EXEC {
        format!("this ELF is no executable (ET_EXEC) but {}", type_name(kind))
    } else {
        return Ok(());
    };
    Err(ImageError::Kind(what))
}

fn name(machine: u16) -> String {
    match machine {
        object::elf::EM_386 => "Intel 80386".to_owned(),
        object::elf::EM_X86_64 => "x86-64".to_owned(),
        object::elf::EM_AARCH64 => "64-bit ARM (AArch64)".to_owned(),
        object::elf::EM_RISCV => "RISC-V".to_owned(),
        object::elf::EM_XTENSA => "Xtensa".to_owned(),
        object::elf::EM_AVR => "AVR".to_owned(),
        object::elf::EM_MIPS => "MIPS".to_owned(),
        other => format!("machine {other}"),
    }
}

fn type_name(kind: u16) -> String {
    match kind {
        object::elf::ET_REL => "an object file, not linked yet".to_owned(),
        object::elf::ET_DYN => "a shared object".to_owned(),
        object::elf::ET_CORE => "a core dump".to_owned(),
        other => format!("of type {other}"),
    }
}

#[cfg(test)]
mod tests {
    use super::check;

    fn said(class: u8, data: u8, kind: u16, machine: u16) -> String {
        let half = |value: u16| if data == 2 { value.to_be_bytes() } else { value.to_le_bytes() };
        let mut elf = vec![0x7F, b'E', b'L', b'F', class, data];
        elf.resize(16, 0);
        elf.extend([half(kind), half(machine)].concat());
        check(&elf).map_or_else(|error| error.to_string(), |()| String::new())
    }

    #[test]
    fn an_elf_for_something_else_is_told_as_what_it_is() {
        assert_eq!(said(1, 1, 2, 40), "");
        assert_eq!(said(1, 1, 2, 3), "this is an ELF for Intel 80386, not for ARM");
        assert_eq!(said(2, 1, 2, 62), "this is an ELF for x86-64, not for ARM");
        assert_eq!(said(1, 2, 2, 40), "this is a big-endian ELF; the STM32F405 is little-endian");
        assert!(said(1, 1, 1, 40).contains("an object file"));
        assert!(check(b"no ELF").is_err());
    }
}
