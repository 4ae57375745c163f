// SPDX-License-Identifier: GPL-3.0-or-later
// The range trees that offer pairs in a cone, and the balanced trees below them, while points come, go
// and change places.
#include "structures/proximity/cone_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "structures/proximity/place_tree.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace cone_pairs_test {

// One of 0, 1 ... n - 1.
std::size_t any(Random& random, std::size_t n) {
  return static_cast<std::size_t>(random.between(0, static_cast<int>(n) - 1));
}

std::size_t log2_up(std::size_t n) {
  std::size_t result = 0;
  while ((std::size_t{1} << result) < n) ++result;
  return result;
}

// As an owner does it.
void insert(PlaceTree& tree, std::vector<ObjectId>& order, std::size_t place, ObjectId object) {
  const ObjectId previous = place == 0 ? kNoObject : order[place - 1];
  tree.insert(object, previous, tree.subtree_to_insert(previous));
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(place), object);
}

void expect_in_order(const PlaceTree& tree, const std::vector<ObjectId>& order) {
  EXPECT_TRUE(tree.consistent());
  EXPECT_EQ(tree.size(), order.size());
  EXPECT_EQ(tree.objects(tree.root()), order);
  for (const ObjectId object : order) {
    EXPECT_LE(tree.way_to(object).size(), 2 * log2_up(order.size()));
  }
}

TEST(PlaceTree, BuiltAsBalancedAsCanBe) {
  for (std::size_t n = 0; n <= 41; ++n) {
    SCOPED_TRACE(n);
    std::vector<ObjectId> order;
    for (std::size_t i = 0; i < n; ++i) order.push_back(static_cast<ObjectId>(7 * i % 41));
    PlaceTree tree(41);
    tree.build(order);
    expect_in_order(tree, order);
    for (const ObjectId object : order) EXPECT_LE(tree.way_to(object).size(), log2_up(n));
    EXPECT_EQ(tree.has(40), std::find(order.begin(), order.end(), ObjectId{40}) != order.end());
  }
}

TEST(PlaceTree, LeavesThatComeAndGoAnywhere) {
  Random random(1);
  PlaceTree tree(60);
  std::vector<ObjectId> order, away;
  for (ObjectId object = 0; object < 60; ++object) away.push_back(object);
  for (int step = 0; step < 2000; ++step) {
    SCOPED_TRACE(step);
    const bool growing = step / 200 % 2 == 0;  // from none to all, and back
    if (away.size() == (growing ? 0 : 60u)) continue;
    if (growing) {
      insert(tree, order, any(random, order.size() + 1), away.back());
      away.pop_back();
    } else {
      const std::size_t place = any(random, order.size());
      const ObjectId object = order[place];
      tree.erase(object, tree.subtree_to_erase(object));
      EXPECT_FALSE(tree.has(object));
      order.erase(order.begin() + static_cast<std::ptrdiff_t>(place));
      away.push_back(object);
    }
    expect_in_order(tree, order);
    if (order.size() > 1) {
      const std::size_t place = any(random, order.size() - 1);
      tree.exchange(order[place], order[place + 1]);
      std::swap(order[place], order[place + 1]);
    }
  }
}

// At one end, where a tree that is not balanced would be a path: the leaves of the subtrees that are
// made anew are O(log n) an insertion.
TEST(PlaceTree, SmallSubtreesAreMadeAnew) {
  constexpr std::size_t n = 4096;
  for (const bool in_front : {false, true}) {
    PlaceTree tree(n);
    std::vector<ObjectId> order;
    std::size_t anew = 0;
    for (ObjectId object = 0; object < n; ++object) {
      const ObjectId previous = in_front || order.empty() ? kNoObject : order.back();
      const PlaceTree::Node subtree = tree.subtree_to_insert(previous);
      tree.insert(object, previous, subtree);
      anew += subtree == PlaceTree::kNone ? 1 : tree.objects(subtree).size();
      if (!in_front) order.push_back(object);
    }
    if (in_front) {
      for (ObjectId object = n; object > 0; --object) order.push_back(object - 1);
    }
    expect_in_order(tree, order);
    EXPECT_LE(anew, n * 3 * log2_up(n));
    EXPECT_GE(anew, 2 * n);
  }
}

