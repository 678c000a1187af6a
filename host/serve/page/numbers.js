// Numbers as they are read.
export function number(value, digits = 4) {
  if (!isFinite(value)) return String(value);
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size < 1e-3 || size >= 1e5 ? value.toExponential(Math.max(1, digits - 2)) : String(Number(value.toPrecision(digits)));
}

/** 12 345 678 as "12.3 M". */
export function amount(value) {
  for (const [unit, name] of [[1e9, "G"], [1e6, "M"], [1e3, "k"]]) {
    if (value >= unit) return `${number(value / unit, 3)} ${name}`;
  }
  return number(value, 3);
}

export const percent = (part) => (isFinite(part) ? `${number(100 * part, 3)} %` : "\u2013");

/** "1:02:03" or "2:03". */
export function clock(seconds) {
  const whole = Math.round(seconds), two = (value) => String(value).padStart(2, "0");
  const hours = Math.floor(whole / 3600), minutes = Math.floor(whole / 60) % 60;
  return hours ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}
