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

// The edges at a vertex are about to change: dissolves its cluster.
void TreeByClusters::touch(Vertex v) {
  drop_between();
  const Cluster cluster = clusters_.of(v);
  if (cluster == TreeClusters::kNone) return clusters_.loosen(v);
  for (const Vertex u : clusters_.vertices(cluster)) {
    for (const Item item : outside_at_[u]) {
      if (outside_[item].place != Place::kDone) continue;
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
    bind(item);
    const Pair pair = pair_of(item);
    if (pair[0] == pair[1]) continue;
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

// Loose vertices are put in clusters, or all vertices where there were too many.
void TreeByClusters::gather() {
  std::vector<Cluster> fresh = clusters_.gather(size_now());
  if (clusters_.count() > most_clusters()) {
    for (const Cluster cluster : fresh) clusters_.dissolve(cluster);
    for (Cluster cluster = 0; cluster < clusters_.most(); ++cluster) {
      if (!clusters_.vertices(cluster).empty()) touch(clusters_.vertices(cluster).front());
    }
    fresh = clusters_.gather(size_now());
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
  const std::vector<Vertex>& vertices = clusters_.vertices(cluster);
  struct Visit {
    Vertex vertex;
    Item from;  // the edge to it
  };
  for (const Vertex portal : vertices) {
    const auto& arcs = clusters_.arcs(portal);
    if (std::all_of(arcs.begin(), arcs.end(), [&](const TreeClusters::Arc& arc) {
          return clusters_.of(arc.other) == cluster;
        })) {
      continue;
    }
    std::vector<Value> longest(vertices.size());
    std::vector<Visit> visits{{portal, kNoItem}};
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const auto [v, from] = visits[i];
      for (const TreeClusters::Arc& arc : clusters_.arcs(v)) {
        if (arc.edge == from || clusters_.of(arc.other) != cluster) continue;
        longest[clusters_.place(arc.other)] = longer(longest[clusters_.place(v)],
                                                     Value::of_edge(arc.edge), interior.nodes);
        visits.push_back({arc.other, arc.edge});
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
  const std::vector<Vertex>& vertices = clusters_.vertices(cluster);
  interior.centroids.assign(vertices.size(), {});
  std::vector<bool> done(vertices.size(), false);  // as a centroid
  struct Visit {
    Vertex vertex;
    std::size_t parent;  // in the list
    std::size_t below;   // vertices below it in its part, and itself
    std::size_t most;    // of those below one child
    Value longest;
  };
  std::vector<Visit> visits;
  // The part of a vertex, from it on.
  const auto visit = [&](Vertex start) {
    visits.assign(1, {start, 0, 1, 0, {}});
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Vertex v = visits[i].vertex, parent = visits[visits[i].parent].vertex;
      for (const TreeClusters::Arc& arc : clusters_.arcs(v)) {
        if (clusters_.of(arc.other) != cluster || done[clusters_.place(arc.other)]) continue;
        if (i > 0 && arc.other == parent) continue;
        visits.push_back({arc.other, i, 1, 0, Value::of_edge(arc.edge)});
      }
    }
    for (std::size_t i = visits.size(); i-- > 1;) {
      Visit& parent = visits[visits[i].parent];
      parent.below += visits[i].below;
      parent.most = std::max(parent.most, visits[i].below);
    }
  };
  std::vector<Vertex> left{vertices.front()};
  while (!left.empty()) {
    visit(left.back());
    left.pop_back();
    const std::size_t all = visits.size();
    const auto middle = std::find_if(visits.begin(), visits.end(), [all](const Visit& one) {
      return 2 * std::max(one.most, all - one.below) <= all;
    });
    const Vertex centroid = middle->vertex;
    visit(centroid);
    for (std::size_t i = 0; i < visits.size(); ++i) {
      Visit& one = visits[i];
      if (i > 0) one.longest = longer(visits[one.parent].longest, one.longest, interior.nodes);
      interior.centroids[clusters_.place(one.vertex)].push_back({centroid, one.longest});
      if (i > 0 && one.parent == 0) left.push_back(one.vertex);
    }
    done[clusters_.place(centroid)] = true;
  }
}

const TreeByClusters::Value& TreeByClusters::from_portal(Cluster cluster, Vertex portal,
                                                         Vertex v) const {
  const Interior& interior = interiors_[cluster];
  const auto found = std::find(interior.portals.begin(), interior.portals.end(), portal);
  return interior.from_portal[static_cast<std::size_t>(found - interior.portals.begin())]
                             [clusters_.place(v)];
}

// ---- between clusters

void TreeByClusters::find_ways() {
  const std::size_t most = clusters_.most();
  ways_.assign(most, std::vector<Way>(most));
  between_.assign(most, std::vector<Value>(most));
  for (Cluster start = 0; start < most; ++start) {
    if (clusters_.vertices(start).empty()) continue;
    std::vector<Cluster> reached{start};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Cluster here = reached[i];
      for (const Vertex portal : interiors_[here].portals) {
        for (const TreeClusters::Arc& arc : clusters_.arcs(portal)) {
          const Cluster there = clusters_.of(arc.other);
          if (there == here || there == start || there == ways_[start][here].before) continue;
          const Vertex out = here == start ? portal : ways_[start][here].out;
          ways_[start][there] = {out, arc.other, here, portal, arc.edge};
          reached.push_back(there);
        }
      }
    }
  }
}

// W(a, b).
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

// The longest edges of the two pieces of its path that are its own; they may be none.
std::array<TreeByClusters::Value, 2> TreeByClusters::ends_of(Item item) const {
  const auto [u, v] = edges_->ends(item);
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
