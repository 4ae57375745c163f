// The picture in the plane: points, and the attribute by its shape (edges, cycle, object, sequence).

// The box to show: that of the whole run if it is not much larger than what is there now, else one
// that slides with the points.
const WHOLE_RUN = (() => {
  const box = emptyBox();
  for (let i = 0; i <= 16; ++i) {
    place(i / 16);
    growBox(box);
  }
  return box;
})();
function emptyBox() { return [Infinity, -Infinity, Infinity, -Infinity]; }
function growBox(box) {
  for (let object = 0; object < OBJECTS; ++object) {
    if (!alive[object]) continue;
    box[0] = Math.min(box[0], X[0][object]);
    box[1] = Math.max(box[1], X[0][object]);
    box[2] = Math.min(box[2], X[1][object]);
    box[3] = Math.max(box[3], X[1][object]);
  }
}
function boxToShow() {
  const now = emptyBox();
  growBox(now);
  const size = b => Math.max(b[1] - b[0], b[3] - b[2]);
  return size(WHOLE_RUN) <= 1.8 * size(now) || !(now[0] <= now[1]) ? WHOLE_RUN : now;
}

class Plane {
  constructor(app) {
    this.app = app;
    this.fit();
  }
  fit() { this.zoom = 1; this.dx = this.dy = 0; }

  // Screen coordinates of all objects, in this.sx and this.sy.
  project(width, height) {
    const [x0, x1, y0, y1] = boxToShow();
    const room = 40;
    const fitted = Math.min((width - 2 * room) / (x1 - x0), (height - 2 * room) / (y1 - y0));
    const scale = this.zoom * (isFinite(fitted) && fitted > 0 ? fitted : 1);
    const cx = width / 2 + this.dx, cy = height / 2 + 10 + this.dy;
    const mx = (x0 + x1) / 2 || 0, my = (y0 + y1) / 2 || 0;
    this.sx = this.sx || new Float64Array(OBJECTS);
    this.sy = this.sy || new Float64Array(OBJECTS);
    for (let object = 0; object < OBJECTS; ++object) {
      this.sx[object] = cx + (X[0][object] - mx) * scale;
      this.sy[object] = cy - (X[1][object] - my) * scale;
    }
  }

  draw(picture) {
    const { app } = this;
    place(app.u);
    const context = picture.begin();
    this.project(picture.width, picture.height);
    const marked = app.certificateObjects();
    this.drawAttribute(context);
    this.drawCertificate(context, marked);
    const radius = OBJECTS > 2000 ? 1.5 : OBJECTS > 300 ? 2.2 : 3.4;
    context.fillStyle = COLOUR.point;
    context.beginPath();
    for (let object = 0; object < OBJECTS; ++object) {
      if (!alive[object]) continue;
      context.moveTo(this.sx[object] + radius, this.sy[object]);
      context.arc(this.sx[object], this.sy[object], radius, 0, 2 * Math.PI);
    }
    context.fill();
    for (const object of marked) {
      if (alive[object]) dot(context, this.sx[object], this.sy[object], radius + 1.6, COLOUR.failed);
    }
    this.drawNames(context, marked, picture);
  }

