// SPDX-License-Identifier: GPL-3.0-or-later
// Whole runs of the structures for collisions against the witness: the same contacts, at the same
// exact instants, by features that do meet there.
#ifndef KINEX_TESTS_EXPERIMENTS_FAMILIES_COLLISION_COLLISION_RUNS_H
#define KINEX_TESTS_EXPERIMENTS_FAMILIES_COLLISION_COLLISION_RUNS_H

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"
#include "experiments/families/collision/contact_witness.h"
#include "structures/collision/collision_pairs.h"
#include "tests/experiments/body_fixture.h"
#include "tests/structures/collision/scene_of_bodies.h"
#include "tests/structures/test_run.h"

namespace kinex::test {

// All structures that can follow the scene: one of them only where nothing turns against anything.
inline std::vector<std::string> collision_structures(bool turning) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (!info.follows_bodies() || (turning && info.name == "separation_minkowski")) continue;
    names.emplace_back(info.name);
  }
  return names;
}

// True if some body's rotor is not constant, or rotors differ.
inline bool turns(const Scene& scene) {
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) {
      for (std::size_t k = 2; k < 4; ++k) {
        const auto& first = scene.objects[0].motion.pieces[0].trajectory.coordinates[k];
        if (piece.trajectory.coordinates[k] != first || first.size() > 1) return true;
      }
    }
  }
  return false;
}

struct SeenContact {
  RealRoot instant;
  std::string of_a, of_b;  // "v3", "e0"
};

inline RealRoot instant_of(const Recorded& event) {
  std::vector<Integer> coefficients;
  for (const std::string& c : event.polynomial) {
    coefficients.push_back(Rational::parse(c)->numerator());
  }
  RootCounters counters;
  auto roots = isolate_real_roots(Polynomial(std::move(coefficients)), counters);
  return roots.at(static_cast<std::size_t>(event.root - 1)).root;
}

// The contacts of a run, by pair; or the grazes.
inline std::map<std::pair<ObjectId, ObjectId>, std::vector<SeenContact>> contacts_of(
    const Trial& trial, std::uint8_t kind = CollisionEvent::kContact) {
  std::map<std::pair<ObjectId, ObjectId>, std::vector<SeenContact>> result;
  for (const Recorded& event : trial.sink.recorder.events) {
    if (event.kind != kind) continue;
    EXPECT_TRUE(event.external);
    EXPECT_EQ(event.ids.size(), 4u);
    const auto feature = [&](std::size_t i) {
      const std::string& name = trial.simulator.object_name(event.ids[i]);
      const std::string body = trial.simulator.object_name(event.ids[i - 2]);
      EXPECT_EQ(name.substr(0, body.size() + 1), body + ".");
      return name.substr(body.size() + 1);
    };
    result[{event.ids[0], event.ids[1]}].push_back({instant_of(event), feature(2), feature(3)});
  }
  return result;
}

// True if the two features are among those that meet. A vertex that meets a vertex lies on the two
// edges beside it.
inline bool are_met(const SeenContact& seen, const families::BodyContact& witness, const SceneObject& a,
                    const SceneObject& b) {
  const auto number = [](const std::string& name) {
    return static_cast<std::uint32_t>(std::stoul(name.substr(1)));
  };
  const std::uint32_t i = number(seen.of_a), j = number(seen.of_b);
  const auto is_met = [&](families::FeaturePair pair) {
    return std::binary_search(witness.features.begin(), witness.features.end(), pair);
  };
  if (seen.of_a[0] == 'e' && seen.of_b[0] == 'v') return is_met({false, j, i});
  if (seen.of_a[0] == 'v' && seen.of_b[0] == 'e') return is_met({true, i, j});
  if (seen.of_a[0] == 'e') return false;
  const auto before = [](std::uint32_t k, const SceneObject& body) {
    return (k == 0 ? static_cast<std::uint32_t>(body.polygon.size()) : k) - 1;
  };
  return is_met({true, i, j}) && is_met({true, i, before(j, b)}) && is_met({false, j, i}) &&
         is_met({false, j, before(i, a)});
}

// When the body appears or jumps.
inline std::vector<Rational> appearances(const SceneObject& body) {
  std::vector<Rational> result;
  const MotionPiece* last = nullptr;
  for (const MotionPiece& piece : body.motion.pieces) {
    const bool goes_on = last != nullptr && last->to == piece.from &&
                         last->trajectory.meets(piece.trajectory, *piece.from, true);
    if (piece.from && !goes_on) result.push_back(*piece.from);
    last = &piece;
  }
  return result;
}

