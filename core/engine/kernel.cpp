// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "core/engine/repeated_object.h"
#include "core/numbers/check.h"

namespace kinex {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The length of the first window in lifetimes. Each further one is kGrowth times as long, and the
// last one, of number kMostLooks, is unbounded.
constexpr double kLifetimes = 5;
constexpr double kGrowth = 4;
// Limits have this many bits below the length of a window: enough for most certificates to have
// different ones, few enough for differences to them to be exact.
constexpr int kWindowBits = 16;
// The least number of retractions for an estimate.
constexpr std::uint64_t kSample = 64;

Trajectory constant_trajectory(std::vector<Rational> coordinates) {
  Trajectory trajectory;
  for (Rational& c : coordinates) trajectory.coordinates.push_back({std::move(c)});
  return trajectory;
}

// True if two of the arguments are the same object, and it is not a constant (no motion could change
// that, so its certificates are never looked up).
bool repeats(const DerivedObjects& derived, const Query& query) {
  for (std::size_t i = 0; i < query.arity; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (query.ids[i] == query.ids[j] && !derived.is_constant(query.ids[i])) return true;
    }
  }
  return false;
}

}  // namespace

Kernel::Kernel(std::unique_ptr<Arithmetic> arithmetic, std::size_t objects, Scheduling scheduling)
    : arithmetic_(std::move(arithmetic)),
      sign_now_(dynamic_cast<SignNow*>(arithmetic_.get())),
      queue_(*arithmetic_),
      scheduling_(scheduling),
      objects_(objects),
      derived_(objects) {}

PredicateId Kernel::bind(std::shared_ptr<const Predicate> predicate) {
  return arithmetic_->bind(std::move(predicate));
}

// ---- derived objects

void Kernel::hold(const DerivedObjects::Object& object, ObjectId id) {
  const int most = arithmetic_->needs().axes, axes = object.trajectory.dimension();
  if (most > 0 && axes > most) {
    throw std::logic_error("the derived object " + object.name + " has " + std::to_string(axes) +
                           " axes, the numbers of this run are made for " + std::to_string(most) +
                           ": its structure has to declare what it derives");
  }
  arithmetic_->set_motion(id, object.trajectory, object.until);
}

void Kernel::renew_dependents(ObjectId object) {
  for (const ObjectId id : derived_.all_dependents(object)) hold(derived_.renew(id), id);
}

ObjectId Kernel::derive(std::string name, std::shared_ptr<const Construction> construction,
                        std::span<const ObjectId> bases) {
  const ObjectId id = derived_.add(std::move(name), std::move(construction), bases);
  hold(derived_.object(id), id);
  make_room(id);
  return id;
}

void Kernel::rederive(ObjectId derived, std::string name, std::span<const ObjectId> bases) {
  derived_.rebase(derived, std::move(name), bases);
  hold(derived_.object(derived), derived);
  renew_dependents(derived);
}

ObjectId Kernel::constant(std::string name, std::vector<Rational> coordinates) {
  return add_constant(std::move(name), std::move(coordinates), std::nullopt);
}

ObjectId Kernel::feature(std::string name, const PolygonFeature& feature) {
  return add_constant(std::move(name), {Rational()}, feature);
}

ObjectId Kernel::add_constant(std::string name, std::vector<Rational> coordinates,
                              const std::optional<PolygonFeature>& feature) {
  const ObjectId id =
      derived_.add(std::move(name), constant_trajectory(std::move(coordinates)), feature);
  hold(derived_.object(id), id);
  make_room(id);
  return id;
}

void Kernel::redefine(ObjectId constant, std::string name, std::vector<Rational> coordinates) {
  derived_.redefine(constant, std::move(name), constant_trajectory(std::move(coordinates)));
  hold(derived_.object(constant), constant);
  renew_dependents(constant);
}

void Kernel::make_room(ObjectId object) {
  if (object < objects_) return;
  objects_ = object + std::size_t{1};
  for (auto& live : live_per_object_) live.resize(objects_, 0u);
  if (indexed_) index_.resize(objects_);
}

// ---- certificates

