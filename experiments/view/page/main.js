// What is shown: the state after event k at time u, in units of the shown span. Stepping goes from
// event to event; playing and the time axes go through time, and k follows.
const WHOLE = 1.04;  // the length of a time window that shows the whole run, with a margin at both ends
const SLOWEST = 1e-9, FASTEST = 8;  // of playing: units of the shown span a second
const LONGEST_FRAME = 250;  // milliseconds of playing in one step, for example where the page was hidden
class App {
  constructor() {
    this.k = BEFORE;
    this.u = 0;
    this.index = 0;            // of the structure that is shown
    this.hovered = null;
    this.playing = false;
    this.plays = 0;            // how often that began or ended
    this.replays = DATA.structures.map((_, i) => new Replay(FIRST, i));
    this.others = OTHER === null ? null : DATA.structures.map((_, i) => new Replay(OTHER, i));
    const events = LAST - BEFORE, share = 30 / Math.max(1, events);
    this.span = share < 0.9 ? share : WHOLE;  // of the time window: some 30 events, or all
    this.rate = Math.min(1 / 12, 2 / Math.max(1, events));  // u per second: about 2 events a second
    this.partedAt = null;
    if (PARTED > BEFORE) {
      this.partedAt = PARTED <= LAST ? timeOf(FIRST, PARTED) : timeOf(OTHER, PARTED);
    }
    this.picture = new Picture("picture");
    this.selected = null;      // a certificate of the proof that is shown
    this.told = null;          // what was asked for and is not there: { text, state: what is shown in its place }
    this.chosenGroup = null;   // a group without certificates
    this.byRecord = false;     // the window's axis is numbers of log records
    this.records = 16;         // as many of them
    this.all = null;           // all certificates are drawn; null: if they are few
    this.certificates = new Certificates(this);
    if (BODIES) return this.startBodies();
    this.runProofs = DATA.structures.map((_, i) => new Proof(FIRST, i));
    this.plane = new Plane(this);
    this.drawings = { plane: this.plane, time: new Diagram(this), axis: new KeyAxis(this),
                      tree: new Tree(this) };
    this.window = new TimeWindow(this);
    this.panel = new Panel(this);
    this.filter = new EventFilter(this);
  }

  startBodies() {
    this.chosen = null;  // the pair that is shown; null: that of the event
    const pairs = run => DATA.structures.map((_, i) => new Pairs(run, i));
    this.proofs = pairs(FIRST);
    this.otherProofs = OTHER === null ? null : pairs(OTHER);
    this.runProofs = this.proofs.map(own => own.proof);
    this.span = WHOLE;
    this.rate = 1 / 30;
    this.drawings = { plane: new Arena(this) };
    this.window = new Lanes(this);
    this.panel = new PairPanel(this);
    this.filter = new EventFilter(this);
  }
  // The pair of bodies that is shown: that of the event, or of the next one that is about a pair.
  pair() {
    if (this.chosen !== null) return this.chosen;
    for (let e = Math.max(0, at(FIRST, this.k)); e < FIRST.u.length; ++e) {
      const pair = pairOfEvent(FIRST, e);
      if (pair !== null) return pair;
    }
    for (let e = Math.min(at(FIRST, this.k), FIRST.u.length - 1); e >= 0; --e) {
      const pair = pairOfEvent(FIRST, e);
      if (pair !== null) return pair;
    }
    return pairCode(0, Math.min(1, OBJECTS - 1));
  }
  colourOf(index) { return COLOUR["s" + index % 6]; }

