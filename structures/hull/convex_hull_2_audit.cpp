// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: invariants, audit.
#include <algorithm>
#include <string>
#include <utility>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

void ConvexHull2::audit(const Snapshot& snapshot, AuditReport& report) const {
  if (!corrupt_) HullSource::audit(snapshot, report);
}

void ConvexHull2::check_invariants(AuditReport& report) const {
  if (corrupt_) return;
  report.check(stale_.empty() && todo_.empty() && root_changes_ == 0,
               [] { return "the last instant was not settled"; });
  report.check(events_.cycle() == hull_cycle(),
               [] { return "the hull that was reported is not the one on the root's chains"; });
  if (root_ != kNone) check_tree(root_, report);
}

void ConvexHull2::check_tree(Index t, AuditReport& report) const {
  const TreeNode& node = tree_[t];
  for (unsigned h = 0; h < kHalves; ++h) check_chain(2 * t + h, report);
  if (node.children[0] == kNone) {
    const ObjectId object = edges_[nodes_[2 * t].first].point;
    report.check(node.leaves == 1 && leaf_of_[object] == t, [&] { return named("leaf", t); });
    return;
  }
  std::uint32_t leaves = 0;
  for (const Index c : node.children) {
    report.check(tree_[c].parent == t && tree_[c].height < node.height,
                 [&] { return named("the tree at", t); });
    leaves += tree_[c].leaves;
    check_tree(c, report);
  }
  report.check(leaves == node.leaves, [&] { return named("the leaves under", t); });
  for (unsigned h = 0; h < kHalves; ++h) {
    check_merge(2 * t + h, report);
    check_certificates(2 * t + h, report);
  }
}

std::string ConvexHull2::named(const char* what, Index place) {
  return std::string(what) + " " + std::to_string(place) + " is wrong";
}

void ConvexHull2::check_chain(Index node, AuditReport& report) const {
  Index previous = kNone;
  for (Index e = nodes_[node].first; e != kNone; e = edges_[e].next) {
    report.check(edges_[e].previous == previous && edges_[e].node == node,
                 [&] { return named("the chain at edge", e); });
    previous = e;
  }
  report.check(nodes_[node].last == previous && previous != kNone,
               [&] { return named("the end of the chain of node", node); });
}

// Checks the merged order, contenders, crossings and purple from left to right, and each claim
// against the signs just after now.
void ConvexHull2::check_merge(Index node, AuditReport& report) const {
  const Half side = half(node);
  std::array<Index, 2> lines = end_lines(node, 0);  // blue, red
  const auto bad = [&](const char* what) { return [what, node] { return named(what, node); }; };
  report.check(!nodes_[node].stale, bad("the merge of node"));
  report.check(
      nodes_[node].red[0] == signs_.slopes_hold(edges_[lines[1]].point, edges_[lines[0]].point),
      bad("the left end of node"));
  bool red_shows = nodes_[node].red[0];
  Index purple = nodes_[node].first;
  std::vector<std::pair<Index, int>> crossings;
  std::size_t shown = 0;
  const auto show = [&](Index line) {
    ++shown;
    report.check(
        purple != kNone && edges_[line].up == purple && edges_[purple].point == edges_[line].point,
        bad("purple of node"));
    if (purple != kNone) purple = edges_[purple].next;
  };
  const auto cross = [&] {
    for (const Index line : lines) crossings.emplace_back(line, 1);
    red_shows = !red_shows;
    show(lines[red_shows]);
  };
  show(lines[red_shows]);
  Index left = kNone;
  for (Index v = nodes_[node].head; v != kNone; v = edges_[v].right) {
    const Edge& e = edges_[v];
    const Index other = lines[!e.red];
    report.check(e.left == left && v == lines[e.red] && e.contender == other && e.next != kNone,
                 bad("the merged order of node"));
    if (v != lines[e.red] || e.next == kNone) return;
    report.check(left == kNone || edges_[left].red == e.red ||
                     signs_.corners_hold(side, corner(left), corner(v)),
                 bad("the order of x at node"));
    report.check(e.above == signs_.above(side, corner(v), edges_[other].point),
                 bad("a height at node"));
    if (red_above(v) != red_shows) cross();
    lines[e.red] = e.next;
    if (e.above) show(e.next);
    left = v;
  }
  report.check(
      nodes_[node].tail == left && edges_[lines[0]].next == kNone && edges_[lines[1]].next == kNone,
      bad("the end of the merged order of node"));
  if (nodes_[node].red[1] != red_shows) cross();
  report.check(purple == kNone, bad("the end of purple of node"));
  std::sort(crossings.begin(), crossings.end());
  for (const int which : {0, 1}) {
    for (Index e = nodes_[child(node, which)].first; e != kNone; e = edges_[e].next) {
      const auto count =
          std::count(crossings.begin(), crossings.end(), std::pair<Index, int>(e, 1));
      report.check(count == edges_[e].crossings, bad("a number of crossings at node"));
      if (edges_[e].up != kNone) shown -= edges_[edges_[e].up].node == node ? 1 : 0;
    }
  }
  report.check(shown == 0, bad("the links to purple of node"));
}

// Every certificate that the state requires exists, with the right query, and no other one does.
void ConvexHull2::check_certificates(Index node, AuditReport& report) const {
  const auto bad = [&](const char* what, Index e) { return [what, e] { return named(what, e); }; };
  const auto expect = [&](Slot slot, Index place, bool wanted) {
    const CertificateId c = certificate_of(slot, place);
    const bool is = c != kNoCertificate;
    // A tie is kept by a substitute.
    const auto query = [&] { return signs_.tied() ? kernel_->query(c) : base_query(slot, place); };
    report.check(is == wanted && (!is || parts_[slot].holds(c, query(), place)),
                 bad(slot == kSlotX     ? "the x certificate of corner"
                     : slot == kSlotY   ? "the y certificate of corner"
                     : slot < kSlotLeft ? "an s certificate of corner"
                                        : "an end certificate of node",
                     place));
  };
  for (const Slot slot : {kSlotLeft, kSlotRight}) expect(slot, node, true);
  for (const int which : {0, 1}) {
    for (Index e = nodes_[child(node, which)].first; e != kNone; e = edges_[e].next) {
      const Edge& edge = edges_[e];
      const Index first = first_of_run(e);
      const bool wanted = variant_ == Variant::kLocal && edge.crossings == 0 && first != kNone &&
                          edges_[first].above;
      report.check((edge.claimant != kNone) == wanted, bad("the slope claim over line", e));
      if (edge.claimant != kNone) {
        const Edge& v = edges_[edge.claimant];
        bool good = v.contender == e && v.claim != kNoClaim;
        if (v.claim == kBefore) good = good && edge.claimant == first;
        if (v.claim == kAfter) good = good && edge.claimant == last_of_run(e);
        report.check(good, bad("the slope claim over line", e));
      }
      const bool is_corner = edge.next != kNone;
      const bool both = is_corner && edge.right != kNone && edges_[edge.right].red != edge.red;
      expect(kSlotX, e, both);
      expect(kSlotY, e, is_corner && needs_y(e));
      expect(kSlotS1, e, edge.claim != kNoClaim);
      expect(kSlotS2, e, edge.claim == kTangent);
      report.check(edge.claim == kNoClaim || edges_[edge.contender].claimant == e,
                   bad("the claim of corner", e));
    }
  }
}

}  // namespace kinex
