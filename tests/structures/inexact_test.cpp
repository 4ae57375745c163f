// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in inexact arithmetics end: of every structure, with and without an end of the scene, from small
// numbers to numbers beyond the doubles. What they end with: inexact_agreement_test.cpp.
#include <string>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace inexact_test {

constexpr const char* kInexact[] = {"double", "gsl", "mpfr:4", "mpfr:53"};

// The same with a third axis: the first one of the objects in reverse order.
Scene in_space(Scene scene) {
  scene.dimension = 3;
  const std::vector<SceneObject> flat = scene.objects;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const auto& other = flat[flat.size() - 1 - i].motion.pieces[0].trajectory.coordinates;
    scene.objects[i].motion.pieces[0].trajectory.coordinates.push_back(other[0]);
  }
  return scene;
}

// Under sanitizers each structure has one of the arithmetics, which one depends on the scene.
void expect_end(const Scene& given) {
  const Scene of_space = in_space(given);
  std::size_t number = static_cast<std::size_t>(given.degree()) + (given.end ? 1 : 0);
  for (const StructureInfo& info : structure_infos()) {
    ++number;
    if (info.bodies) continue;
    if (!info.reads.empty()) continue;  // only the structure that it reads can become corrupt
    if (info.linear() && given.degree() > 1) continue;
    // In space predicates of quadratic and cubic motion have degrees 10 and 15, and runs take minutes.
    if (info.min_dimension == 3 && given.degree() > 1) continue;
    const Scene scene = suited(info.min_dimension == 3 ? of_space : given, info);
    if (refusal_of(info, scene)) continue;
    for (std::size_t i = 0; i < std::size(kInexact); ++i) {
      if (kSanitized && (number + i) % std::size(kInexact) != 0) continue;
      const char* arithmetic = kInexact[i];
      SCOPED_TRACE(std::string(info.name) + " in " + arithmetic);
      Trial run(scene, std::string(info.name), arithmetic, AuditLevel::kEnd);
      EXPECT_EQ(run.simulator.run_until(std::nullopt), RunStatus::kDone);
    }
  }
}

TEST(Inexact, ScenesWithoutEnd) {
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : 2u); ++seed) {
      Random random(100 * seed + static_cast<std::uint64_t>(degree));
      std::vector<Trajectory> paths;
      for (int i = 0; i < 8; ++i) paths.push_back(random.small_path(2, degree, 3 + 200 * (i % 2)));
      expect_end(scene_of(paths, -1, std::nullopt));
    }
  }
}

TEST(Inexact, NumbersBeyondTheDoubles) {
  for (const int degree : {1, 2, 3}) {
    if (kSanitized && degree > 2) break;
    for (const char* size : {"1e150", "1e-150", "1e308", "1e400", "1e-400"}) {
      Random random(static_cast<std::uint64_t>(degree));
      std::vector<Trajectory> paths;
      for (int i = 0; i < 7; ++i) {
        Trajectory p = random.small_path(2, degree, 5);
        if (i % 2 == 0) {
          for (auto& axis : p.coordinates)
            axis[static_cast<std::size_t>(i) % axis.size()] *= *Rational::parse(size);
        }
        paths.push_back(std::move(p));
      }
      expect_end(scene_of(paths, 0, std::nullopt));
      if (!kSanitized) expect_end(scene_of(paths, 0, Rational(1)));
    }
  }
}

TEST(Inexact, TimesBeyondTheDoubles) {
  const auto at = [](const char* time) { return *Rational::parse(time); };
  Random random(4);
  std::vector<Trajectory> paths;
  for (int i = 0; i < 7; ++i) paths.push_back(random.small_path(2, 1, 5));
  for (const char* end : {"1e300", "1e400"}) {
    expect_end(scene_of(paths, -at(end), at(end)));
    expect_end(scene_of(paths, at(end), at(end) + at(end)));
  }
}

// A corrupt structure is held to no bound. Lattices are degenerate at most instants; not every one of them
// makes doubles fail.
TEST(Inexact, ACorruptRunHasNoBounds) {
  for (const char* name : {"delaunay_2", "delaunay_3", "regular_2", "regular_3"}) {
    SCOPED_TRACE(name);
    const StructureInfo& info = *find_structure_info(name);
    int corrupt = 0;
    std::uint64_t seed = 0;
    while (corrupt == 0 && ++seed <= 40) {
      SCOPED_TRACE(seed);
      const Scene scene = suited(lattice_scene(seed, 8, info.min_dimension), info);
      Trial run(scene, name, "double", AuditLevel::kNone);
      run.to_end();
      EXPECT_EQ(run.simulator.bounds(0).empty(), run.ledger().corrupt);
      corrupt += run.ledger().corrupt ? 1 : 0;
    }
    EXPECT_GT(corrupt, 0);
  }
}

// 0 meets 1 at -1e350 and 2 at 1e390; in between 3 meets 0 at 1/2.
TEST(Exact, TimesBeyondTheDoubles) {
  const auto at = [](const char* time) { return *Rational::parse(time); };
  const Scene scene =
      scene_of({path({{0, 1}}), path({{-at("1e350")}}), path({{at("1e390")}}), path({{at("1/2")}})},
               -at("1e400"), at("1e400"));
  Trial run(scene, "sorted_list");
  run.to_end().expect_clean();
  EXPECT_EQ(run.sink.lines,
            (std::vector<std::string>{"sorted_list swap 0 1 !", "sorted_list swap 0 3 !",
                                      "sorted_list swap 0 2 !"}));
}

}  // namespace inexact_test
}  // namespace kinex::test
