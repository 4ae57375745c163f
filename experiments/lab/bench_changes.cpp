// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_changes.h"

namespace kinex::lab {

namespace {

// The finalizer of splitmix64.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash += 0x9e3779b97f4a7c15 + word;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
  return hash ^ (hash >> 31);
}

}  // namespace

void ChangesDigest::event(const Event& event, Arithmetic&) {
  if (!event.external) return;
  std::uint64_t hash = mixed(event.structure, event.kind);
  const auto add = [&hash](std::span<const ObjectId> ids) {
    hash = mixed(hash, ids.size());
    for (const ObjectId id : ids) hash = mixed(hash, id);
  };
  add({event.ids.data(), event.count});
  add(event.gone);
  add(event.came);
  sum_ += hash;
}

}  // namespace kinex::lab
