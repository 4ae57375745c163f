// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of proximity, triangulations and arrangements, one table of all: time reversed and a motion
// that all objects share leave every attribute as it was, at exactly the images of its instants; and
// from any rational instant on a run goes on as one that begins there.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic_scenes.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/meetings_support.h"

namespace kinex::test {
namespace transformed_runs_test {

using Ids = std::vector<ObjectId>;

// kMovedLines: lines and points whose distances are kept by translations alone.
enum class Made {
  kPlane,
  kSpace,
  kGraph,
  kWeightedPlane,
  kWeightedSpace,
  kLines,
  kLinesAndPoints,
  kMovedLines
};

struct Row {
  std::vector<Request> requests;  // for one attribute
  Made made;
  int degrees = 1;  // motions up to this degree
};

const std::vector<Row>& table() {
  static const std::vector<Row> kRows{
      {{ask("closest_pair_delaunay"), ask("closest_pair_all"), ask("closest_pair_range_tree"),
        ask("closest_pair_range_tree", "cones", 4), ask("closest_pair_cones"),
        ask("closest_pair_local"), ask("closest_pair_bins")},
       Made::kPlane,
       2},
      {{ask("closest_pair_delaunay"), ask("closest_pair_all")}, Made::kSpace},
      {{ask("bichromatic_pair_delaunay"), ask("bichromatic_pair_all")}, Made::kPlane, 2},
      {{ask("bichromatic_pair_delaunay"), ask("bichromatic_pair_all")}, Made::kSpace},
      {{ask("bichromatic_pair_maximum_norm")}, Made::kPlane, 2},
      {{ask("emst_list"), ask("emst_cycles"), ask("emst_clusters")}, Made::kPlane, 2},
      {{ask("emst_list"), ask("emst_cycles"), ask("emst_clusters")}, Made::kSpace},
      {{ask("graph_mst_list"), ask("graph_mst_cycles"), ask("graph_mst_clusters"),
        ask("graph_mst_sparsified")},
       Made::kGraph,
       2},
      {{ask("mst_maximum_norm_list"), ask("mst_maximum_norm_cycles"),
        ask("mst_maximum_norm_clusters")},
       Made::kPlane,
       2},
      {{ask("mst_polygon_list"), ask("mst_polygon_cycles"), ask("mst_polygon_clusters")},
       Made::kPlane},
      {{ask("octants_listed"), ask("octants_local")}, Made::kPlane, 2},
      {{ask("cones_local")}, Made::kPlane, 2},
      {{ask("nearest_site")}, Made::kPlane, 2},
      {{ask("nearest_site")}, Made::kSpace},
      {{ask("delaunay_3")}, Made::kSpace},
      {{ask("regular_2")}, Made::kWeightedPlane, 2},
      {{ask("regular_3")}, Made::kWeightedSpace},
      {{ask("line_arrangement_2")}, Made::kLines},
      {{ask("trapezoids_2")}, Made::kLines},
      {{ask("points_in_arrangement")}, Made::kLinesAndPoints},
      {{ask("incidences_all"), ask("incidences_cutting"), ask("incidences_cutting", "r", 1),
        ask("incidences_cutting", "r", 3)},
       Made::kLinesAndPoints,
       2},
      {{ask("closest_point_line_vertical")}, Made::kLinesAndPoints},
      {{ask("closest_point_line")}, Made::kMovedLines}};
  return kRows;
}

bool has_weights(Made made) { return made == Made::kWeightedPlane || made == Made::kWeightedSpace; }
bool has_points_and_lines(Made made) {
  return made == Made::kLinesAndPoints || made == Made::kMovedLines;
}
int dimension_of(Made made) {
  return made == Made::kGraph ? 1 : made == Made::kSpace || made == Made::kWeightedSpace ? 3 : 2;
}
// What the objects of the scene are besides points with weights.
Scene finished(Scene scene, Made made) {
  if (made == Made::kLines) with_lines(scene, LineUse::kAlone);
  if (has_points_and_lines(made)) with_lines(scene, LineUse::kWithPoints);
  return made == Made::kGraph ? suited(std::move(scene), *find_structure_info("graph_mst_list"))
                              : scene;
}

// ---- other motions

// Coefficients are k / 1000 with |k| <= 3000: no ties, no two instants at once (to be expected).
Scene wild(Made made, int degree) {
  Random random(static_cast<std::uint64_t>(degree) + 60);
  std::vector<Trajectory> paths;
  for (int i = 0; i < 7; ++i) {
    Trajectory one = random.small_path(dimension_of(made) + has_weights(made), degree, 3000);
    for (auto& axis : one.coordinates) {
      for (Rational& c : axis) c *= fraction(1, 1000);
    }
    paths.push_back(std::move(one));
  }
  Scene scene = scene_of(paths, fraction(-5, 7), fraction(8, 9));
  scene.dimension = dimension_of(made);
  if (has_weights(made)) scene.extents = Extents::kWeight;
  return finished(std::move(scene), made);
}

// Points and lines y = ax + b are translated, by (t, 5 - 3t): b - at + 5 - 3t in the place of b.
Image translated(const Scene& scene) {
  Image image{scene, {}, 1, 0, false, {}, "points and lines translated"};
  for (SceneObject& object : image.scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      auto& x = piece.trajectory.coordinates[0];
      auto& y = piece.trajectory.coordinates[1];
      y.resize(std::max(y.size(), x.size() + 1));
      y[0] += Rational(5);
      y[1] -= Rational(3);
      if (object.line) {
        for (std::size_t k = 0; k < x.size(); ++k) y[k + 1] -= x[k];
      } else {
        x.resize(std::max<std::size_t>(x.size(), 2));
        x[1] += Rational(1);
      }
      piece.trajectory.normalise();
    }
  }
  return image;
}

// All points, and all weights, have one more motion. A line y = ax + b is mapped as its points are, by
// y + 2x + more: to another line at the same vertical distances.
Image with_common_motion(const Scene& scene, Made made) {
  const Trajectory more = path({{1000, fraction(-17, 3), fraction(2, 9)},
                                {fraction(1, 3), 5, fraction(-9, 7)},
                                {-7, fraction(3, 11)},
                                {2, fraction(-1, 4), 1}});
  if (made == Made::kMovedLines) return translated(scene);
  if (made != Made::kLinesAndPoints) return carried(scene, {}, more);
  Image image{scene, {}, 1, 0, false, {}, "points and lines carried along"};
  for (SceneObject& object : image.scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      auto& x = piece.trajectory.coordinates[0];
      auto& y = piece.trajectory.coordinates[1];
      y.resize(3);
      for (std::size_t k = 0; k < 3; ++k) {
        y[k] += more.coordinates[1][k];
        if (!object.line && k < x.size()) y[k] += Rational(2) * x[k];
      }
      if (object.line) x[0] += Rational(2);
    }
  }
  return image;
}

