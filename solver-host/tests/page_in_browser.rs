//! The page in a browser: headless Chromium, from a telephone's width to a desk's, in light and dark.
//!
//! Ignored where nobody asks for it, because not every machine has a browser; `.ci/run` asks for it.
#![cfg(unix)]

mod browser;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use browser::Browser;
use mintime::flight::{Phase, Witness};
use mintime::flight_log::FlightLog;
use mintime::mission::{Flown, Mission, PlantChoice, Source, VehicleChoice, fly_mission, prepare};
use mintime::page::{self, Component, Learning, LearningFlight, Page, Sources};
use mintime::report::ReportData;
use mintime::solver::Turns;
use mintime_shared::model::{Limits, State};
use serde_json::Value;
use tempfile::TempDir;

/// Windows in pixels, and whether they are a telephone's.
const WINDOWS: [([u32; 2], bool); 4] =
    [([1440, 900], false), ([820, 1180], true), ([390, 844], true), ([360, 740], true)];

/// The page of a flight of the virtual board, flown once for all tests.
fn flown() -> &'static Path {
    static FLOWN: OnceLock<(TempDir, PathBuf)> = OnceLock::new();
    let (_, page) = FLOWN.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let output = Command::new(env!("CARGO_BIN_EXE_mintime"))
            .args(["fly", "--to", "5,5"])
            .current_dir(folder.path())
            .output()
            .expect("it starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let page = folder.path().join("flight.html");
        (folder, page)
    });
    page
}

/// A witness that looks away.
struct Unseen;

impl Witness for Unseen {
    fn phase(&mut self, _: Phase, _: f64) {}
    fn event(&mut self, _: f64, _: &str) {}
}

/// A short flight of the hosted vehicle.
fn short_flight() -> Flown {
    let (to, limits) = (State::at_rest(1.0, 0.5), Limits::TABLE_I);
    let source = Source::Solve { to, limits, turns: Turns::Any, heading_rad: 0.0 };
    let plant = PlantChoice::from_argument("ideal").expect("known");
    let mission = Mission { source, plant, seed: 1, room: None };
    let prepared = prepare(&mission.source, None).expect("solvable");
    fly_mission(&mission, prepared, &VehicleChoice::Hosted, &mut Unseen).expect("flown")
}

/// A page without a plan to compare with.
fn bare_page(flown: &Flown, learning: Option<Learning>) -> Page {
    let picture = ReportData {
        title: "A flight".to_owned(),
        subtitle: Vec::new(),
        planned: Vec::new(),
        flown: Vec::new(),
        segments: Vec::new(),
        limits: Limits::TABLE_I,
        facts: Vec::new(),
    };
    let log = FlightLog { samples: flown.trace.samples.clone(), ..FlightLog::default() };
    Page::collect(Sources { picture: &picture, log: &log, flown, learning })
}

/// Six flights of which one brought no error back.
fn learning() -> Learning {
    let component = |name: &str, unit: &str, tolerance| Component {
        name: name.to_owned(),
        unit: unit.to_owned(),
        tolerance,
    };
    let flight = |i: i32| LearningFlight {
        label: (i + 1).to_string(),
        errors: if i == 2 { Vec::new() } else { [1.2, 1.5, 0.06].map(|e: f64| e * 0.4_f64.powi(i)).to_vec() },
        duration_s: 1.41 + 0.02 * f64::from(i),
        note: if i == 2 { "aborted: the link was lost".to_owned() } else { String::new() },
    };
    Learning {
        components: vec![
            component("position", "m", 0.05),
            component("velocity", "m/s", 0.15),
            component("pitch", "rad", 0.05),
        ],
        flights: (0..6).map(flight).collect(),
        verdict: "Converged: the error came within the tolerances and stayed there.".to_owned(),
    }
}

/// Where to look at what was seen.
fn pictures() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("page");
    std::fs::create_dir_all(&folder).expect("writable");
    folder
}

/// Texts whose contrast with what is behind them is below WCAG's AA: 4.5, or 3 for large ones.
const TOO_PALE: &str = r#"(() => {
  const numbers = (text) => (text.match(/[\d.]+/g) || []).map(Number);
  const light = (text) => {
    const [r, g, b] = numbers(text).map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = getComputedStyle(at).backgroundColor;
      const [, , , alpha = 1] = numbers(colour);
      if (alpha === 1) return colour;
    }
    return 'rgb(255, 255, 255)';
  };
  const pale = [];
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
    const box = element.getBoundingClientRect();
    const onMark = element.matches('.phase-name');
    if (!own || box.width < 2 || box.height < 2 || onMark || element.closest('script, style, .skip')) continue;
    const style = getComputedStyle(element);
    const text = light(element instanceof SVGElement ? style.fill : style.color);
    const back = light(behind(element));
    const ratio = (Math.max(text, back) + 0.05) / (Math.min(text, back) + 0.05);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (large ? 3 : 4.5)) pale.push(`${ratio.toFixed(2)}: ${element.textContent.slice(0, 30)}`);
  }
  return pale;
})()"#;

