// SPDX-License-Identifier: GPL-3.0-or-later
// Kinetic hulls of transformed scenes: the same points enter and leave at the transformed instants,
// and the hull is the same between them. A hull reports the difference that an instant makes, so
// the events must agree even where several certificates fail at once.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/hull/hull_support.h"
#include "tests/structures/metamorphic_scenes.h"

namespace kinex::test {
namespace metamorphic_hull_test {

// An image, and whether it reverses orientation.
struct HullImage {
  Image image;
  bool turns_over = false;
};

Key any_key() {
  Key key;
  key.kind = Key::Kind::kDirection;  // not used: it lets the scene be turned
  key.direction = {1, 0};
  return key;
}

std::vector<HullImage> hull_images(const Scene& scene) {
  std::vector<HullImage> images;
  for (Image& image : images_of(scene, any_key(), false)) images.push_back({std::move(image)});
  images.push_back({mirrored(scene, any_key(), 0), true});
  images.push_back({mirrored(scene, any_key(), 1), true});
  images.push_back({scaled(scene, any_key(), -1)});  // turned by half a turn
  return images;
}

// In old ids, from the smallest on, counter-clockwise in the old scene.
std::vector<ObjectId> old_cycle(const HullImage& in, const std::vector<ObjectId>& cycle) {
  std::vector<ObjectId> ids;
  for (const ObjectId id : cycle) ids.push_back(in.image.old_id(id));
  if (in.turns_over) std::reverse(ids.begin(), ids.end());
  if (!ids.empty()) std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  return ids;
}

// "enter 3": in old ids and the old direction of time. A turn is left out: which of several points
// it names depends on ids; the hulls in between show it.
std::vector<Moment> hull_moments(const HullImage& in, const std::vector<Recorded>& events) {
  return moments_of(events, in.image, [&](const Recorded& event) -> std::optional<std::string> {
    if (event.kind >= HullEvents::kTurn) return std::nullopt;
    const bool enters = (event.kind == HullEvents::kEnter) != in.image.reverses_time();
    return (enters ? "enter " : "leave ") + std::to_string(in.image.old_id(event.ids[0]));
  });
}

// The hull at these (old) times.
std::vector<std::vector<ObjectId>> hulls_at(const std::string& structure, const HullImage& in,
                                            std::vector<Rational> times) {
  const bool back = in.image.reverses_time();
  if (back) std::reverse(times.begin(), times.end());
  Scene scene = in.image.scene;
  scene.maintain = {{structure, structure, {}}};
  Simulator simulator(scene, make_arithmetic("exact", scene), Trial::options(AuditLevel::kNone));
  add_structures(simulator, scene);
  simulator.start();
  std::vector<std::vector<ObjectId>> hulls;
  for (const Rational& t : times) {
    simulator.run_until(in.image.new_time(t));
    hulls.push_back(old_cycle(in, simulator.structure(asked_structure(scene)).attribute().ids));
  }
  if (back) std::reverse(hulls.begin(), hulls.end());
  return hulls;
}

// Returns the number of instants at which points enter or leave.
std::size_t expect_same_hulls(const std::string& structure, const Scene& scene) {
  const HullImage same{{scene, any_key(), 1, 0, false, {}, "the same"}};
  const HullStory story = tell(scene, structure, "exact", AuditLevel::kEnd);
  const std::vector<Moment> moments = hull_moments(same, story.events);
  std::vector<RealRoot> instants;
  for (const Recorded& event : story.events) instants.push_back(instant_of(event, same.image));
  const std::vector<Rational> times = times_between(instants, scene.start, *scene.end);
  const auto hulls = hulls_at(structure, same, times);
  for (const HullImage& in : hull_images(scene)) {
    SCOPED_TRACE(structure + ", " + in.image.how);
    const HullStory other = tell(in.image.scene, structure, "exact", AuditLevel::kEnd);
    EXPECT_EQ(other.violations, std::vector<std::string>{});
    expect_same_moments(moments, hull_moments(in, other.events));
    EXPECT_EQ(hulls, hulls_at(structure, in, times));
  }
  return moments.size();
}

TEST(MetamorphicHull, OrdinaryScenes) {
  std::size_t instants = 0;
  for (const auto& [degree, n] : {std::pair{1, 14}, std::pair{2, 11}, std::pair{3, 7}}) {
    if (kSanitized && degree > 1) break;
    const Scene scene = wild_scene(static_cast<std::uint64_t>(50 + degree), n, degree);
    for (const std::string& hull : kHulls) instants += expect_same_hulls(hull, scene);
  }
  EXPECT_GT(instants, kSanitized ? 20u : 100u);
}

TEST(MetamorphicHull, FlightPlansAndLives) {
  std::size_t instants = 0;
  for (const int degree : {1, 2}) {
    if (kSanitized && degree > 1) break;
    const Scene scene = wild_flights(static_cast<std::uint64_t>(60 + degree), 11, degree);
    for (const std::string& hull : kHulls) instants += expect_same_hulls(hull, scene);
  }
  EXPECT_GT(instants, kSanitized ? 20u : 50u);
}

TEST(MetamorphicHull, ManyAtOneInstant) {
  std::size_t instants = 0;
  for (const int degree : {1, 2}) {
    if (kSanitized && degree > 1) break;
    const auto seed = static_cast<std::uint64_t>(70 + degree);
    for (const Scene& scene :
         {through_one_point(seed, 9, degree), through_a_lattice(seed, 3, degree)}) {
      for (const std::string& hull : kHulls) instants += expect_same_hulls(hull, scene);
    }
  }
  EXPECT_GT(instants, 10u);
}

}  // namespace metamorphic_hull_test
}  // namespace kinex::test
