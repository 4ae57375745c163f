// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/key_order.h"

#include <algorithm>
#include <stdexcept>

#include "predicates/predicates.h"

namespace kinex {
namespace {

const Key& checked(const Key& key, const Scene& scene) {
  const std::size_t dimension = static_cast<std::size_t>(scene.dimension);
  switch (key.kind) {
    case Key::Kind::kCoordinate:
      if (key.axis >= 0 && key.axis < scene.dimension) return key;
      throw std::invalid_argument("the scene has no axis number " + std::to_string(key.axis));
    case Key::Kind::kDirection:
      if (key.direction.size() == dimension) return key;
      throw std::invalid_argument("a key's direction needs one entry per axis of the scene");
    case Key::Kind::kSquaredDistance:
      if (key.object < scene.objects.size()) return key;
      throw std::invalid_argument(
          "a key's squared distance is to an object that is not in the scene");
  }
  throw std::invalid_argument("unknown kind of key");
}

}  // namespace

KeyOrder::KeyOrder(Kernel& kernel, const Key& key, const Scene& scene)
    : kernel_(&kernel),
      key_(checked(key, scene)),
      reference_(key.kind == Key::Kind::kSquaredDistance ? key.object : kNoObject),
      formula_(make_key_order(key, scene.dimension)),
      predicate_(kernel.bind(formula_)) {}

std::vector<ObjectId> KeyOrder::members(std::span<const ObjectId> objects) const {
  std::vector<ObjectId> result(objects.begin(), objects.end());
  if (reference_ == kNoObject) return result;
  const auto place = std::find(result.begin(), result.end(), reference_);
  if (place == result.end()) {
    throw std::invalid_argument(
        "the object that a key's squared distances are measured to is not there at the start");
  }
  result.erase(place);
  return result;
}

void KeyOrder::check_erasure(ObjectId object) const {
  if (object != reference_) return;
  throw std::invalid_argument(
      "the object that a key's squared distances are measured to cannot be erased (or jump)");
}

std::vector<int> KeyOrder::member_pieces(const BoundContext& context) const {
  std::vector<int> pieces = context.pieces;
  if (reference_ != kNoObject)
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(context.place(reference_)));
  return pieces;
}

int KeyOrder::reference_pieces(const BoundContext& context) const {
  return reference_ == kNoObject ? 1 : context.pieces[context.place(reference_)];
}

}  // namespace kinex
