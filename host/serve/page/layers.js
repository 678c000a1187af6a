// What the layers of a render mean, and how their values become one number a pixel.
import { luminance } from "./tone.js";

const grey = ({ channels, values }, i) =>
  channels === 3 ? luminance(values[3 * i], values[3 * i + 1], values[3 * i + 2]) : values[channels * i];

const map = (layer, value) => Float32Array.from({ length: layer.width * layer.height }, (_, i) => value(i));

/** Within a fixed scale. */
const scaled = (low, high, of) => (layer, picture) => ({ values: map(layer, (i) => of(layer, i, picture)), low, high, logarithmic: false });

const MOST_SORTED = 20000;

/** On a logarithmic scale from the 2nd to the 99.5th percent of the values above 0. */
const logarithmic = (of) => (layer, picture) => {
  const values = map(layer, (i) => of(layer, i, picture));
  const step = Math.ceil(values.length / MOST_SORTED);
  const above = values.filter((value, i) => i % step === 0 && value > 0 && isFinite(value)).sort();
  const at = (share) => above[Math.min(above.length - 1, Math.floor(share * above.length))] ?? 1;
  return { values, low: Math.min(at(0.02), at(0.995) / 2), high: at(0.995), logarithmic: true };
};

/** Share of the image's luminance. */
const ofImage = (layer, i, picture) => {
  const whole = grey(picture, i);
  return whole > 0 ? grey(layer, i) / whole : 0;
};

/** Numbers that stand for something, from 1; 0: for nothing. */
const numbers = (name) => (layer) => ({
  values: map(layer, (i) => grey(layer, i)), categories: (value) => (value > 0 ? `${name} ${value - 1}` : "none"),
});

const KNOWN = {
  error: { title: "error", unit: "share of the pixel's brightness", note: "Standard deviation of each pixel\u2019s mean over passes.", values: logarithmic(ofImage) },
  photons: { title: "share carried by photons", unit: "of the pixel's light", note: "The rest comes by shadow rays, eye paths and lamp paths.", values: scaled(0, 1, ofImage) },
  photondensity: { title: "photon density", unit: "photons per square scene unit and pass", values: logarithmic(grey) },
  lightchoice: { title: "learned lights", unit: "which shadow rays ask most", note: "The light that shadow rays have learned to ask most, by the numbers of the table below.", values: numbers("light") },
  lightshare: { title: "learned lights: share of the first", unit: "of the shadow rays", values: scaled(0, 1, grey) },
  tableedges: { title: "guide: regions", unit: "edges of its regions", note: "Each region has a table of directions that photons learn.", values: scaled(0, 1, grey), transparent: true },
  tableshare: { title: "guide: share of learned directions", unit: "of the region's bounces", values: scaled(0, 1, grey) },
  nodeerror: { title: "guide: error of the node", unit: "arbitrary", values: logarithmic(grey) },
  nodeweight: { title: "guide: weight of the node", unit: "share of eye rays", values: logarithmic(grey) },
  nodeedges: { title: "guide: regions", unit: "edges of its nodes", note: "", values: scaled(0, 1, grey), transparent: true },
  guidedshare: { title: "guide: share of guided bounces", unit: "of the node's bounces", values: scaled(0, 1, grey) },
};

export function meaningOf(name) {
  const known = KNOWN[name] ?? { title: `light of \u201c${name}\u201d`, unit: "share of the pixel's light", values: scaled(0, 1, ofImage) };
  return { note: "", transparent: false, ...known };
}
