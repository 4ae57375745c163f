// The certificates of the proof that is shown: a list by failure time, the earliest first, of which
// only the rows in sight are made; and the one that is selected, with its roles.
class Certificates {
  constructor(app) {
    this.app = app;
    this.box = document.getElementById("certificates");
    this.rows = document.getElementById("certificate-rows");
    this.box.addEventListener("scroll", () => this.drawRows());
    this.box.addEventListener("click", click => {
      const row = click.target.closest(".row");
      if (row) app.select(+row.dataset.certificate);
    });
    this.box.addEventListener("keydown", key => onArrows(key, {
      ArrowUp: () => this.choose(this.chosen() - 1), ArrowDown: () => this.choose(this.chosen() + 1),
      Home: () => this.choose(0), End: () => this.choose(this.order.length - 1) }));
    this.known = null;
    this.listed = null;  // the proof whose certificates `order` has
    this.order = [];
  }

  draw() {
    if (this.box.hidden) return;
    const { app } = this, { proof } = app;
    const known = app.state() + "/" + (proof === null ? "" : proof.applied);
    if (known !== this.known || proof !== this.listed) {
      this.known = known;
      this.listed = proof;
      this.order = proof === null || app.replay.lost ? [] : this.sorted(proof);
      this.rows.style.height = this.order.length * ROW + "px";
    }
    this.drawRows();
  }

  // Failures at events of the page, failures that the run knew, then the others.
  sorted(proof) {
    const all = [...proof.live], { times } = proof;
    for (const c of all) proof.timeOfFailure(c);
    return all.sort((a, b) => (times[a] === times[b] ? a - b : times[a] - times[b]));
  }

  // The place of the selected certificate in the list, or -1.
  chosen() { return this.app.selected === null ? -1 : this.order.indexOf(this.app.selected); }
  // Selects the certificate at a place, or at the end that is nearest to it.
  choose(place) {
    if (this.order.length === 0) return;
    const row = Math.max(0, Math.min(this.order.length - 1, place));
    this.app.select(this.order[row]);
    bringIntoSight(this.box, row);
  }

  // In short when it fails: a number of a log record, or a time, or "-".
  when(c) {
    const { proof } = this.app, k = proof.failsAt(c), time = proof.failureTime(c);
    if (k !== null) return "#" + k;
    return isFinite(time) ? "t \u2248 " + timeText(time) : "\u2013";
  }

  drawRows() {
    const { app } = this;
    if (this.box.hidden || app.proof !== this.listed) return;
    if (this.order.length === 0) {
      this.rows.replaceChildren(make("p", "There is no certificate."));
      return;
    }
    const first = Math.max(0, Math.floor(this.box.scrollTop / ROW) - 2);
    const count = Math.ceil(this.box.clientHeight / ROW) + 4;
    this.rows.replaceChildren(...this.order.slice(first, first + count).map((c, i) => {
      const claim = app.proof.certificate(c);
      const row = make("div", undefined, "row" + (c === app.selected ? " now" : ""));
      row.dataset.certificate = c;
      row.id = "certificate-" + c;
      row.setAttribute("role", "option");
      row.setAttribute("aria-selected", c === app.selected);
      row.style.top = (first + i) * ROW + "px";
      const group = app.proof.group(claim.group);
      row.append(make("span", this.when(c) + "  ", "n"),
                 make("b", group === null ? "" : groupName(group)), " " + claim.role);
      row.title = claim.text + ": " + app.proof.failureText(c);
      return row;
    }));
    this.box.setAttribute("aria-activedescendant", app.selected === null ? "" : "certificate-" + app.selected);
  }
}

// One certificate: what it claims of which objects in which roles, and when it fails.
function certificateDetails(proof, c, k) {
  const claim = proof.certificate(c), group = proof.group(claim.group);
  const list = make("dl", undefined, "details");
  const row = (name, ...content) => {
    const value = make("dd");
    value.append(...content);
    list.append(make("dt", name), value);
  };
  row("says", sentence(claim.form, claim.ids));
  const predicate = make("span", shortPredicate(claim.name), "kind");
  predicate.title = claim.text;
  row("predicate", predicate);
  for (const [role, object] of rolesOf(proof.run, claim)) {
    const name = make("span", shortName(nameOf(object)));
    name.title = nameOf(object);
    row(role, name);
  }
  if (group !== null) {
    row("group", groupName(group) + (group.text ? ": " + group.text : ""));
    if (claim.role) row("as", claim.role);
  }
  if (proof.born[c] > proof.run.before) row("since", "log record " + proof.born[c]);
  if (proof.died[c] <= k) {
    row("gone", "since log record " + proof.died[c]);
  } else {
    row("fails", proof.failureText(c));
  }
  return list;
}
