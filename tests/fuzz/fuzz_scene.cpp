// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a valid scene or refused with InputError; a scene survives writing and reading.
#include <string_view>

#include "experiments/formats/input_error.h"
#include "experiments/formats/model_text.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "tests/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kinex;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Scene scene;
  try {
    scene = formats::parse_scene(text, "fuzz");
  } catch (const formats::InputError& error) {
    fuzz_require(!error.problem().empty() && !error.remedy().empty(), "an error without a remedy");
    return 0;
  }
  const std::string written = formats::write_scene(scene);
  fuzz_require(formats::write_scene(formats::parse_scene(written, "again")) == written,
               "a scene changes when written");
  fuzz_require(!formats::describe_model(scene, "").empty(), "a scene without a description");
  return 0;
}
