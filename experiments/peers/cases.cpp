// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "experiments/families/collision/polygons.h"
#include "experiments/peers/case.h"

namespace kinex::peers {

namespace {

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

class Maker {
 public:
  explicit Maker(int seed) : random_(static_cast<std::uint64_t>(seed)) {}
  // Multiples of 2^-10 in [low, high].
  double between(double low, double high) {
    const double steps = (high - low) * 1024;
    return low + std::floor(static_cast<double>(random_() >> 11) * 0x1p-53 * steps) / 1024;
  }
  // At most n vertices on an ellipse, with the origin well inside.
  PeerShape shape(int n) {
    const PeerShape places = regular_shape(4 * n);
    const double x = between(0.25, 1), y = between(0.25, 1);
    for (;;) {
      std::vector<std::size_t> chosen;
      for (int i = 0; i < n; ++i) chosen.push_back(random_() % places.size());
      std::sort(chosen.begin(), chosen.end());
      chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
      PeerShape shape;
      for (const std::size_t i : chosen) shape.push_back({x * places[i][0], y * places[i][1]});
      if (shape.size() >= 3 && inner_radius(shape) >= 0.0625) return shape;
    }
  }

 private:
  std::mt19937_64 random_;
};

double top(const PeerShape& shape) {
  double top = shape.front()[1];
  for (const auto& v : shape) top = std::max(top, v[1]);
  return top;
}

double bottom(const PeerShape& shape) {
  double bottom = shape.front()[1];
  for (const auto& v : shape) bottom = std::min(bottom, v[1]);
  return bottom;
}

}  // namespace

PeerShape regular_shape(int n) {
  PeerShape shape;
  for (const Vertex2& v : families::regular_polygon(n, 1)) {
    shape.push_back({v[0].to_double(), v[1].to_double()});
  }
  return shape;
}

PeerCase line_case(int n, double gap) {
  PeerCase result{gap > 0 ? "line, apart" : "line, overlap",
                  "n=" + std::to_string(n) + " gap=" + number(gap),
                  regular_shape(n),
                  regular_shape(n),
                  {}};
  const double height = top(result.a) - bottom(result.b) + gap;
  result.frames = {{{}, {-4, height, 0}}, {{}, {4.25, height, 0}}};
  return result;
}

PeerCase orbit_case(int n, double gap) {
  PeerCase result{"orbit",
                  "n=" + std::to_string(n) + " gap=" + number(gap),
                  regular_shape(n),
                  regular_shape(n),
                  {}};
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const double angle = quarter * std::numbers::pi / 2;
    result.frames.push_back({{0, 0, angle}, {2 + gap, 0, angle}});
  }
  return result;
}

PeerCase spin_case(int n, int steps) {
  PeerCase result{"spin",
                  "n=" + std::to_string(n) + " steps=" + std::to_string(steps),
                  regular_shape(n),
                  regular_shape(n),
                  {}};
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    result.frames.push_back({{}, {-5 + 10 * s, 1.9, 6 * s}});
  }
  return result;
}

PeerCase random_case(int n, int seed) {
  Maker make(seed * 1000 + n);
  PeerCase result{"random",
                  "n=" + std::to_string(n) + " seed=" + std::to_string(seed),
                  make.shape(n),
                  make.shape(n),
                  {}};
  const PeerShape places = regular_shape(64);
  const auto& start = places[static_cast<std::size_t>(make.between(0, 64)) % 64];
  const double x = make.between(-1.5, 1.5), y = make.between(-1.5, 1.5);  // half way
  const PeerPose from{3 * start[0], 3 * start[1], make.between(-3, 3)};
  const PeerPose to{2 * x - from.x, 2 * y - from.y, from.angle + make.between(-2.5, 2.5)};
  const double turn = make.between(-1.5, 1.5);
  result.frames = {{{}, from}, {{0, 0, turn}, to}};
  return result;
}

PeerCase touch_case(int n) {
  PeerCase result = line_case(n, 0);
  result.family = "touch";
  result.name = "n=" + std::to_string(n);
  return result;
}

}  // namespace kinex::peers
