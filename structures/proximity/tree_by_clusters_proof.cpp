// SPDX-License-Identifier: GPL-3.0-or-later
// What proves a tree by clusters: the longest edges within clusters and between them, and the bounds
// of the edges outside the tree. touch() takes it apart where the tree is about to change; mend()
// puts it together.
#include <algorithm>
#include <utility>

#include "structures/proximity/tree_by_clusters.h"

namespace kinex {

// ---- sizes

// The smallest z with z^3 >= n^2.
std::size_t TreeByClusters::size_now() const {
  if (size_ > 0) return size_;
  const std::size_t n = clusters_.linked();
  std::size_t z = 1;
  while (z * z * z < n * n) ++z;
  return z;
}

// Of a forest of n vertices, t of them roots, n / size + t after it was cut as a whole.
std::size_t TreeByClusters::most_clusters() const {
  const std::size_t n = clusters_.linked(), edges = tree_size();
  return 3 * (n / size_now() + 1) + (n - edges);
}

// ---- taking apart

void TreeByClusters::drop_between() {
  for (auto& [pair, between] : pairs_) {
    if (between.bound != EdgeExtrema::kNone) extrema_.drop(between.bound);
    between.bound = EdgeExtrema::kNone;
  }
  while (!between_nodes_.empty()) {
    extrema_.drop(between_nodes_.back());
    between_nodes_.pop_back();
  }
  for (auto& row : between_) std::fill(row.begin(), row.end(), Value{});
}

// The edges at a copy are about to change: dissolves its cluster.
void TreeByClusters::touch(Copy copy) {
  drop_between();
  const Cluster cluster = clusters_.of(copy);
  if (cluster == TreeClusters::kNone) return clusters_.loosen(copy);
  for (const Copy member : clusters_.members(cluster)) {
    for (const Item item : outside_at_[clusters_.vertex(member)]) {
      if (outside_[item].place != Place::kDone) continue;
      const auto [a, b] = outside_[item].ends;
      if (a != member && b != member) continue;
      unbind(item);
      outside_[item].place = Place::kWaits;
      waiting_.push_back(item);
    }
  }
  for (auto pair = pairs_.begin(); pair != pairs_.end();) {
    const bool its_own = pair->first[0] == cluster || pair->first[1] == cluster;
    if (its_own) pair->second.group.clear(extrema_);
    pair = its_own ? pairs_.erase(pair) : std::next(pair);
  }
  Interior& interior = interiors_[cluster];
  for (std::size_t i = interior.nodes.size(); i-- > 0;) extrema_.drop(interior.nodes[i]);
  interior = {};
  clusters_.dissolve(cluster);
}

// ---- putting together

void TreeByClusters::mend() {
  if (clusters_.any_loose()) {
    gather();
    find_ways();
    for (auto& [pair, between] : pairs_) {
      const Way &way = ways_[pair[0]][pair[1]], &back = ways_[pair[1]][pair[0]];
      if (between.out == way.out && between.into == back.out) continue;
      between.out = way.out;
      between.into = back.out;
      for (const Item item : between.group.edges()) {
        unbind(item);
        bind(item);
      }
    }
  }
  for (const Item item : std::exchange(waiting_, {})) {
    if (outside_[item].place != Place::kWaits) continue;
    outside_[item].place = Place::kDone;
    hang(item);
    bind(item);
    const Pair pair = pair_of(item);
    if (pair[0] == pair[1] || shares_vertex(pair)) continue;
    Between& between = pairs_[pair];
    between.out = ways_[pair[0]][pair[1]].out;
    between.into = ways_[pair[1]][pair[0]].out;
    if (between.bound != EdgeExtrema::kNone) extrema_.drop(between.bound);
    between.bound = EdgeExtrema::kNone;
    between.group.put_in(extrema_, item);
  }
  for (auto& [pair, between] : pairs_) {
    if (between.bound != EdgeExtrema::kNone) continue;
    between.bound = extrema_.make(EdgeExtrema::Kind::kBound, longest_between(pair[0], pair[1]),
                                  between.group.shortest());
  }
}

// Loose vertices are put in clusters; or all vertices, where there were too many clusters, or some
// that are too large for the vertices there are.
void TreeByClusters::gather() {
  const std::size_t size = size_now();
  largest_size_ = std::max(largest_size_, size);
  std::vector<Cluster> fresh = clusters_.gather(size);
  if (clusters_.count() > most_clusters() || largest_size_ > 2 * size) {
    for (const Cluster cluster : fresh) clusters_.dissolve(cluster);
    for (Cluster cluster = 0; cluster < clusters_.most(); ++cluster) {
      if (!clusters_.members(cluster).empty()) touch(clusters_.members(cluster).front());
    }
    fresh = clusters_.gather(size);
    largest_size_ = size;
  }
  widest_ = std::max(widest_, clusters_.count());
  interiors_.resize(clusters_.most());
  for (const Cluster cluster : fresh) make_interior(cluster);
}

// ---- within a cluster

TreeByClusters::Value TreeByClusters::longer(const Value& one, const Value& other,
                                             std::vector<Node>& nodes) {
  if (one.none()) return other;
  if (other.none()) return one;
  nodes.push_back(extrema_.make(EdgeExtrema::Kind::kLongest, one, other));
  return Value::of_node(nodes.back());
}

void TreeByClusters::make_interior(Cluster cluster) {
  Interior& interior = interiors_[cluster];
  const std::vector<Copy>& members = clusters_.members(cluster);
  struct Visit {
    Copy copy;
    Item from;  // the edge to it
  };
  for (const Copy portal : members) {
    const std::vector<Item>& edges = clusters_.edges(portal);
    if (clusters_.copies(clusters_.vertex(portal)).size() == 1 &&
        std::all_of(edges.begin(), edges.end(), [&](Item edge) {
          return clusters_.of(clusters_.other(edge, portal)) == cluster;
        })) {
      continue;
    }
    std::vector<Value> longest(members.size());
    std::vector<Visit> visits{{portal, kNoItem}};
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const auto [copy, from] = visits[i];
      for (const Item edge : clusters_.edges(copy)) {
        const Copy next = clusters_.other(edge, copy);
        if (edge == from || clusters_.of(next) != cluster) continue;
        longest[clusters_.place(next)] =
            longer(longest[clusters_.place(copy)], Value::of_edge(edge), interior.nodes);
        visits.push_back({next, edge});
      }
    }
    interior.portals.push_back(portal);
    interior.from_portal.push_back(std::move(longest));
  }
  make_centroids(cluster);
}

