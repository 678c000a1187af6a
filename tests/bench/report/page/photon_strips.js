// Debug layers over the passes: where photons land and what the guide knows, one layer at a time.
import { choice, element, section } from "./dom.js";
import { clockNames, variantNames } from "./looks.js";
import { figure } from "./numbers.js";

const layers = {
  photondensity: {
    name: "photon density", unit: "photons per square scene unit and pass",
    meaning: "photons gathered at the visible points, mean over all passes so far.",
  },
  nodeerror: {
    name: "node error", unit: "arbitrary unit, only ratios matter",
    meaning: "feature error of the guide\u2019s node that the pixel shows, after the pass.",
  },
  nodeweight: {
    name: "node weight", unit: "share of the eye rays, summed over passes",
    meaning: "weight of the guide\u2019s node that the pixel shows, after the pass.",
  },
  nodeedges: {
    name: "node boundaries", unit: "share of the pixels beside another node",
    meaning: "where a neighbouring pixel shows another node of the guide, after the pass.",
  },
  guidedshare: {
    name: "guided share", unit: "share of the photon bounces",
    meaning: "bounces in the node whose direction was drawn from the guide, in that pass alone.",
  },
};

/** What lies beyond an end of the scale has its colour: but for shares nothing does. */
function legend({ layer, low, high, logarithmic }, palette) {
  const isShare = low === 0 && high === 1;
  const middle = logarithmic ? Math.sqrt(low * high) : (low + high) / 2;
  return element("div", { class: "layer-legend" },
    element("span", { class: "layer-low" }, `${logarithmic ? "\u2264 " : ""}${figure(low, 2)}`),
    element("span", { class: "gradient", style: `background:linear-gradient(to right, ${palette.join(", ")})` },
      element("i", null, figure(middle, 2))),
    element("span", { class: "layer-high" }, `${isShare ? "" : "\u2265 "}${figure(high, 2)}`),
    element("span", { class: "quiet" }, `${layers[layer].unit}${logarithmic ? "; logarithmic scale" : ""}`));
}

function pictureCell(picture, text) {
  if (picture === null) return element("td", { class: "none" }, "\u2013");
  return element("td", null,
    element("img", { src: picture.image, alt: text, class: "pixels" }),
    element("span", { class: "quiet" }, `pass ${picture.pass}, ${figure(picture.seconds)} s`));
}

function layerTable({ rows, layer }, scene, { strips, looks }) {
  return element("table", { class: "layers" },
    element("thead", null, element("tr", null, element("th", null, "Method"),
      strips.columns.map((budget) => element("th", null, budget === null ? "first pass" : `after ${budget} s`)))),
    element("tbody", null, rows.map(({ method, pictures }) => element("tr", { "data-method": method },
      element("th", { scope: "row" }, element("span", { class: "swatch", style: `background:${looks.get(method).colour}` }), method),
      pictures.map((picture) => pictureCell(picture, `${scene}, ${layers[layer].name} of ${method}`))))));
}

function sceneStrips({ scene, layers: own }, chosen, context) {
  const layer = own.find((entry) => entry.layer === chosen);
  return element("article", { class: "scene", "data-scene": scene },
    element("h3", null, scene),
    ...(layer ? [layerTable(layer, scene, context), legend(layer, context.strips.palette)]
      : [element("p", { class: "missing" }, `No method shows its ${layers[chosen].name} here.`)]));
}

function leftOutNote({ left_out: names }) {
  if (names.length === 0) return null;
  return element("p", { class: "missing" },
    `Left out, so that the page stays below 10 MB: ${names.map((name) => layers[name].name).join(", ")}.`);
}

/** Nothing where no run has the layers. */
export function photonSection({ data, looks }) {
  const strips = data.photon_strips;
  if (strips === null) return null;
  const present = Object.keys(layers).filter((name) =>
    strips.scenes.some((scene) => scene.layers.some(({ layer }) => layer === name)));
  const shown = element("div", null);
  const draw = (chosen) => shown.replaceChildren(...[
    present.length === 0 ? null : choice("Layer", present.map((value) => ({ value, text: layers[value].name })), chosen, (value) => {
      draw(value);
      shown.querySelector("button[aria-pressed=true]").focus({ preventScroll: true });
    }),
    present.length === 0 ? null : element("p", { class: "layer-meaning" },
      `${layers[chosen].name[0].toUpperCase()}${layers[chosen].name.slice(1)}: ${layers[chosen].meaning}`),
    leftOutNote(strips),
    ...strips.scenes.map((scene) => sceneStrips(scene, chosen, { strips, looks })),
  ].filter(Boolean));
  draw(present[0]);
  return section("photons", "Photon distribution over the passes",
    `Debug layers of the snapshots (${variantNames[strips.variant].toLowerCase()}, seed ${strips.seed}): after the first pass, and after budgets in ${clockNames[strips.clock]}. All pictures of a scene and layer have one scale; pixels without a value, such as those that show no surface, have the darkest colour. Only guide=paper has nodes.`,
    shown);
}
