// SPDX-License-Identifier: GPL-3.0-or-later
// PolynomialWeights: the cost of solving an equation, by its degree. The cost of a run is the sum
// of the weights of the equations that it solves.
#ifndef KINEX_EXPERIMENTS_FAMILIES_HULL_POLYNOMIAL_WEIGHTS_H
#define KINEX_EXPERIMENTS_FAMILIES_HULL_POLYNOMIAL_WEIGHTS_H

#include <array>
#include <string>

#include "experiments/lab/run_record.h"

namespace kinex::families {

inline constexpr int kHighestWeight = 4;  // linear motion: in-circle tests

struct PolynomialWeights {
  std::string name;
  std::array<double, kHighestWeight + 1> by_degree{};
};

// d^2 for degree d: the multiplications of a Sturm sequence, d divisions of degree d each.
PolynomialWeights square_weights();
// CPU time of a failure time of each degree over that of degree 1, in one arithmetic, on random
// linear motion: coordinate order, orientation and in-circle (degree 3 takes the mean of 2 and 4).
PolynomialWeights measured_weights(const std::string& arithmetic);

double cost_of(const lab::RunRecord& record, const PolynomialWeights& weights);

}  // namespace kinex::families

#endif
