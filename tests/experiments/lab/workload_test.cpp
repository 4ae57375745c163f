// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/workload.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/polynomial.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/colours.h"
#include "experiments/lab/grid_root.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload_parts.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace workload_test {

Scene generate(std::string_view name, int n, std::uint64_t seed = 1, int degree = 1,
               int dimension = 0, int m = 0) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.seed = seed;
  parameters.degree = degree;
  parameters.dimension = dimension;
  return lab::generate_scene(*lab::find_workload(name), parameters);
}

// The scenes' names and what they maintain are left out: they may change, the motions must not.
std::string motion_hash(Scene scene) {
  scene.name.clear();
  scene.maintain.clear();
  return formats::scene_hash(scene);
}

// Same bytes on every machine and compiler. A change here makes published counts irreproducible.
TEST(Workload, GoldenHashes) {
  const std::map<std::string, std::string> golden{
#include "tests/experiments/lab/workload_hashes.inc"
  };
  EXPECT_EQ(golden.size(), lab::workloads().size() + 8);
  for (const lab::Workload& workload : lab::workloads()) {
    const std::string name(workload.name);
    EXPECT_EQ(motion_hash(generate(name, 16)), golden.at(name)) << name;
  }
  EXPECT_EQ(motion_hash(generate("uniform-square", 16, 2)), golden.at("uniform-square seed 2"));
  EXPECT_EQ(motion_hash(generate("uniform-square", 16, 1, 3)),
            golden.at("uniform-square degree 3"));
  EXPECT_EQ(motion_hash(generate("gaussian", 16, 1, 1, 3)), golden.at("gaussian dimension 3"));
  EXPECT_EQ(motion_hash(generate("sort-worst", 16, 1, 2)), golden.at("sort-worst degree 2"));
  EXPECT_EQ(motion_hash(generate("hull-worst", 4, 1, 1, 0, 7)), golden.at("hull-worst 4 7"));
  EXPECT_EQ(motion_hash(generate("polygon-random", 16, 1, 3)),
            golden.at("polygon-random degree 3"));
  lab::WorkloadParameters parameters;
  parameters.n = 16;
  parameters.turns = 3;
  EXPECT_EQ(motion_hash(lab::generate_scene(*lab::find_workload("polygon-spin-orbit"), parameters)),
            golden.at("polygon-spin-orbit turns 3"));
  parameters = {};
  parameters.n = 4;
  parameters.m = 7;
  parameters.separation = Rational(Integer(1), Integer(100));
  EXPECT_EQ(motion_hash(lab::generate_scene(*lab::find_workload("polygon-fan"), parameters)),
            golden.at("polygon-fan 4 7 1/100"));
}

TEST(Workload, EveryFamilyIsAValidScene) {
  for (const lab::Workload& workload : lab::workloads()) {
    for (int dimension = workload.min_dimension; dimension <= workload.max_dimension; ++dimension) {
      Scene scene = generate(workload.name, 8, 3, 1, dimension);
      EXPECT_EQ(scene.has_bodies(), workload.bodies);
      if (!workload.bodies) {
        // n objects, or n and m of two kinds.
        const std::map<std::string_view, std::size_t> others{
            {"hull-worst", 16},
            {"pass-over-row", 16},
            {"pass-along-row", 16},
            {"seesaw", 16},
            {"vernier", 16},
            {"comb", 19},
            {"colours-along-row", 16},
            {"vernier-turned", 16},
            {"points-through-lines", 16},
            {"bipyramid", 10},
            {"skew-curves", 17},
            {"skew-rows", 17},
            {"gaps-along-row", 16},
            {"show-and-hide", 24},
            {"breathing", static_cast<std::size_t>(dimension) + 2}};
        const auto other = others.find(workload.name);
        EXPECT_EQ(scene.objects.size(), other == others.end() ? 8u : other->second)
            << workload.name;
        EXPECT_FALSE(scene.maintain.empty());
      }
      scene.maintain.clear();
      const std::string text = formats::write_scene(scene);
      EXPECT_EQ(formats::write_scene(formats::parse_scene(text, "again")), text) << workload.name;
    }
  }
}

