// SPDX-License-Identifier: GPL-3.0-or-later
// TrajectoryTree: its audit: the hulls of the nodes, and the answers to boxes between points, by
// exact positions and by CGAL.
#include <algorithm>
#include <utility>

#include "structures/range/static_range_audit.h"
#include "structures/range/trajectory_tree.h"

namespace kinex {
namespace {

class BoxInSnapshot final : public BoxAt {
 public:
  BoxInSnapshot(const Snapshot& now, const ExactBox& box) : now_(now), box_(box) {}

  bool precedes(int axis, ObjectId a, ObjectId b) override {
    return now_.position(a, axis) < now_.position(b, axis);
  }
  OutOfInterval out(int axis, const CoordinateTable&, std::size_t,
                    std::span<const ObjectId> objects) override {
    const auto& [low, high] = box_[static_cast<std::size_t>(axis)];
    OutOfInterval out;
    std::uint64_t bit = 1;
    for (const ObjectId object : objects) {
      const Rational own = now_.position(object, axis);
      if (own < low) out.before |= bit;
      if (high < own) out.after |= bit;
      bit <<= 1;
    }
    return out;
  }

 private:
  const Snapshot& now_;
  const ExactBox& box_;
};

}  // namespace

void TrajectoryTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> alive;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) alive.push_back(id);
  }
  report.check(alive == objects_, [] { return "other objects are there"; });
  if (alive != objects_) return;
  const std::unique_ptr<const Forest> fresh = forest_ == nullptr ? made() : nullptr;
  const Forest& forest = fresh != nullptr ? *fresh : *forest_;
  forest.by_x.check(snapshot, report);
  forest.by_y.check(snapshot, report);
  for (const ExactBox& exact : boxes_between_points(snapshot, alive, report.checks)) {
    std::vector<ObjectId> found;
    BoxInSnapshot box(snapshot, exact);
    const std::uint64_t looked_at = search(forest, box, found, nullptr);
    std::sort(found.begin(), found.end());
    const std::vector<ObjectId> expected = scanned_range(snapshot, exact);
    report.check(found == expected, [] { return "a box holds other points"; });
    report.check(cgal_range(snapshot, exact) == expected,
                 [] { return "CGAL finds other points in a box"; });
    report.check(looked_at <= most_looked_at(alive.size()),
                 [] { return "a box takes too many nodes"; });
  }
}

}  // namespace kinex
