// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/contact_witness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/formats/scene_reader.h"
#include "tests/experiments/body_fixture.h"
#include "tests/places.h"

namespace kinex {
namespace collision_witness_test {

using Pairs = std::vector<families::FeaturePair>;

bool is_at(const families::BodyContact& contact, const Rational& t) {
  RealRoot instant = contact.instant;
  RootCounters counters;
  return compare(instant, t, counters) == 0;
}

bool is_root(const families::BodyContact& contact, std::vector<Integer> coefficients) {
  RealRoot instant = contact.instant;
  RootCounters counters;
  return sign_at(Polynomial(std::move(coefficients)), instant, counters) == Sign::kZero;
}

TEST(CollisionWitness, SquaresHeadOn) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  const SceneObject b = body("b", square_of(1), {{5, -2}, {ratio(1, 2)}, {1}, {0}});
  const families::CollisionWitness found = families::find_contacts(a, b, 0, std::nullopt);
  EXPECT_TRUE(found.grazes.empty());
  ASSERT_NE(found.penetration(), nullptr);
  EXPECT_TRUE(is_at(*found.penetration(), ratio(3, 2)));
  // The upper right corner of a on the left edge of b, the lower left one of b on the right of a.
  EXPECT_EQ(found.penetration()->features, (Pairs{{false, 0, 1}, {true, 2, 3}}));
  EXPECT_EQ(found.first(), found.penetration());
  // They part when b is through.
  ASSERT_EQ(found.separations.size(), 1u);
  EXPECT_TRUE(is_at(found.separations[0], ratio(7, 2)));
  EXPECT_EQ(found.separations[0].features, (Pairs{{false, 1, 3}, {true, 3, 1}}));
  EXPECT_EQ(found.separations[0].after, formats::Contact::kApart);
  // They meet at the end: what would follow is a contact.
  const families::CollisionWitness until = families::find_contacts(a, b, 0, ratio(3, 2));
  ASSERT_NE(until.penetration(), nullptr);
  EXPECT_TRUE(is_at(*until.penetration(), ratio(3, 2)));
  EXPECT_TRUE(until.separations.empty());
  EXPECT_EQ(families::find_contacts(a, b, 0, ratio(149, 100)).first(), nullptr);
}

TEST(CollisionWitness, VertexToVertex) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  // Down the diagonal, corner against corner.
  const SceneObject into = body("b", square_of(1), {{4, -1}, {4, -1}, {1}, {0}});
  const families::CollisionWitness found = families::find_contacts(a, into, 0, 4);
  ASSERT_NE(found.penetration(), nullptr);
  EXPECT_TRUE(is_at(*found.penetration(), 2));
  // Each corner is an end of two edges.
  EXPECT_EQ(found.penetration()->features,
            (Pairs{{false, 0, 1}, {false, 0, 2}, {true, 2, 0}, {true, 2, 3}}));
  // Across: the corners meet and part.
  const SceneObject past = body("b", square_of(1), {{4, -1}, {0, 1}, {1}, {0}});
  const families::CollisionWitness graze = families::find_contacts(a, past, 0, 4);
  EXPECT_EQ(graze.penetration(), nullptr);
  ASSERT_EQ(graze.grazes.size(), 1u);
  EXPECT_TRUE(is_at(graze.grazes[0], 2));
  EXPECT_EQ(graze.grazes[0].after, formats::Contact::kApart);
  EXPECT_EQ(graze.first(), &graze.grazes[0]);
}

// y = 1 + (t - 1)^2 above the square: an even root; then with every parabola a little lower.
TEST(CollisionWitness, ParabolaGrazes) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  const formats::Polygon2 wedge{{0, 0}, {1, 2}, {-1, 2}};
  const SceneObject graze = body("b", wedge, {{0}, {2, -2, 1}, {1}, {0}});
  const families::CollisionWitness found = families::find_contacts(a, graze, 0, 9);
  EXPECT_EQ(found.penetration(), nullptr);
  ASSERT_EQ(found.grazes.size(), 1u);
  EXPECT_TRUE(is_at(found.grazes[0], 1));
  EXPECT_EQ(found.grazes[0].features, (Pairs{{false, 0, 2}}));
  const Rational hair(Integer(1), Integer::power_of_two(100));
  const SceneObject lower = body("b", wedge, {{0}, {Rational(2) - hair, -2, 1}, {1}, {0}});
  const families::CollisionWitness below = families::find_contacts(a, lower, 0, 9);
  EXPECT_TRUE(below.grazes.empty());
  ASSERT_NE(below.penetration(), nullptr);
  // 1 - 2^-50: the double root has split.
  EXPECT_TRUE(
      is_at(*below.penetration(), Rational(1) - Rational(Integer(1), Integer::power_of_two(50))));
  const SceneObject higher = body("b", wedge, {{0}, {Rational(2) + hair, -2, 1}, {1}, {0}});
  EXPECT_EQ(families::find_contacts(a, higher, 0, 9).first(), nullptr);
}