// Keeps each change of an attribute, with the last external event of its instant.
class Changes final : public EventSink {
 public:
  Changes(const Simulator& simulator, StructureId id) : simulator_(&simulator), id_(id) {
    recorder_.instants = 1000000;
  }
  void begin() {
    value_ = value();
    begun_ = true;
  }
  void event(const Event& event, Arithmetic& arithmetic) override {
    if (event.structure == id_ && event.external) recorder_.event(event, arithmetic);
  }
  void instant_ended() override {
    if (!begun_) return;
    Ids now = value();
    if (now != value_) {
      ASSERT_FALSE(recorder_.events.empty()) << "a change without an event";
      all.push_back({recorder_.events.back(), std::move(value_), now});
      value_ = std::move(now);
    }
    recorder_.events.clear();
  }
  struct Change {
    Recorded event;
    Ids before, after;
  };
  std::vector<Change> all;

 private:
  Ids value() const { return simulator_->structure(id_).attribute().ids; }

  const Simulator* simulator_;
  StructureId id_;
  Recorder recorder_;
  Ids value_;
  bool begun_ = false;
};

// The changes of the attribute, each a moment of the old scene.
std::vector<Moment> moments(const Image& image, const Request& request) {
  const Scene scene = TwinRun::asking(image.scene, {request});
  Simulator simulator(scene, planned_arithmetic("exact", scene), Trial::options(AuditLevel::kEnd));
  Changes changes(simulator, asked_structure(scene));
  add_structures(simulator, scene);
  simulator.set_sink(&changes);
  simulator.start();
  changes.begin();
  simulator.run_until(std::nullopt);
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  const auto text = [](const Ids& ids) {
    std::string result;
    for (const ObjectId id : ids) result += " " + std::to_string(id);
    return result;
  };
  std::vector<Moment> result;
  for (auto& [event, before, after] : changes.all) {
    if (image.reverses_time()) std::swap(before, after);
    result.push_back({instant_of(event, image), {text(before) + " >" + text(after)}});
  }
  if (image.reverses_time()) std::reverse(result.begin(), result.end());
  return result;
}

