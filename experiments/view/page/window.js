// The window: events around now as bars, long ones external, short ones internal; a second run hangs
// below the line. Its axis is time, or the number of the log record, which sets events apart that are too
// close to be seen apart in time, and names the time between them. The whole run is drawn below.
class TimeWindow {
  constructor(app) {
    this.app = app;
    this.picture = new Picture("window");
    this.overview = new Picture("overview");
  }

  draw() {
    const { app, picture } = this;
    const context = picture.begin();
    const axis = app.windowAxis(picture.width);
    this.axis = axis;
    const base = OTHER === null ? picture.height - 28 : picture.height * 0.52;
    const long = base - 26, depth = picture.height - 28 - base;
    context.fillStyle = COLOUR.panel;
    context.strokeStyle = COLOUR.line;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(axis.x(Math.max(axis.first, axis.from)), base + 0.5);
    context.lineTo(axis.x(Math.min(axis.last, axis.to)), base + 0.5);
    context.stroke();
    this.drawTicks(context, axis, picture.height - 12);
    this.bars(context, axis, FIRST, base, -long, app.k, COLOUR.external, COLOUR.internal);
    if (OTHER !== null) {
      this.bars(context, axis, OTHER, base + 1, depth - 4, app.kOther(), COLOUR.second,
                COLOUR.second);
    }
    this.drawGaps(context, axis, base);
    this.drawNow(context, axis, base, long);
    if (OTHER !== null) {  // over the line of now
      label(context, FIRST.arithmetic, axis.left + 4, base - 8, COLOUR.quiet);
      label(context, OTHER.arithmetic, axis.left + 4, base + 10, COLOUR.second);
    }
    this.drawDivergence(context, axis, base);
    this.drawKey(context, axis);
  }

  drawTicks(context, axis, y) {
    context.textAlign = "right";
    context.textBaseline = "middle";
    context.fillStyle = COLOUR.quiet;
    const end = axis.right + 14 - context.measureText(axis.name).width - 8;
    context.fillText(axis.name, axis.right + 14, y);
    context.textAlign = "center";
    let free = 2;  // where the last number ends
    const tick = (x, text) => {
      const half = context.measureText(text).width / 2;
      context.fillRect(x - 0.5, y - 12, 1, 4);
      if (x - half <= free || x + half >= end) return;
      context.fillText(text, x, y);
      free = x + half + 6;
    };
    if (axis.records) {
      for (const [value] of ticks(Math.max(axis.first, axis.from), Math.min(axis.last, axis.to), (axis.right - axis.left) / 90)) {
        if (value === Math.round(value)) tick(axis.x(value), String(value));
      }
      return;
    }
    const from = timeNumber(Math.max(0, axis.from)), to = timeNumber(Math.min(1, axis.to));
    for (const [value, text] of from < to ? ticks(from, to, (axis.right - axis.left) / 110) : []) {
      tick(axis.x((value - DATA.time.start[1]) / DATA.time.span), text);
    }
  }

  // Between neighbours on the axis of records: how far apart they are in time, as a power of two.
  drawGaps(context, axis, base) {
    this.gaps = [];  // those that are drawn
    if (!axis.records || axis.x(1) - axis.x(0) < 16) return;
    context.font = fontOf(10);
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = COLOUR.quiet;
    const first = Math.max(BEFORE + 1, Math.floor(axis.from));
    for (let k = first; k < LAST && k <= axis.to; ++k) {
      const text = gapText(k);
      if (context.measureText(text).width + 4 > axis.x(1) - axis.x(0)) continue;
      context.fillText(text, axis.x(k + 0.5), base - 7);
      this.gaps.push([k, text]);
    }
    context.font = fontOf(12);
  }

  // At most one bar of a kind in each pixel.
  bars(context, axis, run, base, length, now, external, internal) {
    const shown = this.app.shown();
    const first = axis.firstOf(run);
    const taken = [-9, -9, -9, -9, -9, -9, -9, -9];
    let highlighted = null;
    for (let k = first; k <= run.before + run.u.length; ++k) {
      const place = axis.placeOf(run, k);
      if (place > axis.to) break;
      const x = Math.round(axis.x(place));
      const long = run.x[at(run, k)] === 1;
      const own = run.s[at(run, k)] === shown;
      const fits = run !== FIRST || this.app.filter.fits(k);
      if (k === now) highlighted = [x, long];
      const kind = (long ? 1 : 0) + (own ? 2 : 0) + (fits ? 4 : 0);
      if (taken[kind] === x) continue;
      taken[kind] = x;
      context.globalAlpha = !fits ? 0.12 : own ? 1 : 0.3;
      context.fillStyle = long ? external : internal;
      context.fillRect(x - 1, base, 2, length * (long ? 1 : 0.42));
    }
    context.globalAlpha = 1;
    if (highlighted === null) return;
    context.fillStyle = COLOUR.failed;
    context.fillRect(highlighted[0] - 2, base, 4, length * (highlighted[1] ? 1 : 0.42));
  }

