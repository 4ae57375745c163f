// SPDX-License-Identifier: GPL-3.0-or-later
// EventQueue: the live certificates, and a priority queue of those that fail, by failure time.
#ifndef KINEX_CORE_ENGINE_EVENT_QUEUE_H
#define KINEX_CORE_ENGINE_EVENT_QUEUE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/engine/certificate.h"
#include "core/numbers/big_array.h"

namespace kinex {

// A query as stored in a certificate: the first bytes of a Query. With more than kIds arguments,
// ids[0] is a row of a side table (EventQueue::query).
struct StoredQuery {
  static constexpr std::size_t kIds = 5;
  PredicateId predicate = 0;
  std::uint8_t arity = 0;
  std::array<ObjectId, kIds> ids{};
  bool is_long() const { return arity > kIds; }
};

// One cache line each: a retraction or a replacement touches one line.
struct alignas(64) Certificate {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint32_t kNotQueued = 0xffffffffu;
  static constexpr std::uint32_t kFar = 0xfffffffeu;

  double lo = 0, hi = 0;  // owned by the queue: the key, while it waits in a list
  StoredQuery stored;
  StructureId structure = 0;
  Outlook outlook = Outlook::kNever;
  bool live : 1 = false;
  std::uint8_t looks : 7 = 0;  // how often a kLater was extended
  PartId part = 0;
  std::uint32_t tag = 0;
  std::uint32_t root = 0;  // FailureTime::root
  // Owned by the queue: neighbours in a list; place in the heap, kFar (in a list) or kNotQueued.
  std::uint32_t next = kNone, previous = kNone;
  std::uint32_t where = kNotQueued;
};
static_assert(sizeof(Certificate) == 64);

// Keys are enclosures of failure times; the arithmetic compares only those that overlap. Equal
// instants are ordered by value: (structure, predicate, sorted ids). A certificate whose outlook is
// kLater is queued at the (double) time up to which it is proved not to fail; failures at exactly
// that instant come first.
//
// Two levels: a 4-ary heap of near failures, and behind it unsorted buckets of equal width in time,
// by the lower ends of the keys. Failures after the last bucket wait in one list.
//
//   now                  edge_                                              time
//    |<--------- heap ---->|                                                 -->
//    | bucket 0 .. poured_ | poured_ + 1 | poured_ + 2 | ..  | last list: all later
//          poured            unsorted lists
//
//   pour   when the heap's first key reaches beyond edge_, the next bucket goes into the heap
//   cut    when no bucket is left, the last list is cut into buckets anew
//   spill  when the heap has become large, everything is cut anew
//
// Most certificates are retracted before their bucket is poured, in O(1). Insertion and retraction
// take O(log n) comparisons at most (all times in one bucket: a heap), and O(1) where times are
// spread.
class EventQueue {
 public:
  explicit EventQueue(Arithmetic& arithmetic) : arithmetic_(&arithmetic), spill_at_(kSmall) {}

  CertificateId allocate(StructureId structure, const Query& query, std::uint32_t tag,
                         PartId part = 0);
  // The certificate leaves the heap, its number is released, and its id may be used again.
  void free(CertificateId id);
  Certificate& certificate(CertificateId id) { return certificates_[id]; }
  const Certificate& certificate(CertificateId id) const { return certificates_[id]; }
  // The claim of a live certificate.
  Query query(CertificateId id) const { return query(certificates_[id]); }
  Query query(const Certificate& c) const {
    if (c.stored.is_long()) [[unlikely]] return long_query(c.stored);
    static_assert(offsetof(Query, arity) == offsetof(StoredQuery, arity) &&
                  offsetof(Query, ids) == offsetof(StoredQuery, ids));
    static_assert(sizeof(StoredQuery) == 24);
    Query::Piece first;
    std::uint64_t rest;
    std::memcpy(&first, &c.stored, sizeof(first));
    std::memcpy(&rest, reinterpret_cast<const std::byte*>(&c.stored) + sizeof(first), sizeof(rest));
    return Query::from_pieces(first, Query::Piece{rest, 0});
  }
  // query(id) == query, without making a query.
  bool claims(CertificateId id, const Query& query) const {
    const StoredQuery& stored = certificates_[id].stored;
    if (stored.is_long()) [[unlikely]] return long_query(stored) == query;
    std::uint32_t differ = static_cast<std::uint32_t>(stored.predicate ^ query.predicate) |
                           static_cast<std::uint32_t>(stored.arity ^ query.arity);
    for (std::size_t i = 0; i < StoredQuery::kIds; ++i) differ |= stored.ids[i] ^ query.ids[i];
    return differ == 0;
  }
  // Gives a live certificate another claim.
  void set_query(CertificateId id, const Query& query) {
    StoredQuery& stored = certificates_[id].stored;
    if (std::max(stored.arity, query.arity) > StoredQuery::kIds) [[unlikely]] {
      return set_long_query(stored, query);
    }
    std::memcpy(static_cast<void*>(&stored), &query, sizeof(StoredQuery));
  }
  // One past the largest id ever used; ids in between may be free (live == false).
  std::size_t capacity() const { return certificates_.size(); }
  std::size_t live() const { return live_; }

