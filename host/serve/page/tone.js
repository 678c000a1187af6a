// From radiance to what a screen shows.
const STEPS = 16384;
const SRGB = Uint8ClampedArray.from({ length: STEPS + 1 }, (_, i) => {
  const x = i / STEPS;
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
});

/** The sRGB byte of a linear value. */
export const encoded = (x) => SRGB[x >= 1 ? STEPS : x > 0 ? (x * STEPS + 0.5) | 0 : 0];
export const luminance = (r, g, b) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

// K. Narkowicz, "ACES filmic tone mapping curve", 2015: a fit to the reference of the Academy.
const filmic = (x) => (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14);

const CURVES = {
  clipped: (rgb) => rgb,
  filmic: (rgb) => {
    for (let c = 0; c < 3; ++c) rgb[c] = filmic(0.6 * rgb[c]);
    return rgb;
  },
  // Reinhard et al. 2002, eq. 3: of luminance, so that colours stay.
  reinhard: (rgb) => {
    const factor = 1 / (1 + luminance(rgb[0], rgb[1], rgb[2]));
    for (let c = 0; c < 3; ++c) rgb[c] *= factor;
    return rgb;
  },
};

/** Writes the picture into `bytes`, RGBA; `stops`: brighter by 2 to this power. */
export function toneMap(picture, stops, curve, bytes) {
  const factor = 2 ** stops, map = CURVES[curve], { values } = picture, rgb = [0, 0, 0];
  for (let i = 0, o = 0; i + 2 < values.length; i += 3, o += 4) {
    for (let c = 0; c < 3; ++c) rgb[c] = values[i + c] * factor;
    map(rgb);
    for (let c = 0; c < 3; ++c) bytes[o + c] = encoded(rgb[c]);
    bytes[o + 3] = 255;
  }
}

/** Stops that bring the image's mean brightness, in stops, to a middle grey. */
export function automaticStops({ values }) {
  let sum = 0, count = 0;
  for (let i = 0; i + 2 < values.length; i += 3) {
    const y = luminance(values[i], values[i + 1], values[i + 2]);
    if (!(y > 1e-9) || !isFinite(y)) continue;
    sum += Math.log2(y);
    ++count;
  }
  return count ? Math.max(-12, Math.min(12, Math.log2(0.22) - sum / count)) : 0;
}
