// Numbers as texts: short ones, and such that tell neighbours apart; the round numbers of scales.

// A number for people.
function shortNumber(x) {
  if (x === null || !isFinite(x)) return "";
  if (x === 0) return "0";
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3 ? x.toExponential(2).replace("e+", "e")
                                    : String(+x.toPrecision(5));
}

// The power of ten of a number's first digit.
const powerOfTen = x => Math.floor(Math.log10(x) + 1e-9);
// A number with the digits that tell it from one that is `step` away. Of several the largest one, `most`, decides whether all have
// powers of ten: if that is shorter.
function numberText(x, step, most = Math.abs(x)) {
  if (x === 0) return "0";
  if (!(step > 0) || !(most > 0) || !isFinite(most) || !isFinite(x)) return shortNumber(x);
  const last = Math.max(powerOfTen(step), powerOfTen(most) - 15);  // a double has no more digits
  const plain = y => y.toFixed(Math.max(0, Math.min(100, -last)));
  const byPower = y => y.toExponential(Math.max(0, powerOfTen(Math.abs(y)) - last)).replace("e+", "e");
  const usual = most >= 1e-3 && most < 1e6;
  return usual || (most < 1e21 && plain(most).length <= byPower(most).length) ? plain(x) : byPower(x);
}

// A time by its place in the time that is shown, of which it tells apart a millionth.
function timeText(u) {
  const text = numberText(timeNumber(u), DATA.time.span / 1e6);
  return text.includes(".") && !text.includes("e") ? text.replace(/\.?0+$/, "") : text;
}

// Round numbers between two ends, about `count` of them, each with its text.
function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count), most = Math.max(Math.abs(low), Math.abs(high));
  // Between ends that are closer doubles have no such numbers.
  if (!(rough > 1e-300 && rough > 8 * Number.EPSILON * most && isFinite(rough))) return [];
  const power = Math.floor(Math.log10(rough)), unit = 10 ** Math.abs(power);
  const number = i => (power < 0 ? i / unit : i * unit);
  const factor = [1, 2, 5, 10].find(f => number(f) >= rough) || 10, step = number(factor);
  const numbers = [];
  for (let i = Math.ceil(low / step); number(i * factor) <= high && numbers.length < 50; ++i) numbers.push(number(i * factor));
  const largest = Math.max(...numbers.map(Math.abs));
  return numbers.map(x => [x, numberText(x, step, largest)]);
}
