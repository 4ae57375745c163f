// SPDX-License-Identifier: GPL-3.0-or-later
// A run of a transformed scene has the events of the original, at the transformed instants: for
// every structure, key and degree. Instants are compared exactly.
#include "tests/sanitized.h"
#include "tests/structures/metamorphic_scenes.h"
#include "tests/structures/structure_names.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace metamorphic_test {

// Those of a key of any degree that have certificates of their own.
const std::vector<std::string> kMaxima = structures_where([](const StructureInfo& info) {
  return (info.group == "maximum" || info.group == "minimum") && info.reads.empty() &&
         !info.linear();
});

bool is_list(const std::string& structure) { return structure == "sorted_list"; }
bool is_delaunay(const std::string& structure) { return structure == "delaunay_2"; }

// maximum_heap <-> minimum_heap, and so on.
std::string opposite(const std::string& structure) {
  if (structure.rfind("maximum", 0) == 0) return "minimum" + structure.substr(7);
  if (structure.rfind("minimum", 0) == 0) return "maximum" + structure.substr(7);
  return structure;
}

std::string pair_of(ObjectId a, ObjectId b) {
  return std::to_string(std::min(a, b)) + "-" + std::to_string(std::max(a, b));
}

// The text of an event for the old scene, in old ids and in the old direction of time. Internal
// events of tournaments and heaps depend on the history and on the order of the objects: without
// `internal` they are left out.
std::optional<std::string> word(const std::string& structure, const Image& image, bool internal,
                                const Recorded& event) {
  std::vector<ObjectId> ids;
  for (const ObjectId id : event.ids) ids.push_back(image.old_id(id));
  const bool back = image.reverses_time();
  if (is_delaunay(structure)) {
    switch (event.kind) {
      case 0:
        return "flip " + pair_of(ids[back ? 2 : 0], ids[back ? 3 : 1]) + " to " +
               pair_of(ids[back ? 0 : 2], ids[back ? 1 : 3]);
      case 1:
      case 2: {
        const bool enters = (event.kind == 1) != back;
        return (enters ? "enter " : "leave ") + std::to_string(ids[0]) + " by " +
               pair_of(ids[1], ids[2]);
      }
      default:
        return std::nullopt;  // flight plans; these scenes have no other kind
    }
  }
  const bool net = event.external && !is_list(structure);  // under any name of the structure's
  if ((event.kind != 0 && !net) || (!internal && !event.external)) return std::nullopt;
  if (back != (is_list(structure) && image.reverses_order)) std::swap(ids[0], ids[1]);
  return std::to_string(ids[0]) + " then " + std::to_string(ids[1]);
}

std::vector<ObjectId> old_attribute(const std::string& structure, const Image& image,
                                    const std::vector<ObjectId>& attribute) {
  std::vector<ObjectId> ids;
  for (const ObjectId id : attribute) ids.push_back(image.old_id(id));
  if (is_list(structure) && image.reverses_order) std::reverse(ids.begin(), ids.end());
  if (!is_delaunay(structure) || image.name.empty()) return ids;
  std::vector<std::pair<ObjectId, ObjectId>> edges;
  for (std::size_t i = 0; i < ids.size(); i += 2) {
    edges.emplace_back(std::min(ids[i], ids[i + 1]), std::max(ids[i], ids[i + 1]));
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ids[2 * i] = edges[i].first;
    ids[2 * i + 1] = edges[i].second;
  }
  return ids;
}

using Attributes = std::vector<std::vector<ObjectId>>;

// The attribute at these (old) times.
Attributes attributes_at(const std::string& structure, const Image& image,
                         std::vector<Rational> times) {
  if (image.reverses_time()) std::reverse(times.begin(), times.end());
  Trial run(image.scene, structure, "exact", AuditLevel::kNone, image.key);
  run.without_twin();
  Attributes values;
  for (const Rational& t : times) {
    run.run_until(image.new_time(t));
    values.push_back(old_attribute(structure, image, run.ids()));
  }
  if (image.reverses_time()) std::reverse(values.begin(), values.end());
  return values;
}

enum class Compare { kEvents, kAttributes };

