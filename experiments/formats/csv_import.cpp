// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_import.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/csv_columns.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/csv_properties.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/heading.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/trace.h"

namespace kinex::formats {

namespace {

constexpr const char* kColumns =
    "name the columns id,t,x[,y[,z]] (traces) or id,x[,y[,z]],vx[,vy[,vz]] (velocities)";
constexpr const char* kGraphColumns =
    "name the columns of edges id,t,from,to,weight (traces) or id,from,to,weight,vweight "
    "(velocities)";

class Importer {
 public:
  Importer(CsvTable table, const std::string& file, const ImportOptions& options)
      : table_(std::move(table)),
        file_(file),
        options_(options),
        columns_(table_, file_, options_.columns),
        form_(find_form()) {
    id_ = columns_.take_required("id", kColumns);
    time_ = columns_.take("t");
    take_coordinates();
    if (options_.polygons) check_plane();
    form_.axes = coordinates_.size();
    properties_.emplace(table_, file_, columns_, form_);
    if (options_.heading) find_heading();
    check_unused();
    tell_columns();
  }

  ImportReport import() {
    if (table_.rows.empty()) throw InputError(file_, "", "there are no rows", "write one per fix");
    report_.rows = table_.rows.size();
    report_.scene.dimension = static_cast<int>(coordinates_.size());
    report_.scene.extents = properties_->extents();
    if (time_) {
      import_traces();
    } else {
      import_velocities();
    }
    if (report_.scene.objects.empty()) {
      throw InputError(
          file_, "", "no object has two fixes: " + some_of(report_.single_fixes),
          "write at least two fixes of one id, or name the column of ids: --column id=NAME");
    }
    for (const std::string& row : options_.fixed)
      add_fixed(report_.scene, row, options_.polygons.has_value());
    check_time(report_.scene, file_, report_.notes);
    for (std::size_t i = 0; i < last_rows_.size(); ++i) {
      properties_->check(report_.scene.objects[i], *last_rows_[i], report_.scene);
    }
    if (const std::string kinds = text_of_kinds(report_.scene);
        !kinds.empty() && !options_.polygons) {
      report_.notes.push_back(kinds);
    }
    report_.scene.overlapping_starts = options_.overlapping_starts;
    if (options_.polygons) {
      make_bodies(report_.scene, *options_.polygons, {file_, lines_});
    } else {
      refuse_overlapping_points(report_.scene);
    }
    return std::move(report_);
  }

 private:
  struct FixOfRow : Fix {
    const CsvRow* row;
  };

  // A table of edges of a graph has no y.
  TableForm find_form() const {
    TableForm form{0, columns_.find("t").has_value(), options_.polygons.has_value(), false};
    form.graph =
        !form.bodies && !columns_.find("y") && (columns_.find("from") || columns_.find("to"));
    return form;
  }

  void take_coordinates() {
    std::vector<std::string> names{"x", "y", "z"};
    std::string remedy = kColumns;
    if (form_.graph) {
      const auto x = columns_.find("x"), weight = columns_.find("weight");
      if (x && weight) {
        throw InputError(file_, "line 1",
                         "the columns " + show_text(table_.columns[*x]) + " and " +
                             show_text(table_.columns[*weight]) +
                             ": an edge of a graph has one weight, its x",
                         "remove one of them, or give --column weight= --ignore-columns");
      }
      if (!x) names = {"weight"};
      remedy = kGraphColumns;
    }
    for (const std::string& name : names) {
      const auto coordinate = columns_.take(name);
      if (!coordinate) break;
      coordinates_.push_back(*coordinate);
    }
    if (coordinates_.empty()) columns_.take_required(names[0], remedy);
    if (time_) return;
    for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
      velocities_.push_back(
          columns_.take_required("v" + names[axis], remedy, axis == 0 ? "t" : ""));
    }
  }

  // "ignored: speed", "fields are separated by semicolons".
  void tell_columns() {
    report_.details.push_back(columns_.text());
    std::string ignored;
    for (const std::size_t column : columns_.unused()) {
      ignored += (ignored.empty() ? "" : ", ") + table_.columns[column];
    }
    if (!ignored.empty()) report_.details.push_back("ignored: " + ignored);
    if (table_.separator == ',') return;
    report_.details.push_back(std::string("fields are separated by ") +
                              (table_.separator == ';' ? "semicolons" : "tabs"));
  }

  std::optional<Rational> start() const {
    return options_.start_time ? scale_.read(*options_.start_time) : options_.start;
  }
  std::optional<Rational> end() const {
    return options_.end_time ? scale_.read(*options_.end_time) : options_.end;
  }

  Rational time(const CsvRow& row) {
    const std::string& field = row.fields[*time_];
    return scale_.read(field, file_, place_of_row(row),
                       show_text(field) + " in column " + show_text(table_.columns[*time_]));
  }

