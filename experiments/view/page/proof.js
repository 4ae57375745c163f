// The proof of one structure in one run, from the record: the live certificates and their groups
// after every event, applied in both directions. Its names and figures are data of the run: this
// code knows no structure and no predicate.

// The last of an ascending list that is <= k: its place, or -1.
function placeUntil(list, k, key = x => x) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (key(list[middle]) <= k) low = middle + 1; else high = middle;
  }
  return low - 1;
}

// What a predicate claims of its arguments.
function formOf(run, predicate) {
  const [figure, sign, says, direction, roles, places] = run.forms[predicate];
  return { figure, sign, says, direction: direction === 0 ? null : direction,
           places: places.length === 0 ? null : places,
           roles: roles.map(([name, kind, frame]) => ({ name, kind, frame })) };
}
// A predicate some of whose arguments are one object is named with the object of each argument, "gap/0121": the name without these.
const shortPredicate = name => name.split("/")[0];
// [role, object] for every argument of the predicate that "gap_product/0121" is a form of. A run that does not name that predicate
// tells the first role of each object.
function rolesOf(run, { name, form, ids }) {
  const whole = form.places === null || !name.includes("/") ? -1
    : run.predicates.findIndex((other, i) => other === shortPredicate(name) && run.forms[i][4].length === form.places.length);
  return whole < 0 ? form.roles.map((role, i) => [role.name, ids[i]])
                   : form.places.map((object, place) => [run.forms[whole][4][place][0], ids[object]]);
}
const claimKey = (predicate, ids) => predicate + ":" + ids.join();
const NO_EVENTS = [];
const shortName = name =>
  (name.length <= 30 ? name : name.slice(0, 12) + "\u2026" + name.slice(-8));
// The claim as a sentence.
const sentence = (form, ids) =>
  form.says.replace(/\{(\d)\}/g, (_, i) => shortName(nameOf(ids[+i])));

class Proof {
  constructor(run, index) {
    this.run = run;
    this.index = index;
    this.data = run.proofs[index];
    this.changes = this.data.changes;
    this.applied = 0;
    this.live = new Set();        // places in data.certificates
    this.states = new Map();      // by number of a group: its place in data.groups
    this.members = new Map();     // by number of a group: its live certificates
    this.undone = [];             // by applied change: the states that it replaced
    const count = this.data.certificates.length;
    this.born = new Int32Array(count);
    this.died = new Int32Array(count).fill(0x7fffffff);
    for (const [event, gone, came] of this.changes) {
      for (const c of gone) this.died[c] = event;
      for (const c of came) this.born[c] = event;
    }
    this.failuresByClaim = new Array(run.claims.length);  // as far as they were asked for
    this.times = new Float64Array(count).fill(NaN);       // likewise, by certificate
  }

  get isEmpty() { return this.data.groups.length === 0; }
  // The proof is known after event k.
  isKnown(k) { return this.data.ends === null || k <= this.data.ends; }

  // To the state after event k.
  seek(k) {
    while (this.applied < this.changes.length && this.changes[this.applied][0] <= k) this.forward();
    while (this.applied > 0 && this.changes[this.applied - 1][0] > k) this.back();
  }
  forward() {
    const [, gone, came, states, ended] = this.changes[this.applied++];
    const before = [];
    for (const group of ended) {
      before.push([group, this.states.get(group)]);
      this.states.delete(group);
    }
    for (const state of states) {
      const group = this.data.groups[state][0];
      before.push([group, this.states.get(group)]);
      this.states.set(group, state);
    }
    this.undone[this.applied - 1] = before;
    for (const c of gone) this.remove(c);
    for (const c of came) this.add(c);
  }
  back() {
    const [, gone, came] = this.changes[--this.applied];
    for (const c of came) this.remove(c);
    for (const c of gone) this.add(c);
    for (const [group, state] of this.undone[this.applied].reverse()) {
      if (state === undefined) this.states.delete(group); else this.states.set(group, state);
    }
  }
  add(c) {
    const group = this.data.certificates[c][0];
    this.live.add(c);
    if (!this.members.has(group)) this.members.set(group, new Set());
    this.members.get(group).add(c);
  }
  remove(c) {
    const group = this.data.certificates[c][0];
    this.live.delete(c);
    if (this.members.has(group)) this.members.get(group).delete(c);
  }

