// SPDX-License-Identifier: GPL-3.0-or-later
// SchnyderWood: of every point, in each of three cones around it, which point comes next. It is
// made from three linear orders f1, f2, f3 of the points, in which no two points are ordered alike
// in all three: as those by three linear functions whose sum is zero.
//
// For a colour i, j and k being the others, next(i, p) is the point s with f_j(s) < f_j(p) and
// f_k(s) < f_k(p) whose f_i(s) is smallest, or no point. With three points at infinity for "no
// point" the edges p - next(i, p) triangulate the sphere; counter-clockwise around p:
//
//             next 3                   in(i, q) = {p : next(i, p) = q} is an antichain in f_j and
//       in 1         in 2              f_k: along it f_j ascends while f_k descends. It is kept as
//   next 2     p       next 1          a chain of links, so a swap of two neighbours of an order
//             in 3                     costs as much as it changes.
//
// Swap rule. Neighbours q, p of the order j change places: q before p becomes p before q. One of
// the other orders, call it i, has p before q; the third one, k, has q before p.
//   if next(i, p) is not q, nothing changes
//   else next(k, q) becomes p
//        next(j, r) becomes p for those r in in(j, q) with f_k(p) < f_k(r): one end of in(j, q)
//        next(i, p) becomes the r that is left in in(j, q) with the largest f_k(r), or, if there is
//        none, next(i, q)
// Proof. Only sets of p lose q, only those of q gain p, and in colour j others choose between p and
// q. If w = next(i, p) is not q, then w is before q in i and j, and before p in k: q keeps w or
// better in colour k, and a point that has both in its cone j chooses w. If next(i, p) = q, a point before q
// in i and j and before p in k would have been chosen by p, so q chooses p; those that see both in
// colour j had chosen q; the next one of p is found among those that q covered, or behind q.
//
// A wood proves itself. Let each pointer of the wood of some points have its pair in the same order in two
// configurations of them, and let the points move from one to the other linearly (a little, where they are
// level, so that no two pairs change places at once). A pair changes places in an order once at most, and
// none that a pointer joins does: the wood stays what it is. So pointers of which all claims hold are the
// right ones, whatever became of the other pairs.
//
// Points that come or go. Without p only those that chose p choose others, and those are neighbours of p: the
// rest of the triangulation stays, and the new edges are in the hole that p leaves. A point p that comes is
// chosen in colour i where it is in the cone, and nearer along f_i than what is chosen there.
//
// Source: ours. The figure is the "equilateral Delaunay graph" of Rahmati, Abam, King, Whitesides
// and Zarei, a Schnyder wood.
#ifndef KINEX_STRUCTURES_PROXIMITY_SCHNYDER_WOOD_H
#define KINEX_STRUCTURES_PROXIMITY_SCHNYDER_WOOD_H

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/motion/scene.h"

namespace kinex {

class SchnyderWood {
 public:
  static constexpr std::size_t kColours = 3;  // numbered from 0, as the orders are
  // a comes before b in an order, right after now.
  using Before = std::function<bool(std::size_t order, ObjectId a, ObjectId b)>;
  // next(colour, p) has changed; it was `old` (kNoObject: no point).
  using Changed = std::function<void(std::size_t colour, ObjectId p, ObjectId old)>;

  // `objects`: ids are below this number.
  SchnyderWood(std::size_t objects, Before before, Changed changed);

  // kNoObject if there is none, or if p is no point of the wood.
  ObjectId next(std::size_t colour, ObjectId p) const { return links_[p][colour].target; }
  // The wood of these points, each order from its first one to its last one. O(n log n). Points that
  // come or go are reported like all others.
  void make(const std::array<std::span<const ObjectId>, kColours>& orders);
  // A point that is none of the wood comes; `points`: the others, in any order. O(1) comparisons for each of
  // them, and those of a place in a chain for each pointer that changes.
  void insert(ObjectId p, std::span<const ObjectId> points);
  // A point goes. O(d^2) comparisons where it has d neighbours, and those of places in chains. False: it has
  // more than kMostNeighbours, and nothing has changed.
  static constexpr std::size_t kMostNeighbours = 32;
  bool erase(ObjectId p);
  enum class Swap {
    kNothing,     // no pointer joins the two
    kDone,        // pointers have changed
    kImpossible,  // nothing has changed: the two were ordered alike in all three orders, or are now;
                  // in an inexact arithmetic also where pointers contradict the orders
  };
  // Two neighbours of an order have changed places: `last` was the first of the two. O(1) for each
  // pointer that changes.
  Swap swap(std::size_t order, ObjectId last, ObjectId first);

  // Prefetches what next() reads of the point. No effect on results.
  void prefetch_next(ObjectId p) const {
    if (p != kNoObject) __builtin_prefetch(links_.data() + p, 1);
  }
  // Prefetches what a swap of the point reads. No effect on results.
  void prefetch(ObjectId p) const {
    __builtin_prefetch(links_.data() + p, 1);
    __builtin_prefetch(chains_.data() + p, 1);
  }

  // The links against each other, and the order of each chain.
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Link {                                       // of a point p and a colour
    ObjectId target = kNoObject;                      // next(colour, p)
    ObjectId previous = kNoObject, next = kNoObject;  // in the chain of the target
  };
  struct Chain {  // of in(colour, q), by ascending f of the colour's successor
    ObjectId first = kNoObject, last = kNoObject;
  };
  enum class End : bool { kFirst, kLast };

  // The place in the chains: no point is behind all of them.
  std::size_t place(ObjectId q) const { return q == kNoObject ? objects_ : q; }
  ObjectId end(std::size_t colour, ObjectId q, End end) const {
    const Chain& chain = chains_[place(q)][colour];
    return end == End::kFirst ? chain.first : chain.last;
  }
  void unlink(std::size_t colour, ObjectId p);
  // p chooses q, and is put between two neighbours of the chain of q.
  void link(std::size_t colour, ObjectId p, ObjectId q, ObjectId previous, ObjectId next);
  void link_at(std::size_t colour, ObjectId p, ObjectId q, End end);
  void link_in_order(std::size_t colour, ObjectId p, ObjectId q);
  bool add_neighbours(ObjectId p, std::vector<ObjectId>& neighbours) const;
  void point(std::size_t colour, ObjectId p, ObjectId old) { changed_(colour, p, old); }

  std::size_t objects_;
  Before before_;
  Changed changed_;
  std::vector<bool> present_;
  // By point, then by colour: what is near in the plane of one point is near in memory.
  std::vector<std::array<Link, kColours>> links_;
  std::vector<std::array<Chain, kColours>> chains_;  // the last one: of no point
};

}  // namespace kinex

#endif
