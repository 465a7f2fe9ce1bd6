//! The parts of the page that need no script: everything that is a table.

use mintime_shared::model::{RateMode, ThrustLevel};

use super::bytes::GROUPS;
use super::certificate::{Law, Laws};
use super::data::{Fact, Kind, Page};
use super::html::{Html, escape, number};
use super::learning::Learning;

/// The section of a placeholder; nothing for one that is not known.
pub(super) fn render(section: &str, page: &Page) -> String {
    let mut html = Html::default();
    match section {
        "heading" => heading(&mut html, page),
        "facts" => definitions(&mut html, &page.facts),
        "certificate" => match &page.certificate {
            Some(laws) => certificate(&mut html, laws, page.duration_s),
            None if page.origin == "learned" => {
                html.element(
                    "p",
                    "A learned table has none. Its durations make up for drag, lag and whatever else the planning model does not \
                     know: in the model it misses its end, to reach it in the world.",
                );
            }
            None => {
                html.element(
                    "p",
                    "This table came from a file, with no extremal behind it. `mintime verify FILE` replays it and solves its \
                     request again.",
                );
            }
        },
        "switching" => switching(&mut html, page),
        "bytes" => bytes(&mut html, page),
        "timings" => timings(&mut html, page),
        "counters" => counters(&mut html, page),
        "events" => events(&mut html, page),
        "identity" => definitions(&mut html, &page.identity),
        "learning" => {
            if let Some(learning) = &page.learning {
                learned(&mut html, learning);
            }
        }
        _ => {}
    }
    html.into_text()
}

fn heading(html: &mut Html, page: &Page) {
    let class = if page.success { "good" } else { "bad" };
    let mark = if page.success { "✓" } else { "✗" };
    html.element("h1", &page.title);
    html.raw("<p class=\"outcome\">")
        .element(&format!("span class=\"badge {class}\""), &format!("{mark} {}", page.outcome));
    if let Some(first) = page.subtitle.first() {
        // The picture says here how it went, too.
        let said = format!(": {}", page.outcome);
        html.raw(" ").element("span", first.strip_suffix(&said).unwrap_or(first));
    }
    html.raw("</p>");
    if let Some(reason) = &page.reason {
        html.element("p class=\"reason\"", reason);
    }
}

fn definitions(html: &mut Html, facts: &[Fact]) {
    html.raw("<dl>");
    for fact in facts {
        html.raw("<div>").math("dt", &fact.label).element("dd", &fact.value).raw("</div>");
    }
    html.raw("</dl>");
}

fn certificate(html: &mut Html, laws: &Laws, duration_s: f64) {
    let verdict = if laws.verified {
        "All laws hold: this maneuver satisfies Pontryagin's minimum principle. Checked by an integrator that shares no formula with the solver."
    } else {
        "Not every law holds: this maneuver is not verified."
    };
    html.element("p", verdict);
    if laws.degenerate {
        html.element(
            "p",
            "Degenerate: it begins or ends on a singular arc, or its multiplier is nearly abnormal, so the costate is not unique.",
        );
    }
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Laws of the minimum principle\"><table class=\"laws\">");
    html.heads(&["", "law", "found", "allowed", "what it says"]).raw("<tbody>");
    for law in &laws.laws {
        let (class, mark, word) = if law.holds { ("good", "✓", "holds") } else { ("bad", "✗", "broken") };
        html.raw("<tr>");
        html.element(&format!("td class=\"mark {class}\" title=\"{word}\""), mark);
        html.element("th scope=\"row\"", law.name);
        html.element("td class=\"number\"", &quantity(law.found, law.unit));
        html.element("td class=\"number\"", &bound(law));
        html.math("td", law.says).raw("</tr>");
    }
    html.raw("</tbody></table></div>");
    let [c1, c2, c3, c4] = laws.costate.map(|c| format!("{c:+.9}").replace('-', "−"));
    let mut facts = vec![
        Fact::new("costate c₁, c₂", format!("{c1}, {c2}")),
        Fact::new("costate c₃, c₄", format!("{c3}, {c4}")),
        Fact::new("Φ_R at the start", format!("{:+.9}", laws.phi_r0).replace('-', "−")),
        Fact::new("duration T", format!("{duration_s:.9} s")),
        Fact::new("no maneuver is faster than", format!("{:.6} s", laws.lower_bound_s)),
    ];
    facts.extend(laws.others.iter().map(|(turns, s)| {
        let turns = turns.to_string().replace('-', "−");
        Fact::new(&format!("fastest with {turns} full turns"), format!("{s:.6} s"))
    }));
    definitions(html, &facts);
}

