// SPDX-License-Identifier: GPL-3.0-or-later
// The structure "outer_hierarchy": it builds, is audited and has bounds, but no events.
#include "structures/collision/outer_hierarchies.h"

#include <gtest/gtest.h>

#include "tests/sanitized.h"
#include "tests/structures/collision/body_polygons.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace outer_hierarchies_test {

SceneObject body(std::string id, Polygon polygon, int x) {
  SceneObject object;
  object.id = std::move(id);
  object.polygon = std::move(polygon);
  MotionPiece piece;
  piece.trajectory.coordinates = {
      {Rational(x), Rational(1)}, {Rational(0)}, {Rational(1)}, {Rational(0)}};
  object.motion.pieces.push_back(std::move(piece));
  return object;
}

Scene scene_of(std::vector<SceneObject> bodies) {
  Scene scene;
  scene.name = "bodies";
  scene.dimension = 2;
  scene.start = Rational(0);
  scene.end = Rational(1);
  scene.objects = std::move(bodies);
  return scene;
}

TEST(OuterHierarchies, BuildsAllPoliciesForEveryPolygon) {
  std::vector<SceneObject> bodies;
  const std::vector<NamedPolygon> zoo = polygon_zoo(kSanitized ? 8 : 20);
  for (const NamedPolygon& one : zoo) bodies.push_back(body(one.name, one.polygon, 0));
  bodies.push_back(body("the first again", zoo[0].polygon, 5));
  const Scene scene = scene_of(std::move(bodies));
  Trial trial(scene, "outer_hierarchy");
  trial.to_end();
  trial.expect_clean();
  EXPECT_TRUE(trial.sink.lines.empty());
  EXPECT_EQ(trial.ids().size(), scene.objects.size());
  const StructureLedger& ledger = trial.simulator.ledger(0);
  EXPECT_EQ(ledger.certificates_created, 0u);
  EXPECT_GT(ledger.audit_checks, 100u);
  const auto& structure = dynamic_cast<const OuterHierarchies&>(trial.simulator.structure(0));
  EXPECT_EQ(structure.trees(0), structure.trees(static_cast<ObjectId>(zoo.size())));
  const std::vector<BoundCheck> bounds = trial.simulator.bounds(0);
  ASSERT_EQ(bounds.size(), 12u);
  for (const BoundCheck& check : bounds) EXPECT_TRUE(check.holds) << check.id;
  EXPECT_EQ(bounds[0].id, "outer_hierarchy.median.antichain");
  EXPECT_EQ(bounds[10].id, "outer_hierarchy.balanced_dudley.depth");
}

TEST(OuterHierarchies, ANewBodyBringsItsPolygonAndAnOldOneLeavesIt) {
  std::vector<SceneObject> bodies;
  bodies.push_back(body("a", regular(5), 0));
  bodies.push_back(body("b", regular(7), 9));
  bodies.push_back(body("c", regular(9), 20));
  bodies[0].motion.pieces[0].to = over(1, 2);
  bodies[1].motion.pieces[0].from = over(1, 3);
  const Scene scene = scene_of(std::move(bodies));
  Trial trial(scene, "outer_hierarchy");
  EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 2}));
  trial.run_until(over(2, 5));
  EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 1, 2}));
  trial.to_end();
  trial.expect_clean();
  EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{1, 2}));
  EXPECT_EQ(trial.sink.lines,
            (std::vector<std::string>{"outer_hierarchy insert 1", "outer_hierarchy erase 0"}));
}

// Its audit detects the polygons of another scene.
TEST(OuterHierarchies, TheAuditLooksAtTheScenesPolygons) {
  Scene scene = scene_of({body("a", regular(12), 0), body("b", regular(5), 9)});
  Trial trial(scene, "outer_hierarchy", "exact", AuditLevel::kNone);
  AuditReport good, bad;
  const Snapshot snapshot(Rational(0), 2, 2, 2);
  trial.simulator.structure(0).audit(snapshot, good);
  EXPECT_TRUE(good.violations.empty());
  scene.objects[0].polygon = regular(11);
  trial.simulator.structure(0).audit(snapshot, bad);
  EXPECT_FALSE(bad.violations.empty());
}

}  // namespace outer_hierarchies_test
}  // namespace kinex::test