// A part of the cluster has a centroid: the parts that it leaves have at most half as many vertices.
void TreeByClusters::make_centroids(Cluster cluster) {
  Interior& interior = interiors_[cluster];
  const std::vector<Copy>& members = clusters_.members(cluster);
  interior.centroids.assign(members.size(), {});
  std::vector<bool> done(members.size(), false);  // as a centroid
  struct Visit {
    Copy copy;
    std::size_t parent;  // in the list
    std::size_t below;   // members below it in its part, and itself
    std::size_t most;    // of those below one child
    Value longest;
  };
  std::vector<Visit> visits;
  // The part of a member, from it on.
  const auto visit = [&](Copy start) {
    visits.assign(1, {start, 0, 1, 0, {}});
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Copy copy = visits[i].copy, parent = visits[visits[i].parent].copy;
      for (const Item edge : clusters_.edges(copy)) {
        const Copy next = clusters_.other(edge, copy);
        if (clusters_.of(next) != cluster || done[clusters_.place(next)]) continue;
        if (i > 0 && next == parent) continue;
        visits.push_back({next, i, 1, 0, Value::of_edge(edge)});
      }
    }
    for (std::size_t i = visits.size(); i-- > 1;) {
      Visit& parent = visits[visits[i].parent];
      parent.below += visits[i].below;
      parent.most = std::max(parent.most, visits[i].below);
    }
  };
  std::vector<Copy> left{members.front()};
  while (!left.empty()) {
    visit(left.back());
    left.pop_back();
    const std::size_t all = visits.size();
    const auto middle = std::find_if(visits.begin(), visits.end(), [all](const Visit& one) {
      return 2 * std::max(one.most, all - one.below) <= all;
    });
    const Copy centroid = middle->copy;
    visit(centroid);
    for (std::size_t i = 0; i < visits.size(); ++i) {
      Visit& one = visits[i];
      if (i > 0) one.longest = longer(visits[one.parent].longest, one.longest, interior.nodes);
      interior.centroids[clusters_.place(one.copy)].push_back({centroid, one.longest});
      if (i > 0 && one.parent == 0) left.push_back(one.copy);
    }
    done[clusters_.place(centroid)] = true;
  }
}

