//! Devices on a board, outside the chip.
