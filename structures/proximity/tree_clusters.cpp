// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_clusters.h"

#include <algorithm>
#include <set>

namespace kinex {

void TreeClusters::clear() {
  for (auto& arcs : arcs_) arcs.clear();
  std::fill(cluster_of_.begin(), cluster_of_.end(), kNone);
  is_loose_.assign(is_loose_.size(), false);
  vertices_.clear();
  free_.clear();
  loose_.clear();
  linked_ = 0;
}

void TreeClusters::link(Item edge, Vertex u, Vertex v) {
  for (const auto& [here, there] : {std::pair(u, v), std::pair(v, u)}) {
    if (arcs_[here].empty()) ++linked_;
    arcs_[here].push_back({edge, there});
    loosen(here);
  }
}

void TreeClusters::cut(Item edge, Vertex u, Vertex v) {
  for (const Vertex here : {u, v}) {
    std::erase_if(arcs_[here], [edge](const Arc& arc) { return arc.edge == edge; });
    if (arcs_[here].empty()) --linked_;
  }
}

void TreeClusters::loosen(Vertex v) {
  if (is_loose_[v]) return;
  is_loose_[v] = true;
  loose_.push_back(v);
}

void TreeClusters::dissolve(Cluster cluster) {
  for (const Vertex v : vertices_[cluster]) {
    cluster_of_[v] = kNone;
    loosen(v);
  }
  vertices_[cluster].clear();
  free_.push_back(cluster);
}

TreeClusters::Cluster TreeClusters::fresh() {
  if (free_.empty()) {
    vertices_.emplace_back();
    return static_cast<Cluster>(vertices_.size() - 1);
  }
  const Cluster cluster = free_.back();
  free_.pop_back();
  return cluster;
}

std::vector<TreeClusters::Cluster> TreeClusters::gather(std::size_t size) {
  std::sort(loose_.begin(), loose_.end());
  std::vector<Cluster> result;
  struct Visit {
    Vertex vertex;
    std::size_t parent;  // in the list; of a root: its own place
    std::size_t below;   // vertices below it that are not cut off, and itself
  };
  std::vector<Visit> visits;
  for (const Vertex root : loose_) {
    if (!is_loose_[root]) continue;
    is_loose_[root] = false;
    if (arcs_[root].empty()) continue;
    visits.assign(1, {root, 0, 1});
    for (std::size_t i = 0; i < visits.size(); ++i) {
      for (const Arc& arc : arcs_[visits[i].vertex]) {
        if (!is_loose_[arc.other]) continue;
        is_loose_[arc.other] = false;
        visits.push_back({arc.other, i, 1});
      }
    }
    for (std::size_t i = visits.size(); i-- > 1;) {
      if (visits[i].below < size) visits[visits[i].parent].below += visits[i].below;
    }
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Vertex v = visits[i].vertex;
      const bool top = i == 0 || visits[i].below >= size;
      if (top) result.push_back(fresh());
      cluster_of_[v] = top ? result.back() : cluster_of_[visits[visits[i].parent].vertex];
      std::vector<Vertex>& members = vertices_[cluster_of_[v]];
      place_[v] = members.size();
      members.push_back(v);
    }
  }
  loose_.clear();
  return result;
}

std::string TreeClusters::defect() const {
  if (any_loose()) return "vertices that are to be in a cluster";
  std::size_t count = 0;
  for (Vertex v = 0; v < arcs_.size(); ++v) {
    if (arcs_[v].empty() != (cluster_of_[v] == kNone)) return "a vertex in no cluster";
    if (arcs_[v].empty()) continue;
    ++count;
    const auto& members = vertices_[cluster_of_[v]];
    if (place_[v] >= members.size() || members[place_[v]] != v) return "a vertex out of place";
  }
  if (count != linked_) return "a wrong number of vertices";
  for (const std::vector<Vertex>& members : vertices_) {
    if (members.empty()) continue;
    std::set<Vertex> seen{members.front()};
    std::vector<Vertex> left{members.front()};
    while (!left.empty()) {
      const Vertex v = left.back();
      left.pop_back();
      for (const Arc& arc : arcs_[v]) {
        if (of(arc.other) == of(v) && seen.insert(arc.other).second) left.push_back(arc.other);
      }
    }
    if (seen.size() != members.size()) return "a cluster that is not connected";
  }
  return "";
}

std::size_t TreeClusters::bytes() const {
  std::size_t total = cluster_of_.capacity() * sizeof(Cluster) +
                      place_.capacity() * sizeof(std::size_t) + is_loose_.capacity() / 8;
  for (const auto& arcs : arcs_) total += sizeof(arcs) + arcs.capacity() * sizeof(Arc);
  for (const auto& some : vertices_) total += sizeof(some) + some.capacity() * sizeof(Vertex);
  return total;
}

}  // namespace kinex
