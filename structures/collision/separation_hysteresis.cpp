// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/separation_hysteresis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace kinex {
namespace {

// The motion that a wedge withstands, in thousandths of the separation.
constexpr int kWithstands = 230;

}  // namespace

SeparationHysteresis::SeparationHysteresis(Kernel& kernel, StructureId id, const Scene& scene)
    : ClosestFeatures(kernel, id, scene), least_(std::numeric_limits<double>::infinity()) {}

std::vector<std::string_view> SeparationHysteresis::event_kinds() const {
  return collision_kinds({"change", "wedge"});
}

const FramePolygon& SeparationHysteresis::polygon(ObjectId body, bool negated) {
  return frames_.frame(body, negated).hierarchy().polygon();
}

const RoughPolygon& SeparationHysteresis::rough(ObjectId body, bool negated) {
  const auto found = rough_.find({body, negated});
  if (found != rough_.end()) return found->second;
  return rough_.try_emplace({body, negated}, polygon(body, negated)).first->second;
}

RoughPose SeparationHysteresis::pose_now(PairId p, Frame frame) {
  const Trajectory& pose = kernel_.derived().trajectory(pair(p).pose);
  const double now = kernel_.coarse_now();
  const RoughPose rough_pose(pose, now, frame);
  if (!is_too_rough(rough_pose, rough(pair(p).a, false), rough(pair(p).b, true))) return rough_pose;
  return RoughPose::precise(pose, now, frame);
}

// True if a wedge that holds right after now is in place.
bool SeparationHysteresis::put_wedge(PairId p) {
  const RoughPose pose = pose_now(p, Frame::kA);
  const auto plan = plan_wedge(rough(pair(p).a, false), rough(pair(p).b, true), pose);
  if (!plan) return false;
  const Frame longer = plan->longer();
  return put_wedge(p, *plan, pose, longer) ||
         put_wedge(p, *plan, pose, longer == Frame::kA ? Frame::kB : Frame::kA);
}

bool SeparationHysteresis::put_wedge(PairId p, const WedgePlan& plan, const RoughPose& in_a,
                                     Frame line_of) {
  const ObjectId a = pair(p).a, b = pair(p).b;
  const auto found = separating_wedge(plan, line_of, {polygon(a, false), rough(a, false)},
                                      {polygon(b, true), rough(b, true)}, in_a);
  if (!found) return false;
  Wedge& wedge = wedges_[p];
  wedge.turn ^= 1;
  std::array<ObjectId, 4>& ids = wedge.objects[wedge.turn];
  const std::array<const FrameLine*, 3> lines{&found->line, &found->g1, &found->g2};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!found->turns && (i == 1 || i == 2)) continue;
    std::string name = i < 3 ? lines[i]->to_string() : found->v.to_string();
    std::vector<Rational> at = i < 3 ? lines[i]->coordinates() : found->v.coordinates();
    if (ids[i] == 0) {
      ids[i] = kernel_.constant(std::move(name), std::move(at));
    } else {
      kernel_.redefine(ids[i], std::move(name), std::move(at));
    }
  }
  const ObjectId body = pair(p).pose;
  const PosePredicates& x = predicates_;
  // Orders take the line of A first, so that seen from B' they are each other's reverse.
  const std::array<Query, 3> all =
      line_of == Frame::kA
          ? std::array<Query, 3>{Query(x.side[0], {body, ids[0], ids[3]}),
                                 Query(x.normal_order, {body, ids[0], ids[1]}),
                                 Query(x.normal_order_reversed, {body, ids[0], ids[2]})}
          : std::array<Query, 3>{Query(x.side[1], {body, ids[0], ids[3]}),
                                 Query(x.normal_order_reversed, {body, ids[1], ids[0]}),
                                 Query(x.normal_order, {body, ids[2], ids[0]})};
  const std::span<const Query> queries(all.data(), found->turns ? 3 : 1);
  for (const Query& query : queries) {
    if (kernel_.sign_after(query) != Sign::kPositive) {
      wedge.turn ^= 1;
      return false;
    }
  }
  set_certificates(p, queries);
  const RoughPose pose = line_of == Frame::kA ? in_a : pose_now(p, line_of);
  wedge.in_use = true;
  wedge.line_of = line_of;
  wedge.separation = plan.separation;
  wedge.t = pose.t;
  wedge.c = pose.c;
  wedge.s = pose.s;
  wedge.error = pose.error_t + moving_reach(p, line_of) * pose.error_turn;
  return true;
}

bool SeparationHysteresis::start(PairId p) {
  if (wedges_.size() <= p) wedges_.resize(p + std::size_t{1});
  wedges_[p].in_use = false;
  return put_wedge(p) || ClosestFeatures::start(p);
}

double SeparationHysteresis::moving_reach(PairId p, Frame line_of) {
  const bool of_a = line_of == Frame::kA;
  return rough(of_a ? pair(p).b : pair(p).a, of_a).reach;
}

// The error of the doubles counts as displacement.
void SeparationHysteresis::measure(PairId p) {
  const Wedge& wedge = wedges_[p];
  const RoughPose pose = pose_now(p, wedge.line_of);
  if (!pose.is_known()) return;
  const double moved = std::hypot(pose.t[0] - wedge.t[0], pose.t[1] - wedge.t[1]);
  const double turned =
      std::atan2(wedge.c * pose.s - wedge.s * pose.c, wedge.c * pose.c + wedge.s * pose.s);
  const double reach = moving_reach(p, wedge.line_of);
  const double error = wedge.error + pose.error_t + reach * pose.error_turn;
  least_ = std::min(least_, (moved + reach * std::fabs(turned) + error) / wedge.separation);
}

// While a wedge holds the bodies are apart.
std::optional<CollisionPairs::Features> SeparationHysteresis::touch(PairId p, When when) {
  if (wedges_[p].in_use) return std::nullopt;
  return ClosestFeatures::touch(p, when);
}

void SeparationHysteresis::fail(PairId p, std::uint32_t slot) {
  if (!wedges_[p].in_use) {
    const bool is_contact = is_contact_slot(p, slot);
    if (!is_contact && put_wedge(p)) {
      report(p, kWedge);
      return;
    }
    ClosestFeatures::fail(p, slot);
    return;
  }
  measure(p);
  if (put_wedge(p)) {
    report(p, kWedge);
    return;
  }
  wedges_[p].in_use = false;
  if (ClosestFeatures::start(p)) {
    report(p, kWedge);
    return;
  }
  // A wedge proves a positive distance: reached only in an inexact arithmetic.
  kernel_.corrupt(id_, "the bodies meet although a wedge was between them");
}

std::vector<BoundCheck> SeparationHysteresis::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks = ClosestFeatures::bounds(context);
  if (!(least_ < 1e6)) return checks;
  constexpr std::int64_t kMost = 1000000 / kWithstands;
  const double most = std::ceil(std::min(1000 / least_, 1e15));
  checks.push_back(at_most("separation_hysteresis.displacement",
                           "the separation at which a wedge was made over the displacement that it "
                           "withstood: at most 1 / "
                           "0.23 (thousandths)",
                           Integer(kMost), Integer(static_cast<std::int64_t>(most))));
  return checks;
}

std::size_t SeparationHysteresis::bytes() const {
  std::size_t total = ClosestFeatures::bytes() + wedges_.capacity() * sizeof(Wedge);
  for (const auto& [key, polygon] : rough_) {
    total += sizeof(key) + sizeof(polygon) + polygon.vertices.capacity() * 2 * sizeof(double);
  }
  return total;
}

}  // namespace kinex
