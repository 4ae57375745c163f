// A canvas in CSS pixels, sharp on every screen.
class Picture {
  constructor(id) {
    this.canvas = document.getElementById(id);
    this.context = this.canvas.getContext("2d");
    this.width = this.height = 0;
  }
  begin() {
    const ratio = window.devicePixelRatio || 1;
    const box = this.canvas.getBoundingClientRect();
    this.width = box.width;
    this.height = box.height;
    const w = Math.round(box.width * ratio), h = Math.round(box.height * ratio);
    if (this.canvas.width !== w || this.canvas.height !== h) {
      this.canvas.width = w;
      this.canvas.height = h;
    }
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, box.width, box.height);
    this.context.font = fontOf(12);
    this.context.lineJoin = "round";
    return this.context;
  }
}

// The fonts of all drawings; texts are measured in the font in which they are written, on a canvas and in SVG.
const FACE = { family: "system-ui, sans-serif" };
const fontOf = pixels => pixels + "px " + FACE.family;

const COLOUR = {};
function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["back", "text", "quiet", "line", "point", "first", "fill", "failed",
                      "second", "external", "internal", "panel", "proof", "next", "selected",
                      "s1", "s2", "s3", "s4", "s5"]) {
    COLOUR[name] = style.getPropertyValue("--" + name).trim();
  }
  COLOUR.s0 = COLOUR.first;
}

function dot(context, x, y, radius, colour) {
  context.fillStyle = colour;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
// A text on a patch of background, so that lines do not cross it.
function label(context, text, x, y, colour, align = "left") {
  context.textAlign = align;
  context.textBaseline = "middle";
  context.lineWidth = 3;
  context.strokeStyle = COLOUR.back;
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
}
// Places that labels have taken, so that none covers another. Boxes are [left, top, right, bottom].
class Places {
  constructor(room) {
    this.room = room;
    this.taken = [];
    this.lines = [];  // from labels to what they name
  }
  take(box) { this.taken.push(box); }
  takeLine(from, to) { this.lines.push([from, to]); }
  // The number of boxes that a line crosses.
  crossed(from, to) { return this.taken.filter(box => passes(from, to, box)).length; }
  around(x, y, radius) { this.take([x - radius, y - radius, x + radius, y + radius]); }
  covered([left, top, right, bottom]) {
    const [a, b, c, d] = this.room;
    const outside = left < a || top < b || right > c || bottom > d ? 1000 : 0;
    const box = [left, top, right, bottom];
    return this.taken.reduce((sum, [l, t, r, e]) => sum + (left < r && l < right && top < e && t < bottom ? 1 : 0),
                             outside + this.lines.filter(([from, to]) => passes(from, to, box)).length);
  }
  // A label about (x, y), or beside that place where it would cover something.
  labelIn(context, text, x, y, colour) {
    const half = context.measureText(text).width / 2 + 1, box = [x - half, y - 7, x + half, y + 7];
    if (this.covered(box) > 0) return this.label(context, text, x, y, colour, true);
    label(context, text, x, y, colour, "center");
    this.take(box);
    return true;
  }
  // A label beside (x, y): at the first free place around it; where there is none it is left out, or, if
  // it must be there, drawn over as few others as possible. True if it is drawn.
  label(context, text, x, y, colour, must = false) {
    const width = context.measureText(text).width;
    let best = null, least = Infinity;
    const beside = [[8, -9], [-8, -9], [8, 10], [-8, 10], [0, -15], [0, 16], [14, 0], [-14, 0]];
    for (const [dx, dy] of must ? [...beside, [0, -30], [0, 31]] : beside) {
      const left = dx > 0 ? x + dx : dx < 0 ? x + dx - width : x - width / 2;
      const box = [left - 1, y + dy - 7, left + width + 1, y + dy + 7];
      const covered = this.covered(box);
      if (covered >= least) continue;
      least = covered;
      best = [left, y + dy, box];
      if (covered === 0) break;
    }
    if (least > 0 && !must) return false;
    label(context, text, best[0], best[1], colour);
    this.take(best[2]);
    return true;
  }
}
// True if a segment has a part inside of a box.
function passes([x0, y0], [x1, y1], [left, top, right, bottom]) {
  let from = 0, to = 1;
  for (const [a, b, low, high] of [[x0, x1, left, right], [y0, y1, top, bottom]]) {
    if (a === b) {
      if (a <= low || a >= high) return false;
      continue;
    }
    const [f, g] = [(low - a) / (b - a), (high - a) / (b - a)];
    from = Math.max(from, Math.min(f, g));
    to = Math.min(to, Math.max(f, g));
  }
  return from < to;
}
// A finite interval that holds all of these and has a length.
function spread(low, high, margin) {
  if (!(low <= high)) return [-1, 1];
  const size = high - low || Math.abs(high) || 1;
  return [low - margin * size, high + margin * size];
}
// Scales at the lower and the left edge of a picture of the plane, with the names of the coordinates.
// `origin`: where (0, 0) is; `pixels`: of one drawn unit, up `steep` times as many. Their labels are taken in `places`.
function drawScales(context, [left, top, width, height], origin, pixels, places, steep = 1) {
  const unit = DATA.scale, bottom = top + height;
  if (unit === null || !(unit > 0) || !(pixels > 0) || !isFinite(pixels)) return;
  const boxOf = (text, x, y, align) => {
    const wide = context.measureText(text).width;
    const from = align === "left" ? x : align === "right" ? x - wide : x - wide / 2;
    return [from - 2, y - 7, from + wide + 2, y + 7];
  };
  const write = (text, x, y, align) => {
    label(context, text, x, y, COLOUR.quiet, align);
    places.take(boxOf(text, x, y, align));
  };
  // The names of the axes come first: fonts differ in their arrows, and a number that would touch a name is left out.
  const names = [["x \u2192", left + width - 6, bottom - 12, "right"], ["y \u2191", left + 8, top + 10, "left"]];
  names.forEach(name => write(...name));
  const tick = (...number) => {
    const [a, b, c, d] = boxOf(...number);
    const touches = names.some(name => {
      const [l, t, r, under] = boxOf(...name);
      return a < r + 4 && l < c + 4 && b < under && t < d;
    });
    if (!touches) write(...number);
  };
  const x = value => origin[0] + value / unit * pixels, y = value => origin[1] - value / unit * pixels * steep;
  const across = px => (px - origin[0]) / pixels * unit, up = py => (origin[1] - py) / (pixels * steep) * unit;
  let free = left;  // where the last number ends
  for (const [value, text] of ticks(across(left + 46), across(left + width - 40), width / 110)) {
    const [from, , to] = boxOf(text, x(value), bottom - 12, "center");
    context.fillStyle = COLOUR.quiet;
    context.fillRect(x(value) - 0.5, bottom - 5, 1, 5);
    if (from < free) continue;
    tick(text, x(value), bottom - 12, "center");
    free = to;
  }
  for (const [value, text] of ticks(up(bottom - 26), up(top + 24), height / 90)) {
    context.fillStyle = COLOUR.quiet;
    context.fillRect(left, y(value) - 0.5, 5, 1);
    tick(text, left + 8, y(value), "left");
  }
}