  // Queues a certificate that is not in the heap; its `root` passes from `time`.
  void push(CertificateId id, const FailureTime& time);
  // Takes a certificate out of the queue, if it is there (it stays live). Its number is released.
  void remove(CertificateId id);
  // The certificate fails at another time: push, or an update in place that needs fewer comparisons
  // than remove and push. The former number must have been released.
  void reset(CertificateId id, const FailureTime& time);
  void prefetch(CertificateId id) const {
    if (id != kNoCertificate) __builtin_prefetch(certificates_.data() + id, 1);
  }
  // The same for its neighbours in the queue. The certificate itself is read.
  void prefetch_neighbours(CertificateId id) const {
    if (id == kNoCertificate || certificates_[id].where != kFar) return;
    prefetch(certificates_[id].next);
    prefetch(certificates_[id].previous);
  }
  bool queued(CertificateId id) const { return certificates_[id].where != kNotQueued; }
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size() + far_; }
  CertificateId top() const { return heap_.front().certificate; }
  // Certificates that probably fail soon, for prefetching: the first one (i = 0), then some in no
  // order; kNoCertificate if there are fewer.
  CertificateId upcoming(std::size_t i) const {
    return i < heap_.size() ? heap_[i].certificate : kNoCertificate;
  }
  // True if the first entry is not a failure but the end of what is proved of a certificate
  // (Outlook::kLater). Requires !empty().
  bool top_is_later() const { return is_later(heap_.front()); }
  // The enclosure of the first failure time; requires !empty().
  double top_lo() const { return heap_.front().lo; }
  double top_hi() const { return heap_.front().hi; }
  // The failure time of a queued certificate; return it with set_time after a refinement.
  FailureTime time(CertificateId id) const;
  void set_time(CertificateId id, const FailureTime& time);
  // Takes the first certificate out of the heap and hands over its number.
  FailureTime pop();
  // Appends the queued certificates whose instant equals that of the first one (itself included).
  // O(k) comparisons for k of them.
  void collect_first_instant(std::vector<CertificateId>& out);
  // True if at least two queued certificates share the first one's instant. O(1) comparisons.
  // Requires !empty().
  bool first_instant_is_shared();

  std::size_t bytes() const;
  std::size_t max_size() const { return max_size_; }

 private:
  struct Entry {
    double lo, hi;
    CertificateId certificate;
  };
  static constexpr std::size_t kArity = 4;
  static constexpr std::size_t kSmall = 128;  // no buckets for fewer entries
  static constexpr std::uint32_t kNone = Certificate::kNone;
  static constexpr std::uint32_t kNotQueued = Certificate::kNotQueued;
  static constexpr std::uint32_t kFar = Certificate::kFar;

