// Error over time in logarithmic axes, with fitted slopes.
import * as Plot from "@observablehq/plot";
import { element, section } from "./dom.js";
import { clockNames, metricNames, ofPart, partNames, variantNames } from "./looks.js";
import { logTick, logTicks, slope } from "./numbers.js";
import { methodKey } from "./ratios.js";

const positive = (points) => points.filter(([, error]) => error > 0);

function points(curves) {
  const seeds = [], means = [];
  for (const curve of curves) {
    for (const { seed, points: own } of curve.seeds)
      for (const [seconds, error] of positive(own)) seeds.push({ method: curve.method, seed, seconds, error });
    for (const [seconds, error] of positive(curve.mean)) means.push({ method: curve.method, seconds, error });
  }
  return { seeds, means };
}

function extent(values, margin) {
  return values.length ? [Math.min(...values) / margin, Math.max(...values) * margin] : [0.1, 1];
}

/** A straight line of slope -1 through the first point of the baseline's mean. */
function independentSamples(means, baseline, domains) {
  const start = means.find(({ method }) => method === baseline) ?? means[0];
  if (!start) return [];
  const lowest = domains.y[0] * 1.15;
  const end = Math.min(domains.x[1], start.seconds * start.error / lowest);
  return [start, { seconds: end, error: start.error * start.seconds / end }];
}

function curvePlot({ study, chosen, looks }, curves, domains) {
  const { seeds, means } = points(curves);
  const colour = ({ method }) => looks.get(method).colour;
  const guide = independentSamples(means, study.baseline, domains);
  return Plot.plot({
    width: 600, height: 400, marginLeft: 62, marginBottom: 44, marginTop: 12, marginRight: 14,
    style: { fontSize: "13px" },
    x: { type: "log", domain: domains.x, axis: null },
    y: { type: "log", domain: domains.y, axis: null },
    symbol: { type: "identity" }, color: { type: "identity" },
    marks: [
      Plot.frame({ fill: "#f7f7f5", stroke: "none" }),
      Plot.gridX(logTicks(domains.x), { stroke: "#ffffff", strokeOpacity: 1, strokeWidth: 1.5 }),
      Plot.gridY(logTicks(domains.y), { stroke: "#ffffff", strokeOpacity: 1, strokeWidth: 1.5 }),
      Plot.axisX(logTicks(domains.x), { text: logTick, label: `time (${clockNames[chosen.clock]})`, labelAnchor: "center", labelArrow: "none" }),
      Plot.axisY(logTicks(domains.y), { text: logTick, label: null }),
      Plot.line(guide, { x: "seconds", y: "error", stroke: "#777", strokeDasharray: "3,4" }),
      Plot.text(guide.slice(-1), { x: "seconds", y: "error", text: ["slope \u22121"], textAnchor: "end", dx: -10, dy: 0, lineAnchor: "top", fill: "#666", fontSize: 11, stroke: "#f7f7f5", strokeWidth: 3 }),
      Plot.line(seeds, { x: "seconds", y: "error", z: (p) => `${p.method}\n${p.seed}`, stroke: colour, strokeWidth: 1, strokeOpacity: 0.4, clip: true, className: "seed-curves" }),
      Plot.line(means, { x: "seconds", y: "error", z: "method", stroke: colour, strokeWidth: 2.5, className: "mean-curves" }),
      Plot.dot(means, { x: "seconds", y: "error", r: 4, fill: colour, stroke: "#f7f7f5", symbol: (p) => looks.get(p.method).symbol, className: "mean-dots" }),
    ],
  });
}

function slopeText(curve) {
  if (!curve || curve.slope === null) return ["\u2013"];
  if (curve.seeds.length < 2) return [slope(curve.slope)];
  return [slope(curve.slope), element("span", { class: "range" }, ` (${slope(curve.slope_low)} to ${slope(curve.slope_high)})`)];
}

function slopeTable({ study, looks }, byVariant) {
  return element("table", { class: study.methods.length > 5 ? "slopes stacked" : "slopes" },
    element("thead", null, element("tr", null, element("th", null, "Fitted slope"),
      study.methods.map((method) => element("th", { class: "number" },
        element("span", { class: "swatch", style: `background:${looks.get(method).colour}` }), method)))),
    element("tbody", null, study.variants.map((variant) => element("tr", null,
      element("th", { scope: "row" }, variantNames[variant]),
      study.methods.map((method) => element("td", { class: "number" },
        slopeText(byVariant.get(variant).find((curve) => curve.method === method))))))));
}

function sceneCurves(context, scene) {
  const { data, study, chosen } = context;
  const curves = data.curves.filter((curve) =>
    curve.scene === scene && curve.part === chosen.part && curve.clock === chosen.clock && curve.metric === chosen.metric);
  if (curves.length === 0) return element("p", { class: "missing" }, chosen.part === "image"
    ? `${scene}: no errors; the scene has no references.`
    : `${scene}: no errors of the ${partNames[chosen.part]}; images or references lack its layer.`);
  const { seeds, means } = points(curves);
  // What came before the first common time would take most of the room.
  const start = Math.min(...(means.length ? means : seeds).map((p) => p.seconds));
  const all = [...seeds.filter((p) => p.seconds >= start), ...means];
  const domains = { x: extent(all.map((p) => p.seconds), 1.08), y: extent(all.map((p) => p.error), 1.25) };
  const byVariant = new Map(study.variants.map((variant) => [variant, curves.filter((c) => c.variant === variant)]));
  return element("article", { class: "scene", "data-scene": scene },
    element("h3", null, scene),
    element("div", { class: "pair" }, study.variants.map((variant) =>
      element("figure", { class: "curve-plot", "data-variant": variant },
        element("figcaption", null, `${variantNames[variant]}: ${metricNames[chosen.metric]} over time${ofPart(context)}`),
        curvePlot(context, byVariant.get(variant), domains)))),
    slopeTable(context, byVariant));
}

export function curveSection(context) {
  const { study, chosen } = context;
  const unit = chosen.metric === "mse" ? "radiance\u00b2" : "no unit";
  return section("curves", "Error over time",
    `${metricNames[chosen.metric]} (${unit}) against the time of the passes. Thick lines with symbols: geometric mean over ${study.seeds.length} seeds at equal times; thin lines: the seeds. Slopes are least-squares fits in log time and log error, mean over seeds (least to largest): \u22121 is what independent samples give, a flatter end shows bias or heavy tails.`,
    methodKey(context),
    ...study.scenes.map((scene) => sceneCurves(context, scene)));
}