  // ---- what others ask
  shown() { return this.index; }
  get replay() { return this.replays[this.index]; }
  get other() { return this.others === null ? null : this.others[this.index]; }
  // The proof of the structure that is shown: its own, or that of the structure that it reads. Null
  // where it is not known.
  get proof() {
    const own = this.runProofs[this.index], reads = own.data.reads;
    const proof = own.isEmpty && reads !== null ? this.runProofs[reads] : own;
    return proof.isKnown(this.k) ? proof : null;
  }
  // All certificates are drawn in the plane.
  showsAll() {
    return this.all === null ? this.mode === "plane" && this.proof.live.size <= 60 : this.all;
  }
  // The certificate that fails next, [certificate, event], or null.
  nextFailure() { return this.proof === null || this.replay.lost ? null : this.proof.next(this.k); }
  // The group of the certificate that is selected, or the one that was chosen itself.
  selectedGroup() {
    const { proof } = this;
    if (proof === null) return null;
    if (this.selected !== null && proof.live.has(this.selected)) {
      return proof.group(proof.data.certificates[this.selected][0]);
    }
    return this.chosenGroup === null ? null : proof.group(this.chosenGroup);
  }
  select(c) {
    this.selected = c;
    if (c !== null) this.chosenGroup = null;
    this.panel.shownEvent = null;
    this.changed();
  }
  selectNext() {
    const next = this.nextFailure();
    if (next !== null) this.select(next[0]);
  }
  turnAll() {
    if (BODIES || this.proof === null) return;
    this.all = !this.showsAll();
    this.changed();
  }
  zoom(factor) {
    this.drawing.scaleAbout(factor, this.picture.width / 2, this.picture.height / 2, this.picture);
    this.changed();
  }
  // The claim that failed at the event.
  failedClaim() {
    if (this.k === BEFORE || FIRST.certificates[at(FIRST, this.k)] === 0) return null;
    const [predicate, ids] = FIRST.certificates[at(FIRST, this.k)];
    return { form: formOf(FIRST, predicate), ids, name: FIRST.predicates[predicate] };
  }
  get drawing() { return this.drawings[this.mode]; }
  state() {
    return this.k + "/" + this.kOther() + "/" + this.index + (BODIES ? "/" + this.pair() : "");
  }
  eventStructure() { return this.k > BEFORE ? FIRST.s[at(FIRST, this.k)] : -1; }
  // Of the event k itself, in whatever structure.
  certificateObjects() {
    if (this.k === BEFORE) return [];
    const e = at(FIRST, this.k);
    return FIRST.certificates[e] === 0 ? FIRST.ids[e] : FIRST.certificates[e][1];
  }
  certificateName() {
    const certificate = this.k === BEFORE ? 0 : FIRST.certificates[at(FIRST, this.k)];
    return certificate === 0 ? "" : FIRST.predicates[certificate[0]];
  }
  // The runs have parted: at a log record of the first one; or it has none left, and at the time of the second one's.
  haveParted() {
    return PARTED !== 0 && (this.k >= PARTED || (PARTED > LAST && this.k === LAST && this.u >= this.partedAt));
  }
  // Before the runs part the second one has the same events; from there on it goes by time.
  kOther() {
    if (OTHER === null) return 0;
    const last = OTHER.before + OTHER.u.length;
    if (!this.haveParted()) return Math.min(this.k, last);
    return Math.max(Math.min(PARTED - 1, last), eventsUntil(OTHER, this.u));
  }
  // The time axis of the window and of the drawing over time.
  axis(width) {
    const left = 2;
    const right = width - (this.mode === "time" ? this.drawing.band() : 18);
    // The whole run in the middle; or around now, but not beyond the ends of the run.
    const margin = this.span / 50;
    const from = this.span >= 1 ? (1 - this.span) / 2
      : Math.max(-margin, Math.min(this.u - this.span / 2, 1 + margin - this.span));
    const to = from + this.span;
    return { left, right, from, to,
             x: u => left + (u - from) / this.span * (right - left),
             u: x => from + (x - left) / (right - left) * this.span };
  }

  // The axis of the window: time as above, or numbers of log records.
  windowAxis(width) {
    if (!this.byRecord) {
      const axis = this.axis(width);
      return { ...axis, records: false, name: "time t", first: 0, last: 1, now: this.u,
               times: [axis.from, axis.to], place: axis.u, placeOf: timeOf,
               firstOf: run => eventsUntil(run, axis.from - 1e-12) + 1 };
    }
    const left = 2, right = width - 18, count = Math.max(2, Math.min(this.records, LAST - BEFORE + 1));
    // Between two records now is as far as time is.
    const [u, v] = [timeOf(FIRST, this.k), this.k < LAST ? timeOf(FIRST, this.k + 1) : 1];
    const now = this.k + (v > u ? Math.max(0, Math.min(1, (this.u - u) / (v - u))) : 0);
    const from = Math.max(BEFORE + 0.4, Math.min(now - count / 2, LAST + 1 - count));
    const to = from + count;
    const time = place => timeOf(FIRST, Math.max(BEFORE, Math.min(LAST, Math.round(place))));
    return { left, right, from, to, records: true, name: "log record", first: BEFORE + 0.5, last: LAST + 0.5, now,
             times: [time(from), time(to)], placeOf: (run, k) => k,
             firstOf: run => Math.max(run.before + 1, Math.floor(from)),
             x: place => left + (place - from) / count * (right - left),
             place: x => from + (x - left) / (right - left) * count };
  }

