// Axes: ranges, nice ticks, curves as paths.

/** The step of 1, 2 or 5 times a power of ten that gives at most so many ticks. */
function niceStep(span, most) {
  const raw = span / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((m) => m * power >= raw * (1 - 1e-9));
}

/** Ticks within a range with their labels. */
function ticks(from, to, most) {
  const step = niceStep(to - from, most);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const first = Math.ceil(from / step - 1e-9);
  const count = Math.min(60, Math.floor(to / step + 1e-9) - first + 1);
  return Array.from({ length: Math.max(count, 0) }, (_, i) => {
    const value = (first + i) * step;
    return { value, label: format(value, digits) };
  });
}

/** Least and greatest value of a column within a span of time; nothing where there is none. */
function extremes(series, name, span) {
  const from = Math.max(lowerBound(series.t, span.from) - 1, 0);
  const to = Math.min(lowerBound(series.t, span.to) + 1, series.t.length);
  let [low, high] = [Infinity, -Infinity];
  for (let i = from; i < to; i += 1) {
    const value = series[name][i];
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? { low, high } : null;
}

/**
 * A column as an SVG path. Where samples are denser than pixels, first, least, greatest and last of each pixel are drawn: no
 * peak is lost. Gaps and values that are not numbers break the path.
 */
function path(series, name, span, held, x, y) {
  const times = series.t;
  const values = series[name];
  const from = Math.max(lowerBound(times, span.from) - 1, 0);
  const to = Math.min(lowerBound(times, span.to) + 1, times.length);
  const perPixel = (to - from) / Math.max(x(span.to) - x(span.from), 1);
  let text = "";
  let last = null;
  const join = (i) => {
    const [px, py] = [x(times[i]).toFixed(1), y(values[i]).toFixed(1)];
    if (last === null || times[i] - times[last] > GAP_S) text += `M${px},${py}`;
    else text += held ? `H${px}V${py}` : `L${px},${py}`;
    last = i;
  };
  let i = from;
  while (i < to) {
    if (!Number.isFinite(values[i])) {
      last = null;
      i += 1;
    } else if (perPixel < 2) {
      join(i);
      i += 1;
    } else {
      const pixel = Math.floor(x(times[i]));
      let [low, high, end] = [i, i, i];
      const start = i;
      while (i < to && Number.isFinite(values[i]) && Math.floor(x(times[i])) === pixel) {
        if (values[i] < values[low]) low = i;
        if (values[i] > values[high]) high = i;
        end = i;
        i += 1;
      }
      for (const at of [...new Set([start, Math.min(low, high), Math.max(low, high), end])]) join(at);
    }
  }
  return text;
}
