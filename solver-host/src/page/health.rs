//! What should not happen in a flight, counted.

use mintime_shared::messages::record_flags;
use serde::Serialize;

use crate::mission::Flown;

/// How often something happened that should not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Counter {
    /// What.
    pub label: &'static str,
    /// How often.
    pub count: u64,
    /// Of how many; 0 where that says nothing.
    pub of: u64,
}

/// Everything that was counted; empty for a flight that brought nothing back.
pub(super) fn counters(flown: &Flown) -> Vec<Counter> {
    let mut counters = Vec::new();
    if let Ok(result) = &flown.flight {
        let ticks = u64::from(result.ticks);
        let recorded = result.record.len() as u64;
        let flagged = |flag| result.record.iter().filter(|t| t.flags & flag != 0).count() as u64;
        let unseen = result.record.iter().filter(|t| t.gyro_radps.is_none()).count() as u64;
        counters.extend([
            Counter { label: "control ticks missed", count: u64::from(result.missed_ticks), of: ticks },
            Counter { label: "control ticks late", count: flagged(record_flags::LATE), of: recorded },
            Counter { label: "gyro samples missing", count: unseen, of: recorded },
            Counter {
                label: "ticks with a rotor at its limit",
                count: flagged(record_flags::SATURATED),
                of: recorded,
            },
            Counter {
                label: "ticks that did not fit the record",
                count: ticks.saturating_sub(recorded),
                of: ticks,
            },
        ]);
        counters.extend(result.board.iter().flat_map(|board| {
            [
                Counter { label: "errors of the gyro's bus", count: u64::from(board.gyro_errors), of: 0 },
                Counter {
                    label: "errors of the motors' outputs",
                    count: u64::from(board.motor_errors),
                    of: 0,
                },
            ]
        }));
    }
    counters.extend(flown.emulated.iter().map(|e| Counter {
        label: "mistakes of the firmware that the emulator saw",
        count: e.board.bugs.len() as u64,
        of: 0,
    }));
    counters
}
