// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/short_rational.h"
#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"

namespace kinex::formats {

namespace {

// Bits of the numbers that the check of one seam may need; real scenes stay far below.
constexpr std::size_t kMaxSeamBits = std::size_t{1} << 22;

constexpr std::string_view kMotion = "motion";
constexpr const char* kMotionRemedy =
    "write one coefficient list per axis, [[x0, x1, ..], [y0, y1, ..]], or a list of pieces";

}  // namespace

std::vector<Rational> read_coefficients(const JsonNode& list, int max_degree,
                                        std::string_view what) {
  if (list.is(JsonValue::Kind::kNumber)) {
    const std::string number = shown(list.value());
    list.refuse("an array", what == kMotion
                                ? kMotionRemedy
                                : "write the coefficient list [" + number + "], low degree first");
  }
  list.require_array();
  if (list.size() == 0)
    list.fail("an empty coefficient list", what == kMotion ? "write [0] for a coordinate that is 0"
                                                           : "write [0] for a part that is 0");
  if (list.size() > static_cast<std::size_t>(max_degree) + 1) {
    list.fail("a " + std::string(what) + " of degree " + std::to_string(list.size() - 1),
              "the largest degree is " + std::to_string(max_degree));
  }
  std::vector<Rational> coefficients(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) list.at(k).read(coefficients[k]);
  return coefficients;
}

namespace {

// Fills `trajectory`, which must be empty. `axes`: how many there will be.
void read_coordinates(const JsonNode& node, int dimension, std::size_t axes, Trajectory& trajectory) {
  node.require_array();
  if (node.size() != static_cast<std::size_t>(dimension)) {
    node.fail(counted(node.size(), "coefficient list", "coefficient lists") +
                  " in a scene of dimension " + std::to_string(dimension),
              "write one list per axis");
  }
  trajectory.coordinates.reserve(axes);
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    trajectory.coordinates.push_back(read_coefficients(node.at(axis), kMaxMotionDegree, kMotion));
  }
  trajectory.normalise();
}

std::size_t scene_axes(const Scene& scene, bool body) {
  return static_cast<std::size_t>(body ? kBodyAxes : scene.dimension + scene.extent_axes());
}

// Appends the rotor of `owner`, an object or a piece, to its trajectory.
void add_rotor(const JsonNode& owner, MotionPiece& piece, const Scene& scene) {
  const std::optional<JsonNode> node = owner.find("rotor");
  for (std::vector<Rational>& part : read_rotor(node)) {
    piece.trajectory.coordinates.push_back(std::move(part));
  }
  piece.trajectory.normalise();
  if (!node) return;
  check_rotor(*node, piece.trajectory, piece.from.value_or(scene.start),
              piece.to ? piece.to : scene.end);
}

// Fills `piece`, which must be empty: numbers are made where they stay.
void read_piece(const JsonNode& node, const Scene& scene, bool body, bool first, bool last,
                MotionPiece& piece) {
  node.require_object({"from", "to", "coordinates", "rotor", "radius", "half_extents", "weight"});
  if (const auto from = node.find("from")) {
    from->read(piece.from.emplace());
  } else if (!first) {
    node.fail("\"from\" is missing", "only the first piece may begin with the scene");
  }
  if (const auto to = node.find("to")) {
    to->read(piece.to.emplace());
    if (piece.from && *piece.to <= *piece.from) {
      to->fail("the piece ends at " + shown(to->value()) + ", not after its \"from\"",
               "write \"to\" greater than \"from\"");
    }
  } else if (!last) {
    node.fail("\"to\" is missing", "only the last piece may have no end");
  }
  read_coordinates(node.member("coordinates"), scene.dimension, scene_axes(scene, body), piece.trajectory);
  if (body) {
    add_rotor(node, piece, scene);
  } else if (const auto rotor = node.find("rotor")) {
    rotor->fail("a rotor of a point", "remove it, or give the object a \"polygon\"");
  }
  add_extents(node, scene, piece);
}

// Refuses what would take too long. Instants that fit a word, nearly all of them, are never that long.
void check_cost(const Rational& seam, const MotionPiece& before, const MotionPiece& after,
                const JsonNode& node) {
  if (shortened(seam)) return;
  const auto degree =
      static_cast<std::size_t>(std::max(before.trajectory.degree(), after.trajectory.degree()));
  const std::size_t bits = degree * (seam.numerator().bit_length() + seam.denominator().bit_length());
  if (bits <= kMaxSeamBits) return;
  node.fail("whether the pieces meet takes numbers of " + std::to_string(bits) + " bits",
            "write a shorter time or a smaller degree");
}

void check_seam(const MotionPiece& before, const MotionPiece& after, const JsonNode& node,
                const Scene& scene) {
  const Rational& seam = *after.from;
  if (seam < *before.to) {
    node.member("from").fail("the piece begins at " + time_text(seam) +
                                 ", before the end of the piece before it at " +
                                 time_text(*before.to),
                             "pieces ascend in time and do not overlap");
  }
  if (scene.jumps || seam != *before.to) return;
  check_cost(seam, before, after, node);
  if (before.trajectory.meets(after.trajectory, seam, scene.has_bodies())) return;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const Rational there = before.trajectory.position(axis, seam);
    const Rational here = after.trajectory.position(axis, seam);
    if (there == here) continue;
    node.fail("the object jumps at " + time_text(seam) + " from " + time_text(there) + " to " +
                  time_text(here) + " on axis " + std::to_string(axis),
              "make the pieces meet, or say \"jumps\": true in the scene");
  }
  if (!scene.has_bodies()) {
    node.fail("the " + std::string(name_of(scene.extents)) + " jumps at " + time_text(seam),
              "make the pieces meet, or say \"jumps\": true in the scene");
  }
  const auto rotor = [&](const Trajectory& trajectory) {
    return time_text(trajectory.position(2, seam)) + ", " + time_text(trajectory.position(3, seam));
  };
  node.fail("the object turns suddenly at " + time_text(seam) + " from the rotor " +
                rotor(before.trajectory) + " to " + rotor(after.trajectory),
            "make the rotors equal up to a factor, or say \"jumps\": true in the scene");
}

}  // namespace

