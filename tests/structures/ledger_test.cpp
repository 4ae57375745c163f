// SPDX-License-Identifier: GPL-3.0-or-later
// The counts of a run: by hand where possible, and the sums that must always agree.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/hull/hull_support.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace ledger_test {

const ArithmeticCounters& numbers(const Trial& run) {
  return run.simulator.arithmetic().counters();
}

template <class Counts>
std::uint64_t sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void expect_sums(const ChangeStatistics& changes, std::uint64_t processed) {
  EXPECT_EQ(changes.events, processed);
  EXPECT_EQ(sum(changes.histogram), processed);
  std::uint64_t weighted = 0, largest = 0;
  for (std::uint64_t k = 0; k < changes.histogram.size(); ++k) {
    weighted += k * changes.histogram[k];
    if (changes.histogram[k] != 0) largest = k;
  }
  if (largest + 1 < changes.histogram.size()) {  // nothing in the bin for all the rest
    EXPECT_EQ(weighted, changes.total);
    EXPECT_EQ(largest, changes.max);
  } else {
    EXPECT_GE(changes.total, weighted);
    EXPECT_GE(changes.max, largest);
  }
}

// The lines of the parts add up. (Those of a corrupt structure end where it was cleared.)
void expect_parts(const StructureLedger& l) {
  if (l.parts.empty() || l.corrupt) return;
  PartLedger all;
  for (const PartLedger& part : l.parts) {
    EXPECT_EQ(part.live, part.created - part.retracted) << part.name;
    all.failures += part.failures;
    all.created += part.created;
    all.retracted += part.retracted;
  }
  EXPECT_EQ(all.failures, l.failures);
  EXPECT_EQ(all.created, l.certificates_created);
  EXPECT_EQ(all.retracted, l.certificates_retracted);
}

void expect_sums(const Trial& run) {
  const StructureLedger& l = run.ledger();
  expect_parts(l);
  EXPECT_EQ(l.processed, l.external + l.internal);
  EXPECT_EQ(l.live, l.certificates_created - l.certificates_retracted);
  EXPECT_GE(l.max_live, l.live);
  EXPECT_LE(l.max_per_object, l.max_live);
  expect_sums(l.created_per_event, l.failures);
  expect_sums(l.retracted_per_event, l.failures);
  EXPECT_LE(l.created_per_event.total, l.certificates_created);
  EXPECT_LE(l.retracted_per_event.total, l.certificates_retracted);
  std::uint64_t kinds = 0;
  for (const auto& [kind, count] : l.by_kind) kinds += count;
  EXPECT_EQ(kinds, run.sink.lines.size());
  EXPECT_EQ(run.simulator.ledger().events, l.failures);
  EXPECT_LE(l.internal, l.failures);
  EXPECT_LE(l.largest_group, l.failures);
  EXPECT_LE(2 * l.simultaneous_groups, l.failures);
  EXPECT_LE(run.simulator.ledger().max_queue, l.max_live);
  EXPECT_GT(run.simulator.ledger().peak_bytes, 0u);
  // A certificate's failure time is computed when it is made, and when a motion changes.
  std::uint64_t failures = 0;
  for (const PredicateCounters& p : numbers(run).by_predicate) failures += sum(p.failures);
  EXPECT_GE(failures, l.certificates_created);
  const bool looks_ahead = run.simulator.label(0).find("envelope") != std::string::npos;
  if (l.motion_updates == 0 && !looks_ahead) {
    EXPECT_EQ(failures, l.certificates_created);
  }
  // All but those of polynomials that are zero.
  EXPECT_LE(sum(numbers(run).polynomials_solved), failures);
}

