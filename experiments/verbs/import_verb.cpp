// SPDX-License-Identifier: GPL-3.0-or-later
// kinex import: a table of traces or velocities, GeoJSON or Moving Features to a scene.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "core/numbers/time_text.h"
#include "experiments/formats/box_queries.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/csv_columns.h"
#include "experiments/formats/csv_import.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/moving_features.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/colours.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/structure_for.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct ImportVerbOptions {
  std::string file, start, end, time_zero, separator, name, output;
  std::vector<std::string> columns;
  bool ignore_columns = false;
  std::optional<std::string> polygons, heading, bearing, overlapping_starts;
  std::vector<std::string> maintain, fixed;
  std::optional<std::string> local;
  bool linear = false, planar = false;
  bool force = false;
};

OverlappingStarts overlapping_starts(const ImportVerbOptions& options) {
  if (!options.overlapping_starts) return OverlappingStarts::kRefused;
  const std::string option = "--overlapping-starts";
  if (*options.overlapping_starts == "refused") return OverlappingStarts::kRefused;
  if (*options.overlapping_starts == "contact") return OverlappingStarts::kContact;
  throw formats::InputError(option, "", show_text(*options.overlapping_starts) + " is no choice",
                   "write refused or contact");
}

// "id, t, x"
std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

// "MEANING=COLUMN", or "MEANING=" for a table without such a column.
formats::NamedColumn named_column(const std::string& text) {
  std::vector<std::string> meanings = formats::meanings_of_places();
  const std::vector<std::string>& more = formats::meanings_of_objects();
  meanings.insert(meanings.end(), more.begin(), more.end());
  const std::size_t equals = text.find('=');
  const std::string meaning = text.substr(0, equals);
  if (equals == std::string::npos || text == "id=") {
    throw formats::InputError("--column", "", show_text(text) + " names no column",
                              "write MEANING=COLUMN, as id=trackId");
  }
  if (std::find(meanings.begin(), meanings.end(), meaning) == meanings.end()) {
    throw formats::InputError(
        "--column", "", show_text(meaning) + " is not a meaning",
        did_you_mean(meaning, more, "write one of " + list_of(meanings) + " before the ="));
  }
  return {meaning, text.substr(equals + 1)};
}

char separator_option(const std::string& text) {
  if (text.empty()) return formats::kGuessedSeparator;
  if (text == "comma" || text == ",") return ',';
  if (text == "semicolon" || text == ";") return ';';
  if (text == "tab" || text == "\t" || text == "\\t") return '\t';
  throw formats::InputError("--separator", "", show_text(text) + " is not a separator",
                            "write comma, semicolon or tab");
}

formats::ImportOptions read_options(const ImportVerbOptions& options) {
  formats::ImportOptions read;
  if (!options.start.empty()) read.start_time = {"--start", options.start};
  if (!options.end.empty()) read.end_time = {"--end", options.end};
  if (!options.time_zero.empty()) read.time_zero = {"--time-zero", options.time_zero};
  for (const std::string& text : options.columns) read.columns.push_back(named_column(text));
  read.ignore_columns = options.ignore_columns;
  read.separator = separator_option(options.separator);
  read.fixed = options.fixed;
  read.overlapping_starts = overlapping_starts(options);
  if (options.heading) read.heading = {*options.heading, false};
  if (options.bearing) read.heading = {*options.bearing, true};
  return read;
}

formats::ImportReport import_table(const std::string& text, const ImportVerbOptions& options,
                                   const formats::ImportOptions& read) {
  for (const auto& [given, option] : {std::pair(options.linear, "--linear"),
                                      {options.planar, "--planar"},
                                      {options.local.has_value(), "--local"}}) {
    if (given)
      throw formats::InputError(option, "", "it is for Moving Features and GeoJSON",
                                "leave it out");
  }
  return formats::import_csv(text, options.file, read);
}

formats::ImportReport import_json(const std::string& text, const ImportVerbOptions& options,
                                  const formats::ImportOptions& read) {
  if (!options.separator.empty()) {
    throw formats::InputError("--separator", "", "it is for tables", "leave it out");
  }
  if (options.ignore_columns) {
    throw formats::InputError("--ignore-columns", "", "it is for tables", "leave it out");
  }
  formats::MovingFeaturesOptions features;
  features.common = read;
  features.linear = options.linear;
  if (options.planar && options.local) {
    throw formats::InputError("--local", "", "it does not go with --planar",
                              "leave one of them out");
  }
  if (options.planar) features.plane = formats::Plane::as_they_are();
  features.maintain = options.maintain.empty();
  if (options.local) features.plane = formats::Plane::around(*options.local);
  return formats::import_moving_features(text, options.file, features);
}

