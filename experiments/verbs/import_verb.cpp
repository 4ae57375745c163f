// SPDX-License-Identifier: GPL-3.0-or-later
// kinex import: a table of traces or velocities to a scene.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/csv_import.h"
#include "experiments/file_io.h"
#include "experiments/scene_reader.h"
#include "experiments/scene_writer.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex {

namespace {

struct ImportVerbOptions {
  std::string file, start, end, name, output;
  std::vector<std::string> maintain, fixed;
  bool force = false;
};

void import_file(const ImportVerbOptions& options) {
  keep_input("--output", options.output, options.file);
  ImportOptions import_options;
  if (!options.start.empty()) import_options.start = rational_option("--start", options.start);
  if (!options.end.empty()) import_options.end = rational_option("--end", options.end);
  import_options.fixed = options.fixed;
  const std::string text = read_text_file(options.file);
  ImportReport report = import_csv(text, options.file, import_options);
  Scene& scene = report.scene;
  scene.name = name_option(
      options.name.empty() ? std::filesystem::path(options.file).stem().string() : options.name);
  std::vector<std::string> maintain = options.maintain;
  if (maintain.empty()) maintain = {scene.dimension == 2 ? "delaunay_2" : "sorted_list"};
  set_maintain(scene, maintain);
  write_result(options.output, options.force, write_scene(scene));
  std::fprintf(stderr, "kinex: %zu rows, %zu objects\n", report.rows, scene.objects.size());
  if (report.single_fixes > 0) {
    std::fprintf(stderr, "kinex: %zu traces of a single fix were left out\n", report.single_fixes);
  }
  if (report.repeated_fixes > 0) {
    std::fprintf(stderr, "kinex: %zu identical fixes were read once\n", report.repeated_fixes);
  }
}

}  // namespace

void add_import_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ImportVerbOptions>();
  CLI::App* verb = app.add_subcommand("import", "Makes a scene of a CSV file");
  verb->add_option("FILE", options->file,
                   "Columns id,t,x,y[,z] (traces, linear between fixes; one fix alone is left out) "
                   "or id,x,y[,z],vx,vy[,vz] (linear)")
      ->required();
  verb->add_option("--start", options->start, "Start of the scene (first fix; 0 for velocities)");
  verb->add_option("--end", options->end, "End of the scene (last fix; none for velocities)");
  add_maintain_option(*verb, options->maintain, "What to maintain");
  verb->add_option("--fixed", options->fixed,
                   "Add an object that stands still: ID,X[,Y[,Z]]; can be given several times")
      ->allow_extra_args(false);
  verb->add_option("--name", options->name, "Name of the scene (the file's)");
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  verb->footer(
      "Example:\n"
      "  kinex import storms.csv --maintain sorted_list:x -o storms.json\n"
      "  kinex import stars.csv --fixed Sun,0,0,0 -o stars.json --maintain \\\n"
      "    '{\"structure\": \"minimum_tournament\", \"key\": {\"squared_distance_to\": \"Sun\"}}'");
  verb->callback([options] { import_file(*options); });
}

}  // namespace kinex
