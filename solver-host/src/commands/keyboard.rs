//! Any key stops: the terminal hands over each key at once for as long as a [`Keyboard`] lives.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Watches the terminal, and puts it back when it is dropped, on whatever way out.
pub(crate) struct Keyboard {
    #[cfg(unix)]
    terminal: Option<(std::fs::File, rustix::termios::Termios)>,
}

impl Keyboard {
    /// Sets `stop` at any key and at Ctrl-C. Where there is no terminal only Ctrl-C and a signal to end are left.
    pub(crate) fn watch(stop: &Arc<AtomicBool>) -> Result<Self, ctrlc::Error> {
        let at_signal = Arc::clone(stop);
        ctrlc::set_handler(move || at_signal.store(true, Ordering::Relaxed))?;
        Ok(Self::listen(stop))
    }

    #[cfg(unix)]
    fn listen(stop: &Arc<AtomicBool>) -> Self {
        use std::io::Read as _;

        use rustix::termios::{LocalModes, OptionalActions, tcgetattr, tcsetattr};

        // Not standard input: poses may come from there.
        let Ok(tty) = std::fs::File::open("/dev/tty") else { return Self { terminal: None } };
        let Ok(before) = tcgetattr(&tty) else { return Self { terminal: None } };
        let mut keys = before.clone();
        // Signals stay on: Ctrl-C is one.
        keys.local_modes.remove(LocalModes::ICANON | LocalModes::ECHO);
        let Ok(mut reader) = tty.try_clone() else { return Self { terminal: None } };
        if tcsetattr(&tty, OptionalActions::Flush, &keys).is_err() {
            return Self { terminal: None };
        }
        let stop = Arc::clone(stop);
        std::thread::spawn(move || {
            let mut key = [0];
            if reader.read(&mut key).is_ok_and(|count| count > 0) {
                stop.store(true, Ordering::Relaxed);
            }
        });
        Self { terminal: Some((tty, before)) }
    }

    #[cfg(not(unix))]
    fn listen(_: &Arc<AtomicBool>) -> Self {
        Self {}
    }

    /// Whether keys are heard.
    pub(crate) fn hears(&self) -> bool {
        #[cfg(unix)]
        return self.terminal.is_some();
        #[cfg(not(unix))]
        false
    }
}

#[cfg(unix)]
impl Drop for Keyboard {
    fn drop(&mut self) {
        if let Some((tty, before)) = &self.terminal {
            // There is nobody left to tell.
            let _ = rustix::termios::tcsetattr(tty, rustix::termios::OptionalActions::Now, before);
        }
    }
}
