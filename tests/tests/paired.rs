//! A paired link: what is not sealed for this session, with this key, by a counter that grows, is refused and moves nothing.

use mintime_firmware::config::{Capabilities, VehicleConfig};
use mintime_firmware::flight::TickInput;
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::{Decoder, Frame, encode};
use mintime_shared::messages::{
    Downlink, FlightState, KillSwitch, Message, PROTOCOL_VERSION, RECORD_BYTES, Refusal, Reply, Request,
    Uplink,
};
use mintime_shared::seal::{PairingKey, seal};

const KEY: PairingKey = *b"a secret of both";
const SESSION: u32 = 0x5e55_1011;

struct Radio {
    vehicle: Vehicle<Vec<[u8; RECORD_BYTES]>>,
    now_us: u64,
}

impl Radio {
    fn new() -> Self {
        let both = Capabilities { gyro: true, motors: true };
        let mut vehicle = Vehicle::new(Some(VehicleConfig::REFERENCE), both, vec![[0; RECORD_BYTES]; 1]);
        vehicle.set_session(SESSION);
        let mut radio = Self { vehicle, now_us: 0 };
        assert_eq!(radio.hear(&plain(1, Request::Pair(Some(KEY)))), [(1, Reply::Done)]);
        radio
    }

    fn hear(&mut self, bytes: &[u8]) -> Vec<(u16, Reply)> {
        self.vehicle.receive(bytes);
        self.now_us += 1250;
        let imu = Some(ImuSample { gyro_radps: [0.0; 3], accel_mps2: [0.0, 0.0, 9.81] });
        self.vehicle.tick(&TickInput {
            now_us: self.now_us,
            imu,
            battery_v: Some(15.0),
            kill: KillSwitch::Run,
        });
        let mut out = [0; 2000];
        let length = self.vehicle.transmit(&mut out);
        let mut decoder = Decoder::new();
        let said = out[..length].iter().filter_map(|b| decoder.push::<Downlink>(*b));
        said.filter_map(|m| match m.expect("sound").message {
            Message::Reply { number, reply } => Some((number, reply)),
            Message::Telemetry(_) => None,
        })
        .collect()
    }
}

fn uplink(number: u16, request: Request) -> Uplink {
    Uplink { version: PROTOCOL_VERSION, number, request, heard_ms: 0 }
}

fn plain(number: u16, request: Request) -> Vec<u8> {
    encode(&uplink(number, request)).expect("it fits").as_bytes().to_vec()
}

fn sealed(key: &PairingKey, session: u32, counter: u32, number: u16, request: Request) -> Vec<u8> {
    let mut frame = Frame::new();
    let close = |content: &[u8]| seal(key, session, counter, content);
    frame.fill_sealed(&uplink(number, request), close).expect("it fits");
    frame.as_bytes().to_vec()
}

const STOP: Request = Request::EmergencyStop;

#[test]
fn what_is_sealed_is_heard_once() {
    let mut radio = Radio::new();
    let frame = sealed(&KEY, SESSION, 5, 9, STOP);
    assert_eq!(radio.hear(&frame), [(9, Reply::Done)]);
    assert_eq!(radio.vehicle.state(), FlightState::Terminated);
    // Its replay, and any counter that does not grow.
    for counter in [5, 4, 1, 0] {
        let again = sealed(&KEY, SESSION, counter, 10, Request::Status);
        assert!(!radio.hear(&again).iter().any(|(_, reply)| matches!(reply, Reply::Status(_))), "{counter}");
    }
    assert!(matches!(
        radio.hear(&sealed(&KEY, SESSION, 6, 11, Request::Status))[..],
        [(11, Reply::Status(_))]
    ));
    assert!(matches!(
        radio.hear(&sealed(&KEY, SESSION, u32::MAX, 12, Request::Status))[..],
        [(12, Reply::Status(_))]
    ));
}

#[test]
fn what_is_not_sealed_moves_nothing() {
    let mut radio = Radio::new();
    assert_eq!(radio.hear(&plain(2, STOP)), [(2, Reply::Refused(Refusal::NotSealed))]);
    let mut other = KEY;
    other[3] ^= 1;
    for frame in [sealed(&other, SESSION, 7, 3, STOP), sealed(&KEY, SESSION ^ 1, 7, 3, STOP)] {
        assert_eq!(radio.hear(&frame), [(3, Reply::Refused(Refusal::NotSealed))]);
    }
    // Every bit of a sealed request flipped behind its checksum.
    let mut content = postcard::to_slice(&uplink(4, STOP), &mut [0; 64]).expect("it fits").to_vec();
    content.extend(seal(&KEY, SESSION, 8, &content));
    for bit in 0..content.len() * 8 {
        let mut flipped = content.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let mut frame = mintime_shared::crc32(&flipped).to_le_bytes().to_vec();
        flipped.append(&mut frame);
        let mut coded = [0; 100];
        let length = cobs(&flipped, &mut coded);
        radio.hear(&coded[..length]);
        assert_eq!(radio.vehicle.state(), FlightState::Calibrating, "bit {bit}");
    }
    // Who is there may be asked by anybody: that is where the session is learned.
    assert!(matches!(
        radio.hear(&plain(5, Request::Identify))[..],
        [(5, Reply::Identity(identity))] if identity.session == SESSION && identity.paired
    ));
    // The very request, not flipped, is taken.
    assert_eq!(radio.hear(&sealed(&KEY, SESSION, 8, 4, STOP)), [(4, Reply::Done)]);
}

/// Strangers who ask who is there, as often as the line carries, leave room for the host.
#[test]
fn strangers_keep_no_host_out() {
    let mut radio = Radio::new();
    for round in 0..20 {
        let mut bytes = Vec::new();
        for number in 0..8 {
            bytes.extend(plain(100 + number, Request::Identify));
        }
        for number in 1..=3 {
            bytes.extend(sealed(&KEY, SESSION, 3 * round + u32::from(number), number, Request::Status));
            bytes.extend(plain(200, Request::Identify));
        }
        let said = radio.hear(&bytes);
        let answered: Vec<_> = said.iter().map(|(number, _)| *number).collect();
        // Of the strangers one in 20 ms is answered.
        let (host, strangers) = answered.split_at(3);
        assert_eq!(host, [1, 2, 3]);
        assert_eq!(strangers, if round % 16 == 0 { &[100][..] } else { &[] }, "round {round}");
        assert!(said[..3].iter().all(|(_, reply)| matches!(reply, Reply::Status(_))), "{said:?}");
    }
}

/// COBS of less than 254 bytes, and the closing zero.
fn cobs(content: &[u8], coded: &mut [u8]) -> usize {
    let (mut length, mut lead) = (1, 0);
    for &byte in content {
        if byte == 0 {
            coded[lead] = (length - lead) as u8;
            lead = length;
        } else {
            coded[length] = byte;
        }
        length += 1;
    }
    coded[lead] = (length - lead) as u8;
    coded[length] = 0;
    length + 1
}
