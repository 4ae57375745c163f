// SPDX-License-Identifier: GPL-3.0-or-later
// FloorTimetable: the certificates of a floor, each searched for its failure in windows of time.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_TIMETABLE_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_TIMETABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "experiments/families/points/floor_queue.h"

namespace kinex::families::floors {

// When to search for a failure, and how far: windows of kLifetimes average lifetimes of a
// certificate, each further one kGrowth times as long, as in core/engine/kernel.cpp. `Failure(id,
// now, limit, fresh)` gives the first failure of a certificate in (now, limit]; fresh: it has just
// come about by the failure of its opposite, and is zero now.
class FloorTimetable {
 public:
  FloorTimetable(std::size_t certificates, double start, double end)
      : queue_(certificates, start, end,
               std::min(kMostBuckets, kBucketsPerCertificate * certificates + 2)),
        looks_(certificates, 0),
        certificates_(certificates),
        end_(end),
        since_(start) {}

  // Searches anew.
  template <class Failure>
  void renew(std::uint32_t id, double now, bool fresh, const Failure& failure) {
    looks_[id] = 0;
    queue_.remove(id);
    look(id, now, fresh, failure);
  }

  // The next failure; false: none is left.
  template <class Failure>
  bool next(std::uint32_t& id, double& now, const Failure& failure) {
    for (;;) {
      id = queue_.first();
      if (id == FloorQueue::kNone) return false;
      now = queue_.time(id);
      queue_.remove(id);
      if ((looks_[id] & kLater) == 0) return true;
      looks_[id] = static_cast<std::uint8_t>((looks_[id] & ~kLater) + 1);
      look(id, now, false, failure);
    }
  }

  // `count` certificates have been renewed.
  void note(std::size_t count, double now) {
    renewed_ += count;
    if (renewed_ < certificates_ / 4 || !(now > since_)) return;
    length_ = kLifetimes * (now - since_) * static_cast<double>(certificates_) /
              static_cast<double>(renewed_);
    since_ = now;
    renewed_ = 0;
  }

 private:
  static constexpr std::size_t kBucketsPerCertificate = 64, kMostBuckets = std::size_t{1} << 22;
  static constexpr double kLifetimes = 2.5, kGrowth = 4;
  static constexpr int kMostLooks = 6;
  static constexpr std::uint8_t kLater = 0x80;  // with the number of looks: nothing up to its time

  template <class Failure>
  void look(std::uint32_t id, double now, bool fresh, const Failure& failure) {
    double limit = end_;
    if (looks_[id] < kMostLooks) {
      double length = length_;
      for (int i = 0; i < looks_[id]; ++i) length *= kGrowth;
      limit = std::min(limit, now + length);
    }
    const double time = failure(id, now, limit, fresh);
    if (time <= limit) {
      queue_.insert(id, time);
    } else if (limit < end_) {
      looks_[id] |= kLater;
      queue_.insert(id, limit);
    }
  }

  FloorQueue queue_;
  std::vector<std::uint8_t> looks_;
  std::size_t certificates_, renewed_ = 0;
  double end_, since_, length_ = std::numeric_limits<double>::infinity();
};

}  // namespace kinex::families::floors

#endif
