// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/object_sets.h"

#include <algorithm>

namespace kinex {

ObjectId query_of(const Request& request) { return request.query == kNoObject ? 0 : request.query; }

Subset sites_of(const StructureInfo& info, const Request& request, const Scene& scene) {
  if (info.colours && !request.colours.empty()) {
    return {Subset::Kind::kColours, {}, request.colours};
  }
  Subset result = request.of;
  if (!info.query || info.query_is_site || scene.objects.empty()) return result;
  const ObjectId query = query_of(request);
  if (result.kind == Subset::Kind::kAll) result.kind = Subset::Kind::kAllBut;
  if (result.kind != Subset::Kind::kAllBut) return result;
  const auto place = std::lower_bound(result.objects.begin(), result.objects.end(), query);
  if (place == result.objects.end() || *place != query) result.objects.insert(place, query);
  return result;
}

std::vector<bool> members_of(const StructureInfo& info, const Request& request,
                             const Scene& scene) {
  if (info.query && request.of.kind == Subset::Kind::kAll) return {};
  std::vector<bool> result = scene.members(sites_of(info, request, scene));
  if (info.lines == LineUse::kAlone) {
    result.resize(scene.objects.size(), true);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] && scene.objects[i].line;
  }
  if (info.query && !result.empty()) result[query_of(request)] = true;
  return result;
}

TwoClasses::TwoClasses(const Request& request, const Scene& scene)
    : class_(scene.objects.size(), kNone) {
  for (std::size_t i = 0; i < class_.size(); ++i) {
    if (request.colours.empty()) class_[i] = i % 2;
    for (std::uint8_t which = 0; which < request.colours.size(); ++which) {
      if (scene.objects[i].colour == request.colours[which]) class_[i] = which;
    }
    if (class_[i] < kNone) ++sizes_[class_[i]];
  }
}

}  // namespace kinex
