// SPDX-License-Identifier: GPL-3.0-or-later
// One-dimensional families that reach the largest number of events of a structure.
#include "experiments/input_error.h"
#include "experiments/workloads/families.h"

namespace kinex {

namespace {

std::string function_name(int i) { return "f" + std::to_string(i); }

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

// f_j(t) = j t - (2n)^j, t >= 0: j overtakes i < j once, after all pairs of smaller numbers.
void add_power_lines(int n, Scene& scene) {
  scene.start = 0;
  Integer power_j(1);
  for (int j = 0; j < n; ++j) {
    add_object(scene, function_name(j), {{-Rational(power_j), Rational(j)}});
    power_j *= Integer(2 * static_cast<std::int64_t>(n));
  }
}

}  // namespace

// Degree 1: all n(n-1)/2 pairs swap once. Degree d: x_i(t) = i q(t) + 2^(i-2n-8), where q has d
// simple positive roots: all pairs swap d times, just beside the roots, in d n(n-1)/2 swaps.
void generate_sort_worst(const WorkloadParameters& parameters, Scene& scene) {
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
    add_object(scene, function_name(i), {std::move(coefficients)});
  }
}

// f_i(t) = i t - 2^i with leaves in bit-reversed order: at every node of the tournament the two
// sides win alternately, so its winner changes once for every function below it: n log2(n) - n + 1
// failures.
void generate_tournament_worst(const WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n;
  if ((n & (n - 1)) != 0) {
    throw InputError("tournament-worst", "--n",
                     show_text(std::to_string(n)) + " is not a power of two", "write 2, 4, 8, ..");
  }
  scene.start = 0;
  for (int leaf = 0; leaf < n; ++leaf) {
    int reversed = 0;
    for (int bit = 1; bit < n; bit *= 2) reversed = 2 * reversed + ((leaf & bit) != 0 ? 1 : 0);
    const Integer drop = Integer::power_of_two(static_cast<unsigned long>(reversed));
    add_object(scene, function_name(reversed), {{-Rational(drop), Rational(reversed)}});
  }
}

// In array order every item rises to the root after all smaller ones are done, so the failures are
// the sum of the depths: floor(log2(j + 1)) over j = 0 .. n-1.
void generate_heap_worst(const WorkloadParameters& parameters, Scene& scene) {
  add_power_lines(parameters.n, scene);
}

}  // namespace kinex
