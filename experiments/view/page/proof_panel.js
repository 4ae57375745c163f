const shortName = name =>
  (name.length <= 30 ? name : name.slice(0, 12) + "\u2026" + name.slice(-8));

// The proof of a pair in words: which certificates it has, and of the one that fails next the
// polynomial, the interval and the stage, before it does.
class ProofPanel extends Panel {
  constructor(app) {
    super(app);
    this.proof = document.getElementById("proof");
    this.proof.hidden = false;
    document.body.classList.add("bodies");
  }

  draw(follow) {
    const stale = this.shownEvent !== this.app.state();
    super.draw(follow);
    if (stale) this.drawProof();
  }

  drawProof() {
    const { app } = this;
    const index = app.shown(), pair = app.pair(), proofs = app.proofs[index];
    const title = make("h2", DATA.structures[index].label + ": " + pairOf(pair).map(nameOf).join(", "));
    this.proof.style.borderColor = app.colourOf(index);
    this.proof.replaceChildren(title);
    if (app.replays[index].lost) {
      this.proof.append(make("p", "The structure was led astray: it has no proof."));
      return;
    }
    const contact = proofs.contact(pair, app.k, app.replays[index]);
    if (contact !== null) this.drawContact(pair, contact);
    this.proof.append(make("p", proofs.describe(pair, app.k, app.replays[index]), "tile"));
    this.drawClaims(pair, proofs);
    this.drawNext(pair, proofs);
    this.drawOthers(pair);
  }

  drawContact(pair, contact) {
    if (contact.event === null) {
      this.proof.append(make("p", "contact: " + pairOf(pair).map(nameOf).join(" meets "), "external"));
      this.proof.append(make("p", BEFORE === 0 ? "from the beginning"
                                               : "since before log record " + (BEFORE + 1)));
      return;
    }
    const names = pairOf(pair).map((body, z) => featureName(body, contact.features[z]));
    this.proof.append(make("p", "contact: " + names.join(" meets "), "external"));
    this.proof.append(make("p", "since log record " + contact.event + ", t \u2248 " +
                           instantOf(FIRST, contact.event)[0]));
  }

  drawClaims(pair, proofs) {
    const failing = proofs.failingSlot(pair, this.app.k);
    const list = make("ol", undefined, "claims");
    proofs.claims(pair, this.app.k).forEach((claim, slot) => {
      const item = make("li", undefined, slot === failing ? "fails" : "");
      item.append(make("b", claim.name), " " + claimName(claim, pairOf(pair)));
      item.title = claim.text;
      list.append(item);
    });
    this.proof.append(list);
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
      const so = placeUntil(proofs.events, app.k) + 1;
      const state = app.replays[index].lost ? "led astray"
        : proofs.describe(pair, app.k, app.replays[index]);
      const value = make("dd", so + " of " + proofs.events.length + " events");
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
function proofState() {
  const pair = app.pair();
  return { pair: pairOf(pair).map(nameOf), structures: Object.fromEntries(
    app.proofs.map((proofs, index) => {
      const next = proofs.nextFailure(pair, app.k), entry = proofs.entry(pair, app.k);
      const claims = proofs.claims(pair, app.k);
      const names = found => pairOf(pair).map((body, z) => featureName(body, found[z]));
      const found = proofs.features(claims);
      const contact = proofs.contact(pair, app.k, app.replays[index]);
      return [DATA.structures[index].label, {
        claims: claims.map(claim => ({ certificate: claim.text, kind: claim.kind,
                                       features: claimName(claim, pairOf(pair)) })),
        tile: entry === null ? 0 : entry[2],
        text: proofs.describe(pair, app.k, app.replays[index]),
        next, slot: proofs.failingSlot(pair, app.k), closest: found ? names(found) : null,
        contact: contact === null ? null : { event: contact.event, features: names(contact.features) },
        events: [placeUntil(proofs.events, app.k) + 1, proofs.events.length],
      }];
    })) };
}
