// Boxes: the queries of the scene with the nodes that they look at, and attributes that are boxes.

// The query that is shown: one at this time, or just before it; null: none.
function queryShown(app) {
  const near = FIRST.queries.filter(query => query.u <= app.u && app.u <= query.u + QUERY_LASTS);
  return near.length === 0 ? null : near[near.length - 1];
}
const QUERY_LASTS = 1 / 100;
// The first query after this time; after the last one, the first of all.
function nextQuery(app) {
  const later = FIRST.queries.find(query => query.u > app.u + 1e-12);
  return later === undefined ? FIRST.queries[0] : later;
}

// The box, and around every node the points that it has: inside the box, crossed by it, outside.
function drawQuery(context, plane) {
  const query = queryShown(plane.app);
  if (query === null) return;
  const answer = query.answers.find(([structure]) => structure === plane.app.shown()) || query.answers[0];
  const strokes = [{ colour: COLOUR.quiet, dash: [2, 3], width: 1 },
                   { colour: COLOUR.selected, dash: [], width: 1.2 },
                   { colour: COLOUR.next, dash: [], width: 2.2 }];
  if (answer !== undefined) {
    const [, ids, nodes] = answer;
    for (const [kind, objects] of nodes) {
      const there = objects.filter(id => alive[id]);
      if (there.length === 0) continue;
      const pad = 4 + Math.min(5, Math.log2(there.length));
      const x = there.map(id => plane.sx[id]), y = there.map(id => plane.sy[id]);
      const left = Math.min(...x) - pad, top = Math.min(...y) - pad;
      context.strokeStyle = strokes[kind].colour;
      context.lineWidth = strokes[kind].width;
      context.setLineDash(strokes[kind].dash);
      context.strokeRect(left, top, Math.max(...x) + pad - left, Math.max(...y) + pad - top);
    }
    context.setLineDash([]);
    for (const id of ids) {
      if (alive[id]) dot(context, plane.sx[id], plane.sy[id], 5.5, COLOUR.first);
    }
  }
  const [[x0, x1], [y0, y1]] = query.box;
  const [left, bottom] = plane.onScreen(x0, y0), [right, top] = plane.onScreen(x1, y1);
  context.globalAlpha = 0.12;
  context.fillStyle = COLOUR.first;
  context.fillRect(left, top, right - left, bottom - top);
  context.globalAlpha = 1;
  context.strokeStyle = COLOUR.first;
  context.lineWidth = 2;
  context.strokeRect(left, top, right - left, bottom - top);
  const [, ids, nodes] = answer || [null, [], []];
  const count = kind => nodes.filter(node => node[0] === kind).length;
  const text = "query at t = " + shortText(query.at) + ": " + ids.length + " points; nodes: " +
    count(1) + " crossed, " + count(2) + " inside, " + count(0) + " outside";
  const [areaLeft, areaTop] = plane.rectangle;
  label(context, text, areaLeft + 40, areaTop + 12, COLOUR.text);
}

// The corners of attributes that are boxes, by the role of the structure.
const OUTLINES = {
  // The least and the largest on each axis. In space all edges, in one line that passes some twice.
  box: (plane, ids) => {
    const [left, right, bottom, top] = ids;
    if (ids.length < 2 * DRAWN.length) return [];
    if (plane.camera !== null) {
      const seen = cornersOf(ids.map((id, i) => X[i >> 1][id])).map(p => plane.seenAt(p));
      return [0, 1, 3, 2, 0, 4, 5, 1, 5, 7, 3, 7, 6, 2, 6, 4].map(i => seen[i]);
    }
    const x = [plane.sx[left], plane.sx[right]], y = [plane.sy[bottom], plane.sy[top]];
    return [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
  },
  // An edge a, b of the hull, and the points that are extreme along it, across it and against it.
  rectangle: (plane, [a, b, along, across, against]) => {
    if (against === undefined) return [];
    const [ax, ay] = plane.at(a), [bx, by] = plane.at(b);
    const length = Math.hypot(bx - ax, by - ay);
    if (!(length > 0)) return [];
    const ux = (bx - ax) / length, uy = (by - ay) / length;
    const place = id => {
      const [x, y] = plane.at(id);
      return [(x - ax) * ux + (y - ay) * uy, (y - ay) * ux - (x - ax) * uy];
    };
    const right = place(along)[0], left = place(against)[0], high = place(across)[1];
    const corner = (s, h) => [ax + s * ux - h * uy, ay + s * uy + h * ux];
    return [corner(left, 0), corner(right, 0), corner(right, high), corner(left, high)];
  },
};

function drawOutline(context, corners, colour, dash) {
  if (corners.length === 0) return;
  context.beginPath();
  for (const corner of corners) context.lineTo(...corner);
  context.closePath();
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}
