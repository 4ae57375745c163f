// SPDX-License-Identifier: GPL-3.0-or-later
// Random motions of two convex polygons, every structure against the witness.
#include <gtest/gtest.h>

#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_random_test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  int between(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  Rational eighths(int low, int high) { return ratio(between(8 * low, 8 * high), 8); }
  formats::Polygon2 polygon(int points, int size) { return random_polygon(engine_, points, size); }
  // With sides along the axes and the diagonals.
  formats::Polygon2 lattice_polygon() {
    const std::array<formats::Polygon2, 7> polygons{
        square_of(1),
        formats::Polygon2{{0, -1}, {1, 0}, {0, 1}, {-1, 0}},
        formats::Polygon2{{0, 0}, {1, 0}, {0, 1}},
        formats::Polygon2{{0, 0}, {2, 0}, {1, 1}},
        formats::Polygon2{{-1, 0}, {0, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 1}},
        formats::Polygon2{{0, 0}, {-2, 0}, {-1, -1}},
        formats::Polygon2{{1, 1}, {0, 1}, {-1, 0}, {1, 0}}};
    formats::Polygon2 polygon = polygons[static_cast<std::size_t>(between(0, 6))];
    if (between(0, 1) == 1) {
      for (Vertex2& v : polygon) v = {-v[0], -v[1]};
    }
    return polygon;
  }
  Vertex2 vertex_of(const formats::Polygon2& p) {
    return p[static_cast<std::size_t>(between(0, 99)) % p.size()];
  }
  // A vertex, or the middle of a side.
  Vertex2 place_on(const formats::Polygon2& p) {
    const std::size_t i = static_cast<std::size_t>(between(0, 99)) % p.size();
    if (between(0, 2) > 0) return p[i];
    const Vertex2& next = p[(i + 1) % p.size()];
    return {(p[i][0] + next[0]) / Rational(2), (p[i][1] + next[1]) / Rational(2)};
  }

 private:
  std::mt19937_64 engine_;
};

using Axes = std::vector<std::vector<Rational>>;

// A rotor that never vanishes: 1 + a t and b t with b not zero.
void add_spin(Draw& draw, Axes& axes) {
  const int way = draw.between(0, 1) == 0 ? 1 : -1;
  axes.push_back({1, draw.eighths(-1, 1)});
  axes.push_back({0, Rational(way) * ratio(draw.between(1, 16), 8)});
}

// B turns and goes across.
Axes across(Draw& draw) {
  Axes axes{{draw.eighths(8, 12), draw.eighths(-14, -3)},
            {draw.eighths(-8, 8), draw.eighths(-6, 6)}};
  add_spin(draw, axes);
  return axes;
}

// B swings near A and may turn.
Axes wobble(Draw& draw) {
  Axes axes;
  axes.push_back({draw.eighths(6, 9), draw.eighths(-12, 3), draw.eighths(-2, 9)});
  axes.push_back(
      {draw.eighths(-6, 6), draw.eighths(-9, 9), draw.eighths(-6, 6), draw.eighths(-2, 2)});
  if (draw.between(0, 2) == 0) {
    axes.push_back({1});
    axes.push_back({draw.eighths(-1, 1)});
  } else {
    add_spin(draw, axes);
  }
  return axes;
}

// A turns, and B is carried around it as A sees it, slowly coming nearer.
Axes around(Draw& draw) {
  Axes axes{{draw.eighths(6, 9), draw.eighths(-2, 0)}, {draw.eighths(-2, 2)}};
  if (draw.between(0, 1) == 0) {
    axes.push_back({1});
    axes.push_back({0});
  } else {
    add_spin(draw, axes);
  }
  return axes;
}