/// Opens all that is folded, so that it is seen as well.
const UNFOLD: &str = "document.querySelectorAll('details').forEach((d) => { d.open = true; }); true";
const OVERFLOW: &str = "document.documentElement.scrollWidth - document.documentElement.clientWidth";
const SPAN: &str = "document.getElementById('scrub').max - document.getElementById('scrub').min";
const PLAYS: &str = "document.getElementById('play').getAttribute('aria-label')";

/// Middle and width of the first panel, in the window, pixels.
fn panel(browser: &mut Browser) -> ([f64; 2], f64) {
    let at = "(() => { const p = document.querySelector('.panel svg'); p.scrollIntoView({ block: 'center', behavior: 'instant' }); \
              const r = p.getBoundingClientRect(); return [r.left + r.width / 2, r.top + r.height / 2, r.width]; })()";
    let numbers: Vec<f64> = serde_json::from_value(browser.evaluate(at)).expect("numbers");
    ([numbers[0], numbers[1]], numbers[2])
}

#[test]
#[ignore = "needs Chromium: cargo test -p mintime --test page_in_browser -- --include-ignored"]
fn the_page_works_on_every_screen_in_light_and_dark() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = flown();
    let mut browser = Browser::start(&folder.path().join("profile"));
    for dark in [false, true] {
        for (size, phone) in WINDOWS {
            let which = format!("{size:?}, dark: {dark}");
            browser.window(size, phone, dark, false);
            assert_passes(&mut browser, page, size[0], &which);
            assert_eq!(
                browser.evaluate("document.documentElement.dataset.theme"),
                if dark { "dark" } else { "light" }
            );

            browser.evaluate(UNFOLD);
            assert_eq!(browser.evaluate(OVERFLOW), 0, "{which}: wider than its window");
            let pale = browser.evaluate(TOO_PALE);
            assert_eq!(pale, Value::Array(Vec::new()), "{which}");
            browser.evaluate("document.querySelector('h2').style.color = '#7a7a7a'; true");
            assert_eq!(
                browser.evaluate(TOO_PALE).as_array().map(Vec::len),
                Some(1),
                "{which}: a pale one is not seen"
            );
            assert!(browser.complaints.is_empty(), "{which}: {:?}", browser.complaints);
            let other: Vec<_> = browser.requests.iter().filter(|r| !r.contains("flight.html")).collect();
            assert!(other.is_empty(), "{which}: {other:?}");

            browser.open(page, "#t=0.9");
            let name = format!("{}-{}.png", size[0], if dark { "dark" } else { "light" });
            browser.screenshot(&pictures().join(name));
        }
    }
}

/// Opens a page and lets it check itself.
fn assert_passes(browser: &mut Browser, page: &Path, width: u32, which: &str) {
    browser.open(page, "#self-test");
    browser.wait_for("document.getElementById('self-test-result').textContent !== ''");
    let said = browser.evaluate("document.getElementById('self-test-result').textContent");
    let said = said.as_str().expect("text");
    let here = format!("{width} pixels");
    assert!(said.starts_with("self-test passed") && said.ends_with(&here), "{which}: {said}");
}

#[test]
#[ignore = "needs Chromium: cargo test -p mintime --test page_in_browser -- --include-ignored"]
fn a_learning_curve_and_a_flight_without_its_maneuver_are_shown_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut browser = Browser::start(&folder.path().join("profile"));
    let mut flown = short_flight();
    let file = folder.path().join("learned.html");
    page::write(&bare_page(&flown, Some(learning())), &file).expect("writable");
    for (size, phone) in [([1440, 900], false), ([360, 740], true)] {
        browser.window(size, phone, false, true);
        assert_passes(&mut browser, &file, size[0], "learned");
        browser.evaluate("document.getElementById('learning').scrollIntoView({ behavior: 'instant' })");
        browser.screenshot(&pictures().join(format!("{}-learning.png", size[0])));
    }
    // The second flight was 0.48 m off.
    let row = "document.querySelectorAll('.flights tbody tr')[1].children[1].textContent";
    assert_eq!(browser.evaluate(row), "0.4800");

    // It hovered and landed, and the gate never opened.
    (flown.trace.start_ns, flown.trace.start, flown.trace.end) = (None, None, None);
    let file = folder.path().join("hovered.html");
    page::write(&bare_page(&flown, None), &file).expect("writable");
    browser.window([390, 844], true, true, true);
    assert_passes(&mut browser, &file, 390, "hovered");
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

