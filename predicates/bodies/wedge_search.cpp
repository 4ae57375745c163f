// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/wedge_search.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace kinex {

const FramePolygon& WedgeSearch::polygon(ObjectId body, bool negated) {
  return frames_.frame(body, negated).hierarchy().polygon();
}

const RoughPolygon& WedgeSearch::rough(ObjectId body, bool negated) {
  const auto found = rough_.find({body, negated});
  if (found != rough_.end()) return found->second;
  return rough_.try_emplace({body, negated}, polygon(body, negated)).first->second;
}

RoughPose WedgeSearch::pose_now(const Bodies& bodies, Frame frame) {
  const Trajectory& pose = kernel_.derived().trajectory(bodies.pose);
  const double now = kernel_.coarse_now().value();
  const RoughPose rough_pose(pose, now, frame);
  if (!is_too_rough(rough_pose, rough(bodies.a, false), rough(bodies.b, true))) return rough_pose;
  return RoughPose::precise(pose, now, frame);
}

std::span<const Query> WedgeSearch::place(Wedge& wedge, const Bodies& bodies) {
  const RoughPose pose = pose_now(bodies, Frame::kA);
  const auto plan = plan_wedge(rough(bodies.a, false), rough(bodies.b, true), pose);
  if (!plan) return {};
  const Frame longer = plan->longer();
  for (const Frame line_of : {longer, longer == Frame::kA ? Frame::kB : Frame::kA}) {
    const auto queries = place(wedge, bodies, *plan, pose, line_of);
    if (!queries.empty()) return queries;
  }
  return {};
}

std::span<const Query> WedgeSearch::place(Wedge& wedge, const Bodies& bodies, const WedgePlan& plan,
                                          const RoughPose& in_a, Frame line_of) {
  const auto& [a, b, pose] = bodies;
  const auto found = separating_wedge(plan, line_of, {polygon(a, false), rough(a, false)},
                                      {polygon(b, true), rough(b, true)}, in_a);
  if (!found) return {};
  wedge.turn_ ^= 1;
  std::array<ObjectId, 4>& ids = wedge.objects_[wedge.turn_];
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
  const std::uint8_t z = line_of == Frame::kA ? 0 : 1;
  queries_ = {predicates_.side(z, {pose, ids[0], ids[3]}),
              predicates_.order_after(z, {pose, ids[0], ids[1]}),
              predicates_.order_before(z, {pose, ids[0], ids[2]})};
  const std::span<const Query> queries(queries_.data(), found->turns ? 3 : 1);
  for (const Query& query : queries) {
    if (kernel_.sign_after(query) != Sign::kPositive) {
      wedge.turn_ ^= 1;
      return {};
    }
  }
  const RoughPose placed = line_of == Frame::kA ? in_a : pose_now(bodies, line_of);
  wedge.line_of_ = line_of;
  wedge.separation_ = plan.separation;
  wedge.t_ = placed.t;
  wedge.c_ = placed.c;
  wedge.s_ = placed.s;
  wedge.error_ = placed.error_t + moving_reach(bodies, line_of) * placed.error_turn;
  return queries;
}

double WedgeSearch::moving_reach(const Bodies& bodies, Frame line_of) {
  const bool of_a = line_of == Frame::kA;
  return rough(of_a ? bodies.b : bodies.a, of_a).reach;
}

// The error of the doubles counts as displacement.
void WedgeSearch::measure(const Wedge& wedge, const Bodies& bodies) {
  const RoughPose pose = pose_now(bodies, wedge.line_of_);
  if (!pose.is_known()) return;
  const double moved = std::hypot(pose.t[0] - wedge.t_[0], pose.t[1] - wedge.t_[1]);
  const double turned =
      std::atan2(wedge.c_ * pose.s - wedge.s_ * pose.c, wedge.c_ * pose.c + wedge.s_ * pose.s);
  const double reach = moving_reach(bodies, wedge.line_of_);
  const double error = wedge.error_ + pose.error_t + reach * pose.error_turn;
  least_ = std::min(least_, (moved + reach * std::fabs(turned) + error) / wedge.separation_);
}

std::optional<std::int64_t> WedgeSearch::most_thousandths() const {
  if (!(least_ < 1e6)) return std::nullopt;
  return static_cast<std::int64_t>(std::ceil(std::min(1000 / least_, 1e15)));
}

std::size_t WedgeSearch::bytes() const {
  std::size_t total = 0;
  for (const auto& [key, polygon] : rough_) {
    total += sizeof(key) + sizeof(polygon) + polygon.vertices.capacity() * 2 * sizeof(double);
  }
  return total;
}

}  // namespace kinex
