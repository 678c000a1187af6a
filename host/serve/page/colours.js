// False colours: viridis (van der Walt and Smith 2015), by nine of its colours.
const STOPS = [
  [68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142],
  [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44], [253, 231, 37],
];
const STEPS = 255;
const TABLE = Array.from({ length: STEPS + 1 }, (_, i) => {
  const at = (i / STEPS) * (STOPS.length - 1), below = Math.min(STOPS.length - 2, Math.floor(at)), part = at - below;
  return STOPS[below].map((value, c) => Math.round(value + part * (STOPS[below + 1][c] - value)));
});

/** Writes a colour for each value into `bytes`, RGBA. `transparent`: what is at the low end is left
 * out. */
export function colours(values, low, high, logarithmic, bytes, transparent) {
  const begin = logarithmic ? Math.log(low) : low, size = (logarithmic ? Math.log(high) : high) - begin || 1;
  values.forEach((value, i) => {
    const place = ((logarithmic ? Math.log(value) : value) - begin) / size;
    const step = Math.max(0, Math.min(STEPS, Math.round(place * STEPS))) || 0;
    bytes.set(TABLE[step], 4 * i);
    bytes[4 * i + 3] = transparent && step === 0 ? 0 : 255;
  });
}

/** A colour of its own for each number from 1: hues by the golden angle, which keeps neighbours apart. */
export function colourOf(number) {
  const hue = (200 + 137.508 * (number - 1)) % 360;
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (0.58 - 0.24 * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

/** Writes these colours into `bytes`, RGBA; 0 is left out. */
export function numberColours(values, bytes) {
  values.forEach((value, i) => {
    if (value > 0) bytes.set([...colourOf(value), 255], 4 * i);
  });
}

export function paintScale(canvas) {
  const context = canvas.getContext("2d");
  for (let x = 0; x < canvas.width; ++x) {
    const [r, g, b] = TABLE[Math.round((x / (canvas.width - 1)) * STEPS)];
    context.fillStyle = `rgb(${r} ${g} ${b})`;
    context.fillRect(x, 0, 1, canvas.height);
  }
}
