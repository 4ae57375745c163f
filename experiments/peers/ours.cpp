// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "core/engine/simulator.h"
#include "experiments/families/collision/polygons.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/peers/truth.h"
#include "structures/collision/collision_pairs.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::peers {

namespace {

class FirstContact final : public EventSink {
 public:
  void event(const Event& event, Arithmetic& arithmetic) override {
    if (event.kind == CollisionEvent::kContact && !time) time = arithmetic.now_approximate();
  }
  std::optional<double> time;
};

}  // namespace

Scene orbit_scene(const PeerCase& orbit) {
  Scene scene;
  scene.name = orbit.name;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = 1;
  const auto polygon = [](const PeerShape& shape) {
    std::vector<Vertex2> result;
    for (const auto& v : shape) {
      result.push_back({*Rational::from_double(v[0]), *Rational::from_double(v[1])});
    }
    return result;
  };
  const std::vector<families::RotorPiece> turn = families::half_turns(2, 1);
  families::add_turning_body(scene, "a", polygon(orbit.a), 0, 0, turn);
  families::add_turning_body(scene, "b", polygon(orbit.b), *Rational::from_double(orbit.frames[0].b.x), 0,
                   turn);
  return scene;
}

OurRun run_ours(const Scene& scene, const std::string& structure, const std::string& arithmetic,
                int looks) {
  OurRun result;
  Scene asked = scene;
  asked.maintain = {{structure, structure, {}}};
  const double begin = lab::cpu_seconds();
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic(arithmetic, asked), options);
  const StructureId id = simulator.reserve();
  simulator.add(id, make_structure({structure, structure, {}}, scene, simulator.kernel(), id),
                structure);
  FirstContact sink;
  simulator.set_sink(&sink);
  simulator.start();
  // Bodies that overlap at the start report no contact.
  if (!simulator.structure(id).attribute().ids.empty()) sink.time = scene.start.to_double();
  const double built = lab::cpu_seconds();
  for (int i = 1; i <= looks && !sink.time; ++i) {
    simulator.run_until(scene.start + (*scene.end - scene.start) * Rational(i) / Rational(looks));
  }
  result.run_seconds = lab::cpu_seconds() - built;
  result.build_seconds = built - begin;
  result.contact = sink.time;
  const StructureLedger& ledger = simulator.ledger(id);
  const ArithmeticCounters& counters = simulator.arithmetic().counters();
  result.events = ledger.processed;
  result.roots = ledger.failures_found;
  for (const std::uint64_t count : counters.polynomials_solved) result.polynomials += count;
  for (const PredicateCounters& one : counters.by_predicate) {
    for (const std::uint64_t count : one.signs) result.signs += count;
  }
  return result;
}

}  // namespace kinex::peers