fn quantity(value: f64, unit: &str) -> String {
    format!("{} {unit}", number(value)).trim_end().to_owned()
}

fn bound(law: &Law) -> String {
    match (law.at_least, law.bound) {
        (true, 0.0) => "> 0".to_owned(),
        (true, bound) => format!("≥ {}", quantity(bound, law.unit)),
        (false, bound) => format!("≤ {}", quantity(bound, law.unit)),
    }
}

fn switching(html: &mut Html, page: &Page) {
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Switching times\"><table class=\"switching\">");
    html.heads(&["", "from", "for", "pitch rate", "thrust"]).raw("<tbody>");
    let mut t_s = 0.0;
    let limits = &page.limits;
    for (i, segment) in page.segments.iter().enumerate() {
        let rate = match segment.inputs.rate {
            RateMode::Plus => format!("+{} rad/s", limits.rate_max_radps),
            RateMode::Minus => format!("−{} rad/s", limits.rate_max_radps),
            RateMode::Singular => "singular arc".to_owned(),
        };
        let thrust = match segment.inputs.thrust {
            ThrustLevel::Min => format!("lowest, {} m/s²", limits.thrust_min_mps2),
            ThrustLevel::Max => format!("highest, {} m/s²", limits.thrust_max_mps2),
        };
        html.raw(format_args!("<tr data-t=\"{t_s}\">"));
        html.element("th scope=\"row\"", &(i + 1).to_string());
        html.element("td class=\"number\"", &format!("{t_s:.6} s"));
        html.element("td class=\"number\"", &format!("{:.6} s", segment.duration));
        html.element("td", &rate).element("td", &thrust).raw("</tr>");
        t_s += segment.duration;
    }
    html.raw("</tbody></table></div>");
}

fn bytes(html: &mut Html, page: &Page) {
    let table = &page.table;
    html.raw("<div class=\"hex\" role=\"img\" aria-label=\"The table's bytes; each field is explained in the table below\">");
    for (i, field) in table.fields.iter().enumerate() {
        let hex = |at: usize| table.hex.get(2 * at..2 * at + 2).unwrap_or_default();
        for at in field.offset..field.offset + field.length {
            let group = field.group;
            html.element(&format!("span class=\"byte g{group}\" data-field=\"{i}\""), hex(at));
        }
    }
    html.raw("</div><p class=\"legend\">");
    for (i, name) in GROUPS.iter().enumerate() {
        html.element(&format!("span class=\"key area c-g{i}\""), name);
    }
    html.raw("</p><p id=\"field\" class=\"field\" aria-live=\"polite\">Point at a byte, or at a row, to see what it is.</p>");
    html.raw("<details><summary>").raw(format_args!("All {} fields", table.fields.len())).raw("</summary>");
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Fields of the table\"><table class=\"fields\">");
    html.heads(&["at", "bytes", "field", "value", "meaning"]).raw("<tbody>");
    for (i, field) in table.fields.iter().enumerate() {
        let hex = table.hex.get(2 * field.offset..2 * (field.offset + field.length)).unwrap_or_default();
        html.raw(format_args!("<tr data-field=\"{i}\">"));
        html.element("td class=\"number\"", &field.offset.to_string());
        html.raw(format_args!("<td><code class=\"g{}\">{}</code></td>", field.group, escape(hex)));
        html.element("th scope=\"row\"", &field.name);
        html.element("td", &field.value).element("td", field.meaning).raw("</tr>");
    }
    html.raw("</tbody></table></div></details>");
}

