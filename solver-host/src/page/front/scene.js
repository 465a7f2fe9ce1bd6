// The vehicle in the plane of its maneuver: planned and flown.

/** Half the width of the drawn vehicle, pixels: it is drawn larger than it is, so that one sees how it leans. */
const ARM_PIXELS = 19;
/** Length of the arrow for the highest planned thrust, pixels. */
const THRUST_PIXELS = 52;

class Scene {
  constructor(area, legend) {
    this.svg = area;
    this.back = svg("g", {}, area);
    this.planned = svg("path", { class: "planned-path" }, area);
    this.toCome = svg("path", { class: "to-come" }, area);
    this.trail = svg("path", { class: "trail" }, area);
    this.places = svg("g", {}, area);
    this.ghost = this.vehicle("plan");
    this.arrow = svg("path", { class: "thrust" }, area);
    this.flown = this.vehicle("flown");
    for (const [kind, label] of [["plan", `path, ${PLANNED}`], ["ghost", `vehicle, ${PLANNED}`], ["flown", `flown (${FLOWN})`], ["command", "thrust"]]) {
      html("span", { class: `key c-${kind}` }, label, legend);
    }
    [this.width, this.height] = [0, 0];
  }

  vehicle(kind) {
    const a = ARM_PIXELS;
    const group = svg("g", { class: `vehicle ${kind}`, visibility: "hidden" }, this.svg);
    svg("line", { class: "arm", x1: -a, x2: a, y1: 0, y2: 0 }, group);
    for (const side of [-a, a]) {
      svg("line", { class: "mast", x1: side, x2: side, y1: 0, y2: -6 }, group);
      svg("line", { class: "rotor", x1: side - 9, x2: side + 9, y1: -7, y2: -7 }, group);
    }
    return group;
  }

  measure() {
    const { width, height } = this.svg.getBoundingClientRect();
    const changed = width !== this.width || height !== this.height;
    [this.width, this.height] = [width, height];
    return changed;
  }

  x(x) { return this.width / 2 + (x - this.centre.x) * this.pixelsPerMetre; }

  z(z) { return this.height / 2 - (z - this.centre.z) * this.pixelsPerMetre; }

  /** Fits what is flown and planned in a span of time into the picture, both axes to one scale. */
  draw(view) {
    this.view = view;
    if (this.width < 80) return;
    const shown = [["plan", plan], ["flight", sources.flight]].filter(([, s]) => s && s.t.length);
    const range = (name) => {
      const spans = shown.map(([which, s]) => extremes(s, name, which === "plan" && !page.began ? whole : view)).filter(Boolean);
      const [low, high] = [Math.min(...spans.map((e) => e.low)), Math.max(...spans.map((e) => e.high))];
      return Number.isFinite(high - low) ? { low, high } : { low: -1, high: 1 };
    };
    const [x, z] = [range("x"), range("z")];
    const edge = ARM_PIXELS + 22;
    this.pixelsPerMetre = Math.min(
      (this.width - 2 * edge - 20) / Math.max(x.high - x.low, 0.5),
      (this.height - 2 * edge) / Math.max(z.high - z.low, 0.5),
    );
    this.centre = { x: (x.low + x.high) / 2, z: (z.low + z.high) / 2 };
    set(this.svg, { viewBox: `0 0 ${this.width} ${this.height}` });
    this.grid();
    this.planned.setAttribute("d", this.path(plan, page.began ? view : whole));
    this.toCome.setAttribute("d", this.path(sources.flight, view));
    this.places.replaceChildren();
    const start = plan.t.length ? [{ x: plan.x[0], z: plan.z[0], what: "start" }] : [];
    for (const { x, z, what } of [...start, { ...page.target, what: "where it is to end" }]) {
      const place = svg("circle", { class: "place", cx: this.x(x), cy: this.z(z), r: 4 }, this.places);
      svg("title", {}, place).textContent = what;
    }
  }

  grid() {
    this.back.replaceChildren();
    const [halfWidth, halfHeight] = [this.width / 2 / this.pixelsPerMetre, this.height / 2 / this.pixelsPerMetre];
    const every = niceStep(2 * halfWidth, this.width / 60);
    const lines = (centre, half) => ticks(centre - half, centre + half, (2 * half) / every + 1e-9);
    for (const { value, label } of lines(this.centre.x, halfWidth)) {
      const x = this.x(value);
      svg("line", { class: "grid", x1: x, x2: x, y1: 0, y2: this.height }, this.back);
      if (x > 26 && x < this.width - 52) svg("text", { x, y: this.height - 5, "text-anchor": "middle" }, this.back).textContent = label;
    }
    for (const { value, label } of lines(this.centre.z, halfHeight)) {
      const y = this.z(value);
      svg("line", { class: "grid", x1: 0, x2: this.width, y1: y, y2: y }, this.back);
      if (y > 24 && y < this.height - 22) svg("text", { x: 5, y: y + 4 }, this.back).textContent = label;
    }
    svg("text", { x: this.width - 6, y: this.height - 5, "text-anchor": "end" }, this.back).textContent = "x (m)";
    svg("text", { x: 5, y: 15 }, this.back).textContent = "z (m)";
  }

  path(series, span) {
    if (!series || !series.t.length) return "";
    const from = lowerBound(series.t, span.from - 1e-6);
    const to = lowerBound(series.t, span.to + 1e-6);
    const step = Math.max(1, Math.floor((to - from) / 1500));
    let text = "";
    for (let i = from; i < to; i += step) {
      if (Number.isFinite(series.x[i]) && Number.isFinite(series.z[i])) {
        text += `${text ? "L" : "M"}${this.x(series.x[i]).toFixed(1)},${this.z(series.z[i]).toFixed(1)}`;
      }
    }
    return text;
  }

  /** Puts a vehicle where a series has it; whether it has. */
  place(group, series, t) {
    const at = series ? ["x", "z", "theta"].map((name) => valueAt(series, name, t)) : [NaN];
    const known = at.every(Number.isFinite);
    group.setAttribute("visibility", known ? "visible" : "hidden");
    if (!known) return null;
    const [x, z, theta] = [this.x(at[0]), this.z(at[1]), at[2]];
    group.setAttribute("transform", `translate(${x.toFixed(2)},${z.toFixed(2)}) rotate(${(theta * DEGREES).toFixed(2)})`);
    return { x, z, theta };
  }

  show(t) {
    if (!this.view || this.width < 80) return;
    this.place(this.ghost, sources.plan, t);
    const at = this.place(this.flown, sources.flight, t);
    this.trail.setAttribute("d", this.path(sources.flight, { from: this.view.from, to: t }));
    const { flight } = sources;
    const name = flight && (flight.thrust ? "thrust" : "thrust_command");
    const thrust = at && flight[name] ? valueAt(flight, name, t, true) : NaN;
    const known = thrust > 0;
    this.arrow.setAttribute("visibility", known ? "visible" : "hidden");
    if (!known) return;
    // Along the body's up axis, from between the rotors.
    const length = (THRUST_PIXELS * thrust) / limits.thrust_max_mps2;
    const head = Math.min(7, length / 2);
    const place = `translate(${at.x.toFixed(2)},${at.z.toFixed(2)}) rotate(${(at.theta * DEGREES).toFixed(2)})`;
    const d = `M0,-4V${(-4 - length).toFixed(1)}m${-head},${head}l${head},${-head}l${head},${head}`;
    set(this.arrow, { transform: place, d });
  }
}
