const ROOM = 46;  // pixels between what is shown of configuration space and the edge
// Configuration space: in the frame of the first body the second one is a point, outside of the sum
// M of the first and the negated second, or inside while they overlap. The certificates of a proof
// are half-planes about it.
class Chart {
  constructor(app) {
    this.app = app;
    this.frame = new Frame();
    this.whole = false;
    this.stretch = 1;
  }
  fit() { this.frame.fit(); }
  turnOver() {
    this.whole = !this.whole;
    this.fit();
    this.app.changed();
  }

  draw(context, rectangle) {
    const { app } = this;
    const pair = app.pair();
    const [a, b] = pairOf(pair);
    const poses = [poseOf(a, app.u), poseOf(b, app.u)];
    const [left, top, width, height] = rectangle;
    context.save();
    context.beginPath();
    context.rect(left, top, width, height);
    context.clip();
    context.fillStyle = COLOUR.panel;
    context.fillRect(left, top, width, height);
    this.frame.rectangle = rectangle;
    const seen = nameOf(b) + " as seen from " + nameOf(a), longest = "close up, 1024 times as wide";
    const beside = [seen, longest].reduce((sum, text) => sum + context.measureText(text).width, 0) + 32 <= width;
    const captions = beside ? 22 : 38;  // the height of one or two lines
    this.places = new Places([left, top + captions, left + width, top + height]);
    this.stretch = 1;
    if (poses[0] !== null && poses[1] !== null) this.drawPair(context, rectangle, a, b, poses);
    context.restore();
    label(context, seen, left + 8, top + 13, COLOUR.quiet);
    const view = this.whole ? "the whole sum"
               : this.stretch > 1 ? "close up, " + this.stretch + " times as wide" : "close up";
    if (beside) label(context, view, left + width - 8, top + 13, COLOUR.quiet, "right");
    else label(context, view, left + 8, top + 29, COLOUR.quiet);
  }

  // Of all structures: the half-planes of the proof of this pair, in the frame of the first body.
  cells(pair, pose) {
    const { app } = this;
    return app.proofs.map((proofs, index) => {
      const claims = app.replays[index].lost ? [] : proofs.claims(pair);
      const failing = proofs.failingSlot(pair, app.k);
      const sides = [];
      claims.forEach((claim, slot) => {
        if (isHalfPlane(claim)) {
          sides.push({ slot, fails: slot === failing, chosen: claim.number === app.selected,
                       half: halfPlane(claim, pose) });
        }
      });
      return sides;
    });
  }

  drawPair(context, rectangle, a, b, poses) {
    const { app, frame } = this;
    const pose = relative(...poses), pair = app.pair();
    const t = this.point = [pose.x, pose.y];
    const sum = sumOf(a, b, pose);
    const all = joined(boxOf(sum), boxOf([t]));
    const reach = 3 * Math.max(all[1] - all[0], all[3] - all[2]);
    const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
      .map(([x, y]) => [t[0] + x * reach, t[1] + y * reach]);
    const cells = this.cells(pair, pose);
    const own = cells[app.shown()];
    const cell = clipped(square, own);
    this.setStretch(own, cell, all);
    let box = joined(this.box(own, cell, all), this.failingBox(own, square));
    if (this.turnOf(pair) !== null) box = this.withRoomAbout(t, 84 - ROOM, box);
    frame.show(rectangle, box, ROOM);
    const corners = frame.corners().map(p => this.stretched(p, 1 / this.stretch));
    const shownCell = sides => clipped(corners, sides).map(p => this.at(p));
    // M
    trace(context, sum.map(p => this.at(p)), true);
    context.fillStyle = COLOUR.line;
    context.fill();
    context.strokeStyle = COLOUR.point;
    context.lineWidth = 1.2;
    context.stroke();
    this.drawPath(context, a, b);
    if (own.length > 0) {
      trace(context, shownCell(own), true);
      context.fillStyle = app.colourOf(app.shown());
      context.globalAlpha = 0.16;
      context.fill();
      context.globalAlpha = 1;
    }
    cells.forEach((sides, index) => {
      if (sides.length === 0 || index === app.shown()) return;
      trace(context, shownCell(sides), true);
      context.strokeStyle = app.colourOf(index);
      context.setLineDash([5, 4]);
      context.lineWidth = 1.4;
      context.stroke();
      context.setLineDash([]);
    });
    if (app.other !== null && !app.other.lost) this.drawOther(context, pair, pose, corners);
    this.drawSides(context, own, corners);
    this.drawCentre(context, pair, pose);
    this.drawTurn(context, pair, pose);
    this.drawNames(context, sum, t, a, b);
  }

