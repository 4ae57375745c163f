// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which structure for an attribute of near points should one take? All that maintain it, on
//   the same scenes: failures and changes, certificates, those of one object (locality), those that an
//   event changes (responsiveness), CPU time.
// Scenes: random motion, of few points and of more; points that pass along a row, where the attribute
//   changes most often; a grid full of ties; flight plans that change, one a point on average; for
//   graphs, discs, boxes and lines their own.
// Parameters: three scenes of a random workload; counts of failures and changes are means, of
//   certificates at most: the sum of what each structure of a run had most.
// Structures: those of three families, each on the scenes that it takes; beside nearest_site the tournament of
//   all sites by their squared distance to the same query, which maintains the same attribute. What a run in
//   excess of 20 seconds would count is left out.
// Output: see result_table.h; options: see bench_options.h. Every run is audited at its end.
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/lab/bench_options.h"
#include "experiments/lab/family.h"
#include "experiments/lab/measures.h"
#include "experiments/lab/result_table.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace {

using namespace kinex;

constexpr double kMostSeconds = 20;
constexpr int kRandomScenes = 3;
constexpr std::array<std::string_view, 3> kFamilies{"proximity", "triangulation", "arrangement"};

struct Scenes {
  const char* workload;
  int n, m;
  int dimension;  // 0: the usual one
};

// By what the structure is for.
std::vector<Scenes> scenes_for(const StructureInfo& info) {
  if (info.graph) return {{"random-graph", 64, 16, 0}, {"random-graph", 256, 64, 0}, {"parallel-edges", 32, 1, 0}};
  if (info.lines == LineUse::kAlone) {
    return {{"random-lines", 16, 0, 0},
            {"random-lines", 64, 0, 0},
            {"three-bundles", 24, 0, 0},
            {"turning-pencil", 12, 0, 0}};
  }
  if (info.lines == LineUse::kWithPoints) {
    std::vector<Scenes> scenes{{"random-lines-and-points", 32, 0, 0},
                               {"random-lines-and-points", 128, 0, 0},
                               {"points-through-lines", 12, 12, 0}};
    // A cutting has fewer certificates than all pairs only of many lines and points.
    if (info.group == "incidences")
      scenes.insert(scenes.begin() + 2, {"random-lines-and-points", 512, 0, 0});
    return scenes;
  }
  if (info.extents == Extents::kHalfExtents) {
    return {{"random-boxes", 32, 0, 0}, {"random-boxes", 128, 0, 0}, {"fan-of-boxes", 12, 0, 0}};
  }
  if (info.name == "closest_pair_discs") {  // of discs that overlap the pair hardly ever changes
    return {{"apart-discs", 32, 0, 2},
            {"apart-discs", 128, 0, 2},
            {"apart-discs", 512, 0, 2},
            {"gaps-along-row", 8, 8, 0},
            {"apart-discs", 32, 0, 3}};
  }
  if (info.extents == Extents::kRadius) {
    return {{"random-discs", 32, 0, 0},
            {"random-discs", 128, 0, 0},
            {"random-discs", 512, 0, 0},
            {"random-discs", 2048, 0, 0},
            {"fan-of-discs", 12, 0, 0}};
  }
  std::vector<Scenes> scenes;
  if (info.min_dimension <= 2) {
    scenes = {{"uniform-square", 32, 0, 2},
              {"uniform-square", 128, 0, 2},
              {info.colours ? "colours-along-row" : "pass-along-row", 8, info.colours ? 0 : 8, 0},
              {"grid", 36, 0, 2},
              {"new-plans", 32, 32, 2}};
    // Here the sizes above are too small to tell which structure to take for many points.
    if (info.colours)
      scenes.insert(scenes.begin() + 2,
                    {{"uniform-square", 512, 0, 2}, {"uniform-square", 2048, 0, 2}});
  }
  if (info.any_dimension || info.min_dimension == 3) scenes.push_back({"uniform-square", 32, 0, 3});
  return scenes;
}

// A structure with a key has the squared distance to the first object, which is the usual query of the others.
void measure_from_first(Scene& scene, int /*k*/) {
  Key& key = scene.maintain.front().key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 0;
}
constexpr lab::SceneChange kFromFirst{"measured from the first", measure_from_first};

