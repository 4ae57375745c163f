// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are GeoJSON or Moving Features that make a scene, or are refused with InputError. Such a scene can
// be exported, or is refused with InputError; and what is exported exactly is the same when it is exported
// again.
#include <string>
#include <string_view>

#include "experiments/formats/input_error.h"
#include "experiments/formats/moving_features.h"
#include "experiments/formats/moving_features_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "tests/fuzz/harness.h"

namespace {

using namespace kinex;

// False if it refuses its input, as it should.
template <class Function>
bool works(const Function& function) {
  try {
    function();
    return true;
  } catch (const formats::InputError& error) {
    fuzz_require(!error.problem().empty() && !error.remedy().empty(), "an error without a remedy");
    return false;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  formats::MovingFeaturesOptions options;
  options.plane = size % 2 == 0 ? formats::Plane::as_they_are() : formats::Plane();
  options.linear = size % 3 == 0;
  Scene scene;
  if (!works([&] { scene = formats::import_moving_features(text, "fuzz", options).scene; }))
    return 0;
  fuzz_require(works([&] { formats::parse_scene(formats::write_scene(scene), "again"); }),
               "no scene");
  formats::MovingFeaturesForm form;
  form.tolerance = Rational(1);
  formats::WrittenFeatures features;
  if (!works([&] { features = formats::write_moving_features(scene, "fuzz", form); }) ||
      features.inexact > 0)
    return 0;
  Scene back;
  fuzz_require(
      works([&] { back = formats::import_moving_features(features.text, "again", {}).scene; }),
      "not read again");
  formats::WrittenFeatures again;
  fuzz_require(works([&] { again = formats::write_moving_features(back, "again", form); }),
               "not written again");
  fuzz_require(again.text == features.text, "features change when read and written");
  return 0;
}
