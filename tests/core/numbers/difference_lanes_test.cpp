// SPDX-License-Identifier: GPL-3.0-or-later
// Differences in lanes whose errors are of any size: the roots are bit for bit those of the filter for each
// polynomial alone, and so is what lanes leave to it. (exact_difference_group_test.cpp has true motions.)
#include "core/numbers/difference_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace kinex {
namespace difference_lanes_test {

using filter::Enclosure;
using filter::Search;

struct Rows {
  std::array<std::array<Ball, filter::kMaxDifferenceDegree + 1>, kLanes> from{}, to{};
};

double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; }

// Random, or with two close roots; with errors down to none and up to a sixteenth.
Rows draw_rows(std::mt19937_64& random, int degree) {
  Rows rows;
  for (std::size_t j = 0; j < kLanes; ++j) {
    const double size = std::ldexp(1.0, -static_cast<int>(random() % 60) - 4);
    for (int k = 0; k <= degree; ++k) {
      const auto i = static_cast<std::size_t>(k);
      rows.from[j][i] = {unit(random), size * (1 + unit(random))};
      rows.to[j][i] = {unit(random), size * (1 + unit(random))};
    }
    if (random() % 2 != 0) continue;
    const double r = unit(random), s = r + std::ldexp(unit(random), -static_cast<int>(random() % 30));
    rows.to[j][0].value = rows.from[j][0].value + r * s;
    rows.to[j][1].value = rows.from[j][1].value - (r + s);
    rows.to[j][2].value = rows.from[j][2].value + 1;
  }
  return rows;
}

struct Seen {
  int clear = 0, found = 0, left = 0, left_with_root = 0;
};

template <int D>
void compare(const Rows& rows, const filter::DifferenceSpan& span, double end, Vectors vectors, Seen& seen) {
  filter::DifferenceRows<Ball> pointers;
  for (std::size_t j = 0; j < kLanes; ++j) {
    pointers.from[j] = rows.from[j].data();
    pointers.to[j] = rows.to[j].data();
  }
  filter::DifferenceLanes lanes;
  filter::difference_lanes(pointers, D, span, vectors, lanes);
  for (std::size_t j = 0; j < kLanes; ++j) {
    if ((lanes.known >> j & 1) == 0) continue;
    double c[D + 1], m[D + 1];
    for (std::size_t k = 0; k <= D; ++k) {
      c[k] = lanes.c[k][j];
      m[k] = lanes.m[k][j];
    }
    const filter::FirstRoot<D, true> filter(c, m, D, span.origin);
    Enclosure alone{}, together{lanes.lo[j], lanes.hi[j]};
    const Search expected = filter(span.now_hi - span.origin, end, alone);
    const bool clear = (lanes.clear >> j & 1) != 0, found = (lanes.found >> j & 1) != 0;
    ASSERT_FALSE(clear && found);
    Search search = clear ? Search::kNone : Search::kFound;
    if (!clear && !found) search = filter::from_first_node(lanes, j, D, span, together);
    ASSERT_EQ(search, expected);
    if (search == Search::kFound) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(together.lo), std::bit_cast<std::uint64_t>(alone.lo));
      ASSERT_EQ(std::bit_cast<std::uint64_t>(together.hi), std::bit_cast<std::uint64_t>(alone.hi));
    } else if (clear) {
      ASSERT_EQ(lanes.lo[j], span.nothing);
    }
    ++(clear ? seen.clear : found ? seen.found : seen.left);
    if (!clear && !found && search == Search::kFound) ++seen.left_with_root;
  }
}

TEST(DifferenceLanes, AreTheFilterOfEachPolynomial) {
  std::mt19937_64 random(5);
  Seen seen;
  for (int round = 0; round < 60000; ++round) {
    const int degree = 2 + round % 2;
    const Rows rows = draw_rows(random, degree);
    filter::DifferenceSpan span{};
    span.origin = static_cast<double>(random() % 8) / 8 - 0.5;
    span.shift = span.origin;
    span.now_hi = span.origin + static_cast<double>(random() % 64) / 512;
    span.now_lo = span.now_hi - std::ldexp(1.0, -50);
    span.alike = true;
    span.nothing = -3;
    const double from = span.now_hi - span.origin;
    const double end = from + std::ldexp(1.0, 1 - static_cast<int>(random() % 12));
    using Node = filter::FirstRoot<2, true>;
    span.end[0] = Node::first_end(from, end);
    span.length[0] = Node::length_of(from, span.end[0]);
    for (const Vectors vectors : {Vectors::kBase, Vectors::kAvx2}) {
      if (vectors == Vectors::kAvx2 && best_vectors() != Vectors::kAvx2) continue;
      degree == 2 ? compare<2>(rows, span, end, vectors, seen) : compare<3>(rows, span, end, vectors, seen);
      if (HasFatalFailure()) FAIL() << "round " << round;
    }
  }
  EXPECT_GT(seen.clear, 3000);
  EXPECT_GT(seen.found, 3000);
  EXPECT_GT(seen.left, 3000);
  EXPECT_GT(seen.left_with_root, 1000);
}

}  // namespace difference_lanes_test
}  // namespace kinex
