//! `mintime virtual-board`: the emulated flight controller behind a pseudo-terminal, paced in real time.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

/// Arguments of `mintime virtual-board`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime virtual-board\n  mintime virtual-board --link /tmp/vehicle --seconds 60"
)]
pub(crate) struct VirtualBoard {
    /// The image to run; built from the sources if not given
    #[arg(long, value_name = "FILE.elf")]
    firmware: Option<PathBuf>,
    /// The simulated airframe: `ideal`, `nominal`, or a TOML file (see docs/vehicles.md)
    #[arg(long, value_name = "ideal|nominal|FILE.toml", default_value = "nominal")]
    plant: String,
    /// Seed of everything random in the simulation
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Also make the serial port known under this name (a symbolic link, removed at the end)
    #[arg(long, value_name = "PATH")]
    link: Option<PathBuf>,
    /// End after this much time, s; without it, at Ctrl-C
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    seconds: Option<f64>,
}

impl VirtualBoard {
    pub(crate) fn run(self) -> ExitCode {
        match self.serve() {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            }
        }
    }

    #[cfg(not(unix))]
    fn serve(&self) -> Result<(), Box<dyn Error>> {
        Err("this system has no pseudo-terminals: use Linux or macOS, or `mintime fly`".into())
    }

    #[cfg(unix)]
    fn serve(&self) -> Result<(), Box<dyn Error>> {
        use std::sync::Arc;
        use std::sync::atomic::{AtomicBool, Ordering};
        use std::time::{Duration, Instant};

        use emulator::core::Timing;
        use mintime::flight::{Connection as _, Scene, VirtualVehicle};
        use mintime::mission::PlantChoice;

        /// Virtual time runs in steps of this, ns.
        const STEP_NS: u64 = 2_000_000;
        /// A computer that falls behind by more lets virtual time fall behind, ns.
        const MOST_BEHIND: Duration = Duration::from_millis(200);

        if self.seconds.is_some_and(|s| !(s > 0.0 && s < 1e7)) {
            return Err("--seconds must be a positive number of seconds below 10,000,000".into());
        }
        // What can be refused is refused before anything is built.
        let port = terminal::Port::open(self.link.as_deref())?;
        let progress = super::progress::Progress::new();
        let image = super::fly::firmware(self.firmware.as_deref(), &progress);
        progress.finish();
        let image = image?;
        let plant = PlantChoice::from_argument(&self.plant)?;
        let scene = Scene {
            parameters: &plant.parameters,
            seed: self.seed,
            ground_z_m: 0.0,
            heading_rad: 0.0,
            maneuver_s: 0.0,
        };
        let mut vehicle = VirtualVehicle::new(&scene, image.elf(), Timing::Pessimistic)?;
        super::print(&format!("serial port {}", port.path().display()));
        eprintln!("mintime: 921600 baud in effect whatever is set; Ctrl-C ends");

        let stopped = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&stopped);
        // So that the symbolic link is removed then, too.
        ctrlc::set_handler(move || stop.store(true, Ordering::Relaxed))?;
        let end_ns = self.seconds.map(|s| (s * 1e9) as u64);
        let mut started = Instant::now();
        let mut bytes = Vec::new();
        let mut now_ns = 0;
        while !stopped.load(Ordering::Relaxed) && end_ns.is_none_or(|end| now_ns < end) {
            now_ns += STEP_NS;
            vehicle.send(&port.read()?)?;
            vehicle.advance_to(now_ns)?;
            bytes.clear();
            vehicle.receive(&mut bytes)?;
            port.write(&bytes)?;
            for (ns, line) in vehicle.take_log() {
                eprintln!("{:10.3} s  {line}", ns as f64 * 1e-9);
            }
            let due = started + Duration::from_nanos(now_ns);
            let now = Instant::now();
            if let Some(wait) = due.checked_duration_since(now) {
                std::thread::sleep(wait);
            } else if now - due > MOST_BEHIND {
                started += now - due;
            }
        }
        Ok(())
    }
}

#[cfg(unix)]
mod terminal {
    //! A pseudo-terminal whose other end looks like a serial port.

    use std::cell::Cell;
    use std::fs::File;
    use std::io::{ErrorKind, Read as _, Write as _};
    use std::os::unix::ffi::OsStrExt as _;
    use std::path::{Path, PathBuf};

