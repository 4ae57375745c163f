// SPDX-License-Identifier: GPL-3.0-or-later
// EqualPoints: the points of a triangulation, and its vertices. Of identically equal points the
// smallest id is the vertex, and the others are hidden behind it.
//
// Cost: O(1) for the vertex of a point; O(log n) and the number of points that are equal for a
// change.
#ifndef KINEX_STRUCTURES_TRIANGULATION_EQUAL_POINTS_H
#define KINEX_STRUCTURES_TRIANGULATION_EQUAL_POINTS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/motion/scene.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

class EqualPoints {
 public:
  explicit EqualPoints(std::size_t objects)
      : present_(objects, false), vertex_of_(objects, kNoObject) {}

  // The number of the scene's objects, present or not.
  std::size_t objects() const { return vertex_of_.size(); }
  bool present(ObjectId object) const { return present_[object]; }
  void set_present(ObjectId object, bool present) { present_[object] = present; }
  // These are present and no others.
  void set_present(std::span<const ObjectId> objects);
  // Those that are present, ascending. O(n).
  std::vector<ObjectId> members() const;

  // The vertex for `object`: itself, or the one it is hidden behind; kNoObject: neither.
  ObjectId vertex_of(ObjectId object) const { return vertex_of_[object]; }
  bool is_vertex(ObjectId object) const { return vertex_of_[object] == object; }
  // The points behind each vertex that hides any, ascending.
  const std::map<ObjectId, std::vector<ObjectId>>& hidden() const { return hidden_; }
  // Different numbers: other points may be hidden, or behind others.
  std::uint64_t hidden_changes() const { return hidden_changes_; }

  // No point is a vertex or hidden.
  void reset();
  void show(ObjectId vertex) { vertex_of_[vertex] = vertex; }
  // It is no vertex any more. Those behind it must have been taken before.
  void forget(ObjectId vertex) { vertex_of_[vertex] = kNoObject; }
  // Hides it, and those that it hides, behind a vertex.
  void hide(ObjectId object, ObjectId vertex);
  // Hidden no longer, and no vertex yet.
  void reveal(ObjectId object);
  // Those behind the vertex, ascending: hidden no longer, and no vertices yet.
  std::vector<ObjectId> reveal_behind(ObjectId vertex);
  // Reveals the points that have parted from their vertex because one of the two has moved:
  // !equal(a, b). Ascending.
  template <class Equal>
  std::vector<ObjectId> reveal_parted(std::span<const ObjectId> moved, const Equal& equal) {
    std::vector<ObjectId> parted;
    for (const ObjectId v : moved) {
      if (!present_[v]) continue;
      if (!is_vertex(v)) {
        if (!equal(v, vertex_of_[v])) parted.push_back(v);
      } else if (const auto it = hidden_.find(v); it != hidden_.end()) {
        for (const ObjectId other : it->second) {
          if (!equal(v, other)) parted.push_back(other);
        }
      }
    }
    sort_unique(parted);
    for (const ObjectId v : parted) reveal(v);
    return parted;
  }

  // `known`: the triangulation has it as a vertex. Returns the number of vertices.
  std::size_t check(AuditReport& report, const std::function<bool(ObjectId)>& known) const;
  std::size_t bytes() const {
    return present_.capacity() / 8 + vertex_of_.capacity() * sizeof(ObjectId);
  }

 private:
  std::vector<bool> present_;
  std::vector<ObjectId> vertex_of_;
  std::map<ObjectId, std::vector<ObjectId>> hidden_;
  std::uint64_t hidden_changes_ = 0;
};

}  // namespace kinex

#endif
