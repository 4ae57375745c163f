// The picture of a scene of bodies: at the left the polygons where they are, with the features that
// the proof of a pair rests on; at the right that pair in configuration space.
class Arena {
  constructor(app) {
    this.app = app;
    this.frame = new Frame();
    this.chart = new Chart(app);
    this.everywhere = this.wholeRun();
  }
  fit() { this.frame.fit(); this.chart.fit(); }

  boxAt(u) {
    let box = boxOf([]);
    for (let body = 0; body < OBJECTS; ++body) {
      const pose = poseOf(body, u);
      if (pose !== null) box = joined(box, boxOf(worldPolygon(body, pose)));
    }
    return box;
  }
  wholeRun() {
    let box = boxOf([]);
    for (let i = 0; i <= 32; ++i) box = joined(box, this.boxAt(i / 32));
    return box;
  }

  // Everything that the run shows; two bodies that travel far are followed.
  box() {
    const now = this.boxAt(this.app.u);
    return OBJECTS > 2 || !(sizeOf(this.everywhere) > 1.8 * sizeOf(now)) ? this.everywhere : now;
  }

  draw(picture) {
    const context = picture.begin();
    const { width, height } = picture;
    const beside = width > 1.25 * height;
    const part = beside ? Math.max(width * 0.4, Math.min(width * 0.5, height)) : height * 0.45;
    this.poses = DATA.ids.map((_, body) => poseOf(body, this.app.u));
    this.frame.show(beside ? [0, 22, width - part - 8, height - 22]
                           : [0, 22, width, height - part - 30], this.box(), 30);
    context.save();
    context.beginPath();
    context.rect(...this.frame.rectangle);
    context.clip();
    const { frame } = this, [left, top, w, h] = frame.rectangle;
    this.places = new Places([left, top, left + w, top + h]);
    drawScales(context, frame.rectangle, frame.at([0, 0]), frame.scale, this.places);
    this.drawBodies(context);
    this.drawGroups(context);
    this.drawProof(context);
    this.drawBaselines(context);
    this.drawNames(context);
    context.restore();
    this.chart.draw(context, beside ? [width - part, 0, part, height - 4]
                                    : [0, height - part, width, part]);
  }

  drawBodies(context) {
    const { app } = this;
    const pair = pairOf(app.pair());
    const edges = app.replay.lost || app.replay.edges === null ? [] : app.replay.edges;
    const touching = new Set([...edges].flatMap(pairOf));
    this.outlines = this.poses.map((pose, body) =>
      (pose === null ? null : worldPolygon(body, pose).map(p => this.frame.at(p))));
    this.outlines.forEach((outline, body) => {
      if (outline === null) return;
      trace(context, outline, true);
      context.fillStyle = COLOUR.line;
      context.globalAlpha = pair.includes(body) ? 1 : 0.45;
      context.fill();
      context.strokeStyle = touching.has(body) ? COLOUR.failed : COLOUR.point;
      context.lineWidth = 1.2;
      context.stroke();
      if (outline.length <= 40) {
        for (const [x, y] of outline) dot(context, x, y, 2, COLOUR.point);
      }
      context.globalAlpha = 1;
    });
  }

