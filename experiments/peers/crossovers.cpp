// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/result_table.h"
#include "experiments/peers/tables.h"
#include "experiments/peers/worker.h"

namespace kinex::peers {

namespace {

constexpr const char* kMixed = "kinex separation_mixed";

double our_microseconds(const Scene& scene, int looks, int rounds) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const OurRun run = run_ours(scene, "separation_mixed", "exact", looks);
    times.push_back(1e6 * (run.build_seconds + run.run_seconds));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// nullopt if the answer is wrong or there is none.
std::optional<double> peer_microseconds(const PeerMethod& method, const PeerQuestion& question,
                                        double measure) {
  const PeerAnswer answer = ask_all(method, {question.exact}, {20, measure}).front();
  const PeerGrade grade = judge(method, question, answer).grade;
  if (grade != PeerGrade::kRight) return std::nullopt;
  return 1e6 * (answer.seconds + answer.load_seconds);
}

class Sweep {
 public:
  Sweep(lab::ResultTable& table, std::string name) : table_(table), name_(std::move(name)) {}
  void put(const std::string& method, double x, std::optional<double> microseconds) {
    char place[40];
    std::snprintf(place, sizeof place, "%g", x);
    table_.row(
        {name_, place, method, microseconds ? "right" : "wrong or none", microseconds.value_or(0)});
    auto found = std::find_if(curves_.begin(), curves_.end(),
                              [&](const PeerCurve& curve) { return curve.name == method; });
    if (found == curves_.end()) {
      curves_.push_back({method, {}});
      found = curves_.end() - 1;
    }
    if (microseconds) found->points.push_back({x, *microseconds});
  }
  const std::vector<PeerCurve>& curves() const { return curves_; }

 private:
  lab::ResultTable& table_;
  std::string name_;
  std::vector<PeerCurve> curves_;
};

// The compared methods that consider all instants, not samples.
std::vector<PeerMethod> continuous_methods() {
  std::vector<PeerMethod> methods;
  for (const PeerMethod& method : peer_methods()) {
    const bool cast = method.kind == PeerMethod::Kind::kCast && method.variant != 2 &&
                      method.name != "fcl default" && method.name != "bullet cast";
    const bool advance =
        method.kind == PeerMethod::Kind::kAdvance && method.stop < 1e-3 && method.module != "fcl";
    if (cast || advance) methods.push_back(method);
  }
  return methods;
}

}  // namespace

std::vector<lab::Figure> crossover_tables(const lab::BenchOptions& options,
                                          PeerQuestions& questions) {
  const bool quick = options.smoke;
  const double measure = quick ? 0.001 : 0.01;
  const int rounds = quick ? 1 : 5;
  lab::ResultTable table(
      options, "peers_crossovers",
      "Time of one question in microseconds, build included, against the gap (orbit, "
      "n=64), the vertices (orbit, gap 1e-2) and the looks on the way (line, n=64, gap "
      "1e-3: kinex is stopped and asked at each, a library tests each pose).",
      {{"sweep", lab::ResultTable::kText, 8},
       {"at", lab::ResultTable::kText, 8},
       {"method", lab::ResultTable::kText, 26},
       {"answer", lab::ResultTable::kText, 14},
       {"us", 1}});
  const std::vector<PeerMethod> methods = continuous_methods();
  Sweep by_gap(table, "gap"), by_size(table, "n"), by_looks(table, "looks");
  const auto orbit = [&](Sweep& sweep, double x, int n, double gap) {
    const PeerQuestion& question = questions.of(orbit_case(n, gap));
    sweep.put(kMixed, x, our_microseconds(orbit_scene(question.exact), 1, rounds));
    for (const PeerMethod& method : methods) {
      sweep.put(method.name, x, peer_microseconds(method, question, measure));
    }
  };
  for (int k = 0; k <= (quick ? 1 : 10); ++k) {
    const double gap = std::pow(10.0, -0.5 * k);
    orbit(by_gap, gap, quick ? 8 : 64, gap);
  }
  for (int n = 4; n <= (quick ? 8 : 512); n *= 2) orbit(by_size, n, n, 0.01);
  const PeerQuestion& line = questions.of(line_case(quick ? 8 : 64, 1e-3));
  const Scene scene = scene_of(line.exact);
  for (int looks = 1; looks <= (quick ? 4 : 1 << 14); looks *= quick ? 2 : 4) {
    by_looks.put(kMixed, looks, our_microseconds(scene, looks, rounds));
    for (const char* module : {"box2d", "bullet64", "fcl", "libccd"}) {
      if (!has_module(module)) continue;
      const PeerMethod method = steps_method(module, looks);
      by_looks.put(std::string(module) + " poses", looks, peer_microseconds(method, line, measure));
    }
  }
  const std::string right = " Only right answers are drawn.";
  return {figure_of("Time against separation",
                    "B goes round A once at this distance: microseconds a question, the building "
                    "of hierarchies and shapes included." +
                        right,
                    "separation of the bodies", "microseconds a question", by_gap.curves()),
          figure_of("Time against vertices", "The same at distance 0.01." + right,
                    "vertices of each body", "microseconds a question", by_size.curves()),
          figure_of("Time against looks on the way",
                    "B passes A at 0.001: the whole pass, with so many poses looked at. kinex "
                    "certifies what is in between; poses do not." +
                        right,
                    "looks on the way", "microseconds a pass", by_looks.curves())};
}

}  // namespace kinex::peers
