// The whole flight on one line: phases, and what happened when.

class Timeline {
  constructor(parent, control) {
    this.svg = svg("svg", { role: "img", "aria-label": "Phases of the flight and events; the list below says the same" }, parent);
    this.control = control;
    this.width = 0;
    this.svg.addEventListener("click", (event) => control.visit(this.timeAt(event.clientX)));
  }

  measure() {
    const { width } = this.svg.getBoundingClientRect();
    const changed = width !== this.width;
    this.width = width;
    return changed;
  }

  x(t) { return 2 + ((t - whole.from) / (whole.to - whole.from)) * (this.width - 4); }

  timeAt(clientX) {
    const part = (clientX - this.svg.getBoundingClientRect().left - 2) / (this.width - 4);
    return whole.from + part * (whole.to - whole.from);
  }

  draw(view) {
    if (this.width < 80) return;
    this.svg.replaceChildren();
    set(this.svg, { viewBox: `0 0 ${this.width} 83` });
    for (const { name, from_s: from, to_s: to } of page.phases) {
      const [x, width] = [this.x(from), this.x(to) - this.x(from)];
      const kind = name === "maneuver" ? " maneuver" : "";
      const part = svg("rect", { class: `phase${kind}`, x, y: 16, width: Math.max(width, 1), height: 26 }, this.svg);
      svg("title", {}, part).textContent = `${name}: ${format(from, 2)} to ${format(to, 2)} s`;
      if (width > 7 * name.length + 8) {
        svg("text", { class: `phase-name${kind}`, x: x + width / 2, y: 33, "text-anchor": "middle" }, this.svg).textContent = name;
      }
    }
    for (const event of page.events.filter((e) => e.kind !== "firmware")) {
      const x = this.x(event.t_s);
      const mark = svg("line", { class: `event ${event.kind}`, x1: x, x2: x, y1: 44, y2: 58 }, this.svg);
      svg("title", {}, mark).textContent = `${format(event.t_s, 3)} s: ${event.text}`;
    }
    for (const { value, label } of ticks(whole.from, whole.to, this.width / 70)) {
      const x = this.x(value);
      if (x > 12 && x < this.width - 16) svg("text", { x, y: 76, "text-anchor": "middle" }, this.svg).textContent = `${label} s`;
    }
    const [from, to] = [this.x(view.from), this.x(view.to)];
    svg("rect", { class: "selection", x: from, y: 12, width: Math.max(to - from, 1), height: 34 }, this.svg);
    this.cursor = svg("line", { class: "cursor", y1: 8, y2: 60 }, this.svg);
  }

  show(t) {
    if (this.cursor) set(this.cursor, { x1: this.x(t), x2: this.x(t) });
  }
}

/** Rows and lines that name a time lead there. */
function linkTimes(control) {
  for (const place of document.querySelectorAll("[data-t]")) {
    const time = place.querySelector("time, td.number");
    const text = time.textContent;
    time.textContent = "";
    html("button", { type: "button", class: "goto", "aria-label": `Go to ${text}` }, text, time);
    place.addEventListener("click", () => control.visit(Number(place.dataset.t)));
  }
}