TEST(Ledger, ByHand) {
  // Two that meet: one certificate, replaced once.
  const Scene two = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(2));
  Trial a(two, "sorted_list");
  a.to_end();
  EXPECT_EQ(a.ledger().processed, 1u);
  EXPECT_EQ(a.ledger().external, 1u);
  EXPECT_EQ(a.ledger().certificates_created, 2u);
  EXPECT_EQ(a.ledger().certificates_retracted, 1u);
  EXPECT_EQ(a.ledger().live, 1u);
  EXPECT_EQ(a.ledger().max_live, 1u);
  EXPECT_EQ(a.ledger().max_per_object, 1u);
  EXPECT_EQ(a.ledger().created_per_event.histogram[1], 1u);
  EXPECT_EQ(a.ledger().efficiency(), 1.0);
  EXPECT_EQ(a.simulator.ledger().max_queue, 1u);
  EXPECT_EQ(numbers(a).polynomials_solved, (std::vector<std::uint64_t>{0, 2}));
  EXPECT_EQ(numbers(a).by_predicate.size(), 1u);
  EXPECT_EQ(sum(numbers(a).by_predicate[0].failures), 2u);
  EXPECT_EQ(sum(numbers(a).comparisons), 0u);

  // Three lines: three swaps, each renews both certificates.
  const Scene three = steep_lines(3);
  Trial b(three, "sorted_list");
  b.to_end();
  EXPECT_EQ(b.ledger().created_per_event.histogram[2], 3u);
  EXPECT_EQ(b.ledger().created_per_event.total, 6u);
  EXPECT_EQ(b.ledger().retracted_per_event.histogram[2], 3u);
  EXPECT_EQ(b.ledger().retracted_per_event.total, 6u);
  EXPECT_EQ(b.ledger().certificates_created, 8u);
  EXPECT_EQ(b.ledger().max_per_object, 2u);

  // 0 wins at 1 and loses again at 2.
  const Scene touch = scene_of({path({{0, 3, -1}}), path({{2}})}, 0, Rational(3));
  Trial c(touch, "maximum_tournament");
  c.to_end();
  EXPECT_EQ(c.ledger().processed, 2u);
  EXPECT_EQ(c.ledger().external, 2u);
  EXPECT_EQ(numbers(c).polynomials_solved, (std::vector<std::uint64_t>{0, 0, 3}));

  // Internal: 2 and 3 change places below 0.
  const Scene below =
      scene_of({path({{9}}), path({{8}}), path({{0, 1}}), path({{1}})}, 0, Rational(3));
  Trial d(below, "maximum_tournament");
  d.to_end();
  EXPECT_EQ(d.ledger().processed, 1u);
  EXPECT_EQ(d.ledger().internal, 1u);
  EXPECT_EQ(d.ledger().efficiency(), 0.0);
  EXPECT_EQ(d.ledger().by_kind.at("replace"), 1u);
}

TEST(Ledger, SimultaneousGroups) {
  // Three through one point at 1, and two pairs of others at 1: five swaps at one instant.
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2, -1}}), path({{10, 1}}),
                                path({{11}}), path({{20, 1}}), path({{21}})},
                               0, Rational(2));
  Trial run(scene, "sorted_list");
  run.to_end().expect_clean();
  EXPECT_EQ(run.ledger().processed, 5u);
  EXPECT_EQ(run.ledger().simultaneous_groups, 1u);
  EXPECT_EQ(run.ledger().largest_group, 5u);
  EXPECT_EQ(run.simulator.ledger().instants, 1u);
  expect_sums(run);
}

TEST(Ledger, SumsAgree) {
  for (const StructureInfo& info : structure_infos()) {
    if (info.bodies) continue;
    if (!info.reads.empty()) continue;  // no certificates
    for (const char* arithmetic : {"exact", "sturm"}) {
      for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : 4u); ++seed) {
        SCOPED_TRACE(std::string(info.name) + " in " + arithmetic + ", seed " +
                     std::to_string(seed));
        const int degree = info.linear() ? 1 : 1 + static_cast<int>(seed % 2);
        const int dimension = std::max(2, info.min_dimension);
        const Scene scene =
            suited(random_flights(seed, 7, dimension, degree, seed % 2 == 0), info);
        Trial run(scene, std::string(info.name), arithmetic, AuditLevel::kEnd);
        run.to_end();
        expect_sums(run);
        Random random(seed);
        std::vector<Trajectory> paths;
        for (int i = 0; i < 8; ++i) paths.push_back(random.small_path(2, degree, 50));
        const Scene plain = suited(scene_of(paths, -1, Rational(1)), info);
        Trial other(plain, std::string(info.name), arithmetic, AuditLevel::kEnd);
        other.to_end();
        expect_sums(other);
      }
    }
  }
}

// The number of events of each structure that a log marks as external.
class ExternalSink final : public EventSink {
 public:
  void event(const Event& event, Arithmetic&) override {
    counts.resize(std::max<std::size_t>(counts.size(), event.structure + std::size_t{1}));
    if (!event.external) return;
    ++counts[event.structure];
    if (event.certificate.arity == 0) ++late;
  }
  std::vector<std::uint64_t> counts;
  std::uint64_t late = 0;  // those without a failure of the structure's own
};

