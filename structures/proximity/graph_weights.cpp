// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/graph_weights.h"

#include <map>
#include <string>

#include "predicates/predicates.h"

namespace kinex {

GraphWeights::GraphWeights(Kernel& kernel, const Scene& scene)
    : order_(kernel.bind(make_coordinate_order(0))) {
  std::map<std::string, std::uint32_t> number;
  for (const SceneObject& object : scene.objects) {
    auto& ends = ends_.emplace_back();
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const auto next = static_cast<std::uint32_t>(number.size());
      ends[i] = number.try_emplace(object.ends.at(i), next).first->second;
    }
  }
  vertices_ = number.size();
}

}  // namespace kinex
