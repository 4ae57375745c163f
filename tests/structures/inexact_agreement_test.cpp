// SPDX-License-Identifier: GPL-3.0-or-later
// What a run in an inexact arithmetic ends with, of every structure for points and of all that it reads:
// the attribute of the exact run, or corruption, or a violation that the audit at the end reports. Never
// another attribute that nobody notices.
//
// Events are not counted: what happens at one instant in `exact` is often two events or none here (an edge
// that becomes antiparallel, and the duel of its two candidates, which are equal then).
#include <algorithm>
#include <string>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/metamorphic_scenes.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace inexact_agreement_test {

struct Ended {
  bool noticed = false;  // corrupt, or reported by the audit
  std::vector<ObjectId> ids;
};

Ended run(const Scene& scene, const std::string& arithmetic) {
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene),
                      Trial::options(AuditLevel::kEnd));
  add_structures(simulator, scene);
  simulator.start();
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kDone);
  Ended ended{!simulator.violations().empty(),
              simulator.structure(asked_structure(scene)).attribute().ids};
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    ended.noticed = ended.noticed || ledger.corrupt || ledger.audit_violations > 0;
  }
  return ended;
}

Rational at(const Scene& scene, ObjectId object, std::size_t axis) {
  Rational value(0);
  for (const MotionPiece& piece : scene.objects[object].motion.pieces) {
    if (!piece.from || *piece.from <= *scene.end) {
      value = piece.trajectory.position(static_cast<int>(axis), *scene.end);
    }
  }
  return value;
}

// At the scene's end: the area of the rectangle on the edge a, b that touches r, c and l.
Rational area(const Scene& scene, const std::vector<ObjectId>& ids) {
  const auto from = [&](std::size_t p, std::size_t q, std::size_t axis) {
    return at(scene, ids[q], axis) - at(scene, ids[p], axis);
  };
  const Rational x = from(0, 1, 0), y = from(0, 1, 1);
  const Rational height = x * from(0, 3, 1) - y * from(0, 3, 0);
  const Rational width = x * from(4, 2, 0) + y * from(4, 2, 1);
  return height * width / (x * x + y * y);
}

// Two attributes that are both right at the scene's end.
bool agree(const Scene& scene, const std::string& structure, std::vector<ObjectId> a,
           std::vector<ObjectId> b) {
  if (a == b) return true;
  if (a.size() != b.size()) return false;
  // All rectangles on the sides of an acute triangle have one area, identically. Which one is named is
  // decided by a zero that an inexact arithmetic does not see.
  if (structure == "min_area_rectangle_2" && a.size() == 5) return area(scene, a) == area(scene, b);
  // Nearly balanced trees depend on the order in which points were swapped: simultaneous swaps have no
  // order here. The leaves are all points, and the audit holds each against its cell.
  if (structure == "pseudo_kd_tree_2") {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }
  return false;
}

struct Counts {
  int agree = 0, noticed = 0;
};

// One run in `exact`, and one in each inexact arithmetic, of every structure that takes the scene. Under
// sanitizers one in three of them.
Counts expect_agreement(const Scene& given) {
  Counts counts;
  std::size_t number = 0;
  for (const StructureInfo& info : structure_infos()) {
    if (info.bodies) continue;
    Scene scene = suited(given, info);
    if (refusal_of(info, scene)) continue;
    const std::string name(info.name);
    scene.maintain = {Request{name, name, {}}};
    std::vector<ObjectId> exact;
    bool known = false;
    for (const char* arithmetic : {"double", "gsl", "mpfr:24"}) {
      if (kSanitized && ++number % 3 != 0) continue;
      SCOPED_TRACE(name + " in " + arithmetic);
      if (!known) {
        const Ended ended = run(scene, "exact");
        EXPECT_FALSE(ended.noticed);
        exact = ended.ids;
        known = true;
      }
      const Ended ended = run(scene, arithmetic);
      if (ended.noticed) {
        ++counts.noticed;
        continue;
      }
      ++counts.agree;
      EXPECT_TRUE(agree(scene, name, exact, ended.ids))
          << "exact: " << ::testing::PrintToString(exact)
          << "\nhere: " << ::testing::PrintToString(ended.ids);
    }
  }
  return counts;
}

// Motions without ties or common instants.
TEST(InexactAgreement, WildMotions) {
  const Counts counts = expect_agreement(wild_scene(2, 8, 1));
  EXPECT_GT(counts.agree, kSanitized ? 50 : 200);
}

// Everything at one instant: much goes wrong, and is noticed.
TEST(InexactAgreement, ThroughOnePoint) {
  const Counts counts = expect_agreement(through_one_point(3, 6, 1));
  EXPECT_GT(counts.agree, kSanitized ? 25 : 100);
  EXPECT_GT(counts.noticed, kSanitized ? 5 : 20);
}

TEST(InexactAgreement, Flights) {
  const Counts counts = expect_agreement(random_flights(2, 7, 2, 1, true));
  EXPECT_GT(counts.agree, kSanitized ? 50 : 200);
}

// Ties and meetings everywhere.
TEST(InexactAgreement, Lattice) {
  Random random(3);
  std::vector<Trajectory> paths;
  for (int i = 0; i < 7; ++i) paths.push_back(random.small_path(2, 1, 3));
  const Counts counts = expect_agreement(scene_of(paths, -1, Rational(7)));
  EXPECT_GT(counts.agree, kSanitized ? 50 : 180);
}

}  // namespace inexact_agreement_test
}  // namespace kinex::test
