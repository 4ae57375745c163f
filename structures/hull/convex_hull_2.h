// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: the convex hull of moving points in the plane, by divide and conquer in the dual.
//
// The upper hull is the upper envelope of the dual lines, a convex chain; the lower hull is the
// same upside down (HullSigns). A balanced binary tree over the points, in no geometric order,
// holds an upper and a lower envelope at every node. A node merges the chains of its two children,
// red and blue, into its own, purple; the chains of the root are the hull:
//
//                abcde                   purple of the root
//              ____|____
//           abc         de               its red and its blue chain
//          __|__       _|_
//        ab     c     d   e
//       _|_                              a change of purple at a node is a change of red or blue
//      a   b                             at its parent, and may end there
//
// A corner `ab` of a chain is where line b follows line a. In the merged order of all red and blue
// corners, its contender is the line of the other colour there:
//
//     red    ---o-----------|---------o-----|----      o  a corner of this chain
//               :           :         :     :          |  its contender on the other chain
//     blue   ---|-----------o---------|-----o----
//               <-----x-----><---x----><--x-->         x  between neighbours of two colours
//               y           y         y     y          y  o against |, where it is claimed
//
// Certificates of a node, for motions of degree d:
//   x     a corner is left of the next one in the merged order,    slope_order_2,    degree 2d
//         if the two have different colours
//   y     a corner is above (or below) its contender: where the    orientation_2,    degree 2d
//         chains cross on its left (event yl), on its right (yr)
//         or on both sides (yb), or at a tangent corner (yt)
//   s     the slope of a line is less than that of another         coordinate_order, degree d
//   end   the order of the slopes of the two first lines, and of   coordinate_order, degree d
//         the two last ones
// Take a line c and the run of corners of the other colour over it. If the run is above c and does
// not cross it, s says where in the order of the run's slopes that of c lies: between those of the
// two lines of one corner, the tangent (st, two certificates), before the run (sr) or after it
// (sl).
// x proves the merged order. Where red is above blue, their difference has its minima at tangents:
// red corners whose slopes enclose that of the contender (and likewise with the colours exchanged).
// y proves that a tangent is above, sl and sr that there is no other. Crossings are proved by y on
// both sides.
//
// Quality, for n points:
//   compactness     O(n) certificates on random motions, O(n log n) always
//   locality        a line has two corners, at most two crossings and one tangent per node: O(1)
//                   certificates per node, O(log n) in all
//   responsiveness  a failure is repaired in O(1) at its node. If purple changes, one corner is
//                   replaced by two or two by one, and the same is done at every ancestor whose
//                   chain changes too. Insertion and erasure rebuild the chains on one path of the
//                   tree; new motions leave the tree as it is
// Events, linear motion: two points have different colours at one node only, and the order of their
// slopes changes once there: at most C(n,2) events s and end. In the two halves together there are
// at most 4 C(n,3) events y and 4 C(n,4) events x (four points are two red and two blue ones at one
// node only). The total is O(n^(2 + epsilon)).
//
// The naive variant has y at all corners and no s. Corners far from all crossings then depend on
// their contender, and one line may be in n certificates: it is not local.
//
// Ties: see HullSigns. The hull has only strict vertices; of equal points it has the smallest id.
//
// Degenerate instants. Every claim that fails is repaired separately; new claims that are negative
// right after now fail next. Where no repair in place is possible (four lines through one point),
// the node and its ancestors lose their certificates. They are merged anew, by signs right after
// now, when everything below them is right (node_rebuilds() counts these).
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6; Basch,
// Guibas, Hershberger, "Data structures for mobile data" (1999). The local certificates are worked
// out here.
#ifndef KINEX_STRUCTURES_HULL_CONVEX_HULL_2_H
#define KINEX_STRUCTURES_HULL_CONVEX_HULL_2_H

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/hull/convex_hull_2_signs.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/slots.h"

namespace kinex {

class ConvexHull2 final : public HullSource {
 public:
  // Bound on the number of certificates that name a point, per half and level of the tree.
  // Observed: at most 4.1 (the benchmark hull_levels).
  static constexpr int kPerLevel = 24;

  enum class Variant { kLocal, kNaive };
  // The kinds after those of HullEvents; all internal.
  enum Kind : std::uint8_t {
    kX = HullEvents::kKinds,  // two corners ab, cd: a, b, c, d
    kYl,                      // a corner ab and its contender: a, b, c; crossing on its left
    kYr,                      // ... on its right
    kYb,                      // ... on both sides
    kYt,                      // ... no crossing beside it
    kSl,                      // the slope of a line is no longer after its run: two lines
    kSr,                      // ... no longer before its run
    kSt,                      // ... no longer between the two slopes of its tangent
    kEnd,                     // the first (or last) lines of the two chains: two lines
  };

  ConvexHull2(Kernel& kernel, StructureId id, const Scene& scene, Variant variant);

