// What runs cost beside error: memory over passes, time by phase.
import * as Plot from "@observablehq/plot";
import { element, section } from "./dom.js";
import { variantNames } from "./looks.js";
import { figure, logTick, logTicks, mebibytes } from "./numbers.js";
import { methodKey } from "./ratios.js";

/** The runs of the headline variant, and of methods without variants. */
function headlineRuns({ data, study }) {
  return data.runs.filter((run) => run.variant === study.variants[0] || run.variant === "any");
}

function memoryPlot(runs, looks, scene) {
  const points = runs.filter((run) => run.scene === scene).flatMap((run) =>
    run.memory.map(([pass, bytes]) => ({ method: run.method, seed: run.seed, pass, memory: mebibytes(bytes) })));
  const last = Math.max(2, ...points.map(({ pass }) => pass));
  return element("figure", { class: "memory-plot" }, element("figcaption", null, scene), Plot.plot({
    width: 400, height: 230, marginLeft: 52, marginBottom: 40, marginRight: 12, marginTop: 12, style: { fontSize: "12px" },
    x: { type: "log", domain: [1, last], axis: null },
    y: { zero: true, nice: true, label: "MiB", ticks: 4, labelArrow: "none" },
    color: { type: "identity" },
    marks: [
      Plot.frame({ fill: "#f7f7f5", stroke: "none" }),
      Plot.axisX(logTicks([1, last]), { text: logTick, label: "passes", labelAnchor: "center", labelArrow: "none" }),
      Plot.gridY({ ticks: 4, stroke: "#ffffff", strokeOpacity: 1, strokeWidth: 1.5 }),
      Plot.line(points, { x: "pass", y: "memory", z: (p) => `${p.method}\n${p.seed}`, stroke: (p) => looks.get(p.method).colour, strokeWidth: 1.6, strokeOpacity: 0.8 }),
    ],
  }));
}

export function memorySection(context) {
  const { study, looks } = context;
  const runs = headlineRuns(context);
  return section("memory", "Memory over passes",
    `Resident memory of a run\u2019s own process after each pass (${variantNames[study.variants[0]].toLowerCase()}; one line for each seed). Lines stay flat if memory does not depend on the number of passes.`,
    methodKey(context),
    element("div", { class: "triple" }, study.scenes.map((scene) => memoryPlot(runs, looks, scene))));
}

const phases = [
  ["eye_seconds", "eye paths", "#56b4e9"],
  ["photon_seconds", "photon paths", "#e69f00"],
  ["gather_seconds", "gathering", "#3fbf9a"],
  ["guide_seconds", "guide", "#cc79a7"],
];
const rest = ["rest", "not split, or the rest", "#c8c8c4"];

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function shares(runs) {
  const wall = mean(runs.map((run) => run.phases.render_wall_s));
  const parts = phases.map(([key, name, colour]) =>
    ({ name, colour, share: mean(runs.map((run) => run.engine[key] ?? 0)) / wall }));
  const split = parts.reduce((sum, part) => sum + part.share, 0);
  return [...parts, { name: rest[1], colour: rest[2], share: Math.max(0, 1 - split) }];
}

function bar(runs) {
  return element("div", { class: "bar" }, shares(runs).filter(({ share }) => share > 0.0005).map(({ name, colour, share }) =>
    element("span", { style: `width:${100 * share}%;background:${colour}`, title: `${name}: ${figure(100 * share)} %` },
      share > 0.06 ? `${Math.round(100 * share)} %` : "")));
}

function phaseRow(scene, method, runs, isFirst, rows) {
  const average = (value) => mean(runs.map(value));
  const photons = average((run) => run.totals.photon_paths / run.phases.render_wall_s);
  return element("tr", null,
    isFirst ? element("th", { scope: "rowgroup", rowspan: rows }, scene) : null,
    element("td", { class: "metric" }, method),
    element("td", { class: "bar-cell" }, bar(runs)),
    element("td", { class: "number" }, figure(1000 * average((run) => run.phases.render_wall_s / run.totals.passes))),
    element("td", { class: "number" }, photons > 0 ? figure(photons / 1e6) : "\u2013"),
    element("td", { class: "number" }, figure(average((run) => run.totals.rays / run.phases.render_wall_s) / 1e6)),
    element("td", { class: "number" }, figure(1000 * average((run) => run.phases.load_s + run.phases.build_s + run.phases.prepare_s))),
    element("td", { class: "number" }, figure(mebibytes(Math.max(...runs.map((run) => run.peak_memory_bytes))))));
}

export function phaseSection(context) {
  const { study } = context;
  const runs = headlineRuns(context);
  const key = element("div", { class: "method-key" }, [...phases, rest].map(([, name, colour]) =>
    element("span", null, element("span", { class: "swatch", style: `background:${colour}` }), name)));
  const bodies = study.scenes.map((scene) => {
    const groups = study.methods.map((method) => [method, runs.filter((run) => run.scene === scene && run.method === method)])
      .filter(([, own]) => own.length > 0);
    return element("tbody", null, groups.map(([method, own], row) => phaseRow(scene, method, own, row === 0, groups.length)));
  });
  return section("phases", "Time by phase",
    `Shares of the wall time of the passes, mean over seeds (${variantNames[study.variants[0]].toLowerCase()}). Preparation is reading and building the scene, in no other figure of this page.`,
    key,
    element("table", { class: "phases" },
      element("thead", null, element("tr", null,
        element("th", null, "Scene"), element("th", null, "Method"), element("th", null, "Share of the passes\u2019 wall time"),
        element("th", { class: "number" }, "ms per pass"), element("th", { class: "number" }, "million photon paths / s"),
        element("th", { class: "number" }, "million rays / s"), element("th", { class: "number" }, "preparation, ms"),
        element("th", { class: "number" }, "peak MiB"))),
      ...bodies));
}
