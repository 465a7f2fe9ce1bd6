// The flight's data, decoded, and what they say at a time.

const page = JSON.parse(document.getElementById("data").textContent);

/** Samples further apart than this are not joined, s. */
const GAP_S = 0.25;

/** Numbers from little-endian 32-bit floats in base64. */
function column(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true));
}

/** Columns by name; those of the motors as m1 to m4. */
function decoded(series) {
  if (!series) return null;
  const columns = {};
  for (const [name, value] of Object.entries(series)) {
    if (Array.isArray(value)) value.forEach((text, i) => { columns[`m${i + 1}`] = column(text); });
    else if (value !== null) columns[name] = column(value);
  }
  return columns;
}

const plan = decoded(page.plan);
// A maneuver that never began has no place on the flight's clock.
const sources = {
  plan: page.began ? plan : null,
  flight: page.flight.t ? decoded(page.flight) : null,
  cameras: decoded(page.cameras),
  record: decoded(page.record),
};

/** Index of the first number that is not below a value. */
function lowerBound(sorted, value) {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** A column's value at a time: between samples linear, or held; NaN outside and in gaps. */
function valueAt(series, name, t, held) {
  const times = series.t;
  const values = series[name];
  const after = lowerBound(times, t);
  if (after === times.length) return NaN;
  if (after === 0) return Math.abs(times[0] - t) < 1e-6 ? values[0] : NaN;
  const before = after - 1;
  const gap = times[after] - times[before];
  if (gap > GAP_S) return NaN;
  if (held && t < times[after]) return values[before];
  const part = gap > 0 ? (t - times[before]) / gap : 1;
  return values[before] + (values[after] - values[before]) * part;
}

/** All of the time that there is anything of. */
const whole = (() => {
  const span = { from: page.began ? 0 : Infinity, to: page.began ? page.duration_s : -Infinity };
  for (const { t } of Object.values(sources).filter((s) => s && s.t.length)) {
    span.from = Math.min(span.from, t[0]);
    span.to = Math.max(span.to, t[t.length - 1]);
  }
  return span.to > span.from ? span : { from: 0, to: Math.max(page.duration_s, 1) };
})();

/** The maneuver with a little of what is before and after it. */
const maneuver = page.began
  ? { from: Math.max(whole.from, -0.1), to: Math.min(whole.to, page.duration_s + 0.4) }
  : whole;

/** Segments with their times. */
const segments = (() => {
  let from = 0;
  return page.segments.map(({ inputs, duration }) => {
    const segment = { ...inputs, from, to: from + duration };
    from += duration;
    return segment;
  });
})();
const arcs = page.began ? segments.filter((s) => s.rate === "Singular") : [];

/** An SVG element. */
function svg(name, attributes, parent) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(element, attributes);
  if (parent) parent.append(element);
  return element;
}

function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
}

/** An HTML element with text. */
function html(name, attributes, text, parent) {
  const element = document.createElement(name);
  set(element, attributes);
  if (text !== undefined) element.textContent = text;
  if (parent) parent.append(element);
  return element;
}

/** Text in which `_` begins an index. */
function math(text, parent) {
  for (const [i, part] of text.split(/_(R|T)/).entries()) {
    if (i % 2) html("sub", {}, part, parent);
    else parent.append(part);
  }
}

/** Degrees in a radian: where a drawing is turned, and beside radians for those who think in them. */
const DEGREES = 180 / Math.PI;

/** A number with its unit. */
function quantity(value, digits, unit) {
  const gap = unit ? "\u202F" : "";
  return `${format(value, digits)}${gap}${unit}`;
}

/** A number with fixed digits and a true minus sign; a dash where there is none. */
function format(value, digits) {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}
