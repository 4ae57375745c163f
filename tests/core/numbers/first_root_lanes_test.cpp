// SPDX-License-Identifier: GPL-3.0-or-later
// The filter's first step in lanes, continued: bit for bit the filter of each polynomial alone.
#include "core/numbers/first_root_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace kinex {
namespace first_root_lanes_test {

using filter::Enclosure;
using filter::FirstRoot;
using filter::Search;

struct Four {
  int degree = 4;
  std::array<std::array<double, filter::kMaxLaneDegree + 1>, kLanes> c{}, m{};
};

// Random, with close or multiple roots, tiny and huge, with coefficients that vanish.
Four draw_four(std::mt19937_64& random, int degree) {
  Four four;
  four.degree = degree;
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    auto& c = four.c[lane];
    auto& m = four.m[lane];
    const auto n = static_cast<std::size_t>(degree);
    const int scale = random() % 8 == 0 ? static_cast<int>(random() % 1900) - 950 : 0;
    if (random() % 2 == 0) {
      for (std::size_t i = 0; i <= n; ++i) c[i] = unit();
    } else {  // a product of factors t - root, roots of few bits
      c[0] = random() % 2 == 0 ? 1 : -1;
      for (std::size_t d = 0; d < n; ++d) {
        const double root = static_cast<double>(random() % 64) / 16 - 1;
        for (std::size_t i = d + 1; i > 0; --i) c[i] = c[i - 1] - root * c[i];
        c[0] *= -root;
      }
    }
    if (random() % 8 == 0) c[random() % (n + 1)] = 0;
    if (random() % 16 == 0) c.fill(0);
    for (std::size_t i = 0; i <= n; ++i) {
      c[i] = std::ldexp(c[i], scale);
      m[i] = std::fabs(c[i]) * (1 + 0.5 * std::fabs(unit()));
    }
  }
  return four;
}

// As ExactArithmetic::sign_over_now and the check of the degree.
bool positive_over(const double* c, const double* m, int d, const filter::LaneSpan& span) {
  const double bound = std::max(std::fabs(span.lo), std::fabs(span.hi));
  double value = c[d], magnitude = m[d], slope = d * m[d];
  for (int i = d - 1; i >= 0; --i) {
    value = value * span.hi + c[i];
    magnitude = magnitude * bound + m[i];
    if (i > 0) slope = slope * bound + i * m[i];
  }
  if (!(magnitude >= 0x1p-300 && magnitude <= 0x1p900) || m[d] == 0) return false;
  return value > filter::gamma(d) * magnitude + slope * span.width * (1 + 0x1p-20);
}

template <int D>
void check(const Four& four, double lo, double hi, const std::array<double, kLanes>& ends,
           Vectors vectors, int* answers) {
  Lanes c[D + 1], m[D + 1];
  for (std::size_t i = 0; i <= D; ++i) {
    c[i] = Lanes(four.c[0][i], four.c[1][i], four.c[2][i], four.c[3][i]);
    m[i] = Lanes(four.m[0][i], four.m[1][i], four.m[2][i], four.m[3][i]);
  }
  using Root = FirstRoot<D, true>;
  std::array<double, kLanes> node_end, length;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    node_end[lane] = Root::first_end(hi, ends[lane]);
    length[lane] = Root::length_of(hi, node_end[lane]);
  }
  const filter::LaneSpan span{lo, hi, hi - lo, Lanes(length[0], length[1], length[2], length[3])};
  filter::LaneNodes nodes;
  filter::first_nodes(c, m, D, span, vectors, nodes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double* const one_c = four.c[lane].data();
    const double* const one_m = four.m[lane].data();
    Enclosure alone{}, together{};
    const Search expected = Root(one_c, one_m, D, 0.5)(hi, ends[lane], alone);
    const bool positive = positive_over(one_c, one_m, D, span);
    // A lane whose node has no error bound is left to the filter alone, which does not know either.
    ASSERT_TRUE(!nodes.positive[lane] || positive);
    ASSERT_TRUE(!positive || nodes.positive[lane] || expected == Search::kUnknown);
    ASSERT_TRUE(!nodes.clear[lane] || (nodes.positive[lane] && expected == Search::kNone));
    if (!nodes.positive[lane]) continue;
    const Search search =
        filter::from_first_node(nodes, lane, c, m, D, 0.5, hi, node_end[lane], together);
    ASSERT_EQ(search, expected);
    if (nodes.clear[lane]) ++answers[3];
    ++answers[static_cast<int>(search)];
    if (search != Search::kFound) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(alone.lo), std::bit_cast<std::uint64_t>(together.lo));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(alone.hi), std::bit_cast<std::uint64_t>(together.hi));
  }
}

TEST(FirstRootLanes, AreTheFilterOfEachPolynomial) {
  std::mt19937_64 random(7);
  std::array<int, 4> answers{};
  for (int i = 0; i < 30000; ++i) {
    const int degree = std::array<int, 3>{4, 8, 12}[random() % 3];
    const Four four = draw_four(random, degree);
    const double hi = random() % 4 == 0 ? 0 : static_cast<double>(random() % 1000) / 64 - 4;
    const double width = std::ldexp(1.0, -40 - static_cast<int>(random() % 20));
    const double lo = random() % 2 == 0 ? hi : hi - width;
    std::array<double, kLanes> ends;
    for (double& end : ends) {
      const double ahead = 1 + static_cast<double>(random() % 8);
      end = hi + std::ldexp(ahead, static_cast<int>(random() % 12) - 9);
    }
    for (const Vectors vectors : {Vectors::kBase, Vectors::kAvx2}) {
      if (vectors == Vectors::kAvx2 && best_vectors() != Vectors::kAvx2) continue;
      if (degree == 4) check<4>(four, lo, hi, ends, vectors, answers.data());
      if (degree == 8) check<8>(four, lo, hi, ends, vectors, answers.data());
      if (degree == 12) check<12>(four, lo, hi, ends, vectors, answers.data());
      if (HasFatalFailure()) FAIL() << "round " << i;
    }
  }
  // All cases have occurred.
  for (const int count : answers) EXPECT_GT(count, 100);
}

}  // namespace first_root_lanes_test
}  // namespace kinex
