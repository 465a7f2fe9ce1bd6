//! solver

pub mod solver;
