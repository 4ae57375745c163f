// The picture in the plane, or of space in projection (space.js): points, the attribute by its shape (tuples, cycle, object, sequence), and
// the certificates by their figures.

// What encloses the points reaches beyond their box: the circle around a square by this factor, rectangles mostly by less.
const ENCLOSING = ["circle", "rectangle", "area_along", "perimeter_along"], BEYOND = Math.SQRT2;

class Plane {
  constructor(app) {
    this.app = app;
    this.camera = AXES > 2 ? new Camera() : null;
    this.fit();
  }
  fit() { this.zoom = 1; this.dx = this.dy = 0; }

  // Screen coordinates of all objects, in this.sx and this.sy; in space how near they are, in this.sz.
  project([left, top, width, height]) {
    const box = this.box = boxToShow(this.app.certificateObjects(), this.app.shown(), this.app.replay), [x0, x1, y0, y1] = box;
    const room = Math.min(40, width / 8, height / 8);
    this.places = new Places([left, top, left + width, top + height]);
    this.steep = this.steepness(width - 2 * room, height - 2 * room);
    // In space the ball around the box fits, however it is turned.
    this.reach = this.camera === null ? 0 : Math.hypot(...DRAWN.map(axis => box[2 * axis + 1] - box[2 * axis])) / 2;
    const fitted = this.camera !== null
      ? (Math.min(width, height) - 2 * room) / (2 * this.reach)
      : Math.min((width - 2 * room) / (x1 - x0), (height - 2 * room) / (y1 - y0) / this.steep) /
          (ENCLOSING.includes(DATA.structures[this.app.shown()].role) ? BEYOND : 1);
    const scale = this.zoom * (isFinite(fitted) && fitted > 0 ? fitted : 1);
    const cx = this.cx = left + width / 2, cy = this.cy = top + height / 2;
    this.scale = scale;
    const [mx, my] = this.middle = DRAWN.map(axis => (box[2 * axis] + box[2 * axis + 1]) / 2 || 0);
    this.sx = this.sx || new Float64Array(OBJECTS);
    this.sy = this.sy || new Float64Array(OBJECTS);
    this.sz = this.sz || new Float64Array(OBJECTS);
    for (let object = 0; object < OBJECTS; ++object) {
      if (this.camera !== null) {
        const [right, up, near] = this.camera.seen(minus(this.positionOf(object), this.middle));
        this.sx[object] = cx + this.dx + right * scale;
        this.sy[object] = cy + this.dy - up * scale;
        this.sz[object] = near;
        continue;
      }
      // Of a line the point in the middle of the picture.
      const x = IS_LINE[object] ? mx - this.dx / scale : X[0][object];
      const y = IS_LINE[object] ? X[0][object] * x + X[1][object] : X[1][object];
      this.sx[object] = cx + this.dx + (x - mx) * scale;
      this.sy[object] = cy + this.dy - (y - my) * scale * this.steep;
    }
  }
  // How many times as long a unit up is as one to the right: 1, but in scenes with lines, of which only what is above and below
  // matters, what fills the picture.
  steepness(width, height) {
    if (!IS_LINE.includes(1)) return 1;
    const ratio = height / lengthOf(WHOLE_RUN, 1) / (width / lengthOf(WHOLE_RUN, 0));
    return ratio > 0.5 && ratio < 2 ? 1 : ratio;
  }
  // The height on the screen of a line at a place there.
  heightAt(line, x) { return this.sy[line] - X[0][line] * this.steep * (x - this.sx[line]); }
  // A line across the picture.
  across(line) {
    const [left, , width] = this.rectangle;
    return { from: [left, this.heightAt(line, left)], to: [left + width, this.heightAt(line, left + width)] };
  }
  // A claim about lines: the lines, and each point with the way straight up or down to the first.
  linesOf(ids) {
    if (ids.length === 4 && IS_LINE[ids[2]] && !IS_LINE[ids[1]]) {  // two pairs of a line and a point
      return [...this.linesOf(ids.slice(0, 2)), ...this.linesOf(ids.slice(2))];
    }
    const lines = ids.filter(id => IS_LINE[id]), points = ids.filter(id => !IS_LINE[id]);
    const threads = points.map(id => ({ from: this.at(id),
                                        to: [this.sx[id], this.heightAt(lines[0], this.sx[id])] }));
    return [...lines.map(line => this.across(line)), ...threads, ...points.map(id => ({ dot: this.at(id) }))];
  }
  shapesOf(claim) {
    if (claim.ids.some(id => id >= OBJECTS)) return claimOfWalls(this, claim.ids);
    return claim.ids.some(id => IS_LINE[id]) ? this.linesOf(claim.ids) : shapesOf(claim, this);
  }
  drawLines(context) {
    drawShapes(context, linesThere().map(line => this.across(line)), COLOUR.point, { width: OBJECTS > 300 ? 0.5 : 1 });
  }
  at(id) { return [this.sx[id], this.sy[id]]; }
  positionOf(id) { return DRAWN.map(axis => X[axis][id]); }
  // The place of a position in space.
  seenAt(position) {
    const [right, up] = this.camera.seen(minus(position, this.middle));
    return [this.cx + this.dx + right * this.scale, this.cy + this.dy - up * this.scale];
  }
  onScreen(x, y) {
    const [mx, my] = this.middle;
    return [this.cx + this.dx + (x - mx) * this.scale, this.cy + this.dy - (y - my) * this.scale * this.steep];
  }

