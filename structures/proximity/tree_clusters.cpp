// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_clusters.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace kinex {

TreeClusters::TreeClusters(std::size_t vertices) : copies_(vertices) { clear(); }

void TreeClusters::clear() {
  const std::size_t vertices = copies_.size();
  edges_.assign(vertices, {});
  vertex_of_.resize(vertices);
  std::iota(vertex_of_.begin(), vertex_of_.end(), Vertex{0});
  cluster_of_.assign(vertices, kNone);
  place_.assign(vertices, 0);
  is_loose_.assign(vertices, false);
  for (auto& copies : copies_) copies.clear();
  degrees_.assign(vertices, 0);
  ends_.clear();
  members_.clear();
  free_.clear();
  unused_.clear();
  loose_.clear();
  linked_ = 0;
}

// ---- edges

TreeClusters::Copy TreeClusters::hook(Vertex v) {
  std::vector<Copy>& copies = copies_[v];
  if (copies.empty()) copies.push_back(v);
  const auto loose = std::find_if(copies.begin(), copies.end(),
                                  [this](Copy copy) { return cluster_of_[copy] == kNone; });
  return loose == copies.end() ? copies.front() : *loose;
}

void TreeClusters::link(Item edge, Copy a, Copy b) {
  if (ends_.size() <= edge) ends_.resize(edge + std::size_t{1});
  ends_[edge] = {a, b};
  for (const Copy end : {a, b}) {
    edges_[end].push_back(edge);
    if (degrees_[vertex_of_[end]]++ == 0) ++linked_;
    loosen(end);
  }
}

void TreeClusters::cut(Item edge) {
  for (const Copy end : ends_[edge]) {
    std::erase(edges_[end], edge);
    if (--degrees_[vertex_of_[end]] == 0) --linked_;
  }
}

// The end of an edge becomes that at another copy of its vertex; the first one lists it still.
void TreeClusters::hang(Item edge, Copy from, Copy to) {
  ends_[edge][ends_[edge][0] == from ? 0 : 1] = to;
  edges_[to].push_back(edge);
}

// ---- clusters

void TreeClusters::loosen(Copy copy) {
  if (is_loose_[copy]) return;
  is_loose_[copy] = true;
  loose_.push_back(copy);
}

void TreeClusters::dissolve(Cluster cluster) {
  for (const Copy copy : members_[cluster]) {
    cluster_of_[copy] = kNone;
    loosen(copy);
  }
  members_[cluster].clear();
  free_.push_back(cluster);
}

TreeClusters::Cluster TreeClusters::fresh() {
  if (free_.empty()) {
    members_.emplace_back();
    return static_cast<Cluster>(members_.size() - 1);
  }
  const Cluster cluster = free_.back();
  free_.pop_back();
  return cluster;
}

// Another copy.
TreeClusters::Copy TreeClusters::copy_of(Vertex v) {
  if (unused_.empty()) {
    unused_.push_back(static_cast<Copy>(vertex_of_.size()));
    edges_.emplace_back();
    vertex_of_.push_back(v);
    cluster_of_.push_back(kNone);
    place_.push_back(0);
    is_loose_.push_back(false);
  }
  const Copy copy = unused_.back();
  unused_.pop_back();
  vertex_of_[copy] = v;
  std::vector<Copy>& copies = copies_[v];
  copies.insert(std::lower_bound(copies.begin(), copies.end(), copy), copy);
  return copy;
}

void TreeClusters::put(Copy copy, Cluster cluster) {
  cluster_of_[copy] = cluster;
  place_[copy] = members_[cluster].size();
  members_[cluster].push_back(copy);
}

// Of the loose copies of a vertex one is left, or none if they have no edges.
void TreeClusters::merge() {
  std::sort(loose_.begin(), loose_.end());
  for (const Copy copy : loose_) {
    std::vector<Copy>& copies = copies_[vertex_of_[copy]];
    const Copy first =
        *std::find_if(copies.begin(), copies.end(), [this](Copy one) { return is_loose_[one]; });
    if (first != copy) {
      for (const Item edge : edges_[copy]) hang(edge, copy, first);
      edges_[copy].clear();
    }
    if (!edges_[copy].empty()) continue;
    is_loose_[copy] = false;
    std::erase(copies, copy);
    if (copy >= copies_.size()) unused_.push_back(copy);
  }
}

// The loose copies of a tree, each before those below it.
void TreeClusters::visit(Copy root) {
  visits_.assign(1, {root, kNoItem, root, 0, 0, 1, 0});
  is_loose_[root] = false;
  for (std::size_t i = 0; i < visits_.size(); ++i) {
    const Copy copy = visits_[i].copy;
    visits_[i].first = visits_.size();
    for (const Item edge : edges_[copy]) {
      const Copy below = other(edge, copy);
      if (!is_loose_[below]) continue;
      is_loose_[below] = false;
      visits_.push_back({below, edge, copy, 0, 0, 1, 0});
    }
    visits_[i].last = visits_.size();
  }
}

