// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_properties.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/utf8.h"

namespace kinex::formats {

namespace {

// For messages.
std::string kind_of(Extents extents) {
  return extents == Extents::kWeight ? "weight" : std::string(name_of(extents));
}

std::string half_extent(std::size_t axis) { return std::string("h") + "xyz"[axis]; }

// "--column line= --ignore-columns"
std::string leave_out(const std::string& meaning) {
  return "--column " + meaning + "= --ignore-columns";
}

// A meaning and the name of its column, for messages.
struct Found {
  std::string meaning, name;
};

[[noreturn]] void refuse_together(const std::string& file, const Found& one, const Found& other,
                                  const std::string& why) {
  throw InputError(
      file, "line 1",
      "the columns " + show_text(one.name) + " and " + show_text(other.name) + ": " + why,
      "remove one of them, or give " + leave_out(one.meaning) + ", or " + leave_out(other.meaning));
}

}  // namespace

CsvProperties::CsvProperties(const CsvTable& table, const std::string& file, CsvColumns& columns,
                             const TableForm& form)
    : table_(table), file_(file), traces_(form.traces), axes_(form.axes) {
  if (form.bodies) return;
  take_extents(columns, form);
  if (form.graph) take_graph(columns);
  colour_ = columns.take("colour");
  if (form.axes != 2 || !columns.find("line")) return;
  line_ = columns.take("line");
  if (extents_ == Extents::kNone) return;
  refuse_together(file_, {"line", table_.columns[*line_]}, {names_[0], table_.columns[columns_[0]]},
                  "lines have no " + kind_of(extents_) + ", and points beside them neither");
}

void CsvProperties::take_extents(CsvColumns& columns, const TableForm& form) {
  std::vector<std::pair<Extents, Found>> found;
  const auto look_for = [&](Extents extents, const std::string& meaning) {
    if (!found.empty() && found.back().first == extents) return;
    if (const auto column = columns.find(meaning)) {
      found.push_back({extents, {meaning, table_.columns[*column]}});
    }
  };
  look_for(Extents::kRadius, "radius");
  if (!form.graph) look_for(Extents::kWeight, "weight");  // otherwise it is the place
  for (std::size_t axis = 0; axis < form.axes; ++axis)
    look_for(Extents::kHalfExtents, half_extent(axis));
  if (found.empty()) return;
  if (found.size() > 1) {
    refuse_together(file_, found[0].second, found[1].second,
                    "objects have a radius, a weight or half extents");
  }
  extents_ = found[0].first;
  if (extents_ == Extents::kHalfExtents) {
    for (std::size_t axis = 0; axis < form.axes; ++axis) names_.push_back(half_extent(axis));
  } else {
    names_ = {found[0].second.meaning};
  }
  for (const std::string& name : names_) {
    columns_.push_back(columns.take_required(name, "name a half extent for every axis: hx" +
                                                       std::string(form.axes > 1 ? ",hy" : "") +
                                                       (form.axes > 2 ? ",hz" : "")));
    rates_.push_back(form.traces ? std::nullopt : columns.take("v" + name));
  }
}

void CsvProperties::take_graph(CsvColumns& columns) {
  for (const char* const end : {"from", "to"}) {
    const std::string other = end == std::string("from") ? "to" : "from";
    (end == std::string("from") ? from_ : to_) = columns.take_required(
        end, "name both vertices of an edge, from and to, or neither (" + leave_out(other) + ")");
  }
  if (extents_ == Extents::kNone) return;
  refuse_together(file_, {"from", table_.columns[*from_]}, {names_[0], table_.columns[columns_[0]]},
                  "edges of a graph have no " + kind_of(extents_));
}

Rational CsvProperties::number(const CsvRow& row, std::size_t column) const {
  return csv_number(table_, row, column, file_);
}

std::string CsvProperties::field(const CsvRow& row, std::size_t column) const {
  return show_text(row.fields[column]) + " in column " + show_text(table_.columns[column]);
}

Rational CsvProperties::extent(const CsvRow& row, std::size_t column) const {
  Rational value = number(row, column);
  if (extents_ != Extents::kWeight && value.sign() < 0) {
    throw InputError(file_, place_of_row(row), field(row, column) + " is negative",
                     std::string("write a ") +
                         (extents_ == Extents::kRadius ? "radius" : "half extent") +
                         " of 0 or more");
  }
  return value;
}

void CsvProperties::append(const CsvRow& row, std::vector<Rational>& position) const {
  for (const std::size_t column : columns_) position.push_back(extent(row, column));
}

// With a rate the sign depends on the time: check() has it.
void CsvProperties::append(const CsvRow& row, Trajectory& trajectory) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Rational rate = rates_[i] ? number(row, *rates_[i]) : Rational();
    Rational value = rate.is_zero() ? extent(row, columns_[i]) : number(row, columns_[i]);
    trajectory.coordinates.push_back({std::move(value), std::move(rate)});
  }
}

