// SPDX-License-Identifier: GPL-3.0-or-later
// BestDirection: the common base class of structures that measure something along every direction, by
// the extreme objects there, and keep the best direction: extent_directions.h, rectangle_directions.h.
//
// Certificates. The extreme objects of all directions (DirectionMaxima), and a tournament of what is
// measured along one half of them, or one quarter: a value is the number i of a direction, the extreme
// objects in it and in the opposite one, and, for a quarter, those of the direction turned by 90
// degrees and of its opposite.
//
//   extents    i, high, low              of 2k directions of 4k
//   boxes      i, high, low, left, right of k directions of 4k
//
// Values of one object are zero identically and take no part in the tournament.
#ifndef KINEX_STRUCTURES_EXTENT_BEST_DIRECTION_H
#define KINEX_STRUCTURES_EXTENT_BEST_DIRECTION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/extent/direction_maxima.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {

template <class Claims>
class BestDirection : public Structure {
 public:
  // kReplace: in a direction, or in a duel of its tournament, another object is ahead: the old one,
  // the new one. kOvertake: another value wins a duel: the objects of the old one, then those of the
  // new one. kTie: either of these, because the two have become identically level.
  enum Kind : std::uint8_t { kReplace, kOvertake, kTie };

  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "overtake", "tie"});
  }
  void build(std::span<const ObjectId> objects) override {
    maxima_->build(objects, level());
    begin();
  }
  void rebuild() override {
    maxima_->rebuild(level());
    read_all();
    values_.rebuild(equal());
    begin();
  }
  void certificate_failed(CertificateId failed) override {
    if (maxima_->owns(failed)) {
      const auto [direction, before, after] = maxima_->failed(failed, level());
      read(direction % count());
      values_.apply(equal());
      events_.repaired(kReplace, {before, after}, best());
    } else {
      const auto [old, fresh] = values_.failed(failed, equal());
      with_objects(old, fresh, [this](std::initializer_list<ObjectId> ids) {
        events_.repaired(kOvertake, ids, best());
      });
    }
  }
  void insert(ObjectId object) override {
    maxima_->insert(object, level());
    begin();
  }
  void erase(ObjectId object) override {
    maxima_->erase(object, level());
    begin();
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    maxima_->motions_changed(objects, level());
    read_all();
    values_.motions_changed(objects, equal());
  }
  void instant_over() override { events_.over(best()); }
  int largest_motion_degree() const override { return maxima_->largest_motion_degree(); }
  Attribute attribute() const override { return {events_.told().shape, best()}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override {
    maxima_->visit_proof(visitor);
    visit_tournament(visitor, values_, static_cast<std::uint32_t>(maxima_->size()), text_,
                     [](const Value& winner) {
                       return std::vector<ObjectId>(winner.begin() + 1, winner.end());
                     });
  }
  void check_invariants(AuditReport& report) const override {
    maxima_->check(report);
    values_.check(report, part_);
    std::size_t present = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      const auto where = [&] { return " of " + part_ + " in direction " + std::to_string(i); };
      report.check(current_[i] == value(i), [&] { return "other objects than those" + where(); });
      if (is_point(current_[i])) continue;
      ++present;
      report.check(values_.has(current_[i]), [&] { return "a loss" + where(); });
    }
    report.check(present == values_.size(), [&] { return "too many of " + part_; });
    report.check(events_.told().ids == best(),
                 [&] { return "a change of the best of " + part_ + " was not reported"; });
  }
  std::size_t bytes() const override {
    return maxima_->bytes() + values_.bytes() + events_.bytes() +
           current_.capacity() * sizeof(Value);
  }

 protected:
  using Value = typename Claims::Value;

  // `part`: the name of the tournament in the ledger. `text`: what it is about, for viewers.
  BestDirection(Kernel& kernel, StructureId id, std::unique_ptr<DirectionMaxima> maxima,
                std::string part, std::string text, Claims claims, Attribute::Shape shape)
      : kernel_(&kernel),
        id_(id),
        maxima_(std::move(maxima)),
        values_(kernel, id, part, std::move(claims)),
        part_(std::move(part)),
        text_(std::move(text)),
        events_(kernel, id, shape) {
    for (std::size_t i = 0; i < count(); ++i) current_.push_back(value(i));
  }

  // The attribute: of the front value.
  virtual std::vector<ObjectId> best() const = 0;
  // The number of values, with those of one object.
  std::size_t count() const { return maxima_->size() / (std::tuple_size_v<Value> - 1); }
  const DirectionMaxima& maxima() const { return *maxima_; }
  const ChangingExtremum<Claims>& values() const { return values_; }

 private:
  DirectionMaxima::Tied level() {
    return [this](const DirectionMaxima::Duel& duel) {
      kernel_->report(id_, kTie, {duel.before, duel.after}, false);
    };
  }
  auto equal() {
    return [this](const Value& a, const Value& b) {
      with_objects(a, b, [this](std::initializer_list<ObjectId> ids) {
        kernel_->report(id_, kTie, ids, false);
      });
    };
  }
  // Calls visit(objects of a, then of b).
  template <class Visit>
  static void with_objects(const Value& a, const Value& b, const Visit& visit) {
    if constexpr (std::tuple_size_v<Value> == 3) {
      visit({a[1], a[2], b[1], b[2]});
    } else {
      visit({a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4]});
    }
  }
  Value value(std::size_t i) const {
    Value result{static_cast<ObjectId>(i)};
    for (std::size_t turned = i, place = 1; place < result.size(); turned += count(), place += 2) {
      result[place] = maxima_->winner(turned);
      result[place + 1] = maxima_->winner(maxima_->opposite(turned));
    }
    return result;
  }
  static bool is_point(const Value& value) {
    return std::all_of(value.begin() + 2, value.end(), [&](ObjectId id) { return id == value[1]; });
  }
  void read(std::size_t i) {
    const Value fresh = value(i);
    if (fresh == current_[i]) return;
    if (!is_point(current_[i])) values_.go(current_[i]);
    if (!is_point(fresh)) values_.come(fresh);
    current_[i] = fresh;
  }
  void read_all() {
    for (std::size_t i = 0; i < count(); ++i) read(i);
    values_.apply(equal());
  }
  void begin() {
    read_all();
    events_.begin(best());
  }

  Kernel* kernel_;
  StructureId id_;
  std::unique_ptr<DirectionMaxima> maxima_;
  ChangingExtremum<Claims> values_;
  std::vector<Value> current_;  // by direction, those that are in values_ and those of one object
  std::string part_, text_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