// No scene if the bodies do not start apart.
std::optional<Scene> draw_scene(std::uint64_t seed, int most, bool turning) {
  Draw draw(seed);
  const int points = draw.between(3, most);
  const formats::Polygon2 p = draw.polygon(points, 4), q = draw.polygon(draw.between(3, most), 4);
  Axes a{{0}, {0}, {1}, {0}}, b;
  switch (draw.between(0, 2)) {
    case 0:
      b = across(draw);
      break;
    case 1:
      b = wobble(draw);
      break;
    default:
      b = around(draw);
      a.resize(2);
      add_spin(draw, a);
  }
  if (!turning) {
    a = {{0}, {draw.eighths(-1, 1), draw.eighths(-1, 1)}, {1}, {2}};
    b[2] = {1};
    b[3] = {2};
  }
  Scene scene = scene_of_bodies({body("a", p, a), body("b", q, b)}, 0, Rational(3));
  if (formats::contact_of(formats::placed_polygon(p, scene.objects[0].motion.pieces[0].trajectory, 0),
                 formats::placed_polygon(q, scene.objects[1].motion.pieces[0].trajectory, 0)) !=
      formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene;
}

void check_many(std::uint64_t first, int count, int most, bool turning, std::size_t contacts) {
  std::size_t found = 0;
  int runs = 0;
  for (std::uint64_t seed = first; runs < count; ++seed) {
    SCOPED_TRACE(seed);
    const std::optional<Scene> scene = draw_scene(seed, most, turning);
    if (!scene) continue;
    ++runs;
    found += check_runs(*scene);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(found, contacts);
  if (count > 1) {
    EXPECT_LT(found, static_cast<std::size_t>(count));  // some never meet
  }
}

// Integer polygons, equal ones too, on lines and parabolas of the grid: contacts and grazes by
// parallel sides and by corners. No scene if the bodies do not start apart.
std::optional<Scene> draw_grid_scene(std::uint64_t seed) {
  Draw draw(seed);
  const formats::Polygon2 p = draw.polygon(draw.between(3, 9), 3);
  formats::Polygon2 q = draw.polygon(draw.between(3, 9), 3);
  if (draw.between(0, 2) == 0) {
    q = p;
    if (draw.between(0, 1) == 1) {
      for (Vertex2& v : q) v = {-v[0], -v[1]};
    }
  }
  const std::array<std::array<int, 2>, 5> ways{{{1, 0}, {1, 1}, {1, -1}, {2, 1}, {1, -2}}};
  const auto& way = ways[static_cast<std::size_t>(draw.between(0, 4))];
  const int quarter = draw.between(0, 1), kind = draw.between(0, 3);
  Axes b{{-12 * way[0], way[0]}, {draw.between(-7, 7) - 12 * way[1], way[1]}, {1}, {quarter}};
  if (kind == 1) {
    b[0] = {draw.between(-3, 3) - 6, 1};
    b[1] = {draw.between(-7, 7) + 36, -12, 1};
  } else if (kind == 2) {
    b[0] = {draw.between(4, 7) + 36, -12, 1};
    b[1] = {draw.between(-4, 4)};
  } else if (kind == 3) {
    b[3] = {0, ratio(1, 4)};
  }
  const Axes a{{0}, {0}, {1}, {quarter}};
  if (formats::contact_of(formats::placed_polygon(p, trajectory(a), 0), formats::placed_polygon(q, trajectory(b), 0)) !=
      formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene_of_bodies({body("a", p, a), body("b", q, b)}, 0, Rational(24));
}

// A vertex of b, or a place on its side, is where one of a is at the instant 0, in motion, on the
// way to or from it in one flight plan or two, while b turns: sides become parallel there. No scene
// if the bodies do not start apart.
std::optional<Scene> draw_aimed_scene(std::uint64_t seed) {
  Draw draw(seed);
  const formats::Polygon2 p = draw.lattice_polygon(), q = draw.lattice_polygon();
  const Vertex2 v = draw.place_on(p), w = draw.vertex_of(q);
  const auto plan = [&] {
    const auto few = [&] { return Rational(draw.between(-2, 2)); };
    return Axes{{v[0] - w[0], few(), few()}, {v[1] - w[1], few(), few()}, {1}, {0, few()}};
  };
  SceneObject b = body("b", q, plan());
  if (draw.between(0, 2) == 0) {
    b.motion.pieces[0].to = Rational(0);
    b.motion.pieces.push_back({Rational(0), std::nullopt, trajectory(plan())});
  }
  const Rational start = ratio(-1, 4);
  if (formats::contact_of(p, formats::placed_polygon(q, b.motion.pieces[0].trajectory, start)) != formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene_of_bodies({body("a", p, {{0}, {0}, {1}, {0}}), std::move(b)}, start, ratio(3, 4));
}

// b is like a, seen from behind: all their sides are parallel at the instant 0, at which the
// normals turn back and a place of b's side meets a place of a's, or passes it. No scene if the
// bodies do not start apart.
std::optional<Scene> draw_parallel_scene(std::uint64_t seed) {
  Draw draw(seed);
  const formats::Polygon2 p = draw.polygon(draw.between(3, 9), 3);
  const Rational scale = ratio(draw.between(1, 4), 2);
  formats::Polygon2 q = p;
  for (Vertex2& v : q) v = {-v[0] * scale, -v[1] * scale};
  const std::size_t i = static_cast<std::size_t>(draw.between(0, 99)) % p.size();
  const Vertex2 &from = p[i], &to = p[(i + 1) % p.size()];
  const Vertex2 along{to[0] - from[0], to[1] - from[1]};
  // A place on the sum's side, in quarters, and ways along it and out of it.
  const Rational place = ratio(draw.between(-1, 5), 4) * (Rational(1) + scale);
  const Rational slide = ratio(draw.between(-2, 2), 2), out = ratio(draw.between(-1, 6), 2);
  const std::size_t power = draw.between(0, 3) == 0 ? 4 : 2;
  const auto of_power = [&](Rational constant, Rational first, const Rational& last) {
    std::vector<Rational> axis(power + 1, Rational(0));
    axis[0] = std::move(constant);
    axis[1] = std::move(first);
    axis[power] = last;
    return axis;
  };
  const auto coordinate = [&](std::size_t k, const Rational& outwards) {
    return of_power((Rational(1) + scale) * from[k] + place * along[k], slide * along[k],
                    out * outwards);
  };
  const auto spin = [&] { return of_power(0, 0, ratio(draw.between(-2, 2), 4)); };
  const Axes a{{0}, {0}, {1}, spin()};
  const Axes b{coordinate(0, along[1]), coordinate(1, -along[0]), {1}, spin()};
  const Rational start = ratio(-1, 2);
  if (formats::contact_of(formats::placed_polygon(p, trajectory(a), start),
                 formats::placed_polygon(q, trajectory(b), start)) != formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene_of_bodies({body("a", p, a), body("b", q, b)}, start, ratio(1, 2));
}

// b walks along the grid until the instant 0, and may turn by a quarter; then it does not turn any
// more and touches or passes a at the instant 1, with sides identically parallel or the point on the
// line of a side. No scene if the bodies do not start apart.
std::optional<Scene> draw_settled_scene(std::uint64_t seed) {
  Draw draw(seed);
  const formats::Polygon2 p = draw.lattice_polygon(), q = draw.lattice_polygon();
  const int quarters = draw.between(-1, 1);
  const Vertex2 v = draw.place_on(p), own = draw.vertex_of(q);
  const Vertex2 w = quarters == 0 ? own : Vertex2{-quarters * own[1], quarters * own[0]};
  // Along an axis and back; along a parabola.
  const int kind = draw.between(0, 3);
  Axes comes, settled;
  for (std::size_t k = 0; k < 2; ++k) {
    // d + f (t - 1) + g (t - 1)^2
    const Rational d = v[k] - w[k];
    const Rational f(kind < 2 ? 0 : draw.between(-1, 1));
    const Rational g(static_cast<int>(k) == kind ? 0 : draw.between(-2, 2));
    settled.push_back({d - f + g, f - Rational(2) * g, g});
    comes.push_back({d - f + g, Rational(draw.between(-2, 2))});
  }
  settled.insert(settled.end(), {{1}, {quarters}});
  comes.insert(comes.end(), {{1}, {quarters, quarters}});
  SceneObject b = body("b", q, comes);
  b.motion.pieces[0].to = Rational(0);
  b.motion.pieces.push_back({Rational(0), std::nullopt, trajectory(settled)});
  if (formats::contact_of(p, formats::placed_polygon(q, trajectory(comes), -1)) != formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene_of_bodies({body("a", p, {{0}, {0}, {1}, {0}}), std::move(b)}, -1, Rational(2));
}

// b turns, or turns back, about a vertex of its own that stays on the line of a's side or moves
// along it. No scene if the bodies do not start apart.
std::optional<Scene> draw_pivot_scene(std::uint64_t seed) {
  Draw draw(seed);
  const formats::Polygon2 p = draw.lattice_polygon();
  formats::Polygon2 q = draw.lattice_polygon();
  const Vertex2 pivot = draw.vertex_of(q);
  for (Vertex2& v : q) v = {v[0] - pivot[0], v[1] - pivot[1]};
  const std::size_t i = static_cast<std::size_t>(draw.between(0, 99)) % p.size();
  const Vertex2 &from = p[i], &to = p[(i + 1) % p.size()];
  const int place = draw.between(-4, 3), slide = std::max(0, draw.between(-2, 1));
  Axes b;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational along = to[k] - from[k];
    b.push_back(
        {from[k] + ratio(place < 0 ? place : place + 3, 2) * along, Rational(slide) * along});
  }
  const int quarter = std::max(0, draw.between(-2, 1));
  std::vector<Rational> turn(static_cast<std::size_t>(draw.between(2, 4)), Rational(0));
  turn.back() = ratio(draw.between(-3, 3), 2);
  b.push_back({1});
  b.push_back(turn);
  b[3][0] = Rational(quarter);
  if (quarter == 1) {  // (1 + i) (1 + i turn)
    b[2] = turn;
    for (Rational& c : b[2]) c = -c;
    b[2][0] = Rational(1);
  }
  const Rational start = ratio(-1, 2);
  if (formats::contact_of(p, formats::placed_polygon(q, trajectory(b), start)) != formats::Contact::kApart) {
    return std::nullopt;
  }
  return scene_of_bodies({body("a", p, {{0}, {0}, {1}, {0}}), body("b", q, b)}, start, Rational(1));
}

// So many scenes that one of these makes of seeds from `first` on.
void check_drawn(std::optional<Scene> (*draw_scene)(std::uint64_t), std::uint64_t first, int scenes,
                 std::size_t contacts, std::size_t grazes) {
  MeetingCounts found;
  for (std::uint64_t seed = first; scenes > 0; ++seed) {
    SCOPED_TRACE(seed);
    const std::optional<Scene> scene = draw_scene(seed);
    if (!scene) continue;
    --scenes;
    const MeetingCounts here = check_meetings(*scene);
    found.contacts += here.contacts;
    found.grazes += here.grazes;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(found.contacts, contacts);
  EXPECT_GE(found.grazes, grazes);
}

TEST(CollisionRuns, AimedAtVertices) {
  check_drawn(draw_aimed_scene, 1, kSanitized ? 16 : 40, 2, 2);
}
TEST(SlowCollisionRuns, AimedAtVertices) {
  check_drawn(draw_aimed_scene, 5000, kSanitized ? 50 : 300, 50, 25);
}
TEST(CollisionRuns, SettledBeforeTheTouch) {
  check_drawn(draw_settled_scene, 1, kSanitized ? 30 : 150, 5, 5);
}
TEST(SlowCollisionRuns, SettledBeforeTheTouch) {
  check_drawn(draw_settled_scene, 5000, kSanitized ? 100 : 600, 40, 40);
}
TEST(CollisionRuns, TurnAboutAVertex) {
  check_drawn(draw_pivot_scene, 1, kSanitized ? 75 : 150, 5, 5);
}
TEST(SlowCollisionRuns, TurnAboutAVertex) {
  check_drawn(draw_pivot_scene, 5000, kSanitized ? 100 : 600, 40, 40);
}
TEST(CollisionRuns, SidesThatTurnBackAtATouch) {
  check_drawn(draw_parallel_scene, 1, kSanitized ? 25 : 60, 1, 10);
}
TEST(SlowCollisionRuns, SidesThatTurnBackAtATouch) {
  check_drawn(draw_parallel_scene, 5000, kSanitized ? 50 : 200, 7, 50);
}
TEST(CollisionRuns, LinesAndParabolasOfTheGrid) {
  check_drawn(draw_grid_scene, 90, kSanitized ? 8 : 40, 1, 0);
}
TEST(SlowCollisionRuns, LinesAndParabolasOfTheGrid) {
  check_drawn(draw_grid_scene, 1000, kSanitized ? 100 : 600, 4, 2);
}
TEST(CollisionRuns, SmallPolygonsThatTurn) { check_many(1, kSanitized ? 4 : 25, 8, true, 1); }
TEST(CollisionRuns, SmallPolygonsThatDoNotTurn) {
  check_many(1000, kSanitized ? 4 : 25, 8, false, 1);
}
TEST(CollisionRuns, LargerPolygons) { check_many(2000, kSanitized ? 1 : 4, 24, true, 0); }

TEST(SlowCollisionRuns, Turning) { check_many(10000, kSanitized ? 20 : 200, 12, true, 10); }
TEST(SlowCollisionRuns, NotTurning) { check_many(20000, kSanitized ? 20 : 200, 12, false, 10); }
TEST(SlowCollisionRuns, Large) { check_many(30000, kSanitized ? 3 : 40, 24, true, 1); }

}  // namespace collision_random_test
}  // namespace kinex::test
