// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeExtrema: longest and shortest of some edges, each of two: of an edge or such an extremum and
// another one. And bounds: one of them is at most as long as another one.
//
//     a   b                one certificate a node: "the loser is at most as long as the winner" (kLongest),
//      \ /                 or the reverse (kShortest). When it fails the other operand is the value, and
//     {a, b}   c           what reads the node is decided again, and so on.
//         \   /
//       {a, b, c}  <=  f   a bound has no value: when it fails the owner repairs itself
//
// The owner drops what reads a node before the node. Comparisons are made right after now.
//
// Cost: one certificate a node. A failure renews those of the nodes that read it and have another
// value from now on, or another operand.
//
// Ties. Of edges whose lengths are identically equal goes_first decides (EdgeOrder). A bound between
// two such edges in the other order is noted (tied()).
#ifndef KINEX_STRUCTURES_PROXIMITY_EDGE_EXTREMA_H
#define KINEX_STRUCTURES_PROXIMITY_EDGE_EXTREMA_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "structures/parts/slots.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class EdgeExtrema {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffffu;
  enum class Kind : std::uint8_t { kAbsent, kLongest, kShortest, kBound };
  // An edge, or the extremum of a node; or none.
  struct Value {
    Item edge = kNoItem;
    Node node = kNone;
    bool none() const { return edge == kNoItem && node == kNone; }
    static Value of_edge(Item edge) { return {edge, kNone}; }
    static Value of_node(Node node) { return {kNoItem, node}; }
    friend bool operator==(const Value&, const Value&) = default;
  };

  // `edges` outlives it.
  EdgeExtrema(Kernel& kernel, StructureId id, const TreeEdges& edges)
      : slots_(kernel, id, "extrema"), edges_(&edges) {}

  // The longest or the shortest of the two; or the bound "`one` is at most as long as `other`".
  Node make(Kind kind, const Value& one, const Value& other);
  // Nothing reads it.
  void drop(Node node);
  void clear();
  // Another operand, in the place 0 or 1.
  void set_operand(Node node, std::size_t place, const Value& value);
  // The edge; requires that there is one.
  Item edge(const Value& value) const {
    return value.node == kNone ? value.edge : entries_[value.node].value;
  }
  // All edges of which the value is an extremum.
  std::vector<Item> edges_of(const Value& value) const;

  // What a failed certificate said.
  struct Failure {
    bool bound;
    Item before, after;  // the values of the node; or the two edges of the bound
  };
  bool owns(CertificateId certificate) const { return slots_.owns(certificate); }
  // A certificate has failed: repairs all nodes. A bound stays for the owner to repair.
  Failure failed(CertificateId failed);
  // New motions of objects: puts the ties in order that came with them.
  void motions_changed(std::span<const ObjectId> objects);
  // The claims about these edges may be others now.
  void renew(std::span<const Item> items);

  // Bounds between edges that are level in the wrong order, and bounds that were negative when they
  // were made: the latest first, each once, as of now. nullopt: there is none.
  struct Broken {
    Item shorter, longer;  // as the bound claims
  };
  std::optional<Broken> next_tied();
  std::optional<Broken> next_failing();
  void forget_failing() { failing_.clear(); }

  // Calls visit(node, kind, value, other, certificate) for all nodes: two edges, of which the second
  // is the longer one.
  template <class Visit>
  void each(const Visit& visit) const {
    for (Node node = 0; node < entries_.size(); ++node) {
      const Entry& entry = entries_[node];
      if (entry.kind == Kind::kAbsent) continue;
      const auto [shorter, longer] = compared(entry);
      visit(node, entry.kind, shorter, longer, entry.certificate);
    }
  }
  // The number of nodes.
  std::size_t size() const { return entries_.size() - free_.size(); }
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Entry {
    Kind kind = Kind::kAbsent;
    std::array<Value, 2> operands;
    Item value = kNoItem;
    CertificateId certificate = kNoCertificate;
    std::vector<Node> readers;
  };

  EdgeOrder order() const { return EdgeOrder(*edges_); }
  std::array<Item, 2> compared(const Entry& entry) const;
  void read(Node node, const Value& value);
  void unread(Node node, const Value& value);
  void refresh(Node node);
  void changed(Node node);
  std::optional<Broken> broken(Node node, Outlook outlook) const;

  Slots slots_;
  const TreeEdges* edges_;
  std::vector<Entry> entries_;
  std::vector<Node> free_;
  std::vector<Node> tied_, failing_;  // bounds to be looked at
};

}  // namespace kinex

#endif