  draw(picture) {
    const context = picture.begin();
    this.drawIn(context, [0, 20, picture.width, picture.height - 20]);
  }
  drawIn(context, rectangle) {
    const { app } = this;
    place(app.u);
    this.rectangle = rectangle;
    this.project(rectangle);
    const marked = app.certificateObjects();
    context.save();
    context.beginPath();
    context.rect(...rectangle);
    context.clip();
    this.drawAxes(context);
    this.drawExtents(context, marked);
    drawWeights(context, this);
    this.drawLines(context);
    this.drawAttribute(context);
    this.drawCertificates(context);
    drawQuery(context, this);
    this.drawChange(context, marked);
    this.drawDots(context);
    this.drawChosen(context);
    const radius = OBJECTS > 2000 ? 1.5 : OBJECTS > 300 ? 2.2 : 3.4;
    drawMarks(context, this, radius);
    for (const object of marked) {
      if (alive[object] && !IS_LINE[object]) drawMarked(context, this, object, radius + 1.6);
    }
    this.drawNames(context, marked);
    context.restore();
  }

  drawAxes(context) {
    if (this.camera !== null) {
      if (this.box[0] <= this.box[1]) drawSpaceScales(context, this, this.box);
      return;
    }
    const [mx, my] = this.middle;
    const origin = [this.cx + this.dx - mx * this.scale, this.cy + this.dy + my * this.scale * this.steep];
    drawScales(context, this.rectangle, origin, this.scale, this.places, this.steep);
  }

  // The outlines of discs and boxes.
  drawExtents(context, marked) {
    if (HALF.length === 0) return;
    const outline = (object, colour, width) => {
      if (this.camera !== null && EXTENT_AXES > 1) {
        const box = DRAWN.flatMap(axis => [-1, 1].map(side => X[axis][object] + side * Math.max(0, HALF[axis][object])));
        return drawWires(context, this, box, colour, width);
      }
      const x = this.sx[object], y = this.sy[object];
      const hx = Math.max(0, HALF[0][object] * this.scale);
      const hy = Math.max(0, HALF[1][object] * this.scale);
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.beginPath();
      if (EXTENT_AXES === 1) {
        context.arc(x, y, hx, 0, 2 * Math.PI);
      } else {
        context.moveTo(x - hx, y - hy);
        context.lineTo(x + hx, y - hy);
        context.lineTo(x + hx, y + hy);
        context.lineTo(x - hx, y + hy);
        context.closePath();
      }
      context.stroke();
    };
    for (let object = 0; object < OBJECTS; ++object) {
      if (alive[object]) outline(object, toneOf(object), OBJECTS > 300 ? 0.5 : 1);
    }
    for (const object of marked) {
      if (object < OBJECTS && alive[object]) outline(object, COLOUR.failed, 1.6);
    }
  }

