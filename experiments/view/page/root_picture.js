// The failing certificate's polynomial around its root, in exact numbers: the isolating interval, and the
// root in it. Right of the root the certificate is negative.
class RootPicture {
  constructor(coefficients, instant) {
    this.coefficients = coefficients.map(BigInt);
    this.instant = instant;
    this.box = make("div", undefined, "root");
    this.canvas = make("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The certificate's polynomial around its root");
    const buttons = make("div", undefined, "root-zoom");
    for (const [text, title, factor] of [["\u2212", "Wider", 2], ["+", "Closer", -2]]) {
      const button = make("button", text);
      button.title = title;
      button.setAttribute("aria-label", title);
      button.addEventListener("click", () => { this.power += factor; this.draw(); });
      buttons.append(button);
    }
    this.box.append(this.canvas, buttons);
    [this.low, this.high] = instant.length === 1 ? [null, null]
      : [fractionOf(instant[3]), fractionOf(instant[4])];
    const width = [this.high[0] * this.low[1] - this.low[0] * this.high[1], this.high[1] * this.low[1]];
    // Half of the picture's width is 2^power: four times the interval, or a hundredth of the time shown.
    this.power = width[0] > 0n ? Math.ceil(log2Of(width)) + 1
      : Math.floor(Math.log2(Math.max(1e-300, DATA.time.span || 1))) - 6;
  }

  // Values at `count` places, as doubles of one unit.
  sample(count) {
    const bits = Math.max(8, 12 - this.power);
    const [low, high] = refined(this.instant, bits);
    // The root as a multiple of 2^-scale, next to it.
    const scale = BigInt(bits + 8);
    const root = floorOf((low[0] * high[1] + high[0] * low[1]) << scale, 2n * low[1] * high[1]);
    const half = this.power >= 0 ? 1n << (BigInt(this.power) + scale)
      : 1n << BigInt(Math.max(0, Number(scale) + this.power));
    const denominator = 1n << scale;
    const values = [];
    for (let i = 0; i < count; ++i) {
      const at = root - half + 2n * half * BigInt(i) / BigInt(count - 1);
      values.push(scaledValue(this.coefficients, at, denominator));
    }
    const most = Math.max(...values.map(bitLength));
    const shift = BigInt(Math.max(0, most - 52));
    // Where the ends of the interval are, from -1 to 1.
    const place = ([a, b]) => {
      const far = (floorOf(a << scale, b) - root) * 4096n / half;
      return far > 40960n ? 10 : far < -40960n ? -10 : Number(far) / 4096;
    };
    return { values: values.map(value => Number(value >> shift)), ends: [place(this.low), place(this.high)] };
  }

  draw() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const context = this.canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    this.drawIn(context, width, height);
  }

  drawIn(context, width, height) {
    const left = 18, right = width - 10, top = 8, bottom = height - 34, zero = (top + bottom) / 2;
    const { values, ends } = this.sample(97);
    const most = Math.max(1, ...values.map(Math.abs));
    const x = f => left + (right - left) * (f + 1) / 2;
    const y = value => zero - value / most * (bottom - top) / 2 * 0.94;
    context.font = fontOf(11);
    // The interval that holds the root alone.
    const [a, b] = ends.map(end => Math.max(-1, Math.min(1, end)));
    context.fillStyle = COLOUR.fill;
    context.fillRect(x(a), top, Math.max(1, x(b) - x(a)), bottom - top);
    context.strokeStyle = COLOUR.first;
    context.lineWidth = 1;
    for (const end of ends) {
      if (Math.abs(end) > 1) continue;
      context.beginPath();
      context.moveTo(x(end), top);
      context.lineTo(x(end), bottom);
      context.stroke();
    }
    context.strokeStyle = COLOUR.quiet;
    context.beginPath();
    context.moveTo(left, zero);
    context.lineTo(right, zero);
    context.stroke();
    // Negative: failed.
    const curve = (from, to, colour) => {
      context.strokeStyle = colour;
      context.lineWidth = 1.8;
      context.beginPath();
      for (let i = from; i <= to; ++i) context.lineTo(x(-1 + 2 * i / (values.length - 1)), y(values[i]));
      context.stroke();
    };
    for (let i = 0; i + 1 < values.length; ++i) {
      curve(i, i + 1, values[i] + values[i + 1] < 0 ? COLOUR.failed : COLOUR.first);
    }
    dot(context, x(0), zero, 3.5, COLOUR.failed);
    context.fillStyle = COLOUR.quiet;
    context.textBaseline = "middle";
    const points = values.map((value, i) => [x(-1 + 2 * i / (values.length - 1)), y(value)]);
    const lines = ends.map(x);
    this.curve = points;
    this.names = [["p > 0", top + 6, right - 70], ["p < 0", bottom - 6, right]].map(([text, at, end]) => {
      const box = freeBox(points, lines, left + 2, end, at, context.measureText(text).width);
      if (box !== null) label(context, text, box[0], at, COLOUR.quiet);
      return box;
    });
    context.fillStyle = COLOUR.quiet;
    // A scale: the picture's half is 2^power.
    context.textAlign = "center";
    for (const [f, text] of [[-1, "\u2212"], [0, ""], [1, "+"]]) {
      context.fillRect(x(f) - 0.5, bottom, 1, 4);
      const name = f === 0 ? "\u03c4" : "\u03c4 " + text + " 2" + raised(this.power);
      const half = context.measureText(name).width / 2;
      context.fillText(name, Math.max(half + 1, Math.min(width - half - 1, x(f))), bottom + 11);
    }
    const named = "time t; " + (ends[0] === ends[1] ? "the root \u03c4 is rational" : "shaded: the interval that isolates the root \u03c4");
    context.fillText(named, (left + right) / 2, bottom + 26);
  }
}
// The first place from the left, at the height `y`, for a text of this width that neither a curve through these
// points nor an upright line crosses: [left, top, right, bottom]. null: there is none.
function freeBox(points, lines, from, to, y, width) {
  const top = y - 8, bottom = y + 8;
  for (let left = from; left + width <= to; left += 4) {
    const right = left + width, near = points.filter(([x]) => x > left - 6 && x < right + 6).map(point => point[1]);
    const crossed = near.length > 0 && Math.min(...near) < bottom && Math.max(...near) > top;
    if (!crossed && !lines.some(x => x > left - 3 && x < right + 3)) return [left, top, right, bottom];
  }
  return null;
}
const raised = number => String(number).replace(/./g, c => "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[+c] || (c === "-" ? "\u207b" : c));