  void check_plane() const {
    if (coordinates_.size() == 2) return;
    throw InputError(file_, "line 1",
                     "bodies have 2 axes, the table has " + std::to_string(coordinates_.size()),
                     "name the columns x and y, or leave --polygons out");
  }

  void find_heading() {
    const std::string option = options_.heading->compass ? "--bearing" : "--heading";
    const std::string& name = options_.heading->column;
    if (!options_.polygons) {
      throw InputError(option, "", "points have no heading",
                       "give --polygons too, or leave it out");
    }
    heading_ = table_.column(name);
    if (!heading_) {
      throw InputError(file_, "line 1",
                       "there is no column " + show_text(name) + ", the one of " + option,
                       "name a column of the table");
    }
    if (columns_.is_used(*heading_)) {
      throw InputError(option, "", "the column " + show_text(name) + " has another meaning",
                       "name a column of angles in degrees");
    }
    columns_.use(*heading_, options_.heading->compass ? "bearing" : "heading");
  }

  // Columns without a meaning, unless they are ignored.
  void check_unused() {
    const std::vector<std::size_t> unused = columns_.unused();
    report_.ignored_columns = unused.size();
    for (const std::size_t column : unused) {
      if (!columns_.is_named(column)) continue;
      const std::string meaning = columns_.meaning_of(column);
      const std::string why = why_without_meaning(meaning, form_);
      throw InputError("--column", "",
                       meaning + "=" + table_.columns[column] + " has no use here" +
                           (why.empty() ? "" : ": " + why),
                       "leave it out");
    }
    if (!unused.empty() && !options_.ignore_columns) fail_unused(unused.front());
  }

  [[noreturn]] void fail_unused(std::size_t number) const {
    const std::string& column = table_.columns[number];
    std::string problem = "the column " + show_text(column) + " means nothing here";
    if (const std::string options = columns_.capitals(); !options.empty()) {
      throw InputError(file_, "line 1", problem + "; capitals matter",
                       "write the names in small letters, or give" + options + ", or --ignore-columns");
    }
    const std::string meaning = columns_.meaning_of(number);
    if (const std::string why = why_without_meaning(meaning, form_); !why.empty()) {
      throw InputError(file_, "line 1", problem + ": " + why,
                       "remove it, or give --ignore-columns");
    }
    if (!options_.polygons) {
      const std::string usual = std::string(kColumns) + ", or give --ignore-columns for the others";
      const std::string near = did_you_mean(column, long_names(), "");
      throw InputError(file_, "line 1", problem,
                       near.empty() ? usual : near + " Otherwise give --ignore-columns");
    }
    std::string remedy =
        "remove it, or name it with --heading or --bearing, or give --ignore-columns";
    if (!form_.traces) {
      remedy +=
          "; a body that turns is written as traces, for no rotor that is polynomial turns at a "
          "constant rate";
    }
    throw InputError(file_, "line 1", problem, remedy);
  }

  // The meanings that can be misspelt.
  std::vector<std::string> long_names() const {
    std::vector<std::string> names;
    for (const std::string& meaning : meanings_of_objects()) {
      if (meaning.size() > 3 && why_without_meaning(meaning, form_).empty() &&
          !columns_.find(meaning)) {
        names.push_back(meaning);
      }
    }
    return names;
  }

  Rational number(const CsvRow& row, std::size_t column) const {
    return csv_number(table_, row, column, file_);
  }

  const std::string& id(const CsvRow& row) const {
    check_csv_id(row.fields[id_], file_, place_of_row(row));
    return row.fields[id_];
  }

  // Counter-clockwise from the x axis, in [0, 360); 0 where the table has none.
  Rational heading(const CsvRow& row) const {
    if (!heading_) return {};
    const Rational degrees = number(row, *heading_);
    if (degrees < Rational(-360) || degrees > Rational(360)) {
      throw InputError(file_, place_of_row(row),
                       show_text(row.fields[*heading_]) + " in column " +
                           show_text(table_.columns[*heading_]) + " is not an angle",
                       "write degrees from -360 to 360; leave out rows without a heading");
    }
    return options_.heading->compass ? heading_of_bearing(degrees) : reduced_heading(degrees);
  }

  void import_velocities() {
    Scene& scene = report_.scene;
    scale_.settle(options_.time_zero);
    scene.start = start().value_or(Rational(0));
    scene.end = end();
    for (const CsvRow& row : table_.rows) {
      const auto [other, is_new] = lines_.emplace(id(row), row.line);
      if (!is_new) {
        throw InputError(file_, place_of_row(row),
                         "the id " + show_text(id(row)) + " is that of line " +
                             std::to_string(other->second) + " too",
                         "give one of the two another id, or leave one of the rows out");
      }
      Trajectory trajectory;
      for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
        trajectory.coordinates.push_back(
            {number(row, coordinates_[axis]), number(row, velocities_[axis])});
      }
      if (options_.polygons) add_rotor(trajectory, fixed_rotor(heading(row)));
      properties_->append(row, trajectory);
      trajectory.normalise();
      Motion motion;
      motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
      const std::size_t number = scene.objects.size();
      properties_->read_words(row, number, id(row));
      add_object(id(row), std::move(motion), number, row);
    }
  }

