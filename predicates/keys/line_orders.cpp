// SPDX-License-Identifier: GPL-3.0-or-later
// Key i is the line slope_i t + height_i, and the point (slope_i, height_i) of the dual plane.
//
//   line_slope_order(a, b) = slope_b - slope_a
//   line_turn(a, b, c)     = (slope_b - slope_a) (height_c - height_a)
//                          - (height_b - height_a) (slope_c - slope_a)
//   line_meeting(a, b, c, d, e) = (slope_b - slope_a) line_turn(c, d, e)
//                               - (slope_d - slope_c) line_turn(a, b, e)
//
// line_slope_order says which of two keys grows faster. line_turn is the orientation of the dual
// points, and so the order in which three lines meet. line_meeting, for slope_a < slope_b and
// slope_c < slope_d, has the sign of the height of line ab less that of line cd, both at e:
//
//   height |            . b
//          |         .
//          |      .  |     . d      ab above cd at the slope of e: positive
//          |   a     |  .
//          |      c  .
//          +---------e-------- slope
//
// Degrees in the dual points: 1, 2, 3; in t: 0. Identities: predicates/predicates.h.
#include <array>
#include <stdexcept>
#include <string_view>

#include "predicates/keys/line_predicate.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct LineSlopeOrder {
  static constexpr int kArity = 2;
  static constexpr int kAlternating = 2;
  static constexpr int kHomogeneity = 1;
  static constexpr std::array<ArgumentRole, 2> kRoles{{{"slower"}, {"faster"}}};
  static constexpr std::string_view kSays = "the key of {1} grows no slower than that of {0}";
  static constexpr std::string_view name() { return "line_slope_order"; }

  template <class Points>
  static auto value(const Points& p, const LineKey& key) {
    const auto u = key.difference(p, 0, 1);
    return WideRing<typename decltype(u)::Ring>::widen(LineKey::slope(u));
  }
};

struct LineTurn {
  static constexpr int kArity = 3;
  static constexpr int kAlternating = 3;
  static constexpr int kHomogeneity = 2;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"from"}, {"to"}, {"left of it"}}};
  static constexpr std::string_view kSays =
      "the dual point of {2} is not to the right of the line from that of {0} to that of {1}";
  static constexpr std::string_view name() { return "line_turn"; }

  template <class Points>
  static auto value(const Points& p, const LineKey& key) {
    return LineKey::turn(key.difference(p, 0, 1), key.difference(p, 0, 2));
  }
};

struct LineMeeting {
  static constexpr int kArity = 5;
  static constexpr int kAlternating = 0;
  static constexpr int kHomogeneity = 3;
  static constexpr std::array<ArgumentRole, 5> kRoles{
      {{"upper, from"}, {"upper, to"}, {"lower, from"}, {"lower, to"}, {"slope"}}};
  static constexpr std::string_view kSays =
      "at the slope of {4} the line through the dual points of {0} and {1} is not below that "
      "through those of {2} and {3}";
  static constexpr std::string_view name() { return "line_meeting"; }

  template <class Points>
  static auto value(const Points& p, const LineKey& key) {
    const auto ab = key.difference(p, 0, 1);
    const auto cd = key.difference(p, 2, 3);
    using W = WideRing<typename decltype(ab)::Ring>;
    return W::widen(LineKey::slope(ab)) * LineKey::turn(cd, key.difference(p, 2, 4)) -
           W::widen(LineKey::slope(cd)) * LineKey::turn(ab, key.difference(p, 0, 4));
  }
};

LineKey line_key(const Key& key, int dimension) {
  std::vector<Rational> direction(static_cast<std::size_t>(dimension));
  switch (key.kind) {
    case Key::Kind::kCoordinate:
      direction[static_cast<std::size_t>(key.axis)] = Rational(1);
      break;
    case Key::Kind::kDirection:
      direction = key.direction;
      break;
    case Key::Kind::kSquaredDistance:
      throw std::invalid_argument("squared distances of moving points are no lines");
  }
  LineKey result;
  for (Integer& v : primitive_direction(direction)) result.direction.emplace_back(std::move(v));
  return result;
}

}  // namespace

std::shared_ptr<const Predicate> make_line_slope_order(const Key& key, int dimension) {
  return std::make_shared<LinePredicate<LineSlopeOrder>>(line_key(key, dimension));
}
std::shared_ptr<const Predicate> make_line_turn(const Key& key, int dimension) {
  return std::make_shared<LinePredicate<LineTurn>>(line_key(key, dimension));
}
std::shared_ptr<const Predicate> make_line_meeting(const Key& key, int dimension) {
  return std::make_shared<LinePredicate<LineMeeting>>(line_key(key, dimension));
}

}  // namespace kinex