// Points in three orders, and what a tree over these offers.
class Field {
 public:
  using Pair = std::array<ObjectId, 2>;

  Field(std::size_t objects, KeptPoints kept, const TwoClasses* classes, bool against)
      : classes_(classes), against_(against), labels_(3, AxisLabels(objects)), orders_(3) {
    trees_ = make_cone_pairs(kept,
                             {PlacesAlong(labels_[0], against), PlacesAlong(labels_[1], false),
                              PlacesAlong(labels_[2], against)},
                             objects, classes, [this](ObjectId p, ObjectId q, int change) {
                               ++changes;
                               const int count = offers_[{p, q}] += change;
                               EXPECT_GE(count, 0);
                               if (count == 0) offers_.erase({p, q});
                             });
  }

  std::size_t size() const { return orders_[0].size(); }
  ObjectId at(std::size_t place) const { return orders_[0][place]; }
  void build(const std::vector<ObjectId>& points, Random& random) {
    for (std::size_t i = 0; i < 3; ++i) {
      orders_[i] = points;
      for (std::size_t k = points.size(); k > 1; --k) {
        std::swap(orders_[i][k - 1], orders_[i][any(random, k)]);
      }
      labels_[i].assign(orders_[i], AxisLabels::bits_for(points.size()));
    }
    trees_->build(points);
  }
  void rebuild() { trees_->build(orders_[2]); }
  // At these places of the orders.
  void insert(ObjectId object, const std::array<std::size_t, 3>& places) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto& order = orders_[i];
      const auto place = order.begin() + static_cast<std::ptrdiff_t>(places[i]);
      const ObjectId previous = place == order.begin() ? kNoObject : *(place - 1);
      const ObjectId next = place == order.end() ? kNoObject : *place;
      const auto moves = labels_[i].room_between(previous, object, next);
      order.insert(place, object);
      if (moves) {
        labels_[i].apply(*moves);
      } else {
        labels_[i].assign(order, labels_[i].bits() + 1);
      }
    }
    const auto& alpha = orders_[0];
    const std::size_t place = places[0];
    if (against_) {
      trees_->insert(object, place + 1 == alpha.size() ? kNoObject : alpha[place + 1]);
    } else {
      trees_->insert(object, place == 0 ? kNoObject : alpha[place - 1]);
    }
  }
  void erase(ObjectId object) {
    trees_->erase(object);
    for (std::size_t i = 0; i < 3; ++i) {
      std::erase(orders_[i], object);
      labels_[i].erase(object);
    }
  }
  void exchange(std::size_t i, std::size_t place) {
    const ObjectId a = orders_[i][place], b = orders_[i][place + 1];
    std::swap(orders_[i][place], orders_[i][place + 1]);
    labels_[i].exchange(a, b);
    if (i == 0) trees_->alpha_changed(a, b);
    if (i == 1) trees_->beta_changed(a, b);
    if (i == 2) trees_->projection_changed(a, b);
  }

  // The trees, the number of offers, and that every pair is offered of which each is the first of the
  // other's cone.
  void check(std::size_t most_offers) const {
    AuditReport report;
    trees_->check(report);
    EXPECT_EQ(report.violations, std::vector<std::string>{});
    std::size_t offers = 0;
    for (const auto& [pair, count] : offers_) offers += static_cast<std::size_t>(count);
    EXPECT_LE(offers, most_offers * size() * 2 * log2_up(size()));
    for (const ObjectId p : orders_[0]) {
      for (const ObjectId q : orders_[0]) {
        if (p == q || !in_cone(p, q) || (classes_ != nullptr && !classes_->differ(p, q))) continue;
        bool mutual = true;
        for (const ObjectId r : orders_[0]) {
          mutual = mutual && !(are_rivals(q, r) && in_cone(p, r) && before(2, r, q)) &&
                   !(are_rivals(p, r) && in_cone(r, q) && before(2, p, r));
        }
        EXPECT_TRUE(!mutual || offers_.count({p, q}) == 1) << p << " " << q;
      }
    }
  }
  const std::map<Pair, int>& offers() const { return offers_; }

  std::size_t changes = 0;  // of offers, so far

 private:
  bool before(std::size_t i, ObjectId a, ObjectId b) const {
    return (labels_[i].of(a) < labels_[i].of(b)) != (against_ && i != 1);
  }
  bool in_cone(ObjectId p, ObjectId q) const { return before(0, p, q) && before(1, p, q); }

  // Two points of which one may take the other's place among what is kept.
  bool are_rivals(ObjectId a, ObjectId b) const {
    return a != b && (classes_ == nullptr || !classes_->differ(a, b));
  }

  const TwoClasses* classes_;
  bool against_;
  std::vector<AxisLabels> labels_;
  std::vector<std::vector<ObjectId>> orders_;
  std::map<Pair, int> offers_;
  std::unique_ptr<ConePairs> trees_;
};