  // `number`: of the object in the table, by first rows; `last`: its last row.
  void add_object(const std::string& name, Motion motion, std::size_t number, const CsvRow& last) {
    report_.scene.objects.push_back({name, std::move(motion)});
    properties_->finish(number, report_.scene.objects.back());
    last_rows_.push_back(&last);
  }

  void import_traces() {
    std::vector<std::pair<std::string, std::vector<FixOfRow>>> traces;  // in order of first rows
    std::unordered_map<std::string, std::size_t> numbers;
    for (const CsvRow& row : table_.rows) {
      const auto [entry, is_new] = numbers.emplace(id(row), traces.size());
      if (is_new) {
        traces.emplace_back(id(row), std::vector<FixOfRow>{});
        lines_.emplace(id(row), row.line);
      }
      FixOfRow fix{{time(row), {}, heading(row)}, &row};
      for (const std::size_t column : coordinates_) fix.position.push_back(number(row, column));
      properties_->append(row, fix.position);
      properties_->read_words(row, entry->second, entry->first);
      traces[entry->second].second.push_back(std::move(fix));
    }
    const Rational zero = scale_.settle(options_.time_zero);
    report_.time_zero = scale_.zero_text();
    std::optional<Rational> first, last;
    for (std::size_t number = 0; number < traces.size(); ++number) {
      auto& [name, fixes] = traces[number];
      for (FixOfRow& fix : fixes) fix.t -= zero;
      sort_fixes(fixes);
      if (!first || fixes.front().t < *first) first = fixes.front().t;
      if (!last || fixes.back().t > *last) last = fixes.back().t;
      if (fixes.size() == 1) {
        report_.single_fixes.push_back(show_text(name) + " (" + place_of_row(*fixes.front().row) +
                                       ")");
        continue;
      }
      Motion motion;
      append_linear(motion, {fixes.begin(), fixes.end()}, options_.polygons.has_value());
      add_object(name, std::move(motion), number, *fixes.back().row);
    }
    report_.scene.start = start().value_or(*first);
    const std::optional<Rational> until = end();
    report_.scene.end = until ? until : last;
  }

  // Of two fixes at one time.
  std::string difference(const Fix& one, const Fix& other) const {
    const auto axes = static_cast<std::ptrdiff_t>(coordinates_.size());
    if (!std::equal(one.position.begin(), one.position.begin() + axes, other.position.begin())) {
      return form_.graph ? " has another weight" : " is at another place";
    }
    if (one.heading != other.heading) return " has another heading";
    const Extents extents = properties_->extents();
    return extents == Extents::kRadius        ? " has another radius"
           : extents == Extents::kHalfExtents ? " has other half extents"
                                              : " has another weight";
  }

  // Ascending in time, each time once.
  void sort_fixes(std::vector<FixOfRow>& fixes) {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const FixOfRow& a, const FixOfRow& b) { return a.t < b.t; });
    std::vector<FixOfRow> kept;
    for (FixOfRow& fix : fixes) {
      if (kept.empty() || kept.back().t != fix.t) {
        kept.push_back(std::move(fix));
        continue;
      }
      if (kept.back().position != fix.position || kept.back().heading != fix.heading) {
        throw InputError(file_, place_of_row(*fix.row),
                         show_text(id(*fix.row)) + difference(kept.back(), fix) +
                             " at the same time in line " + std::to_string(kept.back().row->line),
                         "remove one of the two fixes");
      }
      ++report_.repeated_fixes;
    }
    fixes = std::move(kept);
  }

  CsvTable table_;
  const std::string& file_;
  const ImportOptions& options_;
  CsvColumns columns_;
  TableForm form_;
  std::optional<CsvProperties> properties_;
  std::size_t id_;
  std::optional<std::size_t> time_, heading_;
  std::vector<std::size_t> coordinates_, velocities_;
  TimeScale scale_;
  std::unordered_map<std::string, std::size_t> lines_;  // of the first row of each id
  std::vector<const CsvRow*> last_rows_;                // of each object of the table
  ImportReport report_;
};

}  // namespace

ImportReport import_csv(std::string_view text, const std::string& file,
                        const ImportOptions& options) {
  return Importer(parse_csv(text, file, options.separator), file, options).import();
}

}  // namespace kinex::formats
