// The time window of a scene of bodies: one lane for each structure, on one time axis, so that one
// sees which proof changes often and which seldom. A second run hangs below the lines.
const MARK = 9;  // pixels above the lanes, for the mark of now
class Lanes extends TimeWindow {
  constructor(app) {
    super(app);
    const lanes = DATA.structures.length;
    const each = OTHER === null ? 52 : 74;
    this.picture.canvas.parentElement.style.height =
      Math.max(96, 34 + MARK + Math.min(lanes * each, 260)) + "px";
    this.counts = [FIRST, OTHER].map(run => (run === null ? null
      : DATA.structures.map((_, i) => countsOf(run, i))));
  }

  draw() {
    const { app, picture } = this;
    const context = picture.begin();
    const axis = app.windowAxis(picture.width);
    this.axis = axis;
    this.height = (picture.height - 26 - MARK) / DATA.structures.length;
    DATA.structures.forEach((_, index) => this.drawLane(context, axis, index));
    this.drawTicks(context, axis, picture.height - 10);
    this.drawNow(context, axis, 18, 4);
    this.drawDivergence(context, axis);
    DATA.structures.forEach((_, index) => this.drawName(context, axis, index));
  }

  // The parts of a lane: the name, the bars of the first run, those of the second.
  parts(index) {
    const top = MARK + index * this.height;
    const base = OTHER === null ? top + this.height - 5 : top + 16 + (this.height - 18) * 0.55;
    return { top, base, long: base - top - 19, depth: top + this.height - 4 - base };
  }

  drawLane(context, axis, index) {
    const { app } = this;
    const { top, base, long, depth } = this.parts(index);
    const shown = index === app.shown(), colour = app.colourOf(index);
    if (shown) {
      context.fillStyle = COLOUR.panel;
      context.fillRect(axis.left, top, axis.right - axis.left, this.height - 2);
    }
    context.strokeStyle = COLOUR.line;
    context.lineWidth = 1;
    trace(context, [[axis.x(Math.max(axis.first, axis.from)), base + 0.5],
                    [axis.x(Math.min(axis.last, axis.to)), base + 0.5]], false);
    context.stroke();
    this.laneBars(context, axis, FIRST, index, base, -long, colour, app.k);
    if (OTHER !== null) {
      this.laneBars(context, axis, OTHER, index, base + 1, depth, COLOUR.second, app.kOther());
    }
    const next = app.proofs[index].nextFailure(app.pair(), app.k);
    if (next === null) return;
    const x = axis.x(axis.placeOf(FIRST, next));
    if (x < axis.left || x > axis.right) return;
    context.strokeStyle = COLOUR.failed;
    context.lineWidth = shown ? 2 : 1.2;
    context.beginPath();
    context.arc(x, base - long * 0.42 - 6, shown ? 4.5 : 3.5, 0, 2 * Math.PI);
    context.stroke();
  }

  drawName(context, axis, index) {
    const { app } = this;
    const { top } = this.parts(index);
    const counts = this.counts[0][index];
    const name = DATA.structures[index].label;
    const done = (placeUntil(counts.records, app.k) + 1) + " of " + counts.records.length;
    const records = done + (counts.records.length === 1 ? " log record" : " log records");
    const more = (counts.external > 0 ? ", " + counts.external + " external" : "") +
      (OTHER !== null ? " (" + OTHER.arithmetic + ": " + this.counts[1][index].records.length + ")" : "");
    const room = axis.right - axis.left - 10, wide = text => context.measureText(text).width;
    const text = [name + "  " + records + more, name + "  " + records, name + "  " + done]
      .find(one => wide(one) <= room) || name;
    label(context, text, axis.left + 5, top + 9, app.colourOf(index));
    const key = "long bars: external events, short: other log records; ring: fails next";
    if (index === 0 && app.partedAt === null && wide(text) + wide(key) + 24 <= room) {
      label(context, key, axis.right - 4, top + 9, COLOUR.quiet, "right");
    }
  }

  laneBars(context, axis, run, index, base, length, colour, now) {
    const { records } = this.counts[run === FIRST ? 0 : 1][index];
    const taken = [-9, -9];
    let i = placeUntil(records, axis.firstOf(run) - 1) + 1;
    for (; i < records.length; ++i) {
      const k = records[i], place = axis.placeOf(run, k);
      if (place > axis.to) break;
      const x = Math.round(axis.x(place)), long = run.x[at(run, k)];
      if (k !== now && taken[long] === x) continue;
      taken[long] = x;
      context.fillStyle = k === now ? COLOUR.failed : colour;
      context.globalAlpha = run === FIRST && !this.app.filter.fits(k) ? 0.15 : 1;
      const wide = k === now ? 4 : records.length > 300 ? 1 : 2;
      context.fillRect(x - wide / 2, base, wide, length * (long === 1 ? 1 : 0.42));
    }
    context.globalAlpha = 1;
  }

  laneAt(y) {
    return Math.max(0, Math.min(DATA.structures.length - 1, Math.floor((y - MARK) / this.height)));
  }
  // The log record of the lane whose bar is nearest to x; on an axis of time null if none is near.
  eventAt(x, y) {
    const { records } = this.counts[0][this.laneAt(y)];
    const place = this.axis.place(x);
    const near = placeUntil(records, this.axis.records ? Math.floor(place) : eventsUntil(FIRST, place));
    let best = null, distance = this.axis.records ? Infinity : 7;
    for (const k of [records[near], records[near + 1]]) {
      if (k === undefined) continue;
      const d = Math.abs(this.axis.x(this.axis.placeOf(FIRST, k)) - x);
      if (d < distance) { distance = d; best = k; }
    }
    return best;
  }
}

// The numbers of a structure's log records, whether a certificate caused them or not, and how many are external.
function countsOf(run, index) {
  const records = [];
  let external = 0;
  run.u.forEach((_, e) => {
    if (run.s[e] !== index) return;
    records.push(e + run.before + 1);
    external += run.x[e];
  });
  return { records, external };
}
