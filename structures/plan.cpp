// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/plan.h"

#include <algorithm>
#include <utility>

#include "structures/registry.h"

namespace kinex {
namespace {

bool same_work(const Request& a, const Request& b) {
  return a.structure == b.structure && a.key == b.key;
}

// A label that no request has.
std::string unused_label(const Request& reader, std::string_view reads, const Scene& scene) {
  std::string label = reader.label + "." + std::string(reads);
  while (std::any_of(scene.maintain.begin(), scene.maintain.end(),
                     [&label](const Request& r) { return r.label == label; })) {
    label += "'";
  }
  return label;
}

}  // namespace

std::vector<PlannedStructure> plan_structures(const Scene& scene) {
  std::vector<PlannedStructure> plan;
  const auto find = [&plan](const std::string& label) {
    return std::find_if(plan.begin(), plan.end(),
                        [&label](const PlannedStructure& p) { return p.request.label == label; });
  };
  for (const Request& request : scene.maintain) {
    if (find(request.label) != plan.end()) continue;  // added earlier, for a reader
    const StructureInfo* info = find_structure_info(request.structure);
    std::optional<StructureId> watches;
    if (info != nullptr && !info->reads.empty()) {
      const Request wanted{std::string(info->reads), "", request.key};
      const auto is_wanted = [&wanted](const Request& r) { return same_work(r, wanted); };
      auto there = std::find_if(plan.begin(), plan.end(),
                                [&](const PlannedStructure& p) { return is_wanted(p.request); });
      if (there == plan.end()) {
        const auto asked = std::find_if(scene.maintain.begin(), scene.maintain.end(), is_wanted);
        PlannedStructure base{wanted, asked != scene.maintain.end(), {}, 0};
        base.request.label = base.asked ? asked->label : unused_label(request, info->reads, scene);
        plan.push_back(std::move(base));
        there = plan.end() - 1;
      }
      ++there->readers;
      watches = static_cast<StructureId>(there - plan.begin());
    }
    plan.push_back({request, true, watches, 0});
  }
  return plan;
}

NumberNeeds plan_numbers(const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  for (const PlannedStructure& planned : plan_structures(scene)) {
    const StructureInfo* info = find_structure_info(planned.request.structure);
    if (info == nullptr) continue;
    if (info->weights) needs.add_weights(scene);
    if (info->derives != nullptr) info->derives(scene, needs);
  }
  return needs;
}

std::unique_ptr<Arithmetic> planned_arithmetic(std::string_view name, const Scene& scene) {
  return make_arithmetic(name, scene, plan_numbers(scene));
}

StructureId asked_structure(const Scene& scene) {
  const std::vector<PlannedStructure> plan = plan_structures(scene);
  const std::string& label = scene.maintain.at(0).label;
  std::size_t i = 0;
  while (plan[i].request.label != label) ++i;
  return static_cast<StructureId>(i);
}

void add_structures(Simulator& simulator, const Scene& scene) {
  for (const PlannedStructure& planned : plan_structures(scene)) {
    const StructureId id = simulator.reserve();
    const Structure* watched =
        planned.watches ? &std::as_const(simulator).structure(*planned.watches) : nullptr;
    std::vector<StructureId> watches;
    if (planned.watches) watches.push_back(*planned.watches);
    simulator.add(id, make_structure(planned.request, scene, simulator.kernel(), id, watched),
                  planned.request.label, std::move(watches));
  }
}

}  // namespace kinex
