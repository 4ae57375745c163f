// SPDX-License-Identifier: GPL-3.0-or-later
// Queries in transformed scenes: every tree finds the same objects in the transformed box at the
// transformed time. The orders by x and by y are the same, or reversed.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/metamorphic_scenes.h"
#include "tests/structures/range/range_run.h"

namespace kinex::test {
namespace range_metamorphic_test {

using Ids = std::vector<ObjectId>;

struct Asked {
  ExactBox box;
  Ids answer;
};

struct Searched {
  Rational time;
  Snapshot positions;
  std::vector<Asked> asked;
  std::map<std::string, Ids> attributes;  // by label
};

std::vector<Request> trees_for(const Scene& scene) {
  std::vector<Request> requests = all_trees();
  if (scene.degree() <= 1) requests.push_back({"trajectory_tree", "trajectories", {}});
  return requests;
}

std::map<std::string, Ids> attributes_of(const Simulator& simulator) {
  std::map<std::string, Ids> result;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    result[simulator.label(id)] = simulator.structure(id).attribute().ids;
  }
  return result;
}

// Queries all the time, in the scene as it is.
std::vector<Searched> searched(const Scene& scene, std::uint64_t seed) {
  SearchedRun run(scene, "exact", trees_for(scene));
  Random random(seed);
  std::vector<Searched> moments;
  for (int i = 0; i < 12; ++i) {
    const Rational t = scene.start + (*scene.end - scene.start) * fraction(2 * i + 1, 25);
    run.simulator.run_until(t);
    Searched moment{t, run.simulator.snapshot(t), {}, attributes_of(run.simulator)};
    for (int k = 0; k < 8; ++k) {
      ExactBox box;
      for (auto& [low, high] : box) {
        low = fraction(random.between(-3000, 3000), 1000);
        high = low + fraction(random.between(1, 4000), 1000);
      }
      const std::vector<Ids> answers = run.answers(box);
      for (const Ids& answer : answers) EXPECT_EQ(answer, answers[0]);
      moment.asked.push_back({box, answers[0]});
    }
    moments.push_back(std::move(moment));
  }
  return moments;
}

// The transformed box: every axis is multiplied by a number and shifted, as two objects show.
ExactBox image_of(const ExactBox& box, const Snapshot& old, const Snapshot& now,
                  const Image& image) {
  const auto of_old = [&image](ObjectId id) {
    const auto& name = image.name;
    return name.empty() ? id
                        : static_cast<ObjectId>(std::find(name.begin(), name.end(), id) - name.begin());
  };
  ExactBox result;
  for (const int axis : {0, 1}) {
    const Rational a = old.position(0, axis), c = now.position(of_old(0), axis);
    const Rational factor =
        (now.position(of_old(1), axis) - c) / (old.position(1, axis) - a);
    const auto at = static_cast<std::size_t>(axis);
    for (const int side : {0, 1}) {
      const auto end = static_cast<std::size_t>(side);
      result[at][factor < Rational(0) ? 1 - end : end] = c + (box[at][end] - a) * factor;
    }
  }
  return result;
}

// range_tree_2 has both orders. rank_kd_tree_2 is that of the orders. A pseudo kd-tree that has been
// rebuilt depends on the way there as well: on the swaps in their order, which is that of the ids where
// many are due at one instant.
void expect_same_orders(const Searched& moment, const Simulator& simulator, const Image& image,
                        bool many_at_once) {
  std::map<std::string, Ids> now = attributes_of(simulator);
  for (auto& [label, ids] : now) {
    for (ObjectId& id : ids) id = image.old_id(id);
  }
  const bool half_turn = image.how == "times -1";
  Ids& both = now.at("range_tree_2");
  const auto half = both.begin() + static_cast<std::ptrdiff_t>(both.size() / 2);
  if (half_turn || image.how == "axis 0 mirrored") std::reverse(both.begin(), half);
  if (half_turn || image.how == "axis 1 mirrored") std::reverse(half, both.end());
  EXPECT_EQ(both, moment.attributes.at("range_tree_2"));
  if (half_turn || image.how.ends_with("mirrored")) return;
  EXPECT_EQ(now.at("rank_kd_tree_2"), moment.attributes.at("rank_kd_tree_2"));
  if (image.reverses_time()) return;
  EXPECT_EQ(now.at("median"), moment.attributes.at("median"));
  if (many_at_once && !image.name.empty()) return;
  for (const char* tree : {"pseudo", "loose"}) {
    EXPECT_EQ(now.at(tree), moment.attributes.at(tree)) << tree;
  }
}

// `many_at_once`: many swaps are due at one instant.
std::size_t expect_same_answers(std::vector<Searched> moments, const Image& image,
                                bool many_at_once) {
  SCOPED_TRACE(image.how);
  if (image.reverses_time()) std::reverse(moments.begin(), moments.end());
  SearchedRun run(image.scene, "exact", trees_for(image.scene));
  std::size_t found = 0;
  for (const Searched& moment : moments) {
    const Rational t = image.new_time(moment.time);
    run.simulator.run_until(t);
    expect_same_orders(moment, run.simulator, image, many_at_once);
    const Snapshot now = run.simulator.snapshot(t);
    for (const Asked& one : moment.asked) {
      for (Ids answer : run.answers(image_of(one.box, moment.positions, now, image))) {
        for (ObjectId& id : answer) id = image.old_id(id);
        std::sort(answer.begin(), answer.end());
        EXPECT_EQ(answer, one.answer);
        found += answer.size();
      }
    }
  }
  return found;
}

TEST(RangeMetamorphic, Images) {
  std::size_t found = 0;
  for (const auto& [degree, n] : {std::pair{1, 16}, std::pair{1, 9}, std::pair{2, 12}}) {
    SCOPED_TRACE("degree " + std::to_string(degree));
    const Scene scene = wild_scene(static_cast<std::uint64_t>(70 + n), n, degree);
    const std::vector<Searched> moments = searched(scene, 5);
    for (const Image& image : images_of(scene, {}, true)) {
      found += expect_same_answers(moments, image, false);
    }
  }
  EXPECT_GT(found, 10000u);
}

// All points are in one place at one instant, at which all orders are reversed.
TEST(RangeMetamorphic, ThroughOnePoint) {
  const Scene scene = through_one_point(71, 13, 1);
  const std::vector<Searched> moments = searched(scene, 6);
  for (const Image& image : images_of(scene, {}, true)) {
    EXPECT_GT(expect_same_answers(moments, image, true), 0u);
  }
}

}  // namespace range_metamorphic_test
}  // namespace kinex::test