void CsvProperties::keep(const CsvRow& row, std::size_t column, const std::string& id,
                         const std::string& what, std::string text, Word& word) const {
  if (text.empty()) return;
  if (!is_utf8(text)) {
    throw InputError(file_, place_of_row(row), field(row, column) + " is not UTF-8",
                     "convert the file to UTF-8");
  }
  if (word.line == 0) {
    word = {std::move(text), row.line};
  } else if (word.text != text) {
    throw InputError(file_, place_of_row(row),
                     field(row, column) + ": " + what + " of " + show_text(id) + " is " +
                         show_text(word.text) + " in line " + std::to_string(word.line),
                     "write the same in all rows of an object, or nothing after its first one");
  }
}

std::string CsvProperties::truth(const CsvRow& row) const {
  std::string text = row.fields[*line_];
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (text == "1") return "true";
  if (text == "0") return "false";
  if (text.empty() || text == "true" || text == "false") return text;
  throw InputError(
      file_, place_of_row(row), field(row, *line_) + " is neither true nor false",
      "write true for the line y = a x + b, whose a and b are x and y; a column of other lines: " +
          leave_out("line"));
}

void CsvProperties::read_words(const CsvRow& row, std::size_t object, const std::string& id) {
  if (!colour_ && !from_ && !line_) return;
  if (object >= words_.size()) words_.resize(object + 1);
  Words& words = words_[object];
  if (colour_) keep(row, *colour_, id, "the colour", row.fields[*colour_], words.colour);
  if (line_) keep(row, *line_, id, "the value", truth(row), words.line);
  if (!from_) return;
  const std::string &from = row.fields[*from_], &to = row.fields[*to_];
  if (from.empty() != to.empty()) {
    throw InputError(file_, place_of_row(row),
                     field(row, from.empty() ? *from_ : *to_) + ": an edge with one vertex, " +
                         show_text(from.empty() ? to : from),
                     "write both vertices, or neither for a point");
  }
  if (!from.empty() && from == to) {
    throw InputError(file_, place_of_row(row),
                     field(row, *to_) + ": an edge from that vertex to itself",
                     "write two different vertices");
  }
  keep(row, *from_, id, "the first vertex", from, words.from);
  keep(row, *to_, id, "the second vertex", to, words.to);
}

void CsvProperties::finish(std::size_t number, SceneObject& object) const {
  if (number >= words_.size()) return;
  const Words& words = words_[number];
  object.colour = words.colour.text;
  if (words.from.line != 0) object.ends = {words.from.text, words.to.text};
  object.line = words.line.text == "true";
}

void CsvProperties::check(const SceneObject& object, const CsvRow& row, const Scene& scene) const {
  if (extents_ != Extents::kRadius && extents_ != Extents::kHalfExtents) return;
  if (traces_) {
    check_trace(object, row, scene);
  } else {
    check_rates(object, row, scene);
  }
}

