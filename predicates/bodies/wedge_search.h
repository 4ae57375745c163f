// SPDX-License-Identifier: GPL-3.0-or-later
// WedgeSearch: wedges between the bodies of a scene (predicates/bodies/separating_wedge.h), as
// certificates: placed for the present instant, and measured when they fail.
//
// A wedge is placed in doubles, at a time near now that is the same in every exact arithmetic. Its
// certificates are exact, and checked by their signs.
#ifndef KINEX_PREDICATES_BODIES_WEDGE_SEARCH_H
#define KINEX_PREDICATES_BODIES_WEDGE_SEARCH_H

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/engine/kernel.h"
#include "predicates/bodies/body_frames.h"
#include "predicates/bodies/pose_predicates.h"
#include "predicates/bodies/separating_wedge.h"

namespace kinex {

class WedgeSearch {
 public:
  // The separation at which a wedge was placed over the displacement that it withstood is at most
  // 1 / 0.23; in thousandths.
  static constexpr std::int64_t kMostThousandths = 1000000 / 230;

  // Two bodies and the pose between them.
  struct Bodies {
    ObjectId a, b, pose;
  };
  // The wedge of one pair, which stays the same object over all its placements.
  class Wedge {
   public:
    bool line_is_of_b() const { return line_of_ == Frame::kB; }
    // Its line, two tangents and their common point, as constants. The tangents are valid only where
    // the wedge is no disc.
    const std::array<ObjectId, 4>& objects() const { return objects_[turn_]; }

   private:
    friend class WedgeSearch;
    Frame line_of_ = Frame::kA;  // its role
    // Two sets used in turn: no live certificate refers to an object that is redefined.
    std::array<std::array<ObjectId, 4>, 2> objects_{};
    std::uint8_t turn_ = 0;
    double separation_ = 0;
    std::array<double, 2> t_{};  // the pose at which it was placed, in the frame of its line
    double c_ = 1, s_ = 0;
    double error_ = 0;  // of that pose, as a displacement
  };

  // The references must live as long as this object.
  WedgeSearch(Kernel& kernel, BodyFrames& frames, const PosePredicates& predicates)
      : kernel_(kernel), frames_(frames), predicates_(predicates) {}

  // Places a wedge that holds right after now, in the role that withstands more motion. Returns its
  // certificates, valid until the next call: the line with the common point, and, unless it is a
  // disc, the two orders of normals. None if the bodies are too near; then the wedge has not changed.
  // A search in doubles over all vertices, at most six signs.
  std::span<const Query> place(Wedge& wedge, const Bodies& bodies);
  // The wedge has failed: takes down how far the bodies have moved since it was placed.
  void measure(const Wedge& wedge, const Bodies& bodies);
  // The smallest displacement measured, in the metric of the wedge's role, as a fraction of the
  // separation at which the wedge was placed; +infinity if there is none.
  double least_displacement() const { return least_; }
  // 1 / least_displacement() in thousandths, rounded up; nullopt if no displacement was measured.
  std::optional<std::int64_t> most_thousandths() const;
  std::size_t bytes() const;

 private:
  std::span<const Query> place(Wedge& wedge, const Bodies& bodies, const WedgePlan& plan,
                               const RoughPose& in_a, Frame line_of);
  // The reach of the body without the line, in the frame of the one with the line.
  double moving_reach(const Bodies& bodies, Frame line_of);
  const RoughPolygon& rough(ObjectId body, bool negated);
  const FramePolygon& polygon(ObjectId body, bool negated);
  RoughPose pose_now(const Bodies& bodies, Frame frame);

  Kernel& kernel_;
  BodyFrames& frames_;
  const PosePredicates& predicates_;
  std::map<std::pair<ObjectId, bool>, RoughPolygon> rough_;
  std::array<Query, 3> queries_;  // of the last placement
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace kinex

#endif
