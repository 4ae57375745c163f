// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/polynomial_weights.h"

#include <algorithm>
#include <memory>

#include "core/arithmetic.h"
#include "experiments/cpu_clock.h"
#include "experiments/workload.h"
#include "experiments/workloads/families.h"
#include "predicates/predicates.h"

namespace kinex {

namespace {

constexpr int kObjects = 200;
constexpr int kRounds = 5;

// CPU seconds per failure time, the best of some rounds.
double seconds_per_question(Arithmetic& arithmetic, PredicateId predicate, std::size_t arity,
                            int questions) {
  double best = 0;
  for (int round = 0; round < kRounds; ++round) {
    WorkloadRandom random(17);
    const double begin = cpu_seconds();
    for (int k = 0; k < questions; ++k) {
      std::array<ObjectId, 4> ids{};
      for (std::size_t i = 0; i < arity; ++i) {
        do {
          ids[i] = static_cast<ObjectId>(random.below(kObjects));
        } while (std::find(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(i), ids[i]) !=
                 ids.begin() + static_cast<std::ptrdiff_t>(i));
      }
      const Query query = arity == 2   ? Query(predicate, {ids[0], ids[1]})
                          : arity == 3 ? Query(predicate, {ids[0], ids[1], ids[2]})
                                       : Query(predicate, {ids[0], ids[1], ids[2], ids[3]});
      FailureTime time;
      arithmetic.failure(query, time);
      arithmetic.release(time);
    }
    const double each = (cpu_seconds() - begin) / questions;
    if (round == 0 || each < best) best = each;
  }
  return best;
}

}  // namespace

PolynomialWeights square_weights() {
  PolynomialWeights weights{"d^2", {}};
  for (int d = 0; d <= kHighestWeight; ++d) weights.by_degree[static_cast<std::size_t>(d)] = d * d;
  return weights;
}

PolynomialWeights measured_weights(const std::string& arithmetic) {
  WorkloadParameters parameters;
  parameters.n = kObjects;
  parameters.dimension = 2;
  Scene scene = generate_scene(*find_workload("uniform-square"), parameters);
  scene.end.reset();
  const std::unique_ptr<Arithmetic> numbers = make_arithmetic(arithmetic, scene);
  for (ObjectId i = 0; i < kObjects; ++i) {
    numbers->set_motion(i, scene.objects[i].motion.pieces[0].trajectory, std::nullopt);
  }
  numbers->set_now(scene.start);
  const int questions = arithmetic == "exact" ? 20000 : 300;
  const double order =
      seconds_per_question(*numbers, numbers->bind(make_coordinate_order(0)), 2, questions);
  const double orientation =
      seconds_per_question(*numbers, numbers->bind(make_orientation_2()), 3, questions);
  const double circle =
      seconds_per_question(*numbers, numbers->bind(make_in_circle_2()), 4, questions);
  const double two = orientation / order, four = circle / order;
  return {"measured in " + arithmetic, {0, 1, two, (two + four) / 2, four}};
}

double cost_of(const RunRecord& record, const PolynomialWeights& weights) {
  double cost = 0;
  for (std::size_t d = 0; d < record.solved.size(); ++d) {
    const std::size_t known = std::min<std::size_t>(d, kHighestWeight);
    cost += weights.by_degree[known] * static_cast<double>(record.solved[d]);
  }
  return cost;
}

}  // namespace kinex
