// Which curves stand in which panel.

const FLOWN = page.flown_is;
/** A learned table misses its end in the model, on purpose: what it does there is not what is wanted. */
const PLANNED = page.origin === "learned" ? "model" : "plan";

/** A curve: its source, column and name; `alternative` where the source lacks it. */
const curve = (kind, source, name, label, more) => ({ kind, source, name, label, ...more });
const planned = (name) => curve("plan", "plan", name, PLANNED);
const flown = (name) => curve("flown", "flight", name, FLOWN);
const seen = (name) => curve("cameras", "cameras", name, "cameras");
const own = (kind, name, label) => curve(kind, "flight", name, label, { alternative: "record", held: true });

const limits = page.limits;
const PANELS = [
  { id: "x", title: "Position x", unit: "m", digits: 3, curves: [seen("x"), flown("x"), planned("x")] },
  { id: "z", title: "Height z", unit: "m", digits: 3, curves: [seen("z"), flown("z"), planned("z")] },
  { id: "vx", title: "Velocity in x", unit: "m/s", digits: 2, curves: [flown("vx"), planned("vx")] },
  { id: "vz", title: "Velocity in z", unit: "m/s", digits: 2, curves: [flown("vz"), planned("vz")] },
  { id: "theta", title: "Pitch θ", unit: "rad", digits: 3, curves: [flown("theta"), planned("theta")] },
  {
    id: "rate", title: "Pitch rate", unit: "rad/s", digits: 2, limits: [-limits.rate_max_radps, limits.rate_max_radps],
    curves: [own("gyro", "gyro", "gyro"), own("command", "rate_command", "commanded"), flown("rate"), planned("rate")],
  },
  {
    id: "thrust", title: "Thrust per mass", unit: "m/s²", digits: 2, limits: [limits.thrust_min_mps2, limits.thrust_max_mps2],
    curves: [own("command", "thrust_command", "commanded"), flown("thrust"), planned("thrust")],
  },
  {
    id: "motors", title: "Throttles", unit: "%", digits: 1, scale: 100, limits: [0, 100],
    curves: [1, 2, 3, 4].map((i) => own(`m${i}`, `m${i}`, `motor ${i}`)),
  },
  { id: "phi_r", title: "Switching function Φ_R of the pitch rate", unit: "", digits: 4, zero: true, curves: [planned("phi_r")] },
  { id: "phi_t", title: "Switching function Φ_T of the thrust", unit: "", digits: 4, zero: true, curves: [planned("phi_t")] },
  { id: "battery", title: "Battery", unit: "V", digits: 2, curves: [flown("battery")] },
];

/** The panels with their curves' data, without those of which there are none. */
function panelsWithData() {
  const has = (source, name) => sources[source] && sources[source][name] && sources[source].t.length > 1;
  const found = (c) => {
    const source = [c.source, c.alternative].find((s) => s && has(s, c.name));
    return source ? { ...c, source, series: sources[source] } : null;
  };
  return PANELS
    .map((panel) => ({ scale: 1, limits: [], ...panel, curves: panel.curves.map(found).filter(Boolean) }))
    .filter((panel) => panel.curves.length);
}
