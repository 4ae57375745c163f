// The picture on an axis: every object at its key, and every certificate as an arc between the two
// that it puts in order. Neighbours of an order are joined above the axis, other pairs below.
class KeyAxis {
  constructor(app) {
    this.app = app;
    this.fit();
  }
  fit() { this.zoom = 1; this.dx = 0; }

  draw(picture) {
    const { app } = this, { proof } = app;
    place(app.u);
    const context = picture.begin();
    const key = DATA.structures[app.shown()].key;
    const values = new Map();
    let low = Infinity, high = -Infinity;
    for (let object = 0; object < OBJECTS; ++object) {
      const value = memberOf(key, object) ? keyAt(key, object, app.u) : NaN;
      if (Number.isNaN(value)) continue;
      values.set(object, value);
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    [low, high] = spread(low, high, 0.04);
    this.left = 24;
    this.width = picture.width - 48;
    this.y = picture.height * 0.62;
    const x = value => this.left + this.width / 2 + this.dx +
      (value - (low + high) / 2) / (high - low) * this.width * this.zoom;
    this.where = new Map([...values].map(([object, value]) => [object, x(value)]));
    this.placeOfWall = wall => (wall.axis === key.axis ? x(wall.value) : undefined);
    this.drawScale(context, key, x, low, high);
    this.drawArcs(context, picture);
    this.drawObjects(context);
    if (proof !== null && app.selected !== null && proof.live.has(app.selected)) {
      const { form, ids } = proof.certificate(app.selected);
      form.roles.forEach(({ name }, i) => {
        if (this.where.has(ids[i])) {
          label(context, name, this.where.get(ids[i]), this.y + 34 + 15 * (i % 2), COLOUR.selected,
                "center");
        }
      });
    }
  }

  drawScale(context, key, x, low, high) {
    const scale = keyScale(key), middle = (low + high) / 2, half = (high - low) / 2 / this.zoom;
    context.strokeStyle = COLOUR.line;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(this.left, this.y);
    context.lineTo(this.left + this.width, this.y);
    context.stroke();
    context.fillStyle = COLOUR.quiet;
    context.textAlign = "center";
    context.textBaseline = "top";
    context.textAlign = "right";
    context.fillText(keyName(key) + " \u2192", this.left + this.width, this.y + 30);
    context.textAlign = "center";
    let free = 0;  // where the last number ends
    for (const [value, text] of ticks((middle - half) * scale, (middle + half) * scale, 8)) {
      const at = x(value / scale), wide = context.measureText(text).width;
      context.fillRect(at - 0.5, this.y + 5, 1, 5);
      if (at - wide / 2 < free) continue;
      context.fillText(text, at, this.y + 12);
      free = at + wide / 2 + 6;
    }
  }

  // Of an object, or of a wall on this axis; undefined where there is none.
  placeOf(id) {
    const wall = wallOf(id);
    return wall === null ? this.where.get(id) : this.placeOfWall(wall);
  }
  isThere(c) {
    return this.app.proof.certificate(c).ids.slice(0, 2).every(id => this.placeOf(id) !== undefined);
  }
  // Arcs are as high as half their length, up to what there is room for.
  arc(context, ids) {
    const [a, b] = ids.map(id => this.placeOf(id));
    const up = this.ranks ? Math.abs(this.ranks.get(ids[0]) - this.ranks.get(ids[1])) === 1 : true;
    const room = (up ? this.y - 50 : this.height - this.y - 60) * 1.3;
    const size = Math.min(room, 14 + Math.abs(b - a) * 0.55);
    context.beginPath();
    context.moveTo(a, this.y);
    context.quadraticCurveTo((a + b) / 2, this.y + (up ? -size : size) * 1.2, b, this.y);
    return [(a + b) / 2, this.y + (up ? -size : size) * 0.6];
  }

  drawArcs(context, picture) {
    const { app } = this, { proof } = app;
    this.height = picture.height;
    this.arcs = [];
    if (proof === null || app.replay.lost) return;
    const order = [...this.where.keys()].sort((a, b) => this.where.get(a) - this.where.get(b));
    this.ranks = new Map(order.map((object, rank) => [object, rank]));
    const next = proof.next(app.k), soon = next === null ? -1 : next[0];
    const draw = (c, colour, width) => {
      const { ids } = proof.certificate(c), pair = ids.slice(0, 2);
      if (!this.isThere(c)) return;
      context.strokeStyle = colour;
      context.lineWidth = width;
      const top = this.arc(context, pair);
      context.stroke();
      this.arcs.push([c, top, pair.map(id => this.placeOf(id))]);
    };
    context.globalAlpha = proof.live.size > 300 ? 0.35 : 0.8;
    for (const c of proof.live) if (c !== soon && c !== app.selected) draw(c, COLOUR.proof, 1.2);
    context.globalAlpha = 1;
    if (soon >= 0) draw(soon, COLOUR.next, 2.4);
    if (app.selected !== null && proof.live.has(app.selected)) {
      draw(app.selected, COLOUR.selected, 3);
    }
    const failed = app.failedClaim();
    if (failed === null || !failed.ids.slice(0, 2).every(id => this.placeOf(id) !== undefined)) return;
    context.strokeStyle = COLOUR.failed;
    context.lineWidth = 1.4;
    context.setLineDash([2, 3]);
    this.arc(context, failed.ids.slice(0, 2));
    context.stroke();
    context.setLineDash([]);
  }

  drawObjects(context) {
    const { app } = this;
    const marked = app.certificateObjects();
    const winner = app.replay.shape === "object" && !app.replay.lost ? app.replay.ids[0] : null;
    const taken = [];
    for (const [object, x] of this.where) {
      const is = marked.includes(object);
      dot(context, x, this.y, is ? 4.4 : 3.2, is ? COLOUR.failed : COLOUR.point);
      if (object === winner) {
        context.strokeStyle = COLOUR.first;
        context.lineWidth = 2.5;
        context.beginPath();
        context.arc(x, this.y, 8, 0, 2 * Math.PI);
        context.stroke();
      }
    }
    const wanted = id => (id === app.hovered ? 3 : marked.includes(id) ? 2 : id === winner ? 1 : 0);
    for (const [object, x] of [...this.where].sort((a, b) => wanted(b[0]) - wanted(a[0]))) {
      const name = nameOf(object), half = context.measureText(name).width / 2 + 3;
      if (taken.some(([a, b]) => a < x + half && x - half < b)) continue;
      taken.push([x - half, x + half]);
      label(context, name, x, this.y - 14, marked.includes(object) ? COLOUR.failed : COLOUR.text,
            "center");
    }
  }

  nearest(x, y) {
    let best = null, distance = 12;
    if (Math.abs(y - this.y) > 22) return null;
    for (const [object, px] of this.where || []) {
      if (Math.abs(px - x) < distance) { distance = Math.abs(px - x); best = object; }
    }
    return best;
  }
  certificateAt(x, y) {
    let best = null, distance = 14;
    for (const [c, [mx, my], [a, b]] of this.arcs || []) {
      // A parabola through both ends with its top at (mx, my).
      const f = (x - Math.min(a, b)) / (Math.abs(b - a) || 1);
      if (f < -0.05 || f > 1.05) continue;
      const d = Math.abs(y - (this.y + (my - this.y) * 4 * f * (1 - f))) + Math.abs(x - mx) / 60;
      if (d < distance) { distance = d; best = c; }
    }
    return best;
  }
  scaleAbout(factor, x) {
    const cx = x - (this.left + this.width / 2);
    this.dx = cx - (cx - this.dx) * factor;
    this.zoom *= factor;
  }
  move(dx) { this.dx += dx; }
}
