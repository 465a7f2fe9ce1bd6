//! The one vehicle of this board, and where it lies.

use static_cell::ConstStaticCell;

/// Stands in for the flight logic.
pub(super) struct Vehicle<const RECORD: usize> {
    ticks: u32,
}
pub(super) struct TickInput {
    pub(super) now_us: u64,
    pub(super) imu: Option<()>,
    pub(super) battery_v: Option<f32>,
    pub(super) kill: bool,
}
impl<const RECORD: usize> Vehicle<RECORD> {
    const fn new() -> Self {
        Self { ticks: 0 }
    }
    pub(super) fn receive(&mut self, _bytes: &[u8]) {}
    pub(super) fn tick(&mut self, input: &TickInput) -> u32 {
        let _ = (input.now_us, input.imu, input.battery_v, input.kill);
        self.ticks = self.ticks.wrapping_add(1);
        self.ticks
    }
    pub(super) fn transmit(&mut self, _out: &mut [u8]) -> usize {
        0
    }
}

/// Entries of the flight record.
const RECORD: usize = 3200;

static VEHICLE: ConstStaticCell<Vehicle<RECORD>> = ConstStaticCell::new(Vehicle::new());

/// Hands out the vehicle, once.
pub(super) fn take() -> &'static mut Vehicle<RECORD> {
    VEHICLE.take()
}
