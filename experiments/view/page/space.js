// Scenes in space: an orthogonal projection that can be turned.
//
// `yaw` turns about the z axis, `pitch` lifts the eye above the plane of x and y; both are in degrees. At
// (0, 0) x goes to the right and z upwards, at (0, 90) the picture is that of the plane.
class Camera {
  constructor() { this.reset(); }
  reset() { this.look(...Camera.START); }
  look(yaw, pitch) {
    this.yaw = ((yaw + 180) % 360 + 360) % 360 - 180;
    this.pitch = Math.max(-90, Math.min(90, pitch));
    const [a, p] = [this.yaw, this.pitch].map(degrees => degrees * Math.PI / 180);
    const [ca, sa, cp, sp] = [Math.cos(a), Math.sin(a), Math.cos(p), Math.sin(p)];
    this.right = [ca, sa, 0];
    this.up = [-sa * sp, ca * sp, cp];
    this.near = [sa * cp, -ca * cp, sp];  // towards the eye
  }
  turn(yaw, pitch) { this.look(this.yaw + yaw, this.pitch + pitch); }
  isAtStart() { return this.yaw === Camera.START[0] && this.pitch === Camera.START[1]; }
  // To the right, upwards, towards the eye.
  seen(v) { return [this.right, this.up, this.near].map(axis => dotProduct(axis, v)); }
}
Camera.START = [24, 18];
// Where each axis points away from the eye or lies across, by its name.
Camera.VIEWS = { x: [90, 0], y: [0, 0], z: [0, 90] };

const dotProduct = (u, v) => u.reduce((sum, x, i) => sum + x * v[i], 0);
const minus = (u, v) => u.map((x, i) => x - v[i]);
const crossProduct = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];

// Through four points, or the sphere at which they have these powers; of flat ones the radius is infinite,
// or not a number.
function sphereThrough([a, ...others], [first, ...weights] = [0, 0, 0, 0]) {
  const [u, v, w] = others.map(p => minus(p, a));
  const squares = [u, v, w].map((p, i) => dotProduct(p, p) - weights[i] + first);
  const sides = [crossProduct(v, w), crossProduct(w, u), crossProduct(u, v)];
  const volume = 2 * dotProduct(u, sides[0]);
  const to = [0, 1, 2].map(i => sides.reduce((sum, side, k) => sum + squares[k] * side[i], 0) / volume);
  return { centre: a.map((x, i) => x + to[i]), radius: Math.sqrt(dotProduct(to, to) - first) };
}

// The corners of a box [x0, x1, y0, y1, z0, z1]; the edges, each with the axis along which it runs.
const cornersOf = box => [0, 1, 2, 3, 4, 5, 6, 7].map(i => [0, 1, 2].map(axis => box[2 * axis + (i >> axis & 1)]));
const BOX_EDGES = [0, 1, 2].flatMap(axis => [0, 1, 2, 3, 4, 5, 6, 7].filter(i => !(i >> axis & 1))
  .map(i => [i, i | 1 << axis, axis]));

function drawWires(context, view, box, colour, width, dash = []) {
  const corners = cornersOf(box).map(p => view.seenAt(p));
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  for (const [i, j] of BOX_EDGES) {
    context.moveTo(...corners[i]);
    context.lineTo(...corners[j]);
  }
  context.stroke();
  context.setLineDash([]);
}

// The box around what is shown, and along three of its edges the coordinates: below the picture those of x
// and y, at its left those of z. An axis that points at the eye has none.
function drawSpaceScales(context, view, box) {
  const corners = cornersOf(box), seen = corners.map(p => view.seenAt(p));
  drawWires(context, view, box, COLOUR.line, 0.8);
  const middle = view.seenAt([0, 1, 2].map(axis => (box[2 * axis] + box[2 * axis + 1]) / 2));
  const unit = DATA.scale;
  for (const axis of [0, 1, 2]) {
    const edges = BOX_EDGES.filter(edge => edge[2] === axis);
    const out = ([i, j]) => (axis === 2 ? -seen[i][0] - seen[j][0] : seen[i][1] + seen[j][1]);
    const [i, j] = edges.reduce((best, edge) => (out(edge) > out(best) + 1e-9 ? edge : best));
    const [from, to] = [seen[i], seen[j]];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (!(length > 30)) continue;
    // Away from the middle, across the edge.
    let across = [(from[1] - to[1]) / length, (to[0] - from[0]) / length];
    if (across[0] * (from[0] - middle[0]) + across[1] * (from[1] - middle[1]) < 0) across = across.map(x => -x);
    const place = f => [0, 1].map(k => from[k] + f * (to[k] - from[k]));
    const text = (words, f, away) => {
      const [x, y] = place(f), wide = context.measureText(words).width;
      const at = [x + across[0] * (away + wide / 2), y + across[1] * (away + 5)];
      const patch = [at[0] - wide / 2 - 2, at[1] - 7, at[0] + wide / 2 + 2, at[1] + 7];
      if (view.places.covered(patch) > 0) return false;
      label(context, words, ...at, COLOUR.quiet, "center");
      view.places.take(patch);
      return true;
    };
    const [low, high] = [box[2 * axis] * unit, box[2 * axis + 1] * unit];
    for (const [value, number] of unit !== null && low < high ? ticks(low, high, length / 55) : []) {
      const f = (value - low) / (high - low), [x, y] = place(f);
      context.strokeStyle = COLOUR.quiet;
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x + 5 * across[0], y + 5 * across[1]);
      context.stroke();
      text(number, f, 7);
    }
    for (const away of [24, 36, 48]) if (text("xyz"[axis], 0.5, away)) break;
  }
}

// Lines are drawn in layers, from the farthest to the nearest, which are stronger.
const LAYERS = 4;
function inLayers(things, depthOf, reach) {
  const layers = Array.from({ length: LAYERS }, (_, i) => ({ alpha: 0.35 + 0.65 * i / (LAYERS - 1), things: [] }));
  for (const thing of things) {
    const place = Math.floor((depthOf(thing) / reach + 1) / 2 * LAYERS);
    layers[Math.max(0, Math.min(LAYERS - 1, place)) || 0].things.push(thing);
  }
  return layers;
}
