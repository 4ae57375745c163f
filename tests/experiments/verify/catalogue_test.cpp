// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue holds the experiments that it should, and witnesses count what brute force counts.
#include "experiments/verify/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "experiments/families/maximum/envelope_witness.h"
#include "experiments/families/order/inversions.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/formats/input_error.h"
#include "structures/registry.h"

namespace kinex {
namespace catalogue_test {

using Counts = std::map<int, std::string>;  // by n

// The exact counts that cells of a structure and workload expect of a quantity.
Counts expected(const std::string& structure, const std::string& workload, int degree,
                const std::string& quantity) {
  Counts counts;
  for (const lab::Cell& cell : verify::make_catalogue(structure, lab::Extent::kQuick).cells) {
    if (cell.workload != workload || cell.parameters.degree != degree) continue;
    for (const lab::Expectation& expectation : cell.expectations) {
      if (expectation.quantity == quantity && expectation.kind == lab::ExpectationKind::kExact) {
        counts[cell.parameters.n] = expectation.exact.to_string();
      }
    }
  }
  return counts;
}

TEST(Catalogue, HoldsTheWorstCases) {
  EXPECT_EQ(expected("sorted_list", "sort-worst", 1, "processed"),
            (Counts{{4, "6"}, {8, "28"}, {16, "120"}, {32, "496"}, {64, "2016"}}));
  EXPECT_EQ(expected("sorted_list", "sort-worst", 2, "processed").at(5), "20");
  EXPECT_EQ(expected("sorted_list", "sort-worst", 3, "processed").at(6), "45");
  for (const std::string which : {"maximum_", "minimum_"}) {
    EXPECT_EQ(expected(which + "tournament", "tournament-worst", 1, "processed"),
              (Counts{{4, "5"}, {8, "17"}, {16, "49"}, {64, "321"}, {256, "1793"}}));
    EXPECT_EQ(expected(which + "heap", "heap-worst", 1, "processed"),
              (Counts{{7, "10"}, {15, "34"}, {31, "98"}, {63, "258"}}));
    EXPECT_EQ(expected(which + "heap", "heap-worst", 1, "external").at(63), "62");
  }
  EXPECT_EQ(expected("delaunay_2", "hull-worst", 1, "kind.flip"),
            (Counts{{3, "15"}, {4, "38"}, {5, "68"}, {6, "107"}}));
  const Counts hull = expected("delaunay_2", "hull-worst", 1, "kind.enter+kind.leave");
  EXPECT_EQ(hull.at(3), "17");
  EXPECT_EQ(hull.at(4), "31");
  EXPECT_EQ(hull.at(5), "49");
  EXPECT_EQ(hull.at(6), "71");
}

TEST(Catalogue, HoldsTheReferenceMeans) {
  std::map<int, std::pair<double, double>> references;
  for (const lab::Cell& cell : verify::make_catalogue("delaunay_2", lab::Extent::kQuick).cells) {
    for (const lab::Expectation& expectation : cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kMean) continue;
      references[cell.parameters.n] = {expectation.reference, expectation.reference_error};
      EXPECT_EQ(expectation.comparisons, 7);
    }
  }
  std::map<int, std::pair<double, double>> known;
  for (const families::ReferenceMean& mean : families::reference_means("delaunay")) {
    known[mean.n] = {mean.mean, mean.error};
  }
  EXPECT_EQ(known.size(), 7u);
  EXPECT_EQ(references, known);
}

TEST(Catalogue, CoversEveryStructureThatIsRegistered) {
  for (const lab::Extent extent : {lab::Extent::kQuick, lab::Extent::kFull}) {
    std::set<std::string> structures;
    std::set<std::tuple<std::string, std::string, int, int>> names;
    for (const lab::Cell& cell : verify::make_catalogue("all", extent).cells) {
      structures.insert(cell.structure);
      EXPECT_TRUE(names
                      .emplace(cell.structure, cell.workload_text(), cell.parameters.n,
                               cell.parameters.degree)
                      .second)
          << cell.structure << " " << cell.workload_text() << " " << cell.parameters.n;
      EXPECT_FALSE(cell.question.empty());
      EXPECT_GT(cell.cost, 0);
      for (const lab::Expectation& expectation : cell.expectations) {
        EXPECT_FALSE(expectation.source.empty()) << expectation.claim;
      }
    }
    for (const StructureInfo& info : structure_infos()) {
      EXPECT_EQ(structures.count(std::string(info.name)), 1u) << info.name;
    }
  }
}

TEST(Catalogue, RefusesUnknownStructuresByName) {
  try {
    verify::make_catalogue("dealunay_2", lab::Extent::kQuick);
    FAIL() << "it was accepted";
  } catch (const formats::InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"dealunay_2\""));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("delaunay_2"));
  }
}