    use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl, open};
    use rustix::io::Errno;
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{OptionalActions, QueueSelector, tcflush, tcgetattr, tcsetattr};

    /// The end of this command. The other one is opened by whoever talks to the vehicle.
    pub(super) struct Port {
        master: File,
        path: PathBuf,
        link: Option<PathBuf>,
        /// Somebody has the other end open.
        attended: Cell<bool>,
    }

    impl Port {
        pub(super) fn open(link: Option<&Path>) -> Result<Self, String> {
            let no_terminal = |e: Errno| format!("no pseudo-terminal can be had: {e}");
            let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).map_err(no_terminal)?;
            grantpt(&master).map_err(no_terminal)?;
            unlockpt(&master).map_err(no_terminal)?;
            let name = ptsname(&master, Vec::new()).map_err(no_terminal)?;
            let path = PathBuf::from(std::ffi::OsStr::from_bytes(name.as_bytes()));
            let flags = fcntl_getfl(&master).map_err(no_terminal)?;
            fcntl_setfl(&master, flags | OFlags::NONBLOCK).map_err(no_terminal)?;
            clear(&path).map_err(|e| format!("{} cannot be set up: {e}", path.display()))?;
            if let Some(link) = link {
                point(link, &path)?;
            }
            let link = link.map(Path::to_owned);
            Ok(Self { master: File::from(master), path, link, attended: Cell::new(false) })
        }

        pub(super) fn path(&self) -> &Path {
            self.link.as_deref().unwrap_or(&self.path)
        }

        /// What has arrived.
        pub(super) fn read(&self) -> std::io::Result<Vec<u8>> {
            let mut bytes = vec![0; 4096];
            let count = match (&self.master).read(&mut bytes) {
                Ok(0) => None,
                // The other end is closed.
                Err(e) if e.raw_os_error() == Some(Errno::IO.raw_os_error()) => None,
                Err(e) if matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => Some(0),
                other => Some(other?),
            };
            bytes.truncate(count.unwrap_or(0));
            if self.attended.replace(count.is_some()) && count.is_none() {
                // Whoever comes next shall not read what was meant for the one before.
                clear(&self.path)?;
            }
            Ok(bytes)
        }

        /// As on a wire, what nobody reads is lost.
        pub(super) fn write(&self, bytes: &[u8]) -> std::io::Result<()> {
            if !self.attended.get() {
                return Ok(());
            }
            let lost = |e: &std::io::Error| {
                matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted)
                    || e.raw_os_error() == Some(Errno::IO.raw_os_error())
            };
            match (&self.master).write(bytes) {
                Err(e) if !lost(&e) => Err(e),
                _ => Ok(()),
            }
        }
    }

    impl Drop for Port {
        fn drop(&mut self) {
            if let Some(link) = &self.link
                && std::fs::read_link(link).is_ok_and(|to| to == self.path)
            {
                // Gone already is as good.
                let _ = std::fs::remove_file(link);
            }
        }
    }

    /// Bytes as they are (no echo, no lines, no signals), and none that wait. Opening the other end once also tells the
    /// system that it is closed now.
    fn clear(path: &Path) -> Result<(), Errno> {
        let other = open(path, OFlags::RDWR | OFlags::NOCTTY, Mode::empty())?;
        let mut settings = tcgetattr(&other)?;
        settings.make_raw();
        tcsetattr(&other, OptionalActions::Now, &settings)?;
        tcflush(&other, QueueSelector::IOFlush)
    }

    /// Makes `path` known as `link`. A link that leads nowhere was left behind by a board that did not end in order.
    fn point(link: &Path, path: &Path) -> Result<(), String> {
        let shown = link.display();
        let make = || std::os::unix::fs::symlink(path, link);
        let error = match make() {
            Ok(()) => return Ok(()),
            Err(error) => error,
        };
        if error.kind() == ErrorKind::NotFound {
            let folder = link.parent().unwrap_or(link).display();
            return Err(format!("{shown} cannot be made: the folder {folder} does not exist"));
        }
        let target = std::fs::read_link(link).ok().filter(|_| error.kind() == ErrorKind::AlreadyExists);
        match target {
            Some(target) if target == path || !link.exists() => std::fs::remove_file(link)
                .and_then(|()| make())
                .map_err(|e| format!("{shown} leads nowhere and cannot be replaced: {e}")),
            Some(target) => Err(format!(
                "{shown} is used by another virtual board, it leads to {}: end that one, or choose another name",
                target.display()
            )),
            None => Err(format!("{shown} cannot be made: {error}; choose a name that is free")),
        }
    }
}
