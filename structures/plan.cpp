// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/plan.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "structures/parts/object_sets.h"
#include "structures/registry.h"

namespace kinex {
namespace {

// Two requests for one structure, whatever it is called.
bool same_work(const Request& a, const Request& b) {
  return a.structure == b.structure && a.key == b.key && a.parameters == b.parameters &&
         a.of == b.of && a.query == b.query && a.colours == b.colours &&
         std::equal(a.over.begin(), a.over.end(), b.over.begin(), b.over.end(), same_work);
}

// A label that no request has.
std::string unused_label(const Request& reader, const Request& wanted, const Scene& scene,
                         std::optional<int> axis) {
  std::string label = reader.label + "." + wanted.structure;
  if (axis) label += std::string(":") + "xyz"[*axis];
  while (std::any_of(scene.maintain.begin(), scene.maintain.end(),
                     [&label](const Request& r) { return r.label == label; })) {
    label += "'";
  }
  return label;
}

class Planner {
 public:
  explicit Planner(const Scene& scene) : scene_(scene) {}

  std::vector<PlannedStructure> plan() {
    for (const Request& request : scene_.maintain) {
      const auto there = std::find_if(plan_.begin(), plan_.end(), [&](const PlannedStructure& p) {
        return p.request.label == request.label;  // added earlier, for a reader
      });
      if (there == plan_.end()) add(request, true);
    }
    return std::move(plan_);
  }

 private:
  // What the structure of `reader` reads there. Its label is empty.
  Request wanted_by(const Request& reader, const Reading& reading) const {
    if (!reading.role.empty() && !reader.over.empty()) {
      Request wanted = reader.over.front();
      wanted.label.clear();
      wanted.of = reader.of;
      return wanted;
    }
    Request wanted{usual_structure(reading, scene_.dimension), "", {}};
    const StructureInfo& info = *find_structure_info(reader.structure);
    wanted.of = info.sample != nullptr ? info.sample(reader, scene_) : sites_of(info, reader, scene_);
    if (reading.passes_over) wanted.over = reader.over;
    if (reading.axis) {
      wanted.key.axis = *reading.axis;
    } else if (const StructureInfo* read = find_structure_info(wanted.structure);
               read != nullptr && read->uses_key) {
      wanted.key = reader.key;
    }
    return wanted;
  }
  StructureId add(const Request& request, bool asked) {
    PlannedStructure planned{request, asked};
    if (const StructureInfo* info = find_structure_info(request.structure)) {
      planned.members = members_of(*info, request, scene_);
      for (const Reading& reading : info->reads) {
        planned.watches.push_back(read(request, wanted_by(request, reading), reading.axis));
      }
      if (const std::optional<Request> part = shared_part(request, *info)) {
        planned.watches.push_back(read(request, *part, {}));
      }
    }
    plan_.push_back(std::move(planned));
    return static_cast<StructureId>(plan_.size() - 1);
  }
  StructureId read(const Request& reader, const Request& wanted, std::optional<int> axis) {
    const auto is_wanted = [&wanted](const Request& r) { return same_work(r, wanted); };
    const auto there = std::find_if(plan_.begin(), plan_.end(), [&](const PlannedStructure& p) {
      return is_wanted(p.request);
    });
    auto id = static_cast<StructureId>(there - plan_.begin());
    if (there == plan_.end()) {
      const auto asked = std::find_if(scene_.maintain.begin(), scene_.maintain.end(), is_wanted);
      Request base = wanted;
      const bool is_asked = asked != scene_.maintain.end();
      base.label = is_asked ? asked->label : unused_label(reader, wanted, scene_, axis);
      id = add(base, is_asked);
    }
    ++plan_[id].readers;
    return id;
  }
  // The part that the reader shares with another request of the scene; nullopt: it has its own.
  std::optional<Request> shared_part(const Request& reader, const StructureInfo& info) const {
    const Sharing& shares = info.shares;
    if (shares.structure.empty()) return std::nullopt;
    const StructureInfo& part = *find_structure_info(shares.structure);
    const Request read = wanted_by(reader, info.reads.front());
    std::size_t readers = 0;
    Rational largest(0);
    std::vector<Rational> asked;  // requests for the part
    for (const Request& other : scene_.maintain) {
      const StructureInfo* there = find_structure_info(other.structure);
      const bool is_part = other.structure == shares.structure;
      if (there == nullptr || (!is_part && there->shares.structure != shares.structure)) continue;
      if (!same_work(wanted_by(other, there->reads.front()), read)) continue;
      if (is_part) asked.push_back(parameter_of(part, other, shares.parameter));
      if (!is_part) ++readers;
      largest = std::max(largest, is_part ? asked.back() : Rational(there->shares.needs));
    }
    if (readers + static_cast<std::size_t>(std::count(asked.begin(), asked.end(), largest)) < 2) {
      return std::nullopt;
    }
    Request wanted{std::string(shares.structure), "", {}, reader.over};
    wanted.of = reader.of;
    if (largest != parameter_of(part, wanted, shares.parameter)) {
      wanted.parameters.push_back({std::string(shares.parameter), largest});
    }
    return wanted;
  }

  const Scene& scene_;
  std::vector<PlannedStructure> plan_;
};

}  // namespace

std::vector<PlannedStructure> plan_structures(const Scene& scene) { return Planner(scene).plan(); }

std::vector<const Structure*> watched_by(const PlannedStructure& planned,
                                         const Simulator& simulator) {
  std::vector<const Structure*> watched;
  for (const StructureId id : planned.watches) watched.push_back(&simulator.structure(id));
  return watched;
}

NumberNeeds plan_numbers(const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  for (const PlannedStructure& planned : plan_structures(scene)) {
    const StructureInfo* info = find_structure_info(planned.request.structure);
    if (info == nullptr) continue;
    if (info->weights) needs.add_weights(scene);
    // A scene without objects has no extents either.
    if (info->extents != Extents::kNone) needs.axes = std::max(needs.axes, 2 * scene.dimension);
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
    const std::vector<const Structure*> watched = watched_by(planned, simulator);
    simulator.add(
        id,
        make_structure(planned.request, scene, simulator.kernel(), id, watched, planned.watches),
        planned.request.label, planned.watches, planned.members);
  }
}

}  // namespace kinex
