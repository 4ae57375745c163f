// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate fails at the very instant at which a run ends, pauses or loses an object, and others are made
// there.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {
namespace failure_at_the_end_test {

// (t - root) (-1 - t - .. - t^(degree - 1)), and a polynomial of the degree `other` that is -1 at the root.
std::vector<Rational> with_root(const Rational& root, int degree) {
  std::vector<Rational> c(static_cast<std::size_t>(degree) + 1, Rational(0));
  for (int k = 0; k < degree; ++k) {
    c[static_cast<std::size_t>(k) + 1] -= Rational(1);
    c[static_cast<std::size_t>(k)] += root;
  }
  return c;
}

std::vector<Rational> minus_one_at(const Rational& root, int degree) {
  std::vector<Rational> c(static_cast<std::size_t>(degree) + 1, Rational(0));
  c.back() = Rational(1);
  Rational power(1);
  for (int k = 0; k < degree; ++k) power *= root;
  c[0] = -power - Rational(1);
  return c;
}

// The second point reaches the level of the first one at the root.
Scene reaching(const Rational& root, int degree, int other) {
  return scene_of({path({{0}, {0}}), path({with_root(root, degree), minus_one_at(root, other)})}, 0,
                  root);
}

TEST(FailureAtTheEnd, OfAnyDegreeAtAnyNumber) {
  for (const Rational& root :
       {Rational(1), Rational(2), Rational(Integer(1), Integer(2)),
        Rational(Integer(1), Integer(3)), Rational(Integer(3), Integer(8))}) {
    for (int degree = 1; degree <= 5; ++degree) {
      for (int other = 1; other <= 6; ++other) {
        SCOPED_TRACE(root.to_string() + ", degrees " + std::to_string(degree) + " and " +
                     std::to_string(other));
        const Scene scene = reaching(root, degree, other);
        const TwinRun exact(scene, {ask("octants_local"), ask("octants_listed")});
        const TwinRun sturm(scene, {ask("octants_local"), ask("octants_listed")}, "sturm");
        EXPECT_GT(exact.ledger(0).failures, 0u);
        EXPECT_EQ(exact.changes(0), sturm.changes(0));
        // The first point leaves then.
        Scene leaving = scene;
        leaving.end = root + Rational(1);
        leaving.objects[0].motion.pieces[0].to = root;
        const TwinRun left(leaving, {ask("octants_local"), ask("octants_listed")});
      }
    }
  }
}

// All three points are on one line at the end: triangulations are built anew there.
std::vector<ObjectId> attribute_at_the_end(const Scene& scene, const std::string& arithmetic) {
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene),
                      Trial::options(AuditLevel::kEvents));
  add_structures(simulator, scene);
  simulator.start();
  simulator.run_until(std::nullopt);
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  const StructureId last = static_cast<StructureId>(simulator.structures() - 1);
  EXPECT_GT(simulator.ledger(0).failures, 0u);
  return simulator.structure(last).attribute().ids;
}

TEST(FailureAtTheEnd, OfTriangulationsAndTrees) {
  const Scene scene = scene_of({path({{3, -4, 2}, {-1, -1}}),
                                path({{-2, 3, -1}, {2, 2, -2, -2, -1}}), path({{-1}, {-2, 2}})},
                               0, Rational(1));
  for (const char* structure :
       {"delaunay_2", "closest_pair_delaunay", "emst_list", "emst_cycles"}) {
    SCOPED_TRACE(structure);
    const Scene asking = TwinRun::asking(scene, {ask(structure)});
    EXPECT_EQ(attribute_at_the_end(asking, "exact"), attribute_at_the_end(asking, "sturm"));
  }
}

}  // namespace failure_at_the_end_test
}  // namespace kinex::test
