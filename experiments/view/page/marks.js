// How points are marked: by their colours in the scene, and by their part in the structure that is shown.
const COLOURS = DATA.scene.colours || [];
const colourOf = object => (COLOURS.length === 0 ? -1 : DATA.scene.colour_of[object]);

// Each colour has an outline of its own, so that it is known without its tone.
const FORMS = [
  { sign: "\u25cf", corners: null },
  { sign: "\u25a0", corners: [[-1, -1], [1, -1], [1, 1], [-1, 1]] },
  { sign: "\u25b2", corners: [[0, -1.4], [1.3, 0.9], [-1.3, 0.9]] },
  { sign: "\u25c6", corners: [[0, -1.5], [1.3, 0], [0, 1.5], [-1.3, 0]] },
  { sign: "\u25bc", corners: [[0, 1.4], [1.3, -0.9], [-1.3, -0.9]] },
];
const formOfColour = colour => FORMS[Math.max(0, colour) % FORMS.length];
// The tones of names that say what they look like; the others have those of structures.
const TONES = { red: "#cf2f3f", blue: "#2f6fde", green: "#2c8f46", yellow: "#c9a200", orange: "#e07b1a", purple: "#8746bd",
                violet: "#8746bd", pink: "#dc6aa6", brown: "#8c5a32", cyan: "#1b98ac", magenta: "#c332a8", grey: "#808690",
                gray: "#808690" };
function toneOfColour(colour) {
  if (colour < 0 || COLOURS[colour] === "black") return COLOUR.point;
  const tone = TONES[COLOURS[colour].toLowerCase()];
  return tone !== undefined ? tone : COLOUR["s" + (1 + colour) % 6];
}
const toneOf = object => toneOfColour(colourOf(object));

// The part of every object in a structure: among its points, the one that it is about, or neither.
const IN = 0, ASKED = 1, LEFT_OUT = 2;
const PARTS = DATA.structures.map(({ members, query }) => {
  const parts = new Uint8Array(OBJECTS).fill(members === undefined ? IN : LEFT_OUT);
  for (const object of members || []) parts[object] = IN;
  if (query !== undefined) parts[query] = ASKED;
  return parts;
});
// A structure of neighbours in order around the point that it is about, one of its sites.
const isStar = ({ shape, query }) => shape === "cycle" && query !== undefined;

// Adds the outline of a mark to the path.
function markPath(context, form, x, y, radius) {
  if (form.corners === null) {
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
    return;
  }
  form.corners.forEach(([dx, dy], i) => {
    if (i === 0) context.moveTo(x + radius * dx, y + radius * dy); else context.lineTo(x + radius * dx, y + radius * dy);
  });
  context.closePath();
}
function crossPath(context, x, y, radius) {
  for (const side of [-1, 1]) {
    context.moveTo(x - radius, y - side * radius);
    context.lineTo(x + radius, y + side * radius);
  }
}

// All points of a picture of the plane or of space; those that a triangulation hides and those that the structure does not see are
// hollow, and a point that a query is about is a cross.
function drawMarks(context, plane, radius) {
  const { replay } = plane.app, parts = PARTS[plane.app.shown()];
  const groups = new Map();
  for (let object = 0; object < OBJECTS; ++object) {
    if (!alive[object] || IS_LINE[object]) continue;
    const code = 6 * (colourOf(object) + 1) + 2 * parts[object] + (replay.isHidden(object) ? 1 : 0);
    if (!groups.has(code)) groups.set(code, []);
    groups.get(code).push(object);
  }
  for (const code of [...groups.keys()].sort((a, b) => a - b)) {
    const colour = Math.floor(code / 6) - 1, part = (code % 6) >> 1, form = formOfColour(colour);
    context.strokeStyle = context.fillStyle = toneOfColour(colour);
    context.lineWidth = part === ASKED ? 2.4 : 1;
    context.globalAlpha = part === LEFT_OUT ? 0.55 : 1;
    context.beginPath();
    for (const object of groups.get(code)) {
      const own = radius * (1 + 0.45 * (plane.sz[object] / plane.reach || 0));  // near points are larger
      if (part === ASKED) crossPath(context, plane.sx[object], plane.sy[object], own + 2);
      else markPath(context, form, plane.sx[object], plane.sy[object], own);
    }
    if (part !== IN || code % 2 === 1) context.stroke(); else context.fill();
  }
  context.globalAlpha = 1;
}
// A point of the last log record: in the tone of failures, or if it has a colour with a border in that tone.
function drawMarked(context, plane, object, radius) {
  const colour = colourOf(object), asked = PARTS[plane.app.shown()][object] === ASKED;
  context.strokeStyle = COLOUR.failed;
  context.fillStyle = colour < 0 ? COLOUR.failed : toneOfColour(colour);
  context.lineWidth = 2.6;
  context.beginPath();
  if (asked) crossPath(context, plane.sx[object], plane.sy[object], radius + 1.5);
  else markPath(context, formOfColour(colour), plane.sx[object], plane.sy[object], radius);
  if (!asked) context.fill();
  if (asked || colour >= 0) context.stroke();
}

