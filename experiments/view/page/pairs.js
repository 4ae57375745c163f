// The proofs of pairs of bodies: the claims about a pose, by their figures and roles, and the
// features of the two polygons behind them.
const pairCode = (a, b) => a * OBJECTS + b;
const pairOf = code => [Math.floor(code / OBJECTS), code % OBJECTS];

// The pair that an event is about, or null.
function pairOfEvent(run, e) {
  const ids = run.ids[e];
  return ids.length >= 2 && ids[0] < OBJECTS && ids[1] < OBJECTS
    ? pairCode(Math.min(ids[0], ids[1]), Math.max(ids[0], ids[1])) : null;
}

const numbersOf = id => DATA.things[id - OBJECTS][1];
// The lines and points of a claim: {z: 0 or 1 for the body whose frame they are in, line: is it
// one, numbers, feature}.
function partsOf(claim) {
  return claim.form.roles.flatMap((role, i) => (role.kind === "line" || role.kind === "frame point"
    ? [{ z: role.frame, line: role.kind === "line", numbers: numbersOf(claim.ids[i]),
         feature: claim.features[i] }] : []));
}

// In the first body's frame: the sum of a point of it and one of the second body.
function sumOfPoints(points, pose) {
  return points.reduce(([x, y], { z, numbers }) => {
    const p = z === 0 ? numbers.slice(3) : turn(pose, numbers.slice(3));
    return [x + p[0], y + p[1]];
  }, [0, 0]);
}
// The claim says that the pose is in a half-plane.
const isHalfPlane = claim => ["half-plane", "ray", "along"].includes(claim.form.figure);
// In the first body's frame: where such a claim says that the point is.
function halfPlane(claim, pose) {
  const { sign, figure } = claim.form, parts = partsOf(claim);
  if (figure === "ray") {
    const c = sumOfPoints(parts.slice(0, 2), pose), end = sumOfPoints(parts.slice(2), pose);
    const n = [sign * (c[1] - end[1]), sign * (end[0] - c[0])];
    return { n, offset: n[0] * c[0] + n[1] * c[1] };
  }
  const line = parts.find(part => part.line), points = parts.filter(part => !part.line);
  const [nx, ny, h] = line.numbers;
  const normal = figure === "along" ? [-ny, nx] : [nx, ny];
  const n = line.z === 0 ? normal : turn(pose, normal);
  const shift = sumOfPoints(points, pose);
  const offset = (figure === "along" ? 0 : h) + n[0] * shift[0] + n[1] * shift[1];
  return sign > 0 ? { n, offset } : { n: [-n[0], -n[1]], offset: -offset };
}

// "a.e3": edge 3 of body a, from vertex 3 on; "a.v3"; "a.v3..v5": a corner of an outer polygon over
// the vertices from 3 to 5.
function featureName(body, feature) {
  const name = nameOf(body);
  if (!feature) return name + " \u2013";
  const [kind, first, last] = feature;
  if (kind === "vertex") return name + ".v" + first;
  if (kind === "edge") return name + ".e" + first;
  if (kind === "across") return name + ".e" + first + " at v" + last;
  if (kind === "corner") return name + ".v" + first + "..v" + last;
  return first === last ? name + ".v" + first : name + ".e" + first;
}
// A part of a polygon as a feature.
const featureOf = ([kind, , place]) => [kind, place, place];
// What a claim is about, by names of features; a ray by what it goes through.
function claimName(claim, pair) {
  const parts = partsOf(claim);
  if (parts.length === 0) return listOf(claim.ids.filter(id => id < OBJECTS));
  const shown = claim.form.figure === "ray" ? parts.slice(2) : parts;
  return shown.map(part => featureName(pair[part.z], part.feature))
    .join(claim.form.figure === "normals" ? " \u2226 " : " + ");
}

// The proof of one structure, by pairs of bodies.
class Pairs {
  constructor(run, index) {
    this.run = run;
    this.proof = new Proof(run, index);
    this.groups = new Map();     // numbers of groups, by pair
    this.failures = new Map();   // numbers of events with a certificate, by pair
    this.meetings = new Map();   // numbers of external events, by pair
    this.records = countsOf(run, index).records;
    for (const [number, , about] of this.proof.data.groups) {
      if (about.length === 2) this.groups.set(pairCode(...about), number);
    }
    run.u.forEach((_, e) => {
      const k = e + run.before + 1, pair = pairOfEvent(run, e);
      if (run.s[e] !== index || pair === null) return;
      const note = map => {
        if (!map.has(pair)) map.set(pair, []);
        map.get(pair).push(k);
      };
      if (run.certificates[e] !== 0) note(this.failures);
      if (run.x[e] === 1) note(this.meetings);
    });
  }

  seek(k) { this.proof.seek(k); }
  // The group of a pair after the event that the proof is at, or null.
  group(pair) {
    const number = this.groups.get(pair);
    return number === undefined ? null : this.proof.group(number);
  }
  claims(pair) {
    const number = this.groups.get(pair);
    return number === undefined ? [] :
      this.proof.certificatesOf(number).map(c => this.proof.certificate(c));
  }
  marks(pair, shape) {
    const group = this.group(pair);
    return group === null ? [] : group.marks.filter(mark => mark[0] === shape);
  }
  // The next event of the pair that a certificate causes, or null.
  nextFailure(pair, k) {
    const list = this.failures.get(pair) || [];
    const place = placeUntil(list, k) + 1;
    return place < list.length ? list[place] : null;
  }
  // The place of the certificate that fails next among those of the pair, -1: none of these.
  failingSlot(pair, k) {
    const next = this.nextFailure(pair, k);
    if (next === null) return -1;
    const key = claimKey(...this.run.certificates[at(this.run, next)]);
    return this.claims(pair).findIndex(claim => claim.key === key);
  }
  // The contact that the pair is in after event k: {event, features}, or null.
  contact(pair, k, replay) {
    if (!replay.edges || !replay.edges.has(pair)) return null;
    const list = this.meetings.get(pair) || [];
    const place = placeUntil(list, k);
    if (place < 0) return { event: null, features: [0, 0] };
    const parts = this.run.ids[at(this.run, list[place])].filter(id => id >= OBJECTS)
      .map(id => DATA.things[id - OBJECTS][2]).filter(part => part !== 0);
    return { event: list[place],
             features: parts.length === 2 ? parts.map(featureOf) : [0, 0] };
  }
  // The features that a mark joins: [of the first body, of the second], or null.
  joined(pair) {
    const mark = this.marks(pair, "join")[0];
    return mark === undefined ? null : mark.slice(2).map(featureOf);
  }
  // The state of the pair's proof in words.
  describe(pair) {
    const group = this.group(pair);
    return group === null ? "the pair has no certificates of its own" : group.text || group.kind;
  }
  // The groups that are about one body of the pair alone.
  singles(pair) {
    const bodies = pairOf(pair);
    return [...this.proof.groups()].filter(({ about }) => about.length === 1 &&
                                                          bodies.includes(about[0]));
  }
}
