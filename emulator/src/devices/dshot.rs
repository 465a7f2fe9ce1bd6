//! A speed controller that understands DShot.
//!
//! A frame is sixteen bits: eleven of value, one that asks for telemetry, four of checksum. A bit is a pulse that is
//! high for three quarters of the bit time (one) or for three eighths (zero); the rate is 150, 300, 600 or 1200 kbit/s.
//! The line rests low between frames. Value 0 stops, 1 to 47 are commands, 48 to 2047 are throttle.

use crate::chip::Pulse;

/// Rates that the protocol knows [bit/s].
const RATES: [f64; 4] = [150e3, 300e3, 600e3, 1200e3];
/// A rate further off than this comes from a wrong timer setting: counts of a crystal-driven timer are exact. Real
/// controllers take more, until one does not.
const RATE_TOLERANCE: f64 = 0.004;
/// Between a zero (0.375) and a one (0.75).
const THRESHOLD: f64 = 0.5625;
/// How far from its nominal share the high part of a bit may lie.
const SHARE_TOLERANCE: f64 = 0.08;
/// A line that rests for longer than this many bits has ended its frame.
const GAP_BITS: f64 = 1.5;
const BITS: u32 = 16;

/// One entry of the log of commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CommandEntry {
    /// End of its last bit (ns).
    pub ns: u64,
    /// 1..=47.
    pub command: u16,
    /// Whether the controller acted on it: it does so only while its motor stands.
    pub taken: bool,
}

/// A frame that has just ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameEnd {
    /// Start of its first bit (ns).
    pub start_ns: u64,
    /// End of its last bit (ns).
    pub end_ns: u64,
    /// Value, if the checksum was right.
    pub value: Option<u16>,
}

/// The controller of one motor.
#[derive(Clone, Debug)]
pub struct DshotEsc {
    /// How long it must see stop commands before it arms (ns).
    pub arming_ns: u64,
    /// How long it waits for a frame before it stops and disarms (ns).
    pub timeout_ns: u64,
    /// Valid frames.
    pub frames: u64,
    /// Frames with a wrong checksum, cut short or run together.
    pub bad_frames: u64,
    /// Its signal wire is torn off: nothing arrives.
    pub torn_off: bool,
    /// Rate of the last bit pair measured [bit/s]; 0 before the first.
    pub rate: f64,
    /// Commands seen, oldest first; the first thousand.
    pub commands: Vec<CommandEntry>,
    name: String,
    bits: u16,
    count: u32,
    frame_start_ns: u64,
    last_start_ns: Option<u64>,
    last_high_ns: f64,
    stop_since_ns: Option<u64>,
    last_frame_ns: Option<u64>,
    armed: bool,
    value: u16,
    told: u8,
    /// High part and length of the last two shapes of a bit that were judged (ns).
    judged: [(f64, f64); 2],
}

/// Mistakes, each told once.
const TOLD_RATE: u8 = 1;
const TOLD_SHARE: u8 = 2;
const TOLD_LONG: u8 = 4;
const TOLD_SHORT: u8 = 8;
const TOLD_CHECKSUM: u8 = 16;

const MOST_COMMANDS: usize = 1000;

impl DshotEsc {
    /// A controller at power-up; `name` is for messages.
    pub fn new(name: &str) -> Self {
        Self {
            arming_ns: 300_000_000,
            timeout_ns: 100_000_000,
            frames: 0,
            bad_frames: 0,
            torn_off: false,
            rate: 0.0,
            commands: Vec::new(),
            name: name.into(),
            bits: 0,
            count: 0,
            frame_start_ns: 0,
            last_start_ns: None,
            last_high_ns: 0.0,
            stop_since_ns: None,
            last_frame_ns: None,
            armed: false,
            value: 0,
            told: 0,
            judged: [(f64::NAN, f64::NAN); 2],
        }
    }

    /// Whether it would spin its motor at `ns`.
    pub fn armed(&self, ns: u64) -> bool {
        self.armed && self.alive(ns)
    }

