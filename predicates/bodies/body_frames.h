// SPDX-License-Identifier: GPL-3.0-or-later
// BodyFrames: the polygons of a scene's bodies as constants in their frames: their hierarchies, and
// derived objects for their lines and points.
//
// A structure for two bodies A and B works with A's polygon and with B' = -B
// (predicates/bodies/pose_2.h). So every polygon exists twice, unchanged and negated. Bodies with
// equal polygons share both.
#ifndef KINEX_PREDICATES_BODIES_BODY_FRAMES_H
#define KINEX_PREDICATES_BODIES_BODY_FRAMES_H

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"
#include "predicates/bodies/outer_hierarchy.h"

namespace kinex {

// The derived objects of one kernel that stand for constants of frames. Equal constants share one
// object.
class FrameConstants {
 public:
  explicit FrameConstants(Kernel& kernel) : kernel_(kernel) {}
  ObjectId point(const FramePoint& p);
  ObjectId line(const FrameLine& l);
  std::size_t bytes() const;

 private:
  Kernel& kernel_;
  std::map<FramePoint, ObjectId> points_;
  std::map<FrameLine, ObjectId> lines_;
};

// One hierarchy with the objects of its lines and points, which are made when they are first
// needed.
class BodyFrame {
 public:
  BodyFrame(OuterHierarchy hierarchy, FrameConstants& constants);

  const OuterHierarchy& hierarchy() const { return hierarchy_; }
  // The line of an edge, the apex of a node.
  ObjectId line(std::uint32_t edge);
  ObjectId apex(std::uint32_t node);
  // Of the polygon itself: vertex i, the line of edge i from it to the next, and the lines across
  // that edge at its first and at its last end, with normals in the edge's direction.
  ObjectId vertex(std::uint32_t i);
  ObjectId polygon_edge(std::uint32_t i);
  ObjectId across(std::uint32_t edge, bool last);
  // A point strictly inside the polygon: the mean of the ends of a longest edge and of a vertex
  // farthest from it. Invariant under turning and negating the polygon, except for ties.
  ObjectId inner();
  std::uint32_t size() const { return static_cast<std::uint32_t>(hierarchy_.polygon().size()); }
  std::uint32_t after(std::uint32_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::uint32_t before(std::uint32_t i) const { return i == 0 ? size() - 1 : i - 1; }
  FrameConstants& constants() { return *constants_; }
  std::size_t bytes() const;

 private:
  OuterHierarchy hierarchy_;
  FrameConstants* constants_;
  // kNoObject: not made yet
  std::vector<ObjectId> lines_, points_, vertices_, polygon_edges_;
  std::array<std::vector<ObjectId>, 2> across_;
  ObjectId inner_ = kNoObject;
};

class BodyFrames {
 public:
  // Keeps a reference to the scene.
  BodyFrames(Kernel& kernel, const Scene& scene, CutPolicy policy);

  // The frame of a body, negated or not. Built by the first call; lives as long as this object.
  BodyFrame& frame(ObjectId body, bool negated);
  // The place of vertex i of that frame in the scene's list (the frame's list begins elsewhere).
  std::uint32_t place(ObjectId body, bool negated, std::uint32_t i) const;
  FrameConstants& constants() { return constants_; }
  CutPolicy policy() const { return policy_; }
  // Calls visit(hierarchy) for those built so far, each once.
  template <class Visit>
  void each_hierarchy(const Visit& visit) const {
    for (const auto& [vertices, frame] : by_polygon_) visit(frame->hierarchy());
  }
  std::size_t bytes() const;

 private:
  void find_places(ObjectId body, bool negated, std::vector<std::uint32_t>& places) const;

  const Scene& scene_;
  CutPolicy policy_;
  FrameConstants constants_;
  std::map<std::vector<FramePoint>, std::unique_ptr<BodyFrame>> by_polygon_;
  std::vector<std::array<BodyFrame*, 2>> of_body_;
  struct ByPolygon {
    const Scene* scene;
    bool operator()(ObjectId a, ObjectId b) const {
      return scene->objects[a].polygon < scene->objects[b].polygon;
    }
  };
  using Places = std::array<std::vector<std::uint32_t>, 2>;
  // One body for each distinct list of vertices, with the places of its vertices, and the places of
  // every body. A cache, filled by the first request.
  mutable std::map<ObjectId, Places, ByPolygon> different_;
  mutable std::vector<Places*> places_of_body_;
};

}  // namespace kinex

#endif
