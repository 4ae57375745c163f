// SPDX-License-Identifier: GPL-3.0-or-later
// DirectionMeanings: what a certificate along vectors can mean. A log gives the name of its predicate and
// its objects, not the vectors; the structure has a set of them (StructureInfo::directions).
//
//   order_direction(a, b)          one vector: as many meanings as there are vectors
//   order_extent(a, b, c, d)       two of them, u and v, or both opposite: u.(a - b) - v.(c - d)
//   order_extent_3, order_extent_2 likewise, for each way in which two of the four ends are one object
//   order_box_area(r, l, t, b, ..) two of the first half of them, each with the one that is turned by 90
//                                  degrees: the order of two boxes, in either direction
//   order_box_area/01232345        likewise; the digits tell the object that is each of the eight
//   order_box_perimeter            likewise
//
// 2k vectors have O(k^2) meanings. Where the value has to vanish at an instant, those whose value is
// certainly not zero there are passed over: in doubles, with a margin that is far above their rounding
// errors. The caller decides on the others exactly.
#ifndef KINEX_EXPERIMENTS_FORMATS_DIRECTION_MEANINGS_H
#define KINEX_EXPERIMENTS_FORMATS_DIRECTION_MEANINGS_H

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/motion/motion.h"
#include "core/numbers/rational.h"

namespace kinex::formats {

class DirectionMeanings {
 public:
  // `vectors`: one of each two opposite ones, all with as many entries as the scene has axes.
  explicit DirectionMeanings(std::vector<std::vector<Rational>> vectors);

  // The number of objects of a predicate along vectors; nullopt for another name.
  static std::optional<std::size_t> arity_of(std::string_view predicate);
  // An enclosure of an instant.
  struct Instant {
    double lower, upper;
  };
  // True if `fits` is true of one of the meanings, which are tried one after the other; `vanishing`: of
  // those only that may be zero at that instant. `motions`: arity_of(predicate) motions, none of them null.
  bool any(std::string_view predicate, std::span<const Trajectory* const> motions,
           const std::optional<Instant>& vanishing,
           const std::function<bool(const Predicate&)>& fits) const;

 private:
  // About the place of an object along a vector at an instant: the error is at most `margin`.
  struct Place {
    double value = 0, margin = 0;
  };
  using Places = std::vector<std::vector<Place>>;  // by vector, then by object

  Places places(std::span<const Trajectory* const> motions, const Instant& at) const;
  bool any_box(std::string_view predicate, const std::optional<Places>& at,
               const std::function<bool(const Predicate&)>& fits) const;

  std::vector<std::vector<Rational>> vectors_;
};

}  // namespace kinex::formats

#endif