fn timings(html: &mut Html, page: &Page) {
    if page.timings.is_empty() {
        html.element(
            "p",
            "Not measured: the flight logic ran in the host's process, on no flight controller.",
        );
        return;
    }
    let emulated = page.timings.iter().any(|t| t.emulated);
    html.element(
        "p",
        if emulated {
            "Emulated, not measured on silicon. A pair is [optimistic, pessimistic]: with the fastest and the slowest \
             processor that the documentation allows."
        } else {
            "As the flight controller measures itself."
        },
    );
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Timings\"><table class=\"timings\">");
    html.heads(&["what", "how much", "meaning"]).raw("<tbody>");
    for timing in &page.timings {
        let [low, high] = timing.range.map(|v| {
            let digits = timing.digits;
            if v.is_finite() { format!("{v:.digits$}") } else { "–".to_owned() }
        });
        let range = if timing.range[0].to_bits() == timing.range[1].to_bits() {
            format!("{high} {}", timing.unit)
        } else {
            format!("[{low}, {high}] {}", timing.unit)
        };
        html.raw("<tr>").element("th scope=\"row\"", timing.label);
        html.element("td class=\"number\"", range.trim_end()).element("td", timing.meaning).raw("</tr>");
    }
    html.raw("</tbody></table></div>");
}

fn counters(html: &mut Html, page: &Page) {
    if page.counters.is_empty() {
        html.element("p", "Nothing was counted: the flight brought nothing back.");
        return;
    }
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Faults\"><table class=\"counters\">");
    html.heads(&["", "what", "how often"]).raw("<tbody>");
    for counter in &page.counters {
        let (class, mark) = if counter.count == 0 { ("good", "✓") } else { ("warn", "!") };
        let of = if counter.of > 0 { format!(" of {}", counter.of) } else { String::new() };
        html.raw("<tr>").element(&format!("td class=\"mark {class}\""), mark);
        html.element("th scope=\"row\"", counter.label);
        html.element("td class=\"number\"", &format!("{}{of}", counter.count)).raw("</tr>");
    }
    html.raw("</tbody></table></div>");
}

fn events(html: &mut Html, page: &Page) {
    let (firmware, host): (Vec<_>, Vec<_>) = page.events.iter().partition(|e| e.kind == Kind::Firmware);
    let list = |html: &mut Html, events: &[&super::data::Moment]| {
        html.raw("<ol class=\"events\">");
        for event in events {
            let class = match event.kind {
                Kind::Info => "info",
                Kind::Firmware => "firmware",
                Kind::Warning => "warning",
                Kind::Error => "error",
            };
            let time = format!("{:+.3} s", event.t_s).replace('-', "−");
            html.raw(format_args!("<li class=\"{class}\" data-t=\"{}\">", event.t_s));
            html.element("time", &time).raw(" ").element("span", &event.text).raw("</li>");
        }
        html.raw("</ol>");
    };
    list(html, &host);
    if !firmware.is_empty() {
        html.raw(format_args!("<details><summary>The firmware's log, {} lines</summary>", firmware.len()));
        list(html, &firmware);
        html.raw("</details>");
    }
}

fn learned(html: &mut Html, learning: &Learning) {
    html.raw("<section id=\"learning\" class=\"wide\" aria-labelledby=\"learning-title\">");
    html.element("h2 id=\"learning-title\"", "Learning curve");
    html.element("p", &learning.verdict);
    html.raw("<div id=\"learning-plots\"></div>");
    html.raw("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Flights\"><table class=\"flights\"><thead><tr>");
    html.element("th scope=\"col\"", "flight");
    for component in &learning.components {
        let head = format!("{} (±{} {})", component.name, component.tolerance, component.unit);
        html.element("th scope=\"col\"", &head);
    }
    html.element("th scope=\"col\"", "T (s)").element("th scope=\"col\"", "").raw("</tr></thead><tbody>");
    for flight in &learning.flights {
        html.raw("<tr>").element("th scope=\"row\"", &flight.label);
        for (i, component) in learning.components.iter().enumerate() {
            let error = flight.errors.get(i).copied().unwrap_or(f64::NAN);
            let class = if error.abs() <= component.tolerance { "number good" } else { "number" };
            html.element(&format!("td class=\"{class}\""), &number(error));
        }
        html.element("td class=\"number\"", &format!("{:.4}", flight.duration_s));
        html.element("td", &flight.note).raw("</tr>");
    }
    html.raw("</tbody></table></div></section>");
}
