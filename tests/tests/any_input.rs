//! Millions of ticks of arbitrary life: any requests, any bytes, any samples, any clock, any battery and kill switch. What is
//! promised of every tick is checked in every tick.

mod logic;

use logic::{BOTH, HOVER, Record, TICK_US, bytes_of, chunk, table};
use mintime_firmware::config::{BoardStatus, StoreStatus, VehicleConfig};
use mintime_firmware::flight::{FlightLogic, Inbox, Outbox, TickInput, TickOutput};
use mintime_firmware::gyro::ImuSample;
use mintime_firmware::keeping::Key;
use mintime_firmware::vehicle::Vehicle;
use mintime_shared::framing::{Decoder, encode};
use mintime_shared::messages::{
    Downlink, FlightState, Incident, IncidentCause, KillSwitch, Message, PROTOCOL_VERSION, Purpose,
    RECORD_BYTES, Request, Setpoint, TableName, Uplink,
};
use mintime_shared::settings::Settings;

thread_local! {
    static CHECKSUM: u32 = table().checksum();
}

/// A generator of its own (xorshift64*), so that a seed repeats itself and a million draws cost nothing.
struct Draw(u64);

impl Draw {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    fn below(&mut self, n: u64) -> u64 {
        (self.bits() >> 33) % n
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// Any bits as a float: NaN, infinities, subnormals and all.
    fn any_float(&mut self) -> f32 {
        match self.below(6) {
            0 => f32::NAN,
            1 => f32::INFINITY,
            2 => f32::NEG_INFINITY,
            3 => f32::MAX,
            _ => f32::from_bits(self.bits() as u32),
        }
    }

    fn within(&mut self, bound: f32) -> f32 {
        ((self.bits() >> 40) as f32 / (1u64 << 24) as f32 * 2.0 - 1.0) * bound
    }

    fn name(&mut self) -> TableName {
        TableName::try_from(["a", "flip", "", "sixteen bytes ok"][self.below(4) as usize]).expect("short")
    }

    fn setpoint(&mut self) -> Setpoint {
        match self.below(12) {
            0 => Setpoint {
                rates_radps: [self.any_float(), 0.0, self.within(1.0)],
                thrust_mps2: self.any_float(),
            },
            1..4 => Setpoint {
                rates_radps: core::array::from_fn(|_| self.within(36.0)),
                thrust_mps2: self.within(101.0).abs(),
            },
            4 => Setpoint::default(),
            _ => HOVER,
        }
    }

