// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does an exact answer to a continuous collision query cost, and which stage gives
//   it?
// Workload: random doubles; the same after a box test has removed the easy ones; bodies made to
//   miss or meet by a gap of 1e-3 to 1e-15 at a point of their border; small integers, which touch,
//   graze and stay in a plane.
// Times: microseconds a query, one core, the best of several rounds.
//   answer  yes or no
//   first   with the first time of contact
//   exact   the exact stage alone
// Ratio: exact over first. Output: see result_table.h; options: see bench_options.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/result_table.h"
#include "predicates/ccd/contact_exact.h"
#include "predicates/ccd/continuous_contact.h"

namespace {

using namespace kinex;
using Doubles = ContactQuery::Doubles;

class Maker {
 public:
  explicit Maker(ContactKind kind)
      : random_(1), bodies_(kind == ContactKind::kVertexFace ? 1 : 2) {}

  Doubles random() {
    Doubles c;
    for (double& x : c) x = unit();
    return c;
  }

  // The boxes around the two bodies' paths overlap.
  Doubles overlapping() {
    for (;;) {
      const Doubles c = random();
      if (boxes_meet(c)) return c;
    }
  }

  // A point of one body meets a point of the border of the other at a random time, up to the gap.
  Doubles near(double gap) {
    Doubles c = random();
    const double t = half(), along = half(), other = half();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [&](std::size_t p) {
        return c[ContactQuery::index(0, p, axis)] * (1 - t) +
               c[ContactQuery::index(1, p, axis)] * t;
      };
      const double one = bodies_ == 1 ? at(0) : at(0) * (1 - other) + at(1) * other;
      const double two = bodies_ == 1 ? at(1) * (1 - along) + at(2) * along : at(2);
      const double shift = two - one + gap * unit();
      for (std::size_t p = 0; p < bodies_; ++p) {
        c[ContactQuery::index(0, p, axis)] += shift;
        c[ContactQuery::index(1, p, axis)] += shift;
      }
    }
    return c;
  }

  Doubles integers() {
    Doubles c;
    for (double& x : c) x = std::floor(3 * half());
    return c;
  }

 private:
  double half() { return static_cast<double>(random_() >> 12) * 0x1p-52; }
  double unit() { return 2 * half() - 1; }

  bool boxes_meet(const Doubles& c) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 2> low{9, 9}, high{-9, -9};
      for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t body = i % 4 < bodies_ ? 0 : 1;
        low[body] = std::min(low[body], c[3 * i + axis]);
        high[body] = std::max(high[body], c[3 * i + axis]);
      }
      if (high[0] < low[1] || high[1] < low[0]) return false;
    }
    return true;
  }

  std::mt19937_64 random_;
  std::size_t bodies_;  // points of the first body
};

// Microseconds a query.
template <class Ask>
double best_of(int rounds, const std::vector<ContactQuery>& queries, const Ask& ask) {
  const auto ask_all = [&] {
    const double begin = lab::cpu_seconds();
    for (const ContactQuery& query : queries) ask(query);
    return lab::BenchRun{.seconds = lab::cpu_seconds() - begin};
  };
  return lab::best_of_rounds({ask_all}, {.count = rounds})[0].seconds * 1e6 /
         static_cast<double>(queries.size());
}

void measure(lab::ResultTable& table, ContactKind kind, const char* workload,
             const std::vector<ContactQuery>& queries, int rounds) {
  ContactCounters stages, ignored;
  std::size_t contacts = 0;
  for (const ContactQuery& query : queries) contacts += in_contact(query, stages) ? 1 : 0;
  const double answer =
      best_of(rounds, queries, [&](const ContactQuery& q) { in_contact(q, ignored); });
  const double first =
      best_of(rounds, queries, [&](const ContactQuery& q) { first_contact(q, ignored); });
  // The exact stage is slow: it is timed on a part of the queries.
  const std::vector<ContactQuery> some(
      queries.begin(), queries.begin() + static_cast<long>((queries.size() + 9) / 10));
  const double exact =
      best_of(1, some, [&](const ContactQuery& q) { first_contact_exactly(q, ignored.roots); });
  const auto percent = [&](std::uint64_t n) {
    return 100 * static_cast<double>(n) / static_cast<double>(queries.size());
  };
  table.row({kind == ContactKind::kVertexFace ? "vertex-face" : "edge-edge", workload,
             static_cast<std::uint64_t>(queries.size()), percent(contacts), percent(stages.at_once),
             percent(stages.subdivided), percent(stages.exact), answer, first, exact,
             exact / first});
}

void ccd(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "ccd",
      "Continuous collision queries; shares in percent, times in microseconds a query.",
      {{"kind", lab::ResultTable::kText, 11},
       {"workload", lab::ResultTable::kText, 11},
       {"queries", 0},
       {"contacts", 1},
       {"at_once", 1},
       {"subdivided", 1},
       {"exact_stage", 1},
       {"us_answer", 3},
       {"us_first", 3},
       {"us_exact", 1},
       {"ratio", 1}});
  const int count = options.smoke ? 30 : 20000, rounds = options.rounds(5);
  for (const ContactKind kind : {ContactKind::kVertexFace, ContactKind::kEdgeEdge}) {
    Maker make(kind);
    const auto run = [&](const char* workload, const auto& next) {
      std::vector<ContactQuery> queries;
      for (int i = 0; i < count; ++i) queries.emplace_back(kind, next());
      measure(table, kind, workload, queries, rounds);
    };
    run("random", [&] { return make.random(); });
    run("overlapping", [&] { return make.overlapping(); });
    run("gap 1e-3", [&] { return make.near(1e-3); });
    run("gap 1e-6", [&] { return make.near(1e-6); });
    run("gap 1e-9", [&] { return make.near(1e-9); });
    run("gap 1e-12", [&] { return make.near(1e-12); });
    run("gap 1e-15", [&] { return make.near(1e-15); });
    run("integers", [&] { return make.integers(); });
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, ccd); }
