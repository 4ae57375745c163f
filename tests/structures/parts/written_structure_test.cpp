// SPDX-License-Identifier: GPL-3.0-or-later
// The structure of structures/README.md, "Writing a structure": its blocks are compiled as they
// stand there (tests/CMakeLists.txt cuts them out), and run: the class, its drawing and checks, its
// descriptor.
#include <map>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/engine/simulator.h"
#include "core/engine/structure.h"
#include "predicates/predicates.h"
#include "structures/parts/descriptor.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"
#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace written_structure_test {

#include "block_1.inc"
#include "block_2.inc"

struct Left {
  explicit Left(Scene given, const std::string& arithmetic = "exact")
      : scene(std::move(given)),
        simulator(scene, make_arithmetic(arithmetic, scene), Trial::options(AuditLevel::kEvents)),
        sink(simulator) {
    const StructureId id = simulator.reserve();
    simulator.add(id, std::make_unique<LeftOfFirst>(simulator.kernel(), id, scene), "left");
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (const BoundCheck& bound : simulator.bounds(0)) EXPECT_TRUE(bound.holds) << bound.id;
  }
  std::vector<ObjectId> ids() const { return simulator.structure(0).attribute().ids; }
  Scene scene;
  Simulator simulator;
  LogSink sink;
};

TEST(WrittenStructure, LinesCrossOnce) {
  std::vector<Trajectory> t{path({{0}})};
  for (int i = 1; i < 9; ++i) t.push_back(path({{-i, 1}}));
  const Left run(scene_of(t, 0, Rational(100)));
  EXPECT_EQ(run.sink.lines.size(), 8u);
  EXPECT_EQ(run.sink.lines[2], "left cross 3 !");
  EXPECT_EQ(run.ids(), std::vector<ObjectId>{});
  EXPECT_EQ(run.simulator.ledger(0).external, 8u);
  EXPECT_EQ(run.simulator.ledger(0).parts.at(0).failures, 8u);
}

// Audited after every instant: flight plans, ties, objects that come and go.
TEST(WrittenStructure, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
      Scene scene = random_flights(seed, 9, 1, degree, seed % 2 == 0);
      scene.objects[0].motion.pieces = {{std::nullopt, std::nullopt, path({{0, 1}})}};
      const Left run(scene), twin(scene, "sturm");
      EXPECT_EQ(run.sink.lines, twin.sink.lines);
      external += run.simulator.ledger(0).external;
      updates += run.simulator.ledger(0).motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(80u));
  EXPECT_GT(updates, test::seen_in_fewer(50u));
}

// Every live certificate once, each in a group of its own.
TEST(WrittenStructure, ShowsItsProof) {
  class Counter final : public ProofVisitor {
   public:
    void group(const ProofGroup& group) override { groups.push_back(group.about); }
    void certificate(CertificateId id, std::string_view) override { certificates.push_back(id); }
    std::vector<std::vector<ObjectId>> groups;
    std::vector<CertificateId> certificates;
  };
  const Left run(scene_of({path({{0}}), path({{-1, 1}}), path({{2}})}, 0, Rational(9)));
  Counter counter;
  run.simulator.structure(0).visit_proof(counter);
  EXPECT_EQ(counter.groups, (std::vector<std::vector<ObjectId>>{{1}, {2}}));
  ASSERT_EQ(counter.certificates.size(), 2u);
  EXPECT_NE(counter.certificates[0], counter.certificates[1]);
  EXPECT_EQ(run.simulator.ledger(0).live, 2u);
}

TEST(WrittenStructure, ItsAuditNamesTheObject) {
  const Left run(scene_of({path({{0}}), path({{-1, 1}}), path({{2}})}, 0, Rational(9)));
  Snapshot moved(Rational(9), 1, 1, 3);
  for (const ObjectId a : {0u, 1u, 2u})
    moved.set(a, 0, Rational(a == 2 ? -1 : static_cast<int>(a)));
  AuditReport report;
  run.simulator.structure(0).audit(moved, report);
  EXPECT_EQ(report.violations, std::vector<std::string>{"object 2 is on the other side"});
}

TEST(WrittenStructure, ItsDescriptorMakesItAndKnowsItsEvents) {
  const StructureInfo info = left_of_first();
  const Scene scene = scene_of({path({{0}}), path({{-1, 1}})}, 0, Rational(3));
  Simulator simulator(scene, make_arithmetic("exact", scene), {});
  const StructureId id = simulator.reserve();
  const Request request{std::string(info.name), "left", {}};
  const auto structure = info.make({request, scene, simulator.kernel(), id, {}});
  EXPECT_EQ(structure->name(), info.name);
  EXPECT_EQ(structure->attribute().shape, info.shape);
  std::vector<std::string_view> kinds;
  for (const KindRule& rule : info.kinds) kinds.push_back(rule.kind);
  EXPECT_EQ(structure->event_kinds(), common_event_kinds(kinds));
}

// Without a first object, or with one that comes late, goes, or is away for a while.
TEST(WrittenStructure, ItsDescriptorRefusesScenesWithoutAFirstObject) {
  const auto refused = [](const Scene& scene) { return left_of_first().refuse(scene).has_value(); };
  const Scene two = scene_of({path({{0}}), path({{1}})}, 0, Rational(3));
  EXPECT_FALSE(refused(two));
  Scene none = two, late = two, goes = two, pauses = two;
  none.objects.clear();
  EXPECT_TRUE(refused(none));
  late.objects[0].motion.pieces[0].from = Rational(1);
  EXPECT_TRUE(refused(late));
  goes.objects[0].motion.pieces[0].to = Rational(3);
  EXPECT_TRUE(refused(goes));
  MotionPiece first = two.objects[0].motion.pieces[0], last = first;
  first.to = Rational(1);
  last.from = Rational(1);
  pauses.objects[0].motion.pieces = {first, last};
  EXPECT_FALSE(refused(pauses));
  pauses.objects[0].motion.pieces[1].from = Rational(2);
  EXPECT_TRUE(refused(pauses));
}

TEST(WrittenStructure, TheFirstObjectStays) {
  Scene scene = scene_of({path({{0}}), path({{1}})}, 0, Rational(3));
  scene.objects[0].motion.pieces[0].to = Rational(1);
  Simulator simulator(scene, make_arithmetic("exact", scene), {});
  const StructureId id = simulator.reserve();
  simulator.add(id, std::make_unique<LeftOfFirst>(simulator.kernel(), id, scene), "left");
  simulator.start();
  EXPECT_THROW(simulator.run_until(std::nullopt), std::invalid_argument);
}

}  // namespace written_structure_test
}  // namespace kinex::test
