// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/event_queue.h"

#include <algorithm>

#include "core/arithmetic/query_relation.h"
#include "core/numbers/check.h"
#include "core/numbers/exactly.h"

namespace kinex {

CertificateId EventQueue::allocate(StructureId structure, const Query& query, std::uint32_t tag,
                                   PartId part) {
  CertificateId id;
  if (free_.empty()) {
    require(certificates_.size() < kNoCertificate, "more certificates than ids");
    id = static_cast<CertificateId>(certificates_.size());
    if (certificates_.size() == certificates_.capacity()) {
      // By a quarter, not by doubling: memory per certificate is measured.
      const std::size_t room = certificates_.size() + certificates_.size() / 4 + 16;
      certificates_.reserve(room);
    }
    certificates_.emplace_back();
  } else {
    id = free_.back();
    free_.pop_back();
  }
  Certificate& c = certificates_[id];
  c = Certificate{};
  set_query(id, query);
  c.structure = structure;
  c.live = true;
  c.part = part;
  c.tag = tag;
  ++live_;
  return id;
}

void EventQueue::free(CertificateId id) {
  remove(id);
  if (certificates_[id].stored.is_long()) set_long_query(certificates_[id].stored, Query());
  certificates_[id].live = false;
  free_.push_back(id);
  --live_;
}

Query EventQueue::long_query(const StoredQuery& stored) const {
  Query query;
  query.predicate = stored.predicate;
  query.arity = stored.arity;
  query.ids = long_ids_[stored.ids[0]];
  return query;
}

// Takes a row for a query that needs one, gives it back for one that does not.
void EventQueue::set_long_query(StoredQuery& stored, const Query& query) {
  const bool was_long = stored.is_long(), is_long = query.arity > StoredQuery::kIds;
  std::uint32_t row = stored.ids[0];
  if (was_long && !is_long) free_long_ids_.push_back(row);
  if (is_long && !was_long) {
    if (free_long_ids_.empty()) {
      row = static_cast<std::uint32_t>(long_ids_.size());
      long_ids_.emplace_back();
    } else {
      row = free_long_ids_.back();
      free_long_ids_.pop_back();
    }
  }
  stored = StoredQuery{query.predicate, query.arity, {}};
  if (is_long) {
    long_ids_[row] = query.ids;
    stored.ids[0] = row;
  } else {
    std::copy_n(query.ids.begin(), StoredQuery::kIds, stored.ids.begin());
  }
}

void EventQueue::push(CertificateId id, const FailureTime& time) {
  certificates_[id].root = time.root;
  add(Entry{time.lo, time.hi, id});
  max_size_ = std::max(max_size_, size());
  prepare();
}

void EventQueue::reset_near(CertificateId id, const FailureTime& time) {
  const std::uint32_t where = certificates_[id].where;
  if (where == kNotQueued) return push(id, time);
  certificates_[id].root = time.root;
  const Entry e{time.lo, time.hi, id};
  if (bucket_of(e.lo) <= poured_) {
    settle(where, e);
  } else {
    take_out(where);
    add(e);
  }
  prepare();
}

void EventQueue::remove(CertificateId id) {
  const std::uint32_t where = certificates_[id].where;
  if (where == kNotQueued) return;
  if (certificates_[id].root != 0) {
    FailureTime t = time(id);
    arithmetic_->release(t);
    certificates_[id].root = 0;
  }
  if (where == kFar) return unlink(id);
  take_out(where);
  prepare();
}

FailureTime EventQueue::time(CertificateId id) const {
  const Certificate& p = certificates_[id];
  if (p.where == kFar) return {p.lo, p.hi, certificates_[id].root};
  const Entry& e = heap_[p.where];
  return {e.lo, e.hi, certificates_[id].root};
}

// In a list the lower end is kept: it determines the bucket.
void EventQueue::set_time(CertificateId id, const FailureTime& time) {
  Certificate& c = certificates_[id];
  c.root = time.root;
  if (c.where == kFar) {
    c.hi = time.hi;
  } else {
    heap_[c.where].lo = time.lo;
    heap_[c.where].hi = time.hi;
  }
}

// The hole sinks to a leaf; the last entry, which nearly always belongs far down, then fills it.
FailureTime EventQueue::pop() {
  const Entry& top = heap_.front();
  Certificate& c = certificates_[top.certificate];
  const FailureTime result{top.lo, top.hi, c.root};
  c.root = 0;
  certificates_[top.certificate].where = kNotQueued;
  const Entry last = heap_.back();
  heap_.pop_back();
  if (heap_.empty()) {
    prepare();
    return result;
  }
  std::size_t hole = 0;
  for (std::size_t first = 1; first < heap_.size(); first = kArity * hole + 1) {
    const std::size_t least = least_child(first, std::min(first + kArity, heap_.size()));
    place(hole, heap_[least]);
    hole = least;
  }
  sift_up(hole, last);
  prepare();
  return result;
}

void EventQueue::take_out(std::size_t i) {
  certificates_[heap_[i].certificate].where = kNotQueued;
  const Entry last = heap_.back();
  heap_.pop_back();
  if (i < heap_.size()) settle(i, last);
}

// The least of heap_[first .. end). Among four, without branches if the least enclosure is disjoint
// from the others, as it nearly always is.
std::size_t EventQueue::least_child(std::size_t first, std::size_t end) {
  std::size_t least = first;
  if (end - first == kArity) {
    const Entry* e = &heap_[first];
    const std::size_t left = e[1].lo < e[0].lo ? 1u : 0u;
    const std::size_t right = 2u + (e[3].lo < e[2].lo ? 1u : 0u);
    const std::size_t i = left + (right - left) * (e[right].lo < e[left].lo ? 1u : 0u);
    const double hi = e[i].hi;
    const int reached = (e[0].lo <= hi ? 1 : 0) + (e[1].lo <= hi ? 1 : 0) +
                        (e[2].lo <= hi ? 1 : 0) + (e[3].lo <= hi ? 1 : 0);
    if (reached == 1) return first + i;
  }
  for (std::size_t c = first + 1; c < end; ++c) {
    if (less(heap_[c], heap_[least])) least = c;
  }
  return least;
}

// A known failure time against the limit of a kLater: never 0.
int EventQueue::compare_to_limit(Entry& e, double limit) {
  Certificate& c = certificates_[e.certificate];
  FailureTime t{e.lo, e.hi, c.root};
  const int order = arithmetic_->compare(query(c), t, exactly(limit));
  e.lo = t.lo;
  e.hi = t.hi;
  c.root = t.root;
  return order > 0 ? 1 : -1;
}

int EventQueue::compare_times(Entry& a, Entry& b) {
  if (a.hi < b.lo) return -1;
  if (b.hi < a.lo) return 1;
  Certificate& ca = certificates_[a.certificate];
  Certificate& cb = certificates_[b.certificate];
  const bool later_a = ca.outlook == Outlook::kLater, later_b = cb.outlook == Outlook::kLater;
  if (later_a && later_b) return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : 0;
  if (later_a) return -compare_to_limit(b, a.lo);
  if (later_b) return compare_to_limit(a, b.lo);
  const Query qa = query(ca), qb = query(cb);
  // Both hold until they fail for the first time, so one polynomial has one failure; but after a touch one
  // of them may have been certified anew, to its next root, while the other one waits for its turn. A
  // failure without a form of its own is no touch.
  const Predicate& predicate = arithmetic_->predicate(qa.predicate);
  if (qa.predicate == qb.predicate && query_relation(qa, qb, predicate.alternating()) > 0 &&
      ((ca.root == 0 && cb.root == 0) || !arithmetic_->fails_at_touch(qa.predicate))) {
    return 0;
  }
  FailureTime ta{a.lo, a.hi, ca.root};
  FailureTime tb{b.lo, b.hi, cb.root};
  const int order = arithmetic_->compare(qa, ta, qb, tb);
  a.lo = ta.lo;
  a.hi = ta.hi;
  ca.root = ta.root;
  b.lo = tb.lo;
  b.hi = tb.hi;
  cb.root = tb.root;
  return order;
}

bool EventQueue::less_slow(Entry& a, Entry& b) {
  const int order = compare_times(a, b);
  return order < 0 || (order == 0 && ties_before(a.certificate, b.certificate));
}

// By structure, predicate, sorted ids, ids in order of the arguments, certificate.
bool EventQueue::ties_before(CertificateId a, CertificateId b) const {
  const Certificate& ca = certificates_[a];
  const Certificate& cb = certificates_[b];
  if (ca.outlook == Outlook::kLater)
    return a < b;  // not events: any deterministic order
  if (ca.structure != cb.structure) return ca.structure < cb.structure;
  const Query qa = query(ca), qb = query(cb);
  if (qa.predicate != qb.predicate) return qa.predicate < qb.predicate;
  const auto sa = sorted_ids(qa), sb = sorted_ids(qb);
  if (sa != sb) return sa < sb;
  if (qa.ids != qb.ids) return qa.ids < qb.ids;
  return a < b;
}

void EventQueue::sift_up(std::size_t i, Entry e) {
  while (i > 0) {
    const std::size_t parent = (i - 1) / kArity;
    if (!less(e, heap_[parent])) break;
    place(i, heap_[parent]);
    i = parent;
  }
  place(i, e);
}

void EventQueue::sift_down(std::size_t i, Entry e) {
  const std::size_t size = heap_.size();
  for (;;) {
    const std::size_t first = kArity * i + 1;
    if (first >= size) break;
    const std::size_t least = least_child(first, std::min(first + kArity, size));
    if (!less(heap_[least], e)) break;
    place(i, heap_[least]);
    i = least;
  }
  place(i, e);
}

void EventQueue::settle(std::size_t i, Entry e) {
  if (i > 0 && less(e, heap_[(i - 1) / kArity])) return sift_up(i, e);
  sift_down(i, e);
}

bool EventQueue::first_instant_is_shared() {
  const std::size_t end = std::min(heap_.size(), kArity + 1);
  if (end == kArity + 1) {
    const double hi = heap_[0].hi;
    if (std::min(std::min(heap_[1].lo, heap_[2].lo), std::min(heap_[3].lo, heap_[4].lo)) > hi) {
      return false;
    }
  }
  for (std::size_t c = 1; c < end; ++c) {
    if (compare_times(heap_[0], heap_[c]) == 0) return true;
  }
  return false;
}

void EventQueue::collect_first_instant(std::vector<CertificateId>& out) {
  if (heap_.empty()) return;
  // Equal instants form a connected part of the heap, at its top.
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    out.push_back(heap_[i].certificate);
    const std::size_t end = std::min(kArity * i + kArity + 1, heap_.size());
    for (std::size_t c = kArity * i + 1; c < end; ++c) {
      if (compare_times(heap_[0], heap_[c]) == 0) open.push_back(c);
    }
  }
}

std::size_t EventQueue::bytes() const {
  return certificates_.capacity() * sizeof(Certificate) + heap_.capacity() * sizeof(Entry) +
         buckets_.capacity() * sizeof(std::uint32_t) + free_.capacity() * sizeof(CertificateId) +
         long_ids_.capacity() * sizeof(long_ids_[0]) +
         free_long_ids_.capacity() * sizeof(std::uint32_t);
}

}  // namespace kinex
