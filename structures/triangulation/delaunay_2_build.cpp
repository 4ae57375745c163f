// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: the static algorithm. Points are inserted one by one along a Hilbert curve over their
// ranks in x and y, in rounds of doubling size (Amenta, Choi, Rote 2003): only comparisons of
// coordinates are needed, and no order of the input is a bad one.
#include <algorithm>
#include <random>
#include <tuple>

#include "structures/parts/merge_sort.h"
#include "structures/triangulation/delaunay_2.h"

namespace kinex {
namespace {

// Place of (x, y), both below 2^16, along a Hilbert curve.
std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (std::uint32_t s = 1u << 15; s != 0; s >>= 1) {
    const std::uint32_t right = (x & s) != 0 ? 1 : 0, up = (y & s) != 0 ? 1 : 0;
    place = (place << 2) | ((3 * right) ^ up);
    if (up == 0) {
      if (right != 0) {
        x = 0xffffu - x;
        y = 0xffffu - y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

}  // namespace

void Delaunay2::build(std::span<const ObjectId> objects) {
  points_.set_present(objects);
  construct();
}

void Delaunay2::rebuild() {
  if (corrupt_) return;
  construct();
  untold_.clear();
}

void Delaunay2::rebuild_because(const std::string& reason) {
  if (corrupt_) return;
  if (!exact_ && ++repairs_ > kMostRepairs) return give_up("no end of rebuilds");
  AttributeDifference change;
  if (comes_or_goes_) {
    construct();
  } else {
    const Attribute before = told();
    construct();
    untold_.clear();
    if (!corrupt_) change = difference_between(before, attribute());
  }
  kernel_->count_rebuild(id_, reason, change.gone, change.came);
}

void Delaunay2::retract_all() {
  line_.clear();
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (store_.live(Triangulation2::triangle(h))) drop_certificate(h);
  }
}

// ranks()[i] < ranks()[j] iff the i-th object comes before the j-th; equal iff identically equal.
std::vector<std::uint32_t> Delaunay2::ranks(const std::vector<ObjectId>& objects,
                                            PredicateId order) const {
  std::vector<std::uint32_t> sorted(objects.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = i;
  merge_sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
    return kernel_->sign_after(order, {objects[a], objects[b]}) == Sign::kPositive;
  });
  std::vector<std::uint32_t> rank(objects.size(), 0);
  std::uint32_t current = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const ObjectId a = objects[sorted[i - 1]], b = objects[sorted[i]];
    if (kernel_->sign_after(order, {a, b}) != Sign::kZero) ++current;
    rank[sorted[i]] = current;
  }
  return rank;
}

void Delaunay2::construct() {
  retract_all();
  store_.clear();
  mark_.clear();
  epoch_ = 0;
  points_.reset();
  ties_.clear();
  suspects_.clear();
  blocked_ = false;
  has_last_quad_ = false;
  hint_ = kNone;
  on_line_ = true;
  const std::vector<ObjectId> objects = points_.members();
  const std::vector<std::uint32_t> x = ranks(objects, order_[0]), y = ranks(objects, order_[1]);

  struct Point {
    std::uint32_t x, y;
    ObjectId id;
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < objects.size(); ++i) points.push_back({x[i], y[i], objects[i]});
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y, a.id) < std::tie(b.x, b.y, b.id);
  });
  // Identically equal: the smallest id comes first and hides the others.
  std::size_t kept = 0;
  for (const Point& p : points) {
    if (kept != 0 && points[kept - 1].x == p.x && points[kept - 1].y == p.y) {
      points_.hide(p.id, points[kept - 1].id);
    } else {
      points[kept++] = p;
      points_.show(p.id);
    }
  }
  points.resize(kept);

  // The first point off the line through the first two, if there is one.
  std::size_t third = 2;
  while (third < kept && turn(points[0].id, points[1].id, points[third].id) == Sign::kZero) ++third;
  if (third >= kept) {
    std::vector<ObjectId> chain;
    for (const Point& p : points) chain.push_back(p.id);
    const bool upwards = kept > 0 && points.front().x == points.back().x;
    line_.claims().order = order_[upwards ? 1 : 0];
    return line_.build_in_order(chain);
  }

  struct Turn {
    std::uint64_t key;  // round, then place on the curve
    ObjectId id;
  };
  std::vector<Turn> turns;
  std::mt19937_64 engine(20240607);
  const std::uint64_t spread_x = points.back().x + std::uint64_t{1};
  std::uint64_t spread_y = 1;
  for (const Point& p : points)
    spread_y = std::max<std::uint64_t>(spread_y, p.y + std::uint64_t{1});
  for (const Point& p : points) {
    std::uint64_t round = 40;  // half of the points come in the last round, a quarter before, ...
    for (std::uint64_t bits = engine(); (bits & 1) != 0 && round != 0; bits >>= 1) --round;
    const auto px = static_cast<std::uint32_t>(p.x * std::uint64_t{0xffff} / spread_x);
    const auto py = static_cast<std::uint32_t>(p.y * std::uint64_t{0xffff} / spread_y);
    turns.push_back({round << 32 | hilbert_place(px, py), p.id});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.key, a.id) < std::tie(b.key, b.id);
  });
  std::vector<ObjectId> order{points[0].id, points[1].id, points[third].id};
  for (const Turn& t : turns) {
    if (t.id != order[0] && t.id != order[1] && t.id != order[2]) order.push_back(t.id);
  }
  on_line_ = false;
  build_plane(order);
}

// Requires that the first three points of `order` are not on one line.
void Delaunay2::build_plane(const std::vector<ObjectId>& order) {
  if (turn(order[0], order[1], order[2]) == Sign::kPositive) {
    store_.start(order[0], order[1], order[2]);
  } else {
    store_.start(order[1], order[0], order[2]);
  }
  hint_ = 0;
  certify_ = false;
  bool good = true;
  for (std::size_t i = 3; i < order.size() && good; ++i) {
    good = add_point(order[i], hint_, false) != Insertion::kFailed;
  }
  certify_ = true;
  if (!good) return give_up("the static construction found no place for a point");
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (h < store_.twin(h)) set_certificate(h);
  }
  settle_ties(false);
}

}  // namespace kinex
