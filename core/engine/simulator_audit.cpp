// SPDX-License-Identifier: GPL-3.0-or-later
// Audits: all certificates right after now, and independent recomputation at a rational time.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/engine/simulator.h"
#include "core/numbers/check.h"
#include "core/numbers/real_root.h"
#include "core/numbers/time_text.h"

namespace kinex {
namespace {

// Without a known next instant, the time 2^-k after the end for these k.
constexpr std::array<unsigned long, 14> kSteps{0,  1,   2,   4,   8,    16,   32,
                                               64, 128, 256, 512, 1024, 2048, 4096};
constexpr std::size_t kInexactSteps = 8;

// A radius or half an extent that is negative: right after the scene's end it may become so.
bool has_negative_extent(const Scene& scene, const Snapshot& positions) {
  if (scene.extents != Extents::kRadius && scene.extents != Extents::kHalfExtents) return false;
  for (ObjectId object = 0; object < positions.objects(); ++object) {
    if (!positions.alive(object)) continue;
    for (int axis = scene.dimension; axis < scene.axes(); ++axis) {
      if (positions.position(object, axis).sign() < 0) return true;
    }
  }
  return false;
}

}  // namespace

Snapshot Simulator::snapshot(const Rational& t) const {
  const bool weights = kernel_.arithmetic().needs().weights;
  const int axes = std::max(scene_.axes(), scene_.dimension + (weights ? 1 : 0));
  Snapshot result(t, scene_.dimension, axes, alive_.size());
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    if (!alive_[object]) continue;
    deadline_->poll();
    const Trajectory& motion = kernel_.derived().trajectory(object);
    for (int axis = 0; axis < axes; ++axis) {
      result.set(object, axis, axis < motion.dimension() ? motion.position(axis, t) : Rational());
    }
  }
  return result;
}

void Simulator::violation(StructureId id, const std::string& what) {
  ++kernel_.ledger(id).audit_violations;
  if (violations_.size() < kMaxMessages) violations_.push_back(entries_[id].label + ": " + what);
}

void Simulator::audit_certificates() {
  const EventQueue& queue = kernel_.queue();
  for (std::size_t i = 0; i < queue.capacity(); ++i) {
    const Certificate& c = queue.certificate(static_cast<CertificateId>(i));
    if (!c.live) continue;
    kernel_.poll();
    ++kernel_.ledger(c.structure).audit_checks;
    const Query query = queue.query(c);
    if (kernel_.arithmetic().sign_after(query) != Sign::kNegative) continue;
    std::string what = "negative right after now: " +
                       std::string(kernel_.arithmetic().predicate(query.predicate).name());
    for (std::size_t k = 0; k < query.arity; ++k) {
      what += (k == 0 ? "(" : ", ") + object_name(query.ids[k]);
    }
    violation(c.structure, what + ")");
  }
}

// True if every certificate is positive at these positions (zero if it is identically zero), and no extent
// negative: the attributes are then unambiguous.
bool Simulator::certificates_hold(const Snapshot& positions) const {
  if (has_negative_extent(scene_, positions)) return false;
  const EventQueue& queue = kernel_.queue();
  const Rational unit(1);
  std::array<MotionView<Rational>, kMaxViews> points;
  std::map<ObjectId, std::vector<Rational>> derived;
  const auto position = [&](ObjectId id) -> MotionView<Rational> {
    if (!kernel_.derived().is_derived(id)) return &positions.position(id, 0);
    const auto [place, is_new] = derived.try_emplace(id);
    if (is_new) {
      const Trajectory& trajectory = kernel_.derived().trajectory(id);
      for (int axis = 0; axis < trajectory.dimension(); ++axis) {
        place->second.push_back(trajectory.position(axis, positions.time()));
      }
      const int most = std::max(kernel_.arithmetic().needs().axes, trajectory.dimension());
      place->second.resize(static_cast<std::size_t>(most));
    }
    return place->second.data();
  };
  for (std::size_t i = 0; i < queue.capacity(); ++i) {
    const Certificate& c = queue.certificate(static_cast<CertificateId>(i));
    if (!c.live || c.outlook == Outlook::kIdenticallyZero) continue;
    deadline_->poll();
    const Query query = queue.query(c);
    for (std::size_t k = 0; k < query.arity; ++k) points[k] = position(query.ids[k]);
    points[query.arity] = &unit;
    const Predicate& predicate = kernel_.arithmetic().predicate(query.predicate);
    if (predicate.rational(0, points.data()).front().sign() <= 0) return false;
  }
  return std::all_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    if (entry.members.empty()) return entry.structure->holds_at(positions);
    return entry.structure->holds_at(positions.of(entry.members));
  });
}