    /// A request; `sequence` is the number that a host's next setpoint would have.
    fn request(&mut self, sequence: &mut u16, incident: u16) -> Request {
        let checksum = if self.one_in(10) { self.bits() as u32 } else { CHECKSUM.with(|c| *c) };
        match self.below(64) {
            0..22 => {
                *sequence = if self.one_in(30) { self.bits() as u16 } else { sequence.wrapping_add(1) };
                Request::Setpoint { sequence: *sequence, setpoint: self.setpoint() }
            }
            22..30 => Request::Arm(if self.one_in(6) { Purpose::MotorTest } else { Purpose::Flight }),
            30..37 => Request::Trigger { checksum },
            37..44 => {
                Request::Acknowledge { incident: if self.one_in(4) { self.bits() as u16 } else { incident } }
            }
            44 if self.one_in(20) => Request::Disarm,
            45 if self.one_in(20) => Request::EmergencyStop,
            46 => Request::Status,
            47 => Request::Identify,
            48 => Request::SetTelemetry { period_ms: self.below(1100) as u16 },
            49 => {
                let bytes = bytes_of(&table());
                let at = self.below(bytes.len() as u64) as usize;
                let end = bytes.len().min(at + 1 + self.below(127) as usize);
                chunk(bytes.len(), at, &bytes[at..end])
            }
            50 => {
                let (total, offset) = (self.bits() as u16, self.bits() as u16);
                let length = self.below(128) as usize;
                let noise: Vec<u8> = (0..length).map(|_| self.bits() as u8).collect();
                chunk(usize::from(total), usize::from(offset), &noise)
            }
            51 => Request::CommitTable { checksum },
            52 => Request::StoreTable { name: self.name(), checksum },
            53 => Request::LoadTable { name: self.name() },
            54 => Request::DeleteTable { name: self.name() },
            55 => Request::WriteSettings(Settings {
                bench_thrust_mps2: [0.0, 2.0, 5.0, f32::NAN][self.below(4) as usize],
                recovery_ms: self.below(6000) as u16,
                heartbeat_ms: self.below(2500) as u16,
                gyro_scale: [1.0 + self.within(0.06); 3],
                gyro_cutoff_hz: self.within(400.0),
                ..Settings::DEFAULT
            }),
            56 => Request::WriteVehicle(VehicleConfig {
                mass_kg: if self.one_in(3) { self.any_float() } else { 0.752 },
                ..VehicleConfig::REFERENCE
            }),
            57 => Request::TestMotor {
                motor: self.below(5) as u8,
                throttle: self.within(0.2),
                duration_ms: self.below(2500) as u16,
            },
            58 if self.one_in(60) => Request::Calibrate,
            59 if self.one_in(8) => {
                Request::CalibrateScale { axis: self.below(4) as u8, turns: self.bits() as i8 }
            }
            60 => [
                Request::ReadTable,
                Request::ListTables,
                Request::ReadVehicle,
                Request::ReadSettings,
                Request::Record,
            ][self.below(5) as usize]
                .clone(),
            61 => Request::ReadRecord { first: self.below(1000) as u32 },
            62 => Request::ReadEvents { first: self.bits() as u32 >> self.below(32) },
            63 if self.one_in(10) => Request::Pair((!self.one_in(3)).then(|| [self.bits() as u8; 16])),
            _ => Request::Heartbeat,
        }
    }
}

/// The world around a flight logic, and what was true of it in the last tick.
struct World {
    draw: Draw,
    now_us: u64,
    /// Ticks of quiet left: a vehicle that is shaken all the time is never armed.
    quiet: u64,
    /// The host says nothing as long as it is quiet.
    silent: bool,
    kill: KillSwitch,
    /// What it says as a rule: there are lives without one, on the bench.
    usual_kill: KillSwitch,
    battery_v: Option<f32>,
    /// The last voltage that a battery of this vehicle can have.
    plausible_v: Option<f32>,
    /// Its motors were switched on where nothing but the bench's cap stood in for a kill switch.
    on_bench: bool,
    sequence: u16,
    rates_radps: [f32; 3],
    ticks: u64,
    states: [u64; FlightState::ALL.len()],
    /// Throttles that were judged by the bench's cap.
    capped: u64,
}

impl World {
    fn new(seed: u64) -> Self {
        let usual_kill = if seed.is_multiple_of(5) { KillSwitch::Absent } else { KillSwitch::Run };
        Self {
            draw: Draw::new(seed),
            now_us: 0,
            quiet: 900,
            silent: false,
            kill: usual_kill,
            usual_kill,
            battery_v: Some(15.5),
            plausible_v: None,
            on_bench: false,
            sequence: 0,
            rates_radps: [0.0; 3],
            ticks: 0,
            states: [0; FlightState::ALL.len()],
            capped: 0,
        }
    }

    /// What a host heard last of the vehicle's clock: a moment ago, now and then longer ago, or of another start.
    fn heard_ms(&mut self) -> u32 {
        let age_ms = match self.draw.below(50) {
            0 => self.draw.bits(),
            1 => self.draw.below(700),
            _ => self.draw.below(60),
        };
        ((self.now_us / 1000) as u32).wrapping_sub(age_ms as u32)
    }

