// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/model_text.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/weights.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

constexpr std::size_t kShownDigits = 30, kShownOptions = 120;

// Changes of the objects within the scene's time.
struct PlanCounts {
  std::size_t at_rest = 0;
  std::size_t updates = 0, insertions = 0, erasures = 0;
};

bool within(const Rational& t, const Scene& scene) {
  return t > scene.start && (!scene.end || t <= *scene.end);
}

PlanCounts count_plans(const Scene& scene) {
  PlanCounts counts;
  for (const SceneObject& object : scene.objects) {
    const std::vector<MotionPiece>& pieces = object.motion.pieces;
    if (object.motion.degree() == 0) ++counts.at_rest;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool joined = i > 0 && *pieces[i - 1].to == *pieces[i].from;
      const bool goes_on = i + 1 < pieces.size() && *pieces[i].to == *pieces[i + 1].from;
      const bool jumps = joined && scene.jumps &&
                         !pieces[i].trajectory.meets(pieces[i - 1].trajectory, *pieces[i].from,
                                                     scene.has_bodies());
      if (pieces[i].from && within(*pieces[i].from, scene)) {
        ++(joined && !jumps ? counts.updates : counts.insertions);
        if (jumps) ++counts.erasures;  // it leaves, and comes again
      }
      // A piece that ends with the scene does not end within it.
      const bool ends = pieces[i].to && (!scene.end || *pieces[i].to < *scene.end);
      if (ends && !goes_on && within(*pieces[i].to, scene)) ++counts.erasures;
    }
  }
  return counts;
}

std::string short_number(const Rational& value) {
  std::string text = value.to_string();
  if (text.size() <= kShownDigits) return text;
  return "about " + decimal(value, 6);
}

// Cut between two characters.
std::string beginning(const std::string& text) {
  if (text.size() <= kShownOptions) return text;
  std::size_t size = kShownOptions;
  while ((static_cast<unsigned char>(text[size]) & 0xc0u) == 0x80u) --size;
  return text.substr(0, size) + " ..";
}

std::string maintained(const Scene& scene) {
  std::string text;
  for (const Request& request : scene.maintain) {
    if (!text.empty()) text += ", ";
    text += request.structure;
    const StructureInfo* info = find_structure_info(request.structure);
    if (info != nullptr && info->uses_key) text += " by " + plain(key_json(request.key, scene));
    const std::string options = options_json(request, scene);
    if (!options.empty()) text += " " + plain(beginning(options));
    if (request.label != request.structure) text += " as \"" + plain(request.label) + "\"";
  }
  return text.empty() ? "nothing" : text;
}

std::string left_out(const Scene& scene, const PlanCounts& counts) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  if (counts.at_rest == scene.objects.size()) {
    add("all scheduling (nothing moves)");
  } else if (counts.at_rest > 1) {
    add("failure times among the " + counted(counts.at_rest, "object", "objects") + " at rest");
  }
  if (counts.updates == 0) add("flight-plan changes");
  if (counts.insertions + counts.erasures == 0) add("insertions and erasures");
  return text.empty() ? "nothing" : text;
}

std::string described_bodies(const Scene& scene) {
  std::size_t vertices = 0, largest = 0;
  int positions = 0, rotors = 0;
  for (const SceneObject& body : scene.objects) {
    vertices += body.polygon.size();
    largest = std::max(largest, body.polygon.size());
    for (const MotionPiece& piece : body.motion.pieces) {
      positions = std::max(positions, piece.trajectory.degree_of_axes(0, 2));
      rotors = std::max(rotors, piece.trajectory.degree_of_axes(2, kBodyAxes));
    }
  }
  return "bodies    convex polygons of " + counted(vertices, "vertex", "vertices") + ", " +
         std::to_string(largest) + " at most; positions of degree " + std::to_string(positions) +
         ", rotors of degree " + std::to_string(rotors) + "\n";
}

// Behind the axes of the position.
int degree_of_extents(const Scene& scene, const SceneObject& object) {
  int degree = 0;
  for (const MotionPiece& piece : object.motion.pieces) {
    degree = std::max(degree, piece.trajectory.degree_of_axes(scene.dimension, scene.axes()));
  }
  return degree;
}

std::string described_weights(const Scene& scene) {
  int degree = 0;
  const auto weighted =
      std::count_if(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
        degree = std::max(degree, degree_of_extents(scene, object));
        const auto weight = common_weight(object, scene);
        return !weight || weight->size() > 1 || !(*weight)[0].is_zero();
      });
  return "weights   of " + counted(static_cast<std::uint64_t>(weighted), "point", "points") +
         (degree == 0 ? "" : ", of degree " + std::to_string(degree) + " at most") +
         (plan_numbers(scene).weights ? "; 0 for others\n" : ", which no structure reads\n");
}

std::string described_extents(const Scene& scene) {
  int degree = 0;
  for (const SceneObject& object : scene.objects) {
    degree = std::max(degree, degree_of_extents(scene, object));
  }
  return std::string("extents   ") +
         (scene.extents == Extents::kRadius ? "discs, radii" : "boxes, half extents") +
         " of degree " + std::to_string(degree) + " at most\n";
}

