// Numbers as text.

/** Three significant digits; powers of ten beyond 0.001 .. 100000. */
export function figure(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${minus(mantissa)} \u00d7 10${superscript(Number(exponent))}`;
  }
  return minus(String(Number(value.toPrecision(digits))));
}

/** A ratio: zeros at its end stay, as they say how sharp it is. */
export function ratio(value) {
  if (value >= 1000 || value < 0.001) return figure(value, 2);
  if (value >= 100) return String(Math.round(value));
  return value.toPrecision(value < 0.1 ? 2 : 3);
}

/** With two digits after the point, as slopes are. */
export function slope(value) {
  if (value === null) return "\u2013";
  const text = value.toFixed(2);
  return Number(text) === 0 ? "0.00" : minus(text);
}

export const minus = (text) => text.replace("-", "\u2212");

export function superscript(integer) {
  return [...String(integer)].map((c) => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(c)]).join("");
}

/** A power of ten as such, other numbers plainly. */
export function logTick(value) {
  const exponent = Math.round(Math.log10(value));
  const isPower = Math.abs(value / 10 ** exponent - 1) < 1e-9;
  if (isPower && Math.abs(exponent) > 2) return `10${superscript(exponent)}`;
  return figure(value, 2);
}

/** Ticks of a logarithmic axis: powers of ten, the shorter the axis the more between them. */
export function logTicks([low, high]) {
  const decades = Math.log10(high / low);
  const steps = decades > 3 ? [1] : decades > 1 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 8];
  const ticks = [];
  for (let exponent = Math.floor(Math.log10(low)); exponent <= Math.ceil(Math.log10(high)); ++exponent) {
    for (const step of steps) {
      const tick = step * 10 ** exponent;
      if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(tick);
    }
  }
  return ticks;
}

export const mebibytes = (bytes) => bytes / 2 ** 20;

export const geometricMean = (values) =>
  Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
