// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/uniform_lines.h"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace kinex::families {

namespace {

constexpr int kPoints = 24;  // of the Gauss-Legendre rule, on each panel
constexpr int kPanels = 40;  // [2^-(k+1), 2^-k], and one more down to 0

struct FreeTable {
  void operator()(gsl_integration_glfixed_table* table) const {
    gsl_integration_glfixed_table_free(table);
  }
};

// The integral over y of F^(m-2) g^3 / 3 at time t in (0, 1/2]. With c = t (1 - t) and
// w = t / (2 (1 - t)) the trapezoid has F = y^2 / (2c) up to y = t, where F = w; then slope
// 1 / (1 - t) up to y = 1 - t, where F = 1 - w; then 1 - (1-y)^2 / (2c).
double over_position(double t, int m) {
  const double c = t * (1 - t);
  const double w = t / (2 * (1 - t));
  const double k = m - 1;
  const double low = std::pow(w, m) / m;
  // The integral of v (1-v)^(m-2) over v in [0, w].
  const double log_rest = std::log1p(-w);
  const double high = -std::expm1(k * log_rest) / k + std::expm1((k + 1) * log_rest) / (k + 1);
  const double middle = (std::exp(k * log_rest) - std::pow(w, k)) / k;
  return 2 / (3 * c) * (low + high) + middle / (3 * (1 - t) * (1 - t));
}

double at_time(double t, void* m) { return over_position(t, *static_cast<int*>(m)); }

}  // namespace

double expected_envelope_changes(int m) {
  if (m < 2) return 0;
  const std::unique_ptr<gsl_integration_glfixed_table, FreeTable> table(
      gsl_integration_glfixed_table_alloc(kPoints));
  gsl_function function{at_time, &m};
  double sum = 0;
  double high = 0.5;
  for (int panel = 0; panel <= kPanels; ++panel) {
    const double low = panel == kPanels ? 0 : high / 2;
    sum += gsl_integration_glfixed(&function, low, high, table.get());
    high = low;
  }
  return static_cast<double>(m) * (m - 1) * sum;  // C(m,2), and t in (1/2, 1) is the mirror image
}

double expected_tournament_failures(int n) {
  if (n < 1 || (n & (n - 1)) != 0) throw std::invalid_argument("not a power of two");
  double sum = 0;
  for (int m = 2; m <= n; m *= 2) {
    sum += (static_cast<double>(n) / m) * expected_envelope_changes(m) * m / (2.0 * (m - 1));
  }
  return sum;
}

}  // namespace kinex::families
