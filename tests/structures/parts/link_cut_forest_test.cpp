// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/link_cut_forest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace link_cut_forest_test {

using Node = LinkCutForest::Node;

// The same forest as lists of neighbours.
class PlainForest {
 public:
  explicit PlainForest(std::size_t n) : at_(n) {}
  void link(Node e, Node u, Node v) {
    at_[u].push_back({e, v});
    at_[v].push_back({e, u});
  }
  void cut(Node e, Node u, Node v) {
    for (const Node w : {u, v}) {
      std::erase_if(at_[w], [e](const auto& one) { return one[0] == e; });
    }
  }
  // The edges from u to v, or {none} if there is no path.
  std::vector<Node> path(Node u, Node v, Node from = kNone) const {
    if (u == v) return {};
    for (const auto& [e, w] : at_[u]) {
      if (e == from) continue;
      std::vector<Node> rest = path(w, v, e);
      if (!rest.empty() && rest.back() == kNone) continue;
      rest.insert(rest.begin(), e);
      return rest;
    }
    return {kNone};
  }
  static constexpr Node kNone = 0xffffffffu;

 private:
  std::vector<std::vector<std::array<Node, 2>>> at_;
};

TEST(LinkCutForest, AgreesWithAPlainForest) {
  std::size_t links = 0, cuts = 0, longest = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(20u); ++seed) {
    Random random(seed);
    const int n = random.between(2, 24);
    LinkCutForest forest(static_cast<std::size_t>(n));
    PlainForest plain(static_cast<std::size_t>(n));
    std::map<Node, std::array<Node, 2>> edges;
    Node next = 0;
    for (int step = 0; step < 400; ++step) {
      const Node u = static_cast<Node>(random.between(0, n - 1));
      const Node v = static_cast<Node>(random.between(0, n - 1));
      const std::vector<Node> path = plain.path(u, v);
      const bool connected = path.empty() || path.back() != PlainForest::kNone;
      ASSERT_EQ(forest.connected(u, v), connected);
      if (!connected) {
        forest.link(next, u, v);
        plain.link(next, u, v);
        edges[next++] = {u, v};
        ++links;
        continue;
      }
      ASSERT_EQ(forest.path(u, v), path);
      longest = std::max(longest, path.size());
      for (const auto& [edge, ends] : edges) {
        const bool on = std::find(path.begin(), path.end(), edge) != path.end();
        ASSERT_EQ(forest.on_path(edge, u, v), on);
      }
      if (path.empty() || random.between(0, 2) != 0) continue;
      const Node edge = path[path.size() / 2];
      forest.cut(edge, edges[edge][0], edges[edge][1]);
      plain.cut(edge, edges[edge][0], edges[edge][1]);
      edges.erase(edge);
      ++cuts;
    }
  }
  EXPECT_GT(links, test::seen_in_fewer(500u));
  EXPECT_GT(cuts, test::seen_in_fewer(400u));
  EXPECT_GT(longest, test::seen_in_fewer(8u));
}

}  // namespace link_cut_forest_test
}  // namespace kinex::test
