// One panel: its curves over the shown time, and their values at the cursor.

const MARGIN = { left: 46, right: 8, top: 6, bottom: 20 };

class Plot {
  constructor(panel, parent) {
    this.panel = panel;
    const box = html("div", { class: "panel", "data-panel": panel.id }, undefined, parent);
    const title = html("h3", {}, undefined, box);
    math(panel.title, title);
    if (panel.unit) html("span", {}, ` (${panel.unit})`, title);
    const legend = html("div", { class: "legend" }, undefined, box);
    const names = panel.curves.map((c) => c.label).join(", ");
    const name = `${panel.title}: ${names}. Arrow keys move the cursor, plus and minus zoom, Escape resets.`;
    this.svg = svg("svg", { tabindex: 0, role: "img", "aria-label": name }, box);
    this.back = svg("g", {}, this.svg);
    const clip = svg("clipPath", { id: `clip-${panel.id}` }, this.svg);
    this.clip = svg("rect", {}, clip);
    const curves = svg("g", { "clip-path": `url(#clip-${panel.id})` }, this.svg);
    this.curves = panel.curves.map((c) => ({
      ...c,
      path: svg("path", { class: `curve ${c.kind} c-${c.kind}` }, curves),
      value: html("b", {}, "–", html("span", { class: `key c-${c.kind}` }, `${c.label} `, legend)),
    }));
    this.selection = svg("rect", { class: "selection", visibility: "hidden" }, this.svg);
    this.cursor = svg("line", { class: "cursor" }, this.svg);
    for (const c of this.curves) c.dot = svg("circle", { class: `dot c-${c.kind}`, r: 4 }, this.svg);
    this.width = 0;
    this.height = 0;
  }

  /** Whether its size has changed. */
  measure() {
    const { width, height } = this.svg.getBoundingClientRect();
    const changed = width !== this.width || height !== this.height;
    [this.width, this.height] = [width, height];
    return changed;
  }

  x(t) {
    const inner = this.width - MARGIN.left - MARGIN.right;
    return MARGIN.left + ((t - this.view.from) / (this.view.to - this.view.from)) * inner;
  }

  y(value) {
    const inner = this.height - MARGIN.top - MARGIN.bottom;
    return this.height - MARGIN.bottom - ((value - this.low) / (this.high - this.low)) * inner;
  }

  /** The time under a place on the screen. */
  timeAt(clientX) {
    const part = (clientX - this.svg.getBoundingClientRect().left - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right);
    return this.view.from + Math.min(Math.max(part, 0), 1) * (this.view.to - this.view.from);
  }

  draw(view) {
    this.view = view;
    if (this.width < 80) return;
    this.scale();
    const { panel, back, width, height } = this;
    const [left, right, top, bottom] = [MARGIN.left, width - MARGIN.right, MARGIN.top, height - MARGIN.bottom];
    set(this.svg, { viewBox: `0 0 ${width} ${height}` });
    const frame = { x: left, y: top, width: right - left, height: bottom - top };
    set(this.clip, frame);
    back.replaceChildren();
    const inside = (t) => Math.min(Math.max(this.x(t), left), right);
    for (const arc of arcs) {
      const [from, to] = [inside(arc.from), inside(arc.to)];
      if (to > from) svg("rect", { class: "singular", x: from, y: top, width: to - from, height: bottom - top }, back);
    }
    for (const { value, label } of ticks(view.from, view.to, (right - left) / 62)) {
      const x = this.x(value);
      svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }, back);
      const anchor = x > right - 14 ? "end" : "middle";
      svg("text", { x, y: bottom + 15, "text-anchor": anchor }, back).textContent = label;
    }
    for (const { value, label } of ticks(this.low, this.high, (bottom - top) / 24)) {
      const y = this.y(value);
      svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }, back);
      svg("text", { x: left - 6, y: y + 4, "text-anchor": "end" }, back).textContent = label;
    }
    const across = (value, kind) => {
      const y = this.y(value);
      if (y >= top - 1 && y <= bottom + 1) svg("line", { class: kind, x1: left, x2: right, y1: y, y2: y }, back);
    };
    if (panel.zero) across(0, "zero");
    for (const limit of panel.limits) across(limit, "limit");
    for (const t of page.began ? [0, page.duration_s] : []) {
      if (t > view.from && t < view.to) svg("line", { class: "ends", x1: this.x(t), x2: this.x(t), y1: top, y2: bottom }, back);
    }
    svg("rect", { class: "frame", ...frame }, back);
    for (const c of this.curves) {
      const text = path(c.series, c.name, view, c.held, (t) => this.x(t), (v) => this.y(v * panel.scale));
      c.path.setAttribute("d", text);
    }
    set(this.cursor, { y1: top, y2: bottom });
  }

  /** The range of values: all that is shown, with a little room. */
  scale() {
    const found = this.curves.map((c) => extremes(c.series, c.name, this.view)).filter(Boolean);
    const all = found.flatMap(({ low, high }) => [low * this.panel.scale, high * this.panel.scale]);
    let [low, high] = all.length ? [Math.min(...all), Math.max(...all)] : [0, 1];
    // Less than a display's last digit is no range.
    const least = 4 * 10 ** -this.panel.digits;
    if (high - low < least) [low, high] = [(low + high - least) / 2, (low + high + least) / 2];
    const room = 0.06 * (high - low);
    [this.low, this.high] = [low - room, high + room];
  }

  /** The values at a time, in the panel's unit. */
  values(t) {
    return this.curves.map((c) => valueAt(c.series, c.name, t, c.held) * this.panel.scale);
  }

  show(t) {
    if (!this.view || this.width < 80) return;
    const x = this.x(t);
    const shown = x >= MARGIN.left - 1 && x <= this.width - MARGIN.right + 1;
    set(this.cursor, { x1: x, x2: x, visibility: shown ? "visible" : "hidden" });
    this.values(t).forEach((value, i) => {
      const { dot, value: text } = this.curves[i];
      text.textContent = quantity(value, this.panel.digits, this.panel.unit);
      const y = this.y(value);
      const inside = shown && Number.isFinite(y) && y >= 0 && y <= this.height - MARGIN.bottom + 4;
      if (inside) set(dot, { cx: x, cy: y });
      dot.setAttribute("visibility", inside ? "visible" : "hidden");
    });
  }

  /** Marks a span that is being chosen; none hides the mark. */
  select(from, to) {
    if (from === undefined) return this.selection.setAttribute("visibility", "hidden");
    const [a, b] = [this.x(Math.min(from, to)), this.x(Math.max(from, to))];
    return set(this.selection, { x: a, width: b - a, y: MARGIN.top, height: this.height - MARGIN.top - MARGIN.bottom, visibility: "visible" });
  }
}