// The former number of the certificate must have been released. A failure time that is not a number
// (inexact arithmetics) counts as never.
Outlook Kernel::schedule(CertificateId id, const Query& query) {
  poll();
  Certificate& c = queue_.certificate(id);
  c.looks = 0;
  FailureTime time;
  const double limit = limit_of(c.structure, 0);
  const Outlook outlook = limit < kInfinity ? arithmetic_->look_ahead(query, limit, time)
                                            : arithmetic_->failure(query, time);
  return enqueue(id, outlook, time);
}

Outlook Kernel::enqueue(CertificateId id, Outlook outlook, const FailureTime& time) {
  const bool fails = outlook == Outlook::kFails || outlook == Outlook::kFailsNow;
  if ((fails || outlook == Outlook::kLater) && time.lo <= time.hi) {
    StructureLedger& ledger = *ledgers_[queue_.certificate(id).structure];
    ++(fails ? ledger.failures_found : ledger.windows);
    queue_.certificate(id).outlook = outlook;  // the queue reads it
    queue_.reset(id, time);
    return outlook;
  }
  if (fails) outlook = Outlook::kNever;
  queue_.remove(id);
  queue_.certificate(id).outlook = outlook;
  return outlook;
}

// The end of the window that starts now, as a double of few bits: differences to it are exact.
double Kernel::limit_of(StructureId structure, int looks) const {
  const Window& window = windows_[structure];
  double length = window.length;
  if (!(length < kInfinity) || looks == kMostLooks) return kInfinity;
  for (int i = 0; i < looks; ++i) length *= kGrowth;
  const double now = arithmetic_->now_approximate();
  const double limit = (now + length + window.rounder) - window.rounder;
  return limit > now ? limit : kInfinity;
}

// The average lifetime of a certificate is the time in which as many are retracted as are alive.
void Kernel::update_window(StructureId structure) {
  if (scheduling_ == Scheduling::kEager) return;
  const StructureLedger& ledger = *ledgers_[structure];
  Window& window = windows_[structure];
  if (window.length < kInfinity && ledger.windows == 0) {
    // No limit was ever used (polynomials of degree 1): none from now on.
    window.length = kInfinity;
    window.next = std::numeric_limits<std::uint64_t>::max();
    return;
  }
  const double now = arithmetic_->now_approximate();
  const double elapsed = now - window.since;
  const double retracted = static_cast<double>(ledger.certificates_retracted - window.retracted);
  if (elapsed > 0 && retracted > 0) {
    window.length = kLifetimes * elapsed * static_cast<double>(ledger.live) / retracted;
    // The longest window ends before now + 2^13 lengths.
    const double reach = std::fabs(now) + 0x1p13 * window.length;
    if (window.length > 0x1p-900 && reach < 0x1p1000) {
      const int unit = std::ilogb(window.length) - kWindowBits;
      window.rounder = std::ldexp(1.5, 52 + std::max(unit, std::ilogb(reach) - 46));
    } else {
      window.length = kInfinity;
    }
  }
  window.since = now;
  window.retracted = ledger.certificates_retracted;
  window.next = ledger.certificates_retracted + std::max(kSample, ledger.live / 4);
}

// The index from objects to certificates has one entry for each object of a certificate.
void Kernel::refuse_repeated(StructureId structure, const Query& query) const {
  std::vector<std::string> objects;
  for (std::size_t i = 0; i < query.arity; ++i) objects.push_back(std::to_string(query.ids[i]));
  throw RepeatedObject(structure, query, std::to_string(structure),
                       arithmetic_->predicate(query.predicate).name(), objects);
}

Kernel::NewPart Kernel::add_part(StructureId structure, std::string name) {
  std::deque<PartLedger>& parts = ledgers_[structure]->parts;
  if (parts.size() >= std::numeric_limits<PartId>::max()) {
    throw std::invalid_argument("a structure of more than 255 parts");
  }
  parts.push_back({.name = std::move(name)});
  return {static_cast<PartId>(parts.size() - 1), parts.back()};
}

Kernel::Created Kernel::create(StructureId structure, const Query& query, std::uint32_t tag,
                               PartId part) {
  if (repeats_an_object(query) && repeats(derived_, query)) refuse_repeated(structure, query);
  const CertificateId id = queue_.allocate(structure, query, tag, part);
  count_created(structure, query);
  if (indexed_) index_add(id);
  return {id, schedule(id, query)};
}