    /// Throttle 0..=1 at `ns`, or none while it is not armed. An armed motor that is told to stop has 0.
    pub fn throttle(&self, ns: u64) -> Option<f64> {
        self.armed(ns).then(|| throttle_of(self.value))
    }

    /// End of the last bit of the last valid frame (ns).
    pub fn last_frame_ns(&self) -> Option<u64> {
        self.last_frame_ns
    }

    /// The value of the last valid frame.
    pub fn value(&self) -> u16 {
        self.value
    }

    /// A pulse on the line. The answer is the frame that it completes.
    pub fn pulse(&mut self, pulse: Pulse, bugs: &mut Vec<String>) -> Option<FrameEnd> {
        if self.torn_off {
            return None;
        }
        if pulse.cut {
            // Whoever stops the timer in a frame means to; what there is of the frame is void.
            self.bad_frames += u64::from(self.count != BITS);
            (self.count, self.last_start_ns) = (0, None);
            return None;
        }
        let period = pulse.period_ns.max(1.0);
        let gap = self.last_start_ns.map(|last| pulse.start_ns.saturating_sub(last) as f64);
        let follows = gap.is_some_and(|gap| gap < GAP_BITS * period);
        if !follows {
            if self.count != 0 && self.count != BITS {
                self.bad_frames += 1;
                let text = format!("{}: a DShot frame ends after {} bits", self.name, self.count);
                self.tell(TOLD_SHORT, text, bugs);
            }
            (self.bits, self.count, self.frame_start_ns) = (0, 0, pulse.start_ns);
        }
        self.last_start_ns = Some(pulse.start_ns);
        self.last_high_ns = pulse.high_ns;
        if self.count >= BITS {
            if self.count == BITS {
                self.bad_frames += 1;
                let text = format!("{}: a DShot frame goes on after its sixteenth bit", self.name);
                self.tell(TOLD_LONG, text, bugs);
            }
            self.count = BITS + 1;
            return None;
        }
        self.measure(&pulse, bugs);
        self.bits = self.bits << 1 | u16::from(pulse.high_ns / period > THRESHOLD);
        self.count += 1;
        if self.count < BITS {
            return None;
        }
        let end_ns = pulse.start_ns + pulse.period_ns as u64;
        let value = self.complete(end_ns, bugs);
        Some(FrameEnd { start_ns: self.frame_start_ns, end_ns, value })
    }

    fn alive(&self, ns: u64) -> bool {
        self.last_frame_ns.is_some_and(|last| ns.saturating_sub(last) <= self.timeout_ns)
    }

    /// Judges the rate and the shape of a bit.
    fn measure(&mut self, pulse: &Pulse, bugs: &mut Vec<String>) {
        // Most bits have the shape of one before: nothing new can be said of them.
        let shape = (pulse.high_ns, pulse.period_ns);
        if self.judged.contains(&shape) {
            self.rate = 1e9 / pulse.period_ns.max(1.0);
            return;
        }
        self.judged = [shape, self.judged[0]];
        self.rate = 1e9 / pulse.period_ns.max(1.0);
        let off = RATES.iter().map(|rate| (self.rate / rate - 1.0).abs()).fold(f64::MAX, f64::min);
        if off > RATE_TOLERANCE {
            let text = format!(
                "{}: DShot bits come at {:.1} kbit/s, which is no rate of DShot",
                self.name,
                self.rate / 1e3
            );
            self.tell(TOLD_RATE, text, bugs);
        }
        let share = pulse.high_ns / pulse.period_ns.max(1.0);
        let nominal = if share > THRESHOLD { 0.75 } else { 0.375 };
        if (share - nominal).abs() > SHARE_TOLERANCE {
            let text = format!("{}: a DShot bit is high for {:.0} % of its time", self.name, share * 100.0);
            self.tell(TOLD_SHARE, text, bugs);
        }
    }

