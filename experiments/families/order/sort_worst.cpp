// SPDX-License-Identifier: GPL-3.0-or-later
// Every pair of objects swaps as often as their degree allows.
#include <utility>

#include "experiments/families/order/workloads.h"
#include "experiments/families/points/power_lines.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// q(t) = (t - 1)(t - 2) .. (t - degree), low degree first.
std::vector<Rational> product_of_roots(int degree) {
  std::vector<Rational> q{Rational(1)};
  for (int root = 1; root <= degree; ++root) {
    std::vector<Rational> next(q.size() + 1, Rational(0));
    for (std::size_t k = 0; k < q.size(); ++k) {
      next[k + 1] += q[k];
      next[k] -= Rational(root) * q[k];
    }
    q = std::move(next);
  }
  return q;
}

}  // namespace

// Degree 1: all n(n-1)/2 pairs swap once. Degree d: x_i(t) = i q(t) + 2^(i-2n-8), where q has d
// simple positive roots: all pairs swap d times, just beside the roots, in d n(n-1)/2 swaps.
void generate_sort_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  if (parameters.degree == 1) {
    add_power_lines(parameters.n, scene);
    return;
  }
  scene.start = 0;
  scene.end = parameters.degree + 1;
  const std::vector<Rational> q = product_of_roots(parameters.degree);
  const auto shift = static_cast<unsigned long>(2 * static_cast<long>(parameters.n) + 8);
  const Integer unit = Integer::power_of_two(shift);
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<Rational> coefficients;
    for (const Rational& c : q) coefficients.push_back(Rational(i) * c);
    coefficients[0] += Rational(Integer::power_of_two(static_cast<unsigned long>(i)), unit);
    lab::add_object(scene, function_name(i), {std::move(coefficients)});
  }
}

}  // namespace kinex::families