void Kernel::retract(CertificateId id) {
  const Certificate& c = queue_.certificate(id);
  require(c.live, "a certificate was retracted twice");
  count_retracted(c);
  count_unused(id);
  if (indexed_) index_remove(id);
  if (id == failing_) failing_ = kNoCertificate;
  queue_.free(id);
}

inline void Kernel::check_replacement(CertificateId id, const Query& query) const {
  const Certificate& c = queue_.certificate(id);
  require(c.live, "a retracted certificate was replaced");
  if (repeats_an_object(query) && repeats(derived_, query)) refuse_repeated(c.structure, query);
}

// It has been counted already.
inline void Kernel::exchange(CertificateId id, const Query& query, std::uint32_t tag) {
  Certificate& c = queue_.certificate(id);
  count_unused(id);
  if (indexed_) index_remove(id);
  if (c.root != 0) {
    FailureTime old = queue_.time(id);
    arithmetic_->release(old);
    c.root = 0;
  }
  queue_.set_query(id, query);
  c.tag = tag;
  if (indexed_) index_add(id);
  if (id == failing_) failing_ = kNoCertificate;
}

Outlook Kernel::replace(CertificateId id, const Query& query, std::uint32_t tag) {
  check_replacement(id, query);
  count_replaced(queue_.certificate(id), query);
  exchange(id, query, tag);
  return schedule(id, query);
}

void Kernel::replace(Group& group) {
  const double limit = limit_of(queue_.certificate(group.ids[0]).structure, 0);
  const Arithmetic::Grouped grouped =
      arithmetic_->begin_group({group.queries.data(), group.size}, limit, answers_);
  const bool counted = count_together(group);
  for (std::size_t i = 0; i < group.size; ++i) {
    const CertificateId id = group.ids[i];
    const Query& query = group.queries[i];
    if (!counted) {
      check_replacement(id, query);
      count_replaced(queue_.certificate(id), query);
    }
    exchange(id, query, group.tags[i]);
    poll();
    queue_.certificate(id).looks = 0;
    Outlook& outlook = group.outlooks[i];
    FailureTime& time = answers_.times[i];
    switch (grouped) {
      case Arithmetic::Grouped::kAnswered:
        outlook = answers_.outlooks[i];
        break;
      case Arithmetic::Grouped::kPrepared:
        time = FailureTime();
        outlook = arithmetic_->look_ahead_in_group(i, query, limit, time);
        break;
      case Arithmetic::Grouped::kNot:
        time = FailureTime();
        outlook = limit < kInfinity ? arithmetic_->look_ahead(query, limit, time)
                                    : arithmetic_->failure(query, time);
        break;
    }
    outlook = enqueue(id, outlook, time);
  }
}

// ---- events

void Kernel::count_external(StructureId structure) {
  ++ledgers_[structure]->external;
  ++ledgers_[structure]->processed;
  if (handling_ && structure == failing_structure_) event_external_ = true;
}

void Kernel::report(StructureId structure, std::uint8_t kind, std::initializer_list<ObjectId> ids,
                    bool external, std::span<const ObjectId> gone, std::span<const ObjectId> came) {
  require(ids.size() <= kMaxArity, "an event names too many objects");
  const bool caused = handling_ && structure == failing_structure_;
  if (external) count_external(structure);
  event_.structure = structure;
  event_.kind = kind;
  event_.external = external;
  std::size_t i = 0;
  for (const ObjectId id : ids) event_.ids[i++] = id;
  for (; i < event_.count; ++i) event_.ids[i] = 0;  // of the event before
  event_.count = static_cast<std::uint8_t>(ids.size());
  if (caused) {
    event_.certificate = failing_query_;
  } else {
    event_.certificate = Query();
  }
  // They are empty, mostly and now.
  if (!gone.empty()) event_.gone = gone;
  if (!came.empty()) event_.came = came;
  if (reporter_ != nullptr) reporter_->reported(event_);
  event_.gone = event_.came = {};
}

