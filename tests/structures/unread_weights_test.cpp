// SPDX-License-Identifier: GPL-3.0-or-later
// Weights that no structure reads are not kept: whatever their size, denominator and degree, a run has the
// same events, the same work and as many bytes of numbers as without them.
#include <string>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace unread_weights_test {

// Beyond the doubles, with large denominators, of a higher degree than the positions.
Scene with_heavy_weights(Scene scene) {
  scene.extents = Extents::kWeight;
  std::int64_t k = 0;
  for (SceneObject& object : scene.objects) {
    ++k;
    const Rational weight =
        *Rational::parse("1e400") * Rational(Integer(k), Integer(1000003 * k + 2));
    for (MotionPiece& piece : object.motion.pieces) {
      piece.trajectory.coordinates.resize(static_cast<std::size_t>(scene.dimension));
      piece.trajectory.coordinates.push_back({weight, Rational(1), weight, Rational(-k)});
    }
  }
  return scene;
}

struct Outcome {
  Outcome(const Scene& scene, const std::string& arithmetic)
      : simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(AuditLevel::kEnd)),
        sink(simulator) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
  }
  Simulator simulator;
  LogSink sink;
};

void expect_unread(const Scene& plain, const std::string& arithmetic) {
  const Outcome without(plain, arithmetic), with(with_heavy_weights(plain), arithmetic);
  EXPECT_EQ(without.sink.lines, with.sink.lines);
  EXPECT_EQ(without.simulator.violations(), with.simulator.violations());
  const Arithmetic &a = without.simulator.arithmetic(), &b = with.simulator.arithmetic();
  EXPECT_EQ(a.needs().axes, b.needs().axes);
  EXPECT_EQ(a.needs().degree, b.needs().degree);
  EXPECT_EQ(a.bytes(), b.bytes());
  EXPECT_EQ(a.counters().polynomials_solved, b.counters().polynomials_solved);
  EXPECT_EQ(a.counters().roots_made_exact, b.counters().roots_made_exact);
  EXPECT_EQ(a.counters().max_bits, b.counters().max_bits);
  EXPECT_EQ(a.counters().comparisons, b.counters().comparisons);
}

// Of every structure of points that does not read weights.
TEST(UnreadWeights, CostNothing) {
  int runs = 0;
  std::size_t number = 0;
  for (const int dimension : {1, 2, 3}) {
    Scene scene = random_flights(3, 7, dimension, 1, true);
    for (const StructureInfo& info : structure_infos()) {
      if (info.usual_extents() != Extents::kNone || info.graph || info.bodies) continue;
      const std::string name(info.name);
      scene.maintain = {Request{name, name, {}}};
      if (refusal_of(info, with_heavy_weights(scene))) continue;
      for (const char* arithmetic : {"exact", "sturm", "double", "gsl", "mpfr:60"}) {
        if (kSanitized && ++number % 3 != 0) continue;
        SCOPED_TRACE(name + " in " + arithmetic + ", " + std::to_string(dimension) + " axes");
        expect_unread(scene, arithmetic);
        ++runs;
      }
    }
  }
  EXPECT_GT(runs, kSanitized ? 80 : 250);
}

// One structure that reads them is enough.
TEST(UnreadWeights, AreKeptForTheStructureThatReadsThem) {
  Scene scene = with_heavy_weights(random_flights(3, 7, 2, 1, true));
  scene.maintain = {Request{"delaunay_2", "delaunay_2", {}}};
  const NumberNeeds unread = plan_numbers(scene);
  EXPECT_EQ(unread.axes, 2);
  EXPECT_EQ(unread.degree, 1);
  scene.maintain.push_back(Request{"regular_2", "regular_2", {}});
  const NumberNeeds read = plan_numbers(scene);
  EXPECT_EQ(read.axes, 3);
  EXPECT_EQ(read.degree, 3);
}

}  // namespace unread_weights_test
}  // namespace kinex::test
