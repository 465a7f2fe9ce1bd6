//! One motor after the other, propellers off.

use std::error::Error;
use std::io::BufRead as _;

use clap::Args;
use mintime_shared::messages::{FlightState, MOTOR_TEST_MS_MAX, MOTOR_TEST_THROTTLE_MAX, Purpose, Request};
use serde_json::json;

use super::{Bench, Said};

/// What a person has to type.
const SENTENCE: &str = "props are off";
/// Where each motor is, in the order of the frames' definition.
const PLACES: [&str; 4] = ["rear right", "front right", "rear left", "front left"];
/// Between two motors, s.
const PAUSE_S: f64 = 0.7;

/// Arguments of `test-motors`.
#[derive(Args)]
#[command(
    after_help = "Take all propellers off, fix the vehicle, keep fingers away. You are asked to type \"props are off\". Each \
                  motor turns by itself; any other motor than the one named, or the wrong direction, must be put right \
                  before you fly (`params --set outputs=[…]`, or swap two motor wires)."
)]
pub(super) struct TestMotors {
    /// Only this motor, 1 to 4: rear right, front right, rear left, front left
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=4))]
    motor: Option<u8>,
    /// Throttle, 0 to 0.15
    #[arg(long, default_value_t = 0.06)]
    throttle: f32,
    /// How long each turns, s; at most 2
    #[arg(long, value_name = "S", default_value_t = 1.0)]
    seconds: f32,
}

impl TestMotors {
    pub(super) fn run(&self, bench: &mut Bench) -> Said {
        if !(0.0..=MOTOR_TEST_THROTTLE_MAX).contains(&self.throttle) {
            return Err(format!("--throttle must be between 0 and {MOTOR_TEST_THROTTLE_MAX}").into());
        }
        let longest_s = f32::from(MOTOR_TEST_MS_MAX) * 1e-3;
        if !(self.seconds > 0.0 && self.seconds <= longest_s) {
            return Err(format!("--seconds must be between 0 and {longest_s}").into());
        }
        confirm()?;
        bench.tell("arming for the motor test", Request::Arm(Purpose::MotorTest))?;
        let result = self.turn(bench);
        // Whatever happened; the vehicle's own timeouts stand behind this.
        let disarmed = bench.tell("disarming", Request::Disarm);
        let turned = result?;
        disarmed?;
        let names: Vec<_> = turned.iter().map(|m| PLACES[usize::from(*m)]).collect();
        let text =
            format!("turned: {}. Was it that motor each time, and the right way round?", names.join(", "));
        Ok((
            json!({ "turned": turned.iter().map(|m| m + 1).collect::<Vec<_>>(), "throttle": self.throttle }),
            text,
        ))
    }

    fn turn(&self, bench: &mut Bench) -> Result<Vec<u8>, Box<dyn Error>> {
        let motors = match self.motor {
            Some(motor) => vec![motor - 1],
            None => vec![0, 1, 2, 3],
        };
        let duration_ms = (self.seconds * 1e3) as u16;
        for &motor in &motors {
            eprintln!("mintime: motor {}, {}", motor + 1, PLACES[usize::from(motor)]);
            let request = Request::TestMotor { motor, throttle: self.throttle, duration_ms };
            bench.tell("turning a motor", request)?;
            bench.listen(f64::from(self.seconds) + PAUSE_S)?;
            let state = bench.status()?.state;
            if state != FlightState::Armed {
                return Err(format!("the vehicle is {state:?} now: see `status`").into());
            }
        }
        Ok(motors)
    }
}

/// Asks a person.
fn confirm() -> Result<(), Box<dyn Error>> {
    eprintln!("mintime: the motors are going to turn. Take every propeller off, then type: {SENTENCE}");
    let mut line = String::new();
    std::io::stdin().lock().read_line(&mut line)?;
    if line.trim() == SENTENCE {
        return Ok(());
    }
    Err(format!("no motor was turned: that was not \"{SENTENCE}\"").into())
}
