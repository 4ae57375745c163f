// SPDX-License-Identifier: GPL-3.0-or-later
// EventQueue: the buckets behind the heap.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/engine/event_queue.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Average number of entries in a bucket; the fraction of all entries that is cut into buckets at
// once; and the number of entries sampled to find where that fraction ends.
constexpr std::size_t kPerBucket = 4;
constexpr double kPart = 0.75;
constexpr std::size_t kLookedAt = 128;
// A list of at least this part of all certificates is read in the order of their ids: memory in its order
// is several times as fast as links that lead anywhere.
constexpr std::size_t kListIsMost = 4;
// Entries whose new neighbours are fetched together.
constexpr std::size_t kAhead = 16;

}  // namespace

void EventQueue::add_near(const Entry& e) {
  heap_.emplace_back();
  sift_up(heap_.size() - 1, e);
  if (heap_.size() > spill_at_) spill();
}

void EventQueue::pour() {
  while (far_ != 0 && (heap_.empty() || !(heap_.front().hi <= edge_))) {
    std::uint32_t bucket = poured_ + 1;
    const auto last = static_cast<std::uint32_t>(buckets_.size() - 1);
    while (bucket < last && buckets_[bucket] == kNone) ++bucket;
    if (bucket == last) {
      cut();
    } else {
      pour_bucket(bucket);
    }
  }
}

// The next lists are brought near step by step: every pour takes one link of each.
void EventQueue::prefetch_lists(std::uint32_t bucket) const {
  const auto last = static_cast<std::uint32_t>(buckets_.size() - 1);
  const auto link = [&](std::uint32_t ahead, int steps) {
    if (bucket + ahead >= last) return;
    std::uint32_t id = buckets_[bucket + ahead];
    for (; steps > 0 && id != kNone; --steps) id = certificates_[id].next;
    prefetch(id);
  };
  link(4, 0);
  link(3, 1);
  link(2, 2);
  link(1, 3);
}

void EventQueue::pour_bucket(std::uint32_t bucket) {
  poured_ = bucket;
  find_edge();
  prefetch_lists(bucket);
  for (std::uint32_t id = buckets_[bucket]; id != kNone;) {
    const Certificate& p = certificates_[id];
    heap_.emplace_back();
    sift_up(heap_.size() - 1, Entry{p.lo, p.hi, id});
    --far_;
    id = p.next;
  }
  buckets_[bucket] = kNone;
  spill_at_ = std::max(kSmall, 2 * heap_.size());
}

// The largest time of the buckets poured, or slightly less.
void EventQueue::find_edge() {
  const double guess = base_ + (static_cast<double>(poured_) + 1) / per_time_;
  double edge = std::min(guess, kInfinity);
  edge_ = -kInfinity;  // bucket_of computes
  const std::uint32_t poured = poured_;
  poured_ = 0;
  for (double back = 0x1p-52; edge > base_ && bucket_of(edge) > poured; back *= 2) {
    edge = guess - back * std::max(std::fabs(guess), 0x1p-1000);
  }
  poured_ = poured;
  edge_ = edge;
}

// Calls visit(id) for all `size` entries of the list that begins with `first`, the only ones in lists. The
// visitor may link them elsewhere.
template <class Visit>
void EventQueue::each_in_list(std::uint32_t first, std::size_t size, const Visit& visit) {
  if (size * kListIsMost < certificates_.size()) {
    for (std::uint32_t id = first, next; id != kNone; id = next) {
      next = certificates_[id].next;
      visit(id);
    }
    return;
  }
  for (std::size_t id = 0; id < certificates_.size(); ++id) {
    if (certificates_[id].where == kFar) visit(static_cast<std::uint32_t>(id));
  }
}

// Entries that are in no list go where their times belong. What they will be linked to is fetched first.
void EventQueue::distribute(std::span<const std::uint32_t> ids) {
  for (const std::uint32_t id : ids) {
    const std::uint32_t bucket = bucket_of(certificates_[id].lo);
    if (bucket > poured_) prefetch(buckets_[bucket]);
  }
  for (const std::uint32_t id : ids) {
    const Entry e{certificates_[id].lo, certificates_[id].hi, id};
    const std::uint32_t bucket = bucket_of(e.lo);
    if (bucket > poured_) {
      link(e, bucket);
    } else {
      heap_.emplace_back();
      sift_up(heap_.size() - 1, e);
    }
  }
}

// Cuts the entries of the last list up to some time into buckets, and pours the first.
void EventQueue::cut() {
  const std::uint32_t first = buckets_.back();
  const std::size_t size = far_;  // the other lists are empty
  const std::size_t stride = size / kLookedAt + 1;
  std::array<double, kLookedAt> sample{};
  std::size_t looked_at = 0, at = 0;
  double least = kInfinity;
  each_in_list(first, size, [&](std::uint32_t id) {
    const double lo = certificates_[id].lo;
    least = std::min(least, lo);
    if (at++ % stride == 0) sample[looked_at++] = lo;
  });
  const auto end = sample.begin() + static_cast<std::ptrdiff_t>(looked_at);
  const auto part =
      sample.begin() + static_cast<std::ptrdiff_t>(kPart * static_cast<double>(looked_at));
  std::nth_element(sample.begin(), part, end);
  const auto count = static_cast<std::size_t>(kPart * static_cast<double>(size / kPerBucket)) + 1;
  base_ = least;
  per_time_ = static_cast<double>(count) / (*part - least);
  poured_ = 0;
  // Few entries, or times too close to be separated: all of them go into the heap.
  const bool all = size <= kSmall || !(per_time_ < 0x1p500) || !(per_time_ > 0x1p-500);
  buckets_.assign(all ? 2 : count + 1, kNone);
  edge_ = kInfinity;
  if (!all) find_edge();
  far_ = 0;
  std::array<std::uint32_t, kAhead> waiting{};
  std::size_t waits = 0;
  each_in_list(first, size, [&](std::uint32_t id) {
    waiting[waits++] = id;
    if (waits < kAhead) return;
    distribute(waiting);
    waits = 0;
  });
  distribute(std::span(waiting).first(waits));
  spill_at_ = std::max(kSmall, 2 * heap_.size());
}

// The heap has become large: everything is cut anew.
void EventQueue::spill() {
  if (buckets_.empty()) buckets_.assign(2, kNone);
  const auto last = static_cast<std::uint32_t>(buckets_.size() - 1);
  const std::size_t heap_size = heap_.size();
  for (std::uint32_t bucket = 0; bucket < last; ++bucket) {
    for (std::uint32_t id = buckets_[bucket], next; id != kNone; id = next) {
      const Certificate& p = certificates_[id];
      next = p.next;
      --far_;
      link(Entry{p.lo, p.hi, id}, last);
    }
    buckets_[bucket] = kNone;
  }
  for (const Entry& e : heap_) link(e, last);
  heap_.clear();
  cut();
  spill_at_ = std::max(spill_at_, heap_.size() * 2 > heap_size ? 2 * heap_size : kSmall);
}

}  // namespace kinex
