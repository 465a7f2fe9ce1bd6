// The shown time and the shown span of time, in one place: everything that moves is told.

/** The shortest span that is shown, s: some ticks of the control loop. */
const SHORTEST_S = 0.01;
/** What an arrow key moves the time by: one control tick, s. */
const TICK_S = 1 / 800;

class Player {
  /** `views` have measure(), draw(span) and show(t). */
  constructor(views) {
    this.views = views;
    this.t = maneuver.from;
    this.view = { ...maneuver };
    this.playing = false;
    this.stale = false;
    this.byId = (id) => document.getElementById(id);
    this.scrub = this.byId("scrub");
    this.wire();
  }

  wire() {
    const on = (id, type, action) => this.byId(id).addEventListener(type, action);
    on("play", "click", () => this.toggle());
    this.scrub.addEventListener("input", () => { this.pause(); this.seek(Number(this.scrub.value)); });
    on("zoom-maneuver", "click", () => this.look(maneuver));
    on("zoom-all", "click", () => this.look(whole));
    on("zoom-in", "click", () => this.zoom(KEY_ZOOM));
    on("zoom-out", "click", () => this.zoom(1 / KEY_ZOOM));
    document.addEventListener("keydown", (event) => {
      const typing = event.target.closest("button, select, input, summary, a");
      if (event.key === " " && !typing) {
        event.preventDefault();
        this.toggle();
      }
    });
    new ResizeObserver(() => this.resize()).observe(document.body);
    addEventListener("beforeprint", () => this.resize());
  }

  isPlaying() { return this.playing; }

  /** Moves the cursor. */
  seek(t) {
    this.t = Math.min(Math.max(t, whole.from), whole.to);
    this.refresh();
  }

  step(ticks) {
    this.pause();
    this.seek(this.t + ticks * TICK_S);
  }

  /** Shows a span of time. */
  look({ from, to }) {
    const span = Math.min(Math.max(to - from, SHORTEST_S), whole.to - whole.from);
    const start = Math.min(Math.max((from + to - span) / 2, whole.from), whole.to - span);
    this.view = { from: start, to: start + span };
    this.t = Math.min(Math.max(this.t, this.view.from), this.view.to);
    this.stale = true;
    this.refresh();
  }

  zoom(factor, about = this.t) {
    const { from, to } = this.view;
    this.look({ from: about - (about - from) / factor, to: about + (to - about) / factor });
  }

  reset() { this.look(maneuver); }

  resize() {
    const changed = this.views.map((view) => view.measure());
    if (!changed.some(Boolean)) return;
    this.stale = true;
    this.paint();
  }

  /** Paints before the next frame, once. */
  refresh() {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => this.paint());
  }

  paint() {
    this.asked = 0;
    if (this.stale) for (const view of this.views) view.draw(this.view);
    if (this.stale) this.label();
    this.stale = false;
    for (const view of this.views) view.show(this.t);
    const text = `${format(this.t, 3)} s`;
    this.scrub.value = this.t;
    this.scrub.setAttribute("aria-valuetext", `t = ${text}`);
    this.byId("clock").textContent = text;
  }

  label() {
    set(this.scrub, { min: this.view.from, max: this.view.to });
    const shows = (span) => String(Math.abs(this.view.from - span.from) + Math.abs(this.view.to - span.to) < 1e-6);
    this.byId("zoom-maneuver").setAttribute("aria-pressed", shows(maneuver));
    this.byId("zoom-all").setAttribute("aria-pressed", shows(whole));
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.t >= this.view.to - 1e-6 || this.t < this.view.from) this.t = this.view.from;
    this.playing = true;
    this.button(true);
    let last = null;
    const frame = (now) => {
      if (!this.playing) return;
      // A page that was hidden does not leap.
      const passed = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
      last = now;
      this.t = Math.min(this.t + passed * Number(this.byId("speed").value), this.view.to);
      this.paint();
      if (this.t >= this.view.to) this.pause();
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  pause() {
    this.playing = false;
    this.button(false);
  }

  button(plays) {
    const play = this.byId("play");
    play.classList.toggle("playing", plays);
    play.setAttribute("aria-label", plays ? "Pause" : "Play");
  }
}

/** The numbers beside the scene: how the vehicle is, and how far from its plan. */
class Now {
  constructor(list) {
    const row = (label) => {
      const box = html("div", {}, undefined, list);
      html("dt", {}, label, box);
      return html("dd", {}, "–", box);
    };
    this.phase = row("phase");
    this.speed = row("speed");
    this.off = row(`from the ${PLANNED}`);
    this.angle = row(`pitch from the ${PLANNED}`);
  }

  measure() { return false; }

  draw() {}

  show(t) {
    const { flight, plan: planned } = sources;
    const at = (series, name) => (series ? valueAt(series, name, t) : NaN);
    const off = (name) => at(flight, name) - at(planned, name);
    const phase = page.phases.find(({ from_s, to_s }) => t >= from_s && t < to_s);
    this.phase.textContent = phase ? phase.name : "–";
    this.speed.textContent = `${format(Math.hypot(at(flight, "vx"), at(flight, "vz")), 2)} m/s`;
    this.off.textContent = `${format(Math.hypot(off("x"), off("z")), 3)} m`;
    const pitch = off("theta");
    this.angle.textContent = `${format(pitch, 3)} rad (${format(pitch * DEGREES, 1)}°)`;
  }
}
