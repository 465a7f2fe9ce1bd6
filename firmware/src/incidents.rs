//! What a person must have read of before the motors turn again: incidents, the oldest first.

use heapless::Deque;
use mintime_shared::messages::{Incident, IncidentCause};

use crate::config::INCIDENTS;

/// Incidents that wait to be acknowledged. Where there are too many the oldest stay, for the first tells what began it, and
/// the newest takes the last one's place; but nothing displaces the one by which the supervisor stopped the motors, for only
/// its acknowledgement leads on.
#[derive(Debug, Default)]
pub(crate) struct Incidents {
    waiting: Deque<Incident, INCIDENTS>,
    /// Number before the first of this run.
    before: u16,
    /// Number of the latest, or [`Self::before`].
    latest: u16,
    /// Number of the latest that says that the supervisor stopped the motors for good; 0 for none.
    terminated: u16,
}

impl Incidents {
    pub(crate) const fn new() -> Self {
        Self { waiting: Deque::new(), before: 0, latest: 0, terminated: 0 }
    }

    /// Begins the numbers at a place of this run's own, so that an acknowledgement meant for an incident of an earlier run
    /// meets none of this one. Before the first.
    pub(crate) fn number_after(&mut self, session: u32) {
        // Half of them are left to count with.
        self.before = session as u16 >> 1;
        self.latest = self.before;
    }

    /// Adds one and returns its number. Numbers grow by one, and go on with 1 after 65535.
    pub(crate) fn push(&mut self, cause: IncidentCause) -> u16 {
        let stopped_by = self.terminated;
        self.latest = self.latest.checked_add(1).unwrap_or_else(|| {
            self.before = 0;
            1
        });
        let terminates = matches!(cause, IncidentCause::Terminated(_));
        if terminates {
            self.terminated = self.latest;
        }
        let holds = self.waiting.back().is_some_and(|last| last.number == stopped_by);
        if self.waiting.is_full() && (terminates || !holds) {
            self.waiting.pop_back();
        }
        let _ = self.waiting.push_back(Incident { number: self.latest, cause });
        self.latest
    }

    /// The one that is told, and that can be acknowledged.
    pub(crate) fn oldest(&self) -> Option<Incident> {
        self.waiting.front().copied()
    }

    /// All that wait, the oldest first.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Incident> {
        self.waiting.iter()
    }

    /// Whether it is the latest by which the supervisor stopped the motors.
    pub(crate) fn is_termination(&self, number: u16) -> bool {
        number == self.terminated
    }

    /// Whether an incident of this number was there and waits no more.
    pub(crate) fn is_over(&self, number: u16) -> bool {
        number > self.before && self.oldest().map_or(number <= self.latest, |oldest| number < oldest.number)
    }

    /// Takes the oldest out if it has this number, and tells whether it had.
    pub(crate) fn acknowledge(&mut self, number: u16) -> bool {
        let oldest = self.waiting.front().is_some_and(|oldest| oldest.number == number);
        if oldest {
            self.waiting.pop_front();
        }
        oldest
    }
}

#[cfg(test)]
mod tests {
    use heapless::Vec;
    use mintime_shared::messages::AbortReason;

    use super::*;

    fn numbers(incidents: &Incidents) -> Vec<u16, INCIDENTS> {
        incidents.iter().map(|incident| incident.number).collect()
    }

    #[test]
    fn the_oldest_waits_until_it_is_named() {
        let mut incidents = Incidents::new();
        assert!(!incidents.is_over(0) && !incidents.is_over(1));
        incidents.push(IncidentCause::Watchdog);
        incidents.push(IncidentCause::StoreDamaged);
        assert!(!incidents.acknowledge(2), "its turn has not come");
        assert_eq!(incidents.oldest(), Some(Incident { number: 1, cause: IncidentCause::Watchdog }));
        assert!(incidents.acknowledge(1));
        assert!(!incidents.acknowledge(1));
        assert_eq!(numbers(&incidents), [2]);
        assert!(incidents.is_over(1) && !incidents.is_over(2));
        assert!(incidents.acknowledge(2));
        assert!(incidents.is_over(2) && !incidents.is_over(3) && !incidents.is_over(0));
        assert_eq!(incidents.oldest(), None);
    }

    /// A termination always finds room, and keeps it.
    #[test]
    fn where_there_are_too_many_the_oldest_and_the_newest_stay() {
        let mut incidents = Incidents::new();
        for line in 1..=9 {
            incidents.push(IncidentCause::Panic(line));
        }
        assert_eq!(numbers(&incidents), [1, 2, 3, 4, 5, 9]);
        incidents.push(IncidentCause::Terminated(AbortReason::KillSwitch));
        assert_eq!(numbers(&incidents), [1, 2, 3, 4, 5, 10]);
        assert!(incidents.is_termination(10) && !incidents.is_termination(9) && !incidents.is_termination(0));
        incidents.push(IncidentCause::Watchdog);
        assert_eq!(numbers(&incidents), [1, 2, 3, 4, 5, 10]);
        incidents.push(IncidentCause::Terminated(AbortReason::EmergencyStop));
        assert_eq!(numbers(&incidents), [1, 2, 3, 4, 5, 12]);
        for number in 1..=5 {
            assert!(incidents.acknowledge(number));
        }
        assert!(incidents.is_over(7), "what was left out waits no more");
        assert!(incidents.acknowledge(12));
    }

    /// A host that repeats an acknowledgement over a reset acknowledges nothing.
    #[test]
    fn numbers_of_another_run_are_nobodys() {
        let mut incidents = Incidents::new();
        incidents.number_after(0xABCD_8642);
        assert!(!incidents.is_over(0x4321) && !incidents.is_over(1));
        assert_eq!(incidents.push(IncidentCause::Watchdog), 0x4322);
        assert!(!incidents.is_over(1) && !incidents.acknowledge(1));
        assert!(incidents.acknowledge(0x4322));
        assert!(incidents.is_over(0x4322) && !incidents.is_over(0x4321) && !incidents.is_over(0x4323));
        incidents.number_after(u32::MAX);
        assert_eq!(incidents.push(IncidentCause::Watchdog), 0x8000);
    }

    #[test]
    fn zero_is_nobodys_number() {
        let mut incidents = Incidents::new();
        incidents.number_after(1000);
        incidents.latest = u16::MAX;
        incidents.push(IncidentCause::Watchdog);
        assert_eq!(numbers(&incidents), [1]);
        // Numbers that have gone round are this run's own all the same.
        assert!(incidents.acknowledge(1) && incidents.is_over(1));
    }
}
