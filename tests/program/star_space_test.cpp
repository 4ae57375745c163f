// SPDX-License-Identifier: GPL-3.0-or-later
// The stars near the Sun in space (stars_test.cpp), from 100,000 years ago to 100,000 years from now: the
// Delaunay triangulation, the closest pair and the spanning tree. Components of double stars have equal
// positions in the table. CGAL's triangulation and the structures' audits must agree between the
// events, and the closest pair and the length of the tree must be those of the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/formats/scene_reader.h"
#include "structures/plan.h"
#include "tests/program/spawn.h"
#include "tests/program/star_witness.h"
#include "tests/shared_data.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace star_space_test {

using Wide = __int128;

constexpr Wide kFar = Wide(1) << 120;
constexpr int kSteps = 10;  // samples at k / 100 million years, |k| < kSteps

// In units of 1e-16 square parsec.
Wide squared_distance(const Star& a, const Star& b, int k) {
  Wide sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Wide x = Wide(100) * (b.position[axis] - a.position[axis]) +
                   Wide(k) * (b.velocity[axis] - a.velocity[axis]);
    sum += x * x;
  }
  return sum;
}

// The squared lengths of the edges of a minimum spanning tree, ascending (Prim's algorithm): the same
// for all of them.
std::vector<Wide> tree_lengths(const std::vector<Star>& stars, int k) {
  std::vector<Wide> nearest(stars.size(), kFar);
  std::vector<bool> inside(stars.size(), false);
  std::vector<Wide> lengths;
  std::size_t last = 0;
  inside[0] = true;
  while (lengths.size() + 1 < stars.size()) {
    std::size_t best = stars.size();
    for (std::size_t i = 0; i < stars.size(); ++i) {
      if (inside[i]) continue;
      nearest[i] = std::min(nearest[i], squared_distance(stars[last], stars[i], k));
      if (best == stars.size() || nearest[i] < nearest[best]) best = i;
    }
    inside[best] = true;
    lengths.push_back(nearest[best]);
    last = best;
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

class StarSpace : public testing::Test {
 protected:
  void SetUp() override {
    KINEX_REQUIRE_DATA(table_);
    const ScratchFolder scratch;
    const std::string file = scratch.file("stars.json");
    const Finished made = run_kinex({"import", table_, "--start", "-0.1", "--end", "0.1", "--fixed",
                                     "Sun,0,0,0", "--maintain", "delaunay_3", "-o", file});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    scene_ = formats::read_scene(file);
    const std::map<std::string, Star> known = read_stars(table_);
    for (const SceneObject& object : scene_.objects) {
      stars_.push_back(object.id == "Sun" ? Star{} : known.at(object.id));
    }
    ASSERT_EQ(stars_.size(), 295u);
  }

  // Runs the structure, with audits at the samples; `expect` gets its pairs of ids there.
  template <class Expect>
  std::uint64_t expect_run(const std::string& structure, const Expect& expect) {
    scene_.maintain = {{structure, structure, {}}};
    Simulator simulator(scene_, planned_arithmetic("exact", scene_),
                        Trial::options(AuditLevel::kEnd));
    add_structures(simulator, scene_);
    const StructureId id = asked_structure(scene_);
    simulator.start();
    for (int k = 1 - kSteps; k < kSteps; ++k) {
      simulator.run_until(Rational(Integer(k), Integer(100)));
      EXPECT_TRUE(simulator.audit());
      expect(simulator.structure(id).attribute().ids, k);
    }
    simulator.run_until(std::nullopt);
    EXPECT_TRUE(simulator.audit());
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (StructureId s = 0; s < simulator.structures(); ++s) {
      for (const BoundCheck& bound : simulator.bounds(s)) EXPECT_TRUE(bound.holds) << bound.id;
    }
    return simulator.ledger(id).external;
  }

  const std::string table_ = shared_data("nearest_stars.csv");
  Scene scene_;
  std::vector<Star> stars_;  // by object
};

TEST_F(StarSpace, TheTriangulationIsThatOfTheTable) {
  EXPECT_GT(expect_run("delaunay_3", [](const std::vector<ObjectId>& cells, int) {
              EXPECT_GT(cells.size(), 4u * 295u);
            }),
            100u);
}

TEST_F(StarSpace, TheClosestPairIsThatOfTheTable) {
  expect_run("closest_pair_delaunay", [this](const std::vector<ObjectId>& pair, int k) {
    ASSERT_EQ(pair.size(), 2u);
    const Wide told = squared_distance(stars_[pair[0]], stars_[pair[1]], k);
    for (std::size_t b = 0; b < stars_.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        ASSERT_FALSE(squared_distance(stars_[a], stars_[b], k) < told) << a << " " << b << ", " << k;
      }
    }
  });
}

TEST_F(StarSpace, TheTreeIsThatOfTheTable) {
  EXPECT_GT(expect_run("emst_list",
                       [this](const std::vector<ObjectId>& edges, int k) {
                         std::vector<Wide> lengths;
                         for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
                           lengths.push_back(squared_distance(stars_[edges[i]], stars_[edges[i + 1]], k));
                         }
                         std::sort(lengths.begin(), lengths.end());
                         EXPECT_TRUE(lengths == tree_lengths(stars_, k)) << k;
                       }),
            100u);
}

}  // namespace star_space_test
}  // namespace kinex::test
