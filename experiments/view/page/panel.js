// The event in words and formulas, and the list of all events.
const ROW = 22;  // pixels, as in the style

// c0 + c1 t + ..., highest power first.
function polynomial(coefficients) {
  const span = make("span", undefined, "math");
  const most = 14;
  let shown = 0;
  for (let k = coefficients.length - 1; k >= 0; --k) {
    let c = coefficients[k];
    if (c === "0") continue;
    if (shown === most) {
      span.append(" + \u2026");
      break;
    }
    const minus = c.startsWith("-");
    if (minus) c = c.slice(1);
    span.append((shown === 0 ? (minus ? "\u2212" : "") : minus ? " \u2212 " : " + "));
    if (k === 0 || c !== "1") span.append(shortText(c));
    if (k > 0) span.append(make("i", (k === 0 || c === "1" ? "" : "\u2009") + "t"));
    if (k > 1) span.append(make("sup", String(k)));
    ++shown;
  }
  if (shown === 0) span.append("0");
  return span;
}
// The rows of a sequence that a change replaced, and those that it put there; of rows in the same place only the part that differs.
function changedRows(after, [removed, added, place], length) {
  const before = [...after];
  before.splice(place, added.length, ...removed);
  const cut = ids => Array.from({ length: Math.floor(ids.length / length) }, (_, i) => ids.slice(i * length, (i + 1) * length));
  const [old, now] = [cut(before), cut(after)], texts = rows => new Set(rows.map(row => row.join()));
  if (old.length !== now.length) {
    const [known, kept] = [texts(now), texts(old)];
    return [old.filter(row => !known.has(row.join())), now.filter(row => !kept.has(row.join()))];
  }
  const places = [...old.keys()].filter(i => old[i].join() !== now[i].join());
  const part = (rows, others) => places.map(i => {
    const differs = rows[i].map((id, j) => id !== others[i][j]);
    return length < 5 ? rows[i] : rows[i].slice(differs.indexOf(true), differs.lastIndexOf(true) + 1);
  });
  return [part(old, now), part(now, old)];
}
// Keys for a list that has the focus.
function onArrows(key, actions) {
  const action = actions[key.key];
  if (!action || key.ctrlKey || key.metaKey || key.altKey || key.shiftKey) return;
  key.preventDefault();
  key.stopPropagation();
  action();
}
function bringIntoSight(list, row) {
  const top = row * ROW, height = list.clientHeight;
  if (top < list.scrollTop || top + ROW > list.scrollTop + height) list.scrollTop = Math.max(0, top - height / 2);
}
const negated = coefficients =>
  coefficients.map(c => (c === "0" ? c : c.startsWith("-") ? c.slice(1) : "-" + c));

class Panel {
  constructor(app) {
    this.app = app;
    this.event = document.getElementById("event");
    this.proof = document.getElementById("proof");
    this.list = document.getElementById("list");
    this.rows = document.getElementById("rows");
    this.rows.style.height = (LAST - BEFORE + 1) * ROW + "px";
    this.root = null;  // the picture of the event's polynomial
    this.list.addEventListener("scroll", () => this.drawRows());
    this.list.addEventListener("keydown", key => onArrows(key, {
      ArrowUp: () => app.filter.go(-1), ArrowDown: () => app.filter.go(1) }));
    this.list.addEventListener("click", click => {
      const row = click.target.closest(".row");
      if (row) app.setEvent(+row.dataset.event);
    });
    this.shownEvent = null;
  }

  draw(follow) {
    if (this.shownEvent === this.app.state()) return;
    this.shownEvent = this.app.state();
    this.keepingFocus(() => {
      this.drawEvent();
      this.drawProof();
    });
    if (follow) this.scroll();
    this.drawRows();
  }

  // A button that has the focus is made again in its place.
  keepingFocus(draw) {
    const buttons = () => [this.event, this.proof].map(part => [...part.querySelectorAll("button")]);
    const places = buttons().map(list => list.indexOf(document.activeElement));
    draw();
    buttons().forEach((list, part) => {
      const button = list[places[part]];
      if (button !== undefined) button.focus({ preventScroll: true });
    });
  }

  // The certificate that is selected, or else the one that fails next.
  drawProof() {
    const { app } = this, { proof } = app;
    this.proof.hidden = proof === null || app.replay.lost;
    if (this.proof.hidden) return;
    const next = proof.next(app.k);
    const chosen = app.selected !== null ? app.selected : next === null ? null : next[0];
    this.proof.replaceChildren(make("h2", app.selected !== null ? "Selected certificate"
      : next !== null ? "Fails next, at log record " + next[1] : "Certificates"));
    this.proof.style.borderColor = app.selected !== null ? COLOUR.selected : COLOUR.next;
    if (chosen === null) {
      const text = proof.live.size === 0 ? "The structure has no certificates now."
        : proof.live.size === 1 ? "1 certificate; it does not fail after this."
        : proof.live.size + " certificates; none of them fails after this.";
      this.proof.append(make("p", text));
      return;
    }
    this.proof.append(certificateDetails(proof, chosen, app.k));
  }

