// A table of factors against the baseline: scenes down, methods across, a colour for who is ahead.
import { element } from "./dom.js";
import { geometricMean, ratio } from "./numbers.js";

/**
 * "win" or "loss" if the whole interval is on one side of 1, "open" if not. Of a bound one end of the
 * interval is unknown.
 */
export function verdict({ low, high, bound }, lowerWins) {
  const below = high !== null && high < 1 && (low !== null || bound === "at most");
  const above = low !== null && low > 1 && (high !== null || bound === "at least");
  if (!below && !above) return "open";
  return below === lowerWins ? "win" : "loss";
}

const boundSigns = { "at least": "\u2265\u202f", "at most": "\u2264\u202f" };

function factor({ value, low, high, bound, seeds }, studySeeds) {
  const interval = bound ? "beyond measured times"
    : low === null ? "one seed" : `[${ratio(low)}, ${ratio(high)}]`;
  const fewer = seeds < studySeeds ? `, ${seeds}\u202f/\u202f${studySeeds} seeds` : "";
  return [
    element("span", { class: "factor" }, `${boundSigns[bound] ?? ""}${ratio(value)}`),
    element("span", { class: "interval" }, interval + fewer),
  ];
}

function cell(entry, { lowerWins, studySeeds }) {
  if (!entry) return element("td", { class: "none" }, "\u2013");
  const outcome = verdict(entry, lowerWins);
  return element("td", { class: outcome, "data-verdict": outcome }, factor(entry, studySeeds));
}

/** The mean is given only of figures that are all there: bounds left out would shift it. */
function totals(entries, lowerWins) {
  const complete = entries.every((entry) => entry && !entry.bound && entry.value > 0);
  const outcomes = entries.filter(Boolean).map((entry) => verdict(entry, lowerWins));
  const count = (name) => outcomes.filter((outcome) => outcome === name).length;
  if (outcomes.length === 0) return element("td", { class: "none" }, "\u2013");
  return element("td", null,
    element("span", { class: "factor" }, complete ? ratio(geometricMean(entries.map((e) => e.value))) : "\u2013"),
    element("span", { class: "interval" }, `${count("win")} ahead, ${count("loss")} behind, ${count("open")} open`));
}

/**
 * find(scene, method, metric) gives {value, low, high, bound, seeds} or nothing. `metrics` are the
 * rows within a scene: [key, name].
 */
export function ratioTable({ caption, scenes, methods, metrics, find, lowerWins, studySeeds, looks }) {
  const head = element("tr", null, element("th", { scope: "col" }, "Scene"), element("th", { scope: "col" }, "Error"),
    methods.map((method) => element("th", { scope: "col", class: "number" },
      element("span", { class: "swatch", style: `background:${looks.get(method).colour}` }), method)));
  const body = scenes.map((scene) => element("tbody", null, metrics.map(([key, name], row) =>
    element("tr", null,
      row === 0 ? element("th", { scope: "rowgroup", rowspan: metrics.length }, scene) : null,
      element("td", { class: "metric" }, name),
      methods.map((method) => cell(find(scene, method, key), { lowerWins, studySeeds }))))));
  const foot = scenes.length < 2 ? null : element("tfoot", null, metrics.map(([key, name], row) =>
    element("tr", null,
      row === 0 ? element("th", { scope: "rowgroup", rowspan: metrics.length }, "All scenes (geometric mean)") : null,
      element("td", { class: "metric" }, name),
      methods.map((method) => totals(scenes.map((scene) => find(scene, method, key)), lowerWins)))));
  return element("table", { class: methods.length > 3 ? "ratios stacked" : "ratios" }, element("caption", null, caption), element("thead", null, head), ...body, foot);
}