// An end is given by an option here, not by the scene.
void maintain_all(Scene& scene, const std::vector<std::string>& maintain) {
  try {
    formats::set_maintain(scene, maintain);
    lab::name_colours(scene);
  } catch (const formats::InputError& error) {
    if (scene.end || !error.problem().ends_with("the scene has no end")) throw;
    const std::size_t others = error.remedy().find(", or maintain");
    throw formats::InputError(
        error.file(), error.place(), error.problem(),
        "give --end T" + (others == std::string::npos ? "" : error.remedy().substr(others)));
  }
}

void import_file(const ImportVerbOptions& options, const Voice& voice) {
  check_standard_input({{"FILE", options.file}, {"--polygons", options.polygons.value_or("")}});
  keep_input("--output", options.output, options.file);
  formats::ImportOptions import_options = read_options(options);
  if (options.polygons) {
    keep_input("--output", options.output, *options.polygons);
    import_options.polygons =
        formats::parse_polygons(formats::read_text_file(*options.polygons), *options.polygons);
  }
  const std::string text = formats::read_text_file(options.file);
  if (text.starts_with("{\"format\": \"" + std::string(formats::kLogFormat) + "\"")) {
    throw formats::InputError(
        options.file, "line 1", "this is an event log, neither a table nor GeoJSON",
        "give the data that its scene was made from; kinex check, log and view read logs");
  }
  formats::ImportReport report = formats::looks_like_json(text)
                                     ? import_json(text, options, import_options)
                                     : import_table(text, options, import_options);
  Scene& scene = report.scene;
  if (!report.is_named || !options.name.empty()) {
    scene.name = name_option(
        options.name.empty() ? std::filesystem::path(options.file).stem().string() : options.name);
  }
  std::vector<std::string> maintain = options.maintain;
  if (maintain.empty()) maintain = {structure_for(scene)};
  if (!report.maintains) {
    maintain_all(scene, maintain);
    if (!formats::answers_queries(scene)) {
      report.notes.push_back(formats::counted(scene.queries.size(), "query was", "queries were") +
                             (scene.queries.size() == 1 ? " left out: no structure answers it"
                                                        : " left out: no structure answers them"));
      scene.queries.clear();
    }
    formats::check_answered(scene, "--maintain", "");
  }
  write_result(options.output, options.force, formats::write_scene(scene, report.words));
  const bool features = formats::looks_like_json(text);
  voice.note(
      formats::counted(report.rows, features ? "feature" : "row", features ? "features" : "rows") +
      ", " + formats::counted(scene.objects.size(), "object", "objects"));
  if (!report.time_zero.empty()) voice.note("t is in seconds, 0 is " + report.time_zero);
  for (const std::string& note : report.notes) voice.note(formats::plain(note));
  if (ignores_colours(scene)) {
    voice.note(
        "no structure is about the colours: --maintain with \"of\" or \"colours\" names them");
  }
  for (const std::string& detail : report.details) voice.detail(formats::plain(detail));
  voice.detail(formats::plain(scene.name) + ": " + std::to_string(scene.dimension) +
               (scene.dimension == 1 ? " axis" : " axes") + ", t from " + time_text(scene.start) +
               (scene.end ? " to " + time_text(*scene.end) : " on") + ", hash " +
               formats::scene_hash(scene));
  if (report.ignored_columns > 0) {
    voice.note(formats::counted(report.ignored_columns, "column was", "columns were") + " ignored");
  }
  if (!report.single_fixes.empty()) {
    voice.note(formats::counted(report.single_fixes.size(), "trace of a single fix was",
                                "traces of a single fix were") +
               " left out: " + formats::some_of(report.single_fixes));
    for (const std::string& trace : report.single_fixes) voice.detail("left out: " + formats::plain(trace));
  }
  if (report.repeated_fixes > 0) {
    voice.note(formats::counted(report.repeated_fixes, "repeated fix was", "repeated fixes were") +
               " read once");
  }
}

}  // namespace

