// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/turned_order.h"

#include "predicates/predicates.h"

namespace kinex {

PredicateId bind_order_along(Kernel& kernel, const std::array<int, 2>& direction) {
  const auto [u, v] = direction;
  if (v == 0) return kernel.bind(make_coordinate_order(0));
  if (u == 0) return kernel.bind(make_coordinate_order(1));
  return kernel.bind(make_direction_order({u, v}));
}

TurnedOrder::Key TurnedOrder::key(const std::array<int, 2>& direction) const {
  const auto [u, v] = direction;
  const bool descends = u < 0 || (u == 0 && v < 0);
  const int sign = descends ? -1 : 1;
  return {bind_order_along(*kernel_, {sign * u, sign * v}), descends};
}

TurnedOrder::TurnedOrder(Kernel& kernel, const std::array<int, 2>& direction)
    : kernel_(&kernel), first_(key(direction)), second_(key({direction[1], -direction[0]})) {}

Query TurnedOrder::claim(Item a, Item b) const {
  const Query first = first_.claim(a, b);
  return kernel_->sign_after(first) != Sign::kZero ? first : second_.claim(a, b);
}

bool in_front(Kernel& kernel, const TurnedOrder& order, Item a, Item b) {
  Sign sign = kernel.sign_after(order.by_first_key(a, b));
  if (sign == Sign::kZero) sign = kernel.sign_after(order.by_second_key(a, b));
  return sign == Sign::kPositive || (sign == Sign::kZero && order.goes_first(a, b));
}

}  // namespace kinex
