// What fingers, mouse and keys do on a panel.

/** A tap is over by then, ms, and hardly moves, pixels. */
const TAP = { ms: 350, pixels: 8 };
/** Dragged less than this, it was a click, pixels. */
const DRAG_PIXELS = 5;
/** One press of a key zooms by this. */
const KEY_ZOOM = 1.5;

/** `control`: seek(t), zoom(factor, about), look(span), reset(), isPlaying(). */
function listen(plot, control) {
  const { svg: area } = plot;
  const pointers = new Map();
  let drag = null;
  let pinch = null;
  let tap = null;

  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { pixels: Math.max(Math.abs(a - b), 20), middle: (a + b) / 2 };
  };

  area.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    area.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event.clientX);
    if (event.pointerType === "mouse") {
      drag = { x: event.clientX, t: plot.timeAt(event.clientX) };
    } else if (pointers.size === 2) {
      const { pixels, middle } = spread();
      pinch = { pixels, about: plot.timeAt(middle), span: plot.view.to - plot.view.from };
      tap = null;
    } else {
      const again = tap && event.timeStamp - tap.time < TAP.ms && Math.abs(event.clientX - tap.x) < 4 * TAP.pixels;
      tap = { time: event.timeStamp, x: event.clientX, second: Boolean(again) };
      control.seek(plot.timeAt(event.clientX));
    }
  });

  area.addEventListener("pointermove", (event) => {
    const t = plot.timeAt(event.clientX);
    if (!pointers.has(event.pointerId)) {
      if (event.pointerType === "mouse" && !control.isPlaying()) control.seek(t);
      return;
    }
    pointers.set(event.pointerId, event.clientX);
    if (pinch && pointers.size === 2) {
      const { pixels, middle } = spread();
      const span = pinch.span * (pinch.pixels / pixels);
      const part = (plot.timeAt(middle) - plot.view.from) / (plot.view.to - plot.view.from);
      control.look({ from: pinch.about - part * span, to: pinch.about + (1 - part) * span });
    } else if (drag) {
      const moved = Math.abs(event.clientX - drag.x) >= DRAG_PIXELS;
      if (moved) plot.select(drag.t, t);
      else plot.select();
    } else if (!pinch) {
      control.seek(t);
    }
  });

  const released = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (drag) {
      plot.select();
      const t = plot.timeAt(event.clientX);
      const dragged = event.type === "pointerup" && Math.abs(event.clientX - drag.x) >= DRAG_PIXELS;
      if (dragged) control.look({ from: Math.min(drag.t, t), to: Math.max(drag.t, t) });
      else control.seek(t);
      drag = null;
    }
    if (tap && tap.second && event.type === "pointerup" && Math.abs(event.clientX - tap.x) < TAP.pixels) {
      tap = null;
      control.reset();
    }
    if (pointers.size === 0) pinch = null;
  };
  area.addEventListener("pointerup", released);
  area.addEventListener("pointercancel", released);
  area.addEventListener("dblclick", () => control.reset());

  // The wheel scrolls the page unless one zooms on purpose: with Ctrl, or after a click or tab into the panel.
  area.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey && document.activeElement !== area) return;
    event.preventDefault();
    control.zoom(Math.exp(-0.002 * event.deltaY), plot.timeAt(event.clientX));
  }, { passive: false });

  area.addEventListener("keydown", (event) => {
    const actions = {
      ArrowLeft: () => control.step(event.shiftKey ? -10 : -1),
      ArrowRight: () => control.step(event.shiftKey ? 10 : 1),
      "+": () => control.zoom(KEY_ZOOM),
      "=": () => control.zoom(KEY_ZOOM),
      "-": () => control.zoom(1 / KEY_ZOOM),
      Escape: () => control.reset(),
      0: () => control.reset(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
