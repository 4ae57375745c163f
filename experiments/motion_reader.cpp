// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>

#include "experiments/input_error.h"
#include "experiments/scene_parts.h"
#include "experiments/scene_reader.h"

namespace kinex {

namespace {

// Bits of the numbers that the check of one seam may need; real scenes stay far below.
constexpr std::size_t kMaxSeamBits = std::size_t{1} << 22;

constexpr const char* kMotionRemedy =
    "write one coefficient list per axis, [[x0, x1, ..], [y0, y1, ..]], or a list of pieces";

Trajectory read_coordinates(const JsonNode& node, int dimension) {
  node.require_array();
  if (node.size() != static_cast<std::size_t>(dimension)) {
    node.fail(std::to_string(node.size()) + " coefficient lists in a scene of dimension " +
                  std::to_string(dimension),
              "write one list per axis");
  }
  Trajectory trajectory;
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    const JsonNode list = node.at(axis);
    list.require_array();
    if (list.size() == 0)
      list.fail("an empty coefficient list", "write [0] for a coordinate that is 0");
    if (list.size() > kMaxMotionDegree + 1) {
      list.fail("a motion of degree " + std::to_string(list.size() - 1),
                "the largest degree is " + std::to_string(kMaxMotionDegree));
    }
    std::vector<Rational>& coefficients = trajectory.coordinates.emplace_back();
    for (std::size_t k = 0; k < list.size(); ++k) coefficients.push_back(list.at(k).rational());
  }
  trajectory.normalise();
  return trajectory;
}

MotionPiece read_piece(const JsonNode& node, int dimension, bool first, bool last) {
  node.require_object({"from", "to", "coordinates"});
  MotionPiece piece;
  if (const auto from = node.find("from")) {
    piece.from = from->rational();
  } else if (!first) {
    node.fail("\"from\" is missing", "only the first piece may begin with the scene");
  }
  if (const auto to = node.find("to")) {
    piece.to = to->rational();
    if (piece.from && *piece.to <= *piece.from) {
      to->fail("the piece ends at " + shown(to->value()) + ", not after its \"from\"",
               "write \"to\" greater than \"from\"");
    }
  } else if (!last) {
    node.fail("\"to\" is missing", "only the last piece may go on for ever");
  }
  piece.trajectory = read_coordinates(node.member("coordinates"), dimension);
  return piece;
}

void check_seam(const MotionPiece& before, const MotionPiece& after, const JsonNode& node,
                bool jumps) {
  const Rational& seam = *after.from;
  if (seam < *before.to) {
    node.member("from").fail("the piece begins at " + show_text(seam.to_string()) +
                                 ", before the end of the piece before it at " +
                                 show_text(before.to->to_string()),
                             "pieces ascend in time and do not overlap");
  }
  if (jumps || seam != *before.to) return;
  const auto degree =
      static_cast<std::size_t>(std::max(before.trajectory.degree(), after.trajectory.degree()));
  const std::size_t bits = seam.numerator().bit_length() + seam.denominator().bit_length();
  if (degree * bits > kMaxSeamBits) {
    node.fail("whether the pieces meet takes numbers of " + std::to_string(degree * bits) + " bits",
              "write a shorter time or a smaller degree");
  }
  for (int axis = 0; axis < after.trajectory.dimension(); ++axis) {
    const Rational there = before.trajectory.position(axis, seam);
    const Rational here = after.trajectory.position(axis, seam);
    if (there == here) continue;
    node.fail("the object jumps at " + show_text(seam.to_string()) + " from " +
                  show_text(there.to_string()) + " to " + show_text(here.to_string()) +
                  " on axis " + std::to_string(axis),
              "make the pieces meet, or say \"jumps\": true in the scene");
  }
}

}  // namespace

Motion read_motion(const JsonNode& node, int dimension, bool jumps) {
  if (!node.is(JsonValue::Kind::kArray)) node.refuse("a motion", kMotionRemedy);
  if (node.size() == 0) node.fail("an empty motion", kMotionRemedy);
  Motion motion;
  if (!node.at(0).is(JsonValue::Kind::kObject)) {
    motion.pieces.push_back({std::nullopt, std::nullopt, read_coordinates(node, dimension)});
    return motion;
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode entry = node.at(i);
    MotionPiece piece = read_piece(entry, dimension, i == 0, i + 1 == node.size());
    if (i > 0) check_seam(motion.pieces.back(), piece, entry, jumps);
    motion.pieces.push_back(std::move(piece));
  }
  return motion;
}

bool lives_throughout(const Motion& motion, const Scene& scene) {
  const MotionPiece& first = motion.pieces.front();
  const MotionPiece& last = motion.pieces.back();
  if (first.from && *first.from > scene.start) return false;
  if (last.to && (!scene.end || *last.to < *scene.end)) return false;
  for (std::size_t i = 1; i < motion.pieces.size(); ++i) {
    if (*motion.pieces[i].from != *motion.pieces[i - 1].to) return false;
  }
  return true;
}

}  // namespace kinex