  segments(context, codes, colour, width, dash) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash || []);
    context.beginPath();
    for (const code of codes) {
      const a = Math.floor(code / OBJECTS), b = code % OBJECTS;
      if (!alive[a] || !alive[b]) continue;
      context.moveTo(this.sx[a], this.sy[a]);
      context.lineTo(this.sx[b], this.sy[b]);
    }
    context.stroke();
    context.setLineDash([]);
  }

  path(context, ids, closed) {
    context.beginPath();
    for (const id of ids) if (alive[id]) context.lineTo(this.sx[id], this.sy[id]);
    if (closed) context.closePath();
  }

  drawAttribute(context) {
    const { replay, other } = this.app;
    const thin = OBJECTS > 1500 ? 0.5 : OBJECTS > 300 ? 0.8 : 1.3;
    const both = other !== null && !other.lost;
    if (replay.shape === "edges" && !replay.lost) {
      this.segments(context, replay.edges, COLOUR.first, thin);
    }
    if (replay.shape === "edges" && both) {
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
    if (replay.shape === "cycle" || (replay.shape === "sequence" && OBJECTS <= 300)) {
      if (!replay.lost) outline(replay.ids, COLOUR.first, []);
      if (both && other.ids.join() !== replay.ids.join()) outline(other.ids, COLOUR.second, [6, 4]);
    }
    if (replay.shape !== "object") return;
    const ring = (ids, colour, radius) => {
      for (const id of ids) {
        if (!alive[id]) continue;
        context.strokeStyle = colour;
        context.lineWidth = 2.5;
        context.beginPath();
        context.arc(this.sx[id], this.sy[id], radius, 0, 2 * Math.PI);
        context.stroke();
      }
    };
    if (!replay.lost) ring(replay.ids, COLOUR.first, 9);
    if (both && other.ids[0] !== replay.ids[0]) ring(other.ids, COLOUR.second, 12);
  }

  // The last event: what it took away and what it put there, and the circle or line of its
  // certificate.
  drawCertificate(context, marked) {
    const { app } = this;
    if (marked.length === 0) return;
    const predicate = app.certificateName();
    if (predicate === "in_circle_2") {
      this.circle(context, marked);
    } else if (marked.length > 1) {
      this.path(context, marked, marked.length > 2);
      context.strokeStyle = COLOUR.failed;
      context.globalAlpha = 0.7;
      context.lineWidth = 1.2;
      context.setLineDash([2, 3]);
      context.stroke();
      context.setLineDash([]);
      context.globalAlpha = 1;
    }
    if (app.replay.shape !== "edges" || app.shown() !== app.eventStructure()) return;
    const codes = ids => ids.flatMap((id, i) => (i % 2 === 0 ? [id * OBJECTS + ids[i + 1]] : []));
    const [removed, added] = app.replay.changeAt(app.k);
    this.segments(context, codes(removed), COLOUR.failed, 1.6, [3, 4]);
    this.segments(context, codes(added), COLOUR.failed, 3);
  }

  circle(context, [a, b, c]) {
    const ax = this.sx[a], ay = this.sy[a];
    const bx = this.sx[b] - ax, by = this.sy[b] - ay, cx = this.sx[c] - ax, cy = this.sy[c] - ay;
    const d = 2 * (bx * cy - by * cx);
    const x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / d;
    const y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / d;
    const radius = Math.hypot(x, y);
    if (!(radius < 1e5)) return;
    context.strokeStyle = COLOUR.failed;
    context.lineWidth = 1.2;
    context.setLineDash([2, 3]);
    context.beginPath();
    context.arc(ax + x, ay + y, radius, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
  }

  drawNames(context, marked, picture) {
    const named = new Set(marked);
    if (OBJECTS <= 60) for (let object = 0; object < OBJECTS; ++object) named.add(object);
    if (this.app.replay.shape === "object") this.app.replay.ids.forEach(id => named.add(id));
    if (this.app.hovered !== null) named.add(this.app.hovered);
    for (const object of named) {
      const x = this.sx[object], y = this.sy[object];
      if (!alive[object] || x < 0 || y < 0 || x > picture.width || y > picture.height) continue;
      const colour = marked.includes(object) ? COLOUR.failed : COLOUR.text;
      const left = x > picture.width - 60;
      label(context, nameOf(object), x + (left ? -8 : 8), y - 9, colour, left ? "right" : "left");
    }
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
  scaleAbout(factor, x, y, picture) {
    const cx = x - picture.width / 2, cy = y - picture.height / 2;
    this.dx = cx - (cx - this.dx) * factor;
    this.dy = cy - (cy - this.dy) * factor;
    this.zoom *= factor;
  }
  move(dx, dy) { this.dx += dx; this.dy += dy; }
}
