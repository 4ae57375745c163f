// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bench/queue_trace.h"

#include <memory>
#include <utility>

#include "core/engine/scheduler.h"
#include "core/engine/simulator.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::bench {
namespace {

using Kind = QueueOperation::Kind;

// Decorator: forwards every failure to a structure, and compares the queue before and after it.
class Recorder final : public Structure {
 public:
  Recorder(std::unique_ptr<Structure> inner, Kernel& kernel, QueueTrace& trace)
      : inner_(std::move(inner)), kernel_(&kernel), trace_(&trace) {}

  std::string_view name() const override { return inner_->name(); }
  std::vector<std::string_view> event_kinds() const override { return inner_->event_kinds(); }
  void build(std::span<const ObjectId> objects) override { inner_->build(objects); }
  void rebuild() override { inner_->rebuild(); }
  void certificate_failed(CertificateId failed) override {
    if (trace_->events > 0) look(failed);
    ++trace_->events;
    if (!known_.empty() && known_[failed].queued) {
      known_[failed].queued = false;
      trace_->operations.push_back({Kind::kPop, failed, 0, 0});
    } else {
      look(failed);  // the first failure: everything that was built
      trace_->operations.push_back({Kind::kPush, failed, -1e300, -1e300});
      trace_->operations.push_back({Kind::kPop, failed, 0, 0});
    }
    inner_->certificate_failed(failed);
    look(kNoCertificate);
  }
  void insert(ObjectId object) override { inner_->insert(object); }
  void erase(ObjectId object) override { inner_->erase(object); }
  void motions_changed(std::span<const ObjectId> o) override { inner_->motions_changed(o); }
  void instant_settled() override { inner_->instant_settled(); }
  void instant_over() override { inner_->instant_over(); }
  Attribute attribute() const override { return inner_->attribute(); }
  Attribute told() const override { return inner_->told(); }
  std::vector<BoundCheck> bounds(const BoundContext& c) const override { return inner_->bounds(c); }
  void check_invariants(AuditReport& report) const override { inner_->check_invariants(report); }
  void audit(const Snapshot& s, AuditReport& r) const override { inner_->audit(s, r); }
  std::size_t bytes() const override { return inner_->bytes(); }

 private:
  struct Known {
    bool queued = false;
    double lo = 0, hi = 0;
  };

  // Records the changes since the last look, except those of `except`.
  void look(CertificateId except) {
    const EventQueue& queue = static_cast<const Scheduler*>(kernel_)->queue();
    known_.resize(queue.capacity());
    trace_->certificates = queue.capacity();
    for (CertificateId id = 0; id < known_.size(); ++id) {
      if (id == except) continue;
      Known& k = known_[id];
      const bool queued = queue.certificate(id).live && queue.queued(id);
      if (!queued) {
        if (k.queued) trace_->operations.push_back({Kind::kRemove, id, 0, 0});
        k.queued = false;
        continue;
      }
      const FailureTime time = queue.time(id);
      if (k.queued && time.lo == k.lo && time.hi == k.hi) continue;
      trace_->operations.push_back({k.queued ? Kind::kReset : Kind::kPush, id, time.lo, time.hi});
      k = {true, time.lo, time.hi};
    }
  }

  std::unique_ptr<Structure> inner_;
  Kernel* kernel_;
  QueueTrace* trace_;
  std::vector<Known> known_;
};

}  // namespace

QueueTrace record_queue(const Scene& scene, std::uint64_t events) {
  QueueTrace trace;
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = events;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  const Request& request = scene.maintain.front();
  const StructureId id = simulator.reserve();
  simulator.add(id,
                std::make_unique<Recorder>(make_structure(request, scene, simulator.kernel(), id),
                                           simulator.kernel(), trace),
                request.label);
  simulator.start();
  simulator.run_until(scene.end);
  return trace;
}

}  // namespace kinex::bench
