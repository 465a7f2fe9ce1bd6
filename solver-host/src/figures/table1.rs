//! Table I: the parameters of the model, and what follows from them.

use mintime_shared::model::Limits;

use super::{Content, Number};
use crate::drawing::csv::Csv;
use crate::drawing::page;
use crate::drawing::style::{FRAME, INK, MARGIN, MUTED, TEXT_SIZE};
use crate::drawing::svg::{Svg, TextStyle};

const WIDTH: f64 = 860.0;
const ROW: f64 = 34.0;
const COLUMNS: [f64; 3] = [MARGIN, MARGIN + 150.0, MARGIN + 330.0];

struct Row {
    symbol: &'static str,
    value: f64,
    unit: &'static str,
    description: &'static str,
}

/// The paper's three parameters, and gravity, the two dimensionless ones and the scales of eq. (3).
fn rows() -> Vec<Row> {
    let limits = Limits::TABLE_I;
    let (u, scale) = (limits.dimensionless(), limits.scale());
    let row = |symbol, value, unit, description| Row { symbol, value, unit, description };
    vec![
        row("F_{min}/m", limits.thrust_min_mps2, "m/s²", "minimum mass-normalised thrust"),
        row("F_{max}/m", limits.thrust_max_mps2, "m/s²", "maximum mass-normalised thrust"),
        row("ω_{max}", limits.rate_max_radps, "rad/s", "maximum rotational rate"),
        row("g", limits.gravity_mps2, "m/s²", "gravity; the paper does not say which value it used"),
        row("U_{min}", u.min, "", "F_{min}/(m g), eq. (5)"),
        row("U_{max}", u.max, "", "F_{max}/(m g), eq. (5)"),
        row("1/ω_{max}", scale.time_s, "s", "unit of time, eq. (3)"),
        row("g/ω_{max}²", scale.length_m, "m", "unit of length, eq. (3)"),
    ]
}

/// The paper's own rows stand above the line.
const OF_THE_PAPER: usize = 3;

pub(super) fn draw() -> Content {
    let title = "Table I: numerical parameters of the quadrotor model";
    let mut svg = Svg::default();
    let lines =
        ["Above the line Table I of the paper; below it what else every figure here rests on.".to_owned()];
    let mut y = page::heading(&mut svg, WIDTH, title, &lines) + 44.0;
    let rule = |svg: &mut Svg, y: f64, width: f64| {
        let style = format!(r#"stroke="{INK}" stroke-width="{width}""#);
        svg.line((MARGIN, y), (WIDTH - MARGIN, y), &style);
    };
    rule(&mut svg, y - 26.0, 1.6);
    for (x, text) in COLUMNS.into_iter().zip(["parameter", "value", "description"]) {
        svg.text((x, y), text, TextStyle::new(TEXT_SIZE, MUTED).bold());
    }
    rule(&mut svg, y + 12.0, 1.0);
    let mut csv = Csv::new("parameter,value,unit,description");
    for (i, row) in rows().iter().enumerate() {
        y += ROW;
        let value = format!("{:.6}", row.value);
        let value = format!("{} {}", value.trim_end_matches('0').trim_end_matches('.'), row.unit);
        svg.text((COLUMNS[0], y), row.symbol, TextStyle::new(TEXT_SIZE, INK).bold());
        svg.text((COLUMNS[1], y), value.trim_end(), TextStyle::new(TEXT_SIZE, INK));
        svg.text((COLUMNS[2], y), row.description, TextStyle::new(TEXT_SIZE, INK));
        if i + 1 == OF_THE_PAPER {
            let style = format!(r#"stroke="{FRAME}" stroke-width="1""#);
            svg.line((MARGIN, y + 12.0), (WIDTH - MARGIN, y + 12.0), &style);
        }
        let plain = |text: &str| text.replace(['{', '}'], "").replace(',', ";");
        csv.row([&plain(row.symbol), &row.value, &row.unit, &plain(row.description)]);
    }
    rule(&mut svg, y + 12.0, 1.6);
    let numbers =
        rows().iter().map(|r| Number::new(r.symbol.replace(['{', '}'], ""), r.value, r.unit)).collect();
    Content {
        title: title.to_owned(),
        svg: page::document(WIDTH, y + 12.0 + MARGIN, title, &lines[0], svg),
        tables: vec![("", csv.finish())],
        numbers,
    }
}
