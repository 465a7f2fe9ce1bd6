//! Addresses and reset values of the BMI270 (data sheet section 5.2).

pub(super) const CHIP_ID: usize = 0x00;
pub(super) const ERR_REG: usize = 0x02;
pub(super) const STATUS: usize = 0x03;
pub(super) const DATA_FIRST: usize = 0x0C;
pub(super) const GYRO_FIRST: usize = 0x12;
pub(super) const DATA_LAST: usize = 0x17;
pub(super) const SENSORTIME_0: usize = 0x18;
pub(super) const SENSORTIME_2: usize = 0x1A;
pub(super) const EVENT: usize = 0x1B;
pub(super) const INT_STATUS_0: usize = 0x1C;
pub(super) const INT_STATUS_1: usize = 0x1D;
pub(super) const INTERNAL_STATUS: usize = 0x21;
pub(super) const TEMPERATURE_0: usize = 0x22;
pub(super) const FIFO_DATA: usize = 0x26;
pub(super) const GYR_CAS: usize = 0x3C;
pub(super) const ACC_CONF: usize = 0x40;
pub(super) const ACC_RANGE: usize = 0x41;
pub(super) const GYR_CONF: usize = 0x42;
pub(super) const GYR_RANGE: usize = 0x43;
pub(super) const INT1_IO_CTRL: usize = 0x53;
pub(super) const INT_LATCH: usize = 0x55;
pub(super) const INT_MAP_DATA: usize = 0x58;
pub(super) const INIT_CTRL: usize = 0x59;
pub(super) const INIT_ADDR_0: usize = 0x5B;
pub(super) const INIT_ADDR_1: usize = 0x5C;
pub(super) const INIT_DATA: usize = 0x5E;
pub(super) const NVM_CONF: usize = 0x6A;
pub(super) const PWR_CONF: usize = 0x7C;
pub(super) const PWR_CTRL: usize = 0x7D;
pub(super) const CMD: usize = 0x7E;

pub(super) const CMD_SOFT_RESET: u8 = 0xB6;
pub(super) const CMD_NVM_PROG: u8 = 0xA0;

/// Values after power-up.
pub(super) const RESET: [u8; 128] = {
    let mut values = [0; 128];
    values[0x00] = 0x24;
    values[STATUS] = 0x10;
    values[EVENT] = 0x01;
    // 8000 hexadecimal: no temperature yet.
    values[TEMPERATURE_0 + 1] = 0x80;
    values[ACC_CONF] = 0xA8;
    values[ACC_RANGE] = 0x02;
    values[GYR_CONF] = 0xA9;
    values[0x44] = 0x0F;
    values[0x46] = 0x01;
    values[0x48] = 0x02;
    values[0x49] = 0x10;
    values[PWR_CONF] = 0x03;
    values
};
