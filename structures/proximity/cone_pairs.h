// SPDX-License-Identifier: GPL-3.0-or-later
// ConePairs: pairs of points among which is every closest pair whose second point is in a given
// cone of the first: a range tree of two levels, by places in three orders alone.
//
// The cone p + K is "behind p in the orders alpha and beta", and u is its projection. A point is
// in K of another iff it is behind in alpha and in beta.
//
//              z                 A balanced tree over the order alpha (place_tree.h). Its inner node z
//            /   \               has a treap, by beta, of the points below it: those of the left
//     lookers     seen           child are lookers, those of the right child are seen.
//
//              t                 A treap node t keeps the last lookers and the first seen, by u, of
//            /   \               its subtree, and offers pairs of these:
//      looker     seen             the lookers on its left with the seen of itself and its right
//                                  itself, if it is a looker, with the seen on its right
//
// So a pair has one treap node at which it may be offered, where its points separate. All that are
// seen there are in p + K, and all lookers in q - K, for a looker p and a seen q.
//
//   what is kept                offered                        for
//   one of each                 last looker, first seen        octants
//   two of each                 last with first and second,    quadrants
//                               last but one with first
//   one of each and colour      last red with first blue,      octants, in the maximum norm, pairs
//                               last blue with first red       of two colours
//
// Octants. If q is in p + K and pq is a closest pair, then q is strictly the first point of p + K by
// u, and p strictly the last of q - K. (For K = {0 <= y < x}, p = 0, q = (1, b): a point (a, c) of K
// with a <= 1 is nearer to q than p is.)
//
// Quadrants. Then q is the first or the second point of p + K, p the last or the last but one of q -
// K, and not both are second at one treap node. Let K = {x, y >= 0} by x + y, p = 0, q = (a, b) and
// D = |pq| > 0.
//
//   C'
//   |\        Points r level with q or before it are in the triangle 0, C = (a + b, 0), C' = (0, a
//   | \       + b), and at least as far as D from p and from q. Outside of the open disc about p
//   (  q      through q two mirror images are left of the triangle, one at C and one at C', which
//   |`- \     meet at most in (a, b) = (b, a). Each has the diameter min(a, b) sqrt(2) <= D, that
//   p--(-C    of (a, b) or (b, a) and its corner alone.
//
//   a > b: the diameter is less than D. So q is alone in the piece at C, and one point r at most is
//   in that at C', with r.x <= b < a. It is in the triangle, so r.y - b <= a - r.x, and at least as
//   far as D from q: hence a - r.x >= D / sqrt(2). Turned by a half turn: of the points of q - K
//   level with p or behind it there is at most one, s, with s.x >= D / sqrt(2). If a node has both,
//   then r is in s + K, and s.x <= r.x: 2 D / sqrt(2) <= a, but a <= D. Likewise for a < b.
//
//   a = b: only C and C' may be there, level with q and on either side of it along the side of the
//   triangle: one is before q. Likewise one of (a, -a) and (-a, a), opposite to it, is behind p, and
//   no quadrant of that has both q and the other one.
//
// Of points that are equal identically the pair of the two smallest ids is to be offered: in the
// order along (2, 1) they are next to each other in all orders.
//
// Maximum norm. In an octant the length of pq is u(q) - u(p), so of the pairs of a red looker and a
// blue seen at a treap node the last with the first is the shortest, and the only one: there are no
// two level points in u (turned_order.h). So every closest pair of two colours is offered.
//
// Cost, for n points: n ceil(log2 n) treap nodes, at most twice as many after insertions and
// erasures, with 2, 5 or 3 offers each at most. Two neighbours that change places in an order:
// O(log^2 n) steps. An insertion or erasure: O(log^2 n) steps in the treaps that stay, and O(m log^2 m)
// for a new subtree of m points, amortised O(log^3 n). All steps are expected ones, of treaps.
//
// Source: after Basch, Guibas, Zhang, "Proximity problems on moving points" (1997), and Agarwal,
// Kaplan, Sharir, "Kinetic and dynamic data structures for closest pair and all nearest neighbors"
// (2008); octants, colours and offers are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_PAIRS_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_PAIRS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/motion/scene.h"
#include "structures/parts/axis_labels.h"
#include "structures/parts/object_sets.h"

namespace kinex {

// The order of points in a list, from either end.
class PlacesAlong {
 public:
  // `labels`: of the list; they outlive this.
  PlacesAlong(const AxisLabels& labels, bool reversed) : labels_(&labels), reversed_(reversed) {}
  bool before(ObjectId a, ObjectId b) const {
    return (labels_->of(a) < labels_->of(b)) != reversed_;
  }

 private:
  const AxisLabels* labels_;
  bool reversed_;
};

class ConePairs {
 public:
  // offered(p, q, +1) when a node offers the looker p with the seen q, offered(p, q, -1) when it
  // ceases to.
  using Offered = std::function<void(ObjectId, ObjectId, int)>;
  struct Orders {  // of the points: those of the cone, and that of its direction
    PlacesAlong alpha, beta, projection;
  };

  virtual ~ConePairs() = default;

  // The points are these, in any order, at their places.
  virtual void build(std::span<const ObjectId> points) = 0;
  // A point has come, in all orders; along alpha it is behind `previous` (kNoObject: it is the first).
  virtual void insert(ObjectId object, ObjectId previous) = 0;
  // A point goes; the orders need not have it any more.
  virtual void erase(ObjectId object) = 0;
  // Two neighbours have changed places in the order.
  virtual void alpha_changed(ObjectId a, ObjectId b) = 0;
  virtual void beta_changed(ObjectId a, ObjectId b) = 0;
  virtual void projection_changed(ObjectId a, ObjectId b) = 0;

  // Links, orders, what is kept and offered, by brute force.
  virtual void check(AuditReport& report) const = 0;
  virtual std::size_t bytes() const = 0;
};

// What its nodes keep.
enum class KeptPoints : std::uint8_t { kOne, kTwo, kOneOfEachColour };
// The most offers of a treap node.
std::size_t most_offers(KeptPoints kept);
// `objects`: their number in the scene. `classes`: for kOneOfEachColour, whose points are all in
// one of them; it outlives the pairs.
std::unique_ptr<ConePairs> make_cone_pairs(KeptPoints kept, const ConePairs::Orders& orders,
                                           std::size_t objects, const TwoClasses* classes,
                                           ConePairs::Offered offered);

}  // namespace kinex

#endif