// What the witness sees, but for what is there from the start or from an appearance, and touches
// that follow a separation.
inline families::CollisionWitness expected_meetings(const SceneObject& a, const SceneObject& b,
                                          const Scene& scene) {
  std::vector<Rational> appeared{scene.start};
  for (const SceneObject* body : {&a, &b}) {
    for (const Rational& t : appearances(*body)) appeared.push_back(t);
  }
  RootCounters counters;
  families::CollisionWitness all = families::find_contacts(a, b, scene.start, scene.end);
  for (auto* list : {&all.contacts, &all.grazes, &all.separations}) {
    list->erase(std::remove_if(list->begin(), list->end(),
                               [&](families::BodyContact& one) {
                                 return std::any_of(appeared.begin(), appeared.end(),
                                                    [&](const Rational& t) {
                                                      return compare(one.instant, t, counters) == 0;
                                                    });
                               }),
                list->end());
  }
  return all;
}

using BodyContacts = std::map<std::pair<ObjectId, ObjectId>, std::vector<families::BodyContact>>;
struct Expected {
  BodyContacts contacts, grazes, separations;
};

inline Expected expected_contacts(const Scene& scene) {
  Expected result;
  for (ObjectId a = 0; a < scene.objects.size(); ++a) {
    for (ObjectId b = a + 1; b < scene.objects.size(); ++b) {
      families::CollisionWitness found = expected_meetings(scene.objects[a], scene.objects[b], scene);
      if (!found.contacts.empty()) result.contacts[{a, b}] = std::move(found.contacts);
      if (!found.grazes.empty()) result.grazes[{a, b}] = std::move(found.grazes);
      if (!found.separations.empty()) result.separations[{a, b}] = std::move(found.separations);
    }
  }
  return result;
}

inline void expect_meetings(const Trial& trial, const Scene& scene, const BodyContacts& expected,
                            std::uint8_t kind) {
  SCOPED_TRACE(kind == CollisionEvent::kContact ? "contacts"
               : kind == CollisionEvent::kGraze ? "grazes"
                                                : "separations");
  RootCounters counters;
  auto seen = contacts_of(trial, kind);
  EXPECT_EQ(seen.size(), expected.size());
  for (const auto& [pair, witnesses] : expected) {
    const std::string bodies = scene.objects[pair.first].id + " and " + scene.objects[pair.second].id;
    std::vector<SeenContact>& mine = seen[pair];
    ASSERT_EQ(mine.size(), witnesses.size()) << bodies;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      families::BodyContact witness = witnesses[i];
      EXPECT_EQ(compare(mine[i].instant, witness.instant, counters), 0) << bodies;
      EXPECT_TRUE(are_met(mine[i], witness, scene.objects[pair.first], scene.objects[pair.second]))
          << bodies << ": " << mine[i].of_a << " " << mine[i].of_b;
    }
  }
}

inline void expect_contacts(const Trial& trial, const Scene& scene, const Expected& expected) {
  expect_meetings(trial, scene, expected.contacts, CollisionEvent::kContact);
  expect_meetings(trial, scene, expected.grazes, CollisionEvent::kGraze);
  expect_meetings(trial, scene, expected.separations, CollisionEvent::kSeparation);
}

// What contacts, grazes and separations name, in some order that depends on the names alone.
inline std::vector<std::string> features_named(const Trial& trial) {
  std::vector<std::string> names;
  for (const Recorded& event : trial.sink.recorder.events) {
    if (event.kind > CollisionEvent::kSeparation) continue;
    std::string& all = names.emplace_back();
    for (const ObjectId id : event.ids) all += trial.simulator.object_name(id) + " ";
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Every structure over the scene, with all audits, against the witness and against `sturm`; and in
// `double` to its end. In exact runs all structures name the same features. The numbers of
// contacts, grazes and separations.
struct MeetingCounts {
  std::size_t contacts = 0, grazes = 0, separations = 0;
};
inline MeetingCounts check_meetings(const Scene& scene, AuditLevel audit = AuditLevel::kEvents) {
  const Expected expected = expected_contacts(scene);
  MeetingCounts counts;
  for (const auto& [pair, witnesses] : expected.contacts) counts.contacts += witnesses.size();
  for (const auto& [pair, witnesses] : expected.grazes) counts.grazes += witnesses.size();
  for (const auto& [pair, witnesses] : expected.separations) counts.separations += witnesses.size();
  std::optional<std::vector<std::string>> named;
  for (const std::string& name : collision_structures(turns(scene))) {
    SCOPED_TRACE(name);
    {
      Trial trial(scene, name, "exact", audit);
      trial.to_end();
      trial.expect_clean();
      expect_contacts(trial, scene, expected);
      const std::vector<std::string> names = features_named(trial);
      if (!named) named = names;
      EXPECT_EQ(*named, names);
    }
    Trial rough(scene, name, "double", AuditLevel::kNone);
    EXPECT_NO_THROW(rough.to_end());
    if (testing::Test::HasFailure()) break;
  }
  return counts;
}

inline std::size_t check_runs(const Scene& scene, AuditLevel audit = AuditLevel::kEvents) {
  return check_meetings(scene, audit).contacts;
}

}  // namespace kinex::test

#endif
