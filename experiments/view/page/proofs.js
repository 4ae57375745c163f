// The proofs of pairs of bodies, from the record: the certificates of each pair after every event,
// the features of the polygons behind them, and which of them fails next.
const pairCode = (a, b) => a * OBJECTS + b;
const pairOf = code => [Math.floor(code / OBJECTS), code % OBJECTS];

// The pair that an event is about, or null.
function pairOfEvent(run, e) {
  const ids = run.ids[e];
  return ids.length >= 2 && ids[0] < OBJECTS && ids[1] < OBJECTS
    ? pairCode(Math.min(ids[0], ids[1]), Math.max(ids[0], ids[1])) : null;
}

// The last of an ascending list that is <= k: its place, or -1.
function placeUntil(list, k, key = x => x) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (key(list[middle]) <= k) low = middle + 1; else high = middle;
  }
  return low - 1;
}

// A certificate with its parts. A side has a line of body z (0: the first) and a point of the other
// one; an order of normals has a line of each; a ray goes from the sum of the first two of its points,
// of either body in turns, through that of the last two.
function claimOf(run, c) {
  const [predicate, ids, features] = run.claims[c];
  const name = run.predicates[predicate];
  const numbers = i => DATA.things[ids[i] - OBJECTS][1];
  const claim = { name, ids, text: name + "(" + listOf(ids) + ")" };
  const side = /^(side|inside)_([ab])$/.exec(name);
  if (side) {
    const z = side[2] === "a" ? 0 : 1;
    return { ...claim, kind: "side", z, sign: side[1] === "side" ? 1 : -1,
             line: { z, numbers: numbers(1), feature: features[1] },
             point: { z: 1 - z, numbers: numbers(2), feature: features[2] } };
  }
  const ray = /^(left|right)_of_ray$/.exec(name);
  if (ray) {
    return { ...claim, kind: "ray", sign: ray[1] === "left" ? 1 : -1, points: [1, 2, 3, 4].map(
      i => ({ z: (i - 1) % 2, numbers: numbers(i), feature: features[i] })) };
  }
  if (name.startsWith("normal_order")) {
    return { ...claim, kind: "order", lines: [1, 2].map(
      i => ({ z: i - 1, numbers: numbers(i), feature: features[i] })) };
  }
  return { ...claim, kind: "volume" };
}

