//! A vehicle in a thread, in real time, behind a socket or a pseudo-terminal, with a line as bad as one likes.

use std::io::{Read as _, Write as _};
use std::net::{SocketAddr, TcpListener, TcpStream, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use mintime_firmware::config::{BoardStatus, Capabilities, StoreStatus, VehicleConfig};
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::messages::{BoardTelemetry, IncidentCause, KillSwitch, RECORD_BYTES};

/// What the line does to chunks of bytes (datagrams, where it is UDP), each way.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Faults {
    /// Part that is lost.
    pub(crate) loss: f64,
    /// Part that comes twice.
    pub(crate) twice: f64,
    /// Chunks are held up by a random time up to this.
    pub(crate) held_up: Duration,
    /// Chunks take this long.
    pub(crate) delay: Duration,
    /// Chunks come in bursts with this between them.
    pub(crate) burst: Duration,
}

/// What the vehicle hangs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum By {
    Tcp,
    Udp,
    #[cfg(unix)]
    Pty,
}

/// What hands do with the vehicle, and what its motors have done.
#[derive(Debug, Default)]
pub(crate) struct Hands {
    /// Wait this many ticks, then turn about up by this rate, rad/s, for this many ticks.
    pub(crate) turn: Option<(u32, f32, u32)>,
    /// Something that a person must know of.
    pub(crate) report: Option<IncidentCause>,
    /// The line keeps what the host says to itself; it delivers all of it when this ends.
    pub(crate) holds_back: bool,
    /// Highest throttle that each output has had.
    pub(crate) throttle: [f32; 4],
}

/// A vehicle that is served until this is dropped.
pub(crate) struct Served {
    /// Its name for `mintime`.
    pub(crate) port: String,
    stop: Arc<AtomicBool>,
    hands: Arc<Mutex<Hands>>,
    thread: Option<JoinHandle<()>>,
}

impl Drop for Served {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Served {
    pub(crate) fn new(by: By, faults: Faults) -> Self {
        let (end, port) = End::open(by);
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        let hands = Arc::new(Mutex::new(Hands::default()));
        let at_work = Arc::clone(&hands);
        let thread = Some(std::thread::spawn(move || serve(end, faults, &stopped, &at_work)));
        Self { port, stop, hands, thread }
    }

    /// The hands on the vehicle.
    pub(crate) fn with_hands<T>(&self, act: impl FnOnce(&mut Hands) -> T) -> T {
        act(&mut self.hands.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Pulls the plug.
    pub(crate) fn vanish(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.join().expect("it served");
        }
    }
}

/// The vehicle's end of the line.
enum End {
    Tcp(TcpListener, Option<TcpStream>),
    /// All who have sent something hear what it says.
    Udp(UdpSocket, Vec<SocketAddr>),
    #[cfg(unix)]
    Pty(serial2::SerialPort),
}

impl End {
    fn open(by: By) -> (Self, String) {
        match by {
            By::Tcp => {
                let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
                listener.set_nonblocking(true).expect("possible");
                let port = format!("tcp:{}", listener.local_addr().expect("bound"));
                (Self::Tcp(listener, None), port)
            }
            By::Udp => {
                let socket = UdpSocket::bind("127.0.0.1:0").expect("a port");
                socket.set_nonblocking(true).expect("possible");
                let port = format!("udp:{}", socket.local_addr().expect("bound"));
                (Self::Udp(socket, Vec::new()), port)
            }
            #[cfg(unix)]
            By::Pty => {
                use std::os::fd::AsRawFd as _;
                let (mut board, host) = serial2::SerialPort::pair().expect("a pseudo-terminal");
                let path =
                    std::fs::read_link(format!("/proc/self/fd/{}", host.as_raw_fd())).expect("its name");
                // Not to be read, but held: without it a program that closes the port would hang the board up.
                std::mem::forget(host);
                board.set_read_timeout(Duration::ZERO).expect("possible");
                (Self::Pty(board), path.display().to_string())
            }
        }
    }

    fn read(&mut self) -> Option<Vec<u8>> {
        let mut bytes = vec![0; 2048];
        let count = match self {
            Self::Tcp(listener, stream) => {
                if let Ok((new, _)) = listener.accept() {
                    new.set_nonblocking(true).expect("possible");
                    new.set_nodelay(true).expect("possible");
                    *stream = Some(new);
                }
                stream.as_mut()?.read(&mut bytes).ok()?
            }
            Self::Udp(socket, peers) => {
                let (count, from) = socket.recv_from(&mut bytes).ok()?;
                if !peers.contains(&from) {
                    peers.push(from);
                }
                count
            }
            #[cfg(unix)]
            Self::Pty(port) => port.read(&mut bytes).ok()?,
        };
        bytes.truncate(count);
        (count > 0).then_some(bytes)
    }

