// SPDX-License-Identifier: GPL-3.0-or-later
// PlainList: the simplest kinetic structure, a sorted array, for tests of the simulator. It records
// every call and accepts ties in any order.
#ifndef KINEX_TESTS_CORE_ENGINE_PLAIN_LIST_H
#define KINEX_TESTS_CORE_ENGINE_PLAIN_LIST_H

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/predicate_formula.h"
#include "core/engine/kernel.h"
#include "core/engine/structure.h"

namespace kinex::test {

struct Difference {
  static constexpr int kArity = 2;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  std::string_view name() const { return "difference"; }
  int dimension() const { return 1; }
  template <class Points>
  auto value(const Points& p) const {
    return widen(p(1, 0) - p(0, 0));
  }
};

class PlainList : public Structure {
 public:
  PlainList(Kernel& kernel, StructureId id)
      : kernel_(&kernel),
        id_(id),
        less_(kernel.bind(std::make_shared<FormulaPredicate<Difference>>())) {}

  std::vector<std::string> calls;

  std::string_view name() const override { return "plain_list"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap"});
  }
  void build(std::span<const ObjectId> objects) override {
    for (const ObjectId o : objects) put(o);
    certify();
  }
  void rebuild() override {
    calls.push_back("rebuild");
    std::vector<ObjectId> all = std::exchange(order_, {});
    std::sort(all.begin(), all.end());
    for (const ObjectId o : all) put(o);
    certify();
  }
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    note("failed", {order_[i], order_[i + 1]}, kernel_->instant_is_shared(id_) ? " shared" : "");
    std::swap(order_[i], order_[i + 1]);
    for (std::uint32_t k = i == 0 ? 0 : i - 1; k <= i + 1 && k + 1 < order_.size(); ++k) {
      kernel_->replace(certificates_[k], Query(less_, {order_[k], order_[k + 1]}), k);
    }
    kernel_->report(id_, 0, {order_[i + 1], order_[i]}, true);
  }
  void insert(ObjectId object) override {
    note("insert", {object});
    put(object);
    certify();
  }
  void erase(ObjectId object) override {
    note("erase", {object});
    order_.erase(std::find(order_.begin(), order_.end(), object));
    certify();
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    note("motions", {objects.begin(), objects.end()});
  }
  void instant_settled() override { calls.push_back("settled"); }
  Attribute attribute() const override { return {Attribute::Shape::kSequence, order_}; }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override {
    last_context = context;
    return {};
  }
  void check_invariants(AuditReport& report) const override {
    report.check(certificates_.size() + 1 == std::max<std::size_t>(order_.size(), 1),
                 [] { return std::string("certificates"); });
  }
  void audit(const Snapshot& snapshot, AuditReport& report) const override {
    std::vector<Rational> keys;
    for (const ObjectId o : order_) keys.push_back(snapshot.position(o, 0));
    report.check(std::is_sorted(keys.begin(), keys.end()), [] { return std::string("order"); });
  }
  std::size_t bytes() const override { return order_.size() * sizeof(ObjectId); }

  mutable BoundContext last_context;

 protected:
  void note(std::string call, const std::vector<ObjectId>& ids, const char* end = "") {
    for (const ObjectId id : ids) call.append(" ").append(std::to_string(id));
    calls.push_back(call.append(end));
  }
  void put(ObjectId object) {
    std::size_t i = 0;
    while (i < order_.size() && kernel_->sign_after(less_, {order_[i], object}) != Sign::kNegative)
      ++i;
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(i), object);
  }
  void certify() {
    for (const CertificateId c : certificates_) kernel_->retract(c);
    certificates_.clear();
    for (std::uint32_t i = 0; i + 1 < order_.size(); ++i) {
      const Query query(less_, {order_[i], order_[i + 1]});
      certificates_.push_back(kernel_->create(id_, query, i).id);
    }
  }

  Kernel* kernel_;
  StructureId id_;
  PredicateId less_;
  std::vector<ObjectId> order_;
  std::vector<CertificateId> certificates_;
};

}  // namespace kinex::test

#endif
