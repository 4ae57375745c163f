// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers, what they find, circles, boxes and directions in transformed scenes: time reversed and in
// other units, a common motion added, scaled, mirrored, turned, objects renamed. The attribute changes at
// the transformed instants, which are compared exactly, and it is the same in between.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/extent/calipers_support.h"
#include "tests/structures/metamorphic_scenes.h"

namespace kinex::test {
namespace extent_metamorphic_test {

// A run with the instants of all changes of the attribute.
class ChangesRun {
 public:
  ChangesRun(const Scene& given, const std::string& structure, AuditLevel audit)
      : scene_(asking(given, structure, "")),
        simulator_(scene_, planned_arithmetic("exact", scene_), Trial::options(audit)),
        id_(asked_structure(scene_)),
        sink_(id_) {
    add_structures(simulator_, scene_);
    simulator_.set_sink(&sink_);
    simulator_.start();
  }
  ChangesRun(const ChangesRun&) = delete;
  ChangesRun& operator=(const ChangesRun&) = delete;

  ChangesRun& to_end() {
    simulator_.run_until(std::nullopt);
    EXPECT_EQ(simulator_.violations(), std::vector<std::string>{});
    return *this;
  }
  Ids at(const Rational& t) {
    simulator_.run_until(t);
    return simulator_.structure(id_).attribute().ids;
  }
  const std::vector<Recorded>& changes() const { return sink_.recorder.events; }

 private:
  class Sink final : public EventSink {
   public:
    explicit Sink(StructureId id) : id_(id) { recorder.instants = 100000; }
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (event.structure == id_ && event.external) recorder.event(event, arithmetic);
    }
    Recorder recorder;

   private:
    StructureId id_;
  };

