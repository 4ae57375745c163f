// Where the objects are, in doubles: for drawing only.
const MOTIONS = DATA.motions;
const AXES = DATA.scene.dimension;
const DRAWN = AXES > 2 ? [0, 1, 2] : [0, 1];  // axes of the picture

function evaluate(c, u) {
  let value = 0;
  for (let i = c.length - 1; i >= 0; --i) value = value * u + c[i];
  return value;
}

const cursor = new Int32Array(OBJECTS);  // the piece that was looked at last
// The piece in force right after u, or null; at the very end the one that ends there.
function pieceAt(object, u) {
  const pieces = MOTIONS[object];
  const holds = p => (p[0] === null || p[0] <= u) && (p[1] === null || u < p[1]);
  const guess = pieces[cursor[object]];
  if (guess && holds(guess)) return guess;
  for (let i = 0; i < pieces.length; ++i) {
    if (!holds(pieces[i])) continue;
    cursor[object] = i;
    return pieces[i];
  }
  const last = pieces[pieces.length - 1];
  return last && u >= 1 && last[1] !== null && last[1] >= u ? last : null;
}

// By object: 1 for a line y = a x + b, whose axes are (a, b).
const IS_LINE = new Uint8Array(OBJECTS);
(DATA.scene.lines || []).forEach(object => { IS_LINE[object] = 1; });

// Positions of all objects at one time.
const X = [0, 1, 2].map(() => new Float64Array(OBJECTS));
// The axes behind those of a position: one for the radius of a disc, one per axis for a box.
const EXTENT_AXES = DATA.polygons !== undefined ? 0
    : (MOTIONS.find(pieces => pieces.length > 0) || [[0, 0, []]])[0][2].length - AXES;
// That axis is the weight of a point, not a radius.
const WEIGHTED = DATA.scene.weights === true;
// Half the widths of discs and boxes along the axes that are drawn, at that time.
const HALF = EXTENT_AXES > 0 && !WEIGHTED ? DRAWN.map(() => new Float64Array(OBJECTS)) : [];
// Weights, of discs the squares of the radii, in squares of the unit of positions; at that time.
const WEIGHT = new Float64Array(OBJECTS);
const alive = new Uint8Array(OBJECTS);
let placedAt = NaN;
function place(u) {
  if (u === placedAt) return;
  placedAt = u;
  for (let object = 0; object < OBJECTS; ++object) {
    const piece = pieceAt(object, u);
    alive[object] = piece === null ? 0 : 1;
    if (piece === null) continue;
    for (let axis = 0; axis < AXES; ++axis) X[axis][object] = evaluate(piece[2][axis], u);
    HALF.forEach((half, axis) => {
      half[object] = evaluate(piece[2][AXES + Math.min(axis, EXTENT_AXES - 1)], u);
    });
    if (WEIGHTED) WEIGHT[object] = evaluate(piece[2][AXES], u) / DATA.scale;
    else if (EXTENT_AXES === 1) WEIGHT[object] = HALF[0][object] ** 2;
  }
}

// The key of a structure: of a piece at u.
function pieceKey(key, piece, u) {
  if (key.axis !== undefined) return evaluate(piece[2][key.axis], u);
  let sum = 0;
  if (key.weights) {
    key.weights.forEach((w, axis) => { sum += w * evaluate(piece[2][axis], u); });
    return sum;
  }
  const centre = pieceAt(key.object, u);
  if (centre === null) return NaN;
  for (let axis = 0; axis < AXES; ++axis) {
    const d = evaluate(piece[2][axis], u) - evaluate(centre[2][axis], u);
    sum += d * d;
  }
  return sum;
}
function keyAt(key, object, u) {
  const piece = pieceAt(object, u);
  return piece === null ? NaN : pieceKey(key, piece, u);
}
// The degree of the key in u.
function keyDegree(key, piece) {
  const degree = Math.max(...piece[2].map(c => c.length)) - 1;
  return key.object === undefined ? degree : 2 * Math.max(1, degree);
}
// What a drawn key value is to be multiplied with.
const keyScale = key => key.object !== undefined ? DATA.scale * DATA.scale
                      : DATA.scale * (key.weights ? key.size : 1);
// For an axis.
function keyName(key) {
  if (key.axis !== undefined) return "xyz"[key.axis] || "coordinate " + (key.axis + 1);
  return key.object !== undefined ? "squared distance to " + nameOf(key.object) : "key " + key.text;
}
const memberOf = (key, object) => key.object === undefined || key.object !== object;
