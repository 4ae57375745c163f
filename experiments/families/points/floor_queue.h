// SPDX-License-Identifier: GPL-3.0-or-later
// FloorQueue: the failure times of a floor, in an array of buckets of equal length.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_QUEUE_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_QUEUE_H

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace kinex::families::floors {

// Entries are numbers below `size`; each is in the queue once or not at all. Times lie in [start,
// end] and never before the last minimum but by rounding.
class FloorQueue {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  FloorQueue(std::size_t size, double start, double end, std::size_t buckets)
      : entries_(size, {0, kNone, kOut}),
        heads_(buckets, kNone),
        start_(start),
        per_time_(static_cast<double>(buckets - 1) / (end - start)) {}

  void insert(std::uint32_t id, double time) {
    std::uint32_t& head = heads_[bucket_of(time)];
    entries_[id] = {time, head, kNone};
    if (head != kNone) entries_[head].previous = id;
    head = id;
  }

  // Does nothing if the entry is not in the queue.
  void remove(std::uint32_t id) {
    Entry& e = entries_[id];
    if (e.previous == kOut) return;
    if (e.next != kNone) entries_[e.next].previous = e.previous;
    (e.previous != kNone ? entries_[e.previous].next : heads_[bucket_of(e.time)]) = e.next;
    e.previous = kOut;
  }

  // The entry of the least time; kNone if there is none.
  std::uint32_t first() {
    while (current_ < heads_.size() && heads_[current_] == kNone) ++current_;
    if (current_ == heads_.size()) return kNone;
    std::uint32_t best = heads_[current_];
    for (std::uint32_t id = entries_[best].next; id != kNone; id = entries_[id].next) {
      if (entries_[id].time < entries_[best].time) best = id;
    }
    return best;
  }

  double time(std::uint32_t id) const { return entries_[id].time; }

 private:
  static constexpr std::uint32_t kOut = kNone - 1;
  struct Entry {
    double time;
    std::uint32_t next, previous;
  };
  static_assert(sizeof(Entry) == 16);

  // An entry that falls before the current bucket was put into that bucket; it is then not left
  // before the entry is gone.
  std::size_t bucket_of(double time) const {
    const double place = (time - start_) * per_time_;
    return std::max(current_, static_cast<std::size_t>(std::max(place, 0.0)));
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> heads_;
  double start_, per_time_;
  std::size_t current_ = 0;
};

}  // namespace kinex::families::floors

#endif
