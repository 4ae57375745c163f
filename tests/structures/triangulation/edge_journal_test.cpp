// SPDX-License-Identifier: GPL-3.0-or-later
// Readers that follow the edges of triangulations by what was touched: at whatever times they look, they
// have the edges that there are.
#include "structures/triangulation/edge_journal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "structures/plan.h"
#include "structures/proximity/regular_edges.h"
#include "structures/proximity/seen_edges.h"
#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace edge_journal_test {

using Edge = EdgeJournal::Edge;
using Edges = std::vector<Edge>;

TEST(EdgeJournal, TellsWhatWasTouchedSince) {
  EdgeJournal journal;
  const auto begin = journal.position();
  EXPECT_EQ(journal.since(begin), Edges{});
  EXPECT_EQ(journal.since(0), std::nullopt);
  journal.touch(5, 2);
  const auto middle = journal.position();
  journal.touch(1, 3);
  journal.touch(2, 5);
  journal.touch(1, 3);
  EXPECT_EQ(journal.since(begin), (Edges{{1, 3}, {2, 5}}));
  EXPECT_EQ(journal.since(middle), (Edges{{1, 3}, {2, 5}}));
  EXPECT_EQ(journal.since(journal.position()), Edges{});
  const Edges both{{2, 5}, {1, 3}}, one{{1, 3}};
  EXPECT_TRUE(journal.are_all_since(middle, both));
  EXPECT_FALSE(journal.are_all_since(middle, one));
  EXPECT_TRUE(journal.are_all_since(journal.position(), {}));
  EXPECT_FALSE(journal.are_all_since(0, both));
}

TEST(EdgeJournal, Forgets) {
  EdgeJournal journal;
  const auto begin = journal.position();
  journal.forget();
  EXPECT_EQ(journal.since(begin), std::nullopt);
  EXPECT_FALSE(journal.are_all_since(begin, {}));
  const auto seen = journal.position();
  std::size_t most = 0;
  for (ObjectId i = 0; i < 100'000; ++i) {
    journal.touch(i, i + 1);
    most = std::max(most, journal.bytes());
  }
  EXPECT_EQ(journal.since(seen), std::nullopt);
  EXPECT_LE(most, 32u << 10);
  // A reader that keeps up is never told to read all.
  for (ObjectId i = 0; i < 10'000; ++i) {
    const auto before = journal.position();
    journal.touch(i, i + 1);
    EXPECT_EQ(journal.since(before), (Edges{{i, i + 1}}));
  }
  const auto last = journal.position();
  journal.touch(7, 6);
  EXPECT_EQ(journal.since(last), (Edges{{6, 7}}));
}

// Looks at every stride-th chance.
template <class Graph>
class Reader {
 public:
  Reader(const Graph& graph, int stride) : graph_(&graph), seen_(graph), stride_(stride) {}

  void look() {
    if (++chances_ % stride_ != 0) return;
    const Edges right = graph_->edges();
    if (const auto touched = seen_.look()) {
      ++by_touched;
      for (const Edge& edge : *touched) {
        if (graph_->has(edge)) {
          edges_.insert(edge);
        } else {
          edges_.erase(edge);
        }
      }
    } else {
      ++by_all;
      edges_ = {right.begin(), right.end()};
    }
    ASSERT_EQ(Edges(edges_.begin(), edges_.end()), right);
  }
  int by_touched = 0, by_all = 0;

 private:
  const Graph* graph_;
  SeenEdges<Graph> seen_;
  int stride_, chances_ = 0;
  std::set<Edge> edges_;
};

// In the midst of instants, too.
template <class Graph>
class ReadersSink final : public EventSink {
 public:
  explicit ReadersSink(const Graph& graph) {
    for (const int stride : {1, 2, 7}) readers.emplace_back(graph, stride);
  }
  void event(const Event&, Arithmetic&) override { look(); }
  void instant_ended() override { look(); }
  void look() {
    for (auto& reader : readers) reader.look();
  }
  std::vector<Reader<Graph>> readers;
};

struct Looks {
  int by_touched = 0, by_all = 0;
};

template <class Graph>
void read_along(Scene scene, const std::string& structure, const std::string& arithmetic,
                Looks& looks) {
  scene.maintain = {Request{structure, structure, {}}};
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene),
                      Trial::options(AuditLevel::kNone));
  add_structures(simulator, scene);
  const Graph graph = Graph::of(simulator.structure(0));
  ReadersSink sink(graph);
  simulator.set_sink(&sink);
  simulator.start();
  sink.look();
  simulator.run_until(std::nullopt);
  sink.look();
  looks.by_touched += sink.readers[0].by_touched;
  looks.by_all += sink.readers[0].by_all;
}

// Points that come and go, meet, part, and are on one line or in one plane.
TEST(EdgeJournal, ReadersHaveAllEdges) {
  for (const char* arithmetic : {"exact", "double"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(60u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + " " + std::to_string(seed));
      const int n = 4 + static_cast<int>(seed % 6);
      Looks any;
      for (const int dimension : {2, 3}) {
        const std::string axes = std::to_string(dimension);
        for (const Scene& scene : {random_flights(seed, n, dimension, 2, seed % 3 != 0),
                                   lattice_scene(seed, n, dimension)}) {
          read_along<DelaunayGraph>(scene, "delaunay_" + axes, arithmetic, any);
          read_along<RegularGraph>(scene, "regular_" + axes, arithmetic, any);
        }
      }
      EXPECT_GT(any.by_touched, 0);
    }
  }
}

// Points in general position come and go: readers look at all edges when they begin, and then at what was
// touched.
TEST(EdgeJournal, AllEdgesAreReadOnce) {
  for (const int dimension : {2, 3}) {
    Scene scene = reference_scene(60, dimension, 5);
    for (std::size_t i = 40; i < 60; ++i) {
      auto& piece = scene.objects[i].motion.pieces[0];
      if (i % 2 == 0) piece.from = Rational(Integer(static_cast<std::int64_t>(i)), Integer(7));
      if (i % 2 == 1) piece.to = Rational(Integer(static_cast<std::int64_t>(i)), Integer(5));
    }
    const std::string axes = std::to_string(dimension);
    Looks delaunay, regular;
    read_along<DelaunayGraph>(scene, "delaunay_" + axes, "exact", delaunay);
    read_along<RegularGraph>(scene, "regular_" + axes, "exact", regular);
    for (const Looks& looks : {delaunay, regular}) {
      SCOPED_TRACE(dimension);
      EXPECT_EQ(looks.by_all, 1);
      EXPECT_GT(looks.by_touched, 100);
    }
  }
}

}  // namespace edge_journal_test
}  // namespace kinex::test