  // What groups about one body show: outlines in its frame, the sides of its cell.
  drawGroups(context) {
    const { app } = this, { proof } = app.proofs[app.shown()];
    if (app.replay.lost) return;
    for (const group of proof.groups()) {
      if (group.about.length !== 1) continue;
      const [body] = group.about, pose = this.poses[body];
      if (!pose) continue;
      context.strokeStyle = app.colourOf(app.shown());
      context.lineWidth = 0.9;
      for (const [shape, , , points] of group.marks) {
        if (shape !== "outline") continue;
        trace(context, points.map(p => this.frame.at(carry(pose, p))), true);
        context.stroke();
      }
      for (const c of proof.certificatesOf(group.group)) {
        const { form, ids } = proof.certificate(c), is = c === app.selected;
        if (form.figure !== "beyond") continue;
        context.globalAlpha = is || body === app.hovered ? 1 : OBJECTS > 12 ? 0.12 : 0.3;
        this.drawCoordinate(context, form.direction, numbersOf(ids[1])[0],
                            is ? COLOUR.selected : app.colourOf(app.shown()), is ? 2.5 : 0.8, [3, 4]);
        context.globalAlpha = 1;
      }
    }
  }
  // The line of one coordinate along a direction.
  drawCoordinate(context, direction, value, colour, width, dash) {
    const n = [direction[0], direction[1] || 0];
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash);
    trace(context, crossings(this.frame.corners(), { n, offset: value })
      .map(p => this.frame.at(p)), false);
    context.stroke();
    context.setLineDash([]);
  }
  // Two bodies that a disc or a strip keeps apart, or holds together.
  drawVolume(context, { form, ids }, colour, width) {
    const [a, b] = ids.map(id => this.poses[id]), reach = numbersOf(ids[2])[0];
    if (!a || !b) return;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash([5, 4]);
    if (form.figure === "discs") {
      context.beginPath();
      context.arc(...this.frame.at([a.x, a.y]), reach * this.frame.scale, 0, 2 * Math.PI);
      context.stroke();
    }
    trace(context, [this.frame.at([a.x, a.y]), this.frame.at([b.x, b.y])], false);
    context.stroke();
    context.setLineDash([]);
    if (form.figure === "gap") {
      const [x, y] = [form.direction[0], form.direction[1] || 0];
      this.drawCoordinate(context, [x, y], x * a.x + y * a.y + reach, colour, width, [5, 4]);
    }
    for (const p of [a, b]) dot(context, ...this.frame.at([p.x, p.y]), 3, colour);
  }

  // Where a feature of body z of the pair is on the screen: its points; a corner's first is the apex.
  place(z, feature, numbers) {
    const body = pairOf(this.app.pair())[z], outline = this.outlines[body];
    if (!outline || !feature) return [];
    const [kind, first, last] = feature;
    if (kind === "corner" && numbers) {
      const sign = z === 0 ? 1 : -1;  // the second body is negated
      const apex = carry(this.poses[body], [sign * numbers[3], sign * numbers[4]]);
      return [this.frame.at(apex), outline[first], outline[last]];
    }
    if (kind === "edge" || (kind === "support" && first !== last)) {
      return [outline[first], outline[(first + 1) % outline.length]];
    }
    return [outline[kind === "across" ? last : first]];
  }

  mark(context, z, feature, numbers, colour, weight) {
    const points = this.place(z, feature, numbers);
    if (points.length === 0) return null;
    context.strokeStyle = colour;
    if (feature[0] === "corner" && points.length === 3) {
      context.lineWidth = 1;
      context.setLineDash([3, 3]);
      trace(context, [points[1], points[0], points[2]], false);
      context.stroke();
      context.setLineDash([]);
      dot(context, ...points[0], 3 + weight, colour);
      dot(context, ...points[0], 1.5 + weight, COLOUR.back);
      return points[0];
    }
    if (points.length === 2) {
      context.lineWidth = 2 + 1.5 * weight;
      trace(context, points, false);
      context.stroke();
      return middleOf(points);
    }
    dot(context, ...points[0], 3 + weight, colour);
    return points[0];
  }

  drawProof(context) {
    const { app } = this;
    const pair = app.pair(), index = app.shown(), proofs = app.proofs[index];
    this.labels = [];
    this.overlap = false;
    if (app.replays[index].lost) return;
    const claims = proofs.claims(pair), failing = proofs.failingSlot(pair, app.k);
    const contact = proofs.contact(pair, app.k, app.replays[index]);
    this.overlap = contact !== null;
    if (contact !== null && claims.length === 0) {
      contact.features.forEach((feature, z) => {
        const where = this.mark(context, z, feature, null, COLOUR.failed, 1.6);
        if (where) this.note(z, feature, where, "", COLOUR.failed);
      });
      return;
    }
    const through = proofs.marks(pair, "through");
    this.drawThrough(context, through);
    this.drawLines(context, proofs.marks(pair, "line"));
    const found = proofs.joined(pair);
    if (found) this.join(context, found, app.colourOf(index));
    // What fails next, and what is selected, come last, on top.
    const rank = slot => (claims[slot].number === app.selected ? 2 : slot === failing ? 1 : 0);
    const order = claims.map((_, slot) => slot).sort((x, y) => rank(x) - rank(y));
    for (const slot of order) {
      const claim = claims[slot], fails = slot === failing, { figure } = claim.form;
      const chosen = claim.number === app.selected;
      const colour = chosen ? COLOUR.selected : fails ? COLOUR.failed : app.colourOf(index);
      if (figure === "discs" || figure === "gap") {
        this.drawVolume(context, claim, colour, fails || chosen ? 2 : 1.2);
      }
      const parts = partsOf(claim), normals = figure === "normals";
      if (normals && !fails && !chosen) context.globalAlpha = 0.45;
      for (const part of figure === "ray" ? parts.slice(2) : parts) {
        const where = this.mark(context, part.z, part.feature, part.numbers, colour,
                                fails || chosen ? 1.6 : normals ? 0 : 1);
        const named = fails || chosen ||
          (isHalfPlane(claim) && (through.length === 0 || !part.line));
        if (where && named) {
          this.note(part.z, part.feature, where, String(slot + 1), colour);
        }
      }
      context.globalAlpha = 1;
    }
  }

  // One label for all certificates of a feature.
  note(z, feature, where, number, colour) {
    const key = z + feature.join();
    const known = this.labels.find(l => l.key === key);
    if (!known) {
      this.labels.push({ key, z, feature, where, numbers: number ? [number] : [], colour });
      return;
    }
    if (number && !known.numbers.includes(number)) known.numbers.push(number);
    if (colour === COLOUR.failed || colour === COLOUR.selected) known.colour = colour;
  }

  drawBaselines(context) {
    const { app } = this;
    app.proofs.forEach((proofs, index) => {
      if (index === app.shown() || app.replays[index].lost) return;
      const found = proofs.joined(app.pair());
      if (!found) return;
      found.forEach((feature, z) =>
        this.mark(context, z, feature, null, app.colourOf(index), 0.4));
      this.join(context, found, app.colourOf(index));
    });
  }

  // The shortest segment between two features.
  join(context, [fa, fb], colour) {
    const a = this.place(0, fa), b = this.place(1, fb);
    if (a.length === 0 || b.length === 0) return;
    const [from, to] = a.length === 2 ? [nearestOn(a, b[0]), b[0]] : [a[0], nearestOn(b, a[0])];
    trace(context, [from, to], false);
    context.strokeStyle = colour;
    context.lineWidth = 1.4;
    context.setLineDash([6, 4]);
    context.stroke();
    context.setLineDash([]);
  }

  // Lines through a vertex of each body.
  drawThrough(context, marks) {
    for (const mark of marks) {
      const [a, b] = mark.slice(2).map((part, z) => this.place(z, featureOf(part))[0]);
      if (!a || !b) continue;
      const d = [b[0] - a[0], b[1] - a[1]];
      trace(context, [-4, 5].map(f => [a[0] + f * d[0], a[1] + f * d[1]]), false);
      context.strokeStyle = this.app.colourOf(this.app.shown());
      context.lineWidth = 1.2;
      context.stroke();
    }
  }

  // A line in the frame of body z, as it is on the screen.
  line(context, z, [nx, ny, h]) {
    const pose = this.poses[pairOf(this.app.pair())[z]];
    if (pose === null) return;
    const sign = z === 0 ? 1 : -1;
    const n = turn(pose, [sign * nx, sign * ny]);
    const offset = h + n[0] * pose.x + n[1] * pose.y;
    trace(context, crossings(this.frame.corners(), { n, offset }).map(p => this.frame.at(p)), false);
    context.stroke();
  }

  // Lines of the bodies, the first one strong.
  drawLines(context, marks) {
    marks.forEach(([, , thing, z], i) => {
      context.strokeStyle = this.app.colourOf(this.app.shown());
      context.lineWidth = i === 0 ? 1.6 : 0.9;
      context.setLineDash(i === 0 ? [] : [4, 4]);
      this.line(context, z, numbersOf(thing));
    });
    context.setLineDash([]);
  }

  drawNames(context) {
    const pair = pairOf(this.app.pair());
    this.outlines.forEach((outline, body) => {
      if (outline === null) return;
      if (OBJECTS > 40 && !pair.includes(body) && body !== this.app.hovered) return;
      const [x, y] = middleOf(outline), half = context.measureText(nameOf(body)).width / 2 + 1;
      const box = [x - half, y - 7, x + half, y + 7], asked = pair.includes(body) || body === this.app.hovered;
      const colour = pair.includes(body) ? COLOUR.text : COLOUR.quiet;
      if (!asked && this.places.covered(box) > 0) return;
      this.places.labelIn(context, nameOf(body), x, y, colour);
    });
    this.drawFeatureNames(context, pair);
  }

  // Away from the bodies; where these are close to each other, to the sides of the gap between them,
  // those of the first body on one side and those of the second one on the other.
  drawFeatureNames(context, pair) {
    this.placed = [];
    if (this.labels.length === 0) return;
    const [left, top, width, height] = this.frame.rectangle;
    // A body that has left has no features here; its certificates may go with a later log record of the same instant.
    const middles = pair.map(body => (this.outlines[body] === null ? null : middleOf(this.outlines[body])));
    const across = middles.includes(null) ? [0, 0] : [middles[0][1] - middles[1][1], middles[1][0] - middles[0][0]];
    const size = Math.hypot(...across) || 1;
    const narrow = !this.overlap && this.labels.some(p => p.z === 0 && this.labels.some(q => q.z === 1 &&
      Math.hypot(p.where[0] - q.where[0], p.where[1] - q.where[1]) < 90));
    for (const { where } of this.labels) this.places.around(...where, 4);
    // Those whose labels go farthest come first: their leaders have the way free.
    const ahead = ({ z, where }) => (z === 0 ? 1 : -1) * dotProduct(where, across);
    const order = narrow ? [...this.labels].sort((p, q) => ahead(q) - ahead(p)) : this.labels;
    for (const { z, feature, where, numbers, colour } of order) {
      const away = Math.hypot(where[0] - middles[z][0], where[1] - middles[z][1]) || 1;
      const side = (z === 0 ? 1 : -1) / size;
      const d = narrow ? across.map(c => c * side * 64)
                       : [0, 1].map(i => (where[i] - middles[z][i]) / away * 20);
      let [x, y] = [where[0] + d[0], where[1] + d[1]];
      const text = featureName(pair[z], feature) +
        (numbers.length > 0 ? " (" + numbers.sort().join(", ") + ")" : "");
      let align = d[0] > 12 ? "left" : d[0] < -12 ? "right" : "center";
      const room = context.measureText(text).width + 4;
      const before = how => (how === "left" ? 2 : how === "right" ? room : room / 2);
      const within = (at, how) => Math.max(left + before(how), Math.min(left + width - (room + 2 - before(how)), at));
      const boxAt = (at, level, how) => [at - before(how), level - 7, at - before(how) + room, level + 7];
      y = Math.max(top + 10, Math.min(top + height - 10, y));
      // Up or down from there, beside it or at the other side of its line, where it covers and crosses least.
      const step = d[1] > 0 ? 15 : -15, beside = [14, 50, 90].flatMap(shift => [[shift, "left"], [-shift, "right"]]);
      const sides = !narrow ? [[0, align]] : align === "center" ? [[0, align], ...beside]
                  : [[0, align], [0, align === "left" ? "right" : "left"]];
      const tries = [0, 1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6].flatMap(i => sides.map(side => [y + i * step, ...side]));
      let least = Infinity, chosen = null;
      for (const [level, shift, how] of tries) {
        const at = within(x + shift, how);
        const covered = this.places.covered(boxAt(at, level, how)) + (narrow ? this.places.crossed(where, [at, level]) : 0);
        if (covered < least) [least, chosen] = [covered, [at, level, how]];
        if (covered <= (narrow ? 1 : 0)) break;  // a leader begins in the place of its own feature
      }
      [x, y, align] = chosen;
      this.placed.push({ text, where, end: narrow ? [x, y] : null, box: boxAt(x, y, align) });
      this.places.take(boxAt(x, y, align));
      if (narrow) {
        this.places.takeLine(where, [x, y]);
        trace(context, [where, [x, y]], false);
        context.strokeStyle = colour;
        context.lineWidth = 0.7;
        context.stroke();
      }
      label(context, text, x, y, colour, align);
    }
  }

  nearest(x, y) {
    let best = null, distance = 1600;
    (this.outlines || []).forEach((outline, body) => {
      if (outline === null || !this.frame.holds(x, y)) return;
      const [mx, my] = middleOf(outline);
      const d = (mx - x) ** 2 + (my - y) ** 2;
      if (d < distance) { distance = d; best = body; }
    });
    return best;
  }
  under(x, y) { return this.chart.frame.holds(x, y) ? this.chart.frame : this.frame; }
  scaleAbout(factor, x, y) {
    this.last = this.under(x, y);
    this.last.scaleAbout(factor, x, y);
  }
  move(dx, dy, x, y) { this.under(x, y).move(dx, dy); }
}

function nearestOn(segment, p) {
  if (segment.length < 2) return segment[0];
  const [a, b] = segment, d = [b[0] - a[0], b[1] - a[1]];
  const f = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1] || 1);
  const g = Math.max(0, Math.min(1, f));
  return [a[0] + g * d[0], a[1] + g * d[1]];
}