    fn write(&mut self, bytes: &[u8]) {
        // As on a wire, what nobody reads is lost.
        let _ = match self {
            Self::Tcp(_, Some(stream)) => stream.write(bytes).map(|_| ()),
            Self::Udp(socket, peers) => {
                // Who has gone keeps nobody else from hearing.
                for peer in peers {
                    let _ = socket.send_to(bytes, *peer);
                }
                Ok(())
            }
            #[cfg(unix)]
            Self::Pty(port) => port.write(bytes).map(|_| ()),
            _ => Ok(()),
        };
    }
}

/// One direction of the line.
struct Way {
    faults: Faults,
    random: u64,
    began: Instant,
    queue: Vec<(Instant, Vec<u8>)>,
}

impl Way {
    fn new(faults: Faults, seed: u64) -> Self {
        Self { faults, random: seed, began: Instant::now(), queue: Vec::new() }
    }

    fn chance(&mut self) -> f64 {
        self.random =
            self.random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.random >> 33) as f64 / f64::from(1u32 << 31)
    }

    fn push(&mut self, chunk: &[u8]) {
        if self.chance() < self.faults.loss {
            return;
        }
        let times = if self.chance() < self.faults.twice { 2 } else { 1 };
        for _ in 0..times {
            let mut at = Instant::now() + self.faults.delay + self.faults.held_up.mul_f64(self.chance());
            let burst = self.faults.burst.as_nanos();
            if let Some(bursts) = (at - self.began).as_nanos().checked_div(burst) {
                at = self.began + Duration::from_nanos(((bursts + 1) * burst) as u64);
            }
            self.queue.push((at, chunk.to_vec()));
        }
        self.queue.sort_by_key(|(at, _)| *at);
    }

    fn pop(&mut self) -> Option<Vec<u8>> {
        let due = self.queue.first().is_some_and(|(at, _)| *at <= Instant::now());
        due.then(|| self.queue.remove(0).1)
    }
}

/// The rate about up that hands give the vehicle now, rad/s.
fn turned(hands: &mut Hands) -> f32 {
    let Some((wait, rate_radps, ticks)) = &mut hands.turn else { return 0.0 };
    if *wait > 0 {
        *wait -= 1;
        return 0.0;
    }
    let rate_radps = *rate_radps;
    *ticks = ticks.saturating_sub(1);
    if *ticks == 0 {
        hands.turn = None;
    }
    rate_radps
}

fn serve(mut end: End, faults: Faults, stopped: &AtomicBool, hands: &Mutex<Hands>) {
    let capabilities = Capabilities { gyro: true, motors: true };
    let record = vec![[0; RECORD_BYTES]; 800];
    let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), capabilities, record);
    vehicle.set_session(0xC0FF_EE00);
    let (mut up, mut down) = (Way::new(faults, 1), Way::new(faults, 2));
    let began = Instant::now();
    let mut finished = 0;
    let mut job: Option<(u32, Instant)> = None;
    let mut frame = Vec::new();
    let mut tick = 0_u64;
    while !stopped.load(Ordering::Relaxed) {
        while let Some(chunk) = end.read() {
            up.push(&chunk);
        }
        let holds_back = hands.lock().unwrap_or_else(PoisonError::into_inner).holds_back;
        while !holds_back && let Some(chunk) = up.pop() {
            vehicle.receive(&chunk);
        }
        // Flash takes its time.
        job = job.or(vehicle.job().map(|j| (j.ticket, Instant::now())));
        if let Some((ticket, _)) = job.take_if(|(_, since)| since.elapsed() > Duration::from_millis(150)) {
            finished = ticket;
        }
        vehicle.set_board_status(&BoardStatus {
            capabilities,
            starting: false,
            telemetry: BoardTelemetry { latency_ns: 91_000, load_permille: 60, ..BoardTelemetry::default() },
            store: StoreStatus { present: true, busy: job.is_some(), finished, failed: false },
        });
        // A real gyro's last bit never rests.
        let noise = if tick.is_multiple_of(2) { 1e-3 } else { -1e-3 };
        let mut hands = hands.lock().unwrap_or_else(PoisonError::into_inner);
        let yaw = turned(&mut hands);
        if let Some(cause) = hands.report.take() {
            vehicle.report(cause);
        }
        let imu =
            Some(ImuSample { gyro_radps: [noise, -noise, noise + yaw], accel_mps2: [0.0, noise, 9.81] });
        let input = TickInput { now_us: tick * 1250, imu, battery_v: Some(15.5), kill: KillSwitch::Run };
        let throttle = vehicle.tick(&input).throttle.unwrap_or_default();
        for (highest, now) in hands.throttle.iter_mut().zip(throttle) {
            *highest = highest.max(now);
        }
        drop(hands);
        let mut out = [0; 115];
        let sent = vehicle.transmit(&mut out);
        for &byte in &out[..sent] {
            frame.push(byte);
            // One frame, one datagram.
            if byte == 0 {
                down.push(&core::mem::take(&mut frame));
            }
        }
        while let Some(chunk) = down.pop() {
            end.write(&chunk);
        }
        tick += 1;
        let due = began + Duration::from_micros(tick * 1250);
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
    }
}
