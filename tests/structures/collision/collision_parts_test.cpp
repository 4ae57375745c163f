// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of proof is a part of its structure: its certificates have a line in the ledger, and the
// lines add up to the whole.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/structures/collision/body_polygons.h"
#include "tests/structures/collision/scene_of_bodies.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace collision_parts_test {

// A square at rest. One body goes through it, another passes by.
Scene crossing_bodies() {
  return scene_of_bodies(
      {rigid("rests", rectangle(1, 1), {{0}, {0}, {1}, {0}}),
       rigid("goes through", regular(5, 0.3), {{-9, 1}, {over(1, 7), over(-1, 50)}, {1}, {0}}),
       rigid("passes", regular(6, 0.1), {{12, -1}, {over(33, 16), over(1, 90)}, {1}, {0}})},
      0, Rational(20));
}

std::map<std::string, PartLedger> parts_of(const Trial& trial) {
  std::map<std::string, PartLedger> parts;
  for (const PartLedger& part : trial.ledger().parts) parts.emplace(part.name, part);
  return parts;
}

void expect_sums(const Trial& trial) {
  PartLedger sum;
  for (const PartLedger& part : trial.ledger().parts) {
    sum.failures += part.failures;
    sum.created += part.created;
    sum.retracted += part.retracted;
    sum.live += part.live;
  }
  EXPECT_EQ(sum.failures, trial.ledger().failures);
  EXPECT_EQ(sum.created, trial.ledger().certificates_created);
  EXPECT_EQ(sum.retracted, trial.ledger().certificates_retracted);
  EXPECT_EQ(sum.live, trial.ledger().live);
}

TEST(CollisionParts, AddUpToTheLedger) {
  const std::map<std::string, std::vector<std::string>> own{
      {"separation_mixed", {"tiles"}},
      {"separation_minkowski", {"tiles"}},
      {"separation_hysteresis", {"wedges", "closest features"}},
      {"closest_features", {"closest features"}},
      {"bounding_volumes", {"closest features"}},
      {"inner_tangents", {"inner tangents"}}};
  const Scene scene = crossing_bodies();
  for (const auto& [structure, proofs] : own) {
    SCOPED_TRACE(structure);
    Trial trial(scene, structure);
    for (const int t : {2, 8, 14}) {
      trial.run_until(Rational(t));
      expect_sums(trial);
    }
    trial.to_end();
    trial.expect_clean();
    expect_sums(trial);
    const auto parts = parts_of(trial);
    EXPECT_EQ(parts.size(), proofs.size() + 3);
    const PartLedger &cells = parts.at("cells"), &volumes = parts.at("volumes"),
                     &overlap = parts.at("overlap");
    EXPECT_GT(cells.failures, 0u);
    EXPECT_EQ(cells.max_live, 12u);
    EXPECT_GT(volumes.failures, 0u);
    EXPECT_GT(overlap.failures, 0u);
    EXPECT_LE(overlap.max_live, 5u);
    EXPECT_EQ(overlap.live, 0u);  // they have separated
    std::uint64_t failures = 0;
    for (const std::string& proof : proofs) failures += parts.at(proof).failures;
    EXPECT_GT(failures, 0u);
  }
}

// Of two bodies: the pair has one proof at a time, and each begins where the other ends.
TEST(CollisionParts, AProofEndsWhereTheNextBegins) {
  Scene scene = crossing_bodies();
  scene.objects.pop_back();
  Trial trial(scene, "separation_mixed");
  const auto live = [&trial](const std::string& part) { return parts_of(trial).at(part).live; };
  EXPECT_GT(live("tiles"), 0u);
  EXPECT_EQ(live("overlap"), 0u);
  trial.run_until(Rational(9));
  EXPECT_EQ(live("tiles"), 0u);
  EXPECT_EQ(live("overlap"), 5u);
  trial.to_end();
  EXPECT_GT(live("tiles"), 0u);
  EXPECT_EQ(live("overlap"), 0u);
  trial.expect_clean();
}

}  // namespace collision_parts_test
}  // namespace kinex::test
