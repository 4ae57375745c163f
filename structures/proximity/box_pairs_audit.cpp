// SPDX-License-Identifier: GPL-3.0-or-later
// The witness for boxes: CGAL's box_intersection_d, of closed boxes. It needs a number type that has a largest
// number, so coordinates are the ranks of the exact ends along an axis, of equal ends the same one. Each
// pair that it finds is checked at the exact positions. Discs: by trying all pairs.
#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "structures/proximity/box_pairs.h"
#include "structures/proximity/static_meetings_audit.h"

namespace kinex {
namespace {

using Pair = std::array<ObjectId, 2>;

class Boxes {
 public:
  Boxes(const Snapshot& snapshot, bool discs) : snapshot_(snapshot), discs_(discs) {
    for (ObjectId id = 0; id < snapshot.objects(); ++id) {
      if (snapshot.alive(id)) ids_.push_back(id);
    }
  }

  // That CGAL finds, ascending.
  std::vector<Pair> found() const {
    const int axes = snapshot_.dimension();
    return axes == 1 ? found_in<1>() : axes == 2 ? found_in<2>() : found_in<3>();
  }
  // By definition.
  bool meet(const Pair& pair) const {
    for (int axis = 0; axis < snapshot_.dimension(); ++axis) {
      const Rational reach = half(pair[0], axis) + half(pair[1], axis);
      const Rational apart = snapshot_.position(pair[1], axis) - snapshot_.position(pair[0], axis);
      if (reach < apart || reach < -apart) return false;
    }
    return true;
  }

 private:
  using Ends = std::array<Rational, 2>;

  const Rational& half(ObjectId id, int axis) const {
    const int dimension = snapshot_.dimension();
    return snapshot_.position(id, discs_ ? dimension : dimension + axis);
  }
  Ends ends(ObjectId id, int axis) const {
    const Rational& centre = snapshot_.position(id, axis);
    return {centre - half(id, axis), centre + half(id, axis)};
  }

  template <int kAxes>
  std::vector<Pair> found_in() const {
    using Box =
        CGAL::Box_intersection_d::Box_with_handle_d<int, kAxes, const ObjectId*,
                                                    CGAL::Box_intersection_d::ID_FROM_HANDLE>;
    std::array<std::vector<Rational>, kAxes> sorted;
    for (int axis = 0; axis < kAxes; ++axis) {
      auto& all = sorted[static_cast<std::size_t>(axis)];
      for (const ObjectId id : ids_) {
        for (Rational& end : ends(id, axis)) all.push_back(std::move(end));
      }
      std::sort(all.begin(), all.end());
    }
    std::vector<Box> boxes;
    for (const ObjectId& id : ids_) {
      int low[kAxes], high[kAxes];
      for (int axis = 0; axis < kAxes; ++axis) {
        const auto& all = sorted[static_cast<std::size_t>(axis)];
        const auto rank = [&all](const Rational& end) {
          return static_cast<int>(std::lower_bound(all.begin(), all.end(), end) - all.begin());
        };
        const Ends both = ends(id, axis);
        low[axis] = rank(both[0]);
        high[axis] = rank(both[1]);
      }
      boxes.emplace_back(low, high, &id);
    }
    std::vector<Pair> result;
    CGAL::box_self_intersection_d(
        boxes.begin(), boxes.end(),
        [&result](const Box& a, const Box& b) {
          result.push_back(
              {std::min(*a.handle(), *b.handle()), std::max(*a.handle(), *b.handle())});
        },
        std::ptrdiff_t{10}, CGAL::Box_intersection_d::CLOSED);
    std::sort(result.begin(), result.end());
    return result;
  }

  const Snapshot& snapshot_;
  bool discs_;
  std::vector<ObjectId> ids_;  // ascending
};

}  // namespace

std::vector<ObjectId> static_box_pairs(const Snapshot& snapshot, bool discs) {
  const Boxes boxes(snapshot, discs);
  std::vector<ObjectId> result;
  for (const Pair& pair : boxes.found()) {
    if (boxes.meet(pair)) result.insert(result.end(), pair.begin(), pair.end());
  }
  return result;
}

std::vector<ObjectId> static_disc_pairs(const Snapshot& snapshot) {
  return static_meetings(snapshot, [&](ObjectId a, ObjectId b) {
    const int dimension = snapshot.dimension();
    const Rational reach = snapshot.position(a, dimension) + snapshot.position(b, dimension);
    Rational rest = reach * reach;
    for (int axis = 0; axis < dimension; ++axis) {
      const Rational step = snapshot.position(b, axis) - snapshot.position(a, axis);
      rest -= step * step;
    }
    return rest.sign() >= 0;
  });
}

void BoxPairs::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_box_pairs(snapshot, discs_) == attribute().ids,
               [] { return "other boxes meet"; });
}

}  // namespace kinex
