// SPDX-License-Identifier: GPL-3.0-or-later
// ShiftingPairs: the closest of a set of pairs of points that changes all the time, for tests of
// ChangingExtremum and FrontPair: whenever a certificate fails, pairs of a random choice come and go.
#ifndef KINEX_TESTS_STRUCTURES_PARTS_SHIFTING_PAIRS_H
#define KINEX_TESTS_STRUCTURES_PARTS_SHIFTING_PAIRS_H

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/pair_distances.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

class ShiftingPairs final : public FrontPair<PairDistances> {
 public:
  // `shift`: how many pairs change at a failure.
  ShiftingPairs(Kernel& kernel, StructureId id, int dimension, std::uint64_t seed, int shift)
      : FrontPair(kernel, id, "pairs", "pairs by distance", PairDistances(kernel, dimension)),
        random_(seed),
        shift_(shift) {}

  std::string_view name() const override { return "shifting_pairs"; }
  void build(std::span<const ObjectId> objects) override {
    present_.assign(objects.begin(), objects.end());
    for (std::size_t i = 0; i < 2 * present_.size(); ++i) toggle();
    begin();
  }
  void certificate_failed(CertificateId failed) override {
    const Duel duel = pairs_.failed(failed, tied());
    for (int i = 0; i < shift_; ++i) toggle();
    pairs_.apply(tied());
    replaced(duel);
  }
  void insert(ObjectId object) override {
    present_.push_back(object);
    for (int i = 0; i < 3; ++i) toggle();
    begin();
  }
  void erase(ObjectId object) override {
    std::erase(present_, object);
    for (const Pair& pair : pairs_.values()) {
      if (pair[0] == object || pair[1] == object) go(pair);
    }
    begin();
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    FrontPair::motions_changed(objects);
    for (int i = 0; i < shift_; ++i) toggle();
    pairs_.apply(tied());
  }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override {
    return {
        at_most("shifting_pairs.certificates", "a tournament of the pairs",
                counted(most_pairs_ == 0 ? 0 : most_pairs_ - 1), counted(context.ledger->max_live)),
        at_most("shifting_pairs.events", "epochs", pairs_.most_failures(2 * context.degree),
                counted(context.ledger->failures))};
  }
  void check_invariants(AuditReport& report) const override {
    FrontPair::check_invariants(report);
    report.check(pairs_.values() == std::vector<Pair>(expected_.begin(), expected_.end()),
                 [] { return "another set"; });
    const PartLedger& line = pairs_.slots().line();
    report.check(line.live == (expected_.empty() ? 0 : expected_.size() - 1),
                 [] { return "another number of certificates"; });
    report.check(line.created - line.retracted == line.live, [] { return "the line's sum"; });
  }
  // Brute force.
  void audit(const Snapshot& snapshot, AuditReport& report) const override {
    std::vector<ObjectId> best;
    Rational least;
    for (const Pair& pair : expected_) {
      Rational sum;
      for (int axis = 0; axis < snapshot.dimension(); ++axis) {
        const Rational d = snapshot.position(pair[0], axis) - snapshot.position(pair[1], axis);
        sum += d * d;
      }
      if (!best.empty() && !(sum < least)) continue;
      best = {pair[0], pair[1]};
      least = sum;
    }
    report.check(best == attribute().ids, [] { return "another pair is the closest"; });
  }

  const PartLedger& line() const { return pairs_.slots().line(); }
  std::uint64_t toggles() const { return toggles_; }

 private:
  void go(Pair pair) {  // a copy: it may lie in expected_
    expected_.erase(pair);
    if (!pairs_.go(pair)) throw std::logic_error("a pair that is not there");
  }
  // A pair comes, or one that is there goes: so that there are about twelve.
  void toggle() {
    if (present_.size() < 2) return;
    ++toggles_;
    if (!expected_.empty() && random_.chance(expected_.size() > 12 ? 70 : 15)) {
      auto at = expected_.begin();
      std::advance(at, random_.between(0, static_cast<int>(expected_.size()) - 1));
      return go(*at);
    }
    const int n = static_cast<int>(present_.size());
    ObjectId a = present_[static_cast<std::size_t>(random_.between(0, n - 1))];
    ObjectId b = present_[static_cast<std::size_t>(random_.between(0, n - 1))];
    if (a == b) return;
    if (b < a) std::swap(a, b);
    if (pairs_.come({a, b}) != expected_.insert({a, b}).second) {
      throw std::logic_error("a pair that is there, or not");
    }
    most_pairs_ = std::max(most_pairs_, expected_.size());
  }

  Random random_;
  int shift_;
  std::vector<ObjectId> present_;
  std::set<Pair> expected_;
  std::size_t most_pairs_ = 0;
  std::uint64_t toggles_ = 0;
};

}  // namespace kinex::test

#endif