  drawEvent() {
    const { app } = this;
    const k = app.k;
    this.root = null;
    this.event.replaceChildren();
    if (k === BEFORE) {
      this.event.append(make("h2", BEFORE === 0 ? "Before the first log record"
                                                : "Before log record " + (BEFORE + 1)));
      this.event.append(make("p", "t = " + DATA.time.start[0]));
    } else {
      this.event.append(make("h2", "Log record " + k + " of " + LAST));
      this.event.append(this.describe(FIRST, k));
      this.drawRoot(k);
    }
    this.drawLost();
    if (OTHER === null || !app.haveParted() || app.kOther() <= OTHER.before) return;
    const j = app.kOther();
    this.event.append(make("h2", OTHER.arithmetic + ", last log record by then: " + j, "other"));
    this.event.append(this.describe(OTHER, j));
  }

  // The failed certificate's polynomial around its root; of exact runs.
  drawRoot(k) {
    const e = at(FIRST, k), instant = instantOf(FIRST, k), own = FIRST.p[e];
    if (FIRST.certificates[e] === 0 || instant.length === 1) return;
    const coefficients = Array.isArray(own) ? own : own > 0 ? instant[1] : negated(instant[1]);
    if (coefficients.length < 2) return;
    this.root = new RootPicture(coefficients, instant);
    this.event.append(this.root.box);
    this.root.draw();
  }

  drawLost() {
    for (const [run, replay] of [[FIRST, this.app.replay], [OTHER, this.app.other]]) {
      if (!replay || !replay.lost) continue;
      this.event.append(make("p", run.arithmetic + " has led the structure astray: " +
                             replay.corrupt[1] + ".", "external"));
    }
  }

  // Of the second run in short.
  describe(run, k) {
    const e = at(run, k);
    const list = make("dl");
    const row = (name, ...content) => {
      const value = make("dd");
      value.append(...content);
      list.append(make("dt", name), value);
    };
    const long = run.x[e] === 1;
    const kind = make("abbr", kindOf(run, k), "kind");
    kind.title = kindText(run.s[e], kindOf(run, k));
    const effect = make("abbr", long ? "external" : "internal", long ? "external" : "internal");
    effect.title = long ? EXTERNAL_TEXT : INTERNAL_TEXT;
    row("kind", kind, " ", effect,
        DATA.structures.length > 1 ? " \u00b7 " + DATA.structures[run.s[e]].label : "");
    if (run.ids[e].length > 0) row("objects", listOf(run.ids[e]));
    if (run.reasons[k]) row("reason", run.reasons[k]);
    if (run !== FIRST) {
      row("time", instantText(instantOf(run, k)));
      return list;
    }
    this.describeCertificate(run, e, row);
    this.describeInstant(run, k, e, row);
    this.describeChange(run, k, row);
    this.describeProof(run, k, row);
    return list;
  }

  describeCertificate(run, e, row) {
    const certificate = run.certificates[e];
    if (certificate === 0) {
      row("certificate", withoutCertificate(run, e));
      return;
    }
    row("certificate", this.certificateText(run, certificate));
    const own = run.p[e], instant = run.instants[run.i[e]];
    if (Array.isArray(own)) {
      row("polynomial", own.length === 0 ? "0" : polynomial(own));
    } else if (own !== 0) {
      row("polynomial", polynomial(own > 0 ? instant[1] : negated(instant[1])));
    }
  }

  // With an object in each place, also where it stands in several.
  certificateText(run, [predicate, ids]) {
    const name = run.predicates[predicate], claim = { name, form: formOf(run, predicate), ids };
    const text = make("span", shortPredicate(name) + "(" + listOf(rolesOf(run, claim).map(([, object]) => object)) + ") \u2265 0 fails");
    text.title = name + "(" + listOf(ids) + ")";
    return text;
  }

  describeInstant(run, k, e, row) {
    const instant = run.instants[run.i[e]];
    const exact = rationalOf(instant), whole = instantText(instant).startsWith("t =");
    row("time", instantText(instant), whole && exact.includes("/") ? " \u2248 " + instant[0] : "");
    if (instant.length > 1) {
      const [, coefficients, root, lower, upper] = instant;
      if (exact !== null && !whole) {
        const fraction = make("span", shortText(exact));
        fraction.title = exact;
        row("exactly", "t = ", fraction);
      }
      if (lower !== upper) {
        row("interval", "[" + shortText(lower) + ", " + shortText(upper) + "] holds it alone");
      }
      const own = run.p[e];
      if (lower !== upper || Array.isArray(own)) {
        const of = make("span");
        of.append("root " + root + " of ", Array.isArray(own) || run.certificates[e] === 0
          ? polynomial(coefficients) : "the polynomial");
        row("which is", of);
      }
    } else {
      row("interval", "none: " + run.arithmetic + " rounds, and proves nothing");
    }
    const stage = run.g[e];
    if (stage === 0) return;
    const order = !run.exact ? "" : "; order among instants: " +
      (stage[1] === "double" ? "double intervals" : stage[1]);
    row("stage", "failure time: " + stage[0] + order);
  }