// In the first body's frame: the sum of a point of it and one of the second body.
function sumOfPoints([p, q], pose) {
  const [x, y] = turn(pose, q.numbers.slice(3));
  return [p.numbers[3] + x, p.numbers[4] + y];
}
// Sides and rays are half-planes.
const isHalfPlane = claim => claim.kind === "side" || claim.kind === "ray";
// In the first body's frame: where such a claim says that the point is.
function halfPlane(claim, pose) {
  if (claim.kind === "ray") {
    const c = sumOfPoints(claim.points.slice(0, 2), pose);
    const end = sumOfPoints(claim.points.slice(2), pose);
    const n = [claim.sign * (c[1] - end[1]), claim.sign * (end[0] - c[0])];
    return { n, offset: n[0] * c[0] + n[1] * c[1] };
  }
  const [nx, ny, h] = claim.line.numbers, p = claim.point.numbers.slice(3);
  const n = claim.z === 0 ? [nx, ny] : turn(pose, [nx, ny]);
  const shift = claim.z === 0 ? turn(pose, p) : p;
  const offset = h + n[0] * shift[0] + n[1] * shift[1];
  return claim.sign > 0 ? { n, offset } : { n: [-n[0], -n[1]], offset: -offset };
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
function claimName(claim, pair) {
  if (claim.kind === "side") {
    return featureName(pair[claim.line.z], claim.line.feature) + " + " +
      featureName(pair[claim.point.z], claim.point.feature);
  }
  if (claim.kind === "ray") {
    return claim.points.slice(2).map(p => featureName(pair[p.z], p.feature)).join(" + ");
  }
  if (claim.kind === "order") {
    return claim.lines.map(line => featureName(pair[line.z], line.feature)).join(" \u2226 ");
  }
  return listOf(claim.ids.slice(0, 2));
}

// The proof is one that two bodies overlap: the edge of the sum ahead, the rays through its ends.
const areOverlap = claims => claims.some(claim => claim.kind === "ray");

// The proofs of one structure in one run.
class Proofs {
  constructor(run, index) {
    this.run = run;
    this.name = DATA.structures[index].name;
    this.pairs = new Map();
    for (const [a, b, proofs] of run.proofs ? run.proofs[index] : []) {
      this.pairs.set(pairCode(a, b), proofs);
    }
    this.failures = new Map();  // numbers of events with a certificate
    this.contacts = new Map();
    this.events = [];
    run.u.forEach((_, e) => {
      if (run.s[e] !== index) return;
      const k = e + run.before + 1, pair = pairOfEvent(run, e);
      if (run.certificates[e] !== 0) this.events.push(k);
      if (pair === null) return;
      const note = map => {
        if (!map.has(pair)) map.set(pair, []);
        map.get(pair).push(k);
      };
      if (run.certificates[e] !== 0) note(this.failures);
      if (kindOf(run, k) === "contact") note(this.contacts);
    });
  }

  // [event, claims, tile] in force after event k, or null.
  entry(pair, k) {
    const list = this.pairs.get(pair);
    const place = list ? placeUntil(list, k, proof => proof[0]) : -1;
    return place < 0 ? null : list[place];
  }
  claims(pair, k) {
    const entry = this.entry(pair, k);
    return entry === null ? [] : entry[1].map(c => claimOf(this.run, c));
  }
  // The next event of the pair that a certificate causes, or null.
  nextFailure(pair, k) {
    const list = this.failures.get(pair) || [];
    const place = placeUntil(list, k) + 1;
    return place < list.length ? list[place] : null;
  }
  // The slot of the certificate that fails next, -1: none of these.
  failingSlot(pair, k) {
    const next = this.nextFailure(pair, k), entry = this.entry(pair, k);
    if (next === null || entry === null) return -1;
    const [predicate, ids] = this.run.certificates[at(this.run, next)];
    return entry[1].findIndex(c => this.run.claims[c][0] === predicate &&
                                   this.run.claims[c][1].join() === ids.join());
  }
  // The contact that the pair is in after event k: {event, features}, or null.
  contact(pair, k, replay) {
    if (!replay.edges || !replay.edges.has(pair)) return null;
    const list = this.contacts.get(pair) || [];
    const place = placeUntil(list, k);
    if (place < 0) return { event: null, features: [0, 0] };
    const ids = this.run.ids[at(this.run, list[place])];
    return { event: list[place], features: [0, 1].map(z => {
      const mark = nameOf(ids[2 + z]).slice(nameOf(ids[z]).length + 1);
      const number = +mark.slice(1);
      return [mark[0] === "v" ? "vertex" : "edge", number, number];
    }) };
  }
  // The pair of features that the certificates are about: the closest ones, or null.
  features(claims) {
    if (areOverlap(claims)) return null;
    const own = claims.filter(claim => claim.kind !== "volume");
    if (!/^(closest_features|separation_hysteresis|bounding_volumes)$/.test(this.name)) return null;
    const both = (p, q) => (p.z === 0 ? [p.feature, q.feature] : [q.feature, p.feature]);
    if (own.length === 5) return both(own[4].line, own[4].point);
    return own.length === 4 ? both(own[0].point, own[2].point) : null;
  }
  // The two inner tangents: pairs of vertices.
  tangents(claims) {
    if (this.name !== "inner_tangents" || claims.length !== 8) return null;
    return [0, 4].map(k => [claims[k + 2].point.feature, claims[k].point.feature]);
  }
  // What the proof is, in words.
  describe(pair, k, replay) {
    const entry = this.entry(pair, k), [a, b] = pairOf(pair).map(nameOf);
    const claims = this.claims(pair, k);
    if (this.contact(pair, k, replay) !== null) {
      return areOverlap(claims) ? "they overlap; ahead is " + claimName(claims[0], pairOf(pair))
                                : "they overlap, without a proof";
    }
    if (claims.length === 0) return "far apart: other cells of the grid";
    if (claims.every(claim => claim.kind === "volume")) {
      return claims[0].name.startsWith("discs") ? "discs about the bodies are apart"
                                                : "boxes about the bodies are apart";
    }
    const found = this.features(claims);
    if (found) return pairOf(pair).map((body, z) => featureName(body, found[z])).join(" \u2013 ");
    if (this.name === "inner_tangents") return "two inner tangents";
    if (this.name === "separation_hysteresis") return claims.length > 1 ? "a wedge" : "a line";
    const [kind, x, v, other] = entry[2] || ["tile", 0, 0, 0];
    if (this.name === "separation_minkowski") {
      return kind === "half" ? "half-plane beyond edge " + v + " of the sum's box"
                             : "triangle of node " + v + " of the sum";
    }
    const [own, foreign] = x === 0 ? [a, b] : [b, a];
    if (kind === "triangle") {
      return "triangle: node " + v + " of " + own + " is cut, at node " + other + " of " + foreign;
    }
    if (kind === "half") {
      return "half-plane: beyond edge " + v + " of " + own + "'s box, at corner " + other + " of " +
        foreign + "'s";
    }
    return "parallelogram: edge " + other + " of " + foreign + " along the " + kind +
      " side of node " + v + " of " + own;
  }
}
