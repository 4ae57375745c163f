// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/registry.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/numbers/near_names.h"
#include "core/numbers/show_number.h"
#include "core/numbers/show_text.h"
#include "structures/families.h"
#include "structures/family_summary.h"
#include "structures/parts/object_sets.h"

namespace kinex {
namespace {

const std::vector<StructureFamily>& families() {
  static const std::vector<StructureFamily> kFamilies = [] {
    std::vector<StructureFamily> all;
    for (const ListedFamily& family : kStructureFamilies) all.push_back(family.describe());
    return all;
  }();
  return kFamilies;
}

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) names.emplace_back(info.name);
  return names;
}

std::string maintain_instead(const StructureInfo& info, const char* what) {
  if (info.instead.empty()) return "maintain something else";
  return "maintain " + std::string(info.instead) + what;
}

// A number of a descriptor.
Rational number(std::string_view text) { return Rational::parse(text).value(); }

bool can_be_read(const Reading& reading, const Structure& structure) {
  if (structure.name() == reading.structure) return true;
  if (structure.name() == usual_structure(reading, 3)) return true;
  const StructureInfo* info = find_structure_info(structure.name());
  return !reading.role.empty() && info != nullptr && info->role == reading.role;
}

[[noreturn]] void refuse(const StructureInfo& info, const Refusal& refusal) {
  throw std::invalid_argument(std::string(info.name) + " " + refusal.problem + "; " +
                              refusal.remedy);
}

}  // namespace

const std::vector<StructureInfo>& structure_infos() {
  static const std::vector<StructureInfo> kInfos = [] {
    std::vector<StructureInfo> infos;
    for (const StructureFamily& family : families()) {
      infos.insert(infos.end(), family.structures.begin(), family.structures.end());
    }
    return infos;
  }();
  return kInfos;
}

