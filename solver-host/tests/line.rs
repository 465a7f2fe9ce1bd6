//! What a line, and other programs on it, may do to a host: hold messages back, and be ahead with the counters of seals.

#[allow(dead_code, reason = "another test uses the rest of it")]
mod served;

use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use mintime::flight::{Client, ClientError, ConnectionError, Line};
use mintime::vehicle::{PortLink, Session, SessionError, key_text};
use mintime_shared::framing::{Decoder, Frame, encode, parse};
use mintime_shared::messages::{
    Downlink, FlightState, Happening, Identity, Message, PROTOCOL_VERSION, Purpose, Refusal, Reply, Request,
    Uplink,
};
use mintime_shared::seal::seal;
use serde_json::Value;
use served::{By, Faults, Served};

const GOOD: Faults =
    Faults { loss: 0.0, twice: 0.0, held_up: Duration::ZERO, burst: Duration::ZERO, delay: Duration::ZERO };

/// A line that stalls and then delivers everything starts no motor, however often it was asked.
#[test]
fn what_a_line_held_back_arms_nothing() {
    for by in [By::Tcp, By::Udp] {
        let served = Served::new(by, GOOD);
        let mut session =
            Session::begin(PortLink::open(&served.port).expect("a port"), None).expect("a vehicle");
        let arm = |session: &mut Session<PortLink>| session.tell("arming", Request::Arm(Purpose::Flight));
        while session.status().expect("an answer").arming_block != 0 {
            session.listen(0.1).expect("the line works");
        }
        let turned = || served.with_hands(|hands| core::mem::take(&mut hands.throttle) != [0.0; 4]);
        arm(&mut session).expect("in time");
        session.listen(0.1).expect("the line works");
        assert!(turned());
        session.tell("disarming", Request::Disarm).expect("always");
        while session.status().expect("an answer").arming_block != 0 {
            session.listen(0.1).expect("the line works");
        }
        turned();

        served.with_hands(|hands| hands.holds_back = true);
        let error = arm(&mut session).expect_err("it is not heard");
        assert!(matches!(error, SessionError::Client { source: ClientError::Silent, .. }), "{error}");
        session.listen(0.4).expect("the vehicle is heard");
        served.with_hands(|hands| hands.holds_back = false);
        session.listen(0.3).expect("the line works");
        assert_eq!(session.status().expect("an answer").state, FlightState::Disarmed);
        let late = session.events().expect("a list").into_iter();
        let late = late.filter(|(_, event)| event.what == Happening::Refused(Refusal::Late)).count();
        assert_eq!(late, 1, "all ten under one number");
        assert!(!turned());
        // Who asks now is heard.
        arm(&mut session).expect("in time");
    }
}

/// Two programs, one of them with a clock a day ahead: both are heard, and so is a third one's stop.
#[test]
fn programs_that_disagree_on_the_time_are_heard() {
    let served = Served::new(By::Udp, GOOD);
    let open = |key| Session::begin(PortLink::open(&served.port).expect("a port"), key);
    let key = *b"a key of sixteen";
    open(None).expect("a vehicle").pair(Some(key)).expect("paired");
    let mut early = open(Some(key)).expect("it says who it is");
    early.status().expect("heard");

    // One seal as a program makes it whose clock is a day ahead.
    let ahead = early.identify().expect("an answer").last_counter + 86_400 * 500;
    let uplink = Uplink { version: PROTOCOL_VERSION, number: 7, request: Request::Heartbeat, heard_ms: 0 };
    let mut frame = Frame::new();
    let session = early.identity().session;
    frame.fill_sealed(&uplink, |content| seal(&key, session, ahead, content)).expect("it fits");
    let address = served.port.strip_prefix("udp:").expect("a socket");
    let socket = std::net::UdpSocket::bind("127.0.0.1:0").expect("a port");
    socket.send_to(frame.as_bytes(), address).expect("sent");
    std::thread::sleep(Duration::from_millis(50));

    // Who was at work before goes on, and whoever comes later, side by side.
    early.status().expect("told, and above it");
    let mut other = open(Some(key)).expect("it says who it is");
    for _ in 0..5 {
        other.status().expect("heard");
        early.status().expect("heard");
    }
    assert!(other.identify().expect("an answer").last_counter > ahead);

    let directory = tempfile::tempdir().expect("a directory");
    let file = directory.path().join("key");
    std::fs::write(&file, key_text(&key)).expect("written");
    let at_work = std::thread::spawn(move || {
        let heard = (0..20).filter(|_| early.status().is_ok()).count();
        (early, heard)
    });
    let file = file.display().to_string();
    let stop = ["stop", &served.port, "--key", &file, "--json"];
    let output = Command::new(env!("CARGO_BIN_EXE_mintime")).args(stop).output().expect("it starts");
    let stopped: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(stopped["stopped"], true);
    let (mut early, heard) = at_work.join().expect("no panic");
    assert!(heard >= 15, "{heard} of 20");
    assert_eq!(early.status().expect("heard").state, FlightState::Terminated);
}

