// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationHysteresis: collision detection by wedges that cannot fail before a constant fraction
// of the separation has been travelled (predicates/bodies/separating_wedge.h).
//
// A proof is a wedge of 3 certificates: a line of one body and two tangents of the other. Its role
// names the body of the line; here it is A:
//
//      ______ :            .-'  g1
//     /      \:         .-'  _____
//    |   A    :      v <    |  B  |     line with normal m; tangents with normals g1, g2
//     \______/:         '-.  -----      that meet at v
//             : m ->       '-.  g2
//
// When one fails, a new wedge is made for the present separation s, in the role that withstands
// more motion. It cannot fail before the bodies have moved by 0.23 s in the metric of its role
// (|dt| + rho_B |d theta| in A's frame, or |dt'| + rho_A |d theta| in that of B), hence not before
// they have moved that far in the larger of the two metrics. So the number of events is at most the
// number of pieces of the path, each inside a ball of that larger metric of radius 0.103 times the
// separation at its centre, however jagged the path. The choice of the role does not depend on
// which body is called A, except for rounding and for bodies that are alike. Where the bodies are
// so close that doubles find no wedge (2^-26 of their size), the pair of closest features takes
// over until they part: contacts are as exact as in the other structures.
//
// Compactness: 3 certificates a pair, 5 for closest features. Responsiveness: 3 certificates; the
// search for a wedge visits all vertices, in doubles.
// Source: the hysteresis property of Erickson, Guibas, Stolfi, Zhang (1999); the rest is worked out
// here.
#ifndef KINEX_STRUCTURES_COLLISION_SEPARATION_HYSTERESIS_H
#define KINEX_STRUCTURES_COLLISION_SEPARATION_HYSTERESIS_H

#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "predicates/bodies/separating_wedge.h"
#include "structures/collision/closest_features.h"

namespace kinex {

class SeparationHysteresis final : public ClosestFeatures {
 public:
  static constexpr std::uint8_t kWedge = kChange + 1;  // a new wedge

  SeparationHysteresis(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "separation_hysteresis"; }
  std::vector<std::string_view> event_kinds() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // The smallest displacement at which a wedge failed, in the metric of its role, as a fraction of
  // the separation at which it was made; +infinity if none failed. Failures after a change of
  // motion count too.
  double least_displacement() const { return least_; }

 protected:
  Roles describe(PairId p, ProofGroup& group) const override;
  bool start(PairId p) override;
  void fail(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;

 private:
  struct Wedge {
    bool in_use = false;
    Frame line_of = Frame::kA;  // its role
    // line, g1, g2, v: two sets used in turn, so that no live certificate refers to an object that
    // is redefined
    std::array<std::array<ObjectId, 4>, 2> objects{};
    std::uint8_t turn = 0;
    double separation = 0;
    std::array<double, 2> t{};  // the pose at which it was made, in the frame of its line
    double c = 1, s = 0;
    double error = 0;  // of that pose, as a displacement
  };
  bool put_wedge(PairId p);
  bool put_wedge(PairId p, const WedgePlan& plan, const RoughPose& in_a, Frame line_of);
  void measure(PairId p);
  // The reach of the body without the line, in the frame of the one with the line.
  double moving_reach(PairId p, Frame line_of);
  const RoughPolygon& rough(ObjectId body, bool negated);
  const FramePolygon& polygon(ObjectId body, bool negated);
  RoughPose pose_now(PairId p, Frame frame);

  std::vector<Wedge> wedges_;  // per pair
  std::map<std::pair<ObjectId, bool>, RoughPolygon> rough_;
  double least_;
};

}  // namespace kinex

#endif
