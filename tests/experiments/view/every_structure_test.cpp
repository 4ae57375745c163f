// SPDX-License-Identifier: GPL-3.0-or-later
// A viewer looks at a proof whenever a call of its structure has returned, in the middle of an instant
// too: what every structure shows there is live and its own, and its run is recorded to the end.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/view/watched_structure.h"
#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/experiments/view/fixture.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace {

class LiveOnly final : public ProofVisitor {
 public:
  LiveOnly(const EventQueue& queue, StructureId structure) : queue_(queue), structure_(structure) {}
  void group(const ProofGroup&) override {}
  void certificate(CertificateId id, std::string_view) override {
    ++seen;
    wrong += id >= queue_.capacity() || !queue_.certificate(id).live ||
                     queue_.certificate(id).structure != structure_
                 ? 1
                 : 0;
  }
  std::size_t seen = 0, wrong = 0;

 private:
  const EventQueue& queue_;
  StructureId structure_;
};

// By structure of the plan: visits, certificates seen, those that were not live, and those that it has made.
struct Looks {
  std::string name;
  std::size_t visits = 0, seen = 0, wrong = 0, made = 0;
};

std::vector<Looks> look_after_every_call(const Scene& scene) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  const std::vector<PlannedStructure> plan = plan_structures(scene);
  std::vector<Looks> looks(plan.size());
  std::vector<const Structure*> made;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const StructureId id = simulator.reserve();
    std::vector<const Structure*> watched;
    for (const StructureId read : plan[i].watches) watched.push_back(made[read]);
    std::unique_ptr<Structure> structure = make_structure(
        plan[i].request, scene, simulator.kernel(), id, watched, plan[i].watches);
    const Structure* seen = structure.get();
    made.push_back(seen);
    looks[i].name = std::string(seen->name());
    const auto look = [&simulator, &looks, seen, i, id](bool) {
      LiveOnly visitor(simulator.queue(), id);
      seen->visit_proof(visitor);
      ++looks[i].visits;
      looks[i].seen += visitor.seen;
      looks[i].wrong += visitor.wrong;
    };
    simulator.add(id, std::make_unique<view::WatchedStructure>(std::move(structure), look),
                  plan[i].request.label, plan[i].watches, plan[i].members);
  }
  simulator.start();
  simulator.run_until(std::nullopt);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    looks[i].made = simulator.ledger(static_cast<StructureId>(i)).certificates_created;
  }
  return looks;
}

Scene asking(Scene scene, const StructureInfo& info) {
  scene.maintain = {{std::string(info.name), std::string(info.name), {}}};
  return scene;
}

// The first scene that the structure takes.
Scene scene_for(const StructureInfo& info, std::uint64_t seed) {
  std::vector<Scene> scenes;
  if (info.bodies) {
    scenes.push_back(workload("polygons-in-box", 4, "separation_mixed"));
    scenes.push_back(workload("polygon-approach", 8, "separation_mixed"));
  } else {
    for (const int dimension : {2, 3, 1}) {
      for (const int degree : {1 + static_cast<int>(seed % 2), 1}) {
        const int n = dimension == 2 ? 9 : 7;
        scenes.push_back(suited(random_flights(seed, n, dimension, degree, seed % 2 == 0), info));
      }
    }
  }
  for (Scene& scene : scenes) {
    if (!refusal_of(info, scene)) return asking(std::move(scene), info);
  }
  ADD_FAILURE() << "no scene suits " << info.name;
  return {};
}

TEST(EveryStructure, ShowsLiveCertificatesAfterEveryCall) {
  for (const StructureInfo& info : structure_infos()) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Scene scene = scene_for(info, seed);
      if (scene.objects.empty()) continue;
      for (const Looks& looks : look_after_every_call(scene)) {
        EXPECT_GT(looks.visits, 0u) << info.name;
        EXPECT_EQ(looks.seen > 0, looks.made > 0) << looks.name << ", with " << info.name << ", seed " << seed;
        EXPECT_EQ(looks.wrong, 0u) << looks.name << ", with " << info.name << ", seed " << seed;
      }
    }
  }
}

TEST(EveryStructure, IsRecordedToTheEnd) {
  for (const StructureInfo& info : structure_infos()) {
    const Scene scene = scene_for(info, 2);
    if (scene.objects.empty()) continue;
    const view::RecordedRun run = record(scene);
    EXPECT_TRUE(run.complete) << info.name << ": " << run.stopped;
    EXPECT_EQ(run.stopped, "") << info.name;
    for (const view::RecordedStructure& structure : run.structures) {
      EXPECT_FALSE(structure.corrupt_after) << info.name << ": " << structure.corruption;
    }
  }
}

}  // namespace
}  // namespace kinex::test
