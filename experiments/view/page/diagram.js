// The picture over time: the key of every object against time, around now, on the same time axis as
// the window of events below it. Beside it the order or the object that the structure holds.
class Diagram {
  constructor(app) {
    this.app = app;
    this.fit();
  }
  fit() { this.zoom = 1; this.dy = 0; }

  get key() { return DATA.structures[this.app.shown()].key; }
  // Pixels at the right that are not part of the time axis.
  band() { return this.app.replay.shape === "sequence" ? (this.app.other === null ? 170 : 270) : 90; }

  // The values to show: of a list all, of a single object those that come near it.
  range(from, to) {
    if (this.app.replay.shape === "object") return this.rangeNearWinner(from, to);
    let low = Infinity, high = -Infinity;
    for (let i = 0; i <= 4; ++i) {
      const u = from + (to - from) * i / 4;
      for (let object = 0; object < OBJECTS; ++object) {
        if (!memberOf(this.key, object)) continue;
        const y = keyAt(this.key, object, u);
        if (y < low) low = y;
        if (y > high) high = y;
      }
    }
    return spread(low, high, 0.06);
  }

  rangeNearWinner(from, to) {
    let low = Infinity, high = -Infinity;
    for (let i = 0; i <= 8; ++i) {
      const u = from + (to - from) * i / 8;
      const winner = this.app.replay.objectAt(eventsUntil(FIRST, u));
      const own = winner === undefined ? NaN : keyAt(this.key, winner, u);
      if (Number.isNaN(own)) continue;
      const others = [];
      for (let object = 0; object < OBJECTS; ++object) {
        const y = memberOf(this.key, object) ? keyAt(this.key, object, u) : NaN;
        if (!Number.isNaN(y)) others.push(y);
      }
      others.sort((a, b) => Math.abs(a - own) - Math.abs(b - own));
      for (const y of others.slice(0, Math.max(3, Math.ceil(others.length * 0.4)))) {
        low = Math.min(low, y);
        high = Math.max(high, y);
      }
    }
    return spread(low, high, 0.08);
  }

  draw(picture) {
    const { app } = this;
    place(app.u);
    const context = picture.begin();
    const axis = app.axis(picture.width);
    const from = Math.max(0, axis.from), to = Math.min(1, axis.to);
    const [low, high] = this.range(from, to);
    const top = 34, bottom = picture.height - 12;
    this.y = value => (bottom + top) / 2 + this.dy +
      ((low + high) / 2 - value) / (high - low) * (bottom - top) * this.zoom;
    context.save();
    context.beginPath();
    context.rect(axis.left, 0, axis.right - axis.left, picture.height);
    context.clip();
    const texts = this.drawScale(context, axis, low, high);
    this.drawCurves(context, axis, from, to);
    for (const [text, y] of texts) label(context, text, axis.left + 3, y, COLOUR.quiet);  // over the curves
    context.restore();
    this.drawNow(context, axis, picture);
    if (app.replay.shape !== "sequence") this.drawEndNames(context, axis, to, picture);
    if (app.replay.shape === "sequence") this.drawOrder(context, axis, picture);
  }

  // The lines; returns the texts of their values, with the heights of these.
  drawScale(context, axis, low, high) {
    const scale = keyScale(this.key);
    const middle = (low + high) / 2, half = (high - low) / 2 / this.zoom;
    context.strokeStyle = COLOUR.line;
    context.lineWidth = 0.6;
    const texts = [[keyName(this.key) + " \u2191", 28]];
    for (const [value, text] of ticks((middle - half) * scale, (middle + half) * scale, 5)) {
      const y = this.y(value / scale);
      if (y < 50) continue;  // its text would lie on the axis's name
      context.beginPath();
      context.moveTo(axis.left, y);
      context.lineTo(axis.right, y);
      context.stroke();
      texts.push([text, y - 7]);
    }
    return texts;
  }

  curve(context, axis, object, from, to) {
    for (const piece of MOTIONS[object]) {
      const a = Math.max(from, piece[0] === null ? -Infinity : piece[0]);
      const b = Math.min(to, piece[1] === null ? Infinity : piece[1]);
      if (!(a < b)) continue;
      const parts = keyDegree(this.key, piece) <= 1 ? 1 : OBJECTS > 500 ? 16 : 48;
      for (let i = 0; i <= parts; ++i) {
        const u = a + (b - a) * i / parts;
        const x = axis.x(u), y = this.y(pieceKey(this.key, piece, u));
        if (i === 0) context.moveTo(x, y); else context.lineTo(x, y);
      }
    }
  }

