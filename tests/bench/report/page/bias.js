// Bias and variance apart, as the seeds tell.
import { element, section } from "./dom.js";
import { clockNames, ofPart, variantMeanings, variantNames } from "./looks.js";
import { figure } from "./numbers.js";

const columns = [
  ["bias2", "bias\u00b2"], ["variance", "variance"], ["mse", "MSE, their sum"],
  ["rel_bias2", "relative bias\u00b2"], ["rel_variance", "relative variance"],
];

function finder({ data, chosen }, variant) {
  const found = new Map();
  for (const entry of data.seed_statistics) {
    if (entry.variant !== variant || entry.clock !== chosen.clock || entry.budget_s !== chosen.budget) continue;
    if (entry[chosen.part]) found.set(`${entry.scene}\n${entry.method}`, entry[chosen.part]);
  }
  return (scene, method) => found.get(`${scene}\n${method}`);
}

function cell(value) {
  return value < 0
    ? element("td", { class: "number negative", title: "below the noise of the estimate: no bias found" }, figure(value))
    : element("td", { class: "number" }, figure(value));
}

function sceneRows(scene, find, { study, looks }) {
  return element("tbody", null, study.methods.map((method, row) => {
    const entry = find(scene, method);
    return element("tr", { "data-scene": scene, "data-method": method },
      row === 0 ? element("th", { scope: "rowgroup", rowspan: study.methods.length }, scene) : null,
      element("td", { class: "metric" }, element("span", { class: "swatch", style: `background:${looks.get(method).colour}` }), method),
      columns.map(([key]) => entry ? cell(entry[key]) : element("td", { class: "number none" }, "\u2013")));
  }));
}

function variantTable(context, variant) {
  const { study, chosen } = context;
  const find = finder(context, variant);
  return element("div", { class: "variant" },
    element("h3", null, variantNames[variant], element("span", { class: "quiet" }, ` ${variantMeanings[variant]}`)),
    element("table", { class: "bias" },
      element("caption", null, `Of the snapshots taken for ${chosen.budget} ${clockNames[chosen.clock]}${ofPart(context)}; bias\u00b2, variance and MSE in radiance\u00b2`),
      element("thead", null, element("tr", null, element("th", null, "Scene"), element("th", null, "Method"),
        columns.map(([, name]) => element("th", { class: "number" }, name)))),
      ...study.scenes.map((scene) => sceneRows(scene, find, context))));
}

export function biasSection(context) {
  const { data, study } = context;
  const has = data.seed_statistics.some(({ image, photons }) => image || photons);
  return section("bias", "Bias and variance", [
    `What the images of ${study.seeds.length} seeds have in common is bias, what differs is variance; with a fixed radius more time takes away variance alone. Relative figures are divided, pixel by pixel, by the squared references. `,
    "bias\u00b2 is what is left of the mean image\u2019s squared error after the seeds\u2019 noise is subtracted, so that noise can make it ",
    element("span", { class: "negative" }, "negative"),
    ": that means that no bias was found, and a positive one of about that size in the same scene means as little.",
  ], ...(has ? study.variants.map((variant) => variantTable(context, variant))
    : [element("p", { class: "missing" }, "Not known: it takes references and two seeds.")]));
}