TEST(Catalogue, OneStructureIsAPartOfAll) {
  const std::size_t all = verify::make_catalogue("all", lab::Extent::kQuick).cells.size();
  std::size_t sum = 0;
  for (const StructureInfo& info : structure_infos()) {
    sum += verify::make_catalogue(info.name, lab::Extent::kQuick).cells.size();
  }
  EXPECT_EQ(sum, all);
}

TEST(Catalogue, TheMaximaAreAGroup) {
  const lab::Catalogue group = verify::make_catalogue("maximum", lab::Extent::kQuick);
  std::set<std::string> structures;
  std::map<std::tuple<std::string, int, int>, std::set<std::string>> compared;
  for (const lab::Cell& cell : group.cells) {
    structures.insert(cell.structure);
    if (cell.comparison != "maximum") continue;
    compared[{cell.workload, cell.parameters.n, cell.parameters.degree}].insert(cell.structure);
  }
  const std::set<std::string> all{"maximum_dual_hull", "maximum_envelope",    "maximum_hanger",
                                  "maximum_heap",      "maximum_sorted_list", "maximum_tournament"};
  EXPECT_EQ(structures, all);
  EXPECT_GE(compared.size(), 7u);
  for (const auto& [scenes, members] : compared) {
    EXPECT_EQ(members.size(), std::get<2>(scenes) == 1 ? 6u : 5u) << std::get<0>(scenes);
  }
  for (const lab::Cell& cell : verify::make_catalogue("minimum", lab::Extent::kQuick).cells) {
    EXPECT_EQ(cell.structure.substr(0, 8), "minimum_");
  }
}

TEST(Catalogue, AFamilyIsAllOfItsStructures) {
  for (const std::string family : {"extent", "proximity", "range"}) {
    SCOPED_TRACE(family);
    std::size_t cells = 0;
    for (const StructureInfo& info : structure_infos()) {
      if (family_of(info.name) != family) continue;
      cells += verify::make_catalogue(info.name, lab::Extent::kQuick).cells.size();
    }
    const lab::Catalogue catalogue = verify::make_catalogue(family, lab::Extent::kQuick);
    EXPECT_EQ(catalogue.cells.size(), cells);
    EXPECT_GT(cells, 10u);
    for (const lab::Cell& cell : catalogue.cells) EXPECT_EQ(family_of(cell.structure), family);
  }
  EXPECT_FALSE(verify::make_catalogue("range", lab::Extent::kQuick).studies.empty());
}

// ---- witnesses ------------------------------------------------------------------------------

Scene lines(const std::vector<std::pair<Rational, Rational>>& at_both_ends) {
  Scene scene;
  scene.start = 0;
  scene.end = 1;
  for (const auto& [first, last] : at_both_ends) {
    Trajectory trajectory{{{first, last - first}}};
    trajectory.normalise();
    Motion motion;
    motion.pieces.push_back({std::nullopt, std::nullopt, trajectory});
    scene.objects.push_back({"p" + std::to_string(scene.objects.size()), motion});
  }
  return scene;
}

Rational at(const Scene& scene, std::size_t i, const Rational& t) {
  return scene.objects[i].motion.pieces.front().trajectory.position(0, t);
}

