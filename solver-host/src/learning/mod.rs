//! Learning from flight to flight: what the end of one flight corrects in the table of the next.
//!
//! ```text
//! identify ─→ plan: solve with the true thrust, rehearse on the model ─→ table
//!                                                                          │
//!    ┌──────────────────── campaign ────────────────────────────────────────┤
//!    │  fly ─→ observation: start and end as the cameras saw them           │
//!    │           └─→ correction: J⁺ of the model, damped, weighed ─→ table ─┘
//!    └─→ history, best table
//! ```
//!
//! The theory is in `docs/learning.md`.

mod campaign;
mod correction;
mod history;
mod model;
mod observation;
mod parameters;
mod plain;
mod plan;
mod simulated;
mod statistics;

pub use campaign::{Budget, FlightFailure, Flown, Flyer, LEARNED, Learned, Observer, StopReason, learn};
pub use correction::{Correction, CorrectionError, TRUST, correct, weights};
pub use history::{
    ANGLE_TOLERANCE_RAD, Across, FlightEntry, HISTORY_FILE, History, HistoryError, IdentifiedResponse,
    POSITION_TOLERANCE_M, StateError, TABLE_FILE, VELOCITY_TOLERANCE_MPS, check_folder, keep_old,
};
pub use model::Response;
pub use observation::{Eyes, ObservationError, Observed, Seen, effect_of_start, observe};
pub use parameters::{HEADING_MAX_RAD, MAX_PARAMETERS, Parameters};
pub use plain::{Rule, RuleResult, learn_plainly};
pub use plan::{LearningPlan, PlanError, THRUST_SHARE, Target, plan};
pub use simulated::{IdentifyError, SimulatedFlyer, SimulatedVehicle, Unseen, hop_plan};
pub use statistics::{
    Case, DURATION_MAX, MANEUVERS, StatisticsPlan, THRUST_ERROR, airframe, statistics, strength, target,
};
