// What methods, metrics and variants look like and are called, everywhere on the page.

// Okabe and Ito (2008): told apart by the colour-blind. The baseline is always the dark one.
const baselineColour = "#333333";
const colours = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c564b", "#7f7f7f", "#4b0092", "#117733"];
const symbols = ["square", "triangle", "diamond", "star", "cross", "wye", "hexagon", "diamond2", "triangle2", "square2"];

/** Colour and symbol of every method of the study. */
export function methodLooks(study) {
  const looks = new Map();
  let next = 0;
  for (const name of study.methods) {
    if (name === study.baseline) looks.set(name, { colour: baselineColour, symbol: "circle" });
    else {
      looks.set(name, { colour: colours[next % colours.length], symbol: symbols[next % symbols.length] });
      ++next;
    }
  }
  return looks;
}

export const metricNames = { relmse: "relMSE", mse: "MSE", relmse_rest: "relMSE without worst 0.1 %" };
export const clockNames = { cpu: "CPU seconds", wall: "wall-clock seconds" };
export const partNames = { image: "whole image", photons: "photon part" };
/** Says in a caption what part the figures are of, where there is a choice. */
export const ofPart = ({ parts, chosen }) => parts.length > 1 ? `, ${partNames[chosen.part]}` : "";
export const variantNames = { fixed: "Fixed radius", shipped: "As shipped" };
export const variantMeanings = {
  fixed: "one radius for all methods: they differ by their sampling alone",
  shipped: "every method with its own radius schedule",
};
