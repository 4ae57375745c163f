// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/pose_predicates.h"

#include <algorithm>

#include "core/numbers/check.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {
namespace {

bool is_in(const std::array<PredicateId, 2>& ids, const Query& query) {
  return std::find(ids.begin(), ids.end(), query.predicate) != ids.end();
}

}  // namespace

// Predicates are bound in the order in which ties leave the queue: a side that fails at a touch too
// comes where the plain side would.
PosePredicates::PosePredicates(Kernel& kernel) {
  const std::array<Frame, 2> frames{Frame::kA, Frame::kB};
  for (std::size_t z = 0; z < 2; ++z) {
    side_[z] = kernel.bind(make_pose_side(frames[z], false));
    touch_[z] = kernel.bind(make_pose_touch(frames[z], false));
  }
  for (std::size_t z = 0; z < 2; ++z) {
    inside_[z] = kernel.bind(make_pose_side(frames[z], true));
    touch_inside_[z] = kernel.bind(make_pose_touch(frames[z], true));
  }
  for (std::size_t z = 0; z < 2; ++z) along_[z] = kernel.bind(make_pose_along(frames[z]));
  for (const bool reversed : {false, true}) {
    order_[reversed] = kernel.bind(make_pose_normal_order(reversed));
    order_touch_[reversed] = kernel.bind(make_pose_order_touch(reversed));
  }
  for (std::size_t z = 0; z < 2; ++z) {
    along_touch_[z] = kernel.bind(make_pose_along_touch(frames[z], false));
    against_touch_[z] = kernel.bind(make_pose_along_touch(frames[z], true));
  }
}

Query PosePredicates::at_touch(Query query) const {
  for (std::size_t z = 0; z < 2; ++z) {
    if (query.predicate == side_[z]) return query.predicate = touch_[z], query;
    if (query.predicate == inside_[z]) return query.predicate = touch_inside_[z], query;
    if (query.predicate == order_[z]) return query.predicate = order_touch_[z], query;
  }
  require(false, "a query that has no form that fails at touches");
  return query;
}

Query PosePredicates::along_at_touch(Query along, bool against) const {
  const std::size_t z = along.predicate == along_[0] ? 0 : 1;
  along.predicate = (against ? against_touch_ : along_touch_)[z];
  return along;
}

bool PosePredicates::is_about_side(const Query& query) const {
  return is_in(side_, query) || is_in(inside_, query) || is_in(touch_, query) ||
         is_in(touch_inside_, query);
}

bool PosePredicates::is_about_end(const Query& query) const {
  return is_in(along_touch_, query) || is_in(against_touch_, query);
}

std::uint64_t PosePredicates::signs_asked(const Kernel& kernel) const {
  std::uint64_t sum = 0;
  for (const ByFrame* ids : {&side_, &inside_, &along_, &touch_, &touch_inside_, &along_touch_,
                             &against_touch_, &order_, &order_touch_}) {
    for (const PredicateId id : *ids) sum += kernel.signs_asked(id);
  }
  return sum;
}

}  // namespace kinex
