// SPDX-License-Identifier: GPL-3.0-or-later
// ClaimForm: the claim "predicate(arguments) >= 0" as data: the role of every argument, the figure
// that shows the claim, and a sentence. Viewers, logs and audits use it, so they need no list of
// predicates.
#ifndef KINEX_CORE_ARITHMETIC_CLAIM_FORM_H
#define KINEX_CORE_ARITHMETIC_CLAIM_FORM_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/numbers/integer.h"

namespace kinex {

// The kind of one argument, and its role in the claim.
struct ArgumentRole {
  enum class Kind : std::uint8_t {
    kPoint,       // a moving point of the scene
    kBody,        // a body of the scene, by the origin of its frame
    kPose,        // the second of two bodies as seen from the first
    kFrameLine,   // a line in the frame of a body
    kFramePoint,  // a point in the frame of a body
    kNumber,      // a constant length or coordinate
  };
  std::string_view name;  // distinct within a predicate
  Kind kind = Kind::kPoint;
  // kFrameLine, kFramePoint: 0 for the frame of the first body, 1 for the negated frame of the
  // second.
  std::uint8_t frame = 0;
};

// How a claim is drawn. A figure has a fixed number of places for points. The arguments take them
// in the order of the roles, or in that of ClaimForm::places.
enum class ClaimFigure : std::uint8_t {
  kNone,
  kOrder,       // two points in order along a direction, or by a key
  kNearer,      // two points in the order of their distances from a third
  kLengths,     // two pairs of points in the order of their distances
  kTurn,        // three points that turn left; in space a plane through three, and a fourth beside it
  kDirections,  // two pairs of points: the turn from one direction to the other
  kCircle,      // a circle through three points, and a fourth; in space a sphere, and a fifth
  kHalfPlane,   // a pose, a line of one body, a point of the other: the line moved by the point
  kAlong,       // a pose, a line, two points: the place along the line
  kRay,         // a pose, two points of each body: the ray from one sum to the other
  kNormals,     // a pose, a line of each body: the order of their normals
  kDiscs,       // two bodies and the sum of two radii
  kGap,         // two bodies and a length: a gap along a direction
  kBeyond,      // a body and a coordinate along a direction
  kAngle,       // two pairs of points: the angle between the directions from one to the other
  kExtents,     // two pairs of points in the order of their extents, each along a direction
  kStrips,      // two strips in the order of their widths: three points each, two on one side
  kRectangles,  // two rectangles, by area or perimeter: two points on one side, one on each other
};

struct ClaimForm {
  ClaimFigure figure = ClaimFigure::kNone;
  // -1: the claim is that of the figure negated ("inside" for "outside").
  int sign = 1;
  std::span<const ArgumentRole> roles;  // one for each argument; it lives as long as the predicate
  // The claim in words: "{0}" stands for the first argument, and so on.
  std::string_view says;
  // kOrder, kGap, kBeyond: along this vector, one entry an axis; empty: by a key.
  std::vector<Integer> direction;
  // The argument at each place of the figure, where one argument takes several; empty: each takes
  // its own. It lives as long as the predicate.
  std::span<const std::uint8_t> places = {};
};

}  // namespace kinex

#endif