// Decides which of its children go to copies.
void TreeClusters::share(Visit& parent, std::size_t size) {
  for (std::size_t i = parent.first; i < parent.last; ++i) {
    if (visits_[i].below < size) parent.below += visits_[i].below;
  }
  std::size_t group = 0, in_group = 0;
  for (std::size_t i = parent.first; i < parent.last; ++i) {
    Visit& child = visits_[i];
    if (in_group == 0 && parent.below < 2 * size) return;
    if (child.below >= size) continue;
    if (in_group == 0) ++group;
    child.group = group;
    in_group += child.below;
    parent.below -= child.below;
    if (in_group >= size) in_group = 0;
  }
}

// Makes these copies, and a cluster for each.
void TreeClusters::split(const Visit& parent, std::vector<Cluster>& result) {
  std::size_t group = 0;
  Copy copy = parent.copy;
  for (std::size_t i = parent.first; i < parent.last; ++i) {
    Visit& child = visits_[i];
    if (child.group == 0) continue;
    if (child.group != group) {
      group = child.group;
      copy = copy_of(vertex_of_[parent.copy]);
      result.push_back(fresh());
      put(copy, result.back());
    }
    hang(child.from, parent.copy, copy);
    child.above = copy;
  }
  if (group == 0) return;
  std::erase_if(edges_[parent.copy], [&](Item edge) {
    return ends_[edge][0] != parent.copy && ends_[edge][1] != parent.copy;
  });
}

std::vector<TreeClusters::Cluster> TreeClusters::gather(std::size_t size) {
  merge();
  std::vector<Cluster> result;
  for (const Copy root : loose_) {
    if (!is_loose_[root]) continue;
    visit(root);
    for (std::size_t i = visits_.size(); i-- > 0;) share(visits_[i], size);
    for (std::size_t i = 0; i < visits_.size(); ++i) {
      const Visit& one = visits_[i];
      const bool top = i == 0 || one.below >= size;
      if (top) result.push_back(fresh());
      put(one.copy, top ? result.back() : cluster_of_[one.above]);
      split(one, result);
    }
  }
  loose_.clear();
  return result;
}

std::size_t TreeClusters::largest() const {
  std::size_t result = 0;
  for (const std::vector<Copy>& members : members_) result = std::max(result, members.size());
  return result;
}

// ---- checks

std::string TreeClusters::defect_of(Vertex v) const {
  std::set<Cluster> seen;
  std::size_t degree = 0;
  for (const Copy copy : copies_[v]) {
    degree += edges_[copy].size();
    if (vertex_of_[copy] != v) return "a copy of another vertex";
    if (edges_[copy].empty()) return "a copy without edges";
    const Cluster cluster = cluster_of_[copy];
    if (cluster == kNone) return "a vertex in no cluster";
    if (!seen.insert(cluster).second) return "two copies of a vertex in one cluster";
    const std::vector<Copy>& members = members_[cluster];
    if (place_[copy] >= members.size() || members[place_[copy]] != copy) {
      return "a vertex out of place";
    }
    for (const Item edge : edges_[copy]) {
      if (ends_[edge][0] != copy && ends_[edge][1] != copy) return "an edge at the wrong copy";
    }
  }
  return degree == degrees_[v] ? "" : "a wrong number of edges";
}

std::string TreeClusters::defect_in(Cluster cluster) const {
  const std::vector<Copy>& members = members_[cluster];
  std::set<Copy> seen{members.front()};
  std::vector<Copy> left{members.front()};
  while (!left.empty()) {
    const Copy copy = left.back();
    left.pop_back();
    for (const Item edge : edges_[copy]) {
      const Copy next = other(edge, copy);
      if (of(next) == cluster && seen.insert(next).second) left.push_back(next);
    }
  }
  return seen.size() == members.size() ? "" : "a cluster that is not connected";
}

std::string TreeClusters::defect() const {
  if (any_loose()) return "vertices that are to be in a cluster";
  std::size_t linked = 0, copies = 0, members = 0;
  for (Vertex v = 0; v < copies_.size(); ++v) {
    if (const std::string found = defect_of(v); !found.empty()) return found;
    copies += copies_[v].size();
    if (!copies_[v].empty()) ++linked;
  }
  if (linked != linked_) return "a wrong number of vertices";
  for (Cluster cluster = 0; cluster < members_.size(); ++cluster) {
    if (members_[cluster].empty()) continue;
    members += members_[cluster].size();
    if (const std::string found = defect_in(cluster); !found.empty()) return found;
  }
  return members == copies ? "" : "a cluster with a copy that is none";
}

std::size_t TreeClusters::bytes() const {
  std::size_t total =
      (vertex_of_.capacity() + unused_.capacity() + loose_.capacity()) * sizeof(Copy) +
      (cluster_of_.capacity() + free_.capacity()) * sizeof(Cluster) +
      (place_.capacity() + degrees_.capacity()) * sizeof(std::size_t) + is_loose_.capacity() / 8 +
      ends_.capacity() * sizeof(ends_[0]) + visits_.capacity() * sizeof(Visit);
  for (const auto& some : edges_) total += sizeof(some) + some.capacity() * sizeof(Item);
  for (const auto& some : copies_) total += sizeof(some) + some.capacity() * sizeof(Copy);
  for (const auto& some : members_) total += sizeof(some) + some.capacity() * sizeof(Copy);
  return total;
}

}  // namespace kinex