// Runs both, compares the events (unless only attributes are to be compared: where many things
// happen at one instant, the steps in between may differ), and the attributes at all times between.
// Returns the number of instants.
std::size_t expect_same(const std::string& structure, const Scene& scene, const Key& key,
                        const Image& image, Compare what) {
  const std::string other = image.reverses_order ? opposite(structure) : structure;
  SCOPED_TRACE(structure + ", " + image.how + ", key " +
               std::to_string(static_cast<int>(key.kind)));
  const Image same{scene, key, 1, 0, false, {}, "the same"};
  Trial a(scene, structure, "exact", AuditLevel::kEnd, key);
  Trial b(image.scene, other, "exact", AuditLevel::kEnd, image.key);
  a.without_twin().to_end().expect_clean();
  b.to_end().expect_clean();
  const bool internal = !image.reverses_time() && image.name.empty();
  const auto moments = [&](const Trial& run, const Image& as, const std::string& name) {
    return moments_of(run.sink.recorder.events, as, [&](const Recorded& event) {
      return word(name, as, internal || is_list(name) || is_delaunay(name), event);
    });
  };
  if (what == Compare::kEvents) {
    expect_same_moments(moments(a, same, structure), moments(b, image, other));
  }
  std::vector<RealRoot> instants;
  for (const Recorded& event : a.sink.recorder.events) instants.push_back(instant_of(event, same));
  for (const Recorded& event : b.sink.recorder.events) {
    instants.push_back(instant_of(event, image));
  }
  const std::vector<Rational> times = times_between(instants, scene.start, *scene.end);
  EXPECT_EQ(attributes_at(structure, same, times), attributes_at(other, image, times));
  return times.size();
}

TEST(Metamorphic, SortedList) {
  std::size_t instants = 0;
  for (const int degree : {1, 2, 3}) {
    const Scene scene = wild_scene(static_cast<std::uint64_t>(degree), 9, degree);
    for (const Key& key : keys()) {
      for (const Image& image : images_of(scene, key, true)) {
        instants += expect_same("sorted_list", scene, key, image, Compare::kEvents);
      }
    }
  }
  EXPECT_GT(instants, 1500u);
}

TEST(Metamorphic, TournamentsAndHeaps) {
  std::size_t instants = 0;
  for (const std::string& structure : kMaxima) {
    for (const int degree : {1, 2, 3}) {
      if (kSanitized && degree > 2) break;
      const Scene scene = wild_scene(static_cast<std::uint64_t>(10 + degree), 13, degree);
      for (const Key& key : keys()) {
        for (const Image& image : images_of(scene, key, true)) {
          instants += expect_same(structure, scene, key, image, Compare::kEvents);
        }
      }
    }
  }
  EXPECT_GT(instants, kSanitized ? 1000u : 2000u);
}

TEST(Metamorphic, Delaunay) {
  Key any;
  any.kind = Key::Kind::kDirection;  // not used; turns with the scene
  any.direction = {1, 0};
  std::size_t instants = 0;
  for (const auto& [degree, n] : {std::pair{1, 12}, std::pair{2, 8}, std::pair{3, 6}}) {
    if (kSanitized && degree > 2) break;
    const Scene scene = wild_scene(static_cast<std::uint64_t>(20 + degree), n, degree);
    for (const Image& image : images_of(scene, any, true)) {
      // Not reversed in its attribute: the order of the key is irrelevant here.
      Image read = image;
      read.reverses_order = false;
      instants += expect_same("delaunay_2", scene, any, read, Compare::kEvents);
    }
  }
  EXPECT_GT(instants, kSanitized ? 300u : 500u);
}

TEST(Metamorphic, FlightPlans) {
  for (const int degree : {1, 2}) {
    if (kSanitized && degree > 1) break;
    const Scene scene = wild_flights(static_cast<std::uint64_t>(30 + degree), 9, degree);
    for (const char* structure : {"sorted_list", "maximum_tournament", "minimum_heap"}) {
      for (const Key& key : keys()) {
        for (const Image& image : images_of(scene, key, true)) {
          expect_same(structure, scene, key, image,
                      is_list(structure) ? Compare::kEvents : Compare::kAttributes);
        }
      }
    }
    for (Image& image : images_of(scene, keys()[1], true)) {
      image.reverses_order = false;
      expect_same("delaunay_2", scene, keys()[1], image, Compare::kEvents);
    }
  }
}

TEST(Metamorphic, ManyAtOneInstant) {
  for (const int degree : {1, 2, 3}) {
    if (kSanitized && degree > 1) break;
    const auto seed = static_cast<std::uint64_t>(40 + degree);
    for (const Scene& scene :
         {through_one_point(seed, 9, degree), through_a_lattice(seed, 3, degree)}) {
      for (const Key& key : keys()) {
        for (const Image& image : images_of(scene, key, true)) {
          // Each pair that changes its order swaps once: the swaps at an instant are determined.
          expect_same("sorted_list", scene, key, image, Compare::kEvents);
          for (const std::string& structure : kMaxima) {
            expect_same(structure, scene, key, image, Compare::kAttributes);
          }
        }
      }
      if (degree == 3) continue;  // degree 12 in sturm
      for (Image& image : images_of(scene, keys()[1], true)) {
        image.reverses_order = false;
        expect_same("delaunay_2", scene, keys()[1], image, Compare::kAttributes);
      }
    }
  }
}

}  // namespace metamorphic_test
}  // namespace kinex::test
