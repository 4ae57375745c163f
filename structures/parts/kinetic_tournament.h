// SPDX-License-Identifier: GPL-3.0-or-later
// KineticTournament: the item in front of all others, by a tournament tree over any claims.
//
// Certificates. The tree is complete and lies in an array: the children of node v are 2v and
// 2v + 1, the leaves are n .. 2n - 1. One certificate per inner node, whose tag is the node: the
// winner of one child is in front of the winner of the other.
//
//               1: a                 node 2 fails: c wins there from now on, and then at every
//            ____|____               node above where it beats the other child's winner. The
//         2: a       3: e            certificates on that path are renewed, up to where c loses.
//        __|__       __|__
//     4: a   5: c  6: e   7: f       n = 4; leaves 4 .. 7
//
// Claims by cases (MatchProof) have up to three certificates a node. Where one fails and another case
// proves the same result, the node changes its case and no winner changes.
//
// Items come and go at any time, also while the owner repairs itself. Comparisons are made right
// after now. A certificate that is negative right after now stays until it fails or its node gets
// other opponents. Claims are requested for present items only.
//
// Cost for n items: n - 1 certificates (by cases 3 (n - 1)); an item is in ceil(log2 n) of them at most. A failure
// renews those on one path, O(log n). k items that come or go renew those on their paths,
// O(k log n), each once; where one item takes the place of another the tree keeps its shape.
// Bound on the failures: TournamentEpochs.
//
// Ties. Of items that are level identically goes_first decides.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; Basch,
// Guibas, Hershberger, "Data structures for mobile data" (1999).
#ifndef KINEX_STRUCTURES_PARTS_KINETIC_TOURNAMENT_H
#define KINEX_STRUCTURES_PARTS_KINETIC_TOURNAMENT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "core/numbers/integer.h"
#include "structures/parts/claim.h"
#include "structures/parts/match_proof.h"
#include "structures/parts/slots.h"
#include "structures/parts/tournament_epochs.h"

namespace kinex {

template <MatchClaims C>
class KineticTournament {
 public:
  // The winner at the node of a failed certificate: until now, and from now on. By cases it may be the
  // same.
  struct Duel {
    Item before, after;
  };

  // `name`: of the ledger line. `items`: room is reserved for items below this number.
  KineticTournament(Kernel& kernel, StructureId structure, std::string name, C claims,
                    std::size_t items = 0)
      : slots_(kernel, structure, std::move(name)),
        claims_(std::move(claims)),
        leaf_of_(items, 0) {}

  const C& claims() const { return claims_; }
  C& claims() { return claims_; }
  const Slots& slots() const { return slots_; }
  std::size_t size() const { return leaves_; }
  bool has(Item item) const { return item < leaf_of_.size() && leaf_of_[item] != 0; }
  // In front of all others; kNoItem if there is none.
  Item winner() const { return leaves_ == 0 ? kNoItem : winner_[1]; }

  // Replaces the tree by that of these items, right after now. O(n) comparisons.
  template <TieReport Tied>
  void build(std::vector<Item> items, const Tied& tied) {
    for (MatchProof<C>& proof : proofs_) proof.drop(slots_);
    std::fill(leaf_of_.begin(), leaf_of_.end(), 0);
    leaves_ = items.size();
    winner_.assign(2 * std::max<std::size_t>(leaves_, 1), kNoItem);
    proofs_.assign(std::max<std::size_t>(leaves_, 1), MatchProof<C>());
    for (std::size_t i = 0; i < leaves_; ++i) seat(static_cast<Node>(leaves_ + i), items[i]);
    for (std::size_t v = leaves_; v-- > 1;) decide(static_cast<Node>(v), tied);
    epochs_.built(leaves_);
  }
  // The items in the order of their leaves.
  std::vector<Item> items() const {
    const auto first = winner_.begin() + static_cast<std::ptrdiff_t>(leaves_);
    return {first, first + static_cast<std::ptrdiff_t>(leaves_)};
  }

  // A certificate of this part has failed.
  template <TieReport Tied>
  Duel failed(CertificateId failed, const Tied& tied) {
    const Node v = slots_.failed(failed);
    const Duel duel{winner_[v], loser(v)};
    if (proofs_[v].renewed(slots_, claims_, duel.before, duel.after, v)) {
      return {duel.before, duel.before};
    }
    flip(v, tied);
    return duel;
  }

