// The combinatorial state of one structure in one run: the value that the run began with and what
// each event changed, applied in both directions. Never recomputed from positions.
class Replay {
  constructor(run, index) {
    const states = run.states[index];
    this.shape = DATA.structures[index].shape;
    this.changes = states.changes;
    this.corrupt = states.corrupt;       // [events before, text] or null
    this.event = run.before;
    this.applied = 0;                    // of the changes
    this.ids = states.initial.slice();   // sequence, cycle, object
    this.width = DATA.structures[index].width;
    this.tuples = null;                  // of a set of tuples: its ids by their text
    this.sides = null;                   // of its tuples, while they are the same
    this.inCells = null;                 // the objects in its tuples, likewise
    if (this.shape === "tuples") {
      this.tuples = new Map();
      for (const tuple of this.cut(this.ids)) this.tuples.set(tuple.join(), tuple);
    }
  }

  cut(ids) {
    const tuples = [];
    for (let i = 0; i + this.width <= ids.length; i += this.width) {
      tuples.push(ids.slice(i, i + this.width));
    }
    return tuples;
  }
  // The ids of the attribute in a row, tuple by tuple if it is a set of tuples.
  get row() {
    return this.tuples === null ? this.ids : [...this.tuples.values()].flat();
  }
  // All pairs that are in one tuple, as numbers; null if the attribute is no set of tuples.
  get edges() {
    if (this.tuples === null || this.sides !== null) return this.sides;
    this.sides = new Set();
    for (const tuple of this.tuples.values()) for (const code of sidesOf(tuple)) this.sides.add(code);
    return this.sides;
  }
  // True if the attribute consists of cells, triangles or larger, and the object is in none of them.
  isHidden(object) {
    if (this.tuples === null || this.width < 3 || this.tuples.size === 0) return false;
    this.inCells ??= new Set([...this.tuples.values()].flat());
    return !this.inCells.has(object);
  }

  // To the state after event k.
  seek(k) {
    this.event = k;
    const changes = this.changes;
    while (this.applied < changes.length && changes[this.applied][0] <= k) {
      const change = changes[this.applied++];
      this.replace(change[1], change[2], change[3]);
    }
    while (this.applied > 0 && changes[this.applied - 1][0] > k) {
      const change = changes[--this.applied];
      this.replace(change[1], change[3], change[2]);
    }
  }

  replace(place, removed, added) {
    if (this.tuples === null) {
      this.ids.splice(place, removed.length, ...added);
      return;
    }
    this.sides = null;
    this.inCells = null;
    for (const tuple of this.cut(removed)) this.tuples.delete(tuple.join());
    for (const tuple of this.cut(added)) this.tuples.set(tuple.join(), tuple);
  }

  get lost() { return this.corrupt !== null && this.event >= this.corrupt[0]; }

  // What event k itself changed: [removed ids, added ids, their place].
  changeAt(k) {
    const removed = [], added = [];
    let place = 0;
    for (let i = this.applied - 1; i >= 0 && this.changes[i][0] >= k; --i) {
      if (this.changes[i][0] > k) continue;
      place = this.changes[i][1];
      removed.push(...this.changes[i][2]);
      added.push(...this.changes[i][3]);
    }
    return [removed, added, place];
  }

  // The object that is the value after event k: for the pieces of an envelope.
  objectAt(k) {
    let low = 0, high = this.changes.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.changes[middle][0] <= k) low = middle + 1; else high = middle;
    }
    if (low > 0) return this.changes[low - 1][3][0];
    return this.changes.length > 0 ? this.changes[0][2][0] : this.ids[0];
  }

  // As summaries write it, by the names of the scene.
  value() {
    if (this.lost) return null;
    if (this.shape === "object") return this.ids.length > 0 ? nameOf(this.ids[0]) : null;
    if (this.shape === "orders") {  // rows of n ids each
      const n = Math.floor(Math.sqrt(this.ids.length)), names = this.ids.map(nameOf);
      return n === 0 ? [] : Array.from({ length: n + 1 }, (_, i) => names.slice(i * n, (i + 1) * n));
    }
    if (this.tuples === null) return this.ids.map(nameOf);
    const before = (a, b) => a.find((id, i) => id !== b[i]) - b.find((id, i) => id !== a[i]) || 0;
    return [...this.tuples.values()].sort(before).map(tuple => tuple.map(nameOf));
  }
}
// The pairs of a tuple as numbers.
const sidesOf = tuple => tuple.flatMap((a, i) => tuple.slice(i + 1).map(b => a * OBJECTS + b));
