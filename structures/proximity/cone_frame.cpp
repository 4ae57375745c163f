// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_frame.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace kinex {
namespace {

using Vector = ConeFrame::Vector;

constexpr std::array<Vector, kOctantAxes> kOctantDirections{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

ConeFrame make_octants() {
  ConeFrame frame;
  frame.corners = 4;
  frame.axes.assign(kOctantDirections.begin(), kOctantDirections.end());
  frame.woods = {{{{kAlongY, true}, {kAlongX, false}, {kAlongDifference, true}}},
                 {{{kAlongX, false}, {kAlongY, false}, {kAlongSum, true}}}};
  frame.units = {{1, 0}, {0, 1}};
  using Side = ConeFrame::Side;
  frame.sides = {Side{1, true}, Side{0, false}, {}, Side{0, false}, Side{1, false}, {}};
  frame.ratio = {2, 1};
  return frame;
}

// ---- polygons

struct Corner {  // (x, y) / length is on the unit circle
  int x, y, length;
};

// Those of a half circle and the one after it, counter-clockwise.
std::vector<Corner> half_of(int corners) {
  std::vector<Corner> half;
  if (corners == 12) half = {{1, 0, 1}, {4, 3, 5}, {3, 4, 5}};
  if (corners == 20) half = {{1, 0, 1}, {12, 5, 13}, {4, 3, 5}, {3, 4, 5}, {5, 12, 13}};
  if (half.empty()) throw std::invalid_argument("a polygon of 12 or 20 corners");
  const std::size_t quarter = half.size();
  for (std::size_t i = 0; i <= quarter; ++i) {
    const Corner last = half[i];
    half.push_back({-last.y, last.x, last.length});
  }
  return half;
}

// The primitive vector of the same direction, and the axis of the frame along it or against it.
ConeFrame::Order along(ConeFrame& frame, Vector v) {
  const int common = std::gcd(v[0], v[1]);
  const bool reversed = 2 * v[0] + v[1] < 0;
  for (int& entry : v) entry /= reversed ? -common : common;
  const auto there = std::find(frame.axes.begin(), frame.axes.end(), v);
  const auto axis = static_cast<std::size_t>(there - frame.axes.begin());
  if (there == frame.axes.end()) frame.axes.push_back(v);
  return {axis, reversed};
}

ConeFrame make_polygon(int corners) {
  const std::vector<Corner> half = half_of(corners);
  const std::size_t cones = half.size() - 1;
  ConeFrame frame;
  frame.corners = corners;
  std::vector<int> denominators;
  int common = 1;
  for (std::size_t i = 0; i < cones; ++i) {  // u.b = |b| and u.c = |c|, by Cramer's rule
    const Corner &b = half[i], &c = half[i + 1];
    Vector u{b.length * c.y - c.length * b.y, c.length * b.x - b.length * c.x};
    int denominator = b.x * c.y - b.y * c.x;
    const int divisor = std::gcd(std::gcd(u[0], u[1]), denominator);
    for (int* const number : {&u[0], &u[1], &denominator}) *number /= divisor;
    frame.units.push_back(u);
    denominators.push_back(denominator);
    common = std::lcm(common, denominator);
  }
  int longest = 0;
  for (std::size_t i = 0; i < cones; ++i) {
    Vector& u = frame.units[i];
    for (int& entry : u) entry *= common / denominators[i];
    longest = std::max(longest, u[0] * u[0] + u[1] * u[1]);
    const Corner &b = half[i], &c = half[i + 1];
    frame.woods.push_back({along(frame, u), along(frame, {b.y, -b.x}), along(frame, {-c.y, c.x})});
    frame.sides.push_back(ConeFrame::Side{static_cast<std::uint8_t>(i), false});
    frame.sides.resize(frame.sides.size() + SchnyderWood::kColours - 1);
  }
  frame.ratio = {longest, common * common};
  return frame;
}

}  // namespace

std::size_t ConeFrame::counted() const {
  return static_cast<std::size_t>(std::count_if(
      sides.begin(), sides.end(), [](const auto& side) { return side.has_value(); }));
}

const char* octant_axis_name(OctantAxis axis) {
  constexpr std::array<const char*, kOctantAxes> kNames{"x", "y", "x + y", "x - y"};
  return kNames[axis];
}

Vector octant_axis(OctantAxis axis) { return kOctantDirections[axis]; }

const ConeFrame& octant_frame() {
  static const ConeFrame frame = make_octants();
  return frame;
}

const ConeFrame& polygon_frame(int corners) {
  static const ConeFrame twelve = make_polygon(12), twenty = make_polygon(20);
  if (corners != 12 && corners != 20) throw std::invalid_argument("a polygon of 12 or 20 corners");
  return corners == 12 ? twelve : twenty;
}

}  // namespace kinex
