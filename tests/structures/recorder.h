// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a run as data, and the changes that a test makes from outside, so that the run can
// be repeated.
#ifndef KINEX_TESTS_STRUCTURES_RECORDER_H
#define KINEX_TESTS_STRUCTURES_RECORDER_H

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"

namespace kinex::test {

struct Recorded {
  std::uint8_t kind = 0;
  std::vector<ObjectId> ids;
  bool external = false;
  // The exact name of the instant, if requested.
  std::vector<std::string> polynomial;
  int root = 0;
  std::string lower, upper, decimal;
  friend bool operator==(const Recorded&, const Recorded&) = default;
};

inline void PrintTo(const Recorded& r, std::ostream* out) {
  *out << "kind " << static_cast<int>(r.kind) << " of";
  for (const ObjectId id : r.ids) *out << ' ' << id;
  *out << (r.external ? " !" : "") << " at " << r.decimal << ", root " << r.root << " of";
  for (const std::string& c : r.polynomial) *out << ' ' << c;
}

class Recorder final : public EventSink {
 public:
  void event(const Event& event, Arithmetic& arithmetic) override {
    Recorded r;
    r.kind = event.kind;
    r.ids.assign(event.ids.begin(), event.ids.begin() + event.count);
    r.external = event.external;
    if (events.size() < instants) {
      InstantText text = arithmetic.describe_now();
      r.polynomial = std::move(text.polynomial);
      r.root = text.root;
      r.lower = std::move(text.lower);
      r.upper = std::move(text.upper);
      r.decimal = std::move(text.approximate);
    }
    events.push_back(std::move(r));
    predicates.emplace_back(event.certificate.arity == 0
                                ? std::string_view()
                                : arithmetic.predicate(event.certificate.predicate).name());
  }
  // The number of events recorded with their instants.
  std::size_t instants = 0;
  std::vector<Recorded> events;
  // Of the certificate behind each event; empty: there is none.
  std::vector<std::string> predicates;
};

// Changes from outside, kept so that they can be repeated.
class OutsideChanges {
 public:
  void update(Simulator& simulator, const Rational& t, ObjectId object, Trajectory trajectory) {
    simulator.schedule_update(t, object, trajectory);
    changes_.push_back({Kind::kUpdate, t, object, std::move(trajectory)});
  }
  void insert(Simulator& simulator, const Rational& t, ObjectId object, Trajectory trajectory) {
    simulator.schedule_insertion(t, object, trajectory);
    changes_.push_back({Kind::kInsert, t, object, std::move(trajectory)});
  }
  void erase(Simulator& simulator, const Rational& t, ObjectId object) {
    simulator.schedule_erasure(t, object);
    changes_.push_back({Kind::kErase, t, object, {}});
  }
  void repeat(Simulator& simulator) const {
    for (const Change& c : changes_) {
      switch (c.kind) {
        case Kind::kUpdate:
          simulator.schedule_update(c.t, c.object, c.trajectory);
          break;
        case Kind::kInsert:
          simulator.schedule_insertion(c.t, c.object, c.trajectory);
          break;
        case Kind::kErase:
          simulator.schedule_erasure(c.t, c.object);
          break;
      }
    }
  }

 private:
  enum class Kind { kUpdate, kInsert, kErase };
  struct Change {
    Kind kind;
    Rational t;
    ObjectId object;
    Trajectory trajectory;
  };
  std::vector<Change> changes_;
};

}  // namespace kinex::test

#endif
