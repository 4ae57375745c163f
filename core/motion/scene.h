// SPDX-License-Identifier: GPL-3.0-or-later
// Scene: the objects, their motions, and the structures to be maintained.
#ifndef KINEX_CORE_MOTION_SCENE_H
#define KINEX_CORE_MOTION_SCENE_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/motion.h"

namespace kinex {

// Objects are numbered in the scene's order; ties are resolved by this number.
using ObjectId = std::uint32_t;
inline constexpr ObjectId kNoObject = 0xffffffffu;  // none

// A vertex of a polygon in the frame of the body that carries it.
using Vertex2 = std::array<Rational, 2>;

// A point, with a weight or without, a line of the plane, a disc (a ball, in one dimension an
// interval), a box with sides along the axes, or a rigid body: a convex polygon, vertices
// counter-clockwise. The motion of the line y = a x + b has the axes (a, b), that of a point with a
// weight has the weight as last axis, that of a disc its radius, that of a box its half
// extents, that of a body kBodyAxes axes.
struct SceneObject {
  std::string id;
  Motion motion;
  std::vector<Vertex2> polygon = {};  // empty: a point
  std::string colour = {};            // of a point; empty: none
  // An edge of a graph: its two vertices, which differ; its coordinate is its weight. Empty: none.
  std::vector<std::string> ends = {};
  bool line = false;  // the line y = a x + b; only in scenes of two axes
};

// The value by which a one-dimensional structure orders objects.
struct Key {
  enum class Kind { kCoordinate, kDirection, kSquaredDistance };
  Kind kind = Kind::kCoordinate;
  int axis = 0;                     // kCoordinate
  std::vector<Rational> direction;  // kDirection: one entry per axis
  ObjectId object = kNoObject;      // kSquaredDistance: distance to this object
  friend bool operator==(const Key&, const Key&) = default;
};

// A value that a request gives to a parameter of its structure.
struct Parameter {
  std::string name;
  Rational value;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

// Objects of a scene.
struct Subset {
  enum class Kind { kAll, kObjects, kAllBut, kColours };
  Kind kind = Kind::kAll;
  std::vector<ObjectId> objects = {};     // kObjects, kAllBut: ascending
  std::vector<std::string> colours = {};  // kColours
  friend bool operator==(const Subset&, const Subset&) = default;
};

// One entry of "maintain".
struct Request {
  std::string structure;  // registered name, for example "delaunay_2"
  std::string label;      // names it in summaries and logs; default: the structure's name
  Key key;
  std::vector<Request> over = {};          // what it reads, if not the default; at most one
  std::vector<Parameter> parameters = {};  // those that do not have their default values
  Subset of = {};                          // the objects that it is built from
  ObjectId query = kNoObject;              // of a structure with a query; none: the first object
  std::vector<std::string> colours = {};   // of a structure of two colours: both, or none
};

// "Which points are in this closed box right after `at`?"
struct BoxQuery {
  Rational at;
  std::vector<std::array<Rational, 2>> box;  // per axis: least and largest coordinate
};

// The treatment of two bodies that overlap right after one of them first exists: at the scene's
// start, when it appears, or when it jumps.
enum class OverlappingStarts {
  kRefused,  // as an error
  kContact,  // they begin in contact
};

// What the objects have beside their positions: axes of their motions behind those of the position,
// as many as Scene::extent_axes says. Radii and half extents are never negative while the object
// exists.
enum class Extents {
  kNone,         // points, or bodies
  kRadius,       // closed discs: one axis
  kHalfExtents,  // closed boxes: half the width along each axis
  kWeight,       // points with weights: one axis, of either sign
};

struct Scene {
  std::string name;
  int dimension = 1;
  Extents extents = Extents::kNone;  // of all objects
  Rational start;
  std::optional<Rational> end;  // nullopt: none; a run ends when no event is left
  bool jumps = false;           // pieces need not be continuous
  OverlappingStarts overlapping_starts = OverlappingStarts::kRefused;
  std::vector<SceneObject> objects;
  std::vector<Request> maintain;
  std::vector<BoxQuery> queries;

  // Largest degree of any motion.
  int degree() const;
  // The same but for the weights of points, which only some structures read.
  int degree_without_weights() const;
  // True if the objects are rigid bodies; either all are or none.
  bool has_bodies() const { return !objects.empty() && !objects.front().polygon.empty(); }
  // Coordinates of a motion: kBodyAxes, or those of the position and of the extents.
  int axes() const { return has_bodies() ? kBodyAxes : dimension + extent_axes(); }
  int axes_without_weights() const { return extents == Extents::kWeight ? dimension : axes(); }
  int extent_axes() const {
    if (extents == Extents::kNone) return 0;
    return extents == Extents::kHalfExtents ? dimension : 1;
  }
  // True if an object is a line; the others are points.
  bool has_lines() const;
  // By object: true for those of the subset. Empty: all of them.
  std::vector<bool> members(const Subset& subset) const;
};

}  // namespace kinex

#endif