  drawNow(context, axis, base, long) {
    const x = axis.x(axis.now), top = base - long - 8;
    context.strokeStyle = COLOUR.first;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, this.picture.height - 24);
    context.stroke();
    context.fillStyle = COLOUR.first;
    context.beginPath();
    context.moveTo(x - 5, top - 6);
    context.lineTo(x + 5, top - 6);
    context.lineTo(x, top + 2);
    context.fill();
  }

  drawDivergence(context, axis, base) {
    if (this.app.partedAt === null) return;
    const place = axis.records ? PARTED : this.app.partedAt;
    if (place < axis.from || place > axis.to) return;
    const x = axis.x(place);
    context.strokeStyle = COLOUR.second;
    context.lineWidth = 2;
    context.setLineDash([4, 3]);
    context.beginPath();
    context.moveTo(x, 14);
    context.lineTo(x, this.picture.height - 24);
    context.stroke();
    context.setLineDash([]);
    const left = x > axis.right - 150;
    label(context, "the runs part: log record " + PARTED, x + (left ? -6 : 6), 18, COLOUR.second,
          left ? "right" : "left");
  }

  drawKey(context, axis) {
    const x = axis.right - 4;
    context.textAlign = "right";
    context.textBaseline = "middle";
    context.fillStyle = COLOUR.quiet;
    const text = "long bars: external events, short: other log records";
    const width = context.measureText(text).width;
    const now = axis.x(axis.now);
    const parted = this.app.partedAt === null ? -1e9 : axis.x(axis.records ? PARTED : this.app.partedAt);
    // Nothing of the window lies under it, or it is left out.
    if (width > axis.right - axis.left - 20 || now > x - width - 12 || Math.abs(parted - x + width / 2) < width / 2 + 180) return;
    context.fillText(text, x, 7);
  }

  // To the event at a place, or to its time.
  go(x, y) {
    const k = this.eventAt(x, y), place = this.axis.place(x);
    if (k !== null) this.app.setEvent(k);
    else if (this.axis.records) this.app.setEvent(Math.round(place));
    else this.app.setTime(place);
  }

  drawOverview() {
    const { app, overview } = this;
    const context = overview.begin();
    const width = overview.width, height = overview.height - 4;
    const counts = new Uint32Array(Math.max(1, Math.ceil(width)));
    for (const u of FIRST.u) ++counts[Math.min(counts.length - 1, Math.floor(u * width))];
    const most = Math.log2(2 + Math.max(...counts));
    context.fillStyle = COLOUR.internal;
    counts.forEach((count, x) => {
      if (count > 0) context.fillRect(x, height, 1, -height * Math.log2(1 + count) / most);
    });
    const [begin, end] = this.axis.times;
    const from = Math.max(0, begin) * width, to = Math.min(1, end) * width;
    context.fillStyle = COLOUR.fill;
    context.fillRect(from, 0, to - from, height);
    context.strokeStyle = COLOUR.first;
    context.strokeRect(from + 0.5, 0.5, Math.max(1, to - from - 1), height - 1);
    context.fillStyle = COLOUR.first;
    context.fillRect(app.u * width - 1, 0, 2, height);
    if (app.partedAt === null) return;
    context.fillStyle = COLOUR.second;
    context.fillRect(app.partedAt * width - 1, 0, 2, height);
  }

  // The event whose bar is nearest to x; on an axis of time null if none is near.
  eventAt(x, y) {
    const place = this.axis.place(x);
    const k = this.axis.records ? Math.floor(place) : eventsUntil(FIRST, place);
    let best = null, distance = this.axis.records ? Infinity : 7;
    for (const candidate of [k, k + 1]) {
      if (candidate <= BEFORE || candidate > LAST) continue;
      const d = Math.abs(this.axis.x(this.axis.placeOf(FIRST, candidate)) - x);
      if (d < distance) { distance = d; best = candidate; }
    }
    return best;
  }
}

// The time from log record k to the next one, in short.
function gapText(k) {
  const [a, b] = [instantOf(FIRST, k), instantOf(FIRST, k + 1)];
  if (a === b) return "same t";
  const gap = gapBetween(a, b);
  return Number.isNaN(gap) ? "?" : "2" + raised(Math.floor(gap));
}
