//! Boards: which pin of the chip leads to which device.
