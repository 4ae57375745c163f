// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_scene_check.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "experiments/formats/grid_line.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/log_rules.h"
#include "experiments/formats/log_scene.h"
#include "predicates/points/edge_predicates.h"
#include "predicates/points/extent_predicates.h"
#include "predicates/points/gap_predicates.h"
#include "predicates/points/line_distance_order.h"
#include "predicates/points/line_predicates.h"
#include "predicates/points/power_predicates.h"
#include "predicates/points/shared_arguments.h"
#include "predicates/points/space_predicates.h"
#include "predicates/predicates.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

// Two points, one straight above the other or beside it, at all times.
bool are_level(std::span<const Trajectory* const> points) {
  if (points.size() != 2) return false;
  const auto &a = points[0]->coordinates, &b = points[1]->coordinates;
  for (std::size_t axis = 0; axis < std::min(a.size(), b.size()); ++axis) {
    if (a[axis] == b[axis]) return true;
  }
  return false;
}

}  // namespace

LogSceneCheck::LogSceneCheck(const LogHeader& header, const Scene& scene, const std::string& hash,
                             std::vector<std::string>& problems)
    : scene_(scene), is_of_scene_(header.scene_hash == hash), motions_(scene) {
  const auto complain = [&problems](const std::string& what) {
    problems.push_back("line 1: " + what);
  };
  if (header.scene_hash != hash) {
    complain("the log is of a scene with hash " + header.scene_hash + ", the scene has " + hash +
             "; its records are not compared with that: give the scene that was run");
  }
  if (header.scene != scene.name) {
    complain("the scene's name is " + show_text(scene.name) + ", not " + show_text(header.scene));
  }
  std::vector<std::string> objects;
  for (const SceneObject& object : scene.objects) {
    objects_.emplace(object.id, static_cast<ObjectId>(objects.size()));
    objects.push_back(object.id);
  }
  if (header.objects != objects) complain("\"objects\" are not those of the scene, in its order");
  Scene maintaining = scene;
  try {
    maintain_as_logged(maintaining, header, "");
    if (!maintains_as_logged(maintaining, header)) {
      complain("a run of the scene would not have these structures");
    }
    const std::vector<PlannedStructure> plan = plan_structures(maintaining);
    for (const PlannedStructure& planned : plan) {
      std::set<std::string>& watched = watched_[planned.request.label];
      for (const StructureId read : planned.watches) {
        const std::string& label = plan[read].request.label;
        watched.insert(label);
        watched.insert(watched_[label].begin(), watched_[label].end());
      }
      const StructureInfo& info = *find_structure_info(planned.request.structure);
      if (info.uses_key) keys_.emplace(planned.request.label, planned.request.key);
      if (auto vectors = directions_of(info, planned.request, scene.dimension); !vectors.empty()) {
        directions_.emplace(planned.request.label, std::move(vectors));
      }
      if (info.fails_at_touch) touching_.insert(planned.request.label);
      if (info.group == "mst_maximum_norm" || info.group == "mst_polygon")
        turned_.insert(planned.request.label);
    }
  } catch (const InputError& error) {
    complain("a run of the scene cannot have these structures: " + error.problem());
  }
}

std::string LogSceneCheck::check(const LogRecord& record, RealRoot* instant) {
  note_change(record, instant);
  if (instant != nullptr) note_instant(record);
  if (const std::string problem = feature_problem(record.ids); !problem.empty()) return problem;
  if (!record.certificate) return "";
  if (instant == nullptr || lost_ || scene_.has_bodies()) {
    ++(scene_.has_bodies() ? unchecked_.of_bodies : unchecked_.without_instant);
    return "";
  }
  return check_certificate(record, *instant);
}

std::string LogSceneCheck::check(const LogEnd& end) const {
  if (!end.reached) {
    return scene_.end ? "\"reached\" is null, and the scene has an end" : "";
  }
  if (*end.reached < scene_.start || (scene_.end && *scene_.end < *end.reached)) {
    return "\"reached\" is outside of the scene's time";
  }
  return "";
}