  std::string_view name() const override {
    return variant_ == Variant::kNaive ? "convex_hull_2_naive" : "convex_hull_2";
  }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  Attribute attribute() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // Nodes merged anew at degenerate instants, and the reasons.
  std::uint64_t node_rebuilds() const { return node_rebuilds_; }
  const std::map<std::string, std::uint64_t>& node_rebuild_reasons() const {
    return spoil_reasons_;
  }
  // Failures by the height of their node; 1: the nodes just above the points.
  const std::vector<std::uint64_t>& failures_by_level() const { return by_level_; }

 private:
  using Index = std::uint32_t;
  using Half = HullSigns::Half;
  using Corner = HullSigns::Corner;
  static constexpr Index kNone = 0xffffffffu;
  static constexpr unsigned kHalves = 2;
  // The parts. x, y and s are claims of a corner, the others of a node: that is the tag.
  enum Slot : PartId { kSlotX, kSlotY, kSlotS1, kSlotS2, kSlotLeft, kSlotRight };
  struct Claimed {
    Index place;  // edge or node
    Slot slot;
    auto operator<=>(const Claimed&) const = default;
  };
  // Where the slope of a line lies in the run over it, as seen from the corner that claims it.
  enum Claim : std::uint8_t { kNoClaim, kAfter, kBefore, kTangent };

  // A line on the chain of a node, the corner at its right end, and the place of both in the merge
  // of the parent. One cache line.
  struct alignas(64) Edge {
    ObjectId point = kNoObject;
    Index node = kNone;                    // the one whose chain it is on
    Index merge = kNone;                   // the node that merges it; none: the root, or stale
    Index next = kNone, previous = kNone;  // on the chain
    Index up = kNone;                      // the same line on the parent's chain
    // The corner at its right end, if there is one: neighbours in the merged order, contender.
    Index right = kNone, left = kNone;
    Index contender = kNone;
    Index claimant = kNone;  // the corner that claims where the slope of this line falls
    std::array<CertificateId, 4> certificates{kNoCertificate, kNoCertificate, kNoCertificate,
                                              kNoCertificate};
    bool red = false;
    bool above = false;          // the corner is above its contender
    Claim claim = kNoClaim;      // about the contender
    std::uint8_t crossings = 0;  // of this line with the other chain
  };

  // One half of a node; nodes 2t and 2t + 1 are the halves of tree node t.
  struct Node {
    Index first = kNone, last = kNone;  // its chain
    Index head = kNone, tail = kNone;   // merged order of the corners of its children
    std::array<CertificateId, 2> ends{kNoCertificate, kNoCertificate};
    std::array<bool, 2> red{false, false};  // which colour is above at the left end, the right end
    bool stale = false;                     // to be merged anew
    std::uint8_t height = 0;                // of the tree node, when it was merged
  };
  struct TreeNode {
    Index parent = kNone, children[2]{kNone, kNone};
    Index leaves = 0;
    std::uint32_t height = 0;
  };

  static Half half(Index node) { return static_cast<Half>(node & 1u); }
  Index parent(Index node) const {
    const Index p = tree_[node / 2].parent;
    return p == kNone ? kNone : 2 * p + (node & 1u);
  }
  Index child(Index node, int which) const {
    return 2 * tree_[node / 2].children[which] + (node & 1u);
  }
  bool leaf(Index node) const { return tree_[node / 2].children[0] == kNone; }
  // The node that merges the chain of this edge.
  Index merge_of(Index edge) const { return edges_[edge].merge; }
  Corner corner(Index edge) const { return {edges_[edge].point, edges_[edges_[edge].next].point}; }
  // The first (end 0) or the last (end 1) lines of the chains that a node merges: blue, red.
  std::array<Index, 2> end_lines(Index node, int end) const {
    const Node &red = nodes_[child(node, 0)], &blue = nodes_[child(node, 1)];
    return end == 0 ? std::array{blue.first, red.first} : std::array{blue.last, red.last};
  }
  bool red_above(Index corner) const { return edges_[corner].red == edges_[corner].above; }
  bool crosses_left(Index node, Index corner) const;
  bool crosses_right(Index node, Index corner) const;
  Index first_of_run(Index line) const;
  Index last_of_run(Index line) const;

  // ---- convex_hull_2_certificates.cpp: the claims, as a function of the state
  CertificateId& certificate_of(Slot slot, Index place) {
    return slot >= kSlotLeft ? nodes_[place].ends[slot - kSlotLeft]
                             : edges_[place].certificates[slot];
  }
  Query base_query(Slot slot, Index place) const;
  bool needs_y(Index corner) const;
  CertificateId certificate_of(Slot slot, Index place) const {
    return const_cast<ConvexHull2*>(this)->certificate_of(slot, place);
  }
  Slot slot_of(CertificateId certificate) const {
    return static_cast<Slot>(kernel_->part(certificate));
  }
  Outlook certify(Slot slot, Index place, const Query& query);
  void drop(Slot slot, Index place);
  void drop_all(Index edge);
  void refresh(Slot slot, Index place);
  void resolve_tie(Slot slot, Index place);
  void refresh_x(Index corner);
  void refresh_y(Index corner);
  void refresh_end(Index node, int end);
  void drop_claim(Index line);
  void set_claim(Index line, Index corner, Claim claim);
  void refresh_claim(Index line, Index hint);

