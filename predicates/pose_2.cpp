// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/pose_2.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/rational.h"

namespace kinex {
namespace {

using Coefficients = std::vector<Rational>;

Coefficients plus(const Coefficients& a, const Coefficients& b, int sign) {
  Coefficients sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (sign > 0) {
      sum[i] += b[i];
    } else {
      sum[i] -= b[i];
    }
  }
  return sum;
}
Coefficients operator+(const Coefficients& a, const Coefficients& b) { return plus(a, b, 1); }
Coefficients operator-(const Coefficients& a, const Coefficients& b) { return plus(a, b, -1); }
Coefficients operator*(const Coefficients& a, const Coefficients& b) {
  Coefficients product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

struct Turn {  // the square of a rotor, and its absolute value
  Coefficients c, s, n;
};
Turn square(const Coefficients& p, const Coefficients& q) {
  const Coefficients pp = p * p, qq = q * q, pq = p * q;
  return {pp - qq, pq + pq, pp + qq};
}

class Pose2 final : public Construction {
 public:
  std::string_view name() const override { return "pose_2"; }

  Trajectory derive(std::span<const Trajectory* const> bases) const override {
    const auto& a = bases[0]->coordinates;
    const auto& b = bases[1]->coordinates;
    const Coefficients x = b[0] - a[0], y = b[1] - a[1];
    const Turn turn_a = square(a[2], a[3]), turn_b = square(b[2], b[3]);
    // conj(w_A) w_B
    const Turn turn = square(a[2] * b[2] + a[3] * b[3], a[2] * b[3] - a[3] * b[2]);
    Trajectory pose;
    pose.coordinates = {turn_b.n * (turn_a.c * x + turn_a.s * y),
                        turn_b.n * (turn_a.c * y - turn_a.s * x),
                        turn_a.n * (turn_b.c * x + turn_b.s * y),
                        turn_a.n * (turn_b.c * y - turn_b.s * x),
                        turn.n,
                        turn.c,
                        turn.s};
    pose.normalise();
    return pose;
  }
};

}  // namespace

std::shared_ptr<const Construction> make_pose_2() { return std::make_shared<Pose2>(); }

}  // namespace kinex