// A bar of half-length 2 turns by the rotor 1 + it: its end reaches a post at an irrational
// instant.
TEST(CollisionWitness, SpinningBar) {
  const SceneObject bar =
      body("bar", {{-2, 0}, {2, ratio(-1, 100)}, {2, 0}}, {{0}, {0}, {1}, {0, 1}});
  const SceneObject post = body("post", box(-1, 1, 1, 3), {{0}, {0}, {1}, {0}});
  const families::CollisionWitness found = families::find_contacts(bar, post, 0, 1);
  ASSERT_NE(found.penetration(), nullptr);
  EXPECT_TRUE(found.grazes.empty());
  // The upper edge of the bar passes (1, 1) at 45 degrees: t = tan(22.5 degrees) = sqrt(2) - 1.
  EXPECT_TRUE(is_root(*found.penetration(), {-1, 2, 1}));
  EXPECT_EQ(found.penetration()->features, (Pairs{{false, 1, 2}}));
  // Shorter than the way to the corner, it meets the bottom edge with its end: sin = 5/6.
  const SceneObject shorter = body(
      "bar", {{ratio(-6, 5), 0}, {0, ratio(-1, 100)}, {ratio(6, 5), 0}}, {{0}, {0}, {1}, {0, 1}});
  const families::CollisionWitness end = families::find_contacts(shorter, post, 0, 1);
  ASSERT_NE(end.penetration(), nullptr);
  EXPECT_EQ(end.penetration()->features, (Pairs{{true, 2, 0}}));
  EXPECT_TRUE(is_root(*end.penetration(), {5, -12, 5}));  // 2t / (1 + t^2) = 5/6
  // Shorter than the distance of the edge, it never meets it.
  const SceneObject free = body("bar", {{ratio(-1, 2), 0}, {0, ratio(-1, 100)}, {ratio(1, 2), 0}},
                                {{0}, {0}, {1}, {0, 1}});
  EXPECT_EQ(families::find_contacts(free, post, 0, std::nullopt).first(), nullptr);
}

// The tip of a turning triangle comes up to an edge and goes back.
TEST(CollisionWitness, TipOfATurningBodyGrazes) {
  const SceneObject tip = body("tip", {{-1, 0}, {0, -1}, {1, 0}}, {{0}, {0}, {1, -1}, {0, 1}});
  const SceneObject roof = body("roof", box(-3, 1, 3, 2), {{0}, {0}, {1}, {0}});
  const families::CollisionWitness found = families::find_contacts(tip, roof, 0, 1);  // half a turn
  EXPECT_EQ(found.penetration(), nullptr);
  ASSERT_EQ(found.grazes.size(), 2u);
  EXPECT_TRUE(is_at(found.grazes[0], ratio(1, 2)));
  EXPECT_EQ(found.grazes[0].features, (Pairs{{true, 2, 0}}));
  EXPECT_TRUE(is_at(found.grazes[1], 1));  // the next corner, at the end of the time
  EXPECT_EQ(found.grazes[1].features, (Pairs{{true, 1, 0}}));
}

// A corner slides along a side, leaves it, and comes back from the other side into the body.
TEST(CollisionWitness, SlidesAlongAnEdge) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  const formats::Polygon2 wedge{{0, 0}, {1, 2}, {-1, 2}};
  SceneObject b = body("b", wedge, {{-3, 1}, {1}, {1}, {0}});
  const families::CollisionWitness slide = families::find_contacts(a, b, 0, 9);
  EXPECT_EQ(slide.penetration(), nullptr);
  ASSERT_EQ(slide.grazes.size(), 1u);
  EXPECT_TRUE(is_at(slide.grazes[0], 2));
  EXPECT_EQ(slide.grazes[0].after, formats::Contact::kTouching);
  EXPECT_EQ(slide.grazes[0].features,
            (Pairs{{false, 0, 2}, {false, 0, 3}, {true, 3, 0}, {true, 3, 2}}));
  // In a second flight plan it goes down: it penetrates at the seam.
  b.motion.pieces[0].to = Rational(3);
  b.motion.pieces.push_back({Rational(3), std::nullopt, trajectory({{0}, {4, -1}, {1}, {0}})});
  const families::CollisionWitness down = families::find_contacts(a, b, 0, 9);
  ASSERT_EQ(down.grazes.size(), 1u);
  ASSERT_NE(down.penetration(), nullptr);
  EXPECT_TRUE(is_at(*down.penetration(), 3));
  EXPECT_EQ(down.penetration()->features, (Pairs{{false, 0, 2}}));
  // It goes up instead: no more than the slide.
  b.motion.pieces[1].trajectory = trajectory({{0}, {-2, 1}, {1}, {0}});
  const families::CollisionWitness up = families::find_contacts(a, b, 0, 9);
  EXPECT_EQ(up.penetration(), nullptr);
  EXPECT_EQ(up.grazes.size(), 1u);
}