  bool less(Entry& a, Entry& b) {
    if (a.hi < b.lo) return true;
    if (b.hi < a.lo) return false;
    return less_slow(a, b);
  }
  bool is_later(const Entry& e) const {
    return certificates_[e.certificate].outlook == Outlook::kLater;
  }
  bool less_slow(Entry& a, Entry& b);
  int compare_times(Entry& a, Entry& b);
  int compare_to_limit(Entry& e, double limit);
  bool ties_before(CertificateId a, CertificateId b) const;
  std::size_t least_child(std::size_t first, std::size_t end);
  void sift_up(std::size_t i, Entry e);
  void sift_down(std::size_t i, Entry e);
  // Fills the hole at i with e, which may belong above or below.
  void settle(std::size_t i, Entry e);
  void place(std::size_t i, const Entry& e) {
    heap_[i] = e;
    certificates_[e.certificate].where = static_cast<std::uint32_t>(i);
  }
  void take_out(std::size_t i);
  Query long_query(const StoredQuery& stored) const;
  void set_long_query(StoredQuery& stored, const Query& query);

  // ---- below
  std::uint32_t bucket_of(double lo) const;
  void add(const Entry& e);
  void link(const Entry& e, std::uint32_t bucket);
  void unlink(CertificateId id);
  void reset_near(CertificateId id, const FailureTime& time);
  // ---- event_queue_buckets.cpp
  void add_near(const Entry& e);
  // Pours buckets into the heap until its first entry is the first of all.
  void prepare() {
    if (far_ != 0 && (heap_.empty() || !(heap_.front().hi <= edge_))) pour();
  }
  void pour();
  void pour_bucket(std::uint32_t bucket);
  void prefetch_lists(std::uint32_t bucket) const;
  template <class Visit>
  void each_in_list(std::uint32_t first, std::size_t size, const Visit& visit);
  void distribute(std::span<const std::uint32_t> ids);
  void cut();
  void spill();
  void find_edge();

  Arithmetic* arithmetic_;
  BigArray<Certificate> certificates_;
  std::vector<CertificateId> free_;
  // The arguments of certificates with more than StoredQuery::kIds of them, and rows not in use.
  std::vector<std::array<ObjectId, kMaxArity>> long_ids_;
  std::vector<std::uint32_t> free_long_ids_;
  BigArray<Entry> heap_;
  // Buckets 0 .. poured_ are in the heap; all other entries have buckets beyond, and lo > edge_.
  BigArray<std::uint32_t> buckets_;  // heads of lists; the last one takes everything later
  std::uint32_t poured_ = 0;
  double base_ = 0, per_time_ = 0;  // bucket = (lo - base) * per_time
  double edge_ = std::numeric_limits<double>::infinity();
  std::size_t far_ = 0;   // entries in lists
  std::size_t spill_at_;  // size of the heap from which it is cut anew
  std::size_t live_ = 0;
  std::size_t max_size_ = 0;
};

// ---- the lists, inlined

// Monotone in lo, and always computed in the same way: the order of buckets is an order of times.
inline std::uint32_t EventQueue::bucket_of(double lo) const {
  if (lo <= edge_) return poured_;
  const double x = (lo - base_) * per_time_;
  const double last = static_cast<double>(buckets_.size() - 1);
  return x < last ? std::max(poured_, static_cast<std::uint32_t>(x))
                  : static_cast<std::uint32_t>(buckets_.size() - 1);
}

inline void EventQueue::link(const Entry& e, std::uint32_t bucket) {
  Certificate& p = certificates_[e.certificate];
  std::uint32_t& head = buckets_[bucket];
  p.lo = e.lo;
  p.hi = e.hi;
  p.next = head;
  p.previous = kNone;
  p.where = kFar;
  if (head != kNone) certificates_[head].previous = e.certificate;
  head = e.certificate;
  ++far_;
}

inline void EventQueue::unlink(CertificateId id) {
  Certificate& p = certificates_[id];
  if (p.next != kNone) certificates_[p.next].previous = p.previous;
  (p.previous != kNone ? certificates_[p.previous].next : buckets_[bucket_of(p.lo)]) = p.next;
  p.where = kNotQueued;
  --far_;
}

inline void EventQueue::add(const Entry& e) {
  const std::uint32_t bucket = bucket_of(e.lo);
  if (bucket > poured_) return link(e, bucket);
  add_near(e);
}

inline void EventQueue::reset(CertificateId id, const FailureTime& time) {
  if (certificates_[id].where != kFar) return reset_near(id, time);
  certificates_[id].root = time.root;
  unlink(id);
  add(Entry{time.lo, time.hi, id});
  prepare();
}

}  // namespace kinex

#endif
