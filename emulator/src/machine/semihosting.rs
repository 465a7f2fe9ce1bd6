//! Semihosting (Arm's "Semihosting for AArch32 and AArch64", version 3.0): output, exit and clock; no files.
use crate::{Machine, bus::Peripherals};

const SYS_OPEN: u32 = 0x01;
const SYS_CLOSE: u32 = 0x02;
const SYS_WRITEC: u32 = 0x03;
const SYS_WRITE0: u32 = 0x04;
const SYS_WRITE: u32 = 0x05;
const SYS_READ: u32 = 0x06;
const SYS_READC: u32 = 0x07;
const SYS_ISERROR: u32 = 0x08;
const SYS_ISTTY: u32 = 0x09;
const SYS_FLEN: u32 = 0x0C;
const SYS_CLOCK: u32 = 0x10;
const SYS_TIME: u32 = 0x11;
const SYS_ERRNO: u32 = 0x13;
const SYS_EXIT: u32 = 0x18;
const SYS_EXIT_EXTENDED: u32 = 0x20;
const SYS_ELAPSED: u32 = 0x30;
const SYS_TICKFREQ: u32 = 0x31;
/// ADP_Stopped_ApplicationExit.
const APPLICATION_EXIT: u32 = 0x2_0026;
/// Handle of `:tt`, for reading and writing alike.
const TERMINAL: u32 = 1;
const FAILED: u32 = u32::MAX;
/// No such file.
const ENOENT: u32 = 2;

impl<P: Peripherals> Machine<P> {
    /// Serves the request at BKPT 0xAB; `Some` exit code where the program ends.
    pub(super) fn semihost(&mut self) -> Option<i32> {
        let (operation, argument) = (self.core.r[0], self.core.r[1]);
        self.core.pc = self.core.pc.wrapping_add(2);
        let word = |n: u32| {
            let bytes = self.memory.peek(argument.wrapping_add(4 * n), 4)?;
            Some(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
        };
        let code = |reason, status| if reason == APPLICATION_EXIT { status } else { 1 };
        self.core.r[0] = match operation {
            SYS_EXIT => return Some(code(argument, 0)),
            SYS_EXIT_EXTENDED => {
                return Some(code(word(0).unwrap_or(0), word(1).unwrap_or(1).cast_signed()));
            }
            SYS_WRITEC => {
                let byte = self.memory.peek(argument, 1).map_or(b'?', |bytes| bytes[0]);
                self.output.push(byte);
                operation
            }
            SYS_WRITE0 => {
                let mut at = argument;
                while let Some(&[byte]) = self.memory.peek(at, 1)
                    && byte != 0
                {
                    self.output.push(byte);
                    at = at.wrapping_add(1);
                }
                operation
            }
            SYS_WRITE => match (word(1), word(2)) {
                (Some(start), Some(length)) => match self.memory.peek(start, length) {
                    Some(bytes) => {
                        self.output.extend_from_slice(bytes);
                        0
                    }
                    None => length,
                },
                _ => FAILED,
            },
            SYS_OPEN => {
                let name = word(0).and_then(|name| self.memory.peek(name, 3));
                if name.is_some_and(|name| name == b":tt") { TERMINAL } else { FAILED }
            }
            SYS_CLOSE | SYS_FLEN => 0,
            // Nothing to read: the whole buffer stays unfilled.
            SYS_READ => word(2).unwrap_or(0),
            SYS_READC => 0,
            SYS_ISERROR => u32::from(word(0).is_some_and(|status| status.cast_signed() < 0)),
            SYS_ISTTY => 1,
            SYS_CLOCK => (self.core.cycle / (self.clock_hz / 100).max(1)) as u32,
            SYS_TIME => (self.core.cycle / self.clock_hz.max(1)) as u32,
            SYS_ERRNO => ENOENT,
            SYS_ELAPSED => {
                let ticks = self.core.cycle.to_le_bytes();
                if self.memory.place(argument, &ticks).is_some() { 0 } else { FAILED }
            }
            SYS_TICKFREQ => self.clock_hz as u32,
            _ => FAILED,
        };
        None
    }
}
