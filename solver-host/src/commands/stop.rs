//! `mintime stop PORT`: motors off, now.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::Args;
use mintime::flight::Client;
use mintime::vehicle::{Link as _, PortLink, read_key};
use mintime_shared::messages::{FlightState, Reply, Request};
use serde_json::json;

use super::vehicle::{PORT_HELP, report};

/// Between two emergency stops, s.
const PERIOD_S: f64 = 0.02;

/// Arguments of `mintime stop`.
#[derive(Args)]
#[command(
    after_help = "Whatever flies falls. Another program that has the serial port open must be ended first; ending it makes the \
                  vehicle level, descend and switch off by itself. The kill switch works in any case."
)]
pub(crate) struct Stop {
    #[arg(help = PORT_HELP)]
    port: String,
    /// Emergency stops to send, at most
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    tries: u32,
    /// The pairing key, where the vehicle is paired
    #[arg(long, value_name = "FILE")]
    key: Option<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl Stop {
    pub(crate) fn run(&self) -> ExitCode {
        report(self.json, self.stop())
    }

    fn stop(&self) -> Result<(serde_json::Value, String), Box<dyn Error>> {
        let key = self.key.as_deref().map(read_key).transpose()?;
        let mut link = PortLink::open(&self.port)?;
        let mut client = Client::with_key(key).numbered_anew();
        let mut said = None;
        for number in 1..=self.tries {
            // A paired vehicle says its session only when asked who it is; nobody else is kept waiting for that.
            let identify = key.is_some() && !client.knows_session();
            let request = if identify { Request::Identify } else { Request::EmergencyStop };
            let now_s = link.now_s();
            // Under one number, so that on a slow line the answer to an earlier try counts.
            let sent = if client.is_waiting_for(&request) {
                client.insist(&mut link, now_s)
            } else {
                client.ask(&mut link, request, now_s)
            };
            // A line that fails now may carry the next one.
            if let Err(error) = sent {
                said = Some(error.to_string());
            }
            let until_s = now_s + PERIOD_S;
            while link.now_s() < until_s {
                if let Err(error) = link.wait(until_s - link.now_s()) {
                    said = Some(error.to_string());
                    std::thread::sleep(Duration::from_secs_f64(PERIOD_S));
                    break;
                }
                let now_s = link.now_s();
                let answer = client.poll(&mut link, now_s);
                let off = client.telemetry().is_some_and(|t| t.state == FlightState::Terminated);
                match answer {
                    Ok(Some(Reply::Done)) if !identify => return Ok(confirmed(number, "answered")),
                    Ok(Some(_)) => break,
                    _ if off => return Ok(confirmed(number, "reports it")),
                    Ok(None) => {}
                    Err(error) => {
                        said = Some(error.to_string());
                        break;
                    }
                }
            }
        }
        let reason = said.unwrap_or_else(|| "the vehicle does not answer".to_owned());
        Err(format!(
            "not confirmed (tries: {}): {reason}; use the kill switch, or take the power away from a distance",
            self.tries
        )
        .into())
    }
}

fn confirmed(tries: u32, how: &str) -> (serde_json::Value, String) {
    let text = format!(
        "stopped: the vehicle {how} (tries: {tries}). Its motors stay off until `mintime vehicle PORT acknowledge`"
    );
    (json!({ "stopped": true, "tries": tries }), text)
}