std::string described_lines(const Scene& scene) {
  const auto lines = static_cast<std::size_t>(std::count_if(
      scene.objects.begin(), scene.objects.end(), [](const SceneObject& o) { return o.line; }));
  return "lines     " + counted(lines, "line", "lines") + " y = a x + b by (a, b), " +
         counted(scene.objects.size() - lines, "point", "points") + "\n";
}

}  // namespace

std::string shown_name(const Scene& scene) { return scene.name.empty() ? "(no name)" : plain(scene.name); }

std::string objects_in_words(const Scene& scene) {
  if (scene.has_bodies()) return "rigid convex polygons";
  if (scene.extents == Extents::kHalfExtents) return scene.dimension == 1 ? "intervals" : "boxes";
  if (scene.extents == Extents::kRadius) {
    return scene.dimension == 1 ? "intervals" : scene.dimension == 2 ? "discs" : "balls";
  }
  if (scene.extents == Extents::kWeight) return "points with weights";
  const auto is_line = [](const SceneObject& object) { return object.line; };
  if (scene.has_lines()) {
    const bool all = std::all_of(scene.objects.begin(), scene.objects.end(), is_line);
    return all ? "lines" : "lines and points";
  }
  std::set<std::string> colours;
  for (const SceneObject& object : scene.objects) {
    if (!object.ends.empty()) return "edges of a graph";
    if (!object.colour.empty()) colours.insert(object.colour);
  }
  if (colours.empty()) return "points";
  return "points of " + counted(colours.size(), "colour", "colours");
}

std::string describe_model(const Scene& scene, const std::string& hash) {
  const PlanCounts counts = count_plans(scene);
  std::string text = "scene     " + shown_name(scene) + "\n";
  text += "hash      " + hash + "\n";
  text += "time      " + short_number(scene.start) +
          (scene.end ? " to " + short_number(*scene.end) : " until no event is left") + "\n";
  text += "objects   " + std::to_string(scene.objects.size()) + " in " +
          counted(static_cast<std::size_t>(scene.dimension), "axis", "axes") + " (" +
          objects_in_words(scene) + "): " + std::to_string(scene.objects.size() - counts.at_rest) +
          " moving in degree " + std::to_string(scene.degree()) + " at most, " +
          std::to_string(counts.at_rest) + " at rest\n";
  if (scene.has_bodies()) text += described_bodies(scene);
  if (scene.extents == Extents::kWeight) {
    text += described_weights(scene);
  } else if (scene.extents != Extents::kNone) {
    text += described_extents(scene);
  }
  if (scene.has_lines()) text += described_lines(scene);
  text += "plan      " + counted(counts.updates, "change", "changes") + ", " +
          counted(counts.insertions, "insertion", "insertions") + ", " +
          counted(counts.erasures, "erasure", "erasures") + "\n";
  text += "maintain  " + maintained(scene) + "\n";
  text += "left out  " + left_out(scene, counts) + "\n";
  return text;
}

std::string explain_model(const Scene& scene, const Simulator& simulator) {
  const Arithmetic& numbers = simulator.arithmetic();
  std::string text = "numbers   " + numbers.name();
  if (numbers.number_model() != numbers.name()) text += ": " + numbers.number_model();
  text += "\n";
  std::set<std::string> told;  // structures may use the same predicate
  for (PredicateId id = 0; id < numbers.predicates(); ++id) {
    const Predicate& predicate = numbers.predicate(id);
    const std::string line =
        std::string(predicate.name()) + " of " +
        counted(static_cast<std::size_t>(predicate.arity()), "object", "objects") + ": degree " +
        std::to_string(predicate.degree(std::max(1, numbers.needs().degree))) + " in t, " +
        numbers.polynomial_model(id);
    if (told.insert(line).second) text += "          " + line + "\n";
  }
  for (std::size_t i = 0; i < numbers.needs().derived.size(); ++i) {
    const DerivedKind& kind = numbers.needs().derived[i];
    text += (i == 0 ? "derives   " : "          ") + kind.name + ": " +
            counted(static_cast<std::size_t>(kind.axes), "axis", "axes") + " of degree " +
            std::to_string(kind.degree) + " in t at most\n";
  }
  const std::vector<PlannedStructure> plan = plan_structures(scene);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const PlannedStructure& p = plan[i];
    text += (i == 0 ? "builds    " : "          ") + plain(p.request.label);
    for (std::size_t j = 0; j < p.watches.size(); ++j) {
      text += (j == 0 ? ", read off " : " and ") + plain(plan[p.watches[j]].request.label);
    }
    if (p.readers > 0) {
      const int users = p.readers + (p.asked ? 1 : 0);
      text += users > 1 ? ", shared by " + std::to_string(users) + " uses" : ", for that alone";
    }
    text += "\n";
  }
  const bool lazy = simulator.options().scheduling == Scheduling::kLazy;
  return text + (lazy ? "schedules lazily: certificates are looked at a few lifetimes ahead\n"
                      : "schedules eagerly: every failure time is computed at once\n");
}

}  // namespace kinex::formats
