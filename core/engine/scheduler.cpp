// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/scheduler.h"

#include <limits>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

StructureId Scheduler::add_structure() {
  require(ledgers_.size() < std::numeric_limits<StructureId>::max(), "too many structures");
  ledgers_.push_back(std::make_unique<StructureLedger>());
  live_per_object_.emplace_back(objects_, 0u);
  shared_.push_back(0);
  windows_.push_back({kInfinity, 0, kInfinity, 0, 0});
  return static_cast<StructureId>(ledgers_.size() - 1);
}

void Scheduler::set_motion(ObjectId object, const Trajectory& trajectory,
                        const std::optional<Rational>& until) {
  arithmetic_->set_motion(object, trajectory, until);
  derived_.set_motion(object, trajectory, until);
  if (derived_.size() > 0) renew_dependents(object);
}

void Scheduler::look_further() {
  poll();
  const CertificateId id = queue_.top();
  Certificate& c = queue_.certificate(id);
  FailureTime time = queue_.time(id);
  const double from = time.lo;
  if (c.looks < kMostLooks) ++c.looks;
  double limit = limit_of(c.structure, c.looks);
  if (!(limit > from)) limit = kInfinity;
  enqueue(id, arithmetic_->look_further(queue_.query(c), from, limit, time), time);
}

void Scheduler::end_change() {
  deferred_ = false;
  for (const auto& [structure, object] : touched_) note_live(structure, object);
  touched_.clear();
}

void Scheduler::begin_event(StructureId structure, CertificateId failed) {
  const StructureLedger& ledger = *ledgers_[structure];
  failing_ = failed;
  failing_structure_ = structure;
  failing_query_ = queue_.query(failed);
  handling_ = true;
  deferred_ = true;
  event_external_ = false;
  created_before_ = ledger.certificates_created;
  retracted_before_ = ledger.certificates_retracted;
}

void Scheduler::end_event() {
  if (failing_ != kNoCertificate) retract(failing_);
  handling_ = false;
  StructureLedger& ledger = *ledgers_[failing_structure_];
  ++ledger.failures;
  if (!event_external_) {
    ++ledger.internal;
    ++ledger.processed;
  }
  ledger.created_per_event.add(ledger.certificates_created - created_before_);
  if (ledger.certificates_retracted >= windows_[failing_structure_].next) {
    update_window(failing_structure_);
  }
  ledger.retracted_per_event.add(ledger.certificates_retracted - retracted_before_);
  end_change();
}

std::size_t Scheduler::bytes() const {
  std::size_t total = queue_.bytes() + derived_.bytes() +
                      ledgers_.size() * sizeof(StructureLedger) +
                      touched_.capacity() * sizeof(touched_[0]) +
                      index_places_.capacity() * sizeof(index_places_[0]) +
                      index_.capacity() * sizeof(index_[0]);
  for (const auto& live : live_per_object_) total += live.capacity() * sizeof(std::uint32_t);
  for (const auto& list : index_) total += list.capacity() * sizeof(CertificateId);
  return total;
}

}  // namespace kinex
