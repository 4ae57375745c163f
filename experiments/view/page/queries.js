// The queries of the scene, with the nodes that they look at, and attributes that are drawn as a figure: boxes, rectangles, strips, circles.

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
  const [areaLeft, areaTop, areaWidth] = plane.rectangle;
  const text = textsOfQuery(query, answer || [null, [], [], 0])
    .find((one, i, all) => i === all.length - 1 || context.measureText(one).width < areaWidth - 50);
  label(context, text, areaLeft + 40, areaTop + 12, COLOUR.text);
}
// In words, the longest first: the points, the nodes that are drawn, and how many the tree has looked at with those that are not.
function textsOfQuery(query, [, ids, nodes, all]) {
  const count = kind => nodes.filter(node => node[0] === kind).length;
  const found = "query at t = " + shortText(query.at) + ": " + counted(ids.length, "point");
  const drawn = found + "; nodes: " + count(1) + " crossed, " + count(2) + " inside, " + count(0) + " outside";
  return [drawn + "; with those below and in them, as kinex run counts: " + all, drawn + "; in all " + all, drawn, found];
}

// Of the directions of the shown structure, and of those at right angles to them if there are two sides, the first along which the
// objects of each side are the extreme ones and the measure of the extents is least: { vectors, ends, extents } by side; null: none.
function bestAlong(plane, ids, sides, measure) {
  if (ids.length !== 2 * sides) return null;
  const {directions, members} = DATA.structures[plane.app.shown()];
  const along = ([ux, uy]) => id => X[0][id] * ux + X[1][id] * uy;
  const present = (members || [...Array(OBJECTS).keys()]).filter(id => alive[id] && !IS_LINE[id]);
  const all = directions.map(u => {
    const places = present.map(along(u));
    return [
      places.reduce((a, b) => Math.min(a, b), Infinity),
      places.reduce((a, b) => Math.max(a, b), -Infinity)
    ];
  });
  const tolerance = 1e-3 / plane.scale;  // a thousandth of a pixel
  let best = null, least = Infinity;
  for (let i = 0; i < directions.length / sides; ++i) {
    const of = [i, i + directions.length / 2].slice(0, sides);
    const extents = of.map(j => all[j][1] - all[j][0]);
    const touched = of.every((j, side) => {
      const places = ids.slice(2 * side, 2 * side + 2).map(along(directions[j]));
      return Math.min(...places) - all[j][0] < tolerance &&
          all[j][1] - Math.max(...places) < tolerance;
    });
    if (!touched || !(measure(extents) < least)) continue;
    least = measure(extents);
    best = {vectors: of.map(j => directions[j]), ends: of.map(j => all[j]), extents};
  }
  return best;
}
function boxAlong(plane, ids, measure) {
  const found = bestAlong(plane, ids, 2, measure);
  if (found === null) return [];
  const [[ux, uy], [vx, vy]] = found.vectors, [s, t] = found.ends;
  return [[0, 0], [1, 0], [1, 1], [0, 1]].map(
      ([i, j]) => plane.onScreen(s[i] * ux + t[j] * vx, s[i] * uy + t[j] * vy));
}

