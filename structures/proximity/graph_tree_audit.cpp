// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning forest of a graph at exact weights, by Kruskal's algorithm of
// boost::graph. It compares ranks: edges by weight, equal ones by object.
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <iterator>
#include <utility>

#include "structures/proximity/graph_tree.h"

namespace kinex {

void GraphTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, std::size_t>>;
  std::vector<ObjectId> order;
  for (ObjectId object = 0; object < snapshot.objects(); ++object) {
    if (snapshot.alive(object)) order.push_back(object);
  }
  std::stable_sort(order.begin(), order.end(), [&](ObjectId a, ObjectId b) {
    return snapshot.position(a, 0) < snapshot.position(b, 0);
  });
  Graph graph(weights_.vertices());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const auto [u, v] = weights_.ends(order[rank]);
    boost::add_edge(u, v, rank, graph);
  }
  std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree));
  std::vector<ObjectId> ids;
  for (const auto& edge : tree) ids.push_back(order[get(boost::edge_weight, graph, edge)]);
  std::sort(ids.begin(), ids.end());
  report.check(ids == attribute().ids, [] { return "another forest is the lightest"; });
}

}  // namespace kinex
