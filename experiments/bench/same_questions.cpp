// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does one failure time, and one sign, cost in `exact` and in doubles? Runs do not say
//   where doubles handle other events: here both are asked for the same certificates.
// Workload: an exact run. At evenly spaced times all certificates of the structure are taken down,
//   those that it has of the highest degree. A second arithmetic of each kind is then set to each of
//   these times, and asked for all certificates of that time, one after the other.
// Counted: certificates whose failure times doubles and `exact` find alike (equal outlooks, times
//   within 1e-6 of the scene's time), and the others, which are not timed. Time: thread CPU time, the
//   best of the rounds, arithmetics alternating.
// Output: see result_table.h; options: see bench_options.h.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/result_table.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Instant {
  Rational time;
  std::vector<Query> queries;
};

struct Trace {
  std::vector<std::shared_ptr<const Predicate>> predicates;
  std::vector<Instant> instants;
  int degree = 0;  // of the certificates that are taken down
};

// Predicates without a copy: those of `arithmetic`, which has to outlive them.
std::vector<std::shared_ptr<const Predicate>> predicates_of(const Arithmetic& arithmetic) {
  std::vector<std::shared_ptr<const Predicate>> result;
  const std::size_t count = arithmetic.counters().by_predicate.size();
  for (std::size_t id = 0; id < count; ++id) {
    result.emplace_back(std::shared_ptr<const Predicate>(),
                        &arithmetic.predicate(static_cast<PredicateId>(id)));
  }
  return result;
}

Instant instant_of(const Simulator& simulator, StructureId asked) {
  Instant instant{simulator.reached(), {}};
  const EventQueue& queue = simulator.queue();
  for (CertificateId id = 0; id < queue.capacity(); ++id) {
    if (queue.certificate(id).live && queue.certificate(id).structure == asked) {
      instant.queries.push_back(queue.query(id));
    }
  }
  return instant;
}

Trace trace_of(Simulator& simulator, const Scene& scene, int times) {
  Trace trace;
  for (int i = 0; i < times; ++i) {
    const Rational part(Integer(2 * i + 1), Integer(2 * times));
    simulator.run_until(scene.start + (*scene.end - scene.start) * part);
    trace.instants.push_back(instant_of(simulator, asked_structure(scene)));
  }
  trace.predicates = predicates_of(simulator.arithmetic());
  const auto degree = [&](const Query& query) {
    return trace.predicates[query.predicate]->degree(scene.degree());
  };
  for (const Instant& instant : trace.instants) {
    for (const Query& query : instant.queries) trace.degree = std::max(trace.degree, degree(query));
  }
  for (Instant& instant : trace.instants) {
    std::erase_if(instant.queries, [&](const Query& q) { return degree(q) < trace.degree; });
  }
  return trace;
}

struct Answer {
  Outlook outlook;
  double time;
};

class Asked {
 public:
  Asked(std::string_view name, const Scene& scene, const Trace& trace)
      : arithmetic_(planned_arithmetic(name, scene)) {
    for (const auto& predicate : trace.predicates) arithmetic_->bind(predicate);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const MotionPiece& piece = scene.objects[i].motion.pieces.front();
      arithmetic_->set_motion(static_cast<ObjectId>(i), piece.trajectory, piece.to);
    }
  }
  std::vector<Answer> answers(const Instant& instant) {
    arithmetic_->set_now(instant.time);
    std::vector<Answer> result;
    for (const Query& query : instant.queries) {
      FailureTime time;
      const Outlook outlook = arithmetic_->failure(query, time);
      result.push_back({outlook, outlook == Outlook::kFails ? time.lo : 0});
      arithmetic_->release(time);
    }
    return result;
  }
  // Seconds for all failure times, and for all signs.
  double failures(const Trace& trace) {
    double seconds = 0;
    for (const Instant& instant : trace.instants) {
      arithmetic_->set_now(instant.time);
      const double begin = lab::cpu_seconds();
      for (const Query& query : instant.queries) {
        FailureTime time;
        arithmetic_->failure(query, time);
        arithmetic_->release(time);
      }
      seconds += lab::cpu_seconds() - begin;
    }
    return seconds;
  }
  double signs(const Trace& trace) {
    double seconds = 0;
    for (const Instant& instant : trace.instants) {
      arithmetic_->set_now(instant.time);
      const double begin = lab::cpu_seconds();
      for (const Query& query : instant.queries) arithmetic_->sign_after(query);
      seconds += lab::cpu_seconds() - begin;
    }
    return seconds;
  }

 private:
  std::unique_ptr<Arithmetic> arithmetic_;
};

// Takes out certificates whose answers differ; returns their number.
std::uint64_t leave_out_different(Trace& trace, Asked& doubles, Asked& exact, double near) {
  std::uint64_t different = 0;
  for (Instant& instant : trace.instants) {
    const std::vector<Answer> a = doubles.answers(instant), b = exact.answers(instant);
    std::vector<Query> alike;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i].outlook == b[i].outlook && std::fabs(a[i].time - b[i].time) <= near) {
        alike.push_back(instant.queries[i]);
      } else {
        ++different;
      }
    }
    instant.queries = std::move(alike);
  }
  return different;
}

void add_row(const lab::BenchRow& row, bool smoke, lab::ResultTable& table) {
  const Scene scene = lab::scene_of(row);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  Trace trace = trace_of(simulator, scene, smoke ? 3 : 100);
  Asked doubles("double", scene, trace), exact("exact", scene, trace);
  const double near = 1e-6 * (*scene.end - scene.start).to_double();
  const std::uint64_t different = leave_out_different(trace, doubles, exact, near);
  std::uint64_t count = 0;
  for (const Instant& instant : trace.instants) count += instant.queries.size();
  const double each = 1e9 / static_cast<double>(std::max<std::uint64_t>(1, count));
  double best[4] = {};  // failure times and signs in doubles, then exact
  for (int round = 0; round < (smoke ? 1 : 20 * row.rounds); ++round) {
    const double seconds[4] = {doubles.failures(trace), doubles.signs(trace),
                               exact.failures(trace), exact.signs(trace)};
    for (int i = 0; i < 4; ++i) {
      if (round == 0 || seconds[i] < best[i]) best[i] = seconds[i];
    }
  }
  table.row({row.structure, row.workload, row.parameters.n, trace.degree, count, different,
             best[0] * each, best[2] * each, best[2] / best[0], best[1] * each,
             best[3] * each, best[3] / best[1]});
}

void same_questions(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "same_questions",
      "The same certificates' failure times and signs in `exact` and in doubles: nanoseconds of one, "
      "and `exact` over doubles. left_out: certificates that doubles answer otherwise.",
      {{"structure", lab::ResultTable::kText, 25},
       {"scene", lab::ResultTable::kText, 14},
       {"n", 0, 6},
       {"degree", 0},
       {"certificates", 0},
       {"left_out", 0},
       {"failure_double", 1},
       {"failure_exact", 1},
       {"ratio_of_failures", 2},
       {"sign_double", 1},
       {"sign_exact", 1},
       {"ratio_of_signs", 2}});
  for (const lab::BenchRow& row : lab::bench_rows("same_questions", options)) {
    add_row(row, options.smoke, table);
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, same_questions); }
