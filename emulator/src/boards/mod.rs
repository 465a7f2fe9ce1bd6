//! Boards: which pin of the chip leads to which device.

mod speedybee_f405_v3;

pub use speedybee_f405_v3::{MotorSignal, MotorUpdate, SpeedyBeeF405V3};
