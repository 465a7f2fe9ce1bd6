//! `mintime figures`: the paper's figures and the map, as pictures and as numbers.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser as _};
use mintime::figures::{Drawn, Figure};
use mintime::flight_log::OutputError;

use super::print;

/// Arguments of `mintime figures`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  mintime figures -o figures\n  mintime figures -o figures --only fig5,map --json"
)]
pub(crate) struct Figures {
    /// Folder to write NAME.svg, NAME.png and NAME.csv of each figure to; made where it does not exist, files of these
    /// names are replaced
    #[arg(short = 'o', long = "output", value_name = "DIR")]
    output: PathBuf,
    /// Only these figures
    #[arg(long, value_name = "NAME", value_delimiter = ',',
          value_parser = PossibleValuesParser::new(Figure::ALL.map(Figure::name)).try_map(|name| by_name(&name)))]
    only: Vec<Figure>,
    /// Print files and key numbers as JSON
    #[arg(long)]
    json: bool,
}

/// The figure of a name.
fn by_name(name: &str) -> Result<Figure, String> {
    let found = Figure::ALL.into_iter().find(|figure| figure.name() == name);
    found.ok_or_else(|| format!("there is no figure `{name}`"))
}

impl Figures {
    pub(crate) fn run(self) -> ExitCode {
        self.write().map_or_else(
            |error| {
                if self.json {
                    print(&serde_json::json!({ "error": error.to_string() }).to_string());
                }
                eprintln!("mintime: {error}");
                ExitCode::FAILURE
            },
            |()| ExitCode::SUCCESS,
        )
    }

    fn write(&self) -> Result<(), Box<dyn Error>> {
        self.prepare_folder()?;
        let chosen: Vec<Figure> =
            Figure::ALL.into_iter().filter(|f| self.only.is_empty() || self.only.contains(f)).collect();
        let mut summaries = Vec::new();
        for figure in chosen {
            let clock = Instant::now();
            let drawn = figure.draw()?;
            let files = drawn.write(&self.output)?;
            let wall_time_s = clock.elapsed().as_secs_f64();
            if self.json {
                summaries.push(summary(&drawn, &files, wall_time_s));
            } else {
                print(&text(&drawn, &files, wall_time_s));
            }
        }
        if self.json {
            print(&format!("{:#}", serde_json::json!({ "figures": summaries })));
        }
        Ok(())
    }

    /// Everything that can be refused is refused before anything is computed.
    fn prepare_folder(&self) -> Result<(), Box<dyn Error>> {
        let folder = &self.output;
        if folder.exists() && !folder.is_dir() {
            return Err(format!("{} is no folder: give the name of one", folder.display()).into());
        }
        std::fs::create_dir_all(folder).map_err(|error| {
            format!("the folder {} cannot be made ({error}): choose another", folder.display())
        })?;
        mintime::flight_log::check_writable(&folder.join("fig1.csv")).map_err(|error| match error {
            OutputError::FolderNotWritable { folder, source, .. } => {
                format!(
                    "no file can be created in the folder {} ({source}): choose another",
                    folder.display()
                )
            }
            other => other.to_string(),
        })?;
        Ok(())
    }
}

fn summary(drawn: &Drawn, files: &[PathBuf], wall_time_s: f64) -> serde_json::Value {
    let numbers: Vec<_> = drawn
        .numbers()
        .iter()
        .map(|n| serde_json::json!({ "what": n.what, "value": n.value, "unit": n.unit }))
        .collect();
    serde_json::json!({
        "name": drawn.figure().name(),
        "title": drawn.title(),
        "files": files,
        "numbers": numbers,
        "wall_time_s": wall_time_s,
    })
}

fn text(drawn: &Drawn, files: &[PathBuf], wall_time_s: f64) -> String {
    let mut lines = vec![format!("{:<8} {} ({wall_time_s:.2} s)", drawn.figure().name(), drawn.title())];
    lines.extend(drawn.numbers().iter().map(|n| format!("         {n}").trim_end().to_owned()));
    lines.extend(files.iter().map(|f| format!("wrote    {}", f.display())));
    lines.join("\n")
}
