// Do the methods agree? Verdicts of `aips-bench agreement`, each with its ratio on a scale around 1.
import { intervalAxis, intervalPlot, scaleFor } from "./agreement_plot.js";
import { element, section } from "./dom.js";
import { figure, minus } from "./numbers.js";

const references = "references";
/** Classes of the verdicts: those of the ratio tables, and one for what is known to miss light. */
const classes = { agrees: "win", differs: "loss", open: "open", "does not converge": "misses" };

const percent = (value) => `${figure(100 * value)}\u202f%`;

/** Two digits, zeros too, as they say how sharp it is; hundredths of a per cent at least. */
function measured(value) {
  if (value === null) return "\u2013";
  const size = 100 * Math.abs(value);
  return `${size >= 100 ? Math.round(size) : size < 0.1 ? size.toFixed(2) : size.toPrecision(2)}\u202f%`;
}
const signed = (value) => `${value < 0 ? "\u2212" : "+"}${measured(value)}`;

/** As many digits after the point as the interval's width is worth. */
function ratios({ weighted_ratio: ratio, weighted_low: low, weighted_high: high }) {
  const width = low === null ? 0.01 : high - low;
  const digits = width > 0 ? Math.min(5, Math.max(2, Math.ceil(-Math.log10(width / 2)) + 1)) : 5;
  return [ratio, low, high].map((value) => value === null ? null : minus(value.toFixed(digits)));
}

/** In two parts, between which a line may end. */
function strongest({ smallest_at: at, smallest_p: p }) {
  return [`p ${figure(p, 2)}`, `in ${at === null ? "the mean" : `block ${at.row}, ${at.column}`}`]
    .map((part) => part.replaceAll(" ", "\u00a0")).join(" ");
}

function details(test) {
  const { smallest_at: at, mean_ratio, seeds, threshold, misses } = test;
  return [
    misses === null ? null : `Misses ${misses}.`,
    `Strongest difference: ${strongest(test)}${at === null ? "" : " of 8 \u00d7 8 (row and column from 0 at the top left)"}; it counts below ${figure(threshold, 2)}.`,
    `${seeds} seeds; ratio of the unweighted means ${figure(mean_ratio, 4)}.`,
  ].filter(Boolean).join(" ");
}

function verdictCell(test, notes) {
  const note = test.misses === null ? null : element("sup", null, String(notes.indexOf(test.misses) + 1));
  return element("td", { class: `verdict ${classes[test.verdict]}`, "data-verdict": test.verdict, title: details(test) },
    element("b", null, test.verdict, note),
    test.verdict === "differs" ? element("span", { class: "where" }, strongest(test)) : null);
}

function ratioCell(test, scale, look) {
  const [ratio, low, high] = ratios(test);
  return element("td", { class: "plot" }, element("span", { class: "factor" }, ratio),
    element("span", { class: "range" }, low === null ? "interval unknown" : `[${low}, ${high}]`),
    intervalPlot(test, scale, look));
}

function referenceCells(test, scale, look, notes) {
  if (!test) return [element("td", { class: "none", colspan: 4 }, "not tested: it takes three seeds")];
  return [verdictCell(test, notes), ratioCell(test, scale, look),
    element("td", { class: "number" }, test.claimed_bias === null ? "none" : signed(test.claimed_bias)),
    element("td", { class: "number last" }, measured(test.detectable))];
}

function baselineCells(test, missing, scale, look, notes) {
  if (!test) return [element("td", { class: "none", colspan: 3 }, missing)];
  return [verdictCell(test, notes), ratioCell(test, scale, look),
    element("td", { class: "number" }, measured(test.detectable))];
}

function sceneRows(scene, tests, notes, { study, looks }, decisive) {
  const own = tests.filter((test) => test.scene === scene);
  const scale = scaleFor(own, decisive);
  const find = (method, against) => own.find((test) => test.method === method && test.against === against);
  const missing = (method) => method === study.baseline ? "the baseline itself"
    : find(method, references) && find(study.baseline, references) ? "no common radius" : "not tested";
  const rows = study.methods.map((method, row) => {
    const look = looks.get(method);
    return element("tr", { "data-scene": scene, "data-method": method },
      row === 0 ? element("th", { scope: "rowgroup", rowspan: study.methods.length + 1 }, scene) : null,
      element("td", { class: "metric last" }, element("span", { class: "swatch", style: `background:${look.colour}` }), method),
      referenceCells(find(method, references), scale, look, notes),
      baselineCells(find(method, study.baseline), missing(method), scale, look, notes));
  });
  const axis = () => element("td", { class: "plot" }, intervalAxis(scale));
  return element("tbody", null, rows, element("tr", { class: "axis" },
    element("td", { colspan: 2 }), axis(), element("td", { colspan: 3 }), axis(), element("td")));
}

function head(baseline) {
  const columns = (bias) => [
    element("th", null, "Verdict"), element("th", { class: "plot" }, "Ratio of the means"),
    bias ? element("th", { class: "number" }, "Claimed bias") : null,
    element("th", { class: bias ? "number last" : "number" }, "Detectable"),
  ];
  return element("thead", null,
    element("tr", { class: "groups" }, element("th", { rowspan: 2 }, "Scene"), element("th", { rowspan: 2, class: "last" }, "Method"),
      element("th", { colspan: 4 }, "Against the references"),
      element("th", { colspan: 3 }, `Against ${baseline} at the same radius`)),
    element("tr", null, columns(true), columns(false)));
}

function explanation({ significance, decisive, tests }, { study }) {
  const seeds = Math.max(0, ...tests.map((test) => test.seeds));
  const key = (verdict, text) => [element("span", { class: `key ${classes[verdict]}` }, text), " "];
  return [
    `The image that each method tends to is tested against the references and, at the same fixed radius, against ${study.baseline}: over ${seeds} seeds, in 8 \u00d7 8 blocks and in their mean, where less noisy blocks count more (false alarms: ${percent(significance)} of the rows). `,
    "Symbol and line are the ratio of the mean luminances (1: the same light), the claimed bias taken away, with its 95 % interval; the grey band, as wide as what is detectable, holds differences that noise may hide. ",
    ...key("agrees", `agrees: no difference, and ${percent(decisive)} would have been found`),
    ...key("differs", "differs: by more than noise and claimed bias"),
    ...key("open", `open: noise would hide even ${percent(decisive)}`),
    ...key("does not converge", "does not converge: misses light that it can\u2019t find"),
  ];
}

function remarks({ claims_bias: claims, is_older: older, created }) {
  return [
    claims ? null : "No bias is claimed, as it was not measured (--smaller-radius): what the fixed radius blurs counts as a difference from the references.",
    older ? `Tested on ${created.replace("T", " ").replace("Z", " UTC")}, before the study\u2019s last run; aips-bench agreement tests anew.` : null,
  ].filter(Boolean).map((text) => element("p", { class: "remark" }, text));
}

/** Nothing where the study has not been tested. */
export function agreementSection(context) {
  const { data, study } = context;
  if (data.agreement === null) return null;
  const { tests, decisive } = data.agreement;
  const notes = [...new Set(tests.map((test) => test.misses).filter((text) => text !== null))];
  return section("agreement", "Do the methods agree?", explanation(data.agreement, context),
    ...remarks(data.agreement),
    element("table", { class: "agreement" }, head(study.baseline),
      ...study.scenes.map((scene) => sceneRows(scene, tests, notes, context, decisive))),
    notes.length === 0 ? null : element("ol", { class: "footnotes" },
      notes.map((text) => element("li", null, `Can\u2019t find ${text}.`))));
}
