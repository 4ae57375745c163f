// SPDX-License-Identifier: GPL-3.0-or-later
// Structures over one hull share one calipers_2: the same values at the same instants as alone, and
// the certificates of the calipers are paid for once.
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/calipers_support.h"

namespace kinex::test {
namespace shared_calipers_test {

// All that is maintained, audited after every instant; the attribute of each structure after each
// of its changes.
class TogetherRun {
 public:
  TogetherRun(Scene given, std::vector<Request> requests, const std::string& arithmetic = "exact")
      : scene_(asking_all(std::move(given), std::move(requests))),
        simulator_(scene_, planned_arithmetic(arithmetic, scene_),
                   Trial::options(AuditLevel::kEvents)),
        sink_(*this) {
    add_structures(simulator_, scene_);
    simulator_.set_sink(&sink_);
    simulator_.start();
    simulator_.run_until(std::nullopt);
    if (!simulator_.kernel().is_exact()) return;
    EXPECT_EQ(simulator_.violations(), std::vector<std::string>{});
    EXPECT_LE(sink_.most, 1) << "external events of one structure at one instant";
    for (StructureId id = 0; id < simulator_.structures(); ++id) {
      if (is_below(id)) continue;
      EXPECT_EQ(simulator_.ledger(id).rebuilds, 0u);
      for (const BoundCheck& bound : simulator_.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }
  TogetherRun(const TogetherRun&) = delete;
  TogetherRun& operator=(const TogetherRun&) = delete;

  StructureId id(const std::string& label) const {
    for (StructureId id = 0; id < simulator_.structures(); ++id) {
      if (simulator_.label(id) == label) return id;
    }
    ADD_FAILURE() << "there is no " << label;
    return 0;
  }
  // Those of this name in the plan.
  std::vector<StructureId> all(const std::string& name) const {
    std::vector<StructureId> result;
    for (StructureId id = 0; id < simulator_.structures(); ++id) {
      if (simulator_.structure(id).name() == name) result.push_back(id);
    }
    return result;
  }
  // The hull, and what it is read from, have several events at one instant.
  bool is_below(StructureId id) const {
    const std::string_view name = simulator_.structure(id).name();
    return name == "delaunay_2" || name.starts_with("convex_hull_2");
  }
  Ids ids(const std::string& label) const {
    return simulator_.structure(id(label)).attribute().ids;
  }
  std::vector<BoundCheck> bounds(const std::string& label) const {
    return simulator_.bounds(id(label));
  }
  const StructureLedger& ledger(StructureId id) const { return simulator_.ledger(id); }
  std::vector<std::string> values(const std::string& label) const {
    const auto found = sink_.values.find(id(label));
    return found == sink_.values.end() ? std::vector<std::string>{} : found->second;
  }

 private:
  static Scene asking_all(Scene scene, std::vector<Request> requests) {
    scene.maintain = std::move(requests);
    return scene;
  }

  class Sink final : public EventSink {
   public:
    explicit Sink(TogetherRun& run) : run_(&run) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (!event.external || run_->is_below(event.structure)) return;
      changed_[event.structure] = arithmetic.describe_now().approximate;
      most = std::max(most, ++count_[event.structure]);
    }
    void instant_ended() override {
      for (const auto& [id, time] : changed_) {
        std::string value = time + ":";
        for (const ObjectId object : run_->simulator_.structure(id).attribute().ids) {
          value += " " + std::to_string(object);
        }
        values[id].push_back(std::move(value));
      }
      changed_.clear();
      count_.clear();
    }
    std::map<StructureId, std::vector<std::string>> values;
    int most = 0;

   private:
    TogetherRun* run_;
    std::map<StructureId, std::string> changed_;
    std::map<StructureId, int> count_;
  };

  Scene scene_;
  Simulator simulator_;
  Sink sink_;
};

std::vector<Request> requests_for(const std::vector<std::string>& structures,
                                  const std::string& hull = "convex_hull_2") {
  std::vector<Request> requests;
  for (const std::string& structure : structures) requests.push_back(request_for(structure, hull));
  return requests;
}

// The folds of the calipers in the plan of a scene that asks for these.
std::vector<int> planned_folds(const std::vector<Request>& requests) {
  Scene scene = remainders(4);
  scene.maintain = requests;
  std::vector<int> folds;
  for (const PlannedStructure& planned : plan_structures(scene)) {
    if (planned.request.structure != "calipers_2") continue;
    const StructureInfo& info = *find_structure_info("calipers_2");
    folds.push_back(
        static_cast<int>(parameter_of(info, planned.request, "folds").numerator().to_int64()));
  }
  return folds;
}

TEST(SharedCalipers, ThePlan) {
  using Folds = std::vector<int>;
  for (const std::string& alone : kCaliperStructures) {
    EXPECT_EQ(planned_folds(requests_for({alone})), Folds{});
  }
  EXPECT_EQ(planned_folds(requests_for(kCaliperStructures)), Folds{4});
  EXPECT_EQ(planned_folds(requests_for({"diameter_2", "width_2"})), Folds{2});
  EXPECT_EQ(planned_folds(requests_for({"width_2", "min_area_rectangle_2"})), Folds{4});
  EXPECT_EQ(planned_folds(requests_for({"diameter_2", "calipers_2"})), Folds{2});
  EXPECT_EQ(planned_folds(requests_for({"calipers_2_4", "diameter_2"})), Folds{4});
  // A request for calipers of too few folds is maintained by itself.
  EXPECT_EQ(planned_folds(requests_for({"calipers_2", "min_area_rectangle_2"})), Folds{2});
  EXPECT_EQ(planned_folds(requests_for({"width_2", "calipers_2", "min_area_rectangle_2"})),
            (Folds{4, 2}));
  // Other hulls, other calipers.
  std::vector<Request> requests = requests_for({"diameter_2", "width_2"});
  requests[1] = request_for("width_2", "convex_hull_2_delaunay");
  EXPECT_EQ(planned_folds(requests), Folds{});
  requests.push_back(request_for("min_area_rectangle_2", "convex_hull_2_delaunay"));
  EXPECT_EQ(planned_folds(requests), Folds{4});
}

// One calipers_2 of 4 folds pays once for what the four structures pay each by themselves.
TEST(SharedCalipers, CertificatesArePaidForOnce) {
  for (const int n : {6, 8, 10}) {
    SCOPED_TRACE(n);
    const TogetherRun together(remainders(n), requests_for(kCaliperStructures));
    const std::vector<StructureId> calipers = together.all("calipers_2");
    ASSERT_EQ(calipers.size(), 1u);
    const StructureLedger& shared = together.ledger(calipers[0]);
    std::uint64_t created = 0, alone_created = 0, events = shared.failures, alone_events = 0;
    for (const std::string& structure : kCaliperStructures) {
      const CaliperRun alone(remainders(n), structure);
      const StructureLedger &mine = together.ledger(together.id(structure)), &own = alone.ledger();
      ASSERT_EQ(mine.parts.size(), 1u);  // the candidates
      ASSERT_EQ(own.parts.size(), 2u);
      EXPECT_EQ(own.parts[0].name, "calipers");
      EXPECT_EQ(mine.parts[0].failures, own.parts[1].failures);
      EXPECT_EQ(mine.external, own.external);
      created += mine.certificates_created;
      alone_created += own.certificates_created;
      events += mine.failures;
      alone_events += own.failures;
      // The calipers of a rectangle alone are those that are shared.
      if (structure != "min_area_rectangle_2") continue;
      EXPECT_EQ(shared.failures, own.parts[0].failures);
      EXPECT_EQ(shared.certificates_created, own.parts[0].created);
      EXPECT_EQ(shared.max_live, own.parts[0].max_live);
    }
    created += shared.certificates_created;
    EXPECT_LT(created, alone_created);
    EXPECT_LT(events, alone_events);
  }
}

// Points on a parabola, whose hull stays what it is; some get new plans, one after the other.
Scene new_plans_on_a_parabola() {
  std::vector<Trajectory> t;
  for (int i = 0; i < 12; ++i) t.push_back(path({{i}, {i * i}}));
  Scene scene = scene_of(t, 0, Rational(8));
  for (const int i : {2, 5, 7, 10, 11}) {
    const Rational at = quotient(i, 2);
    auto& pieces = scene.objects[static_cast<std::size_t>(i)].motion.pieces;
    pieces[0].to = at;
    pieces.push_back({at, std::nullopt, path({{i}, {Rational(i * i) + at / Rational(100), quotient(-1, 100)}})});
  }
  return scene;
}

// A new plan begins epochs of the duels that name the object, and of no node whose number a certificate
// of the calipers has for its tag: the bound on the duels is the same without calipers of its own.
TEST(SharedCalipers, NewPlansBeginTheSameEpochs) {
  const Scene scene = new_plans_on_a_parabola();
  const auto duels = [](const std::vector<BoundCheck>& bounds, const std::string& structure) {
    for (const BoundCheck& bound : bounds) {
      if (bound.id == structure + ".duels") return bound.bound;
    }
    ADD_FAILURE() << "no bound on the duels of " << structure;
    return Integer(0);
  };
  for (const std::string& hull : kHulls) {
    const TogetherRun together(scene, requests_for(kCaliperStructures, hull));
    for (const std::string& structure : kCaliperStructures) {
      SCOPED_TRACE(structure + " over " + hull);
      const CaliperRun alone(scene, structure, hull);
      EXPECT_EQ(duels(alone.simulator.bounds(alone.id), structure),
                duels(together.bounds(structure), structure));
    }
  }
}

// Values and instants of change are those of each structure alone, whatever the hull.
void expect_values_of_each_alone(std::uint64_t first, std::uint64_t last) {
  std::uint64_t changes = 0;
  for (std::uint64_t seed = first; seed <= first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = seed % 3 != 0 ? caliper_lattice(seed, seed % 10 == 5 ? 2 : 1)
                                      : random_flights(seed, 7, 2, 1, seed % 2 == 0);
    const std::string& hull = kHulls[seed % kHulls.size()];
    const TogetherRun together(scene, requests_for(kAllCaliperStructures, hull));
    EXPECT_EQ(together.all("calipers_2").size(), 2u);  // both are asked for
    for (const std::string& structure : kAllCaliperStructures) {
      SCOPED_TRACE(structure + " over " + hull);
      const CaliperRun alone(scene, structure, hull);
      EXPECT_EQ(together.values(structure), alone.values());
      EXPECT_EQ(together.ids(structure), alone.ids());
      changes += alone.values().size();
    }
  }
  EXPECT_GT(changes, 8 * (test::seen_in_fewer(last - first) + 1));
}

TEST(SharedCalipers, TheSameValuesAsAlone) { expect_values_of_each_alone(1, 12); }
TEST(SlowSharedCalipers, TheSameValuesAsAlone) { expect_values_of_each_alone(13, 170); }

TEST(SharedCalipers, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      const Scene scene =
          seed % 2 == 0 ? caliper_lattice(seed) : random_flights(seed, 8, 2, 2, true);
      const TogetherRun run(scene, requests_for(kCaliperStructures, kHulls[seed % kHulls.size()]),
                            arithmetic);
    }
  }
}

}  // namespace shared_calipers_test
}  // namespace kinex::test
