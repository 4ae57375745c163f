// SPDX-License-Identifier: GPL-3.0-or-later
// The mixed hierarchy at rational poses, against all tiles by their definition.
#include "structures/collision/mixed_tiles.h"

#include <gtest/gtest.h>

#include "tests/sanitized.h"
#include "tests/structures/collision/tile_bench.h"

namespace kinex::test {
namespace mixed_tiles_test {

using Kind = Tile::Kind;

struct Case {
  std::string name;
  Polygon a, b;  // A and B'
  Vertex2 rotor;
};

std::vector<Case> cases() {
  Random random(5);
  const Rational tiny = *Rational::parse("1e-12");
  std::vector<Case> all{
      {"triangles", {{0, 0}, {5, 1}, {2, 7}}, {{-1, 0}, {3, -2}, {2, 2}}, {3, 1}},
      {"squares, parallel", rectangle(1, 1), rectangle(2, 1), {1, 0}},
      {"squares, turned", rectangle(1, 1), rectangle(1, 1), {5, 2}},
      {"square and diamond, parallel", rectangle(1, 1), {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {1, 0}},
      {"twins", regular(8), regular(8), {1, 0}},
      {"twins, a quarter turned", regular(8, 0.5), regular(8, 0.5), {1, 1}},
      {"twins, turned a little", regular(9, 0.1), regular(9, 0.1), {1000, 1}},
      {"regular", regular(12), regular(7, 0.3), {7, -3}},
      {"large and small", regular(10), scaled(regular(6, 0.2), over(1, 50), over(1, 70)), {4, 9}},
      {"small and large", scaled(regular(5), over(1, 1000), over(1, 3000)), regular(9), {-2, 5}},
      {"tiny and huge", scaled(regular(5), tiny, tiny), scaled(regular(6), 1000000, 100), {-2, 3}},
      {"thin", scaled(regular(10, 0.2), 1, over(1, 10000)), regular(5), {1, 3}},
      {"crossed needles", {{0, 0}, {900, 1}, {899, 2}}, {{0, 0}, {900, 1}, {899, 2}}, {1, 1}},
      {"geometric", geometric_chain(10), geometric_chain(8), {2, 1}},
      {"axis edges",
       {{2, -1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}},
       rectangle(1, 3),
       {0, 1}},
      {"nearly a half turn", regular(6, 0.4), geometric_chain(5), {1, 50}},
  };
  for (int i = 0; i < 6; ++i) {
    all.push_back({"random " + std::to_string(i),
                   random_hull(random, 5 + 2 * i, 20),
                   random_hull(random, 14 - i, 20),
                   {random.between(-9, 9), random.between(1, 9)}});
  }
  return all;
}

// Every case, under the policy in use and every fourth under another.
template <class Check>
void for_all(const Check& check) {
  int number = 0;
  for (const Case& one : cases()) {
    ++number;
    for (const CutPolicy policy :
         {CutPolicy::kBalancedDudley, CutPolicy::kMedian, CutPolicy::kCompass}) {
      const int k = static_cast<int>(policy);
      if (policy != CutPolicy::kBalancedDudley && (kSanitized || number % 4 != k)) continue;
      SCOPED_TRACE(one.name + ", " + std::string(cut_policy_name(policy)));
      Bench bench(one.a, one.b, policy);
      check(bench, one);
      if (testing::Test::HasFailure()) return;
    }
  }
}

constexpr int kEnd = OuterHierarchy::kNever - 1;

// The areas of the tiles add up to that between the sum of the boxes and M.
TEST(MixedTiles, AreasAddUp) {
  for_all([](Bench& bench, const Case& one) {
    const TileGeometry geometry = bench.geometry(one.rotor);
    const Polygon m = geometry.sum(kEnd);
    EXPECT_EQ(m, minkowski_sum(one.a, turned(one.b, one.rotor[0], one.rotor[1])));
    Rational total;
    for (const PlacedTile& tile : geometry.all()) total += double_area(tile.outline);
    EXPECT_EQ(total, double_area(geometry.sum(0)) - double_area(m));
  });
}

// Every point between the boxes and M is in one tile; locate() finds it, or M, or a half-plane.
TEST(MixedTiles, PointsAreCoveredOnce) {
  Random random(17);
  int inside = 0, in_m = 0, beyond = 0;
  for_all([&](Bench& bench, const Case& one) {
    const TileGeometry geometry = bench.geometry(one.rotor);
    const Polygon m = geometry.sum(kEnd), boxes = geometry.sum(0);
    const std::vector<PlacedTile> all = geometry.all();
    Vertex2 low = boxes[0], high = boxes[0];
    for (const Vertex2& v : boxes) {
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    }
    for (int i = 0; i < 25; ++i) {
      Vertex2 p;
      for (std::size_t k = 0; k < 2; ++k) {
        p[k] = low[k] + (high[k] - low[k]) * over(random.between(-50, 1050), 1001);
      }
      bench.place(p, one.rotor);
      const auto found = bench.tiles->locate();
      const PlacedTile* holder = nullptr;
      bool on_side = false;
      for (const PlacedTile& tile : all) {
        const int place = where(p, tile.outline);
        on_side = on_side || place == 0;
        if (place <= 0) continue;
        EXPECT_EQ(holder, nullptr) << "two tiles";
        holder = &tile;
      }
      if (on_side) continue;
      if (where(p, m) > 0) {
        ++in_m;
        EXPECT_EQ(holder, nullptr);
        EXPECT_FALSE(found);
        continue;
      }
      ASSERT_TRUE(found);
      EXPECT_TRUE(bench.holds(*found));
      if (where(p, boxes) < 0) {
        ++beyond;
        EXPECT_EQ(holder, nullptr);
        EXPECT_EQ(found->kind, Kind::kHalf);
        continue;
      }
      ++inside;
      ASSERT_NE(holder, nullptr) << "no tile";
      EXPECT_EQ(convex_hull(geometry.placed(*found).outline), convex_hull(holder->outline));
    }
  });
  const int enough = kSanitized ? 20 : 100;
  EXPECT_GT(inside, enough);
  EXPECT_GT(in_m, enough);
  EXPECT_GT(beyond, enough / 2);
}

// The certificates of a tile are its sides: zero on them, positive within, negative beyond.
TEST(MixedTiles, CertificatesAreTheSides) {
  for_all([](Bench& bench, const Case& one) {
    for (const PlacedTile& tile : bench.geometry(one.rotor).all()) {
      const MixedTiles::Certificates proof = bench.tiles->certificates(tile.tile);
      ASSERT_EQ(proof.sides, tile.count);
      ASSERT_EQ(proof.count, tile.count + 2);
      Vertex2 middle{0, 0};
      for (const Vertex2& v : tile.outline) {
        middle = middle + over(1, static_cast<int>(tile.outline.size())) * v;
      }
      bench.place(middle, one.rotor);
      for (std::uint32_t i = 0; i < proof.count; ++i) {
        const Sign sign = bench.sign(proof.query[i]);
        EXPECT_NE(sign, Sign::kNegative);
        if (i < proof.sides) {
          EXPECT_EQ(sign, Sign::kPositive);
        }
      }
      for (std::size_t i = 0; i < tile.count; ++i) {
        const Vertex2 on = over(1, 2) * (tile.sides[i][0] + tile.sides[i][1]);
        bench.place(on, one.rotor);
        EXPECT_EQ(bench.sign(proof.query[i]), Sign::kZero);
        bench.place(on + over(1, 100) * (on - middle), one.rotor);
        EXPECT_EQ(bench.sign(proof.query[i]), Sign::kNegative);
      }
    }
  });
}

struct World {
  explicit World(const TileGeometry& about)
      : geometry(about),
        all(about.all()),
        m(about.sum(kEnd)),
        boxes(about.sum(0)),
        parallels(about.has_parallels()) {}
  const TileGeometry& geometry;
  std::vector<PlacedTile> all;
  Polygon m, boxes;
  bool parallels;
};

// Checks the place of a point that has just left a side.
void expect_beyond(Bench& bench, const World& world, const Vertex2& on, const Vertex2& way,
                   const MixedTiles::Move& next) {
  const TileGeometry& geometry = world.geometry;
  const MixedTiles::Move move = bench.settled(next, world.parallels);
  const Rational hair(Integer(1), Integer::power_of_two(100));
  const Vertex2 p = on + hair * way;
  const PlacedTile* holder = nullptr;
  for (const PlacedTile& tile : world.all) {
    if (where(p, tile.outline) > 0) {
      holder = &tile;
      break;
    }
  }
  if (holder != nullptr) {
    ASSERT_TRUE(move.tile) << "contact in a tile";
    EXPECT_TRUE(bench.holds(*move.tile));
    EXPECT_EQ(convex_hull(geometry.placed(*move.tile).outline), convex_hull(holder->outline));
    const auto found = bench.tiles->locate();
    ASSERT_TRUE(found);
    EXPECT_EQ(convex_hull(geometry.placed(*found).outline), convex_hull(holder->outline));
    return;
  }
  if (where(p, world.boxes) < 0) {
    ASSERT_TRUE(move.tile);
    EXPECT_EQ(move.tile->kind, Kind::kHalf);
    EXPECT_TRUE(bench.holds(*move.tile));
    return;
  }
  ASSERT_GT(where(p, world.m), 0);
  ASSERT_FALSE(move.tile) << "a tile in M";
  // The features that meet: a point of the edge, translated by the node, is at `on`.
  const int z = move.x, w = 1 - z;
  const Vertex2 node = geometry.apex(w, move.node);
  bool first = false, last = false;
  Vertex2 from, to;
  for (const std::uint32_t v : geometry.stage(z, kEnd)) {
    if (geometry.tree(z).node(v).right_edge == move.edge) {
      from = geometry.apex(z, v) + node;
      first = true;
    }
    if (geometry.tree(z).node(v).left_edge == move.edge) {
      to = geometry.apex(z, v) + node;
      last = true;
    }
  }
  ASSERT_TRUE(first && last);
  EXPECT_EQ(cross(to - from, on - from).sign(), 0);
  EXPECT_GE(dot(to - from, on - from).sign(), 0);
  EXPECT_GE(dot(from - to, on - to).sign(), 0);
  EXPECT_EQ(geometry.tree(w).node(move.node).count, 0u);
}

// Across every side of every tile.
TEST(MixedTiles, NeighboursAcrossSides) {
  for_all([](Bench& bench, const Case& one) {
    const TileGeometry geometry = bench.geometry(one.rotor);
    const World world(geometry);
    for (const PlacedTile& tile : world.all) {
      for (std::uint32_t slot = 0; slot < tile.count; ++slot) {
        const auto& [p, q] = tile.sides[slot];
        if (p == q) continue;
        {
          const Rational part = over(slot % 2 == 0 ? 7919 : 18013, 20011);
          const Vertex2 on = p + part * (q - p);
          // Away from a point of the tile.
          const Vertex2 inner =
              over(1, 5) * (tile.outline[0] + tile.outline[1]) + over(3, 5) * tile.outline[2];
          const Vertex2 way = on - inner;
          bench.move(on, way, {one.rotor[0]}, {one.rotor[1]});
          ASSERT_EQ(bench.failing(tile.tile), slot);
          const auto move = bench.tiles->next(tile.tile, slot);
          ASSERT_TRUE(move);
          expect_beyond(bench, world, on, way, *move);
          if (testing::Test::HasFailure()) return;
        }
      }
    }
  });
}

// Inwards across the edges of the boxes' sum, from every half-plane.
TEST(MixedTiles, NeighboursOfHalfPlanes) {
  for_all([](Bench& bench, const Case& one) {
    const TileGeometry geometry = bench.geometry(one.rotor);
    const World world(geometry);
    int halves = 0;
    for (std::uint8_t z = 0; z < 2; ++z) {
      for (std::uint32_t e = 0; e < 4; ++e) {
        for (std::uint32_t u = 0; u < 4; ++u) {
          const Tile half{Kind::kHalf, z, e, u};
          const Vertex2 from = geometry.apex(z, (e + 3) % 4) + geometry.apex(1 - z, u);
          const Vertex2 to = geometry.apex(z, e) + geometry.apex(1 - z, u);
          const Vertex2 on = from + over(1237, 4001) * (to - from);
          const Vertex2 out{(to - from)[1], (from - to)[0]};
          bench.move(on, out, {one.rotor[0]}, {one.rotor[1]});
          if (!bench.holds(half)) continue;
          if (where(on, world.boxes) != 0) {  // a parallel edge of the other box prolongs it
            ADD_FAILURE() << "a half-plane beside the boxes";
            continue;
          }
          ++halves;
          const Vertex2 way = Rational(-1) * out;
          bench.move(on, way, {one.rotor[0]}, {one.rotor[1]});
          ASSERT_EQ(bench.failing(half), 0u);
          const auto move = bench.tiles->next(half, 0);
          ASSERT_TRUE(move);
          expect_beyond(bench, world, on, over(1, 1000) * way, *move);
        }
      }
    }
    EXPECT_GE(halves, 8);
  });
}

// Polygons with parallel edges turn through the pose in which they are parallel, both ways: a tile
// that is divided anew passes its points to the right one.
TEST(MixedTiles, FlipsAtParallelNormals) {
  const Polygon triangle{{0, 0}, {5, 1}, {2, 7}};
  Random random(23);
  std::vector<std::array<Polygon, 2>> pairs{
      {triangle, triangle},
      {rectangle(1, 1), rectangle(2, 3)},
      {regular(8, 0.3), regular(8, 0.3)},
      {scaled(regular(9), over(1, 20), over(1, 20)), scaled(regular(9), 2, 2)},
      {geometric_chain(7), minkowski_sum(geometric_chain(7), triangle)},
  };
  for (int i = 0; i < 6; ++i) {
    const Polygon p = random_hull(random, 9, 15);
    pairs.push_back({p, minkowski_sum(p, random_hull(random, 5, 9))});
  }
  int flips = 0;
  for (const auto& [a, b] : pairs) {
    for (const CutPolicy policy : {CutPolicy::kBalancedDudley, CutPolicy::kMedian}) {
      Bench bench(a, b, policy);
      for (const int turn : {1, -1}) {
        // Right before the instant, and right after it.
        const TileGeometry before = bench.geometry({1, 0}, turn > 0);
        const TileGeometry after = bench.geometry({1, 0}, turn < 0);
        const std::vector<PlacedTile> later = after.all();
        for (const PlacedTile& tile : before.all()) {
          for (int k = 0; k < 6; ++k) {
            Rational total;
            Vertex2 p{0, 0};
            for (const Vertex2& v : tile.outline) {
              const Rational weight(random.between(1, 1000));
              total += weight;
              p = p + weight * v;
            }
            p = (Rational(1) / total) * p;
            bench.move(p, {0, 0}, {1}, {0, turn});
            const PlacedTile* holder = nullptr;
            for (const PlacedTile& other : later) {
              if (where(p, other.outline) > 0) holder = &other;
            }
            if (holder == nullptr) continue;  // on the new side
            const std::uint32_t slot = bench.failing(tile.tile);
            if (slot == bench.tiles->certificates(tile.tile).count) {
              EXPECT_EQ(convex_hull(tile.outline), convex_hull(holder->outline));
              continue;
            }
            ASSERT_GE(slot, tile.count);
            const auto move = bench.tiles->next(tile.tile, slot);
            ASSERT_TRUE(move);
            ASSERT_TRUE(move->tile);
            ++flips;
            EXPECT_TRUE(bench.holds(*move->tile));
            EXPECT_EQ(convex_hull(after.placed(*move->tile).outline), convex_hull(holder->outline));
          }
        }
      }
    }
  }
  EXPECT_GT(flips, 300);
}

// Smaller polygons start later: at equal levels the errors are alike.
TEST(MixedTiles, SmallPolygonsWait) {
  const Bench alike(regular(8), regular(9), CutPolicy::kBalancedDudley);
  EXPECT_EQ(alike.offset, (std::array<int, 2>{0, 0}));
  const Bench small(regular(8), scaled(regular(9), over(1, 70), over(1, 70)),
                    CutPolicy::kBalancedDudley);
  EXPECT_EQ(small.offset, (std::array<int, 2>{0, 6}));
  const Bench large(regular(8), scaled(regular(9), 70, 70), CutPolicy::kBalancedDudley);
  EXPECT_EQ(large.offset, (std::array<int, 2>{6, 0}));
}

}  // namespace mixed_tiles_test
}  // namespace kinex::test