  // Near the sum tiles are long and thin: they are drawn wider, by a power of two, 1024 at most.
  setStretch(own, cell, all) {
    this.stretch = 1;
    this.along = [1, 0];
    if (this.whole || cell.length < 3 || !(sizeOf(boxOf(cell)) < 1.2 * sizeOf(all))) return;
    let longest = 0;
    cell.forEach((p, i) => {
      const q = cell[(i + 1) % cell.length], length = Math.hypot(q[0] - p[0], q[1] - p[1]);
      if (length <= longest) return;
      longest = length;
      this.along = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
    });
    const across = cell.map(p => this.along[0] * p[1] - this.along[1] * p[0]);
    const width = Math.max(...across) - Math.min(...across);
    const most = longest / (3 * width);
    if (most >= 2) this.stretch = 2 ** Math.min(10, Math.floor(Math.log2(most)));
  }
  // By a factor about the point, across the direction `along`.
  stretched([x, y], factor) {
    const [ex, ey] = this.along, [tx, ty] = this.point;
    const a = (x - tx) * ex + (y - ty) * ey, b = ((y - ty) * ex - (x - tx) * ey) * factor;
    return [tx + a * ex - b * ey, ty + a * ey + b * ex];
  }
  at(p) { return this.frame.at(this.stretched(p, this.stretch)); }

  // The tile with some room; everything if there is none, if it has no end, or if that is asked for.
  box(own, cell, all) {
    if (this.whole || own.length === 0 || cell.length < 3) return all;
    const grown = (box, room) => [box[0] - room, box[1] + room, box[2] - room, box[3] + room];
    const t = this.point;
    if (sizeOf(boxOf(cell)) < 1.2 * sizeOf(all)) {
      const box = joined(boxOf(cell.map(p => this.stretched(p, this.stretch))), boxOf([t]));
      return grown(box, 0.3 * sizeOf(box));
    }
    // It has no end, or none that is near: about the point, with the nearest side.
    const distances = own.map(({ half: { n, offset } }) =>
      Math.abs(n[0] * t[0] + n[1] * t[1] - offset) / Math.hypot(...n));
    const about = grown(boxOf([t]), Math.max(6 * Math.min(...distances), 0.06 * sizeOf(all)));
    return sizeOf(about) < sizeOf(all) ? about : all;
  }

  // With as many pixels about a point as the two normals of drawTurn need.
  withRoomAbout([x, y], pixels, box) {
    const [, , width, height] = this.frame.rectangle;
    const scaleOf = b => Math.min((width - 2 * ROOM) / (b[1] - b[0]), (height - 2 * ROOM) / (b[3] - b[2]));
    const grown = scale => {
      const far = pixels / scale;
      return scale > 0 && isFinite(scale) ? joined(box, [x - far, x + far, y - far, y + far]) : box;
    };
    return grown(scaleOf(grown(scaleOf(box))));  // more room makes all smaller, and so needs a little more
  }

  // So that the side that fails next is in sight: its place that is nearest to the point.
  failingBox(own, square) {
    const side = own.find(other => other.fails);
    if (!side) return boxOf([]);
    const ends = boundary(square, own, side, sizeOf(boxOf(square)) * 1e-9);
    const near = ends.length < 2 ? [] : [this.stretched(nearestOn(ends, this.point), this.stretch)];
    return boxOf(near);
  }

  drawPath(context, a, b) {
    const points = [];
    for (let i = 0; i <= 400; ++i) {
      const pa = poseOf(a, i / 400), pb = poseOf(b, i / 400);
      if (pa === null || pb === null) continue;
      const pose = relative(pa, pb);
      points.push(this.at([pose.x, pose.y]));
    }
    trace(context, points, false);
    context.strokeStyle = COLOUR.quiet;
    context.lineWidth = 0.8;
    context.setLineDash([1, 4]);
    context.stroke();
    context.setLineDash([]);
  }

  // Where each half-plane bounds what is shown of the tile.
  drawSides(context, own, corners) {
    const { app } = this;
    const colourOf = side => (side.chosen ? COLOUR.selected : side.fails ? COLOUR.failed
                            : app.colourOf(app.shown()));
    const rank = side => 2 * side.chosen + side.fails;  // what fails next, and what is selected, on top
    for (const side of [...own].sort((x, y) => rank(x) - rank(y))) {
      const wide = 1e-3 / this.frame.scale / this.stretch;
      const ends = boundary(corners, own, side, wide).map(p => this.at(p));
      if (ends.length < 2) continue;
      trace(context, ends, false);
      context.strokeStyle = colourOf(side);
      context.lineWidth = rank(side) > 0 ? 4 : 2;
      context.stroke();
      const [x, y] = this.besidePoint(middleOf(ends), ends);
      badge(context, String(side.slot + 1), x, y, colourOf(side));
      this.places.around(x, y, 9);
    }
  }

  // Where the rays of a proof that they overlap come from.
  drawCentre(context, pair, pose) {
    const { app } = this;
    if (app.replay.lost) return;
    const ray = app.proofs[app.shown()].claims(pair).find(claim => claim.form.figure === "ray");
    if (!ray) return;
    const [x, y] = this.at(sumOfPoints(partsOf(ray).slice(0, 2), pose));
    dot(context, x, y, 3, app.colourOf(app.shown()));
    label(context, "c", x - 7, y + 9, app.colourOf(app.shown()), "right");
    this.places.take([x - 16, y, x, y + 18]);
  }