  drawCurves(context, axis, from, to) {
    const { app } = this;
    if (OBJECTS <= MOST_NAMED) this.drawExtents(context, axis, from, to);
    context.strokeStyle = COLOUR.point;
    context.globalAlpha = OBJECTS > 500 ? 0.15 : OBJECTS > 60 ? 0.3 : 0.55;
    context.lineWidth = OBJECTS > 300 ? 0.7 : 1.1;
    context.beginPath();
    for (let object = 0; object < OBJECTS; ++object) {
      if (memberOf(this.key, object)) this.curve(context, axis, object, from, to);
    }
    context.stroke();
    context.globalAlpha = 1;
    if (app.replay.shape === "object") {
      if (app.other !== null) this.envelope(context, axis, OTHER, app.other, COLOUR.second, 7);
      this.envelope(context, axis, FIRST, app.replay, COLOUR.first, 3.2);
    }
    if (app.replay.tuples !== null && app.replay.width <= (OBJECTS > 500 ? 1 : 2)) {
      if (app.other !== null) this.drawMembers(context, axis, OTHER, [from, to], COLOUR.second, 7);
      this.drawMembers(context, axis, FIRST, [from, to], COLOUR.first, 4);
    }
    const curves = (ids, colour, width) => {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.beginPath();
      for (const object of ids) {
        const wall = wallOf(object);
        if (object < OBJECTS && memberOf(this.key, object)) this.curve(context, axis, object, from, to);
        if (wall === null || wall.axis !== this.key.axis) continue;
        context.moveTo(axis.x(from), this.y(wall.value));
        context.lineTo(axis.x(to), this.y(wall.value));
      }
      context.stroke();
    };
    const next = app.proof === null || app.replay.lost ? null : app.proof.next(app.k);
    if (next !== null) curves(app.proof.certificate(next[0]).ids, COLOUR.next, 1.4);
    curves(app.certificateObjects(), COLOUR.failed, 1.8);
    if (app.proof !== null && app.selected !== null && app.proof.live.has(app.selected)) {
      curves(app.proof.certificate(app.selected).ids, COLOUR.selected, 2.6);
    }
  }