  describeChange(run, k, row) {
    const index = run.s[at(run, k)], replay = this.app.replays[index];
    const [of, change] = this.changeAt(run, k);
    if (change[0].length + change[1].length === 0) return;
    const length = rowLengthOf(DATA.structures[index], replay.ids);
    const names = tuple => tuple.map(nameOf).join("\u2013");
    const shown = ids => (replay.tuples === null ? ids.map(nameOf) : replay.cut(ids).map(names));
    const [removed, added] = length > 0 && change.length > 2 ? changedRows(replay.ids, change, length).map(rows => rows.map(names))
                                                             : change.slice(0, 2).map(shown);
    const short = texts => (texts.length > 8 ? texts.slice(0, 8).join(", ") + ", \u2026 (" +
      texts.length + ")" : texts.join(", ")) || "nothing";
    row("change", short(removed) + " \u2192 " + short(added) + of);
  }
  // What a log record changed, and words if that is not its own. An external one without a certificate has it in the log, or reports what came
  // about with the earlier ones of its structure at its instant.
  changeAt(run, k) {
    if (run.differences[k]) return ["", run.differences[k]];
    const e = at(run, k), replay = this.app.replays[run.s[e]];
    const isReport = run.x[e] === 1 && run.certificates[e] === 0;
    for (let j = k; j > run.before && run.i[at(run, j)] === run.i[e]; --j) {
      if (run.s[at(run, j)] !== run.s[e]) continue;
      const change = replay.changeAt(j);
      if (change[0].length + change[1].length > 0) return [j === k ? "" : " (at this instant)", change];
      if (!isReport) break;
    }
    return ["", [[], []]];
  }

  // The certificates that go and come at the event, in the proof of its structure.
  describeProof(run, k, row) {
    const proof = this.app.runProofs[run.s[at(run, k)]];
    if (!proof.isKnown(k)) return;
    const [gone, came] = proof.changeAt(k);
    if (gone.length + came.length === 0) return;
    const list = make("ul", undefined, "moves");
    const entries = (certificates, sign, name) => certificates.slice(0, 6).forEach(c => {
      const claim = proof.certificate(c);
      const ids = listOf(claim.ids.filter(id => id < OBJECTS));
      const item = make("li", undefined, name), button = make("button", sign + " " + ids + ": " + claim.role);
      item.title = claim.role + ": " + claim.text;
      button.addEventListener("click", () => {
        if (proof !== this.app.proof) this.app.setStructure(proof.index);
        this.app.select(c);
      });
      item.append(button);
      list.append(item);
    });
    entries(gone, "\u2212", "go");
    entries(came, "+", "come");
    row("certificates", gone.length + (gone.length === 1 ? " goes, " : " go, ") + came.length +
        (came.length === 1 ? " comes" : " come"), list);
  }

  scroll() {
    bringIntoSight(this.list, this.app.filter.rowOf(this.app.k));
  }

  // Another choice of log records is shown.
  filtered() {
    this.rows.style.height = this.app.filter.rows * ROW + "px";
    this.scroll();
    this.drawRows();
  }
  // A page of rows up or down.
  turn(step) {
    this.list.scrollTop += step * Math.max(ROW, this.list.clientHeight - ROW);
    this.drawRows();
  }

  drawRows() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / ROW) - 2);
    const count = Math.ceil(this.list.clientHeight / ROW) + 4;
    const rows = [];
    for (let i = first; i < first + count && i < this.app.filter.rows; ++i) {
      const row = this.row(this.app.filter.recordAt(i));
      row.style.top = i * ROW + "px";
      rows.push(row);
    }
    this.rows.replaceChildren(...rows);
    this.list.setAttribute("aria-activedescendant", "record-" + this.app.k);
  }

  row(k) {
    const now = k === this.app.k;
    let name = "row" + (now ? " now" : "");
    const row = make("div");
    row.dataset.event = k;
    row.id = "record-" + k;
    row.setAttribute("role", "option");
    row.setAttribute("aria-selected", now);
    if (k === BEFORE) {
      row.append(make("span", k + "  ", "n"), "start");
    } else {
      const e = at(FIRST, k);
      if (FIRST.s[e] !== this.app.shown()) name += " faded";
      if (k === PARTED) name += " parted";
      row.append(make("span", String(k), "n"),
                 make("span", "", FIRST.x[e] === 1 ? "bar" : "bar short"),
                 make("b", kindOf(FIRST, k)), " " + listOf(FIRST.ids[e]) + " ",
                 make("span", shortInstant(instantOf(FIRST, k)), "n"));
      row.title = listOf(FIRST.ids[e]) + " \u2014 " + explain(FIRST, k);
    }
    row.className = name;
    return row;
  }
}