TEST(ConePairs, PointsThatComeGoAndChangePlaces) {
  constexpr std::size_t kObjects = 24;
  Scene scene = reference_scene(kObjects, 2, 1);
  for (std::size_t i = 0; i < kObjects; ++i) scene.objects[i].colour = i % 3 == 0 ? "red" : "blue";
  Request request;
  request.colours = {"red", "blue"};
  const TwoClasses classes(request, scene);
  for (const KeptPoints kept : {KeptPoints::kOne, KeptPoints::kTwo, KeptPoints::kOneOfEachColour}) {
    for (const bool against : {false, true}) {
      Random random(against ? 3 : 2);
      Field field(kObjects, kept, kept == KeptPoints::kOneOfEachColour ? &classes : nullptr,
                  against);
      std::vector<ObjectId> away;
      for (ObjectId object = 0; object < kObjects; ++object) away.push_back(object);
      field.check(most_offers(kept));
      int insertions_among_many = 0;
      for (int step = 0; step < 600; ++step) {
        SCOPED_TRACE(step);
        const bool growing = step / 100 % 2 == 0;
        if (growing && !away.empty() && any(random, 3) == 0) {
          std::array<std::size_t, 3> places;
          for (std::size_t& place : places) place = any(random, field.size() + 1);
          if (field.size() > 5) ++insertions_among_many;
          field.insert(away.back(), places);
          away.pop_back();
        } else if (!growing && field.size() > 3 && any(random, 6) == 0) {
          away.push_back(field.at(any(random, field.size())));
          field.erase(away.back());
        } else if (field.size() > 1) {
          field.exchange(any(random, 3), any(random, field.size() - 1));
        }
        if (step % 250 == 249) field.rebuild();
        field.check(most_offers(kept));
      }
      EXPECT_GT(insertions_among_many, 30);
      while (field.size() > 0) field.erase(field.at(field.size() / 2));
      EXPECT_TRUE(field.offers().empty());
    }
  }
}

// A tree made anew at each of them would change thousands of offers.
TEST(ConePairs, AnInsertionOrErasureChangesFewOffers) {
  Random random(4);
  constexpr std::size_t n = 1000;
  Field field(2 * n, KeptPoints::kOne, nullptr, false);
  std::vector<ObjectId> points;
  for (ObjectId object = 0; object < n; ++object) points.push_back(object);
  field.build(points, random);
  const std::size_t built = field.changes;
  EXPECT_GE(built, n);
  for (ObjectId object = n; object < 2 * n; ++object) {
    // Along alpha all come behind the others.
    field.insert(object,
                 {field.size(), any(random, field.size() + 1), any(random, field.size() + 1)});
  }
  const std::size_t came = field.changes - built;
  EXPECT_LE(came, n * 4 * log2_up(n) * log2_up(n));
  for (ObjectId object = 0; object < n; ++object) field.erase(object);
  EXPECT_LE(field.changes - built - came, n * 4 * log2_up(n) * log2_up(n));
  EXPECT_LE(field.offers().size(), 2 * n * 2 * log2_up(n));
}

}  // namespace cone_pairs_test
}  // namespace kinex::test