  // ---- convex_hull_2_repair.cpp: failures
  void repair(Slot slot, Index place);
  void repair_x(Index corner);
  void repair_y(Index corner);
  void repair_s(Slot slot, Index corner);
  void pass(Index node, Index e, Index f, const Query& claim);
  void pass_half(Index node, Index e, Index f, const Query& claim);
  void turn_end(Index node, int end);
  void count_crossings(Index line, int more) {
    edges_[line].crossings = static_cast<std::uint8_t>(edges_[line].crossings + more);
  }
  void report_failure(Slot slot, Index place);
  bool claim_holds(Slot slot, Index place) const;
  void work_off();
  void finish_instant();
  void start_afresh();
  Index upcoming_edge(std::size_t i) const;
  void fetch(Index edge) const {
    if (edge != kNone) __builtin_prefetch(edges_.data() + edge, 1);
  }
  void fetch_places() const;
  void fetch_certificates() const;

  // ---- convex_hull_2_chain.cpp: one line more or less on a chain
  Index enter(Index node, Index a, Index b, ObjectId point);
  void leave(Index node, Index edge);
  void join(Index node, Index a, Index b);
  void join_corners(Index node, Index left, Index right);
  void spoil(Index node, const char* reason);
  void unmerge(Index node);
  void mend();

  // ---- convex_hull_2_build.cpp: the static algorithm
  Index allocate_edge(Index node, ObjectId point);
  void free_edge(Index edge);
  Index allocate_tree_node();
  void free_chain(Index node);
  void merge(Index node);
  void merge_both(Index t);
  void merge_corners(Index node);
  void merge_purple(Index node);
  void merge_certificates(Index node);
  Index append(Index node, ObjectId point);
  Index build_tree(std::span<const ObjectId> objects);
  void make_leaf(Index t, ObjectId object);
  void construct(std::span<const ObjectId> objects);
  void construct_anew();
  void update_sizes(Index t);
  void reset_hull();

  // ---- convex_hull_2_update.cpp
  void hang(Index above, Index old, Index fresh);
  void unmerge_path(Index t);
  void merge_path(Index t);
  Index remake(Index t);
  void take_apart(Index t, std::vector<ObjectId>& objects);

  // ---- convex_hull_2_audit.cpp
  void check_tree(Index t, AuditReport& report) const;
  void check_chain(Index node, AuditReport& report) const;
  void check_merge(Index node, AuditReport& report) const;
  void check_certificates(Index node, AuditReport& report) const;
  static std::string named(const char* what, Index place);

  // ---- convex_hull_2_proof.cpp
  std::string_view role_of(Slot slot, Index place) const;
  void visit_merge(Index node, ProofVisitor& visitor) const;

  // ---- convex_hull_2_bounds.cpp
  void add_level_bounds(const BoundContext& context, std::vector<BoundCheck>& checks) const;

  // Points may come or go, or move off a line with others, with no single change to report.
  void look_anew() { root_changes_ += 2; }
  std::vector<ObjectId> hull_cycle() const;
  std::vector<ObjectId> strict_chain(Index node) const;
  void note_root_change(Index node, Index a, Index b, ObjectId point, bool enters);
  bool settle_one_vertex();
  void give_up(const std::string& what);

  Variant variant_;
  bool exact_;  // the arithmetic
  HullSigns signs_;
  std::array<Slots, 6> parts_;  // by Slot

  std::vector<Edge> edges_;
  std::vector<Index> free_edges_;
  std::vector<Node> nodes_;
  std::vector<TreeNode> tree_;
  std::vector<Index> free_tree_nodes_;
  Index root_ = kNone;          // tree node
  std::vector<Index> leaf_of_;  // tree node per object; kNone: not a member

  // The present failure and instant.
  // Changes of the root's chains since the hull was read, and the last one.
  std::uint32_t root_changes_ = 0;
  struct RootChange {
    ObjectId point = kNoObject, left = kNoObject, right = kNoObject;
    Half half = HullSigns::kUpper;
    bool enters = false;
  } root_change_;
  bool unsettled_ = false;     // a certificate was made that is negative right after now
  std::vector<Claimed> todo_;  // claims that no certificate can refute
  std::vector<Index> stale_;
  std::vector<Claimed> tied_;  // claims that were tied when they were made
  std::uint64_t spent_ = 0;    // repairs at this instant
  RepeatGuard repeats_;
  bool corrupt_ = false;

  std::uint64_t node_rebuilds_ = 0;
  std::map<std::string, std::uint64_t> spoil_reasons_;
  std::vector<std::uint64_t> by_level_;
};

}  // namespace kinex

#endif