void CsvProperties::fail_negative(const SceneObject& object, const CsvRow& row, std::size_t axis,
                                  const std::string& when, const std::string& remedy) const {
  const std::size_t column = rates_[axis].value_or(columns_[axis]);
  throw InputError(file_, place_of_row(row),
                   field(row, column) + ": the " +
                       (extents_ == Extents::kRadius ? "radius" : "half extent") + " of " +
                       show_text(object.id) + " is negative " + when,
                   remedy);
}

// Between two fixes it is not negative, since it is not at either of them.
void CsvProperties::check_trace(const SceneObject& object, const CsvRow& row,
                                const Scene& scene) const {
  const MotionPiece& last = object.motion.pieces.back();
  if (*last.to <= scene.start || (scene.end && *scene.end < *last.to)) return;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::vector<Rational>& values = last.trajectory.coordinates[axes_ + i];
    const bool shrinks = values.size() > 1 && values[1].sign() < 0;
    if (!shrinks || !last.trajectory.position(static_cast<int>(axes_ + i), *last.to).is_zero())
      continue;
    fail_negative(object, row, i, "right after its last fix, if it goes on",
                  "add a fix at which it still is 0, or end the scene before: --end");
  }
}

void CsvProperties::check_rates(const SceneObject& object, const CsvRow& row,
                                const Scene& scene) const {
  const Trajectory& trajectory = object.motion.pieces.back().trajectory;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::vector<Rational>& values = trajectory.coordinates[axes_ + i];
    if (values.size() < 2) continue;  // it is constant, and has been checked
    const Rational zero = -values[0] / values[1];
    if (values[1].sign() > 0) {
      if (zero <= scene.start) continue;
      fail_negative(object, row, i, "until " + time_text(zero), "start the scene then: --start");
    } else if (zero <= scene.start) {
      fail_negative(object, row, i, "right after the scene's start at " + time_text(scene.start),
                    "write a greater one, or a rate that is not negative");
    } else if (!scene.end || zero <= *scene.end) {
      fail_negative(object, row, i, "right after " + time_text(zero),
                    "end the scene before: --end");
    }
  }
}

std::string why_without_meaning(const std::string& meaning, const TableForm& form) {
  const std::vector<std::string>& all = meanings_of_objects();
  if (std::find(all.begin(), all.end(), meaning) == all.end()) return {};
  if (form.bodies) return "objects with polygons have none";
  const std::string axes = "the table has " + counted(form.axes, "axis", "axes");
  if (meaning == "line") return axes + ", lines are in tables of 2";
  if (meaning == "from" || meaning == "to") return axes + ", edges of a graph are in tables of 1";
  if (meaning == "hy" || meaning == "hz") return axes;
  if (meaning.front() != 'v') return {};
  if (form.traces) return "traces have values at fixes, no rates";
  return "there is no column " + show_text(meaning.substr(1));
}

std::string text_of_kinds(const Scene& scene) {
  const std::size_t lines = static_cast<std::size_t>(
      std::count_if(scene.objects.begin(), scene.objects.end(),
                    [](const SceneObject& object) { return object.line; }));
  const std::size_t edges = static_cast<std::size_t>(
      std::count_if(scene.objects.begin(), scene.objects.end(),
                    [](const SceneObject& object) { return !object.ends.empty(); }));
  std::set<std::string> colours;
  for (const SceneObject& object : scene.objects) {
    if (!object.colour.empty()) colours.insert(object.colour);
  }
  const std::size_t special = lines + edges;
  std::string kinds = lines > 0 ? "lines" : edges > 0 ? "edges of a graph" : "";
  if (special < scene.objects.size()) {
    kinds += kinds.empty() ? "" : " and ";
    kinds += scene.extents == Extents::kRadius        ? "discs"
             : scene.extents == Extents::kHalfExtents ? "boxes"
             : scene.extents == Extents::kWeight      ? "points with weights"
                                                      : "points";
  }
  if (kinds == "points" && colours.empty()) return {};
  if (!colours.empty()) kinds += " of " + counted(colours.size(), "colour", "colours");
  return "the objects are " + kinds;
}

}  // namespace kinex::formats
