// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/hull/polynomial_weights.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"
#include "predicates/predicates.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr int kObjects = 200;
constexpr int kRounds = 15;

// CPU seconds of `questions` failure times.
double seconds_of(Arithmetic& arithmetic, PredicateId predicate, std::size_t arity, int questions) {
  lab::WorkloadRandom random(17);
  const double begin = lab::cpu_seconds();
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
  return lab::cpu_seconds() - begin;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

PolynomialWeights square_weights() {
  PolynomialWeights weights{"d^2", {}};
  for (int d = 0; d <= kHighestWeight; ++d) weights.by_degree[static_cast<std::size_t>(d)] = d * d;
  return weights;
}

PolynomialWeights measured_weights(const std::string& arithmetic) {
  lab::WorkloadParameters parameters;
  parameters.n = kObjects;
  parameters.dimension = 2;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  scene.end.reset();
  const std::unique_ptr<Arithmetic> numbers = planned_arithmetic(arithmetic, scene);
  for (ObjectId i = 0; i < kObjects; ++i) {
    numbers->set_motion(i, scene.objects[i].motion.pieces[0].trajectory, std::nullopt);
  }
  numbers->set_now(scene.start);
  const int questions = arithmetic == "exact" ? 10000 : 100;
  const PredicateId order = numbers->bind(make_coordinate_order(0));
  const PredicateId orientation = numbers->bind(make_orientation_2());
  const PredicateId circle = numbers->bind(make_in_circle_2());
  // The machine's speed varies from minute to minute: each ratio is taken within a round, and the
  // median of the rounds counts.
  std::vector<double> two, four;
  for (int round = 0; round < kRounds; ++round) {
    const double one = seconds_of(*numbers, order, 2, questions);
    two.push_back(seconds_of(*numbers, orientation, 3, questions) / one);
    four.push_back(seconds_of(*numbers, circle, 4, questions) / one);
  }
  const double w2 = median(two), w4 = median(four);
  return {"measured in " + arithmetic, {0, 1, w2, (w2 + w4) / 2, w4}};
}

double cost_of(const lab::RunRecord& record, const PolynomialWeights& weights) {
  double cost = 0;
  for (std::size_t d = 0; d < record.solved.size(); ++d) {
    const std::size_t known = std::min<std::size_t>(d, kHighestWeight);
    cost += weights.by_degree[known] * static_cast<double>(record.solved[d]);
  }
  return cost;
}

}  // namespace kinex::families
