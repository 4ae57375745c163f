// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a table of traces or velocities that makes a scene which can be written and read,
// or are refused with InputError; so are lines of them as values of --fixed and --maintain, the
// same table with polygons and headings, and a table of polygons.
#include <algorithm>
#include <string>
#include <string_view>

#include "experiments/formats/csv_import.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "tests/fuzz/harness.h"

namespace {

using namespace kinex;

// What `function` returns, or an empty scene if it refuses its input as it should.
template <class Function>
Scene scene_or_refusal(const Function& function) {
  try {
    return function();
  } catch (const formats::InputError& error) {
    fuzz_require(!error.problem().empty() && !error.remedy().empty(), "an error without a remedy");
    return {};
  }
}

void check_scene(const Scene& scene) {
  if (scene.objects.empty()) return;
  const std::string written = formats::write_scene(scene);
  fuzz_require(formats::write_scene(formats::parse_scene(written, "again")) == written,
               "a scene changes when written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_scene(scene_or_refusal([&] { return formats::import_csv(text, "fuzz", {}).scene; }));
  const std::string first_line(text.substr(0, text.find('\n')));
  const std::string second_line(text.substr(std::min(first_line.size() + 1, size)));
  formats::ImportOptions options;
  options.fixed = {second_line.substr(0, second_line.find('\n'))};
  const std::string_view plain = "id,x,y,vx,vy\n-,0,0,1,1\n";
  check_scene(scene_or_refusal([&] { return formats::import_csv(plain, "plain", options).scene; }));
  check_scene(scene_or_refusal([&] {
    Scene scene = formats::import_csv(plain, "plain", {}).scene;
    formats::set_maintain(scene, {first_line});
    return scene;
  }));
  formats::ImportOptions bodies;
  bodies.polygons = formats::parse_polygons("id,x,y\n*,0,0\n*,1,0\n*,0,1\n", "plain");
  const bool heading = first_line.find("heading") != std::string::npos;
  if (heading) bodies.heading = {"heading", size % 2 == 0};
  check_scene(scene_or_refusal([&] { return formats::import_csv(text, "fuzz", bodies).scene; }));
  check_scene(scene_or_refusal([&] {
    formats::ImportOptions given;
    given.polygons = formats::parse_polygons(text, "fuzz");
    const std::string table = "id,x,y,vx,vy\n" + given.polygons->entries[0].id + ",0,0,1,1\n";
    return formats::import_csv(table, "table", given).scene;
  }));
  return 0;
}