  // A certificate with its parts.
  certificate(c) {
    const [group, slot, role, claim, failure] = this.data.certificates[c];
    const [predicate, ids, features] = this.run.claims[claim];
    const form = formOf(this.run, predicate), name = this.run.predicates[predicate];
    return { number: c, group, slot, role: this.data.roles[role], ids, features, form, name, failure,
             text: name + "(" + listOf(ids) + ")", key: claimKey(predicate, ids) };
  }
  // The state of a group, or null if it is not there.
  group(number) {
    const state = this.states.get(number);
    return state === undefined ? null : this.groupState(state);
  }
  groupState(state) {
    const [group, kind, about, text, place, parent, branch, marks] = this.data.groups[state];
    return { group, kind, about, text, place, parent, branch, marks };
  }
  // All groups that are there.
  *groups() {
    for (const state of this.states.values()) yield this.groupState(state);
  }
  // The live certificates of a group, in their order.
  certificatesOf(number) {
    const own = this.members.get(number);
    if (!own) return [];
    const slot = c => this.data.certificates[c][1];
    return [...own].sort((a, b) => slot(a) - slot(b));
  }

  // What event k changed: [certificates that go, certificates that come], those that only change
  // their place in a group left out.
  changeAt(k) {
    const place = placeUntil(this.changes, k, change => change[0]);
    if (place < 0 || this.changes[place][0] !== k || k === this.run.before) return [[], []];
    const [, gone, came] = this.changes[place];
    const mark = c => {
      const [group, , role, claim] = this.data.certificates[c];
      return group + "/" + role + "/" + claim;
    };
    const before = new Set(gone.map(mark)), after = new Set(came.map(mark));
    return [gone.filter(c => !after.has(mark(c))), came.filter(c => !before.has(mark(c)))];
  }

  // The events of the structure that a failure caused, by the text of the claim.
  get failures() {
    if (this.failureLists) return this.failureLists;
    this.failureLists = new Map();
    this.run.u.forEach((_, e) => {
      const certificate = this.run.certificates[e];
      if (this.run.s[e] !== this.index || certificate === 0) return;
      const k = e + this.run.before + 1, key = claimKey(...certificate);
      if (!this.failureLists.has(key)) this.failureLists.set(key, []);
      this.failureLists.get(key).push(k);
    });
    return this.failureLists;
  }
  // The same by the number of a claim; several have one text.
  failuresOf(claim) {
    return this.failuresByClaim[claim] ??= this.failures.get(claimKey(...this.run.claims[claim])) || NO_EVENTS;
  }
  // The event after event k at which this certificate fails, or null: it goes before, or the page ends before.
  failsAt(c, k = 0) {
    const list = this.failuresOf(this.data.certificates[c][3]);
    if (list === NO_EVENTS) return null;
    const place = placeUntil(list, Math.max(k, this.born[c])) + 1;
    return place < list.length && list[place] <= this.died[c] ? list[place] : null;
  }
  // The live certificate that fails next, [certificate, event]; null: none of them does, others come before.
  // Several parts of the page ask after one event.
  next(k) {
    if (this.asked === undefined || this.asked.k !== k || this.asked.applied !== this.applied) {
      this.asked = { k, applied: this.applied, answer: this.findNext(k) };
    }
    return this.asked.answer;
  }
  findNext(k) {
    let next = null;
    for (const c of this.live) {
      const event = this.failsAt(c, k);  // one failure may be several events
      if (event !== null && (next === null || event < next[1])) next = [c, event];
    }
    return next;
  }
  // When it fails, as far as the run knew: u, or Infinity.
  failureTime(c) {
    const failure = this.data.certificates[c][4];
    if (failure === -2) return timeOf(this.run, this.born[c]);
    return Array.isArray(failure) && failure.length === 1 && failure[0] !== null ? failure[0]
                                                                                 : Infinity;
  }
  // When it fails at an event of the page, or else as far as the run knew.
  timeOfFailure(c) {
    if (Number.isNaN(this.times[c])) {
      const k = this.failsAt(c);
      this.times[c] = k !== null ? timeOf(this.run, k) : this.failureTime(c);
    }
    return this.times[c];
  }
  // The same in words.
  failureText(c) {
    const k = this.failsAt(c), failure = this.data.certificates[c][4];
    if (k !== null) return "at log record " + k + ", " + instantText(instantOf(this.run, k));
    const time = u => (u === null ? "unknown" : timeText(u));
    const goes = this.died[c] < 0x7fffffff ? "; it goes at log record " + this.died[c] : "";
    if (failure === 0) return "never, up to the end" + goes;
    if (failure === -1) return "never: it is identically zero" + goes;
    if (failure === -2) return "at once" + goes;
    return (failure.length === 1 ? "t \u2248 " : "not before t \u2248 ") + time(failure[0]) + goes;
  }
}

// A group in words.
const groupName = group => group.kind +
  (group.about.length > 0 && group.about.length <= 4 ? " " + listOf(group.about) : "");
