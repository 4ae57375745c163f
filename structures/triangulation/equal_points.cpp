// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/equal_points.h"

#include <algorithm>
#include <string>
#include <utility>

namespace kinex {

void EqualPoints::set_present(std::span<const ObjectId> objects) {
  std::fill(present_.begin(), present_.end(), false);
  for (const ObjectId id : objects) present_[id] = true;
}

std::vector<ObjectId> EqualPoints::members() const {
  std::vector<ObjectId> result;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    if (present_[id]) result.push_back(id);
  }
  return result;
}

void EqualPoints::reset() {
  std::fill(vertex_of_.begin(), vertex_of_.end(), kNoObject);
  if (!hidden_.empty()) ++hidden_changes_;
  hidden_.clear();
}

void EqualPoints::hide(ObjectId object, ObjectId vertex) {
  std::vector<ObjectId> hidden = reveal_behind(object);
  hidden.push_back(object);
  ++hidden_changes_;
  std::vector<ObjectId>& list = hidden_[vertex];
  for (const ObjectId v : hidden) {
    vertex_of_[v] = vertex;
    list.insert(std::lower_bound(list.begin(), list.end(), v), v);
  }
}

void EqualPoints::reveal(ObjectId object) {
  const auto it = hidden_.find(vertex_of_[object]);
  std::vector<ObjectId>& list = it->second;
  list.erase(std::lower_bound(list.begin(), list.end(), object));
  if (list.empty()) hidden_.erase(it);
  vertex_of_[object] = kNoObject;
  ++hidden_changes_;
}

std::vector<ObjectId> EqualPoints::reveal_behind(ObjectId vertex) {
  const auto it = hidden_.find(vertex);
  if (it == hidden_.end()) return {};
  ++hidden_changes_;
  std::vector<ObjectId> revealed = std::move(it->second);
  hidden_.erase(it);
  for (const ObjectId v : revealed) vertex_of_[v] = kNoObject;
  return revealed;
}

std::size_t EqualPoints::check(AuditReport& report,
                               const std::function<bool(ObjectId)>& known) const {
  std::size_t vertices = 0;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    const auto text = [id](const char* what) { return "object " + std::to_string(id) + what; };
    const ObjectId vertex = vertex_of_[id];
    if (!present_[id]) {
      report.check(vertex == kNoObject && !known(id),
                   [&] { return text(" is gone but still known"); });
    } else if (vertex == id) {
      ++vertices;
    } else {
      const auto it = hidden_.find(vertex);
      report.check(vertex < id && is_vertex(vertex) && it != hidden_.end() &&
                       std::binary_search(it->second.begin(), it->second.end(), id),
                   [&] { return text(" is hidden behind no vertex"); });
    }
  }
  return vertices;
}

}  // namespace kinex
