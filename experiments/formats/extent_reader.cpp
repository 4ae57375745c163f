// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of scenes of discs and boxes only: extents that are never negative.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"
#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"

namespace kinex::formats {

namespace {

constexpr const char* kRadius = "radius";
constexpr const char* kHalfExtents = "half_extents";

// The member of an object, or of a piece, that has its extents.
const char* member_of(Extents extents) {
  return extents == Extents::kRadius ? kRadius : kHalfExtents;
}

std::string quoted(Extents extents) { return std::string("\"") + member_of(extents) + "\""; }

// {"the radius", ..}, {"the half extent on axis 1", ..}
std::string named_axis(const Scene& scene, int axis) {
  if (scene.extents == Extents::kRadius) return "the radius";
  return "the half extent on axis " + std::to_string(axis);
}

// The sign of the polynomial right after t.
Sign sign_right_after(const std::vector<Rational>& coefficients, const Rational& t) {
  std::vector<Rational> c = coefficients;
  while (!c.empty()) {
    Rational value;
    for (std::size_t k = c.size(); k-- > 0;) {
      value *= t;
      value += c[k];
    }
    if (!value.is_zero()) return value.sign() > 0 ? Sign::kPositive : Sign::kNegative;
    c.erase(c.begin());
    for (std::size_t k = 0; k < c.size(); ++k) c[k] *= Rational(static_cast<int>(k + 1));
  }
  return Sign::kZero;
}

void check_not_negative(const JsonNode& node, const std::vector<Rational>& coefficients,
                        const std::string& what, const Rational& from,
                        const std::optional<Rational>& to, bool goes_on) {
  const char* const remedy = "write one that is never negative while the object exists";
  if (coefficients.size() == 1) {
    if (coefficients[0].sign() < 0) {
      node.fail(what + " is negative: " + time_text(coefficients[0]), remedy);
    }
    return;
  }
  if (!(goes_on && to && *to == from) && sign_right_after(coefficients, from) == Sign::kNegative) {
    node.fail(what + " is negative right after " + time_text(from), remedy);
  }
  RealRoot after(from);
  RootCounters counters;
  const Polynomial extent = Polynomial::from_rationals(coefficients);
  std::optional<RealRoot> turns = first_sign_change_after(extent, after, to, counters);
  if (!turns || (goes_on && to && compare(*turns, *to, counters) == 0)) return;
  node.fail(what + " is negative right after " + time_text(extent, *turns, counters), remedy);
}

bool has_polygon(const JsonNode& object) { return object.find("polygon").has_value(); }

bool is_line(const JsonNode& object) {
  const auto line = object.find("line");
  return line && line->is(JsonValue::Kind::kBoolean) && line->boolean();
}

// "a radius", "half extents"
std::string with_article(Extents kind) {
  return std::string(kind == Extents::kRadius ? "a " : "") + std::string(name_of(kind));
}

// Refuses the extents `node` of what never has some, beside a motion or in a flight plan.
void refuse_of_body(const JsonNode& node, Extents kind) {
  node.fail(with_article(kind) + " of a body", "remove it, or the \"polygon\"");
}
void refuse_of_line(const JsonNode& node, Extents kind) {
  node.fail(quoted(kind) + " of a line", "remove it, or \"line\": true");
}

}  // namespace

std::string_view name_of(Extents extents) {
  return extents == Extents::kRadius ? "radius" : "half extents";
}

Extents read_kind_of_extents(const JsonNode& object) {
  if (has_polygon(object) || is_line(object)) return Extents::kNone;
  const auto kind_of = [](const JsonNode& owner) {
    if (owner.find(kRadius)) return Extents::kRadius;
    return owner.find(kHalfExtents) ? Extents::kHalfExtents : Extents::kNone;
  };
  const Extents beside = kind_of(object);
  if (beside != Extents::kNone) return beside;
  const auto motion = object.find("motion");
  if (!motion || !motion->is(JsonValue::Kind::kArray) || motion->size() == 0) return beside;
  const JsonNode first = motion->at(0);
  return first.is(JsonValue::Kind::kObject) ? kind_of(first) : beside;
}

void check_kind_of_extents(const JsonNode& object, const Scene& scene) {
  for (const Extents kind : {Extents::kRadius, Extents::kHalfExtents}) {
    const auto node = object.find(member_of(kind));
    if (!node) continue;
    const std::string what = with_article(kind);
    if (has_polygon(object)) refuse_of_body(*node, kind);
    if (scene.extents == Extents::kNone) {
      if (is_line(object)) refuse_of_line(*node, kind);
      node->fail(what + " in a scene of points", "give every object " + quoted(kind) + ", or none");
    }
    if (scene.extents != kind) {
      node->fail(what + " in a scene of objects with " + quoted(scene.extents),
                 "give all objects \"radius\", or all \"half_extents\"");
    }
  }
  if (scene.extents == Extents::kNone) return;
  const std::string of = scene.extents == Extents::kRadius ? " of a disc" : " of a box";
  if (const auto ends = object.find("ends")) {
    ends->fail("vertices" + of, "remove them, or the " + quoted(scene.extents));
  }
}

void refuse_extents_beside_pieces(const JsonNode& object) {
  for (const char* const name : {kRadius, kHalfExtents}) {
    if (const auto node = object.find(name)) {
      node->fail(std::string("\"") + name + "\" beside a motion in pieces",
                 "write it inside each piece");
    }
  }
}

void add_extents(const JsonNode& owner, const Scene& scene, MotionPiece& piece) {
  for (const Extents kind : {Extents::kRadius, Extents::kHalfExtents}) {
    const auto node = owner.find(member_of(kind));
    if (!node || kind == scene.extents) continue;
    const SceneObject& object = scene.objects.back();
    if (!object.polygon.empty()) refuse_of_body(*node, kind);
    if (object.line) refuse_of_line(*node, kind);
    node->fail(quoted(kind) + " of a flight plan that other objects do not have",
               "give every flight plan of every object the same of the two, or none");
  }
  if (scene.extents == Extents::kNone) return;
  const auto node = owner.find(member_of(scene.extents));
  if (!node) {
    owner.fail(quoted(scene.extents) + " is missing",
               "give every flight plan of every object " + quoted(scene.extents) + ", or none");
  }
  std::vector<std::vector<Rational>>& axes = piece.trajectory.coordinates;
  if (scene.extents == Extents::kRadius) {
    axes.push_back(read_coefficients(*node, kMaxExtentDegree, "radius"));
  } else {
    node->require_array();
    if (node->size() != static_cast<std::size_t>(scene.dimension)) {
      node->fail(counted(node->size(), "half extent", "half extents") +
                     " in a scene of dimension " + std::to_string(scene.dimension),
                 "write one coefficient list per axis");
    }
    for (std::size_t axis = 0; axis < node->size(); ++axis) {
      axes.push_back(read_coefficients(node->at(axis), kMaxExtentDegree, "half extent"));
    }
  }
  piece.trajectory.normalise();
}

void check_extents(const JsonNode& owner, const Scene& scene, const MotionPiece& piece,
                   bool goes_on) {
  const Rational from = piece.from && scene.start < *piece.from ? *piece.from : scene.start;
  if (piece.to && (*piece.to < from || *piece.to == scene.start)) return;
  if (scene.end && *scene.end < from) return;
  std::optional<Rational> to = piece.to;
  if (scene.end && (!to || *scene.end < *to)) {
    to = scene.end;
    goes_on = false;
  }
  const JsonNode node = owner.member(member_of(scene.extents));
  const auto& axes = piece.trajectory.coordinates;
  for (int axis = 0; axis < scene.extent_axes(); ++axis) {
    check_not_negative(node, axes[static_cast<std::size_t>(scene.dimension + axis)],
                       named_axis(scene, axis), from, to, goes_on);
  }
}

}  // namespace kinex::formats