// The runs of a structure on these scenes; none if it does not take them, or takes too long.
lab::CellResult runs_of(const StructureInfo& info, const Scenes& scenes, int scale) {
  lab::CellResult result;
  lab::Cell& cell = result.cell;
  cell.structure = info.name;
  cell.workload = scenes.workload;
  if (info.uses_key) cell.change = &kFromFirst;
  const lab::Workload* const workload = lab::find_workload(cell.workload);
  if (workload == nullptr) throw std::runtime_error("no workload " + cell.workload);
  cell.parameters.n = std::max({4, workload->min_n, scenes.n / scale});
  cell.parameters.m = scenes.m == 0 ? 0 : std::max(workload->min_m, scenes.m / scale);
  cell.parameters.dimension = scenes.dimension;
  const int count = workload->random && scale == 1 ? kRandomScenes : 1;
  for (int k = 0; k < count; ++k) {
    const Scene scene = lab::scene_of(cell, k);
    if (refusal_of(info, scene)) return result;
    SimulatorOptions options;
    options.audit = AuditLevel::kEnd;
    options.max_seconds = kMostSeconds;
    lab::Trial trial{lab::measure(scene, "exact", std::move(options)), {}};
    if (trial.measurement.status != RunStatus::kDone) {
      result.trials.clear();
      return result;
    }
    if (!trial.measurement.clean()) {
      throw std::runtime_error(cell.structure + " on " + scene.name + ": an audit failed");
    }
    result.trials.push_back(std::move(trial));
  }
  return result;
}

// Of certificates, a run on average, structures that are read included.
double mean_failures(const lab::CellResult& cell) {
  std::uint64_t sum = 0;
  for (const lab::Trial& trial : cell.trials) sum += trial.measurement.costs.failures;
  return static_cast<double>(sum) / static_cast<double>(cell.trials.size());
}

void add_row(const std::string& attribute, const lab::CellResult& cell, lab::ResultTable& table) {
  const lab::Measures m = lab::measures_of(cell);
  const lab::WorkloadParameters& size = cell.cell.parameters;
  std::string scenes = cell.cell.workload;
  if (size.m != 0) scenes += " m=" + std::to_string(size.m);
  if (size.dimension == 3) scenes += ", 3 axes";
  const double failures = mean_failures(cell);
  table.row({attribute, scenes, size.n, cell.cell.structure, failures, m.external,
             m.external > 0 ? failures / m.external : 0, m.certificates, m.per_object,
             m.most_changed, m.mean_changed, 1e3 * m.seconds});
}

void proximity(const lab::BenchOptions& options) {
  const int scale = options.smoke ? 8 : 1;
  lab::ResultTable table(
      options, "proximity",
      "All structures of an attribute on the same scenes, in exact arithmetic. Failures "
      "of certificates and changes of the attribute are means. Certificates (all, of "
      "one object): no run had more; where a structure reads another one, the sum of what each "
      "had most. Changed by an event: what the structure whose certificate fails makes and drops "
      "in the repair; what is made when an instant is settled, or when a structure that is read "
      "has changed, is not in it. Failures, and what they change, count structures that are read.",
      {{"attribute", lab::ResultTable::kText, 18},
       {"scenes", lab::ResultTable::kText, 24},
       {"n", 0, 4},
       {"structure", lab::ResultTable::kText, 26},
       {"failures", 1, 9},
       {"changes", 1, 8},
       {"failures_per_change", 1},
       {"certificates", 0},
       {"of_one_object", 0},
       {"most_changed_by_an_event", 0},
       {"mean_changed", 1},
       {"milliseconds", 2}});
  // By attribute, then by scenes; both in their order.
  std::vector<std::pair<std::string, std::vector<const StructureInfo*>>> attributes;
  for (const StructureInfo& info : structure_infos()) {
    const lab::FamilyExperiments* const family = lab::experiments_on(info.name);
    if (family == nullptr || std::ranges::find(kFamilies, family->name) == kFamilies.end()) continue;
    const std::string name(info.group.empty() ? info.name : info.group);
    auto known = std::find_if(attributes.begin(), attributes.end(),
                              [&](const auto& entry) { return entry.first == name; });
    if (known == attributes.end()) known = attributes.insert(known, {name, {}});
    known->second.push_back(&info);
  }
  for (auto& [name, structures] : attributes) {
    if (name == "nearest_site") structures.push_back(find_structure_info("minimum_tournament"));
  }
  for (const auto& [attribute, structures] : attributes) {
    std::vector<std::vector<Scenes>> scenes;
    std::size_t most = 0;
    for (const StructureInfo* info : structures) {
      scenes.push_back(scenes_for(*info));
      if (scenes.back().size() > scenes[most].size()) most = scenes.size() - 1;
    }
    for (const Scenes& one : scenes[most]) {
      for (std::size_t i = 0; i < structures.size(); ++i) {
        const bool takes = std::any_of(scenes[i].begin(), scenes[i].end(), [&](const Scenes& other) {
          return std::string_view(other.workload) == one.workload && other.n == one.n &&
                 other.dimension == one.dimension;
        });
        const std::string row = attribute + " " + std::string(structures[i]->name);
        if (!takes || row.find(options.rows) == std::string::npos) continue;
        const lab::CellResult cell = runs_of(*structures[i], one, scale);
        if (!cell.trials.empty()) add_row(attribute, cell, table);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) { return lab::bench_main(argc, argv, proximity); }