#[test]
#[ignore = "needs Chromium: cargo test -p mintime --test page_in_browser -- --include-ignored"]
fn fingers_mouse_and_keys_zoom_read_and_play() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = flown();
    let mut browser = Browser::start(&folder.path().join("profile"));

    // Two fingers spread over a panel show less time, a double tap all of it again.
    browser.window([390, 844], true, false, true);
    browser.open(page, "");
    let whole = browser.evaluate(SPAN).as_f64().expect("a span");
    let ([x, y], width) = panel(&mut browser);
    let apart = |by: f64| [[x - by, y], [x + by, y]];
    browser.touch(&[&apart(0.1 * width), &apart(0.15 * width), &apart(0.2 * width)]);
    browser.wait_for(&format!("Math.abs(({SPAN}) - {}) < {}", whole / 2.0, 0.02 * whole));
    browser.touch(&[&[[x, y]]]);
    browser.touch(&[&[[x, y]]]);
    browser.wait_for(&format!("Math.abs(({SPAN}) - {whole}) < 1e-6"));
    // One finger reads.
    let clock = "parseFloat(document.getElementById('clock').textContent)";
    browser.touch(&[&[[x - 0.2 * width, y]], &[[x - 0.15 * width, y]], &[[x + 0.2 * width, y]]]);
    browser.wait_for(&format!("{clock} > 0.8"));

    // The mouse chooses a span; the wheel scrolls the page unless Ctrl is held.
    browser.window([1440, 900], false, false, false);
    browser.open(page, "");
    browser.wait_for(&format!("{PLAYS} === 'Pause'"));
    let ([x, y], width) = panel(&mut browser);
    browser.drag([x, y], [x + 0.2 * width, y]);
    browser.wait_for(&format!("({SPAN}) < {}", 0.3 * whole));
    browser.press("Escape");
    browser.evaluate("document.querySelector('.panel svg').focus()");
    browser.press("Escape");
    browser.wait_for(&format!("Math.abs(({SPAN}) - {whole}) < 1e-6"));
    browser.evaluate("document.activeElement.blur()");

    // Space plays and pauses; a tenth of the speed is a tenth of the speed.
    browser.wait_for(&format!("{PLAYS} === 'Play'"));
    browser.evaluate("document.getElementById('speed').value = '0.1'");
    browser.press("Space");
    browser.wait_for(&format!("{PLAYS} === 'Pause' && Math.abs({clock}) < 0.5"));
    let passed = "new Promise((done) => { const t = () => parseFloat(document.getElementById('clock').textContent.replace('−', '-')); \
                  const [from, since] = [t(), performance.now()]; \
                  setTimeout(() => done((t() - from) / ((performance.now() - since) / 1000)), 800); })";
    let speed = browser.evaluate(passed).as_f64().expect("a speed");
    // A busy machine skips frames and is slower then; it is never faster.
    assert!((0.01..0.12).contains(&speed), "{speed}");
    browser.press("Space");
    browser.wait_for(&format!("{PLAYS} === 'Play'"));
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

#[test]
#[ignore = "needs Chromium: cargo test -p mintime --test page_in_browser -- --include-ignored"]
fn nothing_moves_where_motion_is_unwelcome_and_the_numbers_need_no_script() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = flown();
    let mut browser = Browser::start(&folder.path().join("profile"));
    browser.window([1440, 900], false, false, true);
    browser.open(page, "");
    assert_eq!(browser.evaluate(PLAYS), "Play");

    browser.call("Emulation.setScriptExecutionDisabled", &serde_json::json!({ "value": true }));
    browser.window([360, 740], true, false, true);
    browser.open(page, "");
    let seen = browser.evaluate("document.body.innerText");
    let seen = seen.as_str().expect("text");
    for number in ["1.4112 s", "verified", "H = 0", "0.051025 s", "gyro to motors", "taking off"] {
        assert!(seen.contains(number), "{number} is not seen without a script");
    }
    assert!(!seen.contains("Whole flight"), "buttons without a script");
    assert_eq!(browser.evaluate(OVERFLOW), 0);
}