void LogSceneCheck::note_change(const LogRecord& record, RealRoot* instant) {
  const bool inserted = record.kind == "insert";
  if ((record.kind != "motion" && !inserted) || record.ids.size() != 1) return;
  const auto object = objects_.find(record.ids[0]);
  if (object == objects_.end()) return;
  if (instant == nullptr || !instant->is_rational()) {
    lost_ = true;  // no motion changes at such a time, or it is not known
    return;
  }
  const Rational t = instant->value();
  motions_.changed(object->second, t);
  if (appeared_at_ != t) {
    appeared_.clear();
    moved_.clear();
  }
  appeared_at_ = t;
  (inserted ? appeared_ : moved_).push_back(record.ids[0]);
}

void LogSceneCheck::note_instant(const LogRecord& record) {
  if (record.time.root != instant_root_ || record.time.polynomial != instant_polynomial_) {
    instant_root_ = record.time.root;
    instant_polynomial_ = record.time.polynomial;
    changed_.clear();
    rearranged_.clear();
    for (auto& [label, doubt] : doubts_) late_.push_back(std::move(doubt));
    doubts_.clear();
  }
  again_ = !changed_.insert(record.structure).second;
  for (const char* kind : {"blocked", "reinsert", "rebuild", "settled"}) {
    if (record.kind != kind) continue;
    rearranged_.insert(record.structure);
    if (record.kind != "settled") doubts_.erase(record.structure);
  }
  // After an exchange of two edges others may be compared, in the order of the turn since long.
  if (again_ && turned_.count(record.structure) == 1) rearranged_.insert(record.structure);
}

// A triangulation may have made such certificates before it finds that the instant is degenerate.
std::string LogSceneCheck::put_off(const LogRecord& record, const std::string& problem) {
  if (!again_) return problem;
  doubts_.emplace(record.structure, LateProblem{record.line, problem});
  return "";
}

std::vector<LogSceneCheck::LateProblem> LogSceneCheck::late_problems(bool at_end) {
  for (auto& [label, doubt] : doubts_) {
    if (at_end) late_.push_back(std::move(doubt));
  }
  if (at_end) doubts_.clear();
  return std::exchange(late_, {});
}

// A certificate that is made in the midst of an instant can be negative at once: after a repair of
// several things, and where the structure follows a change of what it watches.
bool LogSceneCheck::may_be_made_negative(const LogRecord& record) const {
  if (rearranged_.count(record.structure) == 1) return true;
  const auto watched = watched_.find(record.structure);
  if (watched == watched_.end() || record.external) return false;
  return std::any_of(watched->second.begin(), watched->second.end(),
                     [this](const std::string& label) { return changed_.count(label) == 1; });
}

// The order of a point and a line of a grid; null: the certificate is about something else.
std::shared_ptr<const Predicate> LogSceneCheck::order_on_grid(const LogCertificate& said) const {
  const bool has_line = std::any_of(said.ids.begin(), said.ids.end(), [this](const std::string& id) {
    return objects_.count(id) == 0 && grid_line(id);
  });
  for (int axis = 0; has_line && axis < scene_.dimension; ++axis) {
    std::shared_ptr<const Predicate> order = make_coordinate_order(axis);
    if (order->name() == said.predicate) return order;
  }
  return nullptr;
}

std::string LogSceneCheck::check_certificate(const LogRecord& record, RealRoot& instant) {
  const LogCertificate& said = *record.certificate;
  const auto meanings = directions_.find(record.structure);
  const auto along = meanings == directions_.end() ? std::nullopt : DirectionMeanings::arity_of(said.predicate);
  const std::shared_ptr<const Predicate> on_grid = order_on_grid(said);
  const Predicate* known = along     ? nullptr
                           : on_grid ? on_grid.get()
                                     : predicate(record.structure, said.predicate);
  std::array<const Trajectory*, kMaxArity> motions{};
  std::array<Trajectory, kMaxArity> lines;  // of grids, which do not move
  const bool fits = along ? said.ids.size() == *along
                          : known != nullptr && said.ids.size() == static_cast<std::size_t>(known->arity());
  for (std::size_t i = 0; fits && i < said.ids.size(); ++i) {
    const auto object = objects_.find(said.ids[i]);
    if (object != objects_.end()) {
      motions[i] = motions_.of(object->second);
    } else if (const auto at = grid_line(said.ids[i])) {
      lines[i].coordinates.assign(static_cast<std::size_t>(scene_.dimension), {*at});
      motions[i] = &lines[i];
    }
  }
  const std::span<const Trajectory* const> of(motions.data(), fits ? said.ids.size() : 0);
  if (!fits || std::find(of.begin(), of.end(), nullptr) != of.end()) {
    ++unchecked_.unsaid[said.predicate];
    return "";
  }
  ++certificates_;
  const bool at_changes = appeared_at_ && compare(instant, *appeared_at_, counters_) == 0;
  const auto share = [](const std::vector<std::string>& some,
                        const std::vector<std::string>& others) {
    return std::find_first_of(some.begin(), some.end(), others.begin(), others.end()) != some.end();
  };
  const bool fresh = at_changes && share(said.ids, appeared_);
  // The claim of a tie that a new flight plan has made, or of two points that have become neighbours.
  const bool of_tie =
      (at_changes && (share(said.ids, moved_) || share(record.ids, moved_))) ||
      (again_ && known != nullptr && known->name().starts_with("order_") && are_level(of));
  const auto problem_if = [&](const Failure& failure) {
    if (along) return direction_problem(meanings->second, said.predicate, of, failure, instant);
    return polynomial_problem(certificate_polynomial(*known, of), failure, instant);
  };
  Failure failure{!fresh && !of_tie && !may_be_made_negative(record),
                  fresh || touching_.count(record.structure) == 0};
  const std::string problem = problem_if(failure);
  if (problem.empty() || !failure.vanishes) return problem;
  failure.vanishes = false;
  return problem_if(failure).empty() ? put_off(record, problem) : problem;
}