std::vector<std::vector<Rational>> read_rotor(const std::optional<JsonNode>& node) {
  if (!node) return {{Rational(1)}, {Rational(0)}};
  node->require_array();
  if (node->size() != 2) {
    node->fail(counted(node->size(), "coefficient list", "coefficient lists") + " in a rotor",
               "write two, [[p0, p1, ..], [q0, q1, ..]]");
  }
  return {read_coefficients(node->at(0), kMaxRotorDegree, "rotor"),
          read_coefficients(node->at(1), kMaxRotorDegree, "rotor")};
}

void read_motion(const JsonNode& object, const Scene& scene, bool body, Motion& motion) {
  const JsonNode node = object.member("motion");
  if (!node.is(JsonValue::Kind::kArray)) node.refuse("a motion", kMotionRemedy);
  if (node.size() == 0) node.fail("an empty motion", kMotionRemedy);
  if (!node.at(0).is(JsonValue::Kind::kObject)) {
    MotionPiece& piece = motion.pieces.emplace_back();
    read_coordinates(node, scene.dimension, scene_axes(scene, body), piece.trajectory);
    if (body) add_rotor(object, piece, scene);
    add_extents(object, scene, piece);
    if (scene.extents != Extents::kNone) check_extents(object, scene, piece, false);
    return;
  }
  if (const auto rotor = object.find("rotor")) {
    rotor->fail("a rotor beside a motion in pieces", "write a rotor inside each piece");
  }
  refuse_extents_beside_pieces(object);
  motion.pieces.reserve(node.size());
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode entry = node.at(i);
    MotionPiece& piece = motion.pieces.emplace_back();
    read_piece(entry, scene, body, i == 0, i + 1 == node.size(), piece);
    if (i > 0) check_seam(motion.pieces[i - 1], piece, entry, scene);
  }
  if (scene.extents == Extents::kNone) return;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const bool goes_on = i + 1 < node.size() && !scene.jumps &&
                         motion.pieces[i].to == motion.pieces[i + 1].from;
    check_extents(node.at(i), scene, motion.pieces[i], goes_on);
  }
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

}  // namespace kinex::formats
