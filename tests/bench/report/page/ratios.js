// Equal-time error ratios: the study's result.
import * as Plot from "@observablehq/plot";
import { element, section } from "./dom.js";
import { clockNames, ofPart, variantMeanings, variantNames } from "./looks.js";
import { logTick, logTicks } from "./numbers.js";
import { ratioTable } from "./ratio_table.js";

const metrics = [["relmse", "relMSE"], ["mse", "MSE"]];

function finder({ data, chosen }, variant) {
  const found = new Map();
  for (const entry of data.comparisons) {
    if (entry.variant !== variant || entry.part !== chosen.part || entry.clock !== chosen.clock || entry.budget_s !== chosen.budget) continue;
    if (entry.ratio === null) continue;
    found.set(`${entry.scene}\n${entry.method}\n${entry.metric}`, { ...entry, value: entry.ratio, bound: null });
  }
  return (scene, method, metric) => found.get(`${scene}\n${method}\n${metric}`);
}

const others = (study) => study.methods.filter((method) => method !== study.baseline);

/** Every ratio with its interval, on one axis for both variants. */
function ratioPlot(context, variant, domain) {
  const { study, looks } = context;
  const find = finder(context, variant);
  const entries = study.scenes.flatMap((scene) => others(study).map((method) => find(scene, method, "relmse"))).filter(Boolean);
  const scenes = study.scenes.filter((scene) => entries.some((entry) => entry.scene === scene));
  if (scenes.length === 0) return element("p", { class: "missing" }, "No ratios: errors are missing or not positive.");
  const ticks = logTicks(domain);
  const clip = (value) => Math.min(Math.max(value, domain[0]), domain[1]);
  return Plot.plot({
    width: 600, marginLeft: 110, marginRight: 20, marginTop: 26, marginBottom: 48,
    height: 78 + scenes.length * (12 + 17 * others(study).length),
    style: { fontSize: "13px" },
    x: { type: "log", domain, axis: null },
    y: { axis: null, domain: others(study) },
    fy: { domain: scenes, label: null, padding: 0.12 },
    marks: [
      Plot.frame({ fill: "#f7f7f5", stroke: "none" }),
      Plot.gridX(ticks, { stroke: "#ffffff", strokeOpacity: 1, strokeWidth: 1.5 }),
      Plot.axisX(ticks, {
        text: logTick, labelAnchor: "center", labelArrow: "none",
        label: `relMSE divided by that of ${study.baseline} (95 % interval, cut at the frame)`,
      }),
      Plot.ruleX([1], { stroke: "#222222", strokeWidth: 1.5 }),
      Plot.axisFy({ anchor: "left", label: null, fontWeight: 600, fontSize: 13 }),
      Plot.link(entries.filter((e) => e.low !== null), {
        fy: "scene", x1: (e) => clip(e.low), x2: (e) => clip(e.high), y1: "method", y2: "method",
        stroke: (e) => looks.get(e.method).colour, strokeWidth: 2.5, strokeOpacity: 0.55, strokeLinecap: "butt",
      }),
      Plot.dot(entries, {
        fy: "scene", x: "ratio", y: "method", r: 5, symbol: (e) => looks.get(e.method).symbol,
        fill: (e) => looks.get(e.method).colour, stroke: "white",
      }),
      Plot.text(["\u2190 less error"], { frameAnchor: "top-left", dy: -20, dx: 0, fill: "#555", fontSize: 12, fy: [scenes[0]] }),
      Plot.text(["more error \u2192"], { frameAnchor: "top-right", dy: -20, dx: 0, fill: "#555", fontSize: 12, fy: [scenes[0]] }),
    ],
    symbol: { type: "identity" }, color: { type: "identity" },
  });
}

/** Holds all ratios, and the intervals as far as a hundredfold. */
function commonDomain(context) {
  const { study } = context;
  const values = [0.5, 2];
  for (const variant of study.variants) {
    const find = finder(context, variant);
    for (const scene of study.scenes) {
      for (const method of others(study)) {
        const entry = find(scene, method, "relmse");
        if (!entry) continue;
        values.push(entry.ratio / 1.2, entry.ratio * 1.2);
        if (entry.low !== null) values.push(Math.max(entry.low, entry.ratio / 30), Math.min(entry.high, entry.ratio * 30));
      }
    }
  }
  return [Math.min(...values), Math.max(...values)];
}

export function ratioSection(context) {
  const { study, chosen, looks } = context;
  const domain = commonDomain(context);
  const explanation = [
    `Error of each method divided by the error of ${study.baseline} after ${chosen.budget} ${clockNames[chosen.clock]}, geometric mean over ${study.seeds.length} seeds with its 95 % t-interval. `,
    element("span", { class: "key win" }, "below 1: less error than the baseline"), " ",
    element("span", { class: "key loss" }, "above 1: more error"), " ",
    element("span", { class: "key open" }, "the interval holds 1: not decided"),
  ];
  const parts = study.variants.map((variant) => element("div", { class: "variant" },
    element("h3", null, variantNames[variant], element("span", { class: "quiet" }, ` ${variantMeanings[variant]}`)),
    ratioTable({
      caption: `Equal-time error ratios to ${study.baseline} after ${chosen.budget} ${clockNames[chosen.clock]}${ofPart(context)}`,
      scenes: study.scenes, methods: others(study), metrics, find: finder(context, variant),
      lowerWins: true, studySeeds: study.seeds.length, looks,
    })));
  const plots = element("div", { class: "pair" }, study.variants.map((variant) =>
    element("figure", { class: "ratio-plot" },
      element("figcaption", null, `${variantNames[variant]}: relMSE${ofPart(context)}`), ratioPlot(context, variant, domain))));
  return section("ratios", `Error at equal time, relative to ${study.baseline}`, explanation, methodKey(context), plots, ...parts);
}

/** Which colour and symbol is which method. */
export function methodKey({ study, looks }) {
  return element("div", { class: "method-key" }, study.methods.map((method) => {
    const { colour, symbol } = looks.get(method);
    const drawn = Plot.plot({ width: 16, height: 16, margin: 0, axis: null,
      marks: [Plot.dot([0], { frameAnchor: "middle", r: 5, symbol, fill: colour, stroke: colour })] });
    return element("span", null, drawn, method);
  }));
}
