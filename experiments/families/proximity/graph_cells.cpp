// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does the minimum spanning tree of a graph with moving weights change exactly as often as
//   counted by hand, and does each engine fail exactly as often?
// Source: graphs.cpp.
// Parameters: bundles of 2 to 16 parallel edges; random graphs of 40 to 640 edges.
// Expected: m(n - 1) changes; no other failure of graph_mst_cycles; every hard bound and audit.
// Cost: about 10 s.
#include <string>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

void add_graph_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const char* const engine :
       {"graph_mst_list", "graph_mst_cycles", "graph_mst_clusters", "graph_mst_sparsified"}) {
    for (const int bundles : {1, 3}) {
      for (const int n : {2, 4, 8, 16}) {
        lab::Cell cell = lab::worst_case_cell(engine, "parallel-edges", n, 1, 0.1);
        cell.parameters.m = bundles;
        cell.audit = AuditLevel::kEvents;
        cell.expectations.push_back(
            lab::expect_exactly("graph_mst.parallel_edges", "external", Integer(bundles * (n - 1)),
                                "every edge of a bundle is the lightest in turn: m(n - 1)"));
        if (bundles == 1 && std::string(engine) == "graph_mst_cycles") {
          cell.expectations.push_back(lab::expect_exactly("graph_mst.failures", "processed",
                                                          Integer(n - 1),
                                                          "every failure changes the tree: n - 1"));
        }
        catalogue.cells.push_back(std::move(cell));
      }
    }
    for (const int n : {40, 160, 640}) {
      if (n > 160 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell;
      cell.question = "Do the hard bounds hold?";
      cell.structure = engine;
      cell.workload = "random-graph";
      cell.parameters.n = n;
      cell.parameters.m = n / 4;
      cell.family = "random-graph m=n/4";
      cell.random = true;
      cell.min_seeds = cell.max_seeds = 4;
      cell.audit = n <= 40 ? AuditLevel::kEvents : AuditLevel::kEnd;
      cell.cost = n / 200.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
