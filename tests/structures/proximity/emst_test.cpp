// SPDX-License-Identifier: GPL-3.0-or-later
// The structures for the Euclidean minimum spanning tree, in one run over one triangulation: each is
// audited after every instant, and all report the same changes at the same instants.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace emst_test {

using Ids = std::vector<ObjectId>;
// The third one in clusters of the usual size, of one vertex and of two.
const std::vector<Request>& engines() {
  static const std::vector<Request> kAll = [] {
    std::vector<Request> all{ask("emst_list"), ask("emst_cycles"), ask("emst_clusters")};
    for (const int size : {1, 2}) all.push_back(ask("emst_clusters", "cluster", size));
    for (Request& request : all) {
      if (request.label.empty()) request.label = request.structure;
    }
    return all;
  }();
  return kAll;
}

// The external events of each structure, with the number of the instant.
class ByStructure final : public EventSink {
 public:
  explicit ByStructure(const Simulator& simulator) : log(simulator), simulator_(&simulator) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    log.event(event, arithmetic);
    all[event.structure].push_back(log.lines.back());
    if (!event.external) return;
    std::string line = std::to_string(simulator_->kernel().instant_number());
    for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
    external[event.structure].push_back(line);
  }
  LogSink log;
  std::map<StructureId, std::vector<std::string>> all, external;

 private:
  const Simulator* simulator_;
};

struct TreeRun {
  explicit TreeRun(Scene given, const std::string& arithmetic = "exact")
      : scene(asking(std::move(given))),
        simulator(scene, make_arithmetic(arithmetic, scene), Trial::options(AuditLevel::kEvents)),
        sink(simulator) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    begins_with = tree();
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
  }
  static Scene asking(Scene scene) {
    scene.maintain = engines();
    return scene;
  }
  // The triangulation is the first structure.
  const StructureLedger& ledger(int engine = 0) const {
    return simulator.ledger(static_cast<StructureId>(engine + 1));
  }
  Ids tree(int engine = 0) const {
    return simulator.structure(static_cast<StructureId>(engine + 1)).attribute().ids;
  }
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    const auto lines = [this](StructureId id) {
      const auto found = sink.external.find(id);
      return found == sink.external.end() ? std::vector<std::string>{} : found->second;
    };
    for (int engine = 0; engine < static_cast<int>(engines().size()); ++engine) {
      EXPECT_EQ(lines(1), lines(static_cast<StructureId>(engine + 1))) << engine;
      EXPECT_EQ(tree(), tree(engine)) << engine;
      EXPECT_EQ(ledger(engine).rebuilds, 0u);
      for (const BoundCheck& bound : simulator.bounds(static_cast<StructureId>(engine + 1))) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }

  Scene scene;
  Simulator simulator;
  ByStructure sink;
  Ids begins_with;
};

const std::pair<int, std::uint64_t> kScenes[] = {{6, 1}, {8, 1}, {10, 2}, {12, 3}};

TEST(Emst, ReferenceCounts) {
  const std::uint64_t swaps[] = {7, 14, 22, 20};
  for (std::size_t i = 0; i < 4; ++i) {
    if (kSanitized && kScenes[i].first > 8) break;
    SCOPED_TRACE(kScenes[i].first);
    const Scene scene = reference_scene(kScenes[i].first, 2, kScenes[i].second);
    const TreeRun run(scene);
    EXPECT_EQ(run.ledger(0).external, swaps[i]);
    EXPECT_EQ(run.ledger(1).external, swaps[i]);
    EXPECT_GE(run.ledger(1).failures, swaps[i]);
    EXPECT_LT(run.ledger(1).failures, run.ledger(0).failures);
    if (kScenes[i].first > 8) continue;
    EXPECT_EQ(run.sink.log.lines, TreeRun(scene, "sturm").sink.log.lines);
  }
}

TEST(SlowEmst, ReferenceCountsInSturm) {
  for (const std::size_t i : {2u, 3u}) {
    SCOPED_TRACE(kScenes[i].first);
    const Scene scene = reference_scene(kScenes[i].first, 2, kScenes[i].second);
    EXPECT_EQ(TreeRun(scene).sink.log.lines, TreeRun(scene, "sturm").sink.log.lines);
  }
}

TEST(Emst, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    if (kSanitized && degree > 2) break;
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : degree == 1 ? 4u : 1u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 9, 2, degree, seed % 2 == 0);
      const TreeRun run(scene), twin(scene, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, kSanitized ? 10u : 30u);
  EXPECT_GT(updates, kSanitized ? 5u : 20u);
}

// Points of {0, 1, 2}^2 with velocities in {-1, 0, 1}^2: most instants are degenerate.
void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0, shared = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const TreeRun run(lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2));
    external += run.ledger().external;
    shared += run.simulator.ledger(0).simultaneous_groups;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds));
  EXPECT_GT(shared, test::seen_in_fewer(seeds) / 2);
}

TEST(Emst, TinyLattices) { on_lattices(60); }

TEST(SlowEmst, TinyLattices) { on_lattices(500); }

TEST(Emst, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    const TreeRun run(scene);
    EXPECT_EQ(run.tree(0).size(), n < 2 ? 0u : 2u * static_cast<std::size_t>(n - 1));
    EXPECT_EQ(run.tree(0), run.tree(1));
  }
}

TEST(Emst, FromNothingToNothing) {
  const Scene scene = from_nothing_to_nothing();
  const TreeRun run(scene);
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.tree(0), Ids{});
  EXPECT_EQ(run.tree(1), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
  EXPECT_EQ(run.ledger().erasures, 7u);
}

// Identically equal lengths: Kruskal's algorithm takes the smaller ids first.
TEST(Emst, TiesGoToSmallerIds) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{i % 3, 1}, {i / 3, 2}}));
  const TreeRun run(scene_of(t, 0, Rational(5)));
  EXPECT_EQ(run.tree(), (Ids{0, 1, 0, 3, 1, 2, 1, 4, 2, 5, 3, 6, 4, 7, 5, 8}));
  EXPECT_EQ(run.ledger(0).external, 0u);
  // Identically equal points are a star around the smallest.
  const TreeRun all(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)));
  EXPECT_EQ(all.tree(), (Ids{0, 1, 0, 2, 0, 3}));
  EXPECT_EQ(all.tree(1), (Ids{0, 1, 0, 2, 0, 3}));
}

TEST(Emst, PointsMeetAndJump) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{9}, {3}}), path({{2}, {8}}),
                          path({{8, -1}, {2}}), path({{0, 1}, {2}})},
                         0, Rational(8));
  jump(scene, 2, 1, path({{2}, {7}}));
  const TreeRun run(scene);
  EXPECT_EQ(run.tree(0), run.tree(1));
  // All points pass through one at t = 0.
  std::vector<Trajectory> t;
  for (int i = 0; i < 8; ++i) t.push_back(path({{0, (i * 7) % 12 - 6}, {0, (i * 5) % 12 - 5}}));
  const TreeRun meet(scene_of(t, -1, Rational(1)));
  EXPECT_EQ(meet.begins_with, meet.tree());
  EXPECT_EQ(meet.ledger().external, 0u);
}

TEST(Emst, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TreeRun run(in_units_of(size));
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(Emst, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(3u); ++seed) {
      const TreeRun flights(random_flights(seed, 9, 2, 1, seed % 2 == 0), arithmetic);
      const TreeRun lattice(lattice_scene(seed, 8, 2), arithmetic);
      EXPECT_TRUE(flights.ledger().corrupt || flights.tree().size() <= 16) << arithmetic;
    }
  }
}

}  // namespace emst_test
}  // namespace kinex::test
