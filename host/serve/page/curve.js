// The estimated error over the render's time, and the target.
import uPlot from "uplot";
import { clock } from "./numbers.js";

const HEIGHT = 170;

function axis(values, size) {
  return {
    stroke: "#9a9a9a", grid: { stroke: "#333333", width: 1 }, ticks: { stroke: "#3a3a3a", width: 1 },
    font: "11px system-ui, sans-serif", values, size,
  };
}

function seconds(value) {
  return value >= 60 ? clock(value) : `${Number(value.toPrecision(2))} s`;
}

/** Marks of a logarithmic scale: 1, 2 and 5 of each decade, more where that gives few, fewer where
 * it gives many. */
function marks(plot, axisNumber, low, high) {
  for (const steps of [[1], [1, 3], [1, 2, 5], [1, 1.5, 2, 3, 4, 5, 6, 8]]) {
    const found = [];
    for (let decade = Math.floor(Math.log10(low)); decade <= Math.ceil(Math.log10(high)); ++decade) {
      for (const step of steps) {
        const at = step * 10 ** decade;
        if (at >= low && at <= high) found.push(at);
      }
    }
    if (found.length >= 3 || steps.length > 3) return found.slice(0, 6);
  }
}

function range(plot, low, high) {
  return low > 0 ? [low / 1.15, Math.max(high, low * 1.05) * 1.15] : [0.1, 1];
}

export class Curve {
  constructor(place, without) {
    this.place = place;
    this.without = without;
  }

  show({ curve, target }) {
    this.without.hidden = curve.length > 0;
    if (curve.length === 0) return;
    const times = curve.map(([time]) => Math.max(time, 1e-3));
    const errors = curve.map(([, error]) => Math.max(100 * error, 1e-6));
    const targets = times.map(() => (target == null ? null : 100 * target));
    this.place.dataset.points = curve.length;
    const data = [times, errors, targets];
    if (!this.plot) this.plot = this.make(data);
    else this.plot.setData(data);
  }

  make(data) {
    const percent = (plot, values) => values.map((value) => `${Number(value.toPrecision(3))} %`);
    return new uPlot({
      width: this.place.clientWidth || 340,
      height: HEIGHT,
      cursor: { y: false, points: { size: 6 } },
      legend: { show: false },
      scales: {
        x: { time: false, distr: 3, range },
        y: { distr: 3, range },
      },
      axes: [
        { ...axis((plot, values) => values.map(seconds), 28), splits: marks, filter: (plot, values) => values },
        { ...axis(percent, 58), splits: marks, filter: (plot, values) => values },
      ],
      series: [
        {},
        { stroke: "#e0a75e", width: 2, points: { show: data[0].length < 3, size: 5 } },
        { stroke: "#86b383", width: 1, dash: [5, 4], points: { show: false } },
      ],
    }, data, this.place);
  }
}
