// Exact numbers of instants: fractions and polynomials in integers without limit.

// "a/b" or "a" as [a, b], b > 0.
function fractionOf(text) {
  const [a, b] = text.split("/");
  return [BigInt(a), b === undefined ? 1n : BigInt(b)];
}
const absolute = a => (a < 0n ? -a : a);
function divisor(a, b) {
  a = absolute(a);
  b = absolute(b);
  while (b !== 0n) [a, b] = [b, a % b];
  return a;
}
function fractionText([a, b]) {
  const d = divisor(a, b) || 1n;
  return b / d === 1n ? String(a / d) : a / d + "/" + b / d;
}
// b^degree times the polynomial's value at a/b: of the value's sign.
function scaledValue(coefficients, a, b) {
  let value = 0n, power = 1n;
  for (let k = coefficients.length - 1; k >= 0; --k) {
    value = value * a + coefficients[k] * power;
    power *= b;
  }
  return value;
}
const isPositiveAt = (coefficients, [a, b]) => scaledValue(coefficients, a, b) > 0n;
const floorOf = (a, b) => (a >= 0n || a % b === 0n ? a / b : a / b - 1n);

// The fraction of the smallest denominator in [low, high].
function simplest([a, b], [c, d]) {
  const whole = floorOf(a, b);
  if (a === whole * b) return [whole, 1n];
  if ((whole + 1n) * d <= c) return [whole + 1n, 1n];
  const [p, q] = simplest([d, c - whole * d], [b, a - whole * b]);
  return [whole * p + q, p];
}

// The instant as a fraction, if it is rational; null if it is not, or has no exact name.
function rationalOf(instant) {
  if (instant.length === 1) return null;
  if (instant.rational !== undefined) return instant.rational;
  const [, coefficients, , lower, upper] = instant;
  let found = null;
  if (lower === upper) {
    found = lower;
  } else if (coefficients.length === 2) {
    found = fractionText(coefficients[1].startsWith("-")
      ? [BigInt(coefficients[0]), -BigInt(coefficients[1])]
      : [-BigInt(coefficients[0]), BigInt(coefficients[1])]);
  } else {
    const c = coefficients.map(BigInt);
    const [p, q] = simplest(fractionOf(lower), fractionOf(upper));
    if (scaledValue(c, p, q) === 0n) found = fractionText([p, q]);
  }
  instant.rational = found;
  return found;
}
// A decimal of at most so many characters; but it keeps the digits before the point, `least` of those behind it, and the power of ten.
function cutDecimal(text, most, least) {
  const [, whole, digits, power] = /^([^.e]*)\.?(\d*)(.*)$/.exec(text);
  const kept = digits.slice(0, Math.max(least, most - whole.length - 1 - power.length));
  return whole + (kept === "" ? "" : "." + kept) + power;
}
// "t = 1/3" where that is short, else "t \u2248 0.333..", of about so many characters.
function instantText(instant, characters = 24, least = 0) {
  const exact = rationalOf(instant);
  return exact !== null && exact.length <= 12 ? "t = " + exact : "t \u2248 " + cutDecimal(instant[0], characters, least);
}
// For lists: with the digits that tell apart a millionth of the time that is shown.
const DECIMALS = DATA.time.span > 0 ? Math.max(0, Math.min(12, 6 - powerOfTen(DATA.time.span))) : 0;
const shortInstant = instant => instantText(instant, 12, DECIMALS);

// An interval that holds the instant alone, halved until it is at most 2^-bits long; [low, high] with one
// denominator each. A rational instant has an interval of no length.
function refined(instant, bits) {
  const exact = rationalOf(instant);
  if (exact !== null) return [fractionOf(exact), fractionOf(exact)];
  const c = instant[1].map(BigInt);
  let [low, high] = [fractionOf(instant[3]), fractionOf(instant[4])];
  const up = isPositiveAt(c, high);
  for (let i = 0; i < 4000; ++i) {
    const width = [high[0] * low[1] - low[0] * high[1], high[1] * low[1]];
    if (width[0] << BigInt(bits) <= width[1]) break;
    const middle = [low[0] * high[1] + high[0] * low[1], 2n * low[1] * high[1]];
    const d = divisor(...middle);
    if (d > 1n) { middle[0] /= d; middle[1] /= d; }
    if (isPositiveAt(c, middle) === up) high = middle; else low = middle;
  }
  return [low, high];
}
const bitLength = a => absolute(a).toString(2).length;
// log2 of a positive fraction, to a few digits.
function log2Of([a, b]) {
  const top = x => { const n = bitLength(x); return Math.log2(Number(n > 60 ? x >> BigInt(n - 60) : x)) + Math.max(0, n - 60); };
  return top(a) - top(b);
}
// log2 of the time between two instants of one run, the first not later; -Infinity for one instant, NaN where
// times are not exact.
function gapBetween(a, b) {
  if (a === b) return -Infinity;
  if (a.length === 1 || b.length === 1) {
    const gap = +b[0] - +a[0];
    return gap > 0 ? Math.log2(gap) : NaN;
  }
  for (let bits = 32; bits <= 2048; bits *= 2) {
    const [, end] = refined(a, bits), [begin] = refined(b, bits);
    const gap = [begin[0] * end[1] - end[0] * begin[1], begin[1] * end[1]];
    // The intervals are much shorter than what lies between them.
    if (gap[0] > 0n && gap[0] << BigInt(bits - 8) >= gap[1]) return log2Of(gap);
    if (gap[0] > 0n && rationalOf(a) !== null && rationalOf(b) !== null) return log2Of(gap);
  }
  return NaN;
}