TEST(TransformedRuns, TimeReversedAndACommonMotion) {
  for (const Row& row : table()) {
    for (int degree = 1; degree <= (kSanitized ? 1 : row.degrees); ++degree) {
      const Scene scene = wild(row.made, degree);
      for (const Request& request : row.requests) {
        SCOPED_TRACE(request.structure + " in " + std::to_string(scene.dimension) +
                     " axes, degree " + std::to_string(degree));
        const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"}, request);
        EXPECT_GT(expected.size(), 0u);
        for (const Image& image : {in_time(scene, {}, fraction(-2, 7), fraction(1, 5)),
                                   with_common_motion(scene, row.made)}) {
          SCOPED_TRACE(image.how);
          expect_same_moments(expected, moments(image, request));
        }
      }
    }
  }
}

// A norm is kept by the turns of its polygon alone: those by a quarter are of all that there are here.
Image quarter_turned(const Scene& scene) {
  Image image{scene, {}, 1, 0, false, {}, "turned by a quarter"};
  change_paths(image.scene, [](Trajectory& path) {
    std::swap(path.coordinates[0], path.coordinates[1]);
    for (Rational& c : path.coordinates[0]) c = -c;
  });
  return image;
}

TEST(TransformedRuns, TheTurnsOfANorm) {
  const Scene scene = wild(Made::kPlane, 1);
  for (const char* norm : {"mst_maximum_norm", "mst_polygon"}) {
    for (const char* engine : {"_list", "_cycles", "_clusters"}) {
      const Request request = ask(std::string(norm) + engine);
      SCOPED_TRACE(request.structure);
      const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"}, request);
      EXPECT_GT(expected.size(), 0u);
      for (const Image& image :
           {quarter_turned(scene), mirrored(scene, {}, 0), scaled(scene, {}, fraction(22, 7))}) {
        SCOPED_TRACE(image.how);
        expect_same_moments(expected, moments(image, request));
      }
    }
  }
}

// ---- a run from the middle

// Objects come, go and change their motions.
Scene flights(const Row& row, std::uint64_t seed, PlanInstants instants) {
  const int dimension = dimension_of(row.made), n = dimension == 3 ? 6 : 8;
  if (has_weights(row.made)) {
    return extended_flights(seed, n, dimension, row.degrees, true, Extents::kWeight, instants);
  }
  const int axes = row.made == Made::kGraph ? 2 : dimension;
  return finished(random_flights(seed, n, axes, row.degrees, true, instants), row.made);
}

TEST(TransformedRuns, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (const Row& row : table()) {
    for (const PlanInstants instants : {PlanInstants::kQuarters, PlanInstants::kOddParts}) {
      if (kSanitized && instants == PlanInstants::kOddParts) break;
      // In space points of others are in one plane for a while, or few: triangulations are built anew there.
      const std::uint64_t seed =
          instants == PlanInstants::kQuarters || dimension_of(row.made) == 3 ? 1 : 3;
      SCOPED_TRACE(row.requests[0].structure + ", seed " + std::to_string(seed));
      runs.expect_to_go_on(flights(row, seed, instants), row.requests, seed);
    }
  }
  runs.expect_changes();
  EXPECT_GT(runs.external, 200u);
}

}  // namespace transformed_runs_test
}  // namespace kinex::test
