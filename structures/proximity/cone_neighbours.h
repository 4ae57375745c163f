// SPDX-License-Identifier: GPL-3.0-or-later
// ConeNeighbours: what octants_listed, octants_local and cones_local have in common: the woods
// (cone_woods.h), the attribute, and its events.
//
// Attribute. The pairs of points of which one is next in a cone of the other, for the cones that count
// (cone_frame.h): in octants at most 4n, among them every closest pair. next() tells which point is
// next in which cone.
//
// Events. An instant changes the pointers from what they were just before to what they are just
// after, and is reported once, when it is over: one event "point" for each pointer that differs, of
// the other cones too, in ascending order of points and cones: the point, the old one that was next,
// the new one (the point itself: none). It is external if a pair has left the attribute or joined
// it. So all structures on one frame report the same.
//
// Ties. Points that are identically level are in the order after an infinitesimal turn, equal points
// along (2, 1) by id (turned_order.h).
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_NEIGHBOURS_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_NEIGHBOURS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/proximity/cone_woods.h"

namespace kinex {

// Notified of changes. What a build or a rebuild does to the pairs is not said one by one (builds()).
class ConeWatcher {
 public:
  virtual ~ConeWatcher() = default;
  // At once: the first point in some cone of `point` is `fresh`, and was `old`; kNoObject: none.
  virtual void pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) {
    static_cast<void>(point);
    static_cast<void>(old);
    static_cast<void>(fresh);
  }
  // A pair has joined the attribute, or has left it: with the event that says so, or because a point comes or
  // goes.
  virtual void pair_changed(const std::array<ObjectId, 2>& pair, bool is_there) {
    static_cast<void>(pair);
    static_cast<void>(is_there);
  }
};

class ConeNeighbours : public Structure {
 public:
  using Pair = std::array<ObjectId, 2>;  // ids, ascending
  // The kinds of events, by rank; a structure's own ones follow.
  enum Kind : std::uint8_t { kPoint, kFirstOwnKind };

  StructureId id() const { return id_; }
  const ConeFrame& frame() const { return woods_.frame(); }
  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return woods_.objects(); }
  // The first point in the cone of p, as of now; kNoObject: none.
  ObjectId next(std::size_t cone, ObjectId p) const { return woods_.next(cone, p); }
  // The pairs of the attribute, ascending, and whether one is among them.
  std::vector<Pair> pairs() const;
  bool has(const Pair& pair) const;
  // A build and the rebuilds since, of which watchers are not notified pair by pair.
  std::uint64_t builds() const { return builds_; }
  // `watcher` lives as long as changes are made. It must not change the cones.
  void add_watcher(ConeWatcher& watcher) const { watchers_.push_back(&watcher); }

  Attribute attribute() const override;
  Attribute told() const override;
  void instant_over() override { tell(); }
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

 protected:
  ConeNeighbours(Kernel& kernel, StructureId id, const ConeFrame& frame, std::size_t objects,
                 const ConeWoods::Before& before);

  Kernel& kernel() const { return *kernel_; }
  ConeWoods& woods() { return woods_; }
  const ConeWoods& woods() const { return woods_; }
  bool all_told() const { return changes_.empty(); }
  // Discards the changes that have not been reported: all may be different.
  void begin() {
    changes_.clear();
    ++builds_;
  }
  // The same where a point has come or gone: watchers are notified.
  void follow_point();
  // next(cone, p) has become another one.
  virtual void pointer_changed(std::size_t cone, ObjectId p) {
    static_cast<void>(cone);
    static_cast<void>(p);
  }
  // A failure was repaired: reports what has changed, now or when the instant is over.
  void repaired();
  // True if every pointer follows a lower envelope of segments: motions are linear, flight plans do not change,
  // and there is a point.
  static bool has_segments(const BoundContext& context);
  // How often all pointers change then. Requires has_segments().
  Integer most_pointer_changes(const BoundContext& context) const;
  // The number of events "point" in such runs; external ones.
  void add_bounds(const BoundContext& context, std::vector<BoundCheck>& result) const;
  void check_woods(AuditReport& report) const;
  std::size_t bytes_of_woods() const {
    return woods_.bytes() + changes_.capacity() * sizeof(Change) +
           telling_.capacity() * sizeof(Telling) +
           (gone_.capacity() + came_.capacity()) * sizeof(Named) +
           old_pairs_.capacity() * sizeof(Pair);
  }

 private:
  struct Change {  // next(cone, point) was `old`
    ObjectId point;
    std::uint32_t cone;
    ObjectId old;
  };
  struct Telling {
    ObjectId point, old, fresh;
    bool goes = false, comes = false;  // the pair with the old one, with the new one
  };
  struct Named {  // a pair of the event at a place of telling_
    Pair pair;
    std::size_t place;
    auto operator<=>(const Named&) const = default;
  };
  void note(std::size_t cone, ObjectId p, ObjectId old);
  void tell();
  void find_changes();
  void notify(const Telling& one) const;
  void mark_first(std::vector<Named>& named, bool Telling::*mark);
  // Each pointer once, ascending, as it was last reported.
  static void sort_out(std::vector<Change>& changes);
  ObjectId next_before(std::span<const Change> changes, std::size_t cone, ObjectId p) const;
  void note_old_pairs();
  bool had(std::span<const Change> changes, const Pair& pair) const;
  template <class Next>
  std::vector<Pair> pairs_by(const Next& next) const;

  Kernel* kernel_;
  StructureId id_;
  ConeWoods woods_;
  std::uint64_t builds_ = 0;
  std::vector<Change> changes_;  // not reported yet, in the order in which they were made
  // Scratch of tell().
  std::vector<Telling> telling_;
  std::vector<Named> gone_, came_;
  std::vector<Pair> old_pairs_;  // of the pointers that have changed, as they were; ascending
  mutable std::vector<ConeWatcher*> watchers_;
};

}  // namespace kinex

#endif
