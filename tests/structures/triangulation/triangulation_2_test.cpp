// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/triangulation_2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace kinex {
namespace triangulation_2_test {

using HalfEdge = Triangulation2::HalfEdge;
constexpr std::uint32_t kNone = Triangulation2::kNone;

std::set<std::pair<ObjectId, ObjectId>> edges(const Triangulation2& t) {
  std::set<std::pair<ObjectId, ObjectId>> result;
  for (HalfEdge h = 0; h < t.half_edge_capacity(); ++h) {
    if (t.live(Triangulation2::triangle(h)) && t.origin(h) < t.target(h)) {
      result.emplace(t.origin(h), t.target(h));
    }
  }
  return result;
}

HalfEdge find(const Triangulation2& t, ObjectId a, ObjectId b) {
  HalfEdge h = t.out(a);
  do {
    if (t.target(h) == b) return h;
    h = t.around(h);
  } while (h != t.out(a));
  return kNone;
}

TEST(Triangulation2, OneTriangleIsATetrahedronOnTheSphere) {
  Triangulation2 t(5);
  t.start(3, 1, 4);
  EXPECT_EQ(t.defect(), "");
  EXPECT_EQ(t.vertices(), 3u);
  EXPECT_EQ(t.triangles(), 4u);
  EXPECT_EQ(edges(t).size(), 6u);
  const HalfEdge h = find(t, 3, 1);
  EXPECT_EQ(t.apex(h), 4u);
  EXPECT_EQ(t.apex(t.twin(h)), t.infinity());
  EXPECT_TRUE(t.ghost(Triangulation2::triangle(t.twin(h))));
  EXPECT_FALSE(t.has(0));
}

TEST(Triangulation2, StarOfOneTriangleAndItsRemoval) {
  Triangulation2 t(4);
  t.start(0, 1, 2);
  for (HalfEdge h = 0; h < t.half_edge_capacity(); ++h) t.set_label(h, 7);
  std::vector<HalfEdge> rim;
  ASSERT_TRUE(t.star(3, {Triangulation2::triangle(find(t, 0, 1))}, rim));
  EXPECT_EQ(t.defect(), "");
  EXPECT_EQ(t.vertices(), 4u);
  EXPECT_EQ(rim.size(), 3u);
  for (const HalfEdge h : rim) {
    EXPECT_EQ(t.apex(h), 3u);
    EXPECT_EQ(t.label(h), 7u);
    EXPECT_EQ(t.label(Triangulation2::next(h)), kNone);
  }
  std::vector<Triangulation2::Triangle> filled;
  t.fill(3, {{0, 1, 2}}, filled);
  EXPECT_EQ(t.defect(), "");
  EXPECT_EQ(filled.size(), 1u);
  EXPECT_EQ(edges(t).size(), 6u);
  EXPECT_FALSE(t.has(3));
}

TEST(Triangulation2, FlipThereAndBack) {
  Triangulation2 t(4);
  t.start(0, 1, 2);
  std::vector<HalfEdge> rim;
  const HalfEdge hull = find(t, 0, 1);
  ASSERT_TRUE(
      t.star(3, {Triangulation2::triangle(hull), Triangulation2::triangle(t.twin(hull))}, rim));
  EXPECT_EQ(t.defect(), "");
  const auto before = edges(t);
  EXPECT_EQ(before.count({0, 1}), 0u);
  // 2 3 is an edge between 0 and 1 now
  const HalfEdge h = find(t, 2, 3);
  t.set_label(h, 5);
  HalfEdge d = t.flip(h);
  EXPECT_EQ(t.defect(), "");
  EXPECT_EQ(t.label(d), 5u);
  EXPECT_EQ(edges(t).count({0, 1}), 1u);
  EXPECT_EQ(edges(t).count({2, 3}), 0u);
  EXPECT_EQ(t.target(Triangulation2::next(d)), 3u);  // its triangle is p, q, v with v = 3
  d = t.flip(d);
  EXPECT_EQ(edges(t), before);
  EXPECT_EQ(t.defect(), "");
}

TEST(Triangulation2, RefusesCavitiesThatAreNoDiscs) {
  Triangulation2 t(6);
  t.start(0, 1, 2);
  std::vector<HalfEdge> rim;
  ASSERT_TRUE(t.star(3, {Triangulation2::triangle(find(t, 0, 1))}, rim));
  std::vector<Triangulation2::Triangle> around;  // all of vertex 3: it would be swallowed
  for (const HalfEdge h : rim) around.push_back(Triangulation2::triangle(h));
  const auto before = edges(t);
  EXPECT_FALSE(t.star(4, around, rim));
  EXPECT_EQ(edges(t), before);
  EXPECT_EQ(t.defect(), "");
}

// Random flips, insertions and removals keep a sphere; removal undoes insertion.
TEST(Triangulation2, RandomChanges) {
  std::mt19937_64 random(1);
  const std::size_t objects = 40;
  Triangulation2 t(objects);
  t.start(0, 1, 2);
  std::vector<HalfEdge> rim, link;
  std::vector<Triangulation2::Triangle> filled;
  const auto grow = [&] {
    for (ObjectId v = 3; v < objects; ++v) {
      if (t.has(v)) continue;
      Triangulation2::Triangle s;
      do s = static_cast<std::uint32_t>(random() % t.triangle_capacity());
      while (!t.live(s));
      ASSERT_TRUE(t.star(v, {s}, rim));
      ASSERT_EQ(t.defect(), "");
    }
  };
  for (int round = 0; round < 20; ++round) {
    grow();
    for (int i = 0; i < 200; ++i) {
      const auto h = static_cast<HalfEdge>(random() % t.half_edge_capacity());
      if (!t.live(Triangulation2::triangle(h))) continue;
      if (find(t, t.apex(h), t.apex(t.twin(h))) != kNone) continue;  // there already
      const ObjectId u = t.origin(h), v = t.target(h);
      t.flip(h);
      ASSERT_EQ(t.defect(), "");
      ASSERT_EQ(find(t, u, v), kNone);
    }
    for (ObjectId v = 0; v < objects; ++v) {
      if (!t.has(v)) continue;
      t.link(v, link);
      if (link.size() != 3 || t.vertices() == 3 || random() % 2 != 0) continue;
      t.fill(v, {{1, 2, 0}}, filled);
      ASSERT_EQ(t.defect(), "");
    }
  }
}

TEST(Triangulation2, FillsALongLinkByAFan) {
  Triangulation2 t(9);
  t.start(0, 1, 2);
  std::vector<HalfEdge> rim, link;
  std::vector<Triangulation2::Triangle> filled;
  for (ObjectId v = 3; v < 9; ++v) {
    ASSERT_TRUE(t.star(v, {Triangulation2::triangle(find(t, 0, v == 3 ? 1 : v - 1))}, rim));
  }
  t.link(0, link);
  const auto k = static_cast<std::uint32_t>(link.size());
  ASSERT_GT(k, 6u);
  std::vector<Triangulation2::Ear> ears;
  const auto hub = static_cast<std::uint32_t>(
      std::find_if(link.begin(), link.end(),
                   [&](HalfEdge h) { return t.origin(h) == t.infinity(); }) -
      link.begin());
  for (std::uint32_t i = 1; i + 1 < k; ++i) {
    ears.push_back({hub, (hub + i) % k, (hub + i + 1) % k});
  }
  const std::size_t before = t.triangles();
  t.fill(0, ears, filled);
  EXPECT_EQ(filled.size(), k - 2);
  EXPECT_EQ(t.triangles(), before - 2);
  EXPECT_FALSE(t.has(0));
  // Vertices that were only next to 0 and infinity may have two neighbours now; links are sound.
  for (HalfEdge h = 0; h < t.half_edge_capacity(); ++h) {
    if (!t.live(Triangulation2::triangle(h))) continue;
    EXPECT_EQ(t.twin(t.twin(h)), h);
    EXPECT_EQ(t.origin(h), t.target(t.twin(h)));
  }
}

}  // namespace triangulation_2_test
}  // namespace kinex
