// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/least_squares.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace kinex::lab {

namespace {

template <class Value, void (*kFree)(Value*)>
struct Free {
  void operator()(Value* value) const { kFree(value); }
};
using Vector = std::unique_ptr<gsl_vector, Free<gsl_vector, gsl_vector_free>>;
using Matrix = std::unique_ptr<gsl_matrix, Free<gsl_matrix, gsl_matrix_free>>;
using Workspace = std::unique_ptr<gsl_multifit_linear_workspace,
                                  Free<gsl_multifit_linear_workspace, gsl_multifit_linear_free>>;

constexpr double kDependent = 1e-12;  // relative size of a singular value

}  // namespace

std::optional<LeastSquares> least_squares(const std::vector<std::vector<double>>& columns,
                                          const std::vector<double>& y,
                                          const std::vector<double>& error) {
  const std::size_t points = y.size(), terms = columns.size();
  if (terms == 0 || points <= terms) return std::nullopt;
  LeastSquares result;
  result.degrees = static_cast<int>(points - terms);
  result.weighted = std::all_of(error.begin(), error.end(), [](double e) { return e > 0; });
  const Matrix x(gsl_matrix_alloc(points, terms)), covariance(gsl_matrix_alloc(terms, terms));
  const Vector weights(gsl_vector_alloc(points)), values(gsl_vector_alloc(points)),
      coefficients(gsl_vector_alloc(terms));
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t j = 0; j < terms; ++j) gsl_matrix_set(x.get(), i, j, columns[j][i]);
    gsl_vector_set(values.get(), i, y[i]);
    gsl_vector_set(weights.get(), i, result.weighted ? 1 / (error[i] * error[i]) : 1);
  }
  const Workspace workspace(gsl_multifit_linear_alloc(points, terms));
  std::size_t rank = 0;
  gsl_multifit_wlinear_tsvd(x.get(), weights.get(), values.get(), kDependent, coefficients.get(),
                            covariance.get(), &result.chi_square, &rank, workspace.get());
  if (rank < terms) return std::nullopt;
  const double left = result.chi_square / result.degrees;
  const double widened = result.weighted ? std::max(1.0, left) : left;
  const double quantile = gsl_cdf_tdist_Pinv(0.975, result.degrees);
  for (std::size_t j = 0; j < terms; ++j) {
    const double coefficient = gsl_vector_get(coefficients.get(), j);
    const double half = quantile * std::sqrt(widened * gsl_matrix_get(covariance.get(), j, j));
    result.coefficients.push_back(coefficient);
    result.lower.push_back(coefficient - half);
    result.upper.push_back(coefficient + half);
  }
  return result;
}

}  // namespace kinex::lab