  // ---- where to go
  setEvent(k) {
    this.k = Math.max(BEFORE, Math.min(LAST, k));
    this.u = timeOf(FIRST, this.k);
    this.changed();
  }
  // What was asked for by number, from outside; returns what is to be told if there is no such one.
  goTo(text) {
    const k = /^\s*\d+\s*$/.test(text) ? +text : NaN;
    if (!Number.isNaN(k)) this.setEvent(k);
    return k >= BEFORE && k <= LAST ? [] : [noRecord(text, this.k)];
  }
  tell(faults) {
    this.told = faults.length === 0 ? null : { text: faults.join(" "), state: this.state() };
    this.changed();
  }
  setTime(u) {
    this.u = Math.max(0, Math.min(1, u));
    this.k = eventsUntil(FIRST, this.u);
    this.changed();
  }
  // To where the runs part.
  goToDivergence() {
    if (PARTED <= BEFORE) return;
    if (PARTED <= LAST) this.setEvent(PARTED); else this.setTime(this.partedAt);
  }
  goToQuery() {
    if (FIRST.queries.length > 0) this.setTime(nextQuery(this).u);
  }
  nextExternal(step) {
    let k = this.k + step;
    const wanted = e => FIRST.s[e] === this.index && FIRST.x[e] === 1;
    while (k > BEFORE && k <= LAST && !wanted(at(FIRST, k))) k += step;
    this.setEvent(k);
  }
  setStructure(index) {
    this.index = index;
    document.getElementById("structure").value = index;
    this.selected = this.chosenGroup = null;
    const line = DATA.structures[index].key !== null;
    const can = { plane: AXES > 1 || BODIES, time: line && !BODIES, axis: line && !BODIES,
                  tree: !BODIES && this.hasTree(index) };
    for (const option of document.getElementById("drawing").options) {
      option.disabled = !can[option.value];
    }
    const first = ["time", "plane", "tree", "axis"].find(mode => can[mode]) || "plane";
    this.setMode(this.mode && can[this.mode] ? this.mode : first);
  }
  // The groups of the proof have places in a tree.
  hasTree(index) {
    const own = this.runProofs[index], reads = own.data.reads;
    const proof = own.isEmpty && reads !== null ? this.runProofs[reads] : own;
    return proof.data.groups.some(group => group[4] !== null);
  }
  setMode(mode) {
    this.mode = mode;
    document.getElementById("drawing").value = mode;
    this.panel.shownEvent = null;
    this.changed();
  }
  play(on) {
    if (on && this.u >= 1) this.setTime(0);
    this.playing = on;
    const button = document.getElementById("play");
    button.textContent = on ? "Pause" : "\u25b6 Play";
    button.setAttribute("aria-label", on ? "Pause" : "Play");
    const own = ++this.plays;
    if (!on) return this.changed();
    let last = performance.now();
    const frame = now => {
      if (own !== this.plays) return;
      this.setTime(this.u + Math.max(0, Math.min(LONGEST_FRAME, now - last)) / 1000 * this.rate);
      last = now;
      if (this.u >= 1) this.play(false); else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
  setRate(factor) {
    this.rate = Math.max(SLOWEST, Math.min(FASTEST, this.rate * factor));
    this.drawControls();
  }
  setSpan(factor) {
    if (this.byRecord) {
      this.records = Math.max(4, Math.min(LAST - BEFORE + 2, this.records * factor));
    } else {
      this.span = Math.max(1e-9, Math.min(1.2, this.span * factor));
    }
    this.changed();
  }
  setAxis(byRecord) {
    this.byRecord = byRecord;
    document.getElementById("window-axis").value = byRecord ? "record" : "time";
    this.changed();
  }

  // ---- drawing
  seek() {
    for (const replay of this.replays) replay.seek(this.k);
    if (this.others !== null) for (const replay of this.others) replay.seek(this.kOther());
    for (const proof of this.runProofs) proof.seek(this.k);
    if (BODIES && this.otherProofs) for (const own of this.otherProofs) own.seek(this.kOther());
    document.body.dataset.event = this.k;
  }
  changed() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }
  drawCanvases() {
    this.seek();
    this.drawing.draw(this.picture);
    this.window.draw();
    this.window.drawOverview();
  }
  draw() {
    this.waiting = false;
    this.drawCanvases();
    this.panel.draw(true);
    this.certificates.draw();
    this.drawControls();
    this.drawLegend();
    if (!this.playing) history.replaceState(null, "", addressOf(this));
  }
  drawControls() {
    const set = (id, value) => {
      const input = document.getElementById(id);
      if (document.activeElement !== input || id === "scrub") input.value = value;
    };
    this.drawTold();
    document.getElementById("next-failure").disabled = this.nextFailure() === null;
    document.getElementById("all-certificates").setAttribute("aria-pressed", !BODIES && this.proof !== null && this.showsAll());
    set("scrub", this.k);
    set("number", this.k);
    document.getElementById("scrub").setAttribute("aria-valuetext", "log record " + this.k);
    const rate = this.rate * DATA.time.span;
    document.getElementById("speed").textContent = shortNumber(+rate.toPrecision(2)) + " t/s";
  }
  // While what came of it is shown.
  drawTold() {
    const line = document.getElementById("asked");
    if (this.told !== null && this.told.state !== this.state()) this.told = null;
    line.hidden = this.told === null;
    if (!line.hidden) line.textContent = this.told.text;
  }
  drawLegend() {
    const structure = DATA.structures[this.index];
    const legend = document.getElementById("legend");
    legend.replaceChildren();
    const entry = (colour, text) => {
      const line = make("i"), one = make("span");  // a line and its text stay together
      line.style.color = COLOUR[colour];
      one.append(line, text);
      legend.append(one, " ");
    };
    entry(BODIES ? "s" + this.index % 6 : "first", structure.label + (OTHER === null ? "" : ", " + FIRST.arithmetic));
    for (const [sign, tone, text] of this.mode === "plane" && !BODIES ? meaningsOfMarks(this) : []) {
      const mark = make("b", sign), one = make("span");
      mark.style.color = tone;
      one.append(mark, " " + text);
      legend.append(one, " ");
    }
    if (OTHER !== null) entry("second", "otherwise in " + OTHER.arithmetic);
    const { proof } = this;
    if (BODIES) {
      entry("failed", "fails next, or contact");
    } else if (proof !== null && proof.live.size > 0) {
      if (this.mode !== "time") {
        const count = counted(proof.live.size, "certificate");
        entry("proof", this.mode === "plane" && !this.showsAll() ? count + " (C draws all)" : count);
      }
      const next = proof.next(this.k), { drawing } = this;
      if (next === null) entry("next", "fails next: none of these");
      else if (drawing.isThere === undefined || drawing.isThere(next[0])) entry("next", "fails next");
      if (this.selected !== null) entry("selected", "selected");
    }
    if (!BODIES && this.k > BEFORE) {
      entry("failed", "log record " + this.k + ": what failed and what it changed");
    }
    for (const [shape, name] of BODIES || this.selectedGroup() === null ? []
                                                             : this.selectedGroup().marks) {
      if (shape === "chain") entry("selected", name);
    }
    this.picture.canvas.setAttribute("aria-label", structure.label + " after log record " + this.k);
  }
}

// What is displayed, for tests and scripts: the attribute of every structure after the event.
function kinexState() {
  app.seek();
  const values = replays => Object.fromEntries(
    replays.map((replay, i) => [DATA.structures[i].label, replay.value()]));
  return {
    event: app.k, time: app.k > BEFORE ? instantOf(FIRST, app.k)[0] : DATA.time.start[0],
    certificate: app.certificateName(), objects: app.certificateObjects().map(nameOf),
    structures: values(app.replays), diverges: PARTED,
    proofs: Object.fromEntries(app.runProofs.map((proof, i) => [DATA.structures[i].label, {
      certificates: [...proof.live].map(c => proof.certificate(c).text),
      groups: [...proof.groups()].length, reads: proof.data.reads,
    }])),
    other: app.others === null ? null : { event: app.kOther(), structures: values(app.others) },
    ...(BODIES ? { proof: pairState() } : {}),
  };
}