  // Prefetches what an update by this item reads first. No effect on results.
  void prefetch(Item item) const { __builtin_prefetch(leaf_of_.data() + item, 1); }
  // These items leave, and those join: no item is in both.
  template <TieReport Tied>
  void update(std::span<const Item> gone, std::span<const Item> came, const Tied& tied) {
    touched_.clear();
    const std::size_t both = std::min(gone.size(), came.size());
    for (const Item item : gone) {
      Node v = leaf_of_[item];
      for (int level = 0; level < 3 && v > 1; ++level) {
        __builtin_prefetch(winner_.data() + (v ^ 1), 1);
        v /= 2;
        __builtin_prefetch(proofs_.data() + v, 1);
      }
    }
    for (std::size_t i = 0; i < both; ++i) {
      const Node leaf = leaf_of_[gone[i]];
      leaf_of_[gone[i]] = 0;
      seat(leaf, came[i]);
      touched_.push_back(leaf / 2);
    }
    for (const Item item : gone.subspan(both)) take_out(item);
    for (const Item item : came.subspan(both)) put_in(item);
    epochs_.begin(touched_, leaves_);
    decide_above(tied);
  }
  template <TieReport Tied>
  void insert(Item item, const Tied& tied) {
    update({}, {&item, 1}, tied);
  }
  template <TieReport Tied>
  void erase(Item item, const Tied& tied) {
    update({&item, 1}, {}, tied);
  }

  // New motions of these objects: puts the ties that came with them in order, the lowest nodes
  // first. All other changes show as failures.
  template <TieReport Tied>
  void motions_changed(std::span<const ObjectId> objects, const Tied& tied) {
    Kernel& kernel = slots_.kernel();
    std::vector<Node> ties;
    touched_.clear();
    for (const ObjectId object : objects) {
      for (const CertificateId c : kernel.certificates_of(object)) {
        if (!slots_.owns(c)) continue;
        touched_.push_back(kernel.tag(c));
        if (slots_.is_tie(c)) ties.push_back(kernel.tag(c));
      }
    }
    epochs_.begin(touched_, leaves_);
    std::sort(ties.begin(), ties.end(), std::greater<>());
    ties.erase(std::unique(ties.begin(), ties.end()), ties.end());
    for (const Node v : ties) {
      const Item old = winner_[v], fresh = loser(v);
      if (!proofs_[v].tied(slots_, claims_, old, fresh, v) || claims_.goes_first(old, fresh)) continue;
      flip(v, tied);
      tied(old, fresh);
    }
  }

  // Calls visit(node, winner, certificates) for all nodes, in ascending order from the root, 1. Leaves
  // have no certificates; of those of a match some may be kNoCertificate. The children of node v are 2v
  // and 2v + 1.
  template <class Visit>
  void each_node(const Visit& visit) const {
    for (Node v = 1; v < 2 * leaves_; ++v) {
      visit(v, winner_[v],
            v < leaves_ ? proofs_[v].slots() : std::span<const CertificateId>());
    }
  }

  // An upper bound on the failures so far, for claims of this degree in t (TournamentEpochs). By cases:
  // of those that change a winner.
  Integer most_failures(int degree) const { return epochs_.most_failures(degree); }
  // Likewise on all failures, if the certificates of matches of two given items fail at most `failures`
  // times at a node.
  Integer most_failures_of_pairs(int failures) const {
    return epochs_.most_failures_of_pairs(failures);
  }

  // Links, certificates and ties; `name` begins the messages.
  void check(AuditReport& report, const std::string& name) const {
    for (Node v = 1; v < leaves_; ++v) {
      const auto where = [&] { return " at node " + std::to_string(v) + " of " + name; };
      const Item a = winner_[2 * v], b = winner_[2 * v + 1];
      const bool played = winner_[v] == a || winner_[v] == b;
      report.check(played, [&] { return "a winner that is neither opponent" + where(); });
      if (!played) continue;
      report.check(proofs_[v].holds(slots_, claims_, winner_[v], loser(v), v),
                   [&] { return "a certificate of something else" + where(); });
      report.check(!proofs_[v].is_tie(slots_) || claims_.goes_first(winner_[v], loser(v)),
                   [&] { return "a tie with the wrong winner" + where(); });
    }
    for (std::size_t v = leaves_; v < 2 * leaves_; ++v) {
      report.check(has(winner_[v]) && leaf_of_[winner_[v]] == v,
                   [&] { return "a lost item at leaf " + std::to_string(v) + " of " + name; });
    }
  }
  std::size_t bytes() const {
    return winner_.capacity() * sizeof(Item) + proofs_.capacity() * sizeof(MatchProof<C>) +
           (leaf_of_.capacity() + touched_.capacity()) * sizeof(Node) + epochs_.bytes();
  }

