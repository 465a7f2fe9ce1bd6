//! Where poses come from: datagrams or standard input, read by a thread of its own so that each is stamped when it arrives.

use std::io::{BufRead as _, Read as _};
use std::net::UdpSocket;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use super::error::CaptureError;
use super::monitor::{Monitor, Volume};
use super::sample::{CaptureSample, MAX_LINE_BYTES};
use crate::flight::Pose;

/// Lines that may wait; a host that is this far behind does not fly.
const QUEUE: usize = 1024;

/// What a capture is told.
#[derive(Clone, Debug, Default)]
pub struct CaptureOptions {
    /// The body that flies.
    pub name: Option<String>,
    /// Where it may be.
    pub room: Option<Volume>,
    /// Shortest time from picture to pose, s.
    pub latency_s: f64,
}

/// What the reading thread sends.
enum Arrival {
    Line(Vec<u8>, Instant),
    End(String),
}

/// Motion capture, listening.
#[derive(Debug)]
pub struct Capture {
    arrivals: Receiver<Arrival>,
    monitor: Monitor,
    began: Instant,
    /// Where datagrams are received.
    address: Option<std::net::SocketAddr>,
}

impl Capture {
    /// Listens on `udp:ADDRESS:PORT`, or reads standard input for `-`. Host times are counted from `began`.
    ///
    /// # Errors
    /// [`CaptureError::Name`], [`CaptureError::Listen`].
    pub fn open(spec: &str, options: CaptureOptions, began: Instant) -> Result<Self, CaptureError> {
        let (sender, arrivals) = sync_channel(QUEUE);
        let mut address = None;
        if spec == "-" {
            std::thread::spawn(move || read_lines(std::io::stdin().lock(), &sender));
        } else {
            let at = spec.strip_prefix("udp:").ok_or_else(|| CaptureError::Name { spec: spec.to_owned() })?;
            let listen =
                |e: std::io::Error| CaptureError::Listen { spec: spec.to_owned(), reason: e.to_string() };
            let socket = UdpSocket::bind(at).map_err(listen)?;
            address = socket.local_addr().ok();
            std::thread::spawn(move || read_datagrams(&socket, &sender));
        }
        let CaptureOptions { name, room, latency_s } = options;
        let monitor = Monitor::new(name, room, latency_s, began.elapsed().as_secs_f64());
        Ok(Self { arrivals, monitor, began, address })
    }

    /// Where datagrams are received; `None` for standard input.
    pub fn address(&self) -> Option<std::net::SocketAddr> {
        self.address
    }

    /// Where the body may be from now on.
    pub fn confine(&mut self, room: Volume) {
        self.monitor.confine(room);
    }

    /// Samples that were not believed.
    pub fn refused(&self) -> u64 {
        self.monitor.refused()
    }

    /// Why there is no motion capture now, if there is none.
    pub fn trouble(&self) -> Option<CaptureError> {
        self.monitor.trouble(self.began.elapsed().as_secs_f64())
    }

