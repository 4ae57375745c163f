// Walls of a grid: derived objects that stand still, as "x=3/4", and claims about them in a picture of the plane or of space.

// { axis, value } in drawn units; null: it is no wall, or of an axis that is not drawn.
function wallOf(id) {
  const found = id < OBJECTS ? null : /^([xyz])=(-?[0-9]+)(?:\/([0-9]+))?$/.exec(nameOf(id));
  if (found === null || !(DATA.scale > 0)) return null;
  const axis = "xyz".indexOf(found[1]), value = Number(found[2]) / Number(found[3] || 1) / DATA.scale;
  return DRAWN.includes(axis) && isFinite(value) ? { axis, value } : null;
}

// Across the picture; in space the border of the wall's part in the box that is shown.
function wallShapes(plane, { axis, value }) {
  if (plane.camera !== null) {
    const box = [...plane.box];
    box[2 * axis] = box[2 * axis + 1] = value;
    const corners = cornersOf(box).map(p => plane.seenAt(p));
    return BOX_EDGES.filter(([i, , along]) => along !== axis && !(i >> axis & 1))
      .map(([i, j]) => ({ from: corners[i], to: corners[j], wall: true }));
  }
  const [left, top, width, height] = plane.rectangle, [x, y] = plane.onScreen(value, value);
  return [axis === 0 ? { from: [x, top], to: [x, top + height], wall: true }
                     : { from: [left, y], to: [left + width, y], wall: true }];
}
// Where a wall is named: near the top of the picture, or near its right side.
function wallNameAt(plane, { axis, value }) {
  if (plane.camera !== null) return wallShapes(plane, { axis, value })[0].from;
  const [left, top, width] = plane.rectangle, [x, y] = plane.onScreen(value, value);
  return axis === 0 ? [x, top + 24] : [left + width - 60, y];
}
// A claim about objects and walls: the walls, and a ring around each object.
function claimOfWalls(plane, ids) {
  return ids.flatMap(id => (id < OBJECTS ? [{ dot: plane.at(id) }] : wallShapes(plane, wallOf(id))));
}