const TreeByClusters::Value& TreeByClusters::from_portal(Cluster cluster, Copy portal,
                                                         Copy copy) const {
  const Interior& interior = interiors_[cluster];
  const auto found = std::find(interior.portals.begin(), interior.portals.end(), portal);
  return interior.from_portal[static_cast<std::size_t>(found - interior.portals.begin())]
                             [clusters_.place(copy)];
}

// ---- between clusters

// From a portal one step leads along each of its edges, and to each other copy of its vertex.
void TreeByClusters::find_ways() {
  const std::size_t most = clusters_.most();
  ways_.assign(most, std::vector<Way>(most));
  between_.assign(most, std::vector<Value>(most));
  for (Cluster start = 0; start < most; ++start) {
    if (clusters_.members(start).empty()) continue;
    std::vector<Cluster> reached{start};
    const auto step = [&](Cluster here, Copy portal, Copy into, Item edge) {
      const Cluster there = clusters_.of(into);
      Way& way = ways_[start][there];
      if (there == here || there == start || way.before != TreeClusters::kNone) return;
      way = {here == start ? portal : ways_[start][here].out, into, here, portal, edge};
      reached.push_back(there);
    };
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Cluster here = reached[i];
      const Way way = ways_[start][here];
      for (const Copy portal : interiors_[here].portals) {
        for (const Item edge : clusters_.edges(portal)) {
          step(here, portal, clusters_.other(edge, portal), edge);
        }
        // Where a copy was entered from another one, all of them are reached.
        if (i > 0 && way.edge == kNoItem && way.into == portal) continue;
        for (const Copy copy : clusters_.copies(clusters_.vertex(portal))) {
          step(here, portal, copy, kNoItem);
        }
      }
    }
  }
}

bool TreeByClusters::shares_vertex(const Pair& pair) const {
  const Way& way = ways_[pair[0]][pair[1]];
  return way.before == pair[0] && way.edge == kNoItem;
}

// W(a, b); none if they share a vertex.
TreeByClusters::Value TreeByClusters::longest_between(Cluster a, Cluster b) {
  if (!between_[a][b].none()) return between_[a][b];
  const Way& way = ways_[a][b];
  Value longest;
  if (way.before != a) {
    const Vertex entered = ways_[a][way.before].into;
    longest = longest_between(a, way.before);
    if (entered != way.across) {
      longest = longer(longest, from_portal(way.before, entered, way.across), between_nodes_);
    }
  }
  return between_[a][b] = longer(longest, Value::of_edge(way.edge), between_nodes_);
}

// ---- edges outside the tree

// Chooses the copies of its ends.
void TreeByClusters::hang(Item item) {
  const auto [u, v] = edges_->ends(item);
  const std::vector<Copy>&from = clusters_.copies(u), &to = clusters_.copies(v);
  for (const Copy a : from) {
    for (const Copy b : to) {
      if (clusters_.of(a) != clusters_.of(b)) continue;
      outside_[item].ends = {a, b};
      return;
    }
  }
  outside_[item].ends = {from[item % from.size()], to[item % to.size()]};
}

// The longest edges of the two pieces of its path that are its own; they may be none.
std::array<TreeByClusters::Value, 2> TreeByClusters::ends_of(Item item) const {
  const auto [u, v] = outside_[item].ends;
  const Cluster a = clusters_.of(u), b = clusters_.of(v);
  if (a != b) return {from_portal(a, ways_[a][b].out, u), from_portal(b, ways_[b][a].out, v)};
  const auto& one = interiors_[a].centroids[clusters_.place(u)];
  const auto& other = interiors_[a].centroids[clusters_.place(v)];
  std::size_t last = 0;  // that they have in common
  while (last + 1 < std::min(one.size(), other.size()) &&
         one[last + 1].centroid == other[last + 1].centroid) {
    ++last;
  }
  return {one[last].longest, other[last].longest};
}

void TreeByClusters::bind(Item item) {
  for (const Value& longest : ends_of(item)) {
    if (longest.none()) continue;
    outside_[item].bounds.push_back(
        extrema_.make(EdgeExtrema::Kind::kBound, longest, Value::of_edge(item)));
  }
}

}  // namespace kinex