TEST(CollisionWitness, TouchingAtTheStart) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  const SceneObject leaving = body("b", square_of(1), {{2, 1}, {0}, {1}, {0}});
  const families::CollisionWitness left = families::find_contacts(a, leaving, 0, 1);
  EXPECT_EQ(left.penetration(), nullptr);
  ASSERT_EQ(left.grazes.size(), 1u);
  EXPECT_TRUE(is_at(left.grazes[0], 0));
  EXPECT_EQ(left.grazes[0].after, formats::Contact::kApart);
  EXPECT_EQ(left.grazes[0].features.size(), 8u);  // two whole edges: four corners, two edges each
  const SceneObject coming = body("b", square_of(1), {{2, -1}, {0}, {1}, {0}});
  EXPECT_TRUE(is_at(*families::find_contacts(a, coming, 0, 1).penetration(), 0));
  const SceneObject staying = body("b", square_of(1), {{2}, {0}, {1}, {0}});
  const families::CollisionWitness rest = families::find_contacts(a, staying, 0, std::nullopt);
  EXPECT_EQ(rest.penetration(), nullptr);
  ASSERT_EQ(rest.grazes.size(), 1u);
  EXPECT_EQ(rest.grazes[0].after, formats::Contact::kTouching);
}

// A touch at a seam of flight plans, and one that a jump or a late arrival brings about.
TEST(CollisionWitness, SeamsOfFlightPlans) {
  const SceneObject a = body("a", square_of(1), {{0}, {0}, {1}, {0}});
  SceneObject b = body("b", square_of(1), {{3, -1}, {0}, {1}, {0}});
  b.motion.pieces[0].to = Rational(1);
  b.motion.pieces.push_back({Rational(1), std::nullopt, trajectory({{1, 1}, {0}, {5}, {0}})});
  const families::CollisionWitness bounce = families::find_contacts(a, b, 0, 5);
  EXPECT_EQ(bounce.penetration(), nullptr);
  ASSERT_EQ(bounce.grazes.size(), 1u);
  EXPECT_TRUE(is_at(bounce.grazes[0], 1));
  EXPECT_EQ(bounce.grazes[0].after, formats::Contact::kApart);
  b.motion.pieces[1].trajectory = trajectory({{0}, {0}, {1}, {0}});
  const families::CollisionWitness jump = families::find_contacts(a, b, 0, 5);
  ASSERT_NE(jump.penetration(), nullptr);
  EXPECT_TRUE(is_at(*jump.penetration(), 1));
  b.motion.pieces.erase(b.motion.pieces.begin());
  const families::CollisionWitness late = families::find_contacts(a, b, 0, 5);
  ASSERT_NE(late.penetration(), nullptr);
  EXPECT_TRUE(is_at(*late.penetration(), 1));
  EXPECT_EQ(families::find_contacts(a, b, 0, ratio(1, 2)).first(), nullptr);
}

// The degenerate scenes of the corpus are what their descriptions say.
TEST(CollisionWitness, DegenerateScenes) {
  struct Case {
    const char* name;
    std::size_t grazes;
    std::optional<Rational> penetration;
  };
  for (const Case& one : std::initializer_list<Case>{{"parallel-squares", 0, {}},
                                                     {"through-corners", 0, {}},
                                                     {"graze", 1, {}},
                                                     {"corner-meets-corner", 0, ratio(1, 2)},
                                                     {"corner-passes-corner", 1, {}},
                                                     {"half-turned-twins", 0, {}},
                                                     {"twins-at-rest", 0, {}},
                                                     {"slide", 1, {}},
                                                     {"square-turns", 0, {}},
                                                     {"move-as-one", 0, {}}}) {
    const Scene scene = formats::read_scene(
        std::string(KINEX_SOURCE_DIR "/tests/corpus/scenes/good/bodies-") + one.name + ".json");
    const auto found = families::find_contacts(scene.objects[0], scene.objects[1], scene.start, scene.end);
    EXPECT_EQ(found.grazes.size(), one.grazes) << one.name;
    ASSERT_EQ(found.penetration() != nullptr, one.penetration.has_value()) << one.name;
    if (one.penetration) {
      EXPECT_TRUE(is_at(*found.penetration(), *one.penetration)) << one.name;
    }
  }
}

