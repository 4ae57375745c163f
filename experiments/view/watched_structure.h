// SPDX-License-Identifier: GPL-3.0-or-later
// WatchedStructure: decorator: forwards every call and notifies a callback afterwards. Between two
// calls of a structure its attribute is defined; within one it need not be.
#ifndef KINEX_EXPERIMENTS_VIEW_WATCHED_STRUCTURE_H
#define KINEX_EXPERIMENTS_VIEW_WATCHED_STRUCTURE_H

#include <functional>
#include <memory>
#include <new>
#include <utility>

#include "core/engine/structure.h"
#include "core/numbers/stop.h"

namespace kinex::view {

class WatchedStructure final : public Structure {
 public:
  // `done` is called when a call that may change the attribute has returned or thrown; with true after
  // certificate_failed. It is not called if the call was stopped or memory was exhausted: the state is then undefined.
  WatchedStructure(std::unique_ptr<Structure> structure, std::function<void(bool failure)> done)
      : structure_(std::move(structure)), done_(std::move(done)) {}

  const Structure& watched() const { return *structure_; }

  std::string_view name() const override { return structure_->name(); }
  std::vector<std::string_view> event_kinds() const override { return structure_->event_kinds(); }
  void build(std::span<const ObjectId> objects) override {
    call([&](Structure& s) { s.build(objects); });
  }
  void rebuild() override {
    call([](Structure& s) { s.rebuild(); });
  }
  void certificate_failed(CertificateId failed) override {
    call([=](Structure& s) { s.certificate_failed(failed); }, true);
  }
  void insert(ObjectId object) override {
    call([=](Structure& s) { s.insert(object); });
  }
  void erase(ObjectId object) override {
    call([=](Structure& s) { s.erase(object); });
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    call([&](Structure& s) { s.motions_changed(objects); });
  }
  void instant_settled() override {
    call([](Structure& s) { s.instant_settled(); });
  }
  void instant_over() override {
    call([](Structure& s) { s.instant_over(); });
  }
  void watched_changed(const Event* event) override {
    call([=](Structure& s) { s.watched_changed(event); });
  }
  Attribute attribute() const override { return structure_->attribute(); }
  Attribute told() const override { return structure_->told(); }
  void visit_proof(ProofVisitor& visitor) const override { structure_->visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override {
    return structure_->bounds(context);
  }
  std::uint64_t most_repairs(std::uint64_t certificates) const override {
    return structure_->most_repairs(certificates);
  }
  void check_invariants(AuditReport& report) const override {
    structure_->check_invariants(report);
  }
  void audit(const Snapshot& snapshot, AuditReport& report) const override {
    structure_->audit(snapshot, report);
  }
  std::size_t bytes() const override { return structure_->bytes(); }

 private:
  template <class Call>
  void call(const Call& function, bool failure = false) {
    try {
      function(*structure_);
    } catch (const Stopped&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (...) {
      done_(failure);
      throw;
    }
    done_(failure);
  }

  std::unique_ptr<Structure> structure_;
  std::function<void(bool failure)> done_;
};

}  // namespace kinex::view

#endif