    /// Waits for the next pose that is believed. `None` where none came in time; whether that matters,
    /// [`trouble`](Self::trouble) says.
    ///
    /// # Errors
    /// [`CaptureError::Ended`].
    pub fn next(&mut self, timeout: Duration, flying: bool) -> Result<Option<Pose>, CaptureError> {
        let deadline = Instant::now() + timeout;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.arrivals.recv_timeout(left) {
                Err(RecvTimeoutError::Timeout) => return Ok(None),
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(CaptureError::Ended { reason: "its reader has stopped".to_owned() });
                }
                Ok(Arrival::End(reason)) => return Err(CaptureError::Ended { reason }),
                Ok(Arrival::Line(line, at)) => {
                    let arrived_s = at.saturating_duration_since(self.began).as_secs_f64();
                    match CaptureSample::parse(&line) {
                        Err(error) => self.monitor.refuse(error),
                        Ok(sample) => {
                            // Refusals are noted in the monitor.
                            if let Ok(Some(pose)) = self.monitor.accept(sample, arrived_s, flying) {
                                return Ok(Some(pose));
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Ends when nobody listens any more.
fn read_datagrams(socket: &UdpSocket, sender: &SyncSender<Arrival>) {
    let mut bytes = vec![0; 65_536];
    loop {
        match socket.recv(&mut bytes) {
            Ok(count) => {
                let at = Instant::now();
                for line in bytes[..count].split(|b| *b == b'\n').filter(|l| !l.trim_ascii().is_empty()) {
                    // A line that is too long is refused by its length; its bytes are not needed for that.
                    let line = line[..line.len().min(MAX_LINE_BYTES + 1)].to_vec();
                    if sender.send(Arrival::Line(line, at)).is_err() {
                        return;
                    }
                }
            }
            Err(e) if e.kind() == std::io::ErrorKind::Interrupted => {}
            Err(e) => {
                let _ = sender.send(Arrival::End(e.to_string()));
                return;
            }
        }
    }
}

/// Lines of bounded length.
fn read_lines(mut input: impl std::io::BufRead, sender: &SyncSender<Arrival>) {
    let most = MAX_LINE_BYTES as u64 + 1;
    loop {
        let mut line = Vec::new();
        let result = input.by_ref().take(most).read_until(b'\n', &mut line);
        let at = Instant::now();
        match result {
            Ok(0) => {
                let _ = sender.send(Arrival::End("end of input".to_owned()));
                return;
            }
            Ok(_) => {
                let cut = line.len() as u64 == most && !line.ends_with(b"\n");
                let blank = line.trim_ascii().is_empty();
                if !blank && sender.send(Arrival::Line(line, at)).is_err() {
                    return;
                }
                if cut && input.skip_until(b'\n').is_err() {
                    return;
                }
            }
            Err(e) => {
                let _ = sender.send(Arrival::End(e.to_string()));
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn datagrams_become_poses_and_garbage_does_not() {
        let mut capture =
            Capture::open("udp:127.0.0.1:0", CaptureOptions::default(), Instant::now()).expect("a socket");
        let to = capture.address().expect("an address");
        let sender = UdpSocket::bind("127.0.0.1:0").expect("a socket");
        sender.send_to(b"\xFF\x00garbage", to).expect("sent");
        sender.send_to(&[b'['; 3000], to).expect("sent");
        let line = r#"{"t":1,"position_m":[0,0,0],"attitude_wxyz":[1,0,0,0]}"#;
        sender.send_to(line.as_bytes(), to).expect("sent");
        let pose = capture.next(Duration::from_secs(5), false).expect("listening").expect("a pose");
        assert_eq!(pose.position_m.norm(), 0.0);
        assert_eq!(capture.refused(), 2);
        assert_eq!(capture.next(Duration::from_millis(120), false).expect("listening"), None);
        assert!(matches!(capture.trouble(), Some(CaptureError::Stale { .. })));
    }

    #[test]
    fn lines_of_any_length_are_cut_into_bounded_ones() {
        let (sender, arrivals) = sync_channel(16);
        let mut input = vec![b'x'; 5000];
        input.extend_from_slice(b"\n\n{}\n{");
        read_lines(&input[..], &sender);
        let lengths: Vec<usize> = arrivals
            .try_iter()
            .map(|a| match a {
                Arrival::Line(line, _) => line.len(),
                Arrival::End(_) => 0,
            })
            .collect();
        assert_eq!(lengths, [MAX_LINE_BYTES + 1, 3, 1, 0]);
    }

    #[test]
    fn sources_that_are_none_are_named() {
        for spec in ["", "udp:", "udp:nowhere:0:0", "tcp:1.2.3.4:5"] {
            let error = Capture::open(spec, CaptureOptions::default(), Instant::now()).expect_err(spec);
            assert!(matches!(error, CaptureError::Name { .. } | CaptureError::Listen { .. }), "{error}");
        }
    }
}
