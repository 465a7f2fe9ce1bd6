//! What the firmware says through a debug probe, decoded.

/// Lines, in order.
pub(crate) struct Log(pub(crate) Vec<String>);

impl Log {
    /// Whether a line contains this.
    pub(crate) fn says(&self, text: &str) -> bool {
        self.0.iter().any(|line| line.contains(text))
    }

    /// Causes of the resets before each start.
    pub(crate) fn reset_causes(&self) -> Vec<&str> {
        self.after(", reset by ")
    }

    /// Kinds of the crashes reported at each start.
    pub(crate) fn crashes(&self) -> Vec<&str> {
        // The crash prints as a structure whose first field is its kind.
        self.after("the last run crashed: ")
            .into_iter()
            .map(|crash| {
                let kind = crash.split_once("kind: ").map_or(crash, |(_, rest)| rest);
                kind.split([',', ' ', '(', '}']).next().unwrap_or(kind)
            })
            .collect()
    }

    fn after(&self, text: &str) -> Vec<&str> {
        self.0.iter().filter_map(|line| Some(line.split_once(text)?.1.trim())).collect()
    }
}