  // Which object was the value, and when: from the log.
  envelope(context, axis, run, replay, colour, width) {
    const begin = Math.max(0, axis.from), end = Math.min(1, axis.to);
    const lost = replay.corrupt === null ? Infinity : replay.corrupt[0];
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.globalAlpha = width > 4 ? 0.45 : 1;
    context.beginPath();
    let u = begin, k = eventsUntil(run, begin);
    const last = run.before + run.u.length;
    let place = replay.changes.findIndex(change => change[0] > k);
    if (place < 0) place = replay.changes.length;
    while (u < end && k < lost) {
      const next = place < replay.changes.length ? replay.changes[place][0] : last + 1;
      const until = next > last ? end : Math.min(end, timeOf(run, next));
      const object = replay.objectAt(k);
      if (object !== undefined) this.curve(context, axis, object, u, until);
      u = Math.max(u, until);
      if (next > last) break;
      k = next;
      ++place;
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  // A set of objects as wide curves while they are in it, a set of pairs as what is between the two curves.
  drawMembers(context, axis, run, [from, to], colour, width) {
    const spans = spansOf(run, this.app.shown(), from, to);
    context.globalAlpha = width > 4 ? 0.45 : 1;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (const [[object, second], begin, end] of spans) {
      if (second === undefined) this.curve(context, axis, object, begin, end);
    }
    context.stroke();
    context.fillStyle = colour;
    context.globalAlpha = 0.16;
    for (const [[a, b], begin, end] of spans) {
      if (b !== undefined) this.fillBetween(context, axis, u => [keyAt(this.key, a, u), keyAt(this.key, b, u)], begin, end);
    }
    context.globalAlpha = 1;
  }
  // The area between two values of time; it ends where one of them is not there.
  fillBetween(context, axis, values, from, to) {
    const parts = 48, lower = [], upper = [];
    for (let i = 0; i <= parts; ++i) {
      const u = from + (to - from) * i / parts, [low, high] = values(i < parts ? u : u - (to - from) * 1e-9);
      if (Number.isNaN(low) || Number.isNaN(high)) continue;
      lower.push([axis.x(u), this.y(low)]);
      upper.unshift([axis.x(u), this.y(high)]);
    }
    trace(context, [...lower, ...upper], true);
    context.fill();
  }
  // Discs and boxes on their axis.
  drawExtents(context, axis, from, to) {
    const along = this.key.axis;
    if (HALF.length === 0 || along === undefined) return;
    context.fillStyle = COLOUR.point;
    context.globalAlpha = 0.12;
    for (let object = 0; object < OBJECTS; ++object) {
      this.fillBetween(context, axis, u => {
        const piece = pieceAt(object, u);
        if (piece === null) return [NaN, NaN];
        const x = evaluate(piece[2][along], u), half = evaluate(piece[2][AXES + Math.min(along, EXTENT_AXES - 1)], u);
        return [x - half, x + half];
      }, from, to);
    }
    context.globalAlpha = 1;
  }

  // The names of the objects where their curves end; of many those of the last log record.
  drawEndNames(context, axis, to, picture) {
    const marked = this.app.certificateObjects(), ends = [], before = to - 1e-9 * this.app.span;
    for (let object = 0; object < OBJECTS; ++object) {
      if (!memberOf(this.key, object) || (OBJECTS > MOST_NAMED && !marked.includes(object))) continue;
      const y = this.y(keyAt(this.key, object, before));
      if (y > 20 && y < picture.height) ends.push([object, y]);
    }
    ends.sort((a, b) => a[1] - b[1]);
    const top = 34, bottom = picture.height - 10, step = Math.min(14, (bottom - top) / Math.max(1, ends.length - 1));
    const places = placesInOrder(ends.map(([, y]) => y), step, top, bottom), right = axis.x(to);
    ends.forEach(([object, y], i) => {
      const is = marked.includes(object);
      if (step < 10 && !is && object !== this.app.hovered) return;
      context.strokeStyle = is ? COLOUR.failed : COLOUR.quiet;
      context.lineWidth = 0.8;
      trace(context, [[right, y], [right + 4, y], [right + 12, places[i]], [right + 16, places[i]]], false);
      context.stroke();
      const name = nameOf(object), short = name.length > 9 ? name.slice(0, 8) + "\u2026" : name;
      label(context, short, right + 19, places[i], is ? COLOUR.failed : COLOUR.text);
    });
  }

  drawNow(context, axis, picture) {
    const { app } = this;
    const x = this.nowX = axis.x(app.u);
    context.strokeStyle = COLOUR.first;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, 22);
    context.lineTo(x, picture.height);
    context.stroke();
    const marked = app.certificateObjects();
    const radius = OBJECTS > 300 ? 1.8 : 3.2;
    this.where = [];
    for (let object = 0; object < OBJECTS; ++object) {
      if (!alive[object] || !memberOf(this.key, object)) continue;
      const y = this.y(keyAt(this.key, object, app.u));
      this.where.push([object, x, y]);
      const is = marked.includes(object);
      dot(context, x, y, is ? radius + 1.4 : radius, is ? COLOUR.failed : COLOUR.point);
    }
    if (app.replay.shape === "object") this.drawWinners(context, x);
    if (app.hovered !== null) {
      for (const [object, px, py] of this.where) {
        if (object === app.hovered) label(context, nameOf(object), px + 9, py, COLOUR.text);
      }
    }
  }

  drawWinners(context, x) {
    const { replay, other } = this.app;
    const show = (id, colour, radius, side) => {
      for (const [object, px, py] of this.where) {
        if (object !== id) continue;
        context.strokeStyle = colour;
        context.lineWidth = 2.5;
        context.beginPath();
        context.arc(px, py, radius, 0, 2 * Math.PI);
        context.stroke();
        label(context, nameOf(id), px + side * 14, py - 14, colour, side > 0 ? "left" : "right");
      }
    };
    if (!replay.lost) show(replay.ids[0], COLOUR.first, 8, 1);
    if (other !== null && !other.lost && other.ids[0] !== replay.ids[0]) {
      show(other.ids[0], COLOUR.second, 11, -1);
    }
  }

  // The order that the structure holds, from the log, joined with where the keys are: lines that
  // cross show an order that is not that of the keys.
  drawOrder(context, axis, picture) {
    const { replay, other } = this.app;
    const marked = this.app.certificateObjects();
    const heights = new Map(this.where.map(([object, , y]) => [object, y]));
    const column = (run, state, x, from, colour) => {
      label(context, run.arithmetic, x, 12, colour);
      if (state.lost) {
        label(context, "corrupt", x, 30, colour);
        return;
      }
      const [first, ids] = this.ranksToShow(state.ids, marked);
      if (ids.length < state.ids.length) {
        label(context, "ranks " + (first + 1) + "\u2013" + (first + ids.length), x, 27, COLOUR.quiet);
      }
      const top = 44, bottom = picture.height - 14;
      const step = Math.min(16, (bottom - top) / Math.max(1, ids.length - 1));
      const places = placesInOrder(ids.map(id => heights.get(id)).reverse(), step, top, bottom).reverse();
      ids.forEach((id, rank) => {
        const y = places[rank];
        const is = marked.includes(id);
        const start = heights.get(id);
        if (start !== undefined && start > 20 && start < picture.height) {
          context.strokeStyle = is ? COLOUR.failed : colour;
          context.globalAlpha = is ? 1 : 0.5;
          context.lineWidth = is ? 1.6 : 0.8;
          if (is || ids.length <= 12) {  // straight from the point at now, so that it can be followed
            context.setLineDash([1, 4]);
            trace(context, [[this.nowX, start], [from, start]], false);
            context.stroke();
            context.setLineDash([]);
          }
          trace(context, [[from, start], [from + 8, start], [x - 12, y], [x - 4, y]], false);
          context.stroke();
          context.globalAlpha = 1;
        }
        if (step >= 10 || is || id === this.app.hovered) {
          label(context, shorten(nameOf(id)), x, y, is ? COLOUR.failed : COLOUR.text);
        }
      });
    };
    const shorten = name => (name.length > 12 ? name.slice(0, 11) + "\u2026" : name);
    column(FIRST, replay, axis.right + 75, axis.right + 2, COLOUR.first);
    if (other !== null) column(OTHER, other, axis.right + 195, axis.right + 150, COLOUR.second);
  }

  // Of a long list the part around the last event: [place of the first, ids].
  ranksToShow(ids, marked) {
    const most = 25;
    if (ids.length <= most) return [0, ids];
    const places = marked.map(id => ids.indexOf(id)).filter(place => place >= 0);
    const middle = places.length > 0 ? places[0] : ids.length >> 1;
    const first = Math.max(0, Math.min(ids.length - most, middle - (most >> 1)));
    return [first, ids.slice(first, first + most)];
  }

  nearest(x, y) {
    let best = null, distance = 144;
    for (const [object, px, py] of this.where || []) {
      const d = (px - x) ** 2 + (py - y) ** 2;
      if (d < distance) { distance = d; best = object; }
    }
    return best;
  }
  scaleAbout(factor, x, y, picture) {
    const cy = y - (picture.height + 18) / 2;
    this.dy = cy - (cy - this.dy) * factor;
    this.zoom *= factor;
  }
  move(dx, dy) {
    this.dy += dy;
    return true;
  }
}

// More objects than this are not all named.
const MOST_NAMED = 60;

// The tuples of a set between two times, as the log has them: [tuple, begin, end].
const WALKERS = new Map();  // replays that are kept, as the next picture begins near the last one
function spansOf(run, index, from, to) {
  const known = RUNS.indexOf(run) + "/" + index, spans = [], since = new Map();
  if (!WALKERS.has(known)) WALKERS.set(known, new Replay(run, index));
  const replay = WALKERS.get(known);
  replay.seek(eventsUntil(run, from));
  if (replay.lost) return spans;
  for (const [text, tuple] of replay.tuples) since.set(text, [tuple, from]);
  const close = (text, u) => {
    const [tuple, begin] = since.get(text);
    since.delete(text);
    if (begin < u) spans.push([tuple, begin, u]);
  };
  let end = to;
  for (let i = replay.applied; i < replay.changes.length; ++i) {
    const [event, , removed, added] = replay.changes[i], u = timeOf(run, event);
    if (u >= to) break;
    if (replay.corrupt !== null && event > replay.corrupt[0]) {
      end = timeOf(run, replay.corrupt[0]);
      break;
    }
    for (const tuple of replay.cut(removed)) if (since.has(tuple.join())) close(tuple.join(), u);
    for (const tuple of replay.cut(added)) since.set(tuple.join(), [tuple, u]);
  }
  for (const text of [...since.keys()]) close(text, end);
  return spans;
}

// Places of labels from the top to the bottom in this order, at least `gap` apart, each as near to its wanted
// place (undefined: it has none) as those around it allow; where the wanted places are in another order,
// those concerned share the middle.
function placesInOrder(wanted, gap, top, bottom) {
  const blocks = [];  // [sum of shifted places, labels]
  let last = (top + bottom) / 2;
  const start = wanted.find(place => place !== undefined);
  if (start !== undefined) last = start;
  wanted.forEach((place, i) => {
    if (place !== undefined) last = place;
    blocks.push([Math.min(bottom, Math.max(top, last)) - i * gap, 1]);
    const mean = ([sum, count]) => sum / count;
    while (blocks.length > 1 && mean(blocks[blocks.length - 2]) > mean(blocks[blocks.length - 1])) {
      const [sum, count] = blocks.pop(), before = blocks[blocks.length - 1];
      before[0] += sum;
      before[1] += count;
    }
  });
  const shifted = blocks.flatMap(([sum, count]) => Array(count).fill(sum / count));
  const most = bottom - (wanted.length - 1) * gap;
  return shifted.map((place, i) => Math.min(most, Math.max(top, place)) + i * gap);
}
