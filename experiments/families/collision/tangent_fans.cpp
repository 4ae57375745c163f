// SPDX-License-Identifier: GPL-3.0-or-later
// Question: a regular polygon of n vertices turns once in front of a fan of m edges
//   (polygon_fans.cpp). How often does each of the two inner tangents change?
// Expected: the one at the fan exactly n (2m + 1) times, at any separation; the other one n times,
//   once for each vertex that passes. (An event names the bodies only: the tangents are compared
//   before and after it.)
// Cost: a second, some in full.
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/collision/experiments.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/collision/collision_pairs.h"
#include "structures/collision/inner_tangents.h"

namespace kinex::families {
namespace {

class TangentCounter final : public EventSink {
 public:
  explicit TangentCounter(const InnerTangents& structure) : structure_(structure) {}
  void start() { known_ = structure_.tangents(0, 1); }
  void event(const Event& event, Arithmetic&) override {
    if (event.kind != InnerTangents::kChange) return;
    const auto now = structure_.tangents(0, 1);
    ++events;
    for (std::size_t k = 0; known_ && now && k < 2; ++k) {
      changes[k] += (*known_)[k] == (*now)[k] ? 0 : 1;
    }
    known_ = now;
  }
  std::int64_t events = 0;
  std::array<std::int64_t, 2> changes{};

 private:
  const InnerTangents& structure_;
  std::optional<InnerTangents::Tangents> known_;
};

struct Counts {
  std::int64_t events;
  std::array<std::int64_t, 2> changes;
};

Counts count_changes(int n, int m, lab::StudyResult& study) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.separation = Rational(2);
  Scene scene = lab::generate_scene(*lab::find_workload("polygon-tangents"), parameters);
  scene.maintain = {{"inner_tangents", "inner_tangents", {}}};
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  TangentCounter counter(proof_of<InnerTangents>(std::as_const(*simulator).structure(0)));
  simulator->set_sink(&counter);
  simulator->start();
  counter.start();
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, scene.name, study);
  return {counter.events, counter.changes};
}

}  // namespace

lab::StudyResult study_tangents(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "inner_tangents";
  result.table.title = "inner tangents: changes of each in a turn before a tangent fan";
  result.table.header = {"n", "m", "events", "at the fan", "the other"};
  std::int64_t sizes = 0, right_at_fan = 0, right_others = 0;
  for (const auto& [n, m] : {std::array{8, 8}, {16, 16}, {16, 5}, {32, 32}, {64, 64}, {64, 16}}) {
    if (quick && n > 32) continue;
    if (!go_on()) return result;
    const Counts counter = count_changes(n, m, result);
    const auto& [other, fan] = counter.changes;
    result.table.rows.push_back({std::to_string(n), std::to_string(m),
                                 std::to_string(counter.events), std::to_string(fan),
                                 std::to_string(other)});
    ++sizes;
    right_at_fan += fan == n * (2 * m + 1) ? 1 : 0;
    right_others += other == n && counter.events == fan + other ? 1 : 0;
  }
  const auto check = [&](const char* claim, const char* expected, std::int64_t right,
                         const char* source) {
    result.checks.push_back({claim, "exact", "", expected,
                             "right in " + std::to_string(right) + " of " + std::to_string(sizes),
                             source, right == sizes ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
                             std::nullopt});
  };
  check("inner_tangents.at_fan", "n (2m + 1) changes", right_at_fan,
        "the tangent crosses the whole fan twice while a vertex passes, and goes on to the next");
  check("inner_tangents.other", "n changes", right_others, "one for each vertex that passes");
  return result;
}

}  // namespace kinex::families