// The figure of an attribute with these ids, of a role that has one. An object may have left that a later log record of this instant takes
// out of the attribute: then a figure that is one as a whole is not drawn, of others the parts without it are.
const IN_PARTS = ["crossings", "next_lines", "walls"];
function outlineNow(plane, role, ids) {
  return IN_PARTS.includes(role) || ids.every(id => alive[id]) ? OUTLINES[role](plane, ids) : [];
}
// The figures of attributes by the role of the structure: the corners of a box or a rectangle; else shapes (figures.js).
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
  // An edge a, b and the point that is farthest from its line: the lines through both, across the picture, the edge, and the way between.
  strip: (plane, [a, b, across]) => {
    if (across === undefined) return [];
    const p = plane.at(a), q = plane.at(b), far = plane.at(across);
    const length = Math.hypot(...minus(q, p));
    if (!(length > 0)) return [];
    const [ux, uy] = minus(q, p).map(d => d / length);
    const [, , width, height] = plane.rectangle, reach = 2 * (width + height);
    const line = ([x, y]) => ({ from: [x - reach * ux, y - reach * uy], to: [x + reach * ux, y + reach * uy] });
    const along = (far[0] - p[0]) * ux + (far[1] - p[1]) * uy;
    return [line(p), line(far), { from: p, to: q, wide: true }, { dot: far },
            { from: far, to: [p[0] + along * ux, p[1] + along * uy], faint: true }];
  },
  // The figures along fixed directions. A strip: two points, the lines through both across the direction, and the way between.
  strip_along: (plane, ids) => {
    const found = bestAlong(plane, ids, 1, ([extent]) => extent);
    if (found === null) return [];
    const [[ux, uy]] = found.vectors, [
      p, q
    ] = ids.map(id => plane.at(id)).sort((a, b) => a[0] * ux - a[1] * uy - b[0] * ux + b[1] * uy);
    const [, , width, height] = plane.rectangle, reach = 2 * (width + height);
    const line = ([x, y]) =>
        ({from: [x - reach * uy, y - reach * ux], to: [x + reach * uy, y + reach * ux]});
    const gap = found.extents[0] * plane.scale;
    return [
      line(p), line(q), {dot: p}, {dot: q},
      {from: p, to: [p[0] + gap * ux, p[1] - gap * uy], faint: true}
    ];
  },
  // A box: the points that are extreme along one direction, against it, and along and against the one at right angles to it.
  area_along: (plane, ids) => boxAlong(plane, ids, ([width, height]) => width * height),
  perimeter_along: (plane, ids) => boxAlong(plane, ids, ([width, height]) => width + height),
  // The points on the smallest circle: two that are its diameter, or three and more.
  circle: (plane, ids) => {
    const p = ids.map(id => plane.at(id)), dots = p.map(dot => ({ dot }));
    if (p.length < 2) return dots;
    const middle = (a, b) => a.map((x, i) => (x + b[i]) / 2);
    if (p.length === 2) {
      return [{ centre: middle(p[0], p[1]), radius: Math.hypot(...minus(p[1], p[0])) / 2 },
              { from: p[0], to: p[1], faint: true }, ...dots];
    }
    // Of three that are far apart: some may be in one place just now.
    const twice = (a, b, c) => Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    let best = [p[0], p[1], p[2]];
    p.forEach((a, i) => p.slice(0, i).forEach((b, j) => p.slice(0, j).forEach(c => {
      if (twice(a, b, c) > twice(...best)) best = [a, b, c];
    })));
    const around = circleThrough(...best);
    return [around, ...p.map(q => ({ from: around.centre, to: q, faint: true })), ...dots];
  },
  // Two points with the circle that has them as diameter (in space a ball): no other point is in it.
  diameter: (plane, [a, b]) => {
    if (b === undefined) return [];
    const p = plane.at(a), q = plane.at(b), centre = p.map((x, i) => (x + q[i]) / 2);
    const radius = distanceOnScreen(plane, a, b) / 2;
    // Rings may not hide the circle; where the points hide it, a ring shows the place.
    const dots = radius > 16 ? [{ dot: p }, { dot: q }] : radius < 6 ? [{ dot: centre }] : [];
    return [{ centre, radius }, { from: p, to: q, wide: true }, ...dots];
  },
  // Two points of different colours that are nearest in the maximum norm: the square around the first one with the second on its
  // border has no point of the second one's colour inside.
  square: (plane, [a, b]) => {
    if (b === undefined) return [];
    const p = plane.at(a), q = plane.at(b), half = Math.max(...minus(q, p).map(Math.abs));
    const corner = i => [p[0] + (i === 1 || i === 2 ? half : -half), p[1] + (i > 1 ? half : -half)];
    const sides = [0, 1, 2, 3].map(i => ({ from: corner(i), to: corner((i + 1) % 4) }));
    return [...sides, { from: p, to: q, wide: true }, ...(half > 8 ? [{ dot: p }, { dot: q }] : [])];
  },
  // Two discs with the gap between them.
  gap: (plane, [a, b]) => {
    if (b === undefined) return [];
    const p = plane.at(a), q = plane.at(b), apart = distanceOnScreen(plane, a, b);
    const [r, s] = [a, b].map(id => HALF.length > 0 ? Math.max(0, HALF[0][id] * plane.scale) : 0);
    const along = share => p.map((x, i) => x + share / apart * (q[i] - x));
    return [{ centre: p, radius: r }, { centre: q, radius: s },
            ...(apart > r + s ? [{ from: along(r), to: along(apart - s), wide: true }] : [])];
  },
  // Orders of lines: the vertices of their arrangement. In the list of a line those behind it cross it.
  crossings: (plane, ids) => {
    const n = Math.floor(Math.sqrt(ids.length)), shapes = [];
    ids.slice(0, n).sort((a, b) => a - b).forEach((line, i) => {
      const row = ids.slice((i + 1) * n, (i + 2) * n);
      row.slice(row.indexOf(line) + 1).filter(other => other > line && alive[line] && alive[other]).forEach(other => {
        const x = (X[1][other] - X[1][line]) / (X[0][line] - X[0][other]);
        if (isFinite(x)) shapes.push({ dot: plane.onScreen(x, X[0][line] * x + X[1][line]) });
      });
    });
    return shapes;
  },
  // A point, the line above, the line below, and so on: the ways straight up and down.
  next_lines: (plane, ids) => ids.flatMap((line, i) => {
    const point = ids[i - i % 3];
    if (line === point || !alive[point] || !alive[line]) return [];
    return [{ from: plane.at(point), to: [plane.sx[point], plane.heightAt(line, plane.sx[point])] }];
  }),
  // Two lines that cross, the line above their crossing, the line below, and so on: the walls. One without
  // an end goes to the border.
  walls: (plane, ids) => {
    const shapes = [], [, top, , height] = plane.rectangle;
    for (let i = 0; i + 3 < ids.length; i += 4) {
      const [l, m] = [ids[i], ids[i + 1]];
      if (!ids.slice(i, i + 4).every(id => alive[id])) continue;
      const x = (X[1][m] - X[1][l]) / (X[0][l] - X[0][m]);
      if (!isFinite(x)) continue;
      const dot = plane.onScreen(x, X[0][l] * x + X[1][l]);
      [[ids[i + 2], top], [ids[i + 3], top + height]].forEach(([line, border]) => shapes.push(
        { from: dot, to: [dot[0], line === l ? border : plane.heightAt(line, dot[0])], faint: true }));
      shapes.push({ dot });
    }
    return shapes;
  },
};

// Of sequences that are rows of so many objects: the length of a row.
const ROWS = { next_lines: 3, walls: 4 };
function rowLengthOf({ shape, role }, ids) {
  return shape === "orders" ? Math.floor(Math.sqrt(ids.length)) : ROWS[role] || 0;
}

function drawOutline(context, corners, colour, dash) {
  if (corners.length === 0) return;
  if (!Array.isArray(corners[0])) {
    drawShapes(context, corners, colour, { width: 2, dash });
    return drawShapes(context, corners.filter(shape => shape.wide), colour, { width: 4, dash });
  }
  context.beginPath();
  for (const corner of corners) context.lineTo(...corner);
  context.closePath();
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}