// What --help and explain say of sizes: --n counts objects unless it says otherwise, and the defaults make a scene.
TEST(Workload, SizesAreWhatTheyAreSaidToBe) {
  for (const lab::Workload& workload : lab::workloads()) {
    SCOPED_TRACE(workload.name);
    lab::WorkloadParameters parameters;
    parameters.n = workload.default_n;
    EXPECT_GE(workload.default_n, workload.min_n);
    const Scene scene = lab::generate_scene(workload, parameters);
    const bool counts_objects = workload.n_counts == "objects" || workload.n_counts == "polygons" ||
                                workload.n_counts == "edges";
    EXPECT_EQ(scene.objects.size() == static_cast<std::size_t>(parameters.n),
              counts_objects || workload.m_counts == "bundles");  // one bundle, if --m is not given
    EXPECT_EQ(workload.m_counts.empty(), !workload.takes_m);
    const int m = lab::resolved(workload, parameters).m;
    if (workload.takes_m) {
      EXPECT_GE(m, workload.min_m);
      EXPECT_EQ(m, workload.default_m == 0 ? parameters.n : workload.default_m);
    }
  }
}

TEST(Workload, RootsAreRoundedDownToTheGridAndNoFurther) {
  for (const std::int64_t n : {1, 2, 3, 8, 16, 48, 68, 1000, 9999991}) {
    for (const auto& [root, power] :
         {std::pair(1, 1), std::pair(2, 1), std::pair(2, 2), std::pair(3, 1), std::pair(3, 2)}) {
      const std::int64_t units = lab::grid_over_root(n, root, power);
      Integer most = 1, low = 1, above = 1;
      for (int k = 0; k < power; ++k) low *= Integer(n), above *= Integer(n);
      for (int k = 0; k < root; ++k) {
        most *= Integer(lab::kGridUnits);
        low *= Integer(units);
        above *= Integer(units + 1);
      }
      EXPECT_LE(low, most) << n << " " << root << " " << power;
      EXPECT_GT(above, most) << n << " " << root << " " << power;
    }
  }
}

// The largest of many radii or weights is nearly what a scene of n has at most, whatever n: of 48 as of 64.
TEST(Workload, RandomExtentsScaleWithEverySize) {
  const auto largest = [](std::string_view name, int n, int dimension) {
    const Scene scene = generate(name, n, 1, 1, dimension);
    double most = 0;
    for (const SceneObject& object : scene.objects) {
      const Trajectory& trajectory = object.motion.pieces[0].trajectory;
      for (const int t : {0, 1}) {
        most = std::max(most, trajectory.position(dimension, Rational(t)).to_double());
      }
    }
    return most;
  };
  for (const int n : {48, 64, 68, 100}) {
    for (const int dimension : {2, 3}) {
      const double distance = std::pow(n, -1.0 / dimension);
      for (const char* const name : {"random-discs", "random-boxes"}) {
        const double share = largest(name, n, dimension) / distance;
        EXPECT_LE(share, 0.25) << name << " " << n;
        EXPECT_GE(share, 0.23) << name << " " << n;
      }
      const double share = largest("random-weights", n, dimension) / distance / distance;
      EXPECT_LE(share, 1.0) << n;
      EXPECT_GE(share, 0.92) << n;
    }
  }
}