    fn input(&mut self, asked: &Setpoint) -> TickInput {
        let draw = &mut self.draw;
        let quiet = self.quiet > 0;
        self.silent &= quiet;
        self.quiet = self.quiet.saturating_sub(1);
        if self.quiet == 0 && draw.one_in(150) {
            self.quiet = 200 + draw.below(2500);
            self.silent = draw.one_in(5);
        }
        let step_us = match draw.below(if quiet { 1 << 40 } else { 4000 }) {
            0 => draw.bits() >> draw.below(64),
            1..3 => draw.below(20_000),
            3..40 => draw.below(3000),
            _ => TICK_US,
        };
        let backwards = !quiet && draw.one_in(6000);
        self.now_us =
            if backwards { self.now_us.wrapping_sub(step_us) } else { self.now_us.wrapping_add(step_us) };
        if !quiet && draw.one_in(400) || self.kill != self.usual_kill && draw.one_in(100) {
            self.kill = [KillSwitch::Run, KillSwitch::Lost, KillSwitch::Stop, KillSwitch::Absent]
                [draw.below(4) as usize];
        }
        if quiet && draw.one_in(3) {
            self.kill = self.usual_kill;
        }
        self.battery_v = match draw.below(if quiet { 1 << 40 } else { 600 }) {
            0 => None,
            1 => Some(draw.any_float()),
            2 => Some(11.0 + draw.within(8.0)),
            3..20 => Some(15.5),
            _ if quiet => Some(15.5),
            _ => self.battery_v,
        };
        for (rate, asked) in self.rates_radps.iter_mut().zip(asked.rates_radps) {
            *rate += 0.1 * (asked - *rate);
        }
        let mut gyro_radps = self.rates_radps.map(|rate| rate + draw.within(0.004));
        let mut accel_mps2 = [draw.within(0.2), draw.within(0.2), 9.81 + draw.within(0.2)];
        let mut imu = true;
        if !quiet {
            match draw.below(500) {
                0 => gyro_radps[draw.below(3) as usize] = draw.any_float(),
                1 => gyro_radps = [draw.within(50.0), draw.within(50.0), draw.within(50.0)],
                2 => accel_mps2[draw.below(3) as usize] = draw.any_float(),
                3 => accel_mps2 = [draw.within(300.0), draw.within(300.0), draw.within(300.0)],
                4..7 => imu = false,
                _ => {}
            }
        }
        TickInput {
            now_us: self.now_us,
            imu: imu.then_some(ImuSample { gyro_radps, accel_mps2 }),
            battery_v: self.battery_v,
            kill: self.kill,
        }
    }
}

/// What is promised of each tick, whatever came in.
#[allow(clippy::too_many_arguments, reason = "all that a tick is judged by")]
fn check(
    world: &mut World,
    out: &TickOutput,
    before: FlightState,
    after: FlightState,
    input: &TickInput,
    armed_for: Option<bool>,
    settings: &Settings,
) {
    let story = || format!("tick {}, {before:?} to {after:?}, {input:?}: {out:?}", world.ticks);
    assert_eq!(out.throttle.is_some(), after.motors_on(), "{}", story());
    let throttles = out.throttle.unwrap_or_default();
    assert!(throttles.iter().all(|t| (0.0..=1.0).contains(t)), "{}", story());
    // What it flies is within what makes sense, always.
    assert!(out.setpoint.is_in_range(), "{}", story());
    // No motor starts but from disarmed, by a request to arm in this very tick.
    if after.motors_on() && !before.motors_on() {
        assert_eq!(
            (before, after, armed_for),
            (FlightState::Disarmed, FlightState::Armed, Some(true)),
            "{}",
            story()
        );
    }
    if after.motors_on() {
        // Nor does one turn against the switch, nor without one but on the bench, and there not beyond the cap.
        assert!(!matches!(input.kill, KillSwitch::Stop | KillSwitch::Lost), "{}", story());
        if input.kill == KillSwitch::Absent {
            assert!(settings.bench_thrust_mps2 > 0.0, "{}", story());
            assert!(out.setpoint.thrust_mps2 <= settings.bench_thrust_mps2, "{}", story());
        }
    }
    world.ticks += 1;
    world.states[FlightState::ALL.iter().position(|s| *s == after).expect("a state")] += 1;
}

/// What a rotor gets where the thrust is capped: no more than its share of the cap, or idle, which it never goes below. By the
/// thrust map, T = T_max (V/V_ref · throttle)² for this vehicle.
fn check_share(
    world: &mut World,
    out: &TickOutput,
    before: FlightState,
    input: &TickInput,
    settings: &Settings,
    config: &VehicleConfig,
) {
    assert_eq!((config.thrust_linear_share, config.sag_v_per_n), (0.0, 0.0));
    let waived = input.kill == KillSwitch::Absent && settings.bench_thrust_mps2 > 0.0;
    if !before.motors_on() {
        world.on_bench = waived;
    }
    world.plausible_v = input.battery_v.filter(|v| config.is_plausible_battery(*v)).or(world.plausible_v);
    if !(waived || world.on_bench) {
        return;
    }
    let volts = world.plausible_v.unwrap_or(config.battery_nominal_v);
    let share_n = settings.bench_thrust_mps2 * config.mass_kg / 4.0;
    let speed = (share_n / config.rotor_thrust_max_n).sqrt() * config.battery_nominal_v / volts;
    let idle = (config.rotor_thrust_idle_n / config.rotor_thrust_max_n).sqrt();
    let most = speed.max(idle * config.battery_nominal_v / volts).max(idle);
    for throttle in out.throttle.into_iter().flatten() {
        world.capped += 1;
        assert!(
            throttle <= most * 1.0001,
            "tick {}: {throttle} where {most} is the most, {settings:?}, {config:?}, {input:?}",
            world.ticks
        );
    }
}

fn report(name: &str, ticks: u64, states: &[u64]) {
    println!("{name}: {ticks} ticks; {:?}", FlightState::ALL.iter().zip(states).collect::<Vec<_>>());
}

/// Requests given to the flight logic itself.
#[test]
fn two_million_ticks_of_any_requests() {
    const LIVES: u64 = 100;
    const TICKS_EACH: u64 = 20_000;
    let mut states = [0; FlightState::ALL.len()];
    let (mut ticks, mut capped, mut pairings) = (0, 0, 0);
    for life in 0..LIVES {
        let mut world = World::new(life + 1);
        let known = !life.is_multiple_of(10);
        let mut logic =
            FlightLogic::new(known.then_some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 400]);
        let mut outbox = Outbox::new();
        let mut asked = Setpoint::default();
        let mut uplink_number = 0u16;
        while world.ticks < TICKS_EACH {
            let input = world.input(&asked);
            let mut inbox = Inbox::new();
            let mut arms = false;
            let requests = if world.silent { 0 } else { world.draw.below(4) };
            for _ in 0..requests {
                let incident = logic.incident().map_or(0, |i: Incident| i.number);
                let request = world.draw.request(&mut world.sequence, incident);
                let version = if world.draw.one_in(200) { world.draw.bits() as u8 } else { PROTOCOL_VERSION };
                uplink_number = uplink_number.wrapping_add(1);
                let heard_ms = world.heard_ms();
                let uplink = Uplink { version, number: uplink_number, request, heard_ms };
                arms |= matches!(uplink.request, Request::Arm(_))
                    && version == PROTOCOL_VERSION
                    && uplink.is_recent(input.now_us);
                inbox.push_back(uplink).expect("three at most");
            }
            if world.draw.one_in(5000) {
                logic.report(IncidentCause::Panic(world.draw.bits() as u32));
            }
            if world.draw.one_in(50) {
                let finished = logic.job().map_or(world.draw.bits() as u32, |job| job.ticket);
                let store = StoreStatus {
                    present: life % 3 == 1,
                    busy: world.draw.one_in(20),
                    finished,
                    failed: world.draw.one_in(8),
                };
                let starting = world.ticks < 200 || world.draw.one_in(500);
                logic.set_board_status(&BoardStatus { store, ..logic::status(BOTH, starting) });
            }
            let (before, settings, config) = (logic.state(), *logic.settings(), *logic.config());
            let key = logic.pairing().copied();
            let out = logic.tick(&input, &mut inbox, &mut outbox);
            check_share(&mut world, &out, before, &input, &settings, &config);
            assert!(!logic.state().motors_on() || logic.pairing().copied() == key, "paired in flight");
            pairings += u64::from(logic.pairing().copied() != key);
            logic.telemeter(&mut outbox);
            asked = out.setpoint;
            check(&mut world, &out, before, logic.state(), &input, Some(arms), &settings);
            assert!(inbox.is_empty());
            if world.draw.one_in(3) {
                while let Some(message) = outbox.pop_front() {
                    // Everything it says can be sent.
                    encode(&Downlink { version: PROTOCOL_VERSION, message }).expect("it fits a frame");
                }
            }
        }
        ticks += world.ticks;
        capped += world.capped;
        for (sum, n) in states.iter_mut().zip(world.states) {
            *sum += n;
        }
    }
    report("requests", ticks, &states);
    println!("{capped} throttles under the bench's cap, {pairings} pairings");
    assert!(capped > 10_000 && pairings > 1000, "{capped} {pairings}");
    assert_eq!(ticks, LIVES * TICKS_EACH);
    // The lives are not all spent on the ground.
    let [boot, others @ ..] = states;
    assert!(others.iter().all(|n| *n > 500), "{states:?}");
    // Without a board nothing starts: the first tick leaves it.
    assert_eq!(boot, 0);
}