std::string LogSceneCheck::polynomial_problem(const Polynomial& polynomial, const Failure& failure,
                                              RealRoot& instant) {
  if (polynomial.is_zero()) return "its certificate is identically zero and cannot fail";
  if (failure.vanishes && sign_at(polynomial, instant, counters_) != Sign::kZero) {
    return "its certificate does not vanish at that time";
  }
  if (failure.negative_after && sign_after(polynomial, instant, counters_) != Sign::kNegative) {
    return "its certificate is not negative right after that time";
  }
  return "";
}

std::string LogSceneCheck::direction_problem(const DirectionMeanings& meanings,
                                             const std::string& predicate,
                                             std::span<const Trajectory* const> of,
                                             const Failure& failure, RealRoot& instant) {
  std::optional<DirectionMeanings::Instant> vanishing;
  if (failure.vanishes) {
    instant.refine_to(60, counters_);
    vanishing = {instant.lower_double(), instant.upper_double()};
  }
  const bool found = meanings.any(predicate, of, vanishing, [&](const Predicate& meaning) {
    return polynomial_problem(certificate_polynomial(meaning, of), failure, instant).empty();
  });
  if (found) return "";
  return "its certificate does not fail at that time, along whatever vectors of the structure";
}

// "ferry.v2": the body has a vertex of that number.
std::string LogSceneCheck::feature_problem(const std::vector<std::string>& ids) const {
  for (const std::string& id : ids) {
    if (objects_.count(id) == 1) continue;
    const std::size_t dot = id.rfind('.');
    const auto body = dot == std::string::npos ? objects_.end() : objects_.find(id.substr(0, dot));
    if (body == objects_.end() || dot + 2 >= id.size()) continue;  // reported elsewhere
    const std::string number = id.substr(dot + 2);
    const std::size_t vertices = scene_.objects[body->second].polygon.size();
    const std::optional<Integer> place = Integer::parse(number);
    if (place && place->to_string() == number && *place < Integer(static_cast<long>(vertices))) {
      continue;
    }
    return "the scene's " + show_text(body->first) + " has no " + show_text(id.substr(dot + 1));
  }
  return "";
}