// Of a row and points that pass it, of different numbers, the colours are two classes, whatever maintains them.
TEST(Workload, RequestsNameTheColoursOfARow) {
  const std::vector<std::string> colours{"red", "blue"};
  lab::WorkloadParameters parameters;
  parameters.n = 2;
  parameters.m = 5;
  Scene scene = lab::generate_scene("colours-along-row", parameters, "bichromatic_pair_all");
  EXPECT_EQ(scene.maintain.at(0).colours, colours);
  EXPECT_EQ(generate("colours-along-row", 2, 1, 1, 0, 5).maintain.at(0).colours, colours);
  formats::set_maintain(scene, {"closest_pair_all", "bichromatic_pair_delaunay"});
  lab::name_colours(scene);
  EXPECT_TRUE(scene.maintain.at(0).colours.empty());
  EXPECT_EQ(scene.maintain.at(1).colours, colours);
  const auto red = std::count_if(scene.objects.begin(), scene.objects.end(),
                                 [](const SceneObject& object) { return object.colour == "red"; });
  EXPECT_EQ(red, 5);
  EXPECT_EQ(scene.objects.size(), 7u);
}

// The number of changes is that asked for, each at an instant of its own; objects are alive when stated.
TEST(Workload, ChangesAreWhatTheFamiliesSay) {
  const Scene plans = generate("new-plans", 5, 1, 1, 0, 40);
  std::size_t changes = 0;
  for (const SceneObject& object : plans.objects) {
    changes += object.motion.pieces.size() - 1;
    for (std::size_t k = 1; k < object.motion.pieces.size(); ++k) {
      const MotionPiece& piece = object.motion.pieces[k];
      EXPECT_TRUE(object.motion.pieces[k - 1].trajectory.meets(piece.trajectory, *piece.from));
      EXPECT_FALSE(object.motion.pieces[k - 1].trajectory == piece.trajectory);
    }
  }
  EXPECT_EQ(changes, 40u);
  const Scene walks = generate("walks", 3, 1, 1, 0, 7);
  EXPECT_EQ(*walks.end, Rational(Integer(7), Integer(10)));
  for (const SceneObject& object : walks.objects) {
    ASSERT_EQ(object.motion.pieces.size(), 7u);
    for (std::size_t k = 1; k < 7; ++k) {
      const MotionPiece& piece = object.motion.pieces[k];
      EXPECT_EQ(*piece.from, Rational(Integer(static_cast<int>(k)), Integer(10)));
      EXPECT_TRUE(object.motion.pieces[k - 1].trajectory.meets(piece.trajectory, *piece.from));
    }
  }
  const Scene guests = generate("come-and-go", 8);
  for (std::size_t i = 0; i < 8; ++i) {
    const MotionPiece& piece = guests.objects[i].motion.pieces.front();
    EXPECT_EQ(piece.from.has_value(), i % 2 == 1) << i;
    EXPECT_EQ(piece.to.has_value(), i % 4 >= 2) << i;
  }
}

TEST(Workload, HigherDegreeKeepsOriginAndDestination) {
  const Scene straight = generate("uniform-square", 1, 9);
  const Scene bent = generate("uniform-square", 1, 9, 4);
  const Trajectory& a = straight.objects[0].motion.pieces[0].trajectory;
  const Trajectory& b = bent.objects[0].motion.pieces[0].trajectory;
  EXPECT_EQ(b.degree(), 4);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(a.position(axis, Rational(0)), b.position(axis, Rational(0)));
    EXPECT_EQ(a.position(axis, Rational(1)), b.position(axis, Rational(1)));
  }
}

std::uint64_t processed(Scene scene, const char* structure) {
  formats::set_maintain(scene, {structure});
  const auto simulator = lab::make_simulator(scene, "exact", {});
  const formats::RunOutcome outcome = lab::run_scene(*simulator, {});
  EXPECT_TRUE(outcome.clean(*simulator)) << scene.name;
  return simulator->ledger(0).processed;
}