/// Bytes given to the whole vehicle: sound frames, frames damaged before or behind their checksum, noise.
#[test]
fn a_million_ticks_of_any_bytes() {
    const LIVES: u64 = 60;
    const TICKS_EACH: u64 = 20_000;
    let mut states = [0; FlightState::ALL.len()];
    let (mut ticks, mut heard, mut deaf) = (0, 0u64, 0u64);
    for life in 0..LIVES {
        // Of a paired vehicle's life not much is left to see.
        let may_pair = life % 4 == 3;
        let mut world = World::new(1000 + life);
        let mut vehicle: Vehicle<Record> =
            Vehicle::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 400]);
        vehicle.set_session(life as u32);
        let mut decoder = Decoder::new();
        let mut asked = Setpoint::default();
        let mut settings = Settings::DEFAULT;
        while world.ticks < TICKS_EACH {
            let input = world.input(&asked);
            let requests = if world.silent { 0 } else { world.draw.below(4) };
            for _ in 0..requests {
                let incident = vehicle.incident().map_or(0, |i| i.number);
                let mut request = world.draw.request(&mut world.sequence, incident);
                if matches!(request, Request::Pair(_)) && !may_pair {
                    request = Request::Heartbeat;
                }
                if let Request::WriteSettings(wanted) = request
                    && wanted.check().is_ok()
                {
                    // Its cap may come into force or not: the looser one is what is checked.
                    settings.bench_thrust_mps2 = settings.bench_thrust_mps2.max(wanted.bench_thrust_mps2);
                }
                let number = world.draw.bits() as u16;
                let heard_ms = world.heard_ms();
                let uplink = Uplink { version: PROTOCOL_VERSION, number, request, heard_ms };
                let frame = encode(&uplink).expect("it fits");
                let mut bytes = frame.as_bytes().to_vec();
                match world.draw.below(16) {
                    0 => {
                        bytes[world.draw.below(frame.as_bytes().len() as u64) as usize] ^=
                            world.draw.bits() as u8;
                    }
                    1 => bytes.truncate(world.draw.below(frame.as_bytes().len() as u64) as usize),
                    2 => bytes = (0..world.draw.below(600)).map(|_| world.draw.bits() as u8).collect(),
                    3 => {
                        let content: Vec<u8> =
                            (0..world.draw.below(60)).map(|_| world.draw.bits() as u8).collect();
                        bytes = framed(&content);
                    }
                    _ => {}
                }
                vehicle.receive(&bytes);
            }
            let (before, paired) = (vehicle.state(), vehicle.is_paired());
            let out = vehicle.tick(&input);
            asked = out.setpoint;
            // Nobody here has the key.
            assert!(before.motors_on() || !(paired && vehicle.state().motors_on()), "a stranger's motors");
            deaf += u64::from(paired);
            // What arms comes through the line: that is checked where requests are given directly.
            check(&mut world, &out, before, vehicle.state(), &input, Some(true), &settings);
            let mut room = [0; 600];
            let length = world.draw.below(600) as usize;
            let sent = vehicle.transmit(&mut room[..length]);
            assert!(sent <= length);
            for byte in &room[..sent] {
                if let Some(message) = decoder.push::<Downlink>(*byte) {
                    let message = message.expect("a sound frame").message;
                    heard += u64::from(matches!(message, Message::Reply { .. }));
                }
            }
            if let Some(job) = vehicle.job() {
                let _: Key = job.key;
            }
        }
        ticks += world.ticks;
        for (sum, n) in states.iter_mut().zip(world.states) {
            *sum += n;
        }
    }
    report("bytes", ticks, &states);
    assert_eq!(ticks, LIVES * TICKS_EACH);
    assert!(heard > 100_000, "{heard} answers");
    assert!(deaf > 50_000, "{deaf} ticks of a paired vehicle");
    assert!(
        states[FlightState::ALL.iter().position(|s| *s == FlightState::Tracking).expect("a state")] > 1000
    );
}

