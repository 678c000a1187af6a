// Small plots of ratios around 1, with a scale that the rows of a scene share.
import * as Plot from "@observablehq/plot";

/** Halves of scales, whose middles are round numbers. */
const halves = [0.002, 0.004, 0.01, 0.02, 0.04, 0.1, 0.2, 0.4];
const size = { width: 190, margin: 0, style: { fontSize: "11px", overflow: "visible" } };

/**
 * Half the width of the scale that shows a scene's ratios with their intervals: at most twice the
 * difference that decides, beyond which figures say enough.
 */
export function scaleFor(tests, decisive) {
  const reaches = tests.map(({ weighted_ratio: ratio, weighted_low: low, weighted_high: high }) =>
    Math.max(...[ratio, low ?? ratio, high ?? ratio].map((end) => Math.abs(end - 1))));
  const wanted = Math.min(Math.max(0, ...reaches), 2 * decisive);
  return halves.find((half) => half >= 0.999 * wanted) ?? halves.at(-1);
}

const ticks = (half) => [1 - half / 2, 1, 1 + half / 2];
const domain = (half) => ({ type: "linear", domain: [1 - half, 1 + half], axis: null });

/** The interval, cut at the frame; an arrow at its edge stands for a ratio beyond. */
export function intervalPlot(test, half, { colour, symbol }) {
  const { weighted_ratio: ratio, weighted_low: low, weighted_high: high, detectable } = test;
  const clip = (value) => Math.min(Math.max(value, 1 - half), 1 + half);
  const isBeyond = clip(ratio) !== ratio;
  const hidden = detectable ?? half;
  return Plot.plot({
    ...size, height: 20, x: domain(half), y: { axis: null, domain: [0, 1] },
    color: { type: "identity" }, symbol: { type: "identity" },
    marks: [
      Plot.frame({ fill: "#f7f7f5", stroke: "none" }),
      Plot.rect([0], { x1: clip(1 - hidden), x2: clip(1 + hidden), y1: 0, y2: 1, fill: "#e1e1dc", className: "hidden-band" }),
      Plot.gridX(ticks(half), { stroke: "#ffffff", strokeOpacity: 1, strokeWidth: 1.5 }),
      Plot.ruleX([1], { stroke: "#222222", strokeWidth: 1.5 }),
      low === null ? null : Plot.link([0], {
        x1: clip(low), x2: clip(high), y1: 0.5, y2: 0.5, stroke: colour, strokeWidth: 2.5,
        strokeOpacity: 0.7, className: "interval-line",
      }),
      isBeyond
        ? Plot.dot([0], { x: clip(ratio), y: 0.5, dx: ratio > 1 ? -6 : 6, r: 4, symbol: "triangle", rotate: ratio > 1 ? 90 : -90, fill: colour, className: "beyond" })
        : Plot.dot([0], { x: ratio, y: 0.5, r: 4, symbol, fill: colour, stroke: "white", className: "ratio-dot" }),
    ],
  });
}

export function intervalAxis(half) {
  return Plot.plot({
    ...size, height: 20, marginBottom: 18, x: domain(half), y: { axis: null },
    marks: [Plot.axisX(ticks(half), { tickSize: 0, label: null, tickFormat: (value) => String(Number(value.toFixed(4))) })],
  });
}
