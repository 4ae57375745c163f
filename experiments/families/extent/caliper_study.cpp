// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do rotating calipers and the tournaments above them cost, beside what changes? Are
//   they local, compact, efficient?
// Sources: structures/extent/calipers.h: at most h certificates for h vertices, 4 of one vertex;
//   caliper_extremum.h: h - 1 of the candidates. A tip of the comb is the contact of the m edges above
//   it: m of the candidates, which have a leaf of the tournament each, so it is in m/2 certificates at
//   least: locality of order m. Above them an event of the calipers need not change the attribute: in
//   the vernier the width changes twice.
// Scenes: the vernier, the comb and random motion.
// Expected: the inequalities above; every hard bound and the audit at the end of every run.
// Cost: seconds.
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/lab/measurement.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {
namespace {

struct Row {
  const char* workload;
  const char* structure;
  int degree;  // of the certificates of linear motion
};
// The calipers come first in every scene.
constexpr Row kRows[] = {{"vernier", "calipers_2", 2},
                         {"vernier", "diameter_2", 2},
                         {"vernier", "width_2", 6},
                         {"comb", "calipers_2", 2},
                         {"comb", "width_2", 6},
                         {"comb", "min_area_rectangle_2", 6},
                         {"comb", "min_perimeter_rectangle_2", 6},
                         {"uniform-square", "calipers_2", 2},
                         {"uniform-square", "diameter_2", 2},
                         {"uniform-square", "width_2", 6},
                         {"uniform-square", "min_area_rectangle_2", 6},
                         {"uniform-square", "min_perimeter_rectangle_2", 6}};

class CaliperStudy {
 public:
  CaliperStudy() {
    result_.name = "calipers";
    result_.table.title = "calipers: what the diameter, the width and the rectangles cost beside them";
    result_.table.header = {"scene",  "n = m",   "structure",    "degree",       "events",
                            "changes", "events a change", "certificates", "most of a point", "seconds"};
    result_.table.note =
        "events, certificates: of the calipers and the tournament, without those of the hull; in random "
        "motion n is the number of points; degree: of the certificates that compare candidates";
  }

  void run(const Row& row, int size) {
    const bool random = std::string_view(row.workload) == "uniform-square";
    lab::WorkloadParameters parameters{.n = random ? 16 * size : size, .seed = 7};
    if (!random) parameters.m = size;
    SimulatorOptions options;
    options.audit = AuditLevel::kEnd;
    const Scene scene = lab::generate_scene(row.workload, parameters, row.structure);
    const lab::Measurement run = lab::measure(scene, "exact", options);
    const StructureLedger& ledger = run.ledger;
    const double events = static_cast<double>(ledger.failures);
    const double changes = static_cast<double>(ledger.external);
    result_.table.rows.push_back(
        {row.workload, std::to_string(parameters.n), row.structure, std::to_string(row.degree),
         std::to_string(ledger.failures), std::to_string(ledger.external),
         changes > 0 ? fmt::format("{:.2f}", events / changes) : "-",
         std::to_string(ledger.max_live), std::to_string(ledger.max_per_object),
         fmt::format("{:.3g}", run.seconds)});
    const std::string where = fmt::format("{}.{}", row.workload, parameters.n);
    std::string broken = run.clean() ? "" : "the audit";
    for (const BoundCheck& bound : run.bounds) {
      if (!bound.holds) broken = bound.id;
    }
    check(fmt::format("{}.{}.bounds", row.structure, where), "every hard bound and the audit",
          broken.empty() ? "all hold" : broken, "structures/extent", broken.empty());
    const std::string structure = row.structure;
    if (structure == "calipers_2") {
      at_most("calipers_2.local." + where, ledger.max_per_object, 4,
              "a vertex is in two edges, an edge in two certificates");
    } else if (std::string_view(row.workload) == "comb") {
      at_least(structure + ".not_local." + where, ledger.max_per_object,
               static_cast<std::uint64_t>(size) / 2,
               "a tip is the contact of m edges, and each candidate is in a certificate of its leaf");
    }
  }

  lab::StudyResult take() { return std::move(result_); }

 private:
  void check(std::string claim, std::string expected, std::string observed, const char* source,
             bool holds) {
    result_.checks.push_back({std::move(claim), "bound", "", std::move(expected),
                              std::move(observed), source,
                              holds ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
                              std::nullopt});
  }
  void at_most(std::string claim, std::uint64_t seen, std::uint64_t bound, const char* source) {
    check(std::move(claim), fmt::format("<= {}", bound), std::to_string(seen), source, seen <= bound);
  }
  void at_least(std::string claim, std::uint64_t seen, std::uint64_t bound, const char* source) {
    check(std::move(claim), fmt::format(">= {}", bound), std::to_string(seen), source, seen >= bound);
  }

  lab::StudyResult result_;
};

}  // namespace

lab::StudyResult study_calipers(bool quick, const std::function<bool()>& go_on) {
  CaliperStudy study;
  for (const Row& row : kRows) {
    for (const int size : {8, 16, 32}) {
      if (size > 16 && quick) continue;
      if (!go_on()) return study.take();
      study.run(row, size);
    }
  }
  return study.take();
}

}  // namespace kinex::families
