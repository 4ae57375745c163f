// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/schnyder_wood.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/merge_sort.h"

namespace kinex {
namespace {

// The other two of three orders or colours, in cyclic order.
std::size_t successor(std::size_t i) { return i == 2 ? 0 : i + 1; }
std::size_t predecessor(std::size_t i) { return i == 0 ? 2 : i - 1; }

// The smallest of the values entered so far at places below a bound (a Fenwick tree of minima).
class PrefixMinimum {
 public:
  static constexpr std::size_t kNone = ~std::size_t{0};
  explicit PrefixMinimum(std::size_t places) : least_(places + 1, kNone) {}
  void enter(std::size_t place, std::size_t value) {
    for (std::size_t i = place + 1; i < least_.size(); i += i & (~i + 1)) {
      least_[i] = std::min(least_[i], value);
    }
  }
  std::size_t below(std::size_t bound) const {
    std::size_t result = kNone;
    for (std::size_t i = bound; i > 0; i -= i & (~i + 1)) result = std::min(result, least_[i]);
    return result;
  }

 private:
  std::vector<std::size_t> least_;
};

}  // namespace

SchnyderWood::SchnyderWood(std::size_t objects, Before before, Changed changed)
    : objects_(objects),
      before_(std::move(before)),
      changed_(std::move(changed)),
      present_(objects, false),
      links_(objects),
      chains_(objects + 1) {}

// ---- links

void SchnyderWood::unlink(std::size_t colour, ObjectId p) {
  const Link& link = links_[p][colour];
  Chain& chain = chains_[place(link.target)][colour];
  (link.previous == kNoObject ? chain.first : links_[link.previous][colour].next) = link.next;
  (link.next == kNoObject ? chain.last : links_[link.next][colour].previous) = link.previous;
}

void SchnyderWood::link(std::size_t colour, ObjectId p, ObjectId q, ObjectId previous,
                        ObjectId next) {
  Chain& chain = chains_[place(q)][colour];
  links_[p][colour] = {q, previous, next};
  (previous == kNoObject ? chain.first : links_[previous][colour].next) = p;
  (next == kNoObject ? chain.last : links_[next][colour].previous) = p;
}

void SchnyderWood::link_at(std::size_t colour, ObjectId p, ObjectId q, End at) {
  if (at == End::kFirst) {
    link(colour, p, q, kNoObject, end(colour, q, End::kFirst));
  } else {
    link(colour, p, q, end(colour, q, End::kLast), kNoObject);
  }
}

// Between two of the chain of q, which is in the order of f_j.
void SchnyderWood::link_in_order(std::size_t colour, ObjectId p, ObjectId q) {
  const std::size_t j = successor(colour);
  ObjectId next = kNoObject, previous = end(colour, q, End::kLast);
  while (previous != kNoObject && before_(j, p, previous)) {
    next = previous;
    previous = links_[previous][colour].previous;
  }
  link(colour, p, q, previous, next);
}

// ---- the whole wood

// In colour i, with j and k behind it: points in the order of f_j choose among those before them,
// of which those with a smaller f_k count. Each joins the end of its chain.
void SchnyderWood::make(const std::array<std::span<const ObjectId>, kColours>& orders) {
  const std::size_t n = orders[0].size();
  std::array<std::vector<std::size_t>, kColours> rank;
  for (std::size_t order = 0; order < kColours; ++order) {
    rank[order].assign(objects_, 0);
    for (std::size_t i = 0; i < n; ++i) rank[order][orders[order][i]] = i;
  }
  present_.assign(objects_, false);
  for (const ObjectId p : orders[0]) present_[p] = true;
  for (std::size_t colour = 0; colour < kColours; ++colour) {
    const std::size_t j = successor(colour), k = predecessor(colour);
    std::vector<ObjectId> old(objects_);
    for (ObjectId p = 0; p < objects_; ++p)
      old[p] = std::exchange(links_[p][colour], Link{}).target;
    for (std::array<Chain, kColours>& chains : chains_) chains[colour] = {};
    PrefixMinimum chosen(n);
    for (const ObjectId p : orders[j]) {
      const std::size_t least = chosen.below(rank[k][p]);
      link_at(colour, p, least == PrefixMinimum::kNone ? kNoObject : orders[colour][least],
              End::kLast);
      chosen.enter(rank[k][p], rank[colour][p]);
    }
    for (ObjectId p = 0; p < objects_; ++p) {
      if (old[p] != links_[p][colour].target) changed_(colour, p, old[p]);
    }
  }
}

// ---- points that come and go

void SchnyderWood::insert(ObjectId p, std::span<const ObjectId> points) {
  std::array<ObjectId, kColours> best{kNoObject, kNoObject, kNoObject};
  std::array<std::vector<ObjectId>, kColours> choose;
  for (const ObjectId r : points) {
    if (r == p) continue;
    std::array<bool, kColours> behind{before_(0, p, r), before_(1, p, r), false};
    behind[2] = behind[0] == behind[1] ? !behind[0] : before_(2, p, r);
    for (std::size_t i = 0; i < kColours; ++i) {
      if (behind[successor(i)] != behind[predecessor(i)] || behind[i] == behind[successor(i)])
        continue;
      if (behind[i]) {  // r is in the cone i of p
        if (best[i] == kNoObject || before_(i, r, best[i])) best[i] = r;
      } else {
        const ObjectId target = links_[r][i].target;
        if (target == kNoObject || before_(i, p, target)) choose[i].push_back(r);
      }
    }
  }
  present_[p] = true;
  for (std::size_t i = 0; i < kColours; ++i) {
    const std::size_t j = successor(i);
    merge_sort(choose[i], [&](ObjectId a, ObjectId b) { return before_(j, a, b); });
    for (const ObjectId r : choose[i]) {
      const ObjectId old = links_[r][i].target;
      unlink(i, r);
      link_at(i, r, p, End::kLast);
      point(i, r, old);
    }
    link_in_order(i, p, best[i]);
    if (best[i] != kNoObject) point(i, p, kNoObject);
  }
}

// False if they are too many.
bool SchnyderWood::add_neighbours(ObjectId p, std::vector<ObjectId>& neighbours) const {
  for (std::size_t i = 0; i < kColours; ++i) {
    if (links_[p][i].target != kNoObject) neighbours.push_back(links_[p][i].target);
    for (ObjectId r = end(i, p, End::kFirst); r != kNoObject; r = links_[r][i].next) {
      if (neighbours.size() >= kMostNeighbours) return false;
      neighbours.push_back(r);
    }
  }
  return true;
}

bool SchnyderWood::erase(ObjectId p) {
  std::vector<ObjectId> neighbours;
  if (!add_neighbours(p, neighbours)) return false;
  present_[p] = false;
  for (std::size_t i = 0; i < kColours; ++i) {
    const std::size_t j = successor(i), k = predecessor(i);
    const ObjectId old = links_[p][i].target;
    unlink(i, p);
    links_[p][i] = {};
    if (old != kNoObject) point(i, p, old);
    for (ObjectId r = end(i, p, End::kFirst); r != kNoObject; r = end(i, p, End::kFirst)) {
      ObjectId best = kNoObject;
      for (const ObjectId q : neighbours) {
        if (q == r || (best != kNoObject && !before_(i, q, best))) continue;
        if (before_(j, q, r) && before_(k, q, r)) best = q;
      }
      unlink(i, r);
      link_in_order(i, r, best);
      point(i, r, p);
    }
  }
  return true;
}

// ---- two neighbours that have changed places

SchnyderWood::Swap SchnyderWood::swap(std::size_t order, ObjectId q, ObjectId p) {
  const std::size_t j = order;
  std::size_t i = successor(j), k = predecessor(j);
  const bool in_next = before_(i, p, q);
  if (in_next == before_(k, p, q)) return Swap::kImpossible;
  if (!in_next) std::swap(i, k);
  if (links_[p][i].target != q) return Swap::kNothing;
  if (links_[p][j].target == q || links_[q][i].target == p) return Swap::kImpossible;
  // The chains of j and of i by ascending f: in which direction depends on the names of i and k.
  const bool forward = i == successor(j);
  const End run = forward ? End::kFirst : End::kLast;
  const End far = forward ? End::kLast : End::kFirst;
  const ObjectId old_of_q = links_[q][k].target;

  ObjectId r = end(j, q, run);
  while (r != kNoObject && before_(k, p, r)) {
    const ObjectId following = forward ? links_[r][j].next : links_[r][j].previous;
    unlink(j, r);
    link_at(j, r, p, far);
    point(j, r, q);
    r = following;
  }
  // In in(i, z) p is the one with the largest f_j; in in(i, next(i, q)) the neighbour of q before it.
  unlink(i, p);
  if (r != kNoObject) {
    link_at(i, p, r, j == successor(i) ? End::kLast : End::kFirst);
  } else if (j == successor(i)) {
    link(i, p, links_[q][i].target, links_[q][i].previous, q);
  } else {
    link(i, p, links_[q][i].target, q, links_[q][i].next);
  }
  point(i, p, q);
  // In in(k, p) q is the one with the smallest f_j.
  unlink(k, q);
  link_at(k, q, p, j == successor(k) ? End::kFirst : End::kLast);
  point(k, q, old_of_q);
  return Swap::kDone;
}

// ---- checks

void SchnyderWood::check(AuditReport& report) const {
  for (std::size_t colour = 0; colour < kColours; ++colour) {
    std::vector<bool> seen(objects_, false);
    const std::size_t j = successor(colour), k = predecessor(colour);
    for (std::size_t i = 0; i <= objects_; ++i) {
      const ObjectId q = i == objects_ ? kNoObject : static_cast<ObjectId>(i);
      ObjectId previous = kNoObject;
      for (ObjectId p = chains_[i][colour].first; p != kNoObject && !seen[p];
           p = links_[p][colour].next) {
        const auto at = [&] { return " at point " + std::to_string(p); };
        seen[p] = true;
        report.check(links_[p][colour].target == q && links_[p][colour].previous == previous,
                     [&] { return "a broken link" + at(); });
        report.check(q == kNoObject || (before_(j, q, p) && before_(k, q, p)),
                     [&] { return "a point in another cone" + at(); });
        report.check(previous == kNoObject || (before_(j, previous, p) && before_(k, p, previous)),
                     [&] { return "a chain in another order" + at(); });
        previous = p;
      }
      report.check(chains_[i][colour].last == previous, [] { return "a chain with another end"; });
    }
    report.check(seen == present_, [] { return "points that are in no chain"; });
  }
}

std::size_t SchnyderWood::bytes() const {
  return present_.capacity() / 8 + links_.capacity() * sizeof(links_[0]) +
         chains_.capacity() * sizeof(chains_[0]);
}

}  // namespace kinex
