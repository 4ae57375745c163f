// SPDX-License-Identifier: GPL-3.0-or-later
// The epochs of a tournament's nodes, against a count of each of them by definition.
#include "structures/parts/tournament_epochs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/engine/bound.h"

namespace kinex::test {
namespace tournament_epochs_test {

std::size_t leaves_below(std::size_t node, std::size_t leaves) {
  if (node >= leaves) return 1;
  return leaves_below(2 * node, leaves) + leaves_below(2 * node + 1, leaves);
}

class CountedEpochs {
 public:
  void begin(const std::vector<TournamentEpochs::Node>& nodes, std::size_t leaves) {
    std::set<std::size_t> inner;
    for (const std::size_t node : nodes) {
      for (std::size_t v = node; v > 0; v /= 2) {
        if (v < leaves) inner.insert(v);
      }
    }
    for (const std::size_t v : inner) {
      const std::size_t below = leaves_below(v, leaves);
      pairs_ += Integer(static_cast<std::int64_t>((below / 2) * (below - below / 2)));
      changes_ += davenport_schinzel_bound(2, counted(below)) - Integer(1);
    }
  }
  const Integer& pairs() const { return pairs_; }
  const Integer& changes() const { return changes_; }

 private:
  Integer pairs_{0}, changes_{0};
};

// The sizes change at every call, seldom, or never; changes begin at one node, or at several that may
// be equal, one above another, leaves or 0. The bounds are read at any time.
TEST(TournamentEpochs, AreThoseOfEveryNodeAtOrAboveAChange) {
  std::mt19937_64 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (const std::size_t stays : {1, 5, 1000}) {
    for (const std::size_t most : {1, 2, 3, 5, 8, 13, 64, 100}) {
      TournamentEpochs epochs;
      CountedEpochs expected;
      std::size_t leaves = most;
      for (std::size_t call = 0; call < 300; ++call) {
        if (below(stays) == 0) leaves = 1 + below(most);
        std::vector<TournamentEpochs::Node> nodes(below(6));
        for (TournamentEpochs::Node& v : nodes) {
          v = static_cast<TournamentEpochs::Node>(below(2 * leaves));
        }
        epochs.begin(nodes, leaves);
        expected.begin(nodes, leaves);
        if (call % 50 != 49 && call > 3) continue;
        ASSERT_EQ(epochs.most_failures_of_pairs(1), expected.pairs()) << leaves << " leaves";
        ASSERT_EQ(epochs.most_failures(2), expected.changes()) << leaves << " leaves";
      }
    }
  }
}

}  // namespace tournament_epochs_test
}  // namespace kinex::test
