//! The configuration file that the BMI270 must be given before it measures (data sheet section 4.4).

use super::{Bmi270, CONFIG_BYTES, Defect, TOLD_UPLOAD, Upload, registers as reg};

/// From INIT_CTRL = 1 to INTERNAL_STATUS = 1 (ns) (data sheet section 4.4: at most 20 ms).
const INIT_NS: u64 = 20_000_000;
/// FNV-1a hash (64 bits) of the configuration file that Bosch hands out for the chip (`bmi270_config_file` of its driver):
/// the chip runs it and checks it, so that anything else, or the same bytes at other addresses, fails.
const CONFIG_HASH: u64 = 0xA3AB_E71B_91DB_4895;

impl Bmi270 {
    /// INIT_CTRL: 0 opens the configuration memory, 1 closes it and starts the self-check.
    pub(super) fn write_init_ctrl(&mut self, ns: u64, byte: u8, bugs: &mut Vec<String>) {
        let old = std::mem::replace(&mut self.registers[reg::INIT_CTRL], byte);
        if byte & 1 == 0 {
            self.config_bytes = 0;
            return;
        }
        if old & 1 != 0 {
            return;
        }
        let hash = self.config.iter().fold(0xCBF2_9CE4_8422_2325_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3)
        });
        self.uploaded = Some(Upload { bytes: self.config_bytes, hash });
        let complete = self.config_bytes == CONFIG_BYTES;
        let passes = complete && hash == CONFIG_HASH && !self.power_save();
        if !complete {
            let text = format!(
                "BMI270: {} bytes of configuration are loaded instead of {CONFIG_BYTES}",
                self.config_bytes
            );
            self.tell(TOLD_UPLOAD, text, bugs);
        } else if !passes {
            let why = if self.power_save() {
                "was loaded in advanced power save"
            } else {
                "is not the maker's, or does not lie where it belongs (INIT_ADDR)"
            };
            self.tell(TOLD_UPLOAD, format!("BMI270: the configuration {why}"), bugs);
        }
        self.init_due = Some((ns + INIT_NS, passes && self.defect != Some(Defect::Configuration)));
    }

    /// Where INIT_ADDR points: it counts words of two bytes.
    pub(super) fn init_place(&self) -> usize {
        let word = usize::from(self.registers[reg::INIT_ADDR_0] & 0xF)
            | usize::from(self.registers[reg::INIT_ADDR_1]) << 4;
        2 * word
    }

    /// Bytes of this transaction that went before.
    pub(super) fn config_bytes_of_burst(&self) -> usize {
        self.position as usize - 2
    }
}
