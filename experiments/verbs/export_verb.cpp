// SPDX-License-Identifier: GPL-3.0-or-later
// kinex export: a scene in a form that other programs read.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/iso_time.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/moving_features.h"
#include "experiments/formats/moving_features_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct ExportOptions {
  std::string scene, output, until;
  std::string time_zero = "1970-01-01T00:00:00Z";
  std::string tolerance = "1e-9";
  bool mf_json = false, force = false;
};

formats::SceneWords words_of(const std::string& text, const std::string& file) {
  const formats::JsonDocument document = formats::parse_json(text, file);
  const formats::JsonSource source{file, text};
  return formats::read_words(formats::JsonNode(*document, source));
}

// True if kinex import gives the same scene again. Throws InputError if it refuses the file.
bool is_read_back(const std::string& text, Scene scene, const formats::MovingFeaturesForm& form,
                  const std::string& file) {
  if (form.until) scene.end = form.until;
  try {
    const formats::ImportReport report = formats::import_moving_features(text, file, {});
    return report.maintains && formats::write_scene(report.scene, report.words) ==
                                   formats::write_scene(scene, form.words);
  } catch (const formats::InputError& error) {
    throw formats::InputError(
        file, "", "such a file cannot hold the scene, kinex import refuses it: " + error.problem(),
        form.until ? "give a later --until, or leave it out"
                   : "change the scene: " + error.remedy());
  }
}

void export_scene(const ExportOptions& options, const Voice& voice) {
  if (!options.mf_json) {
    throw formats::InputError("export", "", "no form is named", "give --mf-json");
  }
  keep_input("--output", options.output, options.scene);
  formats::MovingFeaturesForm form;
  std::string problem;
  const auto zero = formats::parse_iso_time(options.time_zero, problem);
  if (!zero) {
    throw formats::InputError("--time-zero", "",
                              show_text(options.time_zero) + " is not a date: " + problem,
                              "write it as 2024-05-01T12:30:05Z");
  }
  form.time_zero = zero->seconds;
  form.tolerance = rational_option("--tolerance", options.tolerance);
  if (form.tolerance.sign() <= 0) {
    throw formats::InputError("--tolerance", "", show_text(options.tolerance) + " is no distance",
                              "write a number greater than 0");
  }
  const std::string text = formats::read_text_file(options.scene);
  const Scene scene = formats::parse_scene(text, options.scene);
  form.words = words_of(text, options.scene);
  if (!options.until.empty()) {
    form.until = rational_option("--until", options.until);
    if (*form.until <= scene.start || (scene.end && *form.until > *scene.end)) {
      throw formats::InputError("--until", "",
                                show_text(options.until) + " is outside of the scene's time",
                                "write a time after " + time_text(scene.start) +
                                    (scene.end ? ", at most " + time_text(*scene.end) : ""));
    }
  }
  const formats::WrittenFeatures features =
      formats::write_moving_features(scene, options.scene, form);
  const bool same = is_read_back(features.text, scene, form, options.scene);
  write_result(options.output, options.force, features.text);
  std::string note = formats::counted(scene.objects.size() - features.absent, "object", "objects");
  if (features.inexact > 0) {
    char error[40];
    std::snprintf(error, sizeof error, "%.2g", features.error.upper_double());
    note += ", " + std::to_string(features.inexact) + " with errors of about " + error + " at most";
  } else {
    note += ", exactly";
    if (!same)
      note += "; kinex import gives the same motions in the scene's time, but another hash";
  }
  voice.note(note);
  voice.detail("t = 0 is " + options.time_zero + "; " +
               formats::counted(features.text.size(), "byte", "bytes"));
}

}  // namespace

void add_export_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb = app.add_subcommand("export", "Writes a scene for other programs");
  verb->add_option("SCENE", options->scene, "Scene file, - reads standard input")->required();
  verb->add_flag(
      "--mf-json", options->mf_json,
      "OGC Moving Features JSON: MovingPoint, or MovingPolygon for bodies that do not turn");
  verb->add_option("--until", options->until, "Up to this time (the scene's end)");
  verb->add_option("--time-zero", options->time_zero,
                   "The date of t = 0 (1970-01-01T00:00:00Z); t is in seconds");
  verb->add_option(
      "--tolerance", options->tolerance,
      "Motions of higher degree become straight lines that are this near on every axis (1e-9)");
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  add_voice(*verb, "Print the file and errors, no counts",
            "Name the date of t = 0 and the size, on standard error");
  verb->footer(
      "Linear motions with decimals are written as they are: kinex import gives the\n"
      "same scene again, with the same hash. Discs, boxes, lines and bodies that turn\n"
      "are refused. For all other motions properties.kinex.error_at_most of a feature\n"
      "bounds the error of its positions.\n"
      "Example:\n"
      "  kinex export square.json --mf-json -o square.mfjson");
  verb->callback([options, verb] { export_scene(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
