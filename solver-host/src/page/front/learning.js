// The learning curve: errors relative to their tolerances, and durations, flight by flight.

class LearningChart {
  constructor(parent, title, curves, { logarithmic, unit, line }) {
    Object.assign(this, { curves, logarithmic, line, width: 0, height: 0 });
    const box = html("div", {}, undefined, parent);
    html("h3", {}, title, box);
    this.svg = svg("svg", { role: "img", "aria-label": `${title}; the table below has the numbers` }, box);
    const legend = html("p", { class: "legend" }, undefined, box);
    this.says = curves.map((c) => html("b", {}, "", html("span", { class: `key c-${c.kind}` }, `${c.label} `, legend)));
    if (line) html("span", { class: "key dashed c-limit" }, "tolerance", legend);
    this.unit = unit;
    this.svg.addEventListener("pointermove", (event) => this.read(event.clientX));
    this.svg.addEventListener("pointerdown", (event) => this.read(event.clientX));
  }

  measure() {
    const { width, height } = this.svg.getBoundingClientRect();
    const changed = width !== this.width || height !== this.height;
    [this.width, this.height] = [width, height];
    return changed;
  }

  get count() { return page.learning.flights.length; }

  x(i) { return 50 + (this.count > 1 ? i / (this.count - 1) : 0.5) * (this.width - 66); }

  y(value) {
    const part = (this.mapped(value) - this.low) / (this.high - this.low);
    return this.height - 26 - part * (this.height - 36);
  }

  mapped(value) { return this.logarithmic ? Math.log10(Math.max(value, 1e-3)) : value; }

  draw() {
    if (this.width < 80) return;
    const values = this.curves.flatMap((c) => c.values).filter(Number.isFinite);
    const all = [...values, ...(this.line ? [this.line] : [])].map((v) => this.mapped(v));
    const [low, high] = all.length ? [Math.min(...all), Math.max(...all)] : [0, 1];
    const room = Math.max(0.08 * (high - low), 1e-4);
    [this.low, this.high] = [low - room, high + room];
    this.svg.replaceChildren();
    set(this.svg, { viewBox: `0 0 ${this.width} ${this.height}` });
    for (const { value, label } of this.ticks()) {
      const y = this.y(value);
      svg("line", { class: "grid", x1: 50, x2: this.width - 16, y1: y, y2: y }, this.svg);
      svg("text", { x: 44, y: y + 4, "text-anchor": "end" }, this.svg).textContent = label;
    }
    const every = Math.ceil(this.count / Math.max((this.width - 66) / 34, 1));
    page.learning.flights.forEach((flight, i) => {
      if (i % every === 0) svg("text", { x: this.x(i), y: this.height - 8, "text-anchor": "middle" }, this.svg).textContent = flight.label;
    });
    if (this.line) svg("line", { class: "limit", x1: 50, x2: this.width - 16, y1: this.y(this.line), y2: this.y(this.line) }, this.svg);
    for (const c of this.curves) {
      const known = c.values.map((v, i) => [v, i]).filter(([v]) => Number.isFinite(v));
      const points = known.map(([v, i]) => `${this.x(i).toFixed(1)},${this.y(v).toFixed(1)}`);
      svg("path", { class: `curve c-${c.kind}`, d: points.length ? `M${points.join("L")}` : "" }, this.svg);
      for (const [v, i] of known) svg("circle", { class: `dot c-${c.kind}`, r: 3.5, cx: this.x(i), cy: this.y(v) }, this.svg);
    }
    this.cursor = svg("line", { class: "cursor", y1: 10, y2: this.height - 26, visibility: "hidden" }, this.svg);
  }

  ticks() {
    if (!this.logarithmic) return ticks(this.low, this.high, 6);
    const decades = [];
    for (let power = Math.ceil(this.low); power <= Math.floor(this.high); power += 1) {
      decades.push({ value: 10 ** power, label: format(10 ** power, Math.max(0, -power)) });
    }
    return decades;
  }

  read(clientX) {
    const left = this.svg.getBoundingClientRect().left;
    const part = (clientX - left - 50) / (this.width - 66);
    const i = Math.min(Math.max(Math.round(part * (this.count - 1)), 0), this.count - 1);
    set(this.cursor, { x1: this.x(i), x2: this.x(i), visibility: "visible" });
    this.says.forEach((text, k) => { text.textContent = `${format(this.curves[k].values[i], 3)}${this.unit}`; });
  }

  show() {}
}

/** The charts of a learning curve; none without one. */
function learningCharts() {
  const { learning } = page;
  if (!learning || !learning.flights.length) return [];
  const place = document.getElementById("learning-plots");
  const kinds = ["m1", "m2", "m3", "m4", "plan", "limit"];
  const errors = learning.components.map(({ name, tolerance }, k) => ({
    label: name,
    kind: kinds[k % kinds.length],
    values: learning.flights.map(({ errors: e }) => (Number.isFinite(e[k]) ? Math.abs(e[k]) / tolerance : NaN)),
  }));
  const durations = [{ label: "T", kind: "plan", values: learning.flights.map((f) => (f.duration_s === null ? NaN : f.duration_s)) }];
  return [
    new LearningChart(place, "Error at the end over its tolerance", errors, { logarithmic: true, unit: "×", line: 1 }),
    new LearningChart(place, "Duration (s)", durations, { logarithmic: false, unit: " s" }),
  ];
}