// Exact maxima of the families, known without kinex.
TEST(Workload, WorstCasesReachTheirCounts) {
  EXPECT_EQ(processed(generate("sort-worst", 12), "sorted_list"), 66u);
  EXPECT_EQ(processed(generate("sort-worst", 5, 1, 2), "sorted_list"), 20u);
  EXPECT_EQ(processed(generate("sort-worst", 6, 1, 3), "sorted_list"), 45u);
  EXPECT_EQ(processed(generate("tournament-worst", 4), "maximum_tournament"), 5u);
  EXPECT_EQ(processed(generate("tournament-worst", 16), "maximum_tournament"), 49u);
  EXPECT_EQ(processed(generate("tournament-worst", 64), "maximum_tournament"), 321u);
  EXPECT_EQ(processed(generate("heap-worst", 7), "maximum_heap"), 10u);
  EXPECT_EQ(processed(generate("heap-worst", 31), "maximum_heap"), 98u);
  EXPECT_EQ(processed(generate("heap-worst", 100), "maximum_heap"), 480u);
  // Interior and hull events of the Delaunay triangulation: 15 + 17, 38 + 31, 68 + 49.
  EXPECT_EQ(processed(generate("hull-worst", 3), "delaunay_2"), 32u);
  EXPECT_EQ(processed(generate("hull-worst", 4), "delaunay_2"), 69u);
  EXPECT_EQ(processed(generate("hull-worst", 5), "delaunay_2"), 117u);
}

Rational squared_radius(const Trajectory& trajectory, const Rational& t) {
  const Rational x = trajectory.position(0, t);
  const Rational y = trajectory.position(1, t);
  return x * x + y * y;
}

TEST(Workload, DegenerateFamiliesAreDegenerate) {
  const Rational half(Integer(1), Integer(2));
  const auto at = [](const Scene& scene, std::size_t i, int axis, const Rational& t) {
    return scene.objects[i].motion.pieces[0].trajectory.position(axis, t);
  };
  const Scene meet = generate("meet", 8);
  const Scene through = generate("through-one-point", 8);
  const Scene near = generate("near-one-point", 8);
  const Scene line = generate("collinear-instant", 8);
  const Scene lattice = generate("lattice", 9);
  for (std::size_t i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(at(meet, i, axis, half), at(meet, i ^ 1, axis, half));
      EXPECT_EQ(at(through, i, axis, half), half);
      const Rational miss = at(near, i, axis, half) - half;
      const Rational most(Integer(1), Integer::power_of_two(60));
      EXPECT_TRUE(-most <= miss && miss <= most && miss != Rational(0));
      EXPECT_TRUE(at(lattice, i, axis, Rational(1)).is_integer());
    }
    EXPECT_EQ(at(line, i, 0, half), Rational(2) * at(line, i, 1, half));
  }
  const Rational t(Integer(3), Integer(7));
  const Rational scale = Rational(1) + t * t;
  for (const SceneObject& object : generate("rotating-circle", 11).objects) {
    EXPECT_EQ(squared_radius(object.motion.pieces[0].trajectory, t), scale * scale);
  }
  for (const SceneObject& object : generate("expanding-circle", 11).objects) {
    EXPECT_EQ(squared_radius(object.motion.pieces[0].trajectory, Rational(1)), Rational(4));
  }
  int inner = 0;
  for (const SceneObject& object : generate("counter-rotating-rings", 11).objects) {
    const Rational square = squared_radius(object.motion.pieces[0].trajectory, t);
    if (square == scale * scale) continue;
    EXPECT_EQ(square * Rational(4), scale * scale);
    ++inner;
  }
  EXPECT_EQ(inner, 5);
}

TEST(Workload, ParametersAreChecked) {
  EXPECT_INPUT_ERROR(generate("tournament-worst", 6),
                     "tournament-worst: --n: \"6\" is not a power");
  EXPECT_INPUT_ERROR(generate("grid", 0), "grid: --n: 0 objects");
  EXPECT_INPUT_ERROR(generate("grid", 4, 1, 2), "--degree");
  EXPECT_INPUT_ERROR(generate("grid", 4, 1, 1, 4), "--dimension");
  EXPECT_INPUT_ERROR(generate("uniform-square", 4, 1, 21), "--degree");
  EXPECT_INPUT_ERROR(generate("grid", 4, 1, 1, 0, 3), "--m");
}

}  // namespace workload_test
}  // namespace kinex
