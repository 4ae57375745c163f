// SPDX-License-Identifier: GPL-3.0-or-later
// The order of two objects under a key, as a predicate.
#include <stdexcept>

#include "predicates/predicates.h"

namespace kinex {

std::shared_ptr<const Predicate> make_key_order(const Key& key, int dimension) {
  switch (key.kind) {
    case Key::Kind::kCoordinate: return make_coordinate_order(key.axis);
    case Key::Kind::kDirection: return make_direction_order(key.direction);
    case Key::Kind::kSquaredDistance: return make_squared_distance_order(dimension);
  }
  throw std::invalid_argument("unknown kind of key");
}

}  // namespace kinex