// Against sampling: overlapping from every contact to the separation after it and at no other time,
// and the same with the bodies exchanged.
TEST(CollisionWitness, RandomMotions) {
  std::mt19937_64 random(11);
  const auto draw = [&](int low, int high) {
    return Rational(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  int penetrations = 0, none = 0, again = 0;
  RootCounters counters;
  for (int round = 0; round < 60; ++round) {
    // Every other time b turns back on the way past a.
    const bool returns = round % 2 == 1;
    const Rational still = 0;
    const SceneObject a = body("a", random_polygon(random, 6, 3),
                               {{0, returns ? still : draw(-2, 2)},
                                {0, returns ? still : draw(-2, 2)},
                                {1},
                                {0, draw(-2, 2)}});
    const SceneObject b =
        body("b", random_polygon(random, 6, 3),
             {{8, returns ? Rational(-9) : draw(-9, 5), returns ? Rational(2) : draw(-3, 3)},
              {returns ? still : draw(-6, 6), returns ? still : draw(-6, 6)},
              {1, draw(-3, 3)},
              {1, draw(0, 2)}});
    const Trajectory& path_a = a.motion.pieces[0].trajectory;
    const Trajectory& path_b = b.motion.pieces[0].trajectory;
    const auto contact_at = [&](const Rational& t) {
      return formats::contact_of(formats::placed_polygon(a.polygon, path_a, t), formats::placed_polygon(b.polygon, path_b, t));
    };
    // Both parts of b's rotor may vanish together.
    const Rational p1 = path_b.position(2, 1) - Rational(1),
                   q1 = path_b.position(3, 1) - Rational(1);
    if (p1 == q1 || contact_at(0) != formats::Contact::kApart) continue;
    families::CollisionWitness found = families::find_contacts(a, b, 0, 6);
    families::CollisionWitness turned = families::find_contacts(b, a, 0, 6);
    ASSERT_EQ(found.contacts.size(), turned.contacts.size());
    EXPECT_EQ(found.grazes.size(), turned.grazes.size());
    none += found.first() == nullptr;
    penetrations += found.contacts.empty() ? 0 : 1;
    ASSERT_EQ(found.separations.size(), turned.separations.size());
    // They come and go in turns.
    ASSERT_LE(found.separations.size(), found.contacts.size());
    ASSERT_LE(found.contacts.size(), found.separations.size() + 1);
    std::vector<Rational> changes;
    for (std::size_t i = 0; i < 2 * found.contacts.size(); ++i) {
      if (i / 2 >= (i % 2 == 0 ? found.contacts : found.separations).size()) continue;
      families::BodyContact& change = (i % 2 == 0 ? found.contacts : found.separations)[i / 2];
      families::BodyContact& same = (i % 2 == 0 ? turned.contacts : turned.separations)[i / 2];
      EXPECT_EQ(compare(change.instant, same.instant, counters), 0);
      EXPECT_EQ(change.features.size(), same.features.size());
      EXPECT_FALSE(change.features.empty());
      change.instant.refine_to(60, counters);
      changes.push_back(change.instant.upper() + Rational(Integer(1), Integer::power_of_two(50)));
      EXPECT_EQ(contact_at(changes.back()) == formats::Contact::kOverlapping, i % 2 == 0);
    }
    again += changes.size() > 2;
    for (int k = 0; k <= 90; ++k) {
      const Rational t = ratio(k, 15);
      const auto past = static_cast<std::size_t>(
          std::count_if(changes.begin(), changes.end(), [&](const Rational& c) { return c < t; }));
      const formats::Contact contact = contact_at(t);
      // At the very instant of a change they only touch.
      const Rational hair(Integer(1), Integer::power_of_two(40));
      if (std::any_of(changes.begin(), changes.end(),
                      [&](const Rational& c) { return t <= c && c < t + hair; })) {
        EXPECT_EQ(contact, formats::Contact::kTouching);
        continue;
      }
      EXPECT_EQ(contact == formats::Contact::kOverlapping, past % 2 == 1);
      if (found.grazes.empty() && past % 2 == 0) {
        EXPECT_EQ(contact, formats::Contact::kApart);
      }
    }
  }
  EXPECT_GT(again, 2);
  EXPECT_GT(penetrations, 5);
  EXPECT_GT(none, 3);
}

}  // namespace collision_witness_test
}  // namespace kinex
