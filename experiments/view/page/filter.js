// Which log records the list and the window show: all, or those that fit the words and choices.
//
// Words: of kinds, objects, structures, predicates; "kind:", "object:", "structure:" ask in one of these
// alone, and "external" and "internal" are words too. All words must fit; "-word" must not.
class EventFilter {
  constructor(app) {
    this.app = app;
    this.found = null;  // numbers of log records, ascending; null: all
    this.is = null;     // by place in the run
    this.input = document.getElementById("search");
    this.kind = document.getElementById("search-kind");
    this.structure = document.getElementById("search-structure");
    const option = (select, text, value) => {
      const made = make("option", text);
      made.value = value;
      select.append(made);
    };
    const kinds = new Set(FIRST.s.map((s, e) => DATA.structures[s].kinds[FIRST.k[e]]));
    option(this.kind, "all kinds", "");
    for (const kind of [...kinds].sort()) option(this.kind, kind, kind);
    option(this.structure, "all structures", "");
    DATA.structures.forEach((one, i) => option(this.structure, one.label, i));
    this.structure.hidden = DATA.structures.length < 2;
    for (const field of [this.input, this.kind, this.structure]) {
      field.addEventListener("input", () => this.apply());
    }
    for (const [id, step] of [["match-back", -1], ["match-forward", 1]]) {
      document.getElementById(id).addEventListener("click", () => this.go(step));
    }
    this.tell();
  }

  apply() {
    const words = this.input.value.toLowerCase().split(/\s+/).filter(word => word !== "" && word !== "-");
    const structure = this.structure.value === "" ? null : +this.structure.value;
    if (words.length === 0 && structure === null && this.kind.value === "") {
      this.found = this.is = null;
    } else {
      const tests = words.map(word => this.test(word));
      const fits = e => (structure === null || FIRST.s[e] === structure) &&
        (this.kind.value === "" || DATA.structures[FIRST.s[e]].kinds[FIRST.k[e]] === this.kind.value) &&
        tests.every(test => test(e));
      this.is = Uint8Array.from(FIRST.u, (_, e) => (fits(e) ? 1 : 0));
      this.found = [];
      this.is.forEach((is, e) => { if (is === 1) this.found.push(BEFORE + e + 1); });
    }
    this.tell();
    this.app.panel.filtered();
    this.app.changed();
  }

  // A word as a question about the record at a place.
  test(word) {
    if (word.startsWith("-")) {
      const other = this.test(word.slice(1));
      return e => !other(e);
    }
    if (word === "external") return e => FIRST.x[e] === 1;
    if (word === "internal") return e => FIRST.x[e] === 0;
    const found = word.match(/^(kind|object|structure):(.+)$/);
    const [, where, text] = found || [null, null, word];
    const kinds = DATA.structures.map(s => s.kinds.map(kind => kind.toLowerCase().includes(text)));
    const structures = DATA.structures.map(s => s.label.toLowerCase().includes(text));
    const objects = new Set();
    const named = id => nameOf(id).toLowerCase();
    // Of objects the whole name is meant where there is such a one: "7" is not 17.
    for (let id = 0; id < OBJECTS + (DATA.things || []).length; ++id) if (named(id) === text) objects.add(id);
    if (objects.size === 0) {
      for (let id = 0; id < OBJECTS + (DATA.things || []).length; ++id) if (named(id).includes(text)) objects.add(id);
    }
    const predicates = FIRST.predicates.map(name => name.toLowerCase().includes(text));
    const isKind = e => kinds[FIRST.s[e]][FIRST.k[e]];
    const isStructure = e => structures[FIRST.s[e]];
    const isObject = e => FIRST.ids[e].some(id => objects.has(id)) ||
      (FIRST.certificates[e] !== 0 && FIRST.certificates[e][1].some(id => objects.has(id)));
    if (where === "kind") return isKind;
    if (where === "structure") return isStructure;
    if (where === "object") return isObject;
    return e => isKind(e) || isStructure(e) || isObject(e) ||
      (FIRST.certificates[e] !== 0 && predicates[FIRST.certificates[e][0]]);
  }

  tell() {
    const count = this.found === null ? LAST - BEFORE : this.found.length;
    document.getElementById("matches").textContent =
      this.found === null ? counted(count, "log record") : count + " of " + (LAST - BEFORE);
    for (const id of ["match-back", "match-forward"]) document.getElementById(id).disabled = count === 0;
  }

  fits(k) { return this.is === null || this.is[k - BEFORE - 1] === 1; }
  // Rows of the list: the start, which is one only where nothing is filtered, and log records.
  get rows() { return this.found === null ? LAST - BEFORE + 1 : this.found.length; }
  recordAt(row) { return this.found === null ? BEFORE + row : this.found[row]; }
  // The first row that is not before record k.
  rowOf(k) {
    if (this.found === null) return k - BEFORE;
    let low = 0, high = this.found.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.found[middle] < k) low = middle + 1; else high = middle;
    }
    return low;
  }
  // To the next or the last record that fits.
  go(step) {
    if (this.found === null) return this.app.setEvent(this.app.k + step);
    const row = this.rowOf(this.app.k);
    const to = step < 0 ? row - 1 : this.found[row] === this.app.k ? row + 1 : row;
    if (to >= 0 && to < this.found.length) this.app.setEvent(this.found[to]);
  }
}
