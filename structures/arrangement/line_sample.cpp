// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_sample.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kinex {
namespace {

// Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::size_t cube_root(std::size_t n) {
  std::size_t root = 0;
  while (root * root * root < n) ++root;
  return root;
}

}  // namespace

Subset sample_of_lines(const Subset& of, const Scene& scene, std::size_t size) {
  const std::vector<bool> members = scene.members(of);
  std::vector<std::pair<std::uint64_t, ObjectId>> lines;
  for (ObjectId object = 0; object < scene.objects.size(); ++object) {
    if (!scene.objects[object].line || (!members.empty() && !members[object])) continue;
    lines.emplace_back(mixed(object), object);
  }
  std::sort(lines.begin(), lines.end());
  lines.resize(size == 0 ? cube_root(lines.size()) : std::min(size, lines.size()));
  Subset result{Subset::Kind::kObjects, {}, {}};
  for (const auto& [random, line] : lines) result.objects.push_back(line);
  std::sort(result.objects.begin(), result.objects.end());
  return result;
}

}  // namespace kinex