 private:
  using Node = TournamentEpochs::Node;

  Item loser(Node v) const {
    return winner_[2 * v] == winner_[v] ? winner_[2 * v + 1] : winner_[2 * v];
  }
  void seat(Node leaf, Item item) {
    if (leaf_of_.size() <= item) leaf_of_.resize(item + std::size_t{1}, 0);
    winner_[leaf] = item;
    leaf_of_[item] = leaf;
  }

  // `winner` has won, or is expected to: if it has not, the certificate fails at once.
  template <TieReport Tied>
  void set_node(Node v, Item winner, Item loser, const Tied& tied) {
    if (proofs_[v].set(slots_, claims_, winner, loser, v) && claims_.goes_first(loser, winner)) {
      std::swap(winner, loser);
      proofs_[v].set(slots_, claims_, winner, loser, v);
      tied(loser, winner);
    }
    winner_[v] = winner;
  }

  // The other child's winner becomes the winner of v, and so on upwards to where it loses. Wherever
  // the old winner won it was in front of its opponent or level with it, and the new one is in
  // front of the old one right after now.
  template <TieReport Tied>
  void flip(Node v, const Tied& tied) {
    Item old = winner_[v], fresh = loser(v);
    set_node(v, fresh, old, tied);
    while (v > 1 && old != (fresh = winner_[v])) {
      const Item sibling = winner_[v ^ 1];
      v /= 2;
      const Item before = winner_[v];
      if (before == old) {
        set_node(v, fresh, sibling, tied);
      } else {
        set_node(v, sibling, fresh, tied);
      }
      old = before;
    }
  }

  // Compares the two children's winners, unless they are the opponents of last time.
  template <TieReport Tied>
  void decide(Node v, const Tied& tied) {
    const Item a = winner_[2 * v], b = winner_[2 * v + 1];
    if (proofs_[v].there() && (winner_[v] == a || winner_[v] == b) &&
        proofs_[v].is_about(slots_, claims_, a, b)) {
      return;
    }
    if (in_front(slots_.kernel(), claims_, a, b)) {
      set_node(v, a, b, tied);
    } else {
      set_node(v, b, a, tied);
    }
  }

  // Decides the nodes of touched_, children first, and those above them whose opponents are others now. A
  // winner that stays has the same value: items that leave and those that join have other numbers.
  template <TieReport Tied>
  void decide_above(const Tied& tied) {
    std::make_heap(touched_.begin(), touched_.end());
    Node last = 0;
    while (!touched_.empty()) {
      std::pop_heap(touched_.begin(), touched_.end());
      const Node v = touched_.back();
      touched_.pop_back();
      if (v == last || v == 0 || v >= leaves_) continue;
      last = v;
      const Item before = winner_[v];
      decide(v, tied);
      if (winner_[v] == before) continue;
      touched_.push_back(v / 2);
      std::push_heap(touched_.begin(), touched_.end());
    }
  }

  // The first leaf becomes an inner node above its item and the new one.
  void put_in(Item item) {
    const Node v = static_cast<Node>(leaves_);
    ++leaves_;
    winner_.resize(2 * leaves_, kNoItem);
    proofs_.resize(leaves_);
    if (leaves_ == 1) return seat(1, item);
    seat(2 * v, winner_[v]);
    seat(2 * v + 1, item);
    touched_.push_back(v);
  }

  // The last two leaves are removed: one moves up into their parent, the other to the place of the
  // item that leaves.
  void take_out(Item item) {
    const Node hole = leaf_of_[item];
    leaf_of_[item] = 0;
    --leaves_;
    if (leaves_ == 0) {
      winner_[1] = kNoItem;
      return;
    }
    const Node parent = static_cast<Node>(leaves_);
    const Item a = winner_[2 * parent], b = winner_[2 * parent + 1];
    proofs_[parent].drop(slots_);
    proofs_.resize(leaves_);
    winner_.resize(2 * leaves_);
    seat(parent, item == a ? b : a);
    touched_.push_back(parent / 2);
    if (item == a || item == b) return;
    seat(hole, b);
    touched_.push_back(hole / 2);
  }

  Slots slots_;
  C claims_;
  std::size_t leaves_ = 0;
  std::vector<Item> winner_;                // per node from 1; at a leaf its item
  std::vector<MatchProof<C>> proofs_;       // per inner node from 1
  std::vector<Node> leaf_of_;               // per item; 0: not a member
  TournamentEpochs epochs_;
  std::vector<Node> touched_;  // scratch
};

}  // namespace kinex

#endif
