// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_forest_audit.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <iterator>

namespace kinex {

std::vector<std::size_t> static_forest(std::span<const std::array<std::uint32_t, 2>> edges,
                                       std::size_t vertices) {
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, std::size_t>>;
  Graph graph(vertices);
  for (std::size_t place = 0; place < edges.size(); ++place) {
    boost::add_edge(edges[place][0], edges[place][1], place, graph);
  }
  std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree));
  std::vector<std::size_t> places;
  for (const auto& edge : tree) places.push_back(get(boost::edge_weight, graph, edge));
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace kinex