void add_import_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ImportVerbOptions>();
  CLI::App* verb =
      app.add_subcommand("import", "Makes a scene from a CSV file, GeoJSON or Moving Features");
  verb->add_option("FILE", options->file,
                   "Columns id,t,x,y[,z] (traces, linear between fixes; a single fix is left out) "
                   "or id,x,y[,z],vx,vy[,vz] (linear), and more columns (below); or GeoJSON with "
                   "times; or OGC Moving "
                   "Features JSON")
      ->required();
  verb->add_option("--column", options->columns,
                   "MEANING=COLUMN, as id=trackId: the column of a meaning, where it has another "
                   "name, and MEANING= "
                   "where the table has no such column; can be given several times; meanings are " +
                       list_of(formats::meanings_of_places()) + ", " +
                       list_of(formats::meanings_of_objects()))
      ->allow_extra_args(false);
  verb->add_flag("--ignore-columns", options->ignore_columns, "Ignore columns without a meaning");
  verb->add_option("--separator", options->separator,
                   "comma, semicolon or tab (default: that of the first line)");
  verb->add_option("--start", options->start, "Start of the scene (first fix; 0 for velocities)");
  verb->add_option("--end", options->end, "End of the scene (last fix; none for velocities)");
  verb->add_option("--time-zero", options->time_zero,
                   "The date at which t = 0 (first fix), if times are dates");
  add_maintain_option(*verb, options->maintain, "What to maintain");
  verb->add_option(
          "--fixed", options->fixed,
          "Add an object at rest: ID,X[,Y[,Z]], and its radius, weight or half extents if the "
          "table has them; can be given several times")
      ->allow_extra_args(false);
  verb->add_option("--polygons", options->polygons,
                   "Make the objects rigid bodies: a CSV file with the columns id,x,y, one row per "
                   "vertex, counter-clockwise, convex; id * is for all objects without another");
  CLI::Option* heading =
      verb->add_option("--heading", options->heading,
                       "Column of the bodies' headings: degrees counter-clockwise from the x axis, "
                       "to 1.1e-10 degrees, multiples of 90 exactly; between two fixes they turn "
                       "the short way round, with velocities not at all");
  verb->add_option("--bearing", options->bearing,
                   "The same as compass bearings: degrees clockwise from the y axis (north)")
      ->excludes(heading);
  verb->add_option(
      "--overlapping-starts", options->overlapping_starts,
      "Bodies that overlap when they are first seen: refused (default) or contact (they "
      "begin in contact)");
  verb->add_flag("--linear", options->linear, "Of Moving Features: read Discrete as Linear");
  verb->add_option("--local", options->local,
                   "Of GeoJSON and Moving Features in degrees: metres around LON,LAT");
  verb->add_flag("--planar", options->planar,
                 "Of the same: coordinates are planar, whatever the file says");
  verb->add_option("--name", options->name, "Name of the scene (the file's)");
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  add_voice(*verb, "Print the scene and errors, no counts",
            "Name the columns, the time and the hash of the scene, on standard error");
  verb->footer(
      "More columns: radius, weight, or hx[,hy[,hz]] (half extents), which change as\n"
      "places do, beside velocities at the rates vradius, vweight, vhx, ..; colour;\n"
      "line (true: the line y = a x + b, x and y are a and b).\n"
      "Edges of a graph: id,t,from,to,weight or id,from,to,weight,vweight.\n"
      "Times are numbers, or dates as 2024-05-01T12:30:05Z (ISO 8601): t is then in\n"
      "seconds.\n"
      "Example:\n"
      "  kinex import storms.csv --maintain " +
      example_structure(1) +
      ":x -o storms.json\n"
      "  kinex import ships.csv --polygons hulls.csv --bearing heading -o harbour.json\n"
      "  kinex import tracks.csv --column id=trackId --column t=time \\\n"
      "    --ignore-columns -o tracks.json\n"
      "  kinex import cells.csv --column radius=r --column colour=kind -o cells.json\n"
      "  kinex import tram.mfjson --local 13.4,52.5 -o tram.json\n"
      "  kinex import stars.csv --fixed Sun,0,0,0 -o stars.json --maintain \\\n"
      "    '{\"structure\": \"" +
      example_structure(1) + "\", \"key\": {\"squared_distance_to\": \"Sun\"}}'");
  verb->callback([options, verb] { import_file(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
