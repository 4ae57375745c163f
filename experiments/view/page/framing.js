// The box of coordinates that a picture of the plane or of space shows: [least, largest] of each axis in a row.
const emptyBox = () => DRAWN.flatMap(() => [Infinity, -Infinity]);
const lengthOf = (box, axis) => box[2 * axis + 1] - box[2 * axis];
const sizeOfBox = box => Math.max(...DRAWN.map(axis => lengthOf(box, axis)));
function joinTo(box, point) {
  point.forEach((x, axis) => {
    box[2 * axis] = Math.min(box[2 * axis], x);
    box[2 * axis + 1] = Math.max(box[2 * axis + 1], x);
  });
}
const linesThere = () => [...alive.keys()].filter(object => alive[object] && IS_LINE[object]);
const heightOf = (line, x) => X[0][line] * x + X[1][line];
function crossingOf(l, m) {
  const x = (X[1][m] - X[1][l]) / (X[0][l] - X[0][m]);
  return isFinite(x) ? [x, heightOf(l, x)] : null;
}

function growByPoints(box) {
  for (let object = 0; object < OBJECTS; ++object) {
    if (!alive[object] || IS_LINE[object]) continue;
    for (const axis of DRAWN) {
      const half = HALF.length > 0 ? HALF[axis][object] : 0;
      box[2 * axis] = Math.min(box[2 * axis], X[axis][object] - half);
      box[2 * axis + 1] = Math.max(box[2 * axis + 1], X[axis][object] + half);
    }
  }
}

// ---- scenes with lines
const MOST_LINES = 60;  // of whose pairs the crossings are looked at
// Where the lines cross now, and where they are above or below the points.
function placesOfLines(crossings, feet) {
  const lines = linesThere().slice(0, MOST_LINES);
  lines.forEach((l, i) => lines.slice(0, i).forEach(m => {
    const crossing = crossingOf(l, m);
    if (crossing !== null) crossings.push(crossing);
  }));
  for (let point = 0; point < Math.min(OBJECTS, 400); ++point) {
    if (!alive[point] || IS_LINE[point]) continue;
    for (const line of lines) feet.push([X[0][point], heightOf(line, X[0][point])]);
  }
}
// The middle half of the numbers, and with it those that are not far from it: [least, largest].
function halfOf(sorted) {
  const last = sorted.length - 1;
  return [sorted[Math.floor(last / 4)], sorted[Math.ceil(last * 3 / 4)]];
}
function mostOf(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b), [low, high] = halfOf(sorted);
  const near = sorted.filter(x => x >= low - 0.8 * (high - low) && x <= high + 0.8 * (high - low));
  return [near[0], near[near.length - 1]];
}
// A length on an axis where nothing else gives one.
const lengthAbout = x => Math.max(Math.abs(x) / 2, DATA.scale > 1e-300 ? 1 / DATA.scale : 1);
// All points, most crossings, and half of the places of lines above and below points: crossings that are much farther away than the
// points reach are left out.
function boxOfLines(points, crossings, feet) {
  const box = [...points], hasPoints = points[0] <= points[1];
  const most = list => [0, 1].flatMap(axis => mostOf(list.map(place => place[axis])));
  if (hasPoints && feet.length > 0) {
    const [low, high] = halfOf(feet.map(([, y]) => y).sort((a, b) => a - b));
    box[2] = Math.min(box[2], low);
    box[3] = Math.max(box[3], high);
  }
  if (crossings.length > 0) {
    const own = most(crossings), size = hasPoints ? sizeOfBox(box) : Infinity;
    own.forEach((x, i) => {
      if (i % 2 === 0) box[i] = Math.min(box[i], hasPoints ? Math.max(x, box[i] - size) : x);
      else box[i] = Math.max(box[i], hasPoints ? Math.min(x, box[i] + size) : x);
    });
  }
  if (!(box[0] <= box[1])) box[0] = box[1] = 0;
  if (!(box[2] <= box[3])) [box[2], box[3]] = mostOf([0, ...linesThere().map(line => X[1][line])]);
  for (const axis of [0, 1]) {
    if (box[2 * axis + 1] - box[2 * axis] > 1e-9 * Math.abs(box[2 * axis])) continue;
    const other = box[3 - 2 * axis] - box[2 - 2 * axis];
    const half = (other > 0 ? other : lengthAbout(box[2 * axis])) / 2;
    box[2 * axis] -= half;
    box[2 * axis + 1] += half;
  }
  return box;
}
// Higher, so that these lines are in sight, but at most so many times as high.
function growByLines(box, lines, most) {
  const [x0, x1, y0, y1] = box, room = (most - 1) / 2 * (y1 - y0), inside = 0.04 * (y1 - y0);
  for (const line of lines) {
    const ends = [heightOf(line, x0), heightOf(line, x1)], low = Math.min(...ends), high = Math.max(...ends);
    if (low > y1 - inside && low <= y1 + room) box[3] = Math.max(box[3], low + inside);
    if (high < y0 + inside && high >= y0 - room) box[2] = Math.min(box[2], high - inside);
  }
}
// So that the crossings of these lines are in sight, but at most so many times as large.
function growByCrossings(box, lines, most) {
  const [x0, x1, y0, y1] = box, wide = (most - 1) / 2 * (x1 - x0), high = (most - 1) / 2 * (y1 - y0);
  lines.forEach((l, i) => lines.slice(0, i).forEach(m => {
    const crossing = crossingOf(l, m);
    if (crossing === null) return;
    const [x, y] = crossing;
    if (x >= x0 - wide && x <= x1 + wide && y >= y0 - high && y <= y1 + high) joinTo(box, crossing);
  }));
}

