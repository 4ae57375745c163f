// The proof of a pair in words: which certificates it has, and of the one that fails next the
// polynomial, the interval and the stage, before it does.
class PairPanel extends Panel {
  constructor(app) {
    super(app);
    this.proof.hidden = false;
    document.body.classList.add("bodies");
  }

  drawProof() {
    const { app } = this;
    const index = app.shown(), pair = app.pair(), proofs = app.proofs[index];
    const title = make("h2", DATA.structures[index].label + ": " + pairOf(pair).map(nameOf).join(", "));
    this.proof.style.borderColor = app.colourOf(index);
    this.proof.replaceChildren(title);
    if (app.replays[index].lost) {
      this.proof.append(make("p", "The structure is corrupt: it has no proof."));
      return;
    }
    const contact = proofs.contact(pair, app.k, app.replays[index]);
    if (contact !== null) this.drawContact(pair, contact);
    this.proof.append(make("p", proofs.describe(pair), "state"));
    this.drawClaims(pair, proofs);
    for (const group of proofs.singles(pair)) {
      this.proof.append(make("p", groupName(group) + ": " + group.text, "quiet"));
    }
    this.drawNext(pair, proofs);
    this.drawOthers(pair);
  }

  drawContact(pair, contact) {
    if (contact.event === null || contact.features[0] === 0) {
      this.proof.append(make("p", "contact: " + pairOf(pair).map(nameOf).join(" meets "), "external"));
      this.proof.append(make("p", contact.event !== null ? "since log record " + contact.event
        : BEFORE === 0 ? "from the beginning" : "since before log record " + (BEFORE + 1)));
      return;
    }
    const names = pairOf(pair).map((body, z) => featureName(body, contact.features[z]));
    this.proof.append(make("p", "contact: " + names.join(" meets "), "external"));
    this.proof.append(make("p", "since log record " + contact.event + ", " +
                           instantText(instantOf(FIRST, contact.event))));
  }

  drawClaims(pair, proofs) {
    const { app } = this;
    const failing = proofs.failingSlot(pair, app.k);
    const list = make("ol", undefined, "claims");
    proofs.claims(pair).forEach((claim, slot) => {
      const item = make("li", undefined, (slot === failing ? "fails" : "") +
                                         (claim.number === app.selected ? " chosen" : ""));
      const button = make("button");
      button.append(make("b", claim.role), " " + claimName(claim, pairOf(pair)));
      button.setAttribute("aria-pressed", claim.number === app.selected);
      button.addEventListener("click", () =>
        app.select(app.selected === claim.number ? null : claim.number));
      item.append(button);
      item.title = claim.text;
      list.append(item);
    });
    this.proof.append(list);
    if (app.selected === null || !proofs.proof.live.has(app.selected)) return;
    this.proof.append(make("h2", "Selected certificate"),
                      certificateDetails(proofs.proof, app.selected, app.k));
  }

  drawNext(pair, proofs) {
    const next = proofs.nextFailure(pair, this.app.k);
    if (next === null) {
      this.proof.append(make("p", "No certificate of this pair fails after this."));
      return;
    }
    const e = at(FIRST, next), slot = proofs.failingSlot(pair, this.app.k);
    const what = slot < 0 ? "a certificate that is not there yet" : "certificate " + (slot + 1);
    this.proof.append(make("h2", "Fails next: " + what + ", log record " + next, "external"));
    const list = make("dl");
    const row = (name, ...content) => {
      const value = make("dd");
      value.append(...content);
      list.append(make("dt", name), value);
    };
    row("leads to", kindOf(FIRST, next));
    this.describeCertificate(FIRST, e, row);
    this.describeInstant(FIRST, next, e, row);
    this.proof.append(list);
  }

  // What the other structures hold of this pair.
  drawOthers(pair) {
    const { app } = this;
    if (app.proofs.length < 2) return;
    const list = make("dl", undefined, "others");
    app.proofs.forEach((proofs, index) => {
      const name = make("dt", DATA.structures[index].label);
      name.style.color = app.colourOf(index);
      const so = placeUntil(proofs.records, app.k) + 1;
      const state = app.replays[index].lost ? "corrupt"
        : proofs.describe(pair);
      const value = make("dd", so + " of " + counted(proofs.records.length, "log record"));
      if (index !== app.shown()) value.append("; " + state);
      list.append(name, value);
    });
    this.proof.append(make("h2", "Beside each other"), list);
  }

  // Constants of a proof can be long numbers.
  certificateText(run, certificate) {
    const names = certificate[1].map(id => shortName(nameOf(id))).join(", ");
    const text = make("span", run.predicates[certificate[0]] + "(" + names + ") \u2265 0 fails");
    text.title = run.predicates[certificate[0]] + "(" + listOf(certificate[1]) + ")";
    return text;
  }
}

// What is displayed of the proofs, for tests and scripts.
function pairState() {
  const pair = app.pair();
  return { pair: pairOf(pair).map(nameOf), structures: Object.fromEntries(
    app.proofs.map((proofs, index) => {
      const group = proofs.group(pair), joined = proofs.joined(pair);
      const names = found => pairOf(pair).map((body, z) => featureName(body, found[z]));
      const contact = proofs.contact(pair, app.k, app.replays[index]);
      return [DATA.structures[index].label, {
        claims: proofs.claims(pair).map(claim => ({
          certificate: claim.text, figure: claim.form.figure, role: claim.role,
          features: claimName(claim, pairOf(pair)) })),
        kind: group === null ? null : group.kind, text: proofs.describe(pair),
        next: proofs.nextFailure(pair, app.k), slot: proofs.failingSlot(pair, app.k),
        closest: joined ? names(joined) : null,
        contact: contact === null ? null
          : { event: contact.event, features: names(contact.features) },
        records: [placeUntil(proofs.records, app.k) + 1, proofs.records.length],
      }];
    })) };
}
