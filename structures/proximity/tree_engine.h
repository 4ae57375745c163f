// SPDX-License-Identifier: GPL-3.0-or-later
// TreeEngine: the minimum spanning forest of a changing graph whose edges change their lengths.
//
// The owner adds and removes edges and calls finish(); failures are repaired by the engine. It
// holds the forest and reports through TreeEvents; tree_by_list.h, tree_by_cycles.h,
// tree_by_short_cycles.h, tree_by_clusters.h and tree_by_forests.h say how the forest is proved to
// be minimal.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_ENGINE_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_ENGINE_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/numbers/integer.h"
#include "structures/parts/link_cut_forest.h"
#include "structures/proximity/tree_edges.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class TreeEngine {
 public:
  // When edges have been added or removed:
  enum class Change {
    kSwap,   // at an instant, one edge took the place of another that is not in the tree
    kMany,   // at an instant, others
    kSized,  // objects came or went: no certificate may be left to fail
  };

  // `edges` and `events` outlive it. Ends are below `vertices`.
  TreeEngine(Kernel& kernel, StructureId id, const TreeEdges& edges, TreeEvents& events,
             std::size_t vertices)
      : kernel_(&kernel),
        id_(id),
        edges_(&edges),
        events_(&events),
        vertices_(vertices),
        forest_(vertices) {}
  virtual ~TreeEngine() = default;

  // "order", for example: the kind kTreeInside.
  virtual std::string_view inside_kind() const = 0;
  // Builds the tree of these edges and its proof, right after now; no call of finish is needed.
  virtual void build(std::vector<Item> items) = 0;
  // Adds an edge; removes one whose number is still valid.
  virtual void add(Item item) = 0;
  virtual void remove(Item item) = 0;
  virtual void finish(Change change) = 0;
  // An edge that has been removed is still in the proof: its number is still valid.
  virtual bool uses(Item) const { return false; }
  // A live certificate is one of this engine.
  virtual bool owns(CertificateId certificate) const = 0;
  virtual void certificate_failed(CertificateId failed) = 0;
  virtual void motions_changed(std::span<const ObjectId> objects) = 0;
  // The claims about these edges may be others now, after new motions of their objects: makes their
  // certificates anew where they are. Takes the place of motions_changed.
  virtual void renew(std::span<const Item> items) = 0;

  std::size_t size() const { return size_; }
  bool has(Item item) const { return item < state_.size() && state_[item] != State::kAbsent; }
  bool in_tree(Item item) const { return item < state_.size() && state_[item] == State::kInside; }
  // Its edges, ascending.
  std::vector<Item> tree() const;

  virtual void visit_proof(ProofVisitor& visitor) const = 0;
  // The largest number of certificates for this many edges and vertices.
  virtual Integer most_certificates(std::size_t edges, std::size_t vertices) const = 0;
  virtual std::string_view why_most() const = 0;
  // The most failures by which two edges exchange their order.
  virtual Integer most_failures_per_exchange() const { return Integer(1); }
  virtual void check(AuditReport& report) const = 0;
  virtual std::size_t bytes() const = 0;

 protected:
  void enter(Item item);
  void leave(Item item);
  void put_in(Item item);
  void take_out(Item item);
  // The same without the forest: for engines that change it later.
  void count_in(Item item);
  void count_out(Item item);
  void clear();
  EdgeIds ids(Item item) const { return edges_->ids(item); }
  // The ids of some edges, each once.
  std::vector<ObjectId> about(std::span<const Item> items) const;
  std::vector<Item> present() const;
  // The number of edges in the tree.
  std::size_t tree_size() const { return inside_; }
  // False after too many steps of a repair, which is then corrupt. Every swap makes the tree shorter,
  // or gives it a smaller edge of the same length; in an inexact arithmetic signs may contradict each
  // other.
  bool may_go_on(std::uint64_t steps);
  std::size_t base_bytes() const { return forest_.bytes() + state_.capacity() * sizeof(State); }

  Kernel* kernel_;
  StructureId id_;
  const TreeEdges* edges_;
  TreeEvents* events_;
  std::size_t vertices_;
  LinkCutForest forest_;

 private:
  enum class State : std::uint8_t { kAbsent, kOutside, kInside };
  std::vector<State> state_;  // by item
  std::size_t size_ = 0, inside_ = 0;
};

// How a spanning tree is proved.
enum class TreeProof { kList, kCycles, kShortCycles, kClusters, kForests };
// The engine, and what it takes besides.
struct TreeMethod {
  TreeProof proof;
  std::size_t cluster = 0;  // of TreeByClusters: the size of a cluster
  std::size_t items = 0;    // of TreeByForests: numbers of edges are below
};
// With the arguments of TreeEngine. Of kShortCycles the edges must be AdjacentEdges: else std::bad_cast.
std::unique_ptr<TreeEngine> make_tree_engine(const TreeMethod& method, Kernel& kernel, StructureId id,
                                             const TreeEdges& edges, TreeEvents& events,
                                             std::size_t vertices);

}  // namespace kinex

#endif