// The largest number of external events of the requested structure beyond its failures.
std::uint64_t expect_external_as_logged(Scene scene, const std::string& structure,
                                        const std::string& arithmetic) {
  scene.maintain = {{structure, structure, {}}};
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), {});
  add_structures(simulator, scene);
  ExternalSink sink;
  sink.counts.resize(simulator.structures());
  simulator.set_sink(&sink);
  simulator.start();
  simulator.run_until(std::nullopt);
  std::uint64_t failures = 0, beyond = 0;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& l = simulator.ledger(id);
    EXPECT_EQ(l.external, sink.counts[id]) << simulator.label(id);
    EXPECT_EQ(l.processed, l.external + l.internal) << simulator.label(id);
    EXPECT_LE(l.internal, l.failures) << simulator.label(id);
    expect_parts(l);
    EXPECT_TRUE(!l.parts.empty() || l.certificates_created == 0) << simulator.label(id);
    failures += l.failures;
    beyond = l.processed > l.failures ? l.processed - l.failures : 0;
  }
  EXPECT_EQ(failures, simulator.ledger().events);
  return beyond;
}

TEST(Ledger, ExternalEventsAreThoseThatTheLogMarks) {
  std::uint64_t beyond = 0;
  for (const StructureInfo& info : structure_infos()) {
    if (info.bodies) continue;
    for (const char* arithmetic : {"exact", "double"}) {
      SCOPED_TRACE(std::string(info.name) + " in " + arithmetic);
      const std::string name(info.name);
      const int degree = info.linear() ? 1 : 2;
      for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
        // Flight plans; many at one instant, some that last; ordinary scenes.
        std::vector<Scene> scenes{random_flights(seed, 7, 3, degree, seed % 2 == 0)};
        if (info.min_dimension < 3) {
          scenes = {random_flights(seed, 9, 2, degree, seed % 2 == 0), small_plane(8, seed, degree, 2),
                    random_plane(12, seed, degree)};
        }
        for (const Scene& scene : scenes) {
          beyond += expect_external_as_logged(suited(scene, info), name, arithmetic);
        }
      }
    }
  }
  EXPECT_GT(beyond,
            test::seen_in_fewer(100u));  // changes reported by no failure, or by one of several
}

// A point is identically between two others until a new motion takes it up or down. The divide and
// conquer hulls report the consequence when the instant is settled, after its failures.
TEST(Ledger, AChangeThatIsReportedWhenTheInstantIsSettledIsExternal) {
  for (const int way : {1, -1}) {
    Scene scene = scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{2}, {0}})}, 0, Rational(2));
    auto& pieces = scene.objects[2].motion.pieces;
    pieces[0].to = Rational(1);
    pieces.push_back({Rational(1), std::nullopt, path({{2}, {-way, way}})});
    for (const std::string& hull : kHulls) {
      SCOPED_TRACE(hull);
      scene.maintain = {{hull, hull, {}}};
      Simulator simulator(scene, make_arithmetic("exact", scene), {});
      add_structures(simulator, scene);
      const StructureId id = asked_structure(scene);
      ExternalSink sink;
      simulator.set_sink(&sink);
      simulator.start();
      simulator.run_until(std::nullopt);
      EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
      const StructureLedger& ledger = simulator.ledger(id);
      EXPECT_EQ(sink.counts.at(id), 1u);
      // The triangulation's edges too.
      const std::uint64_t late = hull == "convex_hull_2_delaunay" ? 2u : 1u;
      EXPECT_EQ(sink.late, hull == "convex_hull_2_brute_force" ? 0u : late);
      EXPECT_EQ(ledger.external, 1u);
      EXPECT_EQ(ledger.internal, hull == "convex_hull_2_brute_force" ? 0 : ledger.failures);
      EXPECT_EQ(ledger.processed, 1 + ledger.internal);
    }
  }
}

TEST(Ledger, CountsBitsAndStages) {
  const Scene scene = scene_of({path({{0, 1, 1}}), path({{3}}), path({{7, -1}})}, 0, Rational(9));
  Trial run(scene, "sorted_list", "sturm");
  run.to_end();
  const ArithmeticCounters& counters = numbers(run);
  EXPECT_GE(counters.max_bits, 3u);
  EXPECT_EQ(counters.polynomials_solved.size(), 3u);
  for (const PredicateCounters& p : counters.by_predicate) {
    EXPECT_EQ(sum(p.signs), p.signs[static_cast<int>(Stage::kExact)]);
    EXPECT_EQ(sum(p.failures), p.failures[static_cast<int>(Stage::kExact)]);
  }
}

}  // namespace ledger_test
}  // namespace kinex::test