void Kernel::report_settled(StructureId structure, std::span<const ObjectId> gone,
                            std::span<const ObjectId> came) {
  if (gone.empty() && came.empty()) return;
  count_external(structure);
  Event event;
  event.structure = structure;
  event.external = true;
  event.gone = gone;
  event.came = came;
  if (reporter_ != nullptr) reporter_->settled(event);
}

void Kernel::report_changed_within(StructureId structure) {
  if (reporter_ != nullptr) reporter_->changed_within(structure);
}

bool Kernel::instant_is_shared(StructureId structure) const { return shared_[structure] != 0; }

void Kernel::count_rebuild(StructureId structure, const std::string& reason,
                           std::span<const ObjectId> gone, std::span<const ObjectId> came) {
  StructureLedger& ledger = *ledgers_[structure];
  ++ledger.rebuilds;
  const auto counted = ledger.rebuild_reasons.try_emplace(reason).first;
  ++counted->second;
  Event event;
  event.structure = structure;
  event.reason = counted->first;
  event.gone = gone;
  event.came = came;
  event.external = event.has_difference();
  if (event.external) count_external(structure);
  if (reporter_ != nullptr) reporter_->rebuilt(event);
}

void Kernel::clear_structure(StructureId structure) {
  for (std::size_t i = 0; i < queue_.capacity(); ++i) {
    const CertificateId id = static_cast<CertificateId>(i);
    const Certificate& c = queue_.certificate(id);
    if (c.live && c.structure == structure) retract(id);
  }
}

void Kernel::corrupt(StructureId structure, const std::string& what) {
  if (arithmetic_->is_exact()) {
    throw std::logic_error("impossible in an exact arithmetic: " + what);
  }
  StructureLedger& ledger = *ledgers_[structure];
  if (!ledger.corrupt) {
    std::array<char, 40> t{};
    std::snprintf(t.data(), t.size(), " (at t = %.10g)", arithmetic_->now_approximate());
    ledger.corruption = what + t.data();
  }
  ledger.corrupt = true;
  clear_structure(structure);
}

// ---- the index from objects to certificates

// For all certificates, and for queries of so many arguments.
void Kernel::make_room_in_index(std::size_t arity) {
  if (arity > index_arity_) {
    std::vector<std::uint32_t> wider(queue_.capacity() * arity);
    if (index_arity_ > 0) {
      for (std::size_t i = 0; i < index_places_.size(); ++i) {
        wider[i / index_arity_ * arity + i % index_arity_] = index_places_[i];
      }
    }
    index_places_ = std::move(wider);
    index_arity_ = arity;
  }
  index_places_.resize(queue_.capacity() * index_arity_);
}

void Kernel::index_add(CertificateId id) {
  const Query query = queue_.query(id);
  if (query.arity > index_arity_ || index_places_.size() <= id * index_arity_) {
    make_room_in_index(query.arity);
  }
  for (std::size_t i = 0; i < query.arity; ++i) {
    if (derived_.is_constant(query.ids[i])) continue;
    std::vector<CertificateId>& list = index_[query.ids[i]];
    place_in_index(id, i) = static_cast<std::uint32_t>(list.size());
    list.push_back(id);
  }
}

void Kernel::index_remove(CertificateId id) {
  const Query query = queue_.query(id);
  for (std::size_t i = 0; i < query.arity; ++i) {
    const ObjectId object = query.ids[i];
    if (derived_.is_constant(object)) continue;
    std::vector<CertificateId>& list = index_[object];
    const std::uint32_t place = place_in_index(id, i);
    const CertificateId last = list.back();
    list[place] = last;
    list.pop_back();
    const Query moved = queue_.query(last);
    for (std::size_t j = 0; j < moved.arity; ++j) {
      if (moved.ids[j] == object) place_in_index(last, j) = place;
    }
  }
}

std::span<const CertificateId> Kernel::certificates_of(ObjectId object) {
  if (!indexed_) {
    indexed_ = true;
    index_.resize(objects_);
    for (std::size_t i = 0; i < queue_.capacity(); ++i) {
      if (queue_.certificate(static_cast<CertificateId>(i)).live) {
        index_add(static_cast<CertificateId>(i));
      }
    }
  }
  return index_[object];
}

}  // namespace kinex
