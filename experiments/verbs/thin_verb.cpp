// SPDX-License-Identifier: GPL-3.0-or-later
// kinex thin: the few points of a scene whose diameter is nearly that of all, at all times.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/numbers/show_number.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/family.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct ThinOptions {
  std::string scene, output, error = "1/50";
  bool force = false;
};

// The colours that requests name, or those that they read.
void add_colours(const std::vector<Request>& requests, std::vector<std::string>& colours) {
  for (const Request& request : requests) {
    colours.insert(colours.end(), request.colours.begin(), request.colours.end());
    colours.insert(colours.end(), request.of.colours.begin(), request.of.colours.end());
    add_colours(request.over, colours);
  }
}

// A scene is refused if a request names a colour that no object has. So the first object of every named colour
// stays: a request of these objects is added for the time of thinning, as the last one.
lab::ThinnedScene thin_with_colours(const Scene& scene, const lab::Thinning& method, const Rational& error) {
  Scene named = scene;
  std::vector<std::string> colours;
  add_colours(scene.maintain, colours);
  Request& last = named.maintain.emplace_back();
  for (const std::string& colour : colours) {
    const auto has_it = [&colour](const SceneObject& object) { return object.colour == colour; };
    const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), has_it);
    if (first == scene.objects.end()) continue;
    last.of.objects.push_back(static_cast<ObjectId>(first - scene.objects.begin()));
  }
  lab::ThinnedScene thin = method.thin(named, error);
  thin.scene.maintain.pop_back();
  return thin;
}

void thin_scene(const ThinOptions& options, const Voice& voice) {
  const lab::Thinning& method = *lab::known_thinning();
  const Rational error = rational_option("--error", options.error);
  if (error < method.least_error() || !(error < Rational(1))) {
    throw formats::InputError(
        "--error", "", show_number(options.error) + " is no part of the diameter that may be lost",
        "write a number from " + method.least_error().to_string() +
            " on, less than 1, as 1/50: the diameter of what is left is at least 1 - ERROR of that "
            "of all");
  }
  keep_input("--output", options.output, options.scene);
  const Scene scene = formats::read_scene(options.scene);
  const std::string refusal = method.refusal(scene);
  if (!refusal.empty()) {
    const std::size_t end = refusal.find("; ");
    throw formats::InputError(options.scene, "", refusal.substr(0, end), refusal.substr(end + 2));
  }
  const lab::ThinnedScene thin = thin_with_colours(scene, method, error);
  write_result(options.output, options.force, formats::write_scene(thin.scene));
  voice.note(std::to_string(thin.scene.objects.size()) + " of " +
             formats::counted(scene.objects.size(), "object", "objects"));
  voice.note(thin.guarantee);
  std::string left;
  for (const SceneObject& object : thin.scene.objects) left += " " + formats::plain(object.id);
  voice.detail("left are:" + left);
}

}  // namespace

void add_thin_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ThinOptions>();
  CLI::App* verb =
      app.add_subcommand("thin", "Leaves out points that hardly matter to the diameter");
  verb->add_option("SCENE", options->scene,
                   "Scene of points that move linearly in the plane, - reads standard input")
      ->required();
  verb->add_option("--error", options->error,
                   "At all times the diameter of the points that are left is at least 1 - ERROR of "
                   "that of all; from 1/100000, less than 1 (1/50)");
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  add_voice(*verb, "Print the scene and errors, no counts",
            "Name the points that are left, on standard error");
  verb->footer(
      "The guarantee is a theorem, and the computation is exact; for the width there is\n"
      "no guarantee.\n"
      "Points that keys, queries and \"of\" of \"maintain\" name are kept, and one of each\n"
      "colour that it names.\n"
      "Example:\n  kinex thin square.json --error 1/50 -o thin.json");
  verb->callback([options, verb] { thin_scene(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