/// A paired vehicle is stopped over a line of any length, also while another program flies it, and at once.
#[test]
fn a_stop_gets_through_however_long_the_line_is() {
    let key = *b"a key of sixteen";
    let directory = tempfile::tempdir().expect("a directory");
    let file = directory.path().join("key");
    std::fs::write(&file, key_text(&key)).expect("written");
    let file = file.display().to_string();
    for way_ms in [0, 25, 50, 125] {
        let served = Served::new(By::Udp, Faults { delay: Duration::from_millis(way_ms), ..GOOD });
        let open = |key| Session::begin(PortLink::open(&served.port).expect("a port"), key);
        open(None).expect("a vehicle").pair(Some(key)).expect("paired");
        let mut flight = open(Some(key)).expect("it says who it is");
        let over = Arc::new(AtomicBool::new(false));
        let ends = Arc::clone(&over);
        // A hundred a second, as a flight streams.
        let streams = std::thread::spawn(move || {
            while !ends.load(Ordering::Relaxed) {
                flight.heartbeat().expect("a line");
                flight.listen(0.01).expect("a line");
            }
        });
        std::thread::sleep(Duration::from_millis(200));
        let stop = ["stop", &served.port, "--key", &file, "--json"];
        let began = Instant::now();
        let output = Command::new(env!("CARGO_BIN_EXE_mintime")).args(stop).output().expect("it starts");
        let took = began.elapsed();
        over.store(true, Ordering::Relaxed);
        streams.join().expect("no panic");
        let stopped: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(stopped["stopped"], true, "{way_ms} ms: {stopped}");
        // Who it is, the stop, and the word of it: two round trips; the rest is this machine's.
        assert!(took < Duration::from_millis(4 * way_ms + 400), "{way_ms} ms: {took:?}");
    }
}

/// Programs of one computer do not push each other aside: neither the one that streams nor the one that asks.
#[test]
fn programs_with_one_clock_share_a_line() {
    let key = [9; 16];
    for way_ms in [2, 20, 50] {
        let served = Served::new(By::Udp, Faults { delay: Duration::from_millis(way_ms), ..GOOD });
        let open = |key| Session::begin(PortLink::open(&served.port).expect("a port"), key);
        open(None).expect("a vehicle").pair(Some(key)).expect("paired");
        let mut flight = open(Some(key)).expect("it says who it is");
        let mut other = open(Some(key)).expect("it says who it is");
        let asks = std::thread::spawn(move || (0..10).filter(|_| other.status().is_ok()).count());
        let mut sent = 0;
        while !asks.is_finished() || sent < 100 {
            flight.heartbeat().expect("a line");
            flight.listen(0.01).expect("a line");
            sent += 1;
        }
        assert_eq!(asks.join().expect("no panic"), 10, "{way_ms} ms");
        let errors = flight.client().telemetry().expect("heard").link_errors;
        // Two seals of one instant cost one of them, and an answer to it.
        assert!(errors * 3 < sent, "{errors} of {sent} seals refused, {way_ms} ms");
    }
}

/// A stop is said also where nothing can be heard any more.
#[test]
fn a_line_that_cannot_be_read_is_written_to() {
    struct Mute(Vec<u8>);
    impl Line for Mute {
        fn send(&mut self, bytes: &[u8]) -> Result<(), ConnectionError> {
            self.0.extend_from_slice(bytes);
            Ok(())
        }
        fn receive(&mut self, _: &mut Vec<u8>) -> Result<(), ConnectionError> {
            Err(std::io::Error::from(std::io::ErrorKind::UnexpectedEof).into())
        }
    }
    for request in [Request::EmergencyStop, Request::Disarm, Request::Heartbeat] {
        let mut line = Mute(Vec::new());
        let mut client = Client::default();
        client.ask(&mut line, request, 0.0).expect("it is sent");
        assert!(line.0.len() > 5);
        client.poll(&mut line, 0.01).expect_err("and the line's failure told");
    }
}

/// A counter for which the vehicle does not vouch is a stranger's: it uses up nobody's numbers.
#[test]
fn a_counter_that_nobody_vouches_for_is_not_believed() {
    // Answers as a vehicle that is paired with another key, and with a counter near the last there is.
    let socket = std::net::UdpSocket::bind("127.0.0.1:0").expect("a port");
    socket.set_read_timeout(Some(Duration::from_secs(5))).expect("possible");
    let port = format!("udp:{}", socket.local_addr().expect("bound"));
    let stranger = std::thread::spawn(move || {
        let mut decoder = Decoder::new();
        let mut buffer = [0; 300];
        loop {
            let (count, from) = socket.recv_from(&mut buffer).expect("a request");
            let content = &mut &buffer[..count];
            while let Some(content) = decoder.next_content(content) {
                let content = content.expect("sound");
                if let Ok(Uplink { number, request: Request::Identify, .. }) = parse(content) {
                    let identity = Identity {
                        firmware_version: [0; 3],
                        table_schema: 0,
                        vehicle: 0,
                        session: 5,
                        paired: true,
                        last_counter: u32::MAX - 1,
                        last_counter_mac: 0x1234_5678_9abc_def0,
                        thrust_min_mps2: 0.0,
                        thrust_max_mps2: 0.0,
                        rate_max_radps: 0.0,
                    };
                    let message = Message::Reply { number, reply: Reply::Identity(identity) };
                    let frame = encode(&Downlink { version: PROTOCOL_VERSION, message }).expect("it fits");
                    socket.send_to(frame.as_bytes(), from).expect("sent");
                } else {
                    let (_, seal) = content.split_last_chunk::<12>().expect("a seal");
                    return u32::from_le_bytes(seal[..4].try_into().expect("four"));
                }
            }
        }
    });
    let mut session =
        Session::begin(PortLink::open(&port).expect("a port"), Some([7; 16])).expect("an answer");
    session.status().expect_err("nobody answers");
    assert!(stranger.join().expect("no panic") < u32::MAX - (1 << 24), "counted on by the clock");
}