// The weight of a point is the square of the radius of a circle around it: points outside the circle have a positive power to it.
// A weight below 0 has none: dashed is that of its absolute value. Only where a certificate reads weights.
const READS_WEIGHTS = WEIGHTED && RUNS.some(run => run.predicates.some(name => name.includes("power")));
function drawWeights(context, plane) {
  if (!READS_WEIGHTS) return;
  const parts = PARTS[plane.app.shown()];
  context.lineWidth = OBJECTS > 300 ? 0.4 : 0.8;
  context.globalAlpha = 0.45;
  for (let object = 0; object < OBJECTS; ++object) {
    const radius = Math.sqrt(Math.abs(WEIGHT[object])) * plane.scale;
    if (!alive[object] || parts[object] !== IN || !(radius > 0 && radius < LARGEST_RADIUS)) continue;
    context.strokeStyle = toneOf(object);
    context.setLineDash(WEIGHT[object] < 0 ? [2, 4] : []);
    context.beginPath();
    context.arc(plane.sx[object], plane.sy[object], radius, 0, 2 * Math.PI);
    context.stroke();
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
}

// What the marks mean: [sign, tone, text].
function meaningsOfMarks(app) {
  const structure = DATA.structures[app.shown()], parts = PARTS[app.shown()];
  const entries = COLOURS.map((name, colour) => [formOfColour(colour).sign, toneOfColour(colour), name]);
  if (structure.query !== undefined) {
    entries.push(["\u00d7", COLOUR.point, (isStar(structure) ? "the site " : "the query ") + nameOf(structure.query)]);
  }
  if (parts.some((part, object) => part === LEFT_OUT && !IS_LINE[object])) {
    entries.push(["\u25cb", COLOUR.quiet, "not in " + structure.label]);
  }
  if (READS_WEIGHTS) entries.push(["\u25ef", COLOUR.quiet, "weight, as the square of a radius"]);
  return entries;
}

// The Voronoi cell of a site, whose neighbours are given, and its edges to these in the triangulation. A cell without an end goes
// on beyond the picture.
function drawCell(context, plane, site, neighbours, colour, dash) {
  if (!alive[site]) return;
  const s = plane.at(site), others = neighbours.filter(id => alive[id]).map(id => plane.at(id));
  const [left, top, width, height] = plane.rectangle, beyond = 4;
  const around = [[left - beyond, top - beyond], [left + width + beyond, top - beyond],
                  [left + width + beyond, top + height + beyond], [left - beyond, top + height + beyond]];
  const nearer = q => ({ n: [s[0] - q[0], s[1] - q[1]], offset: (s[0] ** 2 + s[1] ** 2 - q[0] ** 2 - q[1] ** 2) / 2 });
  const cell = others.reduce((rest, q) => clip(rest, nearer(q)), around);
  trace(context, cell, true);
  context.fillStyle = COLOUR.fill;
  if (dash.length === 0) context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
  drawShapes(context, others.map(to => ({ from: s, to })), colour, { width: 1.2, dash: [5, 3] });
  drawShapes(context, [{ dot: s }], colour, { width: 2.4 });
}