// Crossings of two lines in (0, 1) at which all others are below: three nested loops.
int brute_force_envelope(const Scene& scene) {
  int changes = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational first = at(scene, i, 0) - at(scene, j, 0);
      const Rational last = at(scene, i, 1) - at(scene, j, 1);
      if (first.sign() * last.sign() >= 0) continue;
      const Rational t = first / (first - last);
      bool highest = true;
      for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        if (k != i && k != j && at(scene, k, t) > at(scene, i, t)) highest = false;
      }
      if (highest) ++changes;
    }
  }
  return changes;
}

int brute_force_inversions(const Scene& scene) {
  int count = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((at(scene, i, 0) - at(scene, j, 0)).sign() * (at(scene, i, 1) - at(scene, j, 1)).sign() <
          0)
        ++count;
    }
  }
  return count;
}

TEST(Witness, CountsWhatBruteForceCounts) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    lab::WorkloadParameters parameters;
    parameters.n = 20;
    parameters.dimension = 1;
    parameters.seed = seed;
    const Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
    EXPECT_EQ(families::inversions(scene), Integer(brute_force_inversions(scene))) << seed;
    EXPECT_EQ(families::upper_envelope_changes(scene), Integer(brute_force_envelope(scene))) << seed;
  }
}

TEST(Witness, KnowsTies) {
  // Equal at the start: the order right after it. Equal at the end: the order right after it.
  EXPECT_EQ(families::inversions(lines({{0, 1}, {0, 2}})), Integer(0));
  EXPECT_EQ(families::inversions(lines({{1, 0}, {0, 0}})), Integer(1));
  // Identical motions: never.
  EXPECT_EQ(families::inversions(lines({{1, 1}, {1, 1}})), Integer(0));
  EXPECT_EQ(families::upper_envelope_changes(lines({{0, 1}, {1, 0}, {1, 0}})), Integer(1));
  EXPECT_EQ(families::lower_envelope_changes(lines({{0, 1}, {1, 0}, {2, 2}})), Integer(1));
  EXPECT_EQ(families::upper_envelope_changes(lines({{0, 1}, {1, 1}})), Integer(1));  // at the end
  EXPECT_EQ(families::upper_envelope_changes(lines({})), Integer(0));
}

TEST(Witness, KnowsScenesWithoutEnd) {
  Scene scene = lines({{3, 4}, {2, 4}, {1, 9}});  // slopes 1, 2, 8
  scene.end.reset();
  EXPECT_EQ(families::inversions(scene), Integer(3));
  EXPECT_EQ(families::upper_envelope_changes(scene), Integer(1));
}

TEST(Witness, AgreesWithTheWorstCases) {
  lab::WorkloadParameters parameters;
  parameters.n = 16;
  EXPECT_EQ(families::inversions(lab::generate_scene(*lab::find_workload("sort-worst"), parameters)), Integer(120));
  EXPECT_EQ(families::upper_envelope_changes(lab::generate_scene(*lab::find_workload("tournament-worst"), parameters)),
            Integer(15));
}

TEST(SceneOf, MirrorsAMaximumIntoAMinimum) {
  lab::Cell cell;
  cell.structure = "minimum_heap";
  cell.workload = "heap-worst";
  cell.parameters.n = 7;
  cell.mirrored = true;
  const Scene scene = lab::scene_of(cell, 0);
  ASSERT_EQ(scene.maintain.size(), 1u);
  EXPECT_EQ(scene.maintain.front().structure, "minimum_heap");
  EXPECT_EQ(families::lower_envelope_changes(scene), Integer(6));
  cell.mirrored = false;
  EXPECT_EQ(families::upper_envelope_changes(lab::scene_of(cell, 0)), Integer(6));
  EXPECT_EQ(lab::scene_of(cell, 0).objects.back().motion.pieces.front().trajectory.coordinates[0][1],
            Rational(6));
  EXPECT_EQ(scene.objects.back().motion.pieces.front().trajectory.coordinates[0][1], Rational(-6));
}

}  // namespace catalogue_test
}  // namespace kinex
