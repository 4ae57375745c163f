// SPDX-License-Identifier: GPL-3.0-or-later
// The partition of a changing forest: trees with vertices of many edges, which are split.
#include "structures/proximity/tree_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace tree_clusters_test {

using Tree = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Tree star(std::uint32_t n) {
  Tree tree;
  for (std::uint32_t v = 1; v < n; ++v) tree.emplace_back(0, v);
  return tree;
}

// A path of which each vertex has this many leaves.
Tree caterpillar(std::uint32_t path, std::uint32_t leaves) {
  Tree tree;
  for (std::uint32_t v = 1; v < path; ++v) tree.emplace_back(v - 1, v);
  for (std::uint32_t i = 0; i < path * leaves; ++i) tree.emplace_back(i / leaves, path + i);
  return tree;
}

// A path whose last vertex has leaves.
Tree broom(std::uint32_t path, std::uint32_t leaves) {
  Tree tree;
  for (std::uint32_t v = 1; v < path; ++v) tree.emplace_back(v - 1, v);
  for (std::uint32_t i = 0; i < leaves; ++i) tree.emplace_back(path - 1, path + i);
  return tree;
}

// From one vertex many paths of one length.
Tree spider(std::uint32_t legs, std::uint32_t length) {
  Tree tree;
  for (std::uint32_t i = 0; i < legs * length; ++i) {
    tree.emplace_back(i % length == 0 ? 0 : i, i + 1);
  }
  return tree;
}

// Every vertex hangs on one of the first few, or on any that is there.
Tree random_tree(Random& random, int n, int hubs, int percent) {
  Tree tree;
  for (int v = 1; v < n; ++v) {
    const int most = random.chance(percent) ? std::min(hubs, v) : v;
    tree.emplace_back(static_cast<std::uint32_t>(random.between(0, most - 1)),
                      static_cast<std::uint32_t>(v));
  }
  return tree;
}

void link(TreeClusters& clusters, Item edge, std::uint32_t u, std::uint32_t v) {
  for (const std::uint32_t end : {u, v}) {
    const TreeClusters::Copy copy = clusters.hook(end);
    if (clusters.of(copy) != TreeClusters::kNone) clusters.dissolve(clusters.of(copy));
    clusters.loosen(copy);
  }
  clusters.link(edge, clusters.hook(u), clusters.hook(v));
}

void cut(TreeClusters& clusters, Item edge) {
  for (const TreeClusters::Copy end : clusters.ends(edge)) {
    if (clusters.of(end) != TreeClusters::kNone) clusters.dissolve(clusters.of(end));
  }
  clusters.cut(edge);
}

void expect_bounds(const TreeClusters& clusters, std::size_t size) {
  EXPECT_EQ(clusters.defect(), "");
  EXPECT_LE(clusters.largest(), 2 * size - 1);
}

// All at once, in clusters of several sizes.
void cut_whole(const Tree& tree) {
  const std::size_t n = tree.size() + 1;
  for (const std::size_t size : {1u, 2u, 3u, 5u, 8u, 13u, 200u}) {
    SCOPED_TRACE(size);
    TreeClusters clusters(n);
    for (Item edge = 0; edge < tree.size(); ++edge) {
      link(clusters, edge, tree[edge].first, tree[edge].second);
    }
    clusters.gather(size);
    expect_bounds(clusters, size);
    EXPECT_EQ(clusters.linked(), n);
    EXPECT_LE(clusters.count(), n / size + 1);
  }
}

TEST(TreeClusters, VerticesOfManyEdgesAreSplit) {
  cut_whole(star(100));
  cut_whole(caterpillar(12, 9));
  cut_whole(caterpillar(40, 2));
  cut_whole(broom(60, 40));
  cut_whole(spider(30, 4));
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    cut_whole(random_tree(random, 80, 1 + i % 4, 90));
  }
}

// A star of 100 vertices in clusters of 10: nine times ten leaves with a copy of the hub, and nine
// leaves with the hub itself.
TEST(TreeClusters, AStar) {
  TreeClusters clusters(100);
  const Tree tree = star(100);
  for (Item edge = 0; edge < tree.size(); ++edge) link(clusters, edge, 0, edge + 1);
  clusters.gather(10);
  EXPECT_EQ(clusters.count(), 10u);
  EXPECT_EQ(clusters.copies(0).size(), 10u);
  EXPECT_EQ(clusters.largest(), 11u);
  EXPECT_EQ(clusters.copies(1).size(), 1u);
  // What is left of it: an edge.
  for (Item edge = 1; edge < tree.size(); ++edge) cut(clusters, edge);
  clusters.gather(10);
  EXPECT_EQ(clusters.defect(), "");
  EXPECT_EQ(clusters.linked(), 2u);
  EXPECT_EQ(clusters.copies(0).size(), 1u);
  EXPECT_EQ(clusters.copies(5).size(), 0u);
}

// Edges come and go at hubs; copies meet, vanish, and are made again.
TEST(TreeClusters, HubsThatChange) {
  std::size_t most_copies = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::size_t size = 1 + seed % 5;
    const int n = 60, hubs = 2;
    TreeClusters clusters(n);
    std::vector<std::uint32_t> parent(n, n);  // n: none
    for (int step = 0; step < 150; ++step) {
      const int changes = step == 0 ? 100 : random.between(1, 3);
      for (int i = 0; i < changes; ++i) {
        const auto v = static_cast<std::uint32_t>(random.between(hubs, n - 1));
        if (parent[v] < n) {
          cut(clusters, v);
          parent[v] = n;
        } else {
          parent[v] = static_cast<std::uint32_t>(random.chance(80)
                                                     ? random.between(0, hubs - 1)
                                                     : random.between(0, static_cast<int>(v) - 1));
          link(clusters, v, parent[v], v);
        }
      }
      if (clusters.any_loose()) clusters.gather(size);
      expect_bounds(clusters, size);
      most_copies = std::max(most_copies, clusters.copies(0).size());
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(most_copies, 8u);
}

}  // namespace tree_clusters_test
}  // namespace kinex::test