namespace {

// Of discs, boxes and points with weights, by its name; null: none of the scene.
std::shared_ptr<const Predicate> make_extent_predicate(const Scene& scene, std::string_view name) {
  if (name == "power_2" && scene.dimension == 2) return make_power_2();
  if (name == "power_3" && scene.dimension == 3) return make_power_3();
  const bool discs = scene.extents == Extents::kRadius;
  for (const auto& [first, second] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    if (scene.dimension != 3) break;
    const auto power = make_power_lifted(first, second);
    if (power->name() == name) return power;
    const auto of_discs = make_disc_power_lifted(first, second);
    if (discs && of_discs->name() == name) return of_discs;
  }
  if (scene.extents == Extents::kNone || scene.extents == Extents::kWeight) return nullptr;
  if (discs && scene.dimension == 2 && name == "disc_power_2") return make_disc_power_2();
  if (discs && scene.dimension == 3 && name == "disc_power_3") return make_disc_power_3();
  if (discs && name == "disc_overlap") return make_disc_overlap(scene.dimension);
  if (discs && name == "disc_apart") return make_disc_apart(scene.dimension);
  if (discs && (name.starts_with("gap_") || name.starts_with("radius_order"))) {
    for (const GapTerm term :
         {GapTerm::kRadii, GapTerm::kLeft, GapTerm::kRight, GapTerm::kProduct}) {
      for (const bool negated : {false, true}) {
        std::shared_ptr<const Predicate> claim = make_gap_claim(term, negated, scene.dimension);
        if (claim->name() == name) return claim;
      }
    }
  }
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const EndAxes axes{axis, scene.dimension + (discs ? 0 : axis), scene.dimension};
    for (const EndClaim claim :
         {EndClaim::kLowerEnds, EndClaim::kUpperEnds, EndClaim::kMeeting, EndClaim::kApart}) {
      std::shared_ptr<const Predicate> order = make_end_order(claim, axes);
      if (order->name() == name) return order;
    }
    for (std::shared_ptr<const Predicate> width : {make_half_width(axes), make_no_width(axes)}) {
      if (width->name() == name) return width;
    }
  }
  return nullptr;
}

}  // namespace

std::shared_ptr<const Predicate> LogSceneCheck::make_predicate(const std::string& label,
                                                               const std::string& name) const {
  if (name == "orientation_2") return make_orientation_2();
  if (name == "slope_order_2") return make_slope_order_2();
  if (name == "in_circle_2") return make_in_circle_2();
  if (name == "orientation_3") return make_orientation_3();
  if (name == "in_sphere_3") return make_in_sphere_3();
  if (name == "unfolded_3") return make_unfolded_3();
  if (name == "obtuse_angle_3") return make_obtuse_angle_3();
  for (const auto& [first, second] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    for (const auto& of_plane :
         {make_projected_orientation(first, second), make_in_circle_lifted(first, second)}) {
      if (of_plane->name() == name) return of_plane;
    }
  }
  if (name == "acute_angle_2") return make_acute_angle_2();
  if (name == "obtuse_angle_2") return make_obtuse_angle_2();
  if (name == "edge_dot_2") return make_edge_dot_2();
  if (name == "order_strip") return make_strip_order_2();
  if (name == "order_rectangle_area") return make_rectangle_area_order_2();
  if (name == "order_rectangle_perimeter") return make_rectangle_perimeter_order_2();
  if (name == "line_side") return make_line_side();
  if (name == "line_under") return make_line_under();
  if (name == "line_order") return make_line_order();
  if (name == "order_line_height") return make_line_distance_order(LineMeasure::kHeight);
  if (name == "order_line_distance") return make_line_distance_order(LineMeasure::kDistance);
  if (name == "order_pair_distance") return make_pair_distance_order(scene_.dimension);
  if (name == "order_squared_distance") return make_squared_distance_order(scene_.dimension);
  // Whether the structure has a key or not.
  for (int axis = 0; axis < scene_.dimension; ++axis) {
    std::shared_ptr<const Predicate> order = make_coordinate_order(axis);
    if (order->name() == name) return order;
  }
  if (auto of_extents = make_extent_predicate(scene_, name)) return of_extents;
  if (const std::size_t slash = name.find('/'); slash != std::string::npos) {
    const std::shared_ptr<const Predicate> whole = make_predicate(label, name.substr(0, slash));
    if (whole == nullptr || !arity_of(name)) return nullptr;
    std::vector<std::uint8_t> pattern;
    for (const char c : name.substr(slash + 1)) {
      pattern.push_back(static_cast<std::uint8_t>(c - '0'));
    }
    return make_shared_arguments(whole, pattern);
  }
  const auto key = keys_.find(label);
  if (key == keys_.end()) return nullptr;
  if (!name.starts_with("order_")) return nullptr;  // of slopes and heights: no functions of time
  std::shared_ptr<const Predicate> order = make_key_order(key->second, scene_.dimension);
  return order->name() == name ? order : nullptr;
}

const Predicate* LogSceneCheck::predicate(const std::string& label, const std::string& name) {
  const auto [place, is_new] = predicates_.try_emplace({label, name});
  if (is_new) place->second = make_predicate(label, name);
  return place->second.get();
}

}  // namespace kinex::formats
