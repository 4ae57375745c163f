// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/static_range_audit.h"

#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;
using Named = std::tuple<Point, ObjectId>;
using Traits = CGAL::Search_traits_adapter<Named, CGAL::Nth_of_tuple_property_map<0, Named>,
                                           CGAL::Search_traits_2<Exact>>;
using Box = CGAL::Fuzzy_iso_box<Traits>;

CGAL::Gmpq number(const Rational& value) { return CGAL::Gmpq(value.to_string()); }

}  // namespace

std::vector<ExactBox> boxes_between_points(const Snapshot& snapshot,
                                           const std::vector<ObjectId>& alive, std::uint64_t turn) {
  std::vector<ExactBox> result(std::min<std::size_t>(alive.size(), 3));
  for (std::size_t k = 0; k < result.size(); ++k) {
    const std::size_t number = static_cast<std::size_t>(turn) + k;
    for (const int axis : {0, 1}) {
      const std::size_t first = (number * 5 + static_cast<std::size_t>(axis) * 3) % alive.size();
      const std::size_t second = (number * 11 + 1 + k) % alive.size();
      Rational low = snapshot.position(alive[first], axis);
      Rational high = snapshot.position(alive[second], axis);
      if (high < low) std::swap(low, high);
      result[k][static_cast<std::size_t>(axis)] = {low, high};
    }
  }
  return result;
}

std::vector<ObjectId> scanned_range(const Snapshot& snapshot, const ExactBox& box) {
  std::vector<ObjectId> result;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (!snapshot.alive(id)) continue;
    bool inside = true;
    for (const int axis : {0, 1}) {
      const auto& [low, high] = box[static_cast<std::size_t>(axis)];
      const Rational& x = snapshot.position(id, axis);
      inside = inside && !(x < low) && !(high < x);
    }
    if (inside) result.push_back(id);
  }
  return result;
}

std::vector<ObjectId> cgal_range(const Snapshot& snapshot, const ExactBox& box) {
  std::vector<Named> points;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (!snapshot.alive(id)) continue;
    points.emplace_back(Point(number(snapshot.position(id, 0)), number(snapshot.position(id, 1))),
                        id);
  }
  std::vector<ObjectId> result;
  if (points.empty()) return result;
  CGAL::Kd_tree<Traits> tree(points.begin(), points.end());
  const Box query(Point(number(box[0][0]), number(box[1][0])),
                  Point(number(box[0][1]), number(box[1][1])), CGAL::Gmpq(0));
  std::vector<Named> found;
  tree.search(std::back_inserter(found), query);
  for (const Named& named : found) result.push_back(std::get<1>(named));
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace kinex
