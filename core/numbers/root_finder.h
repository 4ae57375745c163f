// SPDX-License-Identifier: GPL-3.0-or-later
// RootFinder: isolates the real roots above a point one by one, from left to right.
//
// Bernstein bisection. The number v of sign variations of the Bernstein coefficients on a cell
// exceeds the number of roots inside (with multiplicity) by an even number: 0 proves none, 1 proves
// one. Cells with more are halved, lower half first:
//
//   depth 0   |-------------- 3 --------------|     number: v
//   depth 1   |------ 2 ------|------ 1 ------|     v = 1: kInterval, found last
//   depth 2   |-- 0 --|-- 2 --|                     v = 0: dropped
//   depth 3           |-1-|-1-|                     kInterval, kInterval: the first two roots
//
// A cell that keeps exactly two variations over several levels is settled at once: its two close
// roots, if real, are separated at the root of the derivative between them (close_pair.h).
//
// Source: Descartes' rule of signs in the Bernstein basis with bisection (Lane, Riesenfeld 1981;
// the method of Vincent, Collins and Akritas), integer arithmetic.
#ifndef KINEX_CORE_NUMBERS_ROOT_FINDER_H
#define KINEX_CORE_NUMBERS_ROOT_FINDER_H

#include <memory>
#include <optional>
#include <vector>

#include "core/numbers/real_root.h"

namespace kinex {

class RootFinder {
 public:
  enum class Status {
    kPoint,     // a root at a dyadic point, with its multiplicity
    kInterval,  // one simple root between the ends, which are not roots
    kStuck,     // reached the depth limit with two or more variations; raise it to continue
    kFinished   // no more roots (up to the limit)
  };

  // Roots of p strictly above origin / 2^exponent (exponent >= 0); p of positive degree. Roots
  // above limit / 2^exponent need not be found. p need not be square-free, but then the search does
  // not get past a multiple root that is not dyadic: see kStuck.
  RootFinder(std::shared_ptr<const Polynomial> p, Integer origin, long exponent,
             std::optional<Integer> limit, RootCounters& counters);

  Status next();
  void set_depth_limit(long limit) { depth_limit_ = limit; }

  // What the last next() found.
  Rational point() const;
  int multiplicity() const { return multiplicity_; }
  RealRoot root() const;
  // The negative of the last found root, as a root of `mirrored`(t) = +-p(-t).
  RealRoot mirrored_root(const std::shared_ptr<const Polynomial>& mirrored) const;

 private:
  // Bernstein coefficients (times a positive constant) on the cell [cell, cell + 1] * 2^(width -
  // depth) above the origin, in units of 2^-exponent.
  struct Node {
    std::vector<Integer> b;
    Integer cell;
    long depth = 0;
    int levels_with_two = 0;  // number of enclosing cells with two sign variations
    bool lower_done = false;  // a root at the lower end has been reported (or is not wanted)
  };

  void start(const Polynomial& p);
  void split(Node&& node);
  bool beyond_limit(const Node& node) const;
  Integer end_of(const Integer& cell, long depth) const;
  long exponent_at(long depth) const;
  // Settles a node with two sign variations if the derivative has exactly one root in it.
  bool settle_pair(const Node& node);

  std::shared_ptr<const Polynomial> p_;
  Integer origin_;
  long exponent_;
  std::optional<Integer> limit_;  // relative to the origin
  long width_ = 0;
  long depth_limit_ = -1;  // none
  std::vector<Node> stack_;
  // the last root
  struct Interval {
    Integer lower, upper;
    long exponent = 0;
    Sign sign_at_lower = Sign::kZero;
  };
  Interval found_;
  int multiplicity_ = 0;
  std::optional<Interval> pending_;  // the upper one of a pair
  RootCounters& counters_;
};

}  // namespace kinex

#endif