  // The order of normals that fails next: its claim and its slot; null: none, or something else does.
  turnOf(pair) {
    const { app } = this;
    const proofs = app.proofs[app.shown()], slot = proofs.failingSlot(pair, app.k);
    if (slot < 0 || app.replay.lost) return null;
    const claim = proofs.claims(pair)[slot];
    return claim.form.figure === "normals" ? { claim, slot } : null;
  }
  // Its two normals, which will be parallel then.
  drawTurn(context, pair, pose) {
    const turning = this.turnOf(pair);
    if (turning === null) return;
    const { claim, slot } = turning;
    const from = this.at(this.point);
    const ends = partsOf(claim).map(({ z, numbers }) => {
      const n = z === 0 ? numbers : turn(pose, numbers), size = Math.hypot(n[0], n[1]);
      const step = 1 / (this.frame.scale * size);
      const [x, y] = this.at([this.point[0] + n[0] * step, this.point[1] + n[1] * step]);
      const length = Math.hypot(x - from[0], y - from[1]);
      return [from[0] + (x - from[0]) / length * 52, from[1] + (y - from[1]) / length * 52];
    });
    context.strokeStyle = COLOUR.failed;
    context.lineWidth = 2.5;
    for (const end of ends) {
      trace(context, [from, end], false);
      context.stroke();
      dot(context, ...end, 3, COLOUR.failed);
    }
    const [x, y] = middleOf(ends), length = Math.hypot(x - from[0], y - from[1]) || 1;
    const place = [from[0] + (x - from[0]) / length * 66, from[1] + (y - from[1]) / length * 66];
    badge(context, String(slot + 1), ...place, COLOUR.failed);
    this.places.around(...place, 9);
  }

  // A place on a segment that does not hide the point.
  besidePoint([x, y], [p, q]) {
    const [px, py] = this.at(this.point);
    const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    if (Math.hypot(px - x, py - y) > 30 || length < 90) return [x, y];
    return [x + (q[0] - p[0]) / length * 40, y + (q[1] - p[1]) / length * 40];
  }

  // The tile of the second run, if it is another one.
  drawOther(context, pair, pose, corners) {
    const { app } = this;
    const texts = list => list.map(claim => claim.text).join();
    const claims = app.otherProofs[app.shown()].claims(pair);
    if (texts(claims) === texts(app.proofs[app.shown()].claims(pair))) return;
    const sides = claims.filter(isHalfPlane).map(c => halfPlane(c, pose));
    if (sides.length === 0) return;
    trace(context, sides.reduce(clip, corners).map(p => this.at(p)), true);
    context.strokeStyle = COLOUR.second;
    context.lineWidth = 3;
    context.setLineDash([8, 5]);
    context.stroke();
    context.setLineDash([]);
  }

  drawNames(context, sum, t, a, b) {
    const { frame } = this;
    const [x, y] = this.at(t);
    dot(context, x, y, 5.5, COLOUR.back);
    dot(context, x, y, 4, COLOUR.text);
    this.places.around(x, y, 4);
    this.places.label(context, nameOf(b), x, y, COLOUR.text, true);
    const [left, top, width, height] = frame.rectangle;
    const inside = corners => middleOf(sum.reduce(
      (polygon, p, i) => {
        const q = sum[(i + 1) % sum.length];
        const n = [p[1] - q[1], q[0] - p[0]];  // inward: counter-clockwise
        return clip(polygon, { n, offset: n[0] * p[0] + n[1] * p[1] });
      }, corners));
    const [mx, my] = this.at(inside(frame.corners().map(p => this.stretched(p, 1 / this.stretch))));
    if (isNaN(mx) || Math.hypot(mx - x, my - y) < 20) return;
    const text = nameOf(a) + " \u2295 \u2212" + nameOf(b), half = context.measureText(text).width / 2 + 2;
    this.places.labelIn(context, text, Math.min(left + width - half, Math.max(left + half, mx)),
                        Math.min(top + height - 12, Math.max(top + 30, my)), COLOUR.quiet);
  }
}

const clipped = (polygon, sides) => sides.reduce((rest, side) => clip(rest, side.half), polygon);
// The part of a side's line that bounds the others, which may have the same line: they are `wide` wider.
function boundary(polygon, sides, side, wide) {
  const others = sides.filter(other => other !== side).map(({ half: { n, offset } }) =>
    ({ half: { n, offset: offset - wide * Math.hypot(...n) } }));
  return crossings(clipped(polygon, others), side.half);
}

// Where the line of a half-plane crosses the outline of a convex polygon.
function crossings(polygon, { n, offset }) {
  const value = p => n[0] * p[0] + n[1] * p[1] - offset;
  const result = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length], a = value(p), b = value(q);
    if ((a < 0) === (b < 0)) return;
    const f = a / (a - b);
    result.push([p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])]);
  });
  return result;
}
// A number on a small disc.
function badge(context, text, x, y, colour) {
  dot(context, x, y, 8.5, COLOUR.back);
  dot(context, x, y, 7.5, colour);
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = COLOUR.back;
  context.fillText(text, x, y + 0.5);
}
