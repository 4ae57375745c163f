// SPDX-License-Identifier: GPL-3.0-or-later
// Readers that follow the edges of triangulations by what was touched: at whatever times they look, they
// have the edges that there are.
#include "structures/triangulation/edge_journal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
}

// One change after the other, each in any order; what comes between is not passed over.
TEST(EdgeJournal, BehindOneChange) {
  EdgeJournal journal;
  const auto begin = journal.position();
  journal.touch(1, 2);
  journal.touch(3, 4);
  journal.touch(5, 6);
  const Edges first{{3, 4}, {1, 2}}, second{{5, 6}}, third{{7, 8}}, twice{{1, 2}, {1, 2}};
  const auto middle = journal.behind(begin, first);
  EXPECT_EQ(middle, begin + 2);
  EXPECT_EQ(journal.behind(begin, second), begin);
  EXPECT_EQ(journal.behind(begin, twice), begin);
  EXPECT_EQ(journal.behind(begin, {}), begin);
  EXPECT_EQ(journal.behind(middle, second), journal.position());
  EXPECT_EQ(journal.behind(journal.position(), third), journal.position());
  EXPECT_EQ(journal.behind(0, first), 0u);
}

TEST(EdgeJournal, Forgets) {
  EdgeJournal journal;
  const auto begin = journal.position();
  journal.forget();
  EXPECT_EQ(journal.since(begin), std::nullopt);
  EXPECT_EQ(journal.behind(begin, {}), begin);
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
    seen_.look(
        [&] {
          edges_ = {right.begin(), right.end()};
        },
        [this](const Edge& edge, bool is_there) {
          ++by_touched;
          if (is_there) {
            edges_.insert(edge);
          } else {
            edges_.erase(edge);
          }
        });
    ASSERT_EQ(Edges(edges_.begin(), edges_.end()), right);
  }
  int by_all() const { return static_cast<int>(seen_.full_looks()); }
  int by_touched = 0;

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
  looks.by_all += sink.readers[0].by_all();
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

// A structure that follows the events, and looks when points come and go: after thousands of flips, too.
class Follower final : public Structure {
 public:
  Follower(Kernel&, StructureId, const DelaunayGraph& graph) : graph_(graph), seen_(graph) {}
  std::string_view name() const override { return "follower"; }
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void build(std::span<const ObjectId>) override { look(); }
  void rebuild() override {}
  void certificate_failed(CertificateId) override {}
  void insert(ObjectId) override { look(); }
  void erase(ObjectId) override { look(); }
  void watched_changed(const Event* event) override {
    const auto change = graph_.told(event);
    if (!change) return look();
    if (change->gone) edges_.erase(*change->gone);
    if (change->came) edges_.insert(*change->came);
    seen_.followed(*change);
    ++followed;
  }
  Attribute attribute() const override { return {}; }
  void visit_proof(ProofVisitor&) const override {}
  std::vector<BoundCheck> bounds(const BoundContext&) const override { return {}; }
  void check_invariants(AuditReport&) const override {}
  void audit(const Snapshot&, AuditReport&) const override {}
  std::size_t bytes() const override { return 0; }
  void expect_all() const { EXPECT_EQ(Edges(edges_.begin(), edges_.end()), graph_.edges()); }
  std::uint64_t full_looks() const { return seen_.full_looks(); }
  int followed = 0;

 private:
  void look() {
    seen_.look(
        [this] {
          const Edges all = graph_.edges();
          edges_ = {all.begin(), all.end()};
        },
        [this](const Edge& edge, bool is_there) {
          if (is_there) {
            edges_.insert(edge);
          } else {
            edges_.erase(edge);
          }
        });
  }
  DelaunayGraph graph_;
  SeenEdges<DelaunayGraph> seen_;
  std::set<Edge> edges_;
};

TEST(EdgeJournal, FollowersNeedNotReadAllLater) {
  Scene scene = reference_scene(300, 2, 7);
  for (std::size_t i = 290; i < 300; ++i) {  // late
    scene.objects[i].motion.pieces[0].from =
        Rational(Integer(static_cast<std::int64_t>(i)), Integer(31));
  }
  scene.maintain = {Request{"delaunay_2", "delaunay_2", {}}};
  Simulator simulator(scene, planned_arithmetic("exact", scene), Trial::options(AuditLevel::kNone));
  add_structures(simulator, scene);
  const StructureId id = simulator.reserve();
  auto made =
      std::make_unique<Follower>(simulator.kernel(), id, DelaunayGraph::of(simulator.structure(0)));
  const Follower& follower = *made;
  simulator.add(id, std::move(made), "follower", {0});
  simulator.start();
  simulator.run_until(std::nullopt);
  follower.expect_all();
  EXPECT_GT(follower.followed, 5000);
  EXPECT_EQ(follower.full_looks(), 1u);
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
