// SPDX-License-Identifier: GPL-3.0-or-later
// FamilyExperiments: all that the laboratory knows about a family of structures. Each family fills
// one in, in its family.cpp; verify, trade, reproduce and the workloads of all verbs use them.
#ifndef KINEX_EXPERIMENTS_LAB_FAMILY_H
#define KINEX_EXPERIMENTS_LAB_FAMILY_H

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/gnuplot.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/measures.h"
#include "experiments/lab/part.h"
#include "experiments/lab/thinning.h"
#include "experiments/lab/trade_plan.h"
#include "experiments/lab/workload.h"
#include "structures/parts/descriptor.h"

namespace kinex::lab {

// The structure to maintain in a scene that names none.
struct UsualStructure {
  bool bodies;    // for scenes of bodies; otherwise of points
  int dimension;  // 0: every dimension for which no other family has one
  std::string_view structure;
};

// A study of `kinex verify`.
struct FamilyStudy {
  std::string_view name;       // in results
  std::string_view group;      // it is run with all structures of this group
  std::string_view structure;  // .. and with this structure
  StudyResult (*run)(bool quick, const std::function<bool()>& go_on);
};

struct FamilyExperiments {
  std::string_view name;  // of the structures' family and of its folders
  std::vector<UsualStructure> usual = {};
  std::vector<Workload> workloads = {};
  // Cells and growth claims of its structures; nullptr: none.
  void (*add_cells)(Catalogue& catalogue, Extent extent) = nullptr;
  // True for structures with a hard bound on all their events; nullptr: all have one.
  bool (*bounds_events)(std::string_view structure) = nullptr;
  // The hard bound on all events of a structure has the id STRUCTURE.events, or ends in one of these.
  std::vector<std::string_view> event_bounds = {};
  // Structures whose audits after every event are long: scenes of common cells have fewer objects.
  std::vector<std::string_view> long_audits = {};
  // Hard bounds and audits of any structure, also of other families, on scenes of this family.
  void (*add_common_cells)(Catalogue& catalogue, const StructureInfo& structure,
                           Extent extent) = nullptr;
  // Comparisons of structures on the same scenes; called after all cells above have been added.
  void (*add_comparisons)(Catalogue& catalogue, Extent extent) = nullptr;
  std::vector<FamilyStudy> studies = {};
  // Tables and figures of its own from the cells of all families.
  std::vector<Table> (*tables)(const std::vector<CellResult>& cells) = nullptr;
  std::vector<Figure> (*figures)(const std::vector<CellResult>& cells) = nullptr;
  std::vector<std::string_view> figure_titles = {};  // of all that `figures` can draw
  std::vector<TradePlan> trade = {};
  const Thinning* thinning = nullptr;  // nullptr: none
  // Rows of the benchmarks, with all sizes divided by `scale`; nullptr: none.
  std::vector<BenchRow> (*bench_rows)(int scale) = nullptr;
  // Parts of papers; several families may have parts of one paper.
  std::vector<Paper> papers = {};
};

// All families, in the order in which users see them. Defined where they are listed, in
// families/families.cpp: the laboratory knows the list but no family on it.
const std::vector<FamilyExperiments>& experiment_families();

// The experiments of the family of a structure; nullptr if it has none.
const FamilyExperiments* experiments_on(std::string_view structure);

// The tables and figures of all families, then (of tables) one per comparison.
std::vector<Table> family_tables(const std::vector<CellResult>& cells);
std::vector<Figure> family_figures(const std::vector<CellResult>& cells);
// The titles of all figures that a family can draw if a cell is of one of its structures.
std::vector<std::string> family_figure_titles(const std::vector<Cell>& cells);

// The method of `kinex thin`: that of the first family with one; nullptr: none has.
const Thinning* known_thinning();

// The usual structure of a scene; empty if there is none.
std::string usual_structure(bool bodies, int dimension);

}  // namespace kinex::lab

#endif
