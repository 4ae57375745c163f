// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/trace.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/number_defect.h"

namespace kinex::formats {

namespace {

// Appends the piece [from, to], or extends the last piece if it ends at `from` with the same trajectory.
void append_piece(Motion& motion, const Rational& from, const Rational& to, Trajectory trajectory) {
  trajectory.normalise();
  const bool goes_on = !motion.pieces.empty() && motion.pieces.back().to == from;
  if (goes_on && motion.pieces.back().trajectory == trajectory) {
    motion.pieces.back().to = to;
  } else {
    motion.pieces.push_back({from, to, std::move(trajectory)});
  }
}

// What follows the place in a row of --fixed.
std::string fields_of_extents(const Scene& scene) {
  if (scene.extents == Extents::kRadius) return ",RADIUS";
  if (scene.extents == Extents::kWeight) return ",WEIGHT";
  return scene.extents == Extents::kNone
             ? ""
             : std::string(",HX,HY,HZ").substr(0, 3 * static_cast<std::size_t>(scene.dimension));
}

}  // namespace

void add_rotor(Trajectory& trajectory, RotorMotion rotor) {
  for (std::vector<Rational>& part : rotor) trajectory.coordinates.push_back(std::move(part));
}

void append_linear(Motion& motion, const std::vector<Fix>& fixes, bool body) {
  for (std::size_t i = 0; i + 1 < fixes.size(); ++i) {
    const Fix& from = fixes[i];
    const Fix& to = fixes[i + 1];
    Trajectory trajectory;
    for (std::size_t axis = 0; axis < from.position.size(); ++axis) {
      const Rational velocity = (to.position[axis] - from.position[axis]) / (to.t - from.t);
      trajectory.coordinates.push_back({from.position[axis] - velocity * from.t, velocity});
    }
    if (body) add_rotor(trajectory, turning_rotor(from.heading, from.t, to.heading, to.t));
    append_piece(motion, from.t, to.t, std::move(trajectory));
  }
}

void append_steps(Motion& motion, const std::vector<Fix>& fixes, bool body) {
  for (std::size_t i = 0; i + 1 < fixes.size(); ++i) {
    Trajectory trajectory;
    for (const Rational& x : fixes[i].position) trajectory.coordinates.push_back({x});
    if (body) add_rotor(trajectory, fixed_rotor(fixes[i].heading));
    append_piece(motion, fixes[i].t, fixes[i + 1].t, std::move(trajectory));
  }
}

void add_fixed(Scene& scene, const std::string& text, bool body) {
  const std::string option = "--fixed";
  const std::vector<std::string> fields = parse_csv_row(text, option);
  const auto axes = static_cast<std::size_t>(scene.dimension);
  const auto values = axes + static_cast<std::size_t>(scene.extent_axes());
  if (fields.size() != values + 1) {
    throw InputError(
        option, "",
        show_text(text) + " has " + counted(fields.size(), "field", "fields") + ", not " +
            std::to_string(values + 1),
        "write " + std::string("ID,X,Y,Z").substr(0, 2 + 2 * axes) + fields_of_extents(scene));
  }
  check_csv_id(fields[0], option, "");
  for (const SceneObject& object : scene.objects) {
    if (object.id != fields[0]) continue;
    throw InputError(option, "", "there is an object " + show_text(fields[0]) + " already",
                     "give one of them another name");
  }
  Trajectory trajectory;
  for (std::size_t i = 0; i < values; ++i) {
    const std::string& field = fields[i + 1];
    std::optional<Rational> value = csv_number(field);
    if (!value) {
      const NumberDefect defect = number_defect(field, kCsvNumberRemedy);
      throw InputError(option, "",
                       show_text(field) + " in " + show_text(text) + " " + defect.problem,
                       defect.remedy);
    }
    if (i >= axes && scene.extents != Extents::kWeight && value->sign() < 0) {
      throw InputError(option, "", show_text(field) + " in " + show_text(text) + " is negative",
                       std::string("write a ") +
                           (scene.extents == Extents::kRadius ? "radius" : "half extent") +
                           " of 0 or more");
    }
    trajectory.coordinates.push_back({*std::move(value)});
  }
  if (body) add_rotor(trajectory, fixed_rotor(0));
  trajectory.normalise();
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
  scene.objects.push_back({fields[0], std::move(motion)});
}

void check_time(const Scene& scene, const std::string& file, std::vector<std::string>& notes) {
  if (!scene.end) return;
  const Rational &start = scene.start, &end = *scene.end;
  std::vector<std::string> outside;
  std::size_t traces = 0;
  std::optional<Rational> first, last;
  for (const SceneObject& object : scene.objects) {
    const std::vector<MotionPiece>& pieces = object.motion.pieces;
    const std::optional<Rational>&from = pieces.front().from, &to = pieces.back().to;
    if (!from || !to) continue;
    ++traces;
    if (!first || *from < *first) first = from;
    if (!last || *to > *last) last = to;
    const bool there = std::any_of(pieces.begin(), pieces.end(), [&](const MotionPiece& piece) {
      return *piece.from <= end && *piece.to >= start;
    });
    if (!there) outside.push_back(show_text(object.id));
  }
  const std::string fixes =
      traces == 0 ? "" : ": the traces are from " + time_text(*first) + " to " + time_text(*last);
  if (end <= start) {
    throw InputError(file, "",
                     "the scene would end at " + time_text(end) + ", not after its start at " +
                         time_text(start) + fixes,
                     "give --start and --end, the earlier one first");
  }
  if (outside.empty()) return;
  const std::string time = time_text(start) + " to " + time_text(end);
  if (outside.size() == traces) {
    throw InputError(file, "", "no trace is in the time of the scene, " + time + fixes,
                     "give --start and --end within these");
  }
  notes.push_back(counted(outside.size(), "trace is", "traces are") +
                  " outside of the time of the scene, " + time + ": " + some_of(outside));
}

}  // namespace kinex::formats
