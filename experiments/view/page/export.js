// Pictures to take away: PNG as on the screen, SVG, and single frames for an animation (animate.py).

// The name of the language, as every SVG file has it; nothing is loaded from there.
const SVG_NAME = ["http", "//www.w3.org/2000/svg"].join(":");

// What the drawings use of a canvas's context, written as SVG.
class SvgContext {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.parts = [];
    this.clips = 0;
    this.state = { fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, globalAlpha: 1, textAlign: "left",
                   textBaseline: "alphabetic", font: "12px sans-serif", lineJoin: "miter", lineCap: "butt", dash: [],
                   clip: null };
    this.saved = [];
    this.path = "";
    this.ruler = document.createElement("canvas").getContext("2d");
    for (const name of Object.keys(this.state)) {
      if (name === "dash" || name === "clip") continue;
      Object.defineProperty(this, name, { get: () => this.state[name], set: value => { this.state[name] = value; } });
    }
  }
  static number(x) { return String(+(+x).toFixed(2)); }
  static escape(text) {
    return String(text).replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
  }
  points(...numbers) { return numbers.map(SvgContext.number).join(" "); }
  save() { this.saved.push({ ...this.state, dash: this.state.dash.slice() }); }
  restore() { if (this.saved.length > 0) this.state = this.saved.pop(); }
  setTransform() {}
  clearRect() {}
  setLineDash(dash) { this.state.dash = dash.slice(); }
  measureText(text) {
    this.ruler.font = this.state.font;
    return this.ruler.measureText(text);
  }
  beginPath() { this.path = ""; }
  closePath() { this.path += "Z"; }
  moveTo(x, y) { this.path += "M" + this.points(x, y); }
  lineTo(x, y) { this.path += (this.path === "" ? "M" : "L") + this.points(x, y); }
  quadraticCurveTo(a, b, x, y) { this.path += "Q" + this.points(a, b, x, y); }
  bezierCurveTo(a, b, c, d, x, y) { this.path += "C" + this.points(a, b, c, d, x, y); }
  rect(x, y, w, h) { this.path += `M${this.points(x, y)}h${SvgContext.number(w)}v${SvgContext.number(h)}h${SvgContext.number(-w)}Z`; }
  arc(x, y, r, from, to, back = false) {
    const at = angle => [x + r * Math.cos(angle), y + r * Math.sin(angle)];
    let turn = to - from;
    if (Math.abs(turn) >= 2 * Math.PI - 1e-9) {
      this.path += `M${this.points(x + r, y)}A${this.points(r, r)} 0 1 1 ${this.points(x - r, y)}` +
        `A${this.points(r, r)} 0 1 1 ${this.points(x + r, y)}Z`;
      return;
    }
    if (back && turn > 0) turn -= 2 * Math.PI;
    if (!back && turn < 0) turn += 2 * Math.PI;
    this.lineTo(...at(from));
    this.path += `A${this.points(r, r)} 0 ${Math.abs(turn) > Math.PI ? 1 : 0} ${turn > 0 ? 1 : 0} ${this.points(...at(from + turn))}`;
  }
  add(text) {
    const clip = this.state.clip === null ? "" : ` clip-path="url(#${this.state.clip})"`;
    const alpha = this.state.globalAlpha === 1 ? "" : ` opacity="${SvgContext.number(this.state.globalAlpha)}"`;
    this.parts.push(text.replace("/>", clip + alpha + "/>").replace("@", clip + alpha));
  }
  stroked() {
    const dash = this.state.dash.length === 0 ? "" : ` stroke-dasharray="${this.state.dash.join(" ")}"`;
    return `stroke="${this.state.strokeStyle}" stroke-width="${SvgContext.number(this.state.lineWidth)}" stroke-linejoin="${this.state.lineJoin}"${dash}`;
  }
  fill() { if (this.path !== "") this.add(`<path d="${this.path}" fill="${this.state.fillStyle}"/>`); }
  stroke() { if (this.path !== "") this.add(`<path d="${this.path}" fill="none" ${this.stroked()}/>`); }
  fillRect(x, y, w, h) { this.box(x, y, w, h, `fill="${this.state.fillStyle}"`); }
  strokeRect(x, y, w, h) { this.box(x, y, w, h, `fill="none" ${this.stroked()}`); }
  box(x, y, w, h, how) {
    const [a, b, c, d] = [w < 0 ? x + w : x, h < 0 ? y + h : y, Math.abs(w), Math.abs(h)].map(SvgContext.number);
    this.add(`<rect x="${a}" y="${b}" width="${c}" height="${d}" ${how}/>`);
  }
  clip() {
    const id = "clip" + ++this.clips;
    this.parts.push(`<clipPath id="${id}"><path d="${this.path}"/></clipPath>`);
    this.state.clip = id;
  }
  text(text, x, y, how) {
    const anchor = { left: "start", right: "end", center: "middle" }[this.state.textAlign] || "start";
    const size = parseFloat(this.state.font.match(/([\d.]+)px/)[1]);
    const down = { middle: 0.35, top: 0.8, bottom: -0.2 }[this.state.textBaseline] || 0;
    this.add(`<text x="${SvgContext.number(x)}" y="${SvgContext.number(y + down * size)}" font-size="${size}" text-anchor="${anchor}" ${how}@>${SvgContext.escape(text)}</text>`);
  }
  // A patch below a text becomes part of it: it is one element.
  strokeText(text, x, y) { this.patch = [text, x, y, this.stroked()]; }
  fillText(text, x, y) {
    const patch = this.patch && [text, x, y].every((part, i) => part === this.patch[i])
      ? ` ${this.patch[3]} paint-order="stroke"` : "";
    this.patch = null;
    this.text(text, x, y, `fill="${this.state.fillStyle}"${patch}`);
  }
  // The title is what a screen reader reads.
  result(title) {
    return `<svg xmlns="${SVG_NAME}" role="img" width="${this.width}" height="${this.height}" viewBox="0 0 ${this.width} ${this.height}" font-family="${FACE.family}">` +
      `<title>${SvgContext.escape(title)}</title><rect width="100%" height="100%" fill="${COLOUR.back}"/>${this.parts.join("\n")}</svg>\n`;
  }
}

