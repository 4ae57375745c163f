// SPDX-License-Identifier: GPL-3.0-or-later
// Every run of a test in `exact` is repeated in `sturm`, which shares no filter with it, and
// compared: all events, their order, the exact names of their instants, and the attribute at the
// end.
//
// Large scenes are compared up to their first events only, or not at all; the test's record says so
// ("sturm").
#ifndef KINEX_TESTS_STRUCTURES_STURM_TWIN_H
#define KINEX_TESTS_STRUCTURES_STURM_TWIN_H

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "core/engine/simulator.h"
#include "structures/registry.h"
#include "tests/structures/recorder.h"

namespace kinex::test {

// Beyond this many objects `sturm` takes too long to build a structure.
inline constexpr std::size_t kMostTwinObjects = 1100;

// The number of failures compared: about a second in `sturm`.
inline std::size_t twin_failures(const Scene& scene, std::string_view structure) {
  if (structure != "delaunay_2") return 2000;
  constexpr std::size_t kByDegree[] = {1000, 1000, 300, 150};
  const int degree = scene.degree();
  return degree <= 3 ? kByDegree[degree] : 50;
}

// For one structure of this name alone.
inline std::unique_ptr<Arithmetic> arithmetic_for(std::string_view structure,
                                                  std::string_view arithmetic, const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  const StructureInfo* info = find_structure_info(structure);
  if (info != nullptr && info->weights) needs.add_weights(scene);
  if (info != nullptr && info->derives != nullptr) info->derives(scene, needs);
  return make_arithmetic(arithmetic, scene, needs);
}

// True if `scene` is run in `sturm` too; if not, the test's record says why.
inline bool has_twin(const Scene& scene, const std::string& arithmetic) {
  if (arithmetic != "exact") return false;
  if (scene.objects.size() <= kMostTwinObjects) return true;
  ::testing::Test::RecordProperty(
      "sturm", "not compared: " + std::to_string(scene.objects.size()) + " objects");
  return false;
}

// `recorded` are the events of `exact`, a run of one structure that has gone as far as reached().
inline void expect_same_in_sturm(const Simulator& exact, const Recorder& recorded,
                                 const Request& request, const OutsideChanges& changes) {
  const Scene& scene = exact.scene();
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = twin_failures(scene, request.structure);
  Simulator sturm(scene, arithmetic_for(request.structure, "sturm", scene), options);
  Recorder twin;
  twin.instants = recorded.instants;
  sturm.set_sink(&twin);
  const StructureId id = sturm.reserve();
  sturm.add(id, make_structure(request, scene, sturm.kernel(), id), request.label);
  sturm.start();
  changes.repeat(sturm);
  const bool complete = sturm.run_until(exact.reached()) == RunStatus::kDone;
  const std::size_t common = std::min(recorded.events.size(), twin.events.size());
  for (std::size_t i = 0; i < common; ++i) {
    ASSERT_EQ(recorded.events[i], twin.events[i]) << "event " << i << " of " << scene.name;
  }
  if (!complete) {
    ASSERT_LE(twin.events.size(), recorded.events.size()) << scene.name;
    ::testing::Test::RecordProperty("sturm", "compared: " + std::to_string(common) + " events of " +
                                                 std::to_string(recorded.events.size()));
    return;
  }
  ASSERT_EQ(recorded.events.size(), twin.events.size()) << scene.name;
  EXPECT_EQ(exact.structure(0).attribute(), sturm.structure(id).attribute()) << scene.name;
  const StructureLedger& a = exact.ledger(0);
  const StructureLedger& b = sturm.ledger(id);
  EXPECT_EQ(a.processed, b.processed);
  EXPECT_EQ(a.rebuilds, b.rebuilds);
  EXPECT_EQ(a.certificates_created, b.certificates_created);
  EXPECT_EQ(a.simultaneous_groups, b.simultaneous_groups);
}

}  // namespace kinex::test

#endif
