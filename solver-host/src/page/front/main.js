// Puts the parts together.

const scene = new Scene(document.getElementById("scene"), document.getElementById("scene-legend"));
const plots = panelsWithData().map((panel) => new Plot(panel, document.getElementById("plots")));
const player = new Player([scene, new Now(document.getElementById("now")), ...plots, ...learningCharts()]);
/** Goes to a time that may be outside of what is shown. */
const visit = (t) => {
  player.pause();
  if (t < player.view.from || t > player.view.to) player.look(whole);
  player.seek(t);
};
const control = {
  seek: (t) => player.seek(t),
  step: (ticks) => player.step(ticks),
  zoom: (factor, about) => player.zoom(factor, about),
  look: (span) => player.look(span),
  reset: () => player.reset(),
  isPlaying: () => player.isPlaying(),
  visit,
};
player.views.push(new Timeline(document.getElementById("timeline"), control));
for (const plot of plots) listen(plot, control);
linkTimes(control);
explainBytes();

document.getElementById("theme").addEventListener("click", (event) => {
  const { dataset } = document.documentElement;
  dataset.theme = dataset.theme === "dark" ? "light" : "dark";
  event.currentTarget.setAttribute("aria-label", `Colours: ${dataset.theme}`);
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ({ matches }) => {
  document.documentElement.dataset.theme = matches ? "dark" : "light";
});

player.resize();
// #t=0.8 shows that time; otherwise the flight plays once, unless motion is unwelcome.
const asked = /^#t=(-?[\d.]+)$/.exec(location.hash);
if (asked) visit(Number(asked[1]));
else if (location.hash === "#self-test") addEventListener("load", () => selfTest({ plots, player, scene }));
else if (matchMedia("(prefers-reduced-motion: reduce)").matches) player.seek(page.duration_s / 2);
else player.play();