// A sheet in place of the picture on the page: the same size, or another one.
class Sheet {
  constructor(context, width, height) {
    this.context = context;
    this.width = width;
    this.height = height;
  }
  begin() {
    this.context.font = fontOf(12);
    this.context.lineJoin = "round";
    return this.context;
  }
}
function captionOf(k) {
  if (k === BEFORE) return "t = " + DATA.time.start[0];
  return "log record " + k + " of " + LAST + ": " + kindOf(FIRST, k) + " " + listOf(FIRST.ids[at(FIRST, k)]);
}
function pictureAsSvg(width = app.picture.width, height = app.picture.height) {
  const context = new SvgContext(width, height);
  app.seek();
  app.drawing.draw(new Sheet(context, width, height));
  return context.result(DATA.scene.name + ": " + DATA.structures[app.shown()].label + ", " + captionOf(app.k));
}
// The drawing and a line below it, on a canvas of this size.
function pictureAsCanvas(width, height, caption, ratio = 1) {
  const canvas = document.createElement("canvas");
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.fillStyle = COLOUR.back;
  context.fillRect(0, 0, width, height);
  const line = caption === "" ? 0 : 24;
  app.seek();
  app.drawing.draw(new Sheet(context, width, height - line));
  if (caption !== "") {
    context.font = fontOf(13);
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillStyle = COLOUR.text;
    context.fillText(caption, 8, height - line / 2);
  }
  return canvas;
}
function takeAway(name, blob) {
  const link = make("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
const exportName = kind => DATA.scene.name.replace(/[^A-Za-z0-9_.-]+/g, "-") + "-" + app.k + "." + kind;
function savePng() {
  const ratio = Math.max(2, window.devicePixelRatio || 1);
  pictureAsCanvas(app.picture.width, app.picture.height, "", ratio).toBlob(blob => takeAway(exportName("png"), blob));
}
function saveSvg() {
  takeAway(exportName("svg"), new Blob([pictureAsSvg()], { type: "image/svg+xml" }));
}

// A frame of an animation, as a PNG's data URL: { u } in 0 .. 1, or { event }.
window.kinexFrame = ({ u, event, width = 640, height = 480, caption = true }) => {
  if (event !== undefined) app.setEvent(event); else app.setTime(u);
  const t = timeText(app.u);
  const text = app.k === BEFORE ? "t = " + t : "t \u2248 " + t + "   " + captionOf(app.k);
  return pictureAsCanvas(width, height, caption ? text : "").toDataURL("image/png");
};
