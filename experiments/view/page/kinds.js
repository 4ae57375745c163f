// What kinds of events mean. A word may mean different things for different shapes of the attribute.
const KIND_TEXT = {
  swap: "two objects that the proof compares change places",
  tie: "two keys are equal at this instant; what they prove is settled anew",
  replace: "another object becomes the value",
  turn: "a hull vertex and its neighbours are on one line: the hull turns there",
  reflex: "a chain bends the other way",
  outside: "a point crosses the line of a hull edge",
  inside: "the proof that a point or body is inside goes to another edge",
  between: "two points on one line change places",
  enter: "an object joins the hull",
  leave: "an object leaves the hull",
  flip: "an edge of two triangles gives way to the other diagonal: four points are on one circle",
  pass: "on a line two neighbours change places",
  blocked: "at a degenerate instant no repair is possible yet",
  reinsert: "a point is taken out and put in again, when the instant is settled",
  x: "the x order of two neighbouring corners of two colours changes",
  yl: "a corner meets the chain of the other colour, which it crosses on its left",
  yr: "a corner meets the chain of the other colour, which it crosses on its right",
  yb: "a corner meets the chain of the other colour, which it crosses on both sides",
  yt: "a corner meets the chain of the other colour, without a crossing beside it",
  sl: "the slope of a line passes that of another, on the left",
  sr: "the slope of a line passes that of another, on the right",
  st: "the slope of a line passes that of another, at a tangent",
  end: "a chain's end changes",
  contact: "two bodies touch and begin to overlap",
  graze: "two bodies touch without overlapping",
  separation: "two bodies cease to overlap",
  overlap: "two bodies overlap when one of them appears",
  volume: "the proof by enclosing volumes changes",
  grid: "a body changes its cell of the grid",
  side: "the proof goes to a neighbouring tile, across a side",
  cell: "the proof goes to another cell",
  change: "the features that prove the distance change",
  wedge: "the proof goes to another wedge",
  motion: "flight plans change: certificates are computed anew",
  insert: "an object appears",
  erase: "an object disappears",
  settled: "the instant is settled: its changes are reported together",
  rebuild: "the whole proof is built anew",
};
const KIND_TEXT_OF_PAIRS = { flip: "the tile that proves the distance is exchanged with its neighbour" };
const EXTERNAL_TEXT = "external: the attribute changes";
const INTERNAL_TEXT = "internal: only its proof changes";

function kindText(structure, kind) {
  const own = DATA.structures[structure].shape === "tuples" && !BODIES ? KIND_TEXT
    : { ...KIND_TEXT, ...KIND_TEXT_OF_PAIRS };
  return own[kind] || "";
}
// Of a log record, for its title.
function explain(run, k) {
  const e = at(run, k), kind = kindOf(run, k), text = kindText(run.s[e], kind);
  return kind + (text === "" ? "" : ": " + text) + " (" + (run.x[e] === 1 ? EXTERNAL_TEXT : INTERNAL_TEXT) + ")";
}