    /// Takes in a frame of sixteen bits.
    fn complete(&mut self, ns: u64, bugs: &mut Vec<String>) -> Option<u16> {
        let payload = self.bits >> 4;
        let checksum = (payload ^ payload >> 4 ^ payload >> 8) & 0xF;
        if checksum != self.bits & 0xF {
            self.bad_frames += 1;
            let text = format!("{}: a DShot frame has a wrong checksum", self.name);
            self.tell(TOLD_CHECKSUM, text, bugs);
            return None;
        }
        let value = payload >> 1;
        if !self.alive(ns) {
            (self.armed, self.stop_since_ns, self.value) = (false, None, 0);
        }
        self.frames += 1;
        self.last_frame_ns = Some(ns);
        match value {
            1..=47 => {
                let taken = throttle_of(self.value) == 0.0;
                if self.commands.len() < MOST_COMMANDS {
                    self.commands.push(CommandEntry { ns, command: value, taken });
                }
            }
            _ => {
                self.value = value;
                if value == 0 {
                    let since = *self.stop_since_ns.get_or_insert(ns);
                    self.armed |= ns - since >= self.arming_ns;
                } else {
                    self.stop_since_ns = None;
                }
            }
        }
        Some(value)
    }

    fn tell(&mut self, what: u8, text: String, bugs: &mut Vec<String>) {
        if self.told & what == 0 {
            self.told |= what;
            bugs.push(text);
        }
    }
}

/// Throttle 0..=1 of a value.
fn throttle_of(value: u16) -> f64 {
    if value < 48 { 0.0 } else { f64::from(value - 47) / 2000.0 }
}

#[cfg(test)]
mod tests {
    use super::DshotEsc;
    use crate::chip::Pulse;

    /// Sends one frame; answers its end.
    fn send(esc: &mut DshotEsc, at_ns: u64, value: u16, bit_ns: f64, bugs: &mut Vec<String>) -> u64 {
        let payload = value << 1;
        let frame = payload << 4 | (payload ^ payload >> 4 ^ payload >> 8) & 0xF;
        let mut end = 0;
        for bit in 0..16 {
            let start_ns = at_ns + (f64::from(bit) * bit_ns) as u64;
            let share = if frame >> (15 - bit) & 1 == 1 { 0.75 } else { 0.375 };
            let pulse = Pulse { start_ns, high_ns: share * bit_ns, period_ns: bit_ns, cut: false };
            if let Some(done) = esc.pulse(pulse, bugs) {
                end = done.end_ns;
            }
        }
        end
    }

    const BIT_NS: f64 = 1e9 / 600e3;

    #[test]
    fn it_arms_after_zeros_and_disarms_without_signal() {
        let mut esc = DshotEsc::new("motor 1");
        let mut bugs = Vec::new();
        for tick in 0..240 {
            send(&mut esc, tick * 1_250_000, 0, BIT_NS, &mut bugs);
        }
        assert!(!esc.armed(300_000_000));
        send(&mut esc, 240 * 1_250_000, 0, BIT_NS, &mut bugs);
        let end = send(&mut esc, 241 * 1_250_000, 2047, BIT_NS, &mut bugs);
        assert_eq!(esc.throttle(end), Some(1.0));
        assert_eq!(end - 241 * 1_250_000, 26_666);
        send(&mut esc, 242 * 1_250_000, 7, BIT_NS, &mut bugs);
        assert!(!esc.commands[0].taken);
        assert_eq!(esc.throttle(end + 103_000_000), None);
        send(&mut esc, end + 200_000_000, 1000, BIT_NS, &mut bugs);
        assert_eq!(esc.throttle(end + 200_100_000), None);
        assert!(bugs.is_empty(), "{bugs:?}");
    }

    #[test]
    fn a_rate_off_by_one_count_is_told() {
        for (counts, wrong) in [(140.0, false), (141.0, true), (139.0, true), (147.0, true)] {
            let (mut esc, mut bugs) = (DshotEsc::new("motor 1"), Vec::new());
            send(&mut esc, 0, 100, counts * 1e3 / 84.0, &mut bugs);
            assert_eq!(!bugs.is_empty(), wrong, "{counts}: {bugs:?}");
        }
    }
}
