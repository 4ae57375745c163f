// SPDX-License-Identifier: GPL-3.0-or-later
// EventQueue: live certificates, and a heap of those that fail, ordered by exact failure time.
#ifndef KINEX_CORE_EVENT_QUEUE_H
#define KINEX_CORE_EVENT_QUEUE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/arithmetic.h"
#include "core/certificate.h"

namespace kinex {

struct Certificate {
  Query query;
  StructureId structure = 0;
  Outlook outlook = Outlook::kNever;
  bool live = false;
  std::uint8_t looks = 0;  // how often a kLater was looked into further
  std::uint32_t tag = 0;
  std::uint32_t root = 0;  // FailureTime::root
};

// A 4-ary heap over (interval key, certificate). Keys are compared by their enclosures; only when
// two overlap is the arithmetic asked. Equal instants are ordered by value: (structure, predicate,
// sorted ids). Insertion and retraction take O(log n) comparisons. A certificate whose outlook is
// kLater is queued at the (double) time up to which it is known not to fail; failures at that very
// instant come first.
class EventQueue {
 public:
  explicit EventQueue(Arithmetic& arithmetic) : arithmetic_(&arithmetic) {}

  CertificateId allocate(StructureId structure, const Query& query, std::uint32_t tag);
  // The certificate leaves the heap, its number is released, and its id may be used again.
  void free(CertificateId id);
  Certificate& certificate(CertificateId id) { return certificates_[id]; }
  const Certificate& certificate(CertificateId id) const { return certificates_[id]; }
  // One past the largest id ever used; ids in between may be free (live == false).
  std::size_t capacity() const { return certificates_.size(); }
  std::size_t live() const { return live_; }

  // Queues a certificate that is not in the heap; its `root` passes from `time`.
  void push(CertificateId id, const FailureTime& time);
  // Takes a certificate out of the heap, if it is there (it stays live). Its number is released.
  void remove(CertificateId id);
  // The certificate fails at another time: push, or an update in place that needs fewer comparisons
  // than remove and push. The former number must have been released.
  void reset(CertificateId id, const FailureTime& time);
  bool queued(CertificateId id) const { return position_[id] != kNotQueued; }
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  CertificateId top() const { return heap_.front().certificate; }
  // The first entry is no failure but the end of what is known of a certificate (Outlook::kLater).
  bool top_is_later() const { return is_later(heap_.front()); }
  // The enclosure of the first failure time; requires !empty().
  double top_lo() const { return heap_.front().lo; }
  double top_hi() const { return heap_.front().hi; }
  // The failure time of a queued certificate; give it back with set_time after it was refined.
  FailureTime time(CertificateId id) const;
  void set_time(CertificateId id, const FailureTime& time);
  // Takes the first certificate out of the heap and hands over its number.
  FailureTime pop();
  // Appends the queued certificates whose instant equals that of the first one (itself included).
  // O(k) comparisons for k of them.
  void collect_first_instant(std::vector<CertificateId>& out);
  // True if at least two queued certificates share the first one's instant. O(1) comparisons.
  bool first_instant_is_shared();

  std::size_t bytes() const;
  std::size_t max_size() const { return max_size_; }

 private:
  struct Entry {
    double lo, hi;
    CertificateId certificate;
  };
  static constexpr std::size_t kArity = 4;
  static constexpr std::uint32_t kNotQueued = 0xffffffffu;

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
    position_[e.certificate] = static_cast<std::uint32_t>(i);
  }
  void take_out(std::size_t i);

  Arithmetic* arithmetic_;
  std::vector<Certificate> certificates_;
  std::vector<std::uint32_t> position_;  // in the heap, per certificate; kNotQueued
  std::vector<CertificateId> free_;
  std::vector<Entry> heap_;
  std::size_t live_ = 0;
  std::size_t max_size_ = 0;
};

}  // namespace kinex

#endif
