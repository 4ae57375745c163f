// How the claim of a certificate on points is drawn, by its figure: as segments and circles on the
// screen. `view` knows the place of each point there, and in space.
function shapesOf({ form, ids, name }, view) {
  const named = form.places ? form.places.map(i => ids[i]) : ids;
  const p = named.map(id => view.at(id));
  switch (form.figure) {
    case "circle": {  // through the points, or that at which their weights are their powers
      const weights = named.map(id => name.includes("power") ? WEIGHT[id] : 0);
      if (p.length === 5) return sphereShapes(view, named, p, weights);
      return [circleThrough(p[0], p[1], p[2], weights.map(w => w * view.scale ** 2)), { dot: p[3] }];
    }
    case "turn":
      if (p.length === 4) return planeShapes(p);
      return [{ from: p[0], to: p[1], arrow: true }, { from: p[1], to: p[2], faint: true },
              { dot: p[2] }];
    case "directions":
      return [{ from: p[0], to: p[1], arrow: true }, { from: p[2], to: p[3], arrow: true }];
    case "order":
      return [{ from: p[0], to: p[1], arrow: true }];
    case "angle":
      return [{ from: p[0], to: p[1], arrow: true }, { from: p[2], to: p[3], arrow: true },
              { from: p[0], to: [p[0][0] + p[3][0] - p[2][0], p[0][1] + p[3][1] - p[2][1]],
                faint: true }];
    case "strips":
      return [...flushBox([p[0], p[1], p[1], p[2], p[0]]),
              ...flushBox([p[3], p[4], p[4], p[5], p[3]], true)];
    case "rectangles":
      return [...flushBox(p.slice(0, 5)), ...flushBox(p.slice(5), true)];
    case "extents":
    case "lengths":
      return pairShapes(p);
    case "nearer":
      return [{ from: p[2], to: p[0] }, { from: p[2], to: p[1], faint: true },
              { centre: p[2], radius: distanceOnScreen(view, named[1], named[2]), faint: true }];
    default:
      return p.slice(1).map((q, i) => ({ from: p[i], to: q }));
  }
}

// A segment between the two points of each pair: the first half of the pairs against the second half.
// (Of two boxes: the two extents of the smaller, then those of the larger.)
function pairShapes(p) {
  return p.flatMap((from, i) => i % 2 ? [] : [{ from, to: p[i + 1], faint: 2 * i >= p.length }]);
}

// A sphere through four points, or one that has their weights as powers, and a fifth; its outline is a
// circle however it is turned.
function sphereShapes(view, ids, p, weights) {
  const { centre, radius } = sphereThrough(ids.slice(0, 4).map(id => view.positionOf(id)), weights);
  return [{ centre: view.seenAt(centre), radius: radius * view.scale }, { dot: p[4] },
          ...[[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]].map(([i, j]) => ({ from: p[i], to: p[j] }))];
}
// A plane through three points, and a fourth.
function planeShapes(p) {
  const around = [0, 1, 2].map(i => ({ from: p[i], to: p[(i + 1) % 3], arrow: true }));
  return [...around, { dot: p[3] }, ...[0, 1, 2].map(i => ({ from: p[i], to: p[3], faint: true }))];
}
// In space this is longer than the segment between the two on the screen.
function distanceOnScreen(view, a, b) {
  return Math.hypot(...minus(view.positionOf(a), view.positionOf(b))) * view.scale;
}

// The rectangle on the line of a and b whose other sides pass through r, c and l; of a strip only
// the part on its edge.
function flushBox([a, b, r, c, l], faint = false) {
  const ux = b[0] - a[0], uy = b[1] - a[1], square = ux * ux + uy * uy;
  if (!(square > 0)) return [{ from: a, to: c, faint }];
  const along = q => ((q[0] - a[0]) * ux + (q[1] - a[1]) * uy) / square;
  const above = q => ((q[1] - a[1]) * ux - (q[0] - a[0]) * uy) / square;
  const at = (s, h) => [a[0] + s * ux - h * uy, a[1] + s * uy + h * ux];
  const low = along(l), high = along(r), top = above(c);
  const corners = [at(low, 0), at(high, 0), at(high, top), at(low, top)];
  return [{ from: a, to: b, arrow: true, faint },
          ...corners.map((q, i) => ({ from: q, to: corners[(i + 1) % 4], faint }))];
}

// Through three points; or the circle at which they have these powers. If it has no points the radius is not
// a number.
function circleThrough([ax, ay], [px, py], [qx, qy], [wa, wp, wq] = [0, 0, 0]) {
  const bx = px - ax, by = py - ay, cx = qx - ax, cy = qy - ay;
  const d = 2 * (bx * cy - by * cx);
  const b = bx * bx + by * by - wp + wa, c = cx * cx + cy * cy - wq + wa;
  const x = (cy * b - by * c) / d, y = (bx * c - cx * b) / d;
  return { centre: [ax + x, ay + y], radius: Math.sqrt(x * x + y * y - wa) };
}

// A circle larger than this is a line on the screen, and is not drawn.
const LARGEST_RADIUS = 2e4;

function drawShapes(context, shapes, colour, { width = 1.2, alpha = 1, dash = [] } = {}) {
  context.strokeStyle = colour;
  for (const shape of shapes) {
    context.globalAlpha = alpha * (shape.faint ? 0.6 : 1);
    context.lineWidth = width;
    context.setLineDash(shape.faint ? [2, 4] : shape.wall && dash.length === 0 ? [7, 4] : dash);
    if (shape.centre) {
      if (!(shape.radius < LARGEST_RADIUS)) continue;
      context.beginPath();
      context.arc(...shape.centre, shape.radius, 0, 2 * Math.PI);
      context.stroke();
    } else if (shape.dot) {
      context.setLineDash([]);
      context.beginPath();
      context.arc(...shape.dot, 6.5, 0, 2 * Math.PI);
      context.stroke();
    } else {
      context.beginPath();
      context.moveTo(...shape.from);
      context.lineTo(...shape.to);
      context.stroke();
      if (shape.arrow) arrowHead(context, shape.from, shape.to);
    }
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
}

// In the middle of the segment, where no point hides it.
function arrowHead(context, [x0, y0], [x1, y1]) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (!(length > 14)) return;
  const dx = (x1 - x0) / length, dy = (y1 - y0) / length;
  const x = (x0 + x1) / 2 + 4 * dx, y = (y0 + y1) / 2 + 4 * dy;
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(x - 7 * dx - 4 * dy, y - 7 * dy + 4 * dx);
  context.lineTo(x, y);
  context.lineTo(x - 7 * dx + 4 * dy, y - 7 * dy - 4 * dx);
  context.stroke();
}

// The distance of a place on the screen from the nearest of the shapes.
function distanceToShapes(shapes, x, y) {
  let best = Infinity;
  for (const shape of shapes) {
    if (shape.centre) {
      if (!(shape.radius < LARGEST_RADIUS)) continue;
      best = Math.min(best, Math.abs(Math.hypot(x - shape.centre[0], y - shape.centre[1]) -
                                     shape.radius));
    } else if (shape.from && !shape.faint) {
      const [px, py] = nearestOn([shape.from, shape.to], [x, y]);
      best = Math.min(best, Math.hypot(x - px, y - py));
    }
  }
  return best;
}
