// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/hull_ring.h"

#include <algorithm>

namespace kinex {

std::vector<ObjectId> HullRing::cycle() const {
  std::vector<ObjectId> result;
  result.reserve(size_);
  ObjectId vertex = any_;
  for (std::size_t i = 0; i < size_; ++i, vertex = links_[vertex].next) result.push_back(vertex);
  start_at_smallest(result);
  return result;
}

bool HullRing::assign(std::span<const ObjectId> cycle) {
  std::vector<ObjectId> sorted(cycle.begin(), cycle.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  ObjectId vertex = any_;
  for (std::size_t i = 0; i < size_; ++i) {
    const ObjectId next = links_[vertex].next;
    links_[vertex] = {};
    vertex = next;
  }
  if (!sorted.empty() && sorted.back() >= links_.size()) {
    links_.resize(std::size_t{sorted.back()} + 1);
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    link(cycle[i], cycle[i + 1 == cycle.size() ? 0 : i + 1]);
  }
  size_ = cycle.size();
  any_ = cycle.empty() ? kNoObject : cycle.front();
  return true;
}

bool HullRing::enter(ObjectId vertex, ObjectId from, ObjectId to) {
  if (size_ < 2 || vertex == kNoObject || has(vertex)) return false;
  if (!has(from) || next(from) != to) return false;
  if (vertex >= links_.size()) links_.resize(std::size_t{vertex} + 1);
  link(from, vertex);
  link(vertex, to);
  ++size_;
  return true;
}

bool HullRing::leave(ObjectId vertex, ObjectId from, ObjectId to) {
  if (size_ < 3 || !has(vertex)) return false;
  if (previous(vertex) != from || next(vertex) != to) return false;
  links_[vertex] = {};
  link(from, to);
  --size_;
  if (any_ == vertex) any_ = from;
  return true;
}

}  // namespace kinex
