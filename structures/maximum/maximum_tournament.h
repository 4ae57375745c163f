// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumTournament: the object with the largest (or smallest) key, by a tournament tree.
//
// Certificates. The tree is complete and lies in an array: the children of node v are 2v and 2v +
// 1, the leaves are n .. 2n - 1 (in the scene's order at the start). One certificate per inner
// node: the winner of one child is at least as good as the winner of the other; degree D in t, that
// of the key.
//
//               1: a                 node 2 fails: c wins there from now on, and then at every
//            ____|____               node above where it beats the other child's winner. The
//         2: a       3: e            certificates on that path are renewed, up to where c loses.
//        __|__       __|__
//     4: a   5: c  6: e   7: f       n = 4; leaves 4 .. 7
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        ceil(log2 n) certificates an object, the depth
//   responsiveness  O(log n) certificates, those on the path; an insertion or erasure moves at most
//                   two objects, O(log n) certificates
//   efficiency      not strongly efficient: the maximum may change O(1) times while Theta(n) events
//                   are processed
// Events, without flight-plan changes: at most the sum over inner nodes v of lambda_D(m_v) - 1,
// with m_v the number of leaves under v: n log2 n - n + 1 for lines and n a power of two, which is
// reached. The maximum changes at most lambda_D(n) - 1 times. (Several failures at one instant
// count one by one: the winners of a node still form a Davenport-Schinzel sequence of order D,
// since each is strictly better than the last right after the instant and equal to it at the
// instant; roots counted with multiplicity.)
// A change of motion, an insertion or an erasure begins a new epoch of every node on the paths from
// its leaves to the root. Each epoch of a node has at most lambda_D(m_v) - 1 events: the winner
// from before the change is the first of the sequence, since its key is no less than the others' at
// the instant. So an update adds the sum over its paths to the bound, about 2 n for lines.
//
// Ties. Of objects with identically equal keys the smallest id wins.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; Basch,
// Guibas, Hershberger, "Data structures for mobile data" (1999).
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_TOURNAMENT_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_TOURNAMENT_H

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/maximum/maximum_events.h"
#include "structures/parts/key_order.h"

namespace kinex {

class MaximumTournament final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner at a node, or another maximum: the old one, the new one
    kTie,      // at a node, because the two keys have become identically equal
  };

  MaximumTournament(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                    Extremum extremum);

  std::string_view name() const override;
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override { events_.settle(winner()); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // kNoObject if there is none.
  ObjectId winner() const { return leaves_ == 0 ? kNoObject : winner_[1]; }

 private:
  using Node = std::uint32_t;

  void construct(std::vector<ObjectId> members);
  ObjectId loser(Node v) const {
    return winner_[2 * v] == winner_[v] ? winner_[2 * v + 1] : winner_[2 * v];
  }
  void set_node(Node v, ObjectId winner, ObjectId loser);
  void flip(Node v);
  void decide(Node v);
  void replay(Node a, Node b);
  std::size_t leaves_below(Node v) const;
  void begin_epochs(std::vector<Node>& nodes);

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  MaximumEvents events_;
  std::size_t leaves_ = 0;
  std::vector<ObjectId> winner_;            // per node from 1; at a leaf its object
  std::vector<CertificateId> certificate_;  // per inner node from 1
  std::vector<Node> leaf_of_;               // per object; 0: not a member
  // Epochs of nodes by their number of leaves: of single changes, and (trees_) of whole trees built
  // or changed all over, by the number of leaves of these.
  std::map<std::size_t, std::uint64_t> epochs_;
  std::map<std::size_t, std::uint64_t> trees_;
  std::vector<Node> touched_;  // scratch
};

}  // namespace kinex

#endif
