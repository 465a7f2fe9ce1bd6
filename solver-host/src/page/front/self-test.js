// Add #self-test to the page's address and it checks itself in this browser, and says what it found at its end.

const failures = [];
addEventListener("error", (event) => failures.push(`error: ${event.message}`));
addEventListener("securitypolicyviolation", (event) => failures.push(`policy: ${event.violatedDirective}`));

function selfTest({ plots, player, scene }) {
  let checks = 0;
  const check = (holds, what) => {
    checks += 1;
    if (!holds) failures.push(what);
  };
  const [first] = plots;
  const at = (plot, t) => plot.svg.getBoundingClientRect().left + plot.x(t);
  const point = (plot, type, clientX, more) => plot.svg.dispatchEvent(
    new PointerEvent(type, { clientX, clientY: 0, pointerId: 1, pointerType: "mouse", bubbles: true, ...more }),
  );
  // Events of the test belong to no pointer that could be captured.
  first.svg.setPointerCapture = () => {};
  player.pause();
  player.reset();
  player.paint();

  for (const { panel, curves } of plots) {
    for (const c of curves) {
      const d = c.path.getAttribute("d") || "";
      check(d.length > 20 && !d.includes("NaN"), `${panel.id}: ${c.label} is not drawn`);
    }
  }
  check(scene.trail.getAttribute("d") !== null, "the trail is not drawn");

  // Hovering: the read-out is the datum at that time.
  const t = maneuver.from + 0.4 * (maneuver.to - maneuver.from);
  point(first, "pointermove", at(first, t));
  player.paint();
  check(Math.abs(player.t - t) < 1e-3, `pointing at ${t} s shows ${player.t} s`);
  for (const plot of plots) {
    for (const c of plot.curves) {
      const { series } = c;
      const i = lowerBound(series.t, player.t);
      const near = [series[c.name][i - 1], series[c.name][i]].map((v) => v * plot.panel.scale);
      const told = parseFloat(c.value.textContent.replace("−", "-"));
      const digit = 10 ** -plot.panel.digits;
      const known = near.every(Number.isFinite) && series.t[i] - series.t[i - 1] < GAP_S;
      const fits = told >= Math.min(...near) - digit && told <= Math.max(...near) + digit;
      check(!known || fits, `${plot.panel.id}: ${c.label} reads ${c.value.textContent}, the data say ${near}`);
    }
  }

  // Dragging, wheel, keys and double-click change the shown span.
  const span = () => player.view.to - player.view.from;
  const before = span();
  const [from, to] = [at(first, maneuver.from + 0.25 * before), at(first, maneuver.from + 0.5 * before)];
  point(first, "pointerdown", from);
  point(first, "pointermove", to);
  point(first, "pointerup", to);
  player.paint();
  check(Math.abs(span() - 0.25 * before) < 0.02 * before, `dragging shows ${span()} s of ${before} s`);
  check(plots.every((plot) => plot.view.from === player.view.from), "the panels show different times");
  const dragged = span();
  first.svg.dispatchEvent(new WheelEvent("wheel", { deltaY: -200, clientX: from, ctrlKey: true, cancelable: true, bubbles: true }));
  check(span() < dragged, "the wheel does not zoom");
  first.svg.dispatchEvent(new KeyboardEvent("keydown", { key: "-", bubbles: true }));
  first.svg.dispatchEvent(new MouseEvent("dblclick", { bubbles: true }));
  check(Math.abs(span() - before) < 1e-9, "double-click does not reset");

  // Bytes.
  const bytes = document.querySelectorAll(".byte");
  check(bytes.length === page.table.hex.length / 2, `${bytes.length} bytes are shown`);
  for (let i = 0; i < page.table.fields.length; i += 1) {
    bytes[page.table.fields[i].offset].click();
    check(document.getElementById("field").textContent.includes(page.table.fields[i].value), `field ${i} is not explained`);
  }

  // The learning curve, where there is one.
  const drawn = [...document.querySelectorAll("#learning-plots path")].map((p) => p.getAttribute("d"));
  check(!page.learning || drawn.length > 1, "the learning curve is not drawn");
  check(drawn.every((d) => !d.includes("NaN")), "the learning curve has holes in its numbers");

  // Light and dark differ.
  const colour = () => getComputedStyle(document.body).backgroundColor;
  const was = colour();
  document.getElementById("theme").click();
  check(colour() !== was, "the colours do not change");
  document.getElementById("theme").click();

  const { scrollWidth, clientWidth } = document.documentElement;
  check(scrollWidth <= clientWidth, `${scrollWidth} pixels wide in a window of ${clientWidth}`);

  // Playing moves the vehicle.
  player.seek(maneuver.from + 0.4 * before);
  player.paint();
  const began = player.t;
  const stood = scene.flown.getAttribute("transform");
  document.getElementById("speed").value = "0.5";
  player.play();
  setTimeout(() => {
    check(player.t > began, "playing does not advance the time");
    check(scene.flown.getAttribute("transform") !== stood, "playing does not move the vehicle");
    player.pause();
    const result = document.getElementById("self-test-result");
    result.hidden = false;
    result.textContent = failures.length
      ? `self-test failed: ${failures.join("; ")}`
      : `self-test passed: ${checks} checks, ${clientWidth} pixels`;
  }, 600);
}
