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
    this.edges = null;
    if (this.shape === "edges") {
      this.edges = new Set();
      for (let i = 0; i + 1 < this.ids.length; i += 2) this.edges.add(this.code(this.ids, i));
    }
  }

  code(ids, i) { return ids[i] * OBJECTS + ids[i + 1]; }

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
    if (this.edges === null) {
      this.ids.splice(place, removed.length, ...added);
      return;
    }
    for (let i = 0; i < removed.length; i += 2) this.edges.delete(this.code(removed, i));
    for (let i = 0; i < added.length; i += 2) this.edges.add(this.code(added, i));
  }

  get lost() { return this.corrupt !== null && this.event >= this.corrupt[0]; }

  // What event k itself changed: [removed ids, added ids].
  changeAt(k) {
    const removed = [], added = [];
    for (let i = this.applied - 1; i >= 0 && this.changes[i][0] >= k; --i) {
      if (this.changes[i][0] > k) continue;
      removed.push(...this.changes[i][2]);
      added.push(...this.changes[i][3]);
    }
    return [removed, added];
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
    if (this.edges === null) return this.ids.map(nameOf);
    return [...this.edges].sort((a, b) => a - b)
      .map(code => [nameOf(Math.floor(code / OBJECTS)), nameOf(code % OBJECTS)]);
  }
}
