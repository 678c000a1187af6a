// What stands behind the figures: failed runs, references, definitions.
import { element, section } from "./dom.js";
import { figure } from "./numbers.js";

export function failureNote({ data }) {
  if (data.failures.length === 0) return null;
  return element("aside", { class: "failures" },
    element("b", null, data.failures.length === 1 ? "One run failed; its figures are missing."
      : `${data.failures.length} runs failed; their figures are missing.`),
    element("ul", null, data.failures.map(({ settings, message }) => element("li", null,
      `${settings.scene}, ${settings.method}, ${settings.variant}, seed ${settings.seed}: ${message}`))));
}

function agreementText(agreement) {
  if (!agreement) return "not tested";
  return `${agreement.agree ? "agree" : "DIFFER"} (smallest p ${figure(agreement.smallest_p, 2)}, threshold ${figure(agreement.threshold, 2)})`;
}

function referenceRow({ name, width_px, height_px, reference }) {
  if (!reference) return element("tr", null, element("th", null, name), element("td", { colspan: 4 }, "no references: no errors"));
  const images = ["1", "2"].map((key) => reference.images[key]).filter(Boolean);
  return element("tr", null,
    element("th", { scope: "row" }, name),
    element("td", { class: "pixel-count" }, `${width_px} \u00d7 ${height_px}`),
    element("td", null, images.map(({ method, cpu_s }) => `${method} (${figure(cpu_s)} CPU s)`).join(" and ")),
    element("td", null, images.map(({ standard_error }) => standard_error === null ? "unknown" : `${figure(100 * standard_error, 2)} %`).join(" and ")),
    element("td", null, agreementText(reference.agreement)),
    element("td", null, reference.bias_left ? figure(reference.bias_left.relmse, 2) : "\u2013"));
}

const definitions = [
  ["relMSE", "mean over pixels and R, G, B of (I \u2212 R\u2081)(I \u2212 R\u2082) / (R\u2081 R\u2082 + \u03b5); R\u2081 and R\u2082 are independent references, so that their own noise cancels; \u03b5 = (1 % of the mean luminance)\u00b2. Nothing is trimmed: a few bright pixels can carry most of it."],
  ["MSE", "mean of (I \u2212 R\u2081)(I \u2212 R\u2082), in radiance\u00b2."],
  ["relMSE without worst 0.1 %", "the same without the worst thousandth of the pixels: less noisy, but blind to fireflies."],
  ["Bias\u00b2, variance", "bias\u00b2: mean of (M \u2212 R\u2081)(M \u2212 R\u2082) \u2212 variance / seeds, M being the mean over the seeds; variance: mean over pixels of the sample variance over seeds. Relative: each pixel divided by R\u2081 R\u2082 + \u03b5."],
  ["Photon part", "what photons carry, without emission seen and shadow rays, whose noise all photon methods share; measured against the same part of the references."],
  ["Equal time", "the error at a budget lies between two snapshots, straight in log time and log error, never extrapolated. Time is that of the passes alone."],
  ["Interval", "95 % t-interval of the mean log ratio over seeds. With three seeds t is 4.3: wide, and honest."],
  ["Fixed radius", "alpha = 1 and one startradius for all methods. A radius that shrinks with the photons shot flatters whichever method shoots fewer."],
];

export function notesSection({ data }) {
  return section("notes", "What stands behind the figures",
    "References are rendered from other seeds and, where two methods converge, by different methods. What the errors are measured against is itself known only so well:",
    element("table", { class: "references" },
      element("thead", null, element("tr", null, ["Scene", "Pixels", "References", "Standard error of a pixel, of the mean luminance", "Do they agree?", "Bias left (relMSE)"]
        .map((text) => element("th", null, text)))),
      element("tbody", null, data.scenes.map(referenceRow))),
    element("dl", { class: "definitions" }, definitions.flatMap(([name, text]) =>
      [element("dt", null, name), element("dd", null, text)])));
}