  segments(context, codes, colour, width, dash) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash || []);
    const ends = code => [Math.floor(code / OBJECTS), code % OBJECTS];
    const depthOf = code => ends(code).reduce((sum, id) => sum + this.sz[id], 0) / 2;
    const layers = this.camera === null ? [{ alpha: 1, things: codes }] : inLayers(codes, depthOf, this.reach);
    for (const { alpha, things } of layers) {
      context.globalAlpha = alpha;
      context.beginPath();
      for (const code of things) {
        const [a, b] = ends(code);
        if (!alive[a] || !alive[b]) continue;
        const [p, q] = IS_LINE[a] ? [b, a] : [a, b];  // a pair of a point and a line: straight down
        context.moveTo(this.sx[p], this.sy[p]);
        if (IS_LINE[q]) {
          context.lineTo(this.sx[p], this.heightAt(q, this.sx[p]));
        } else {
          context.lineTo(this.sx[q], this.sy[q]);
        }
      }
      context.stroke();
    }
    context.globalAlpha = 1;
    context.setLineDash([]);
  }

  path(context, ids, closed) {
    context.beginPath();
    for (const id of ids) if (alive[id]) context.lineTo(this.sx[id], this.sy[id]);
    if (closed) context.closePath();
  }

  // The rings of an attribute that is drawn as a figure, again on top of lines.
  drawDots(context) {
    const { replay } = this.app, { role } = DATA.structures[this.app.shown()];
    if (OUTLINES[role] === undefined || replay.lost || !IS_LINE.includes(1)) return;
    const dots = outlineNow(this, role, replay.row).filter(shape => shape.dot);
    drawShapes(context, dots, COLOUR.first, { width: 2 });
  }

  drawAttribute(context) {
    const { replay, other } = this.app;
    const structure = DATA.structures[this.app.shown()];
    if (isStar(structure)) {
      if (!replay.lost) drawCell(context, this, structure.query, replay.ids, COLOUR.first, []);
      if (other !== null && !other.lost && other.ids.join() !== replay.ids.join()) {
        drawCell(context, this, structure.query, other.ids, COLOUR.second, [6, 4]);
      }
      return;
    }
    const { role } = structure;
    if (OUTLINES[role] !== undefined) {
      if (!replay.lost) drawOutline(context, outlineNow(this, role, replay.row), COLOUR.first, []);
      if (other !== null && !other.lost && other.row.join() !== replay.row.join()) {
        drawOutline(context, outlineNow(this, role, other.row), COLOUR.second, [6, 4]);
      }
      return;
    }
    const thin = OBJECTS > 1500 ? 0.5 : OBJECTS > 300 ? 0.8 : 1.3;
    const both = other !== null && !other.lost;
    if (replay.tuples !== null && !replay.lost) {
      this.segments(context, replay.edges, COLOUR.first, thin);
    }
    if (replay.tuples !== null && both) {
      const only = (a, b) => [...a.edges].filter(code => b.lost || !b.edges.has(code));
      if (!replay.lost) this.segments(context, only(replay, other), COLOUR.first, thin + 1.4);
      this.segments(context, only(other, replay), COLOUR.second, thin + 1.2, [6, 4]);
    }
    const outline = (ids, colour, dash) => {
      this.path(context, ids, replay.shape === "cycle");
      context.strokeStyle = colour;
      context.globalAlpha = replay.shape === "cycle" ? 1 : 0.45;
      context.lineWidth = replay.shape === "cycle" ? 2 : 1;
      context.setLineDash(dash);
      context.stroke();
      context.setLineDash([]);
      context.globalAlpha = 1;
    };
    if (replay.shape === "cycle" && !replay.lost) {
      this.path(context, replay.ids, true);
      context.fillStyle = COLOUR.fill;
      context.fill();
    }
    const ring = (ids, colour, radius, width = 2.5) => {
      for (const id of ids) {
        if (!alive[id] || IS_LINE[id]) continue;
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.beginPath();
        context.arc(this.sx[id], this.sy[id], radius, 0, 2 * Math.PI);
        context.stroke();
      }
    };
    // An order by a key is joined; the leaves of a tree, for example, are a set in a picture of the plane.
    const isOrder = replay.shape === "sequence" && DATA.structures[this.app.shown()].key !== null;
    if (replay.shape === "sequence" && !isOrder) {
      const radius = OBJECTS > 300 ? 3.5 : 6;
      if (!replay.lost) ring(replay.ids, COLOUR.first, radius, 1.2);
      const own = new Set(replay.lost ? [] : replay.ids);
      if (both) ring(other.ids.filter(id => !own.has(id)), COLOUR.second, radius + 3, 1.2);
    } else if (replay.shape === "cycle" || (isOrder && OBJECTS <= 300)) {
      if (!replay.lost) outline(replay.ids, COLOUR.first, []);
      if (both && other.ids.join() !== replay.ids.join()) outline(other.ids, COLOUR.second, [6, 4]);
    }
    if (replay.shape !== "object") return;
    if (!replay.lost) ring(replay.ids, COLOUR.first, 9);
    if (both && other.ids[0] !== replay.ids[0]) ring(other.ids, COLOUR.second, 12);
  }

  // All certificates faintly if there are few, or if that is asked for; the group of the one that is selected.
  drawCertificates(context) {
    const { app } = this, { proof } = app;
    if (app.replay.lost || proof === null) return;
    const shapes = c => this.shapesOf(proof.certificate(c));
    if (app.showsAll()) {
      const alpha = proof.live.size > 400 ? 0.2 : proof.live.size > 80 ? 0.35 : 0.6;
      this.drawAll(context, proof.live, shapes, alpha);
    }
    const group = app.selectedGroup();
    if (group !== null) {
      this.drawAll(context, proof.certificatesOf(group.group), shapes, 0.9);
      this.drawMarks(context, group);
      if (group.about.length === 2 && group.about.every(id => id < OBJECTS && alive[id])) {
        drawShapes(context, group.about.some(id => IS_LINE[id]) ? this.linesOf(group.about)
                                : [{ from: this.at(group.about[0]), to: this.at(group.about[1]) }],
                   COLOUR.selected, { width: 3.5 });
      }
    }
  }
  // What fails next, if it is drawn.
  nextShapes() {
    const { app } = this, { proof } = app;
    const next = app.replay.lost || proof === null ? null : proof.next(app.k);
    return next !== null && this.isThere(next[0]) ? this.shapesOf(proof.certificate(next[0])) : [];
  }
  // What fails next and what is selected, on top.
  drawChosen(context) {
    const { app } = this, { proof, selected } = app;
    drawShapes(context, this.nextShapes(), COLOUR.next, { width: 2.2, dash: [7, 4] });
    if (app.replay.lost || proof === null || selected === null || !proof.live.has(selected) || !this.isThere(selected)) return;
    drawShapes(context, this.shapesOf(proof.certificate(selected)), COLOUR.selected, { width: 2.6 });
    this.drawRoles(context, proof.certificate(selected));
  }
  drawAll(context, certificates, shapes, alpha) {
    for (const c of certificates) {
      if (!this.isThere(c)) continue;
      drawShapes(context, shapes(c).filter(shape => !shape.dot), COLOUR.proof, { width: 0.9, alpha });
    }
  }
  // Whether a certificate is drawn: of objects that are there, and walls.
  isThere(c) { return this.areThere(this.app.proof.certificate(c).ids); }
  areThere(ids) { return ids.every(id => (id < OBJECTS ? alive[id] === 1 : wallOf(id) !== null)); }
  // Chains of a group: a hull, the winners to come; and those of its children in its tree.
  drawMarks(context, group) {
    const { proof } = this.app;
    const chain = (marks, colour, width, dash) => {
      for (const [shape, , objects] of marks) {
        if (shape !== "chain") continue;
        this.path(context, objects, false);
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.setLineDash(dash);
        context.stroke();
        context.setLineDash([]);
        for (const id of objects) {
          if (alive[id]) dot(context, this.sx[id], this.sy[id], 3 + width / 2, colour);
        }
      }
    };
    chain(group.marks, COLOUR.selected, 5, []);
    let number = 0;
    if (group.place === null) return;
    for (const child of proof.groups()) {
      if (child.parent !== group.place) continue;
      chain(child.marks, COLOUR[number++ === 0 ? "s1" : "s4"], 2, number === 1 ? [] : [6, 3]);
    }
  }
  // The roles of the points of a certificate beside them.
  drawRoles(context, { form, ids }) {
    form.roles.forEach(({ name }, i) => {
      const wall = wallOf(ids[i]), [x, y] = wall === null ? this.at(ids[i]) : wallNameAt(this, wall);
      this.places.label(context, name, x, y + 2, COLOUR.selected, true);
    });
  }

  // The last event: what it took away and what it put there, and the certificate that failed.
  drawChange(context, marked) {
    const { app } = this;
    // A patch of background under what fails next: it may lie on edges of the attribute. Where it is of the last event, too, both are seen.
    drawShapes(context, this.nextShapes().filter(shape => shape.from && !shape.faint), COLOUR.back, { width: 5 });
    const { proof, k } = app, next = this.nextShapes().length > 0 ? proof.certificate(proof.next(k)[0]).ids : [];
    for (const line of marked.filter(object => alive[object] && IS_LINE[object])) {
      drawShapes(context, [this.across(line)], COLOUR.failed, { width: next.includes(line) ? 5 : 1.6 });
    }
    if (marked.length === 0) return;
    const failed = app.failedClaim();
    if (failed !== null && this.areThere(failed.ids)) {
      drawShapes(context, this.shapesOf(failed), COLOUR.failed, { dash: [2, 3] });
    }
    if (app.replay.tuples === null || app.shown() !== app.eventStructure()) return;
    const codes = ids => app.replay.cut(ids).flatMap(sidesOf);
    const [removed, added] = app.replay.changeAt(app.k);
    this.segments(context, codes(removed), COLOUR.failed, 1.6, [3, 4]);
    this.segments(context, codes(added), COLOUR.failed, 3);
  }

  drawNames(context, marked) {
    const [left, top, width, height] = this.rectangle;
    const isInSight = object => {
      const [x, y] = this.nameAt(object);
      return alive[object] && x >= left && y >= top && x <= left + width && y <= top + height;
    };
    const inSight = [...alive.keys()].filter(isInSight), tones = this.tonesOfNames(marked);
    const { replay, hovered } = this.app;
    const named = new Set(inSight.length <= 60 ? inSight : [...tones.keys()].filter(isInSight));
    if (replay.shape === "object") replay.ids.filter(isInSight).forEach(id => named.add(id));
    for (const object of named) this.places.around(...this.nameAt(object), 3);
    for (const [id, colour] of tones) {
      const wall = wallOf(id);
      if (wall !== null) this.places.label(context, nameOf(id), ...wallNameAt(this, wall), colour, true);
    }
    const asked = object => tones.has(object);
    for (const object of [...[...named].filter(asked), ...[...named].filter(object => !asked(object))]) {
      const colour = object !== hovered && tones.get(object) || COLOUR.text;
      this.places.label(context, nameOf(object), ...this.nameAt(object), colour, asked(object));
    }
  }
  // What must be named, with the tones of the names: what the last log record is about, the certificate that fails next and the one
  // that is selected.
  tonesOfNames(marked) {
    const { proof, replay, selected, hovered, k } = this.app, tones = new Map();
    const add = (ids, colour) => ids.forEach(id => { if (!tones.has(id)) tones.set(id, colour); });
    add(marked, COLOUR.failed);
    if (proof !== null && !replay.lost) {
      const next = proof.next(k);
      if (selected !== null && proof.live.has(selected)) add(proof.certificate(selected).ids, COLOUR.selected);
      if (next !== null && this.isThere(next[0])) add(proof.certificate(next[0]).ids, COLOUR.next);
    }
    if (hovered !== null) add([hovered], COLOUR.text);
    return tones;
  }
  // Where an object is named: a line in the middle of the picture, or where it comes into it.
  nameAt(object) {
    const x = this.sx[object], y = this.sy[object], [, top, , height] = this.rectangle;
    if (!IS_LINE[object] || (y >= top && y <= top + height)) return [x, y];
    const inside = y < top ? top + 16 : top + height - 34;
    return [x + (y - inside) / (X[0][object] * this.steep), inside];
  }

  nearest(x, y) {
    let best = null, distance = 100;
    for (let object = 0; object < OBJECTS; ++object) {
      if (!alive[object]) continue;
      const d = (this.sx[object] - x) ** 2 + (this.sy[object] - y) ** 2;
      if (d < distance) { distance = d; best = object; }
    }
    return best;
  }
  // The certificate that is drawn nearest to a place, or null.
  certificateAt(x, y) {
    const { app } = this, { proof } = app;
    if (proof === null || app.replay.lost) return null;
    let best = null, distance = 7;
    for (const c of proof.live) {
      if (!this.isThere(c)) continue;
      const claim = proof.certificate(c);
      let d = distanceToShapes(this.shapesOf(claim), x, y);
      const { about } = proof.group(claim.group) || { about: [] };
      if (about.length === 2) {  // the edge that it is about goes before circles
        const [px, py] = nearestOn(about.map(id => this.at(id)), [x, y]);
        d = Math.min(d, Math.hypot(x - px, y - py) - 2);
      }
      if (d < distance) { distance = d; best = c; }
    }
    return best;
  }
  scaleAbout(factor, x, y) {
    const cx = x - this.cx, cy = y - this.cy;
    this.dx = cx - (cx - this.dx) * factor;
    this.dy = cy - (cy - this.dy) * factor;
    this.zoom *= factor;
  }
  // A picture of space is turned, unless `shifted`.
  move(dx, dy, x, y, shifted) {
    if (this.camera !== null && !shifted) return this.camera.turn(-dx / 2, dy / 2);
    this.dx += dx;
    this.dy += dy;
  }
}