const StructureInfo* find_structure_info(std::string_view name) {
  for (const StructureInfo& info : structure_infos()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

std::string_view meaning_of_kind(const StructureInfo& info, std::string_view kind) {
  static constexpr KindRule kCommon[] = {
      {"motion", Effect::kNever, "an object gets another flight plan"},
      {"insert", Effect::kNever, "an object appears"},
      {"erase", Effect::kNever, "an object disappears"},
      {"settled", Effect::kSometimes, "the instant is over: its changes are reported together"},
      {"rebuild", Effect::kSometimes, "the whole proof is made anew"}};
  const auto is_asked = [kind](const KindRule& rule) { return rule.kind == kind; };
  const auto own = std::find_if(info.kinds.begin(), info.kinds.end(), is_asked);
  if (own != info.kinds.end()) return own->text;
  const auto* const common = std::find_if(std::begin(kCommon), std::end(kCommon), is_asked);
  return common == std::end(kCommon) ? std::string_view() : common->text;
}

std::string_view family_of(std::string_view structure) {
  for (const StructureFamily& family : families()) {
    for (const StructureInfo& info : family.structures) {
      if (info.name == structure) return family.name;
    }
  }
  return {};
}

std::vector<FamilySummary> family_summaries() {
  std::vector<FamilySummary> all;
  for (std::size_t i = 0; i < families().size(); ++i) {
    all.push_back({families()[i].name, kStructureFamilies[i].summary});
  }
  return all;
}

std::vector<std::string_view> structure_groups() {
  std::vector<std::string_view> groups;
  for (const StructureInfo& info : structure_infos()) {
    if (info.group.empty()) continue;
    if (std::find(groups.begin(), groups.end(), info.group) == groups.end()) {
      groups.push_back(info.group);
    }
  }
  return groups;
}

std::optional<Refusal> refusal_of(const StructureInfo& info, const Scene& scene) {
  if (!scene.objects.empty() && info.bodies != scene.has_bodies()) {
    return Refusal{info.bodies ? "is for rigid bodies, the scene has points"
                               : "is for points, the scene has bodies",
                   std::string("maintain a structure for ") +
                       (info.bodies ? "points" : "rigid bodies") + " (kinex list structures)"};
  }
  if (info.lines == LineUse::kNone && scene.has_lines()) {
    return Refusal{"is for points, the scene has lines",
                   "remove \"line\": true, or maintain something else"};
  }
  const std::string axes = std::to_string(info.min_dimension) +
                           (info.min_dimension == 1 ? " axis" : " axes") + ", the scene has " +
                           std::to_string(scene.dimension);
  if (scene.dimension < info.min_dimension) {
    return Refusal{"needs " + axes, "maintain something else, or give the scene more axes"};
  }
  if (!info.any_dimension && scene.dimension > info.min_dimension) {
    return Refusal{"is for " + axes, "leave axes out, or maintain something else"};
  }
  const auto has_ends = [](const SceneObject& object) { return !object.ends.empty(); };
  const auto bare = std::find_if_not(scene.objects.begin(), scene.objects.end(), has_ends);
  if (info.graph && bare != scene.objects.end()) {
    return Refusal{"is for edges of a graph, object " + show_text(bare->id) + " has no ends",
                   "give every object \"ends\": [VERTEX, VERTEX], or maintain something else"};
  }
  if (info.weights && scene.extents == Extents::kHalfExtents) {
    return Refusal{"is for points with weights and for discs, the scene has boxes",
                   "give the objects a \"weight\" or a \"radius\" instead of \"half_extents\", or "
                   "maintain something else"};
  }
  if (info.lines != LineUse::kNone && !scene.objects.empty() && !scene.has_lines()) {
    return Refusal{"is for lines, the scene has none",
                   "write \"line\": true for each line, or maintain something else"};
  }
  const bool fits = info.extents == scene.extents || info.extents == Extents::kNone ||
                    (info.extents == Extents::kHalfExtents && scene.extents == Extents::kRadius);
  if (!fits && !scene.objects.empty()) {
    const bool discs = info.extents == Extents::kRadius;
    return Refusal{std::string("is for ") + (discs ? "discs" : "boxes") + ", the scene has " +
                       (scene.extents == Extents::kHalfExtents ? "boxes" : "points"),
                   std::string("give every object ") +
                       (discs ? "a \"radius\"" : "\"half_extents\", or a \"radius\"") +
                       ", or maintain something else"};
  }
  const int degree = info.weights ? scene.degree() : scene.degree_without_weights();
  if (degree > info.largest_degree) {
    return Refusal{"needs " +
                       (info.linear() ? std::string("linear motions")
                                      : "motions of degree " + std::to_string(info.largest_degree) +
                                            " or less") +
                       ", the scene has motions of degree " + std::to_string(degree),
                   maintain_instead(info, ", which takes every motion")};
  }
  if (info.refuse != nullptr && scene.has_bodies() == info.bodies) return info.refuse(scene);
  return std::nullopt;
}

std::optional<Refusal> refusal_of_key(const StructureInfo& info, const Key& key) {
  if (info.linear() && key.kind == Key::Kind::kSquaredDistance) {
    return Refusal{"needs a key that is linear, not a squared distance",
                   maintain_instead(info, " by this key")};
  }
  return std::nullopt;
}

std::optional<Refusal> refusal_of_parameter(const StructureInfo& info, const Parameter& parameter) {
  std::string names;
  for (const ParameterInfo& known : info.parameters) {
    if (known.name != parameter.name) {
      names += (names.empty() ? "" : ", ") + std::string(known.name);
      continue;
    }
    const Rational least = number(known.least);
    std::string range =
        (known.whole ? "an integer of at least " : "a number of at least ") + least.to_string();
    bool fits = !(parameter.value < least) && (!known.whole || parameter.value.is_integer());
    if (!known.most.empty()) {
      const Rational most = number(known.most);
      fits = fits && (known.most_is_allowed ? !(most < parameter.value) : parameter.value < most);
      range += (known.most_is_allowed ? " and at most " : " and less than ") + most.to_string();
    }
    if (!known.step.empty()) {
      const Rational step = number(known.step);
      fits = fits && ((parameter.value - least) / step).is_integer();
      range += ", in steps of " + step.to_string();
    }
    if (fits) return std::nullopt;
    return Refusal{"cannot have " + std::string(known.name) + " = " + show_number(parameter.value),
                   "write " + range};
  }
  return Refusal{"has no parameter \"" + parameter.name + "\"",
                 names.empty() ? "remove it" : "its parameters are " + names};
}

std::string usual_structure(const Reading& reading, int dimension) {
  const std::string_view name = reading.structure;
  if (dimension == 3 && name.ends_with("_2")) {
    const std::string namesake = std::string(name.substr(0, name.size() - 1)) + "3";
    if (find_structure_info(namesake) != nullptr) return namesake;
  }
  return std::string(name);
}

const Reading* reading_of_choice(const StructureInfo& info) {
  for (const Reading& reading : info.reads) {
    if (!reading.role.empty()) return &reading;
    if (reading.passes_over) return reading_of_choice(*find_structure_info(reading.structure));
  }
  return nullptr;
}

std::optional<Refusal> refusal_of_over(const StructureInfo& info, const Request& over) {
  const Reading* const reading = reading_of_choice(info);
  if (reading == nullptr) {
    return Refusal{
        info.reads.empty() ? "reads no other structure" : "has no choice of what it reads",
        "remove \"over\""};
  }
  const StructureInfo* there = find_structure_info(over.structure);
  if (there != nullptr && there->role == reading->role) return std::nullopt;
  std::string names;
  int count = 0;
  for (const StructureInfo& other : structure_infos()) {
    if (other.role != reading->role) continue;
    names += (names.empty() ? "" : ", ") + std::string(other.name);
    ++count;
  }
  return Refusal{"cannot read \"" + over.structure + "\"",
                 "it reads a structure with the role " + std::string(reading->role) + ": " +
                     (count > 1 ? "one of " : "") + names};
}

std::optional<Refusal> refusal_of_objects(const StructureInfo& info, const Request& request,
                                          const Scene& scene) {
  if (info.bodies && request.of.kind != Subset::Kind::kAll) {
    return Refusal{"is for all bodies of a scene", "remove \"of\""};
  }
  if (info.colours && request.of.kind != Subset::Kind::kAll) {
    return Refusal{"takes the objects of its two colours", "remove \"of\""};
  }
  if (info.query_is_site && request.of.kind != Subset::Kind::kAll &&
      query_of(request) < scene.objects.size() && !scene.members(request.of)[query_of(request)]) {
    return Refusal{"is about " + show_text(scene.objects[query_of(request)].id) +
                       ", which is not among its sites",
                   "take it into \"of\""};
  }
  if (info.query && !info.query_is_site && request.of.kind != Subset::Kind::kAll &&
      request.of.kind != Subset::Kind::kAllBut && query_of(request) < scene.objects.size() &&
      scene.members(request.of)[query_of(request)]) {
    return Refusal{
        "has its query " + show_text(scene.objects[query_of(request)].id) + " among its sites",
        "leave it out of \"of\""};
  }
  if (info.uses_key && request.key.kind == Key::Kind::kSquaredDistance) {
    const std::vector<bool> members = scene.members(request.of);
    if (!members.empty() && !members[request.key.object]) {
      return Refusal{"measures the distance to " + show_text(scene.objects[request.key.object].id) +
                         ", which is not among its objects",
                     "take it into \"of\""};
    }
  }
  for (const std::string& colour : request.colours) {
    const bool known =
        std::any_of(scene.objects.begin(), scene.objects.end(),
                    [&colour](const SceneObject& object) { return object.colour == colour; });
    if (known) continue;
    return Refusal{"is to compare " + show_text(colour) + ", a colour that no object has",
                   "write two colours of objects of the scene"};
  }
  if (!request.colours.empty() && request.colours[0] == request.colours[1]) {
    return Refusal{"is to compare a colour with itself", "write two different colours"};
  }
  return std::nullopt;
}

Rational parameter_of(const StructureInfo& info, const Request& request, std::string_view name) {
  for (const Parameter& given : request.parameters) {
    if (given.name == name) return given.value;
  }
  for (const ParameterInfo& known : info.parameters) {
    if (known.name == name) return number(known.usual);
  }
  throw std::logic_error("a parameter that is not in the descriptor");
}

const StructureInfo& MakerInput::info() const { return *find_structure_info(request.structure); }

Rational MakerInput::parameter(std::string_view name) const {
  return parameter_of(info(), request, name);
}

std::vector<std::vector<Rational>> directions_of(const StructureInfo& info, const Request& request,
                                                 int axes) {
  if (info.directions == nullptr) return {};
  const Rational parameter = parameter_of(info, request, info.parameters.front().name);
  return info.directions(static_cast<int>(parameter.numerator().to_int64()), axes);
}

std::size_t width_of(const StructureInfo& info, const Request& request) {
  if (info.shape != Attribute::Shape::kTuples) return 0;
  if (info.width != StructureInfo::kWidthOfParameter) return info.width;
  const Rational width = parameter_of(info, request, info.parameters.front().name);
  return static_cast<std::size_t>(width.numerator().to_int64());
}

std::unique_ptr<Structure> make_structure(const Request& request, const Scene& scene,
                                          Kernel& kernel, StructureId id,
                                          std::span<const Structure* const> watched,
                                          std::span<const StructureId> watched_ids) {
  const StructureInfo* info = find_structure_info(request.structure);
  if (info == nullptr) {
    throw std::invalid_argument(show_text(request.structure) + " is not a known structure; " +
                                did_you_mean(request.structure, known_names(),
                                             "kinex list structures names them"));
  }
  if (const auto refusal = refusal_of(*info, scene)) refuse(*info, *refusal);
  if (const auto refusal = refusal_of_key(*info, request.key)) refuse(*info, *refusal);
  for (const Parameter& given : request.parameters) {
    if (const auto refusal = refusal_of_parameter(*info, given)) refuse(*info, *refusal);
  }
  if (const auto refusal = refusal_of_objects(*info, request, scene)) refuse(*info, *refusal);
  for (const Request& over : request.over) {
    if (const auto refusal = refusal_of_over(*info, over)) refuse(*info, *refusal);
  }
  for (std::size_t i = 0; i < info->reads.size(); ++i) {
    if (i >= watched.size() || !can_be_read(info->reads[i], *watched[i])) {
      throw std::invalid_argument(request.structure + " has to watch a " +
                                  std::string(info->reads[i].structure));
    }
  }
  return info->make({request, scene, kernel, id, watched, watched_ids});
}

}  // namespace kinex
