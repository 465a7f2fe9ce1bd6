//! Loading an ELF, and the symbols the machine looks for.
use object::{
    Endianness,
    elf::{FileHeader32, PT_LOAD, SHF_ALLOC},
    read::elf::{FileHeader, ProgramHeader, SectionHeader, Sym},
};

use super::kind;
use crate::{Machine, bus::Peripherals, memory::FLASH_BASE};

/// Why an ELF cannot be loaded.
#[derive(Debug, thiserror::Error)]
pub enum ImageError {
    /// Not a 32-bit ELF.
    #[error("not an ELF for this machine: {0}")]
    Elf(#[from] object::read::Error),
    /// Another kind of ELF than this machine runs.
    #[error("{0}")]
    Kind(String),
    /// A segment that no memory takes.
    #[error("a segment of {bytes} bytes at {address:#010x} lies in no memory")]
    Outside {
        /// Physical address.
        address: u32,
        /// Size in the file.
        bytes: usize,
    },
}

/// Addresses of symbols that tools look for.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// `_SEGGER_RTT`.
    pub(super) rtt: Option<u32>,
}

impl<P: Peripherals> Machine<P> {
    /// Loads an image by the physical addresses of its program headers, as a programmer does, and resets the core.
    /// Images linked at 0 are taken as linked to the alias of flash. An image with nothing in flash starts at its
    /// entry point, with the vector table at the lowest address loaded.
    ///
    /// # Errors
    /// [`ImageError`].
    pub fn load_elf(&mut self, elf: &[u8]) -> Result<(), ImageError> {
        kind::check(elf)?;
        let header = FileHeader32::<Endianness>::parse(elf)?;
        let endian = header.endian()?;
        let mut lowest = u32::MAX;
        for (address, content) in pieces(elf)? {
            self.memory
                .place(address, content)
                .ok_or(ImageError::Outside { address, bytes: content.len() })?;
            lowest = lowest.min(address);
        }
        self.symbols = Symbols::default();
        let sections = header.sections(endian, elf)?;
        let table = sections.symbols(endian, elf, object::elf::SHT_SYMTAB)?;
        for symbol in table.iter() {
            if symbol.name(endian, table.strings()).is_ok_and(|name| name == b"_SEGGER_RTT") {
                self.symbols.rtt = Some(symbol.st_value(endian));
            }
        }
        self.core.reset(&mut self.memory);
        let in_flash = lowest & !FLASH_BASE < crate::memory::FLASH_BYTES;
        if !in_flash {
            self.core.start_in_ram(&self.memory, lowest, header.e_entry(endian));
        }
        Ok(())
    }

    /// Puts a raw image at `address`, as a programmer does, and resets the core.
    ///
    /// # Errors
    /// [`ImageError::Outside`].
    pub fn load_binary(&mut self, address: u32, image: &[u8]) -> Result<(), ImageError> {
        self.memory.place(address, image).ok_or(ImageError::Outside { address, bytes: image.len() })?;
        self.core.reset(&mut self.memory);
        Ok(())
    }

    /// Whether the image has a channel of SEGGER's Real-Time Transfer.
    pub fn has_rtt(&self) -> bool {
        self.symbols.rtt.is_some()
    }

    /// What the program wrote to channel 0 of SEGGER's Real-Time Transfer since last asked; empty where the image
    /// has no such channel. Reading makes room, as a debug probe would.
    pub fn read_rtt(&mut self) -> Vec<u8> {
        self.try_read_rtt().unwrap_or_default()
    }