// ---- structures that draw more around a pair than the pair: by role the centre of that, and how far it reaches on every axis.
const AROUND_PAIRS = {
  diameter: (p, q) => [p.map((x, axis) => (x + q[axis]) / 2), Math.hypot(...minus(q, p)) / 2],
  square: (p, q) => [p, Math.max(...minus(q, p).map(Math.abs))],
};
function growByPair(box, role, pair, u) {
  const pieces = pair.map(object => pieceAt(object, u));
  if (pair.length < 2 || pieces.includes(null)) return;
  const [centre, half] = AROUND_PAIRS[role](...pieces.map(piece => DRAWN.map(axis => evaluate(piece[2][axis], u))));
  for (const side of [-half, half]) joinTo(box, centre.map(x => x + side));
}
// In the whole run: of each pair at the ends and within the time for which it is the value.
const BOXES_OF_PAIRS = new Map();
function boxOfPairs(index) {
  const { role } = DATA.structures[index];
  if (BOXES_OF_PAIRS.has(index)) return BOXES_OF_PAIRS.get(index);
  const box = emptyBox(), spans = AROUND_PAIRS[role] === undefined ? [] : spansOf(FIRST, index, 0, 1);
  for (const [pair, from, to] of spans) {
    for (let i = 0; i <= 4; ++i) growByPair(box, role, pair, from + (i < 4 ? i / 4 : 1 - 1e-9) * (to - from));
  }
  BOXES_OF_PAIRS.set(index, box);
  return box;
}

// The box of the whole run.
const WHOLE_RUN = (() => {
  const box = emptyBox(), crossings = [], feet = [], steps = 16;
  for (let i = 0; i <= steps; ++i) {
    place(i / steps);
    growByPoints(box);
    if (IS_LINE.includes(1)) placesOfLines(crossings, feet);
  }
  return IS_LINE.includes(1) ? boxOfLines(box, crossings, feet) : box;
})();
// The box of what is there now; with lines of an eighth of the run around now, as many may meet in one place.
function boxOfNow() {
  const box = emptyBox(), crossings = [], feet = [], now = placedAt;
  growByPoints(box);
  if (!IS_LINE.includes(1)) return box;
  for (let i = -2; i <= 2; ++i) {
    place(Math.max(0, Math.min(1, now + i / 32)));
    growByPoints(box);
    placesOfLines(crossings, feet);
  }
  place(now);
  return boxOfLines(box, crossings, feet);
}
// So that a box around one place has a size.
function growToSize(box) {
  if (sizeOfBox(box) !== 0) return;
  for (const axis of DRAWN) {
    const half = lengthAbout(box[2 * axis]) / 2;
    box[2 * axis] -= half;
    box[2 * axis + 1] += half;
  }
}
// That of the whole run if it is not much larger than what is there now, or if that is in one place; else one that slides with the
// points; with lines those of the last log record and their crossings, too; with pairs what the structure draws around them.
function boxToShow(marked, index, replay) {
  const now = boxOfNow(), lines = IS_LINE.includes(1);
  const larger = lines ? Math.max(...DRAWN.map(axis => lengthOf(WHOLE_RUN, axis) / lengthOf(now, axis))) / 10
                       : sizeOfBox(WHOLE_RUN) / (1.8 * sizeOfBox(now));
  const isPlace = !(sizeOfBox(now) > 1e-9 * sizeOfBox(WHOLE_RUN));
  const isWhole = larger <= 1 || isPlace, box = isWhole ? [...WHOLE_RUN] : now;
  const { role } = DATA.structures[index];
  if (AROUND_PAIRS[role] !== undefined && !replay.lost) {
    if (isWhole) [0, 1].forEach(end => joinTo(box, DRAWN.map(axis => boxOfPairs(index)[2 * axis + end])));
    else growByPair(box, role, replay.row, placedAt);
  }
  growToSize(box);
  if (!lines) return box;
  const shown = marked.filter(object => alive[object] && IS_LINE[object]);
  growByLines(box, linesThere(), 2);
  growByLines(box, shown, 6);
  growByCrossings(box, shown, 6);
  return box;
}