  Scene scene_;
  Simulator simulator_;
  StructureId id_;
  Sink sink_;
};

Rational value_at(const Scene& scene, ObjectId object, std::size_t axis, const Rational& t) {
  Rational value(0);
  const auto& c = scene.objects[object].motion.pieces[0].trajectory.coordinates[axis];
  for (std::size_t k = c.size(); k-- > 0;) value = value * t + c[k];
  return value;
}

// The area of the rectangle on the edge a, b that touches r, c and l.
Rational area_at(const Scene& scene, const Ids& ids, const Rational& t) {
  const auto from = [&](ObjectId p, ObjectId q, std::size_t axis) {
    return value_at(scene, q, axis, t) - value_at(scene, p, axis, t);
  };
  const Rational x = from(ids[0], ids[1], 0), y = from(ids[0], ids[1], 1);
  const Rational height = x * from(ids[0], ids[3], 1) - y * from(ids[0], ids[3], 0);
  const Rational width = x * from(ids[4], ids[2], 0) + y * from(ids[4], ids[2], 1);
  const Rational area = height * width / (x * x + y * y);
  return area < Rational(0) ? -area : area;
}

// In words of the old scene, whatever the orientation: an edge has no direction, right and left are
// two sides. Rectangles of one area are one, as they often are identically.
std::string old_value(const std::string& structure, const Image& image, const Scene& scene,
                      const Ids& attribute, const Rational& t) {
  Ids ids;
  for (const ObjectId id : attribute) ids.push_back(image.old_id(id));
  if (structure == "min_area_rectangle_2") {
    return ids.empty() ? "" : area_at(scene, ids, t).to_string();
  }
  if (structure.starts_with("calipers_2") || structure == "farthest_delaunay_2") {
    const std::size_t width = structure == "calipers_2_4" ? 4 : 2;
    std::vector<Ids> tuples;
    for (std::size_t i = 0; i < ids.size(); i += width) {
      tuples.emplace_back(ids.begin() + static_cast<std::ptrdiff_t>(i),
                          ids.begin() + static_cast<std::ptrdiff_t>(i + width));
      std::sort(tuples.back().begin(), tuples.back().end());
    }
    std::sort(tuples.begin(), tuples.end());
    ids.clear();
    for (const Ids& tuple : tuples) ids.insert(ids.end(), tuple.begin(), tuple.end());
  } else if (structure.starts_with("diameter") || structure.starts_with("min_circle_2") ||
             structure == "width_directions") {
    std::sort(ids.begin(), ids.end());
  } else if (structure.starts_with("bounding_box") ||
             structure.find("rectangle_directions") != std::string::npos) {
    for (std::size_t i = 0; i < ids.size(); i += 2) {
      if (ids[i + 1] < ids[i]) std::swap(ids[i], ids[i + 1]);
    }
  } else if (structure.starts_with("directions_2")) {  // a cycle
    std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
    if (ids.size() > 2 && ids.back() < ids[1]) std::reverse(ids.begin() + 1, ids.end());
  } else if (!ids.empty()) {
    std::sort(ids.begin(), ids.begin() + 2);
    if (ids.size() == 5 && ids[4] < ids[2]) std::swap(ids[2], ids[4]);
  }
  std::string text;
  for (const ObjectId id : ids) text += " " + std::to_string(id);
  return text;
}

std::vector<std::string> values_at(const std::string& structure, const Image& image,
                                   const Scene& scene, std::vector<Rational> times) {
  if (image.reverses_time()) std::reverse(times.begin(), times.end());
  ChangesRun run(image.scene, structure, AuditLevel::kNone);
  std::vector<std::string> values;
  for (const Rational& t : times) {
    values.push_back(old_value(structure, image, scene, run.at(image.new_time(t)), t));
  }
  if (image.reverses_time()) std::reverse(values.begin(), values.end());
  return values;
}

// Returns the number of times at which the attributes were compared.
std::size_t expect_same(const std::string& structure, const Scene& scene, const Image& same,
                        const Image& image) {
  SCOPED_TRACE(structure + ", " + image.how);
  ChangesRun a(scene, structure, AuditLevel::kEnd), b(image.scene, structure, AuditLevel::kEnd);
  a.to_end();
  b.to_end();
  // Which of several rectangles of one area is named depends on the ids of edges.
  if (structure != "min_area_rectangle_2") {
    const auto moments = [](const ChangesRun& run, const Image& as) {
      return moments_of(run.changes(), as,
                        [](const Recorded&) { return std::optional<std::string>("change"); });
    };
    expect_same_moments(moments(a, same), moments(b, image));
  }
  std::vector<RealRoot> instants;
  for (const Recorded& event : a.changes()) instants.push_back(instant_of(event, same));
  for (const Recorded& event : b.changes()) instants.push_back(instant_of(event, image));
  const std::vector<Rational> times = times_between(instants, scene.start, *scene.end);
  EXPECT_EQ(values_at(structure, same, scene, times), values_at(structure, image, scene, times));
  return times.size();
}

// The axes, and 4k directions, are the same in the transformed scene: those of more than the axes are
// not symmetric to them.
bool has_image(const std::string& structure, const Image& image) {
  const bool along_axes =
      structure.starts_with("bounding_box") || structure.find("directions") != std::string::npos;
  if (!along_axes) return true;
  if (image.how == "turned") return false;
  const bool axes_alone = structure.starts_with("bounding_box") || structure.ends_with(":1");
  return axes_alone || image.how.find("mirrored") == std::string::npos;
}

class ExtentMetamorphic : public ::testing::TestWithParam<std::string> {};

TEST_P(ExtentMetamorphic, Images) {
  Key any;
  any.kind = Key::Kind::kDirection;  // not used; turns with the scene
  any.direction = {1, 0};
  std::size_t compared = 0;
  for (const auto& [degree, n] : {std::pair{1, 9}, std::pair{1, 12}, std::pair{2, 6}}) {
    const Scene scene = wild_scene(static_cast<std::uint64_t>(50 + n), n, degree);
    const Image same{scene, any, 1, 0, false, {}, "the same"};
    for (const Image& image : images_of(scene, any, true)) {
      if (!has_image(GetParam(), image)) continue;
      compared += expect_same(GetParam(), scene, same, image);
    }
  }
  EXPECT_GT(compared, 60u);
}

// All points in one place at one instant: the same attributes before and after.
TEST_P(ExtentMetamorphic, ThroughOnePoint) {
  Key any;
  any.kind = Key::Kind::kDirection;
  any.direction = {1, 0};
  const Scene scene = through_one_point(61, 8, 1);
  const Image same{scene, any, 1, 0, false, {}, "the same"};
  for (const Image& image : images_of(scene, any, true)) {
    if (has_image(GetParam(), image)) expect_same(GetParam(), scene, same, image);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ExtentMetamorphic,
    ::testing::Values("diameter_2", "width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2",
                      "calipers_2", "calipers_2_4", "farthest_delaunay_2", "min_circle_2",
                      "min_circle_2_brute_force", "diameter_all_pairs", "bounding_box",
                      "bounding_box_2_hull", "directions_2:1", "directions_2",
                      "directions_2_tournament", "diameter_directions", "width_directions:1",
                      "min_perimeter_rectangle_directions:1", "min_area_rectangle_directions:1",
                      "min_perimeter_rectangle_directions", "min_area_rectangle_directions"),
    [](const auto& one) {
      std::string name = one.param;
      std::replace(name.begin(), name.end(), ':', '_');
      return name;
    });

}  // namespace extent_metamorphic_test
}  // namespace kinex::test