    fn try_read_rtt(&mut self) -> Option<Vec<u8>> {
        let block = self.symbols.rtt?;
        // The first up-channel lies behind the identifier (16 bytes) and two counts: name, buffer, size, write and
        // read offset, flags.
        let channel = block.checked_add(24)?;
        let word = |at: u32| {
            let bytes = self.memory.peek(at, 4)?;
            Some(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
        };
        let (buffer, size) = (word(channel + 4)?, word(channel + 8)?);
        let (write, read) = (word(channel + 12)?, word(channel + 16)?);
        let valid = self.memory.peek(block, 10).is_some_and(|id| id == b"SEGGER RTT");
        if !valid || write >= size || read >= size {
            return None;
        }
        let mut bytes = Vec::new();
        if write < read {
            bytes.extend_from_slice(self.memory.peek(buffer.checked_add(read)?, size - read)?);
            bytes.extend_from_slice(self.memory.peek(buffer, write)?);
        } else {
            bytes.extend_from_slice(self.memory.peek(buffer.checked_add(read)?, write - read)?);
        }
        self.memory.place(channel + 16, &write.to_le_bytes())?;
        Some(bytes)
    }
}

/// Address of a symbol of an ELF.
pub fn symbol_address(elf: &[u8], name: &str) -> Option<u32> {
    symbols(elf).ok()?.into_iter().find(|(symbol, _)| symbol == name).map(|(_, address)| address)
}

/// All symbols of an ELF with their values; names that are no text are left out.
///
/// # Errors
/// [`ImageError::Elf`].
pub fn symbols(elf: &[u8]) -> Result<Vec<(String, u32)>, ImageError> {
    let header = FileHeader32::<Endianness>::parse(elf)?;
    let endian = header.endian()?;
    let sections = header.sections(endian, elf)?;
    let table = sections.symbols(endian, elf, object::elf::SHT_SYMTAB)?;
    let named = |symbol: &object::elf::Sym32<Endianness>| {
        let name = symbol.name(endian, table.strings()).ok()?;
        Some((std::str::from_utf8(name).ok()?.to_owned(), symbol.st_value(endian)))
    };
    Ok(table.iter().filter_map(named).collect())
}

/// Where a programmer writes an image: address and length of each piece that it loads, in the order of the file.
///
/// # Errors
/// [`ImageError`].
pub fn loaded(elf: &[u8]) -> Result<Vec<(u32, usize)>, ImageError> {
    Ok(pieces(elf)?.into_iter().map(|(address, content)| (address, content.len())).collect())
}

/// Where the program of an image keeps what: address and length of each section that takes memory while it runs, whether it
/// is loaded or not.
///
/// # Errors
/// [`ImageError::Elf`].
pub fn occupied(elf: &[u8]) -> Result<Vec<(u32, usize)>, ImageError> {
    let header = FileHeader32::<Endianness>::parse(elf)?;
    let endian = header.endian()?;
    let sections = header.sections(endian, elf)?;
    let taken = sections.iter().filter(|s| s.sh_flags(endian) & SHF_ALLOC != 0);
    Ok(taken.map(|s| (s.sh_addr(endian), s.sh_size(endian) as usize)).filter(|(_, size)| *size > 0).collect())
}

/// What an image puts into flash, from the lowest address to the highest; gaps stay erased.
///
/// # Errors
/// [`ImageError`].
pub fn flash_content(elf: &[u8]) -> Result<Vec<u8>, ImageError> {
    let mut pieces = pieces(elf)?;
    pieces.retain_mut(|(address, _)| {
        *address &= !FLASH_BASE;
        *address < crate::memory::FLASH_BYTES
    });
    let begin = pieces.iter().map(|(at, _)| *at as usize).min().unwrap_or(0);
    let end = pieces.iter().map(|(at, content)| *at as usize + content.len()).max().unwrap_or(0);
    let mut flash = vec![0xFF; end - begin];
    for (at, content) in pieces {
        flash[at as usize - begin..][..content.len()].copy_from_slice(content);
    }
    Ok(flash)
}

/// What an image loads, by physical address.
fn pieces(elf: &[u8]) -> Result<Vec<(u32, &[u8])>, ImageError> {
    let header = FileHeader32::<Endianness>::parse(elf)?;
    let endian = header.endian()?;
    let mut pieces = Vec::new();
    for segment in header.program_headers(endian, elf)? {
        let content = segment.data(endian, elf).unwrap_or_default();
        if segment.p_type(endian) == PT_LOAD && !content.is_empty() {
            pieces.push((segment.p_paddr(endian), content));
        }
    }
    Ok(pieces)
}