/// A frame around any content, its checksum valid.
fn framed(content: &[u8]) -> Vec<u8> {
    struct Raw<'a>(&'a [u8]);
    impl serde::Serialize for Raw<'_> {
        fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            use serde::ser::SerializeTuple;
            let mut tuple = serializer.serialize_tuple(self.0.len())?;
            for byte in self.0 {
                tuple.serialize_element(byte)?;
            }
            tuple.end()
        }
    }
    encode(&Raw(content)).expect("short enough").as_bytes().to_vec()
}

/// The same inputs give the same outputs, bit for bit.
#[test]
fn a_life_repeats_itself() {
    let live = |seed| {
        let mut world = World::new(seed);
        let mut logic: FlightLogic<Record> =
            FlightLogic::new(Some(VehicleConfig::REFERENCE), BOTH, vec![[0; RECORD_BYTES]; 400]);
        let mut outbox = Outbox::new();
        let mut asked = Setpoint::default();
        let mut sum = 0u32;
        for number in 0..20_000u16 {
            let input = world.input(&asked);
            let mut inbox = Inbox::new();
            let incident = logic.incident().map_or(0, |i| i.number);
            let request = world.draw.request(&mut world.sequence, incident);
            let heard_ms = world.heard_ms();
            inbox.push_back(Uplink { version: PROTOCOL_VERSION, number, request, heard_ms }).expect("room");
            let out = logic.tick(&input, &mut inbox, &mut outbox);
            logic.telemeter(&mut outbox);
            asked = out.setpoint;
            let mut text = format!("{sum} {out:?}");
            while let Some(message) = outbox.pop_front() {
                text += &format!("{message:?}");
            }
            sum = mintime_shared::crc32(text.as_bytes());
        }
        sum
    };
    assert_eq!(live(7), live(7));
    assert_ne!(live(7), live(8), "the sum sees the difference between lives");
}