// A rational strictly between now and the next failure, change or end. nullopt if none is found (in
// an exact arithmetic only just before a change).
std::optional<Rational> Simulator::rational_after_now() {
  Arithmetic& arithmetic = kernel_.arithmetic();
  EventQueue& queue = kernel_.queue();
  std::optional<Rational> result;
  while (!queue.empty() && queue.top_is_later()) kernel_.look_further();
  if (queue.empty()) {
    result = arithmetic.rational_between(nullptr, nullptr);
  } else {
    FailureTime time = queue.time(queue.top());
    const Query first = kernel_.query(queue.top());
    result = arithmetic.rational_between(&first, &time);
    queue.set_time(queue.top(), time);
  }
  if (!result) return result;
  const Rational* limit = next_change();
  if (scene_.end && (limit == nullptr || *scene_.end < *limit)) limit = &*scene_.end;
  if (limit == nullptr || *result < *limit) return result;
  std::optional<Rational> now = reached_;
  if (at_failure_instant_) {
    now = Rational::from_double(now_hi_);
    if (now && !(*now < *limit)) {
      if (!arithmetic.is_exact()) return std::nullopt;  // it has no name
      RealRoot instant = to_root(arithmetic.name_now(InstantDetail::kName));
      RootCounters counters;
      if (compare(instant, *limit, counters) >= 0) return std::nullopt;
      while (!(instant.upper() < *limit)) instant.refine(counters);
      now = instant.upper();
    }
  }
  if (!now || !(*now < *limit)) return std::nullopt;
  return (*now + *limit) / Rational(2);
}

// The same; in an inexact arithmetic now itself if no such rational is found.
std::optional<Rational> Simulator::time_between() {
  std::optional<Rational> t = rational_after_now();
  if (!t && !kernel_.is_exact()) t = Rational::from_double(kernel_.arithmetic().now_approximate());
  return t;
}

// A rational time right after now at which every certificate is strict; nullopt if none of a few
// candidates is one.
std::optional<Rational> Simulator::audit_time() {
  if (!at_failure_instant_ && scene_.end && *scene_.end <= reached_) {
    // Failures after the end are not scheduled: a time before the first of them is searched for.
    std::optional<Rational> t;
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      if (!kernel_.is_exact() && i == kInexactSteps) break;
      t = reached_ + Rational(Integer(1), Integer::power_of_two(kSteps[i]));
      if (certificates_hold(snapshot(*t))) break;
    }
    return t;
  }
  const std::optional<Rational> first = rational_after_now();
  if (!first || certificates_hold(snapshot(*first))) return first;
  const std::optional<Rational> now =
      at_failure_instant_ ? Rational::from_double(now_hi_) : std::optional<Rational>(reached_);
  if (now && *now < *first) {
    for (const int part : {3, 5, 7, 11}) {
      const Rational t = *now + (*first - *now) / Rational(part);
      if (certificates_hold(snapshot(t))) return t;
    }
  }
  return first;
}

// What was reported since the last audit against what became of the attribute. Objects that come and
// go, and rebuilds, change it in their own ways; and there are external events that change nothing (two
// bodies that graze). An inexact arithmetic may change its mind between two instants.
void Simulator::audit_reports(StructureId id, AuditReport& report) {
  if (!kernel_.is_exact() || options_.audit != AuditLevel::kEvents) return;
  Entry& entry = entries_[id];
  const StructureLedger& ledger = kernel_.ledger(id);
  const std::uint64_t anew = ledger.insertions + ledger.erasures + ledger.rebuilds;
  Attribute now = entry.structure->attribute();
  const bool told = ledger.external != entry.external_then || anew != entry.anew_then;
  if (entry.audited && !told && now != *entry.audited) {
    report.check(false, [] { return "the attribute changed, and no external event was reported"; });
  }
  entry.audited = std::move(now);
  entry.external_then = ledger.external;
  entry.anew_then = anew;
}

bool Simulator::run_audit(bool certificates) {
  end_charge();
  const RunClock::Scope audit(clock_, RunPhase::kAudit);
  const auto count = [this] {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      sum += kernel_.ledger(static_cast<StructureId>(i)).audit_violations;
    }
    return sum;
  };
  const std::uint64_t before = count();
  if (certificates) audit_certificates();
  const std::optional<Rational> t = audit_time();
  std::optional<Snapshot> positions;
  if (t) positions = snapshot(*t);
  std::string when;
  if (t) when = " (t = " + time_text(*t) + ")";
  if (t && scene_.end && *scene_.end < *t) {
    when = " (right after the scene's end, which is t = " + time_text(*scene_.end) + ")";
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    AuditReport report;
    deadline_->look();
    if (kernel_.ledger(id).corrupt) {
      report.check(false, [&] { return "corrupt: " + kernel_.ledger(id).corruption; });
    } else {
      entries_[i].structure->check_invariants(report);
      const std::vector<bool>& members = entries_[i].members;
      if (positions && members.empty()) entries_[i].structure->audit(*positions, report);
      if (positions && !members.empty()) {
        entries_[i].structure->audit(positions->of(members), report);
      }
      audit_reports(id, report);
    }
    kernel_.ledger(id).audit_checks += report.checks;
    for (const std::string& what : report.violations) violation(id, what + when);
  }
  return count() == before;
}

bool Simulator::audit() {
  require(started_, "a run has to be started");
  return run_audit(true);
}

}  // namespace kinex
