// Rigid bodies for drawing: poses in doubles, convex polygons, half-planes, the Minkowski sum. What a
// proof consists of never comes from here.
const BODIES = DATA.polygons !== undefined;

// The rotation by c + is and the position of a frame; null: the body is not there.
function poseOf(body, u) {
  const piece = pieceAt(body, u);
  if (piece === null) return null;
  const [x, y, p, q] = piece[2].map(c => evaluate(c, u));
  const n = p * p + q * q;
  return { x, y, c: (p * p - q * q) / n, s: 2 * p * q / n };
}
const turn = (pose, [x, y]) => [pose.c * x - pose.s * y, pose.s * x + pose.c * y];
const turnBack = (pose, [x, y]) => [pose.c * x + pose.s * y, pose.c * y - pose.s * x];
const carry = (pose, point) => {
  const [x, y] = turn(pose, point);
  return [x + pose.x, y + pose.y];
};
// Body b as seen from a: its frame in that of a.
function relative(a, b) {
  const [x, y] = turnBack(a, [b.x - a.x, b.y - a.y]);
  return { x, y, c: a.c * b.c + a.s * b.s, s: a.c * b.s - a.s * b.c };
}
const worldPolygon = (body, pose) => DATA.polygons[body].map(v => carry(pose, v));
const boxOf = points => points.reduce(
  (box, [x, y]) => [Math.min(box[0], x), Math.max(box[1], x), Math.min(box[2], y),
                    Math.max(box[3], y)], [Infinity, -Infinity, Infinity, -Infinity]);
const joined = (a, b) => [Math.min(a[0], b[0]), Math.max(a[1], b[1]), Math.min(a[2], b[2]),
                          Math.max(a[3], b[3])];
const sizeOf = box => Math.max(box[1] - box[0], box[3] - box[2]);
const middleOf = points => {
  const sum = points.reduce(([a, b], [x, y]) => [a + x, b + y], [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
};

// a + R(-b) in a's frame: the edges of both by angle, from the lowest point on.
function sumOf(a, b, pose) {
  const pa = DATA.polygons[a], pb = DATA.polygons[b].map(v => turn(pose, [-v[0], -v[1]]));
  const edges = [];
  let x = 0, y = 0;
  for (const polygon of [pa, pb]) {
    let low = polygon[0];
    polygon.forEach((v, i) => {
      const next = polygon[(i + 1) % polygon.length];
      const d = [next[0] - v[0], next[1] - v[1]];
      let angle = Math.atan2(d[1], d[0]);
      if (angle < 0) angle += 2 * Math.PI;
      edges.push([angle, d]);
      if (v[1] < low[1] || (v[1] === low[1] && v[0] < low[0])) low = v;
    });
    x += low[0];
    y += low[1];
  }
  edges.sort((p, q) => p[0] - q[0]);
  return edges.map(([, d]) => {
    x += d[0];
    y += d[1];
    return [x, y];
  });
}

// The part of a convex polygon in which n.x >= offset.
function clip(polygon, { n, offset }) {
  const result = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const a = n[0] * p[0] + n[1] * p[1] - offset, b = n[0] * q[0] + n[1] * q[1] - offset;
    if (a >= 0) result.push(p);
    if ((a < 0) !== (b < 0)) {
      const f = a / (a - b);
      result.push([p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])]);
    }
  });
  return result;
}

// A rectangle of the screen that shows a box of coordinates, with what the user zoomed and moved.
class Frame {
  constructor() { this.fit(); }
  fit() { this.zoom = 1; this.dx = this.dy = 0; }
  show(rectangle, box, room) {
    this.rectangle = rectangle;
    const [left, top, width, height] = rectangle;
    const fitted = Math.min((width - 2 * room) / (box[1] - box[0]),
                            (height - 2 * room) / (box[3] - box[2]));
    this.scale = this.zoom * (isFinite(fitted) && fitted > 0 ? fitted : 1);
    this.cx = left + width / 2 + this.dx;
    this.cy = top + height / 2 + this.dy;
    this.mx = (box[0] + box[1]) / 2 || 0;
    this.my = (box[2] + box[3]) / 2 || 0;
  }
  at([x, y]) { return [this.cx + (x - this.mx) * this.scale, this.cy - (y - this.my) * this.scale]; }
  // The coordinates that the rectangle shows, a little more on every side.
  corners() {
    const [left, top, width, height] = this.rectangle;
    const back = (x, y) => [this.mx + (x - this.cx) / this.scale, this.my - (y - this.cy) / this.scale];
    return [back(left - 9, top + height + 9), back(left + width + 9, top + height + 9),
            back(left + width + 9, top - 9), back(left - 9, top - 9)];
  }
  holds(x, y) {
    const [left, top, width, height] = this.rectangle || [0, 0, 0, 0];
    return x >= left && x < left + width && y >= top && y < top + height;
  }
  scaleAbout(factor, x, y) {
    const cx = x - (this.cx - this.dx), cy = y - (this.cy - this.dy);
    this.dx = cx - (cx - this.dx) * factor;
    this.dy = cy - (cy - this.dy) * factor;
    this.zoom *= factor;
  }
  move(dx, dy) { this.dx += dx; this.dy += dy; }
}
function trace(context, points, closed) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  if (closed) context.closePath();
}
