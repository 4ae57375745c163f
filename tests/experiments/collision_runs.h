// SPDX-License-Identifier: GPL-3.0-or-later
// Whole runs of the structures for collisions against the witness: the same contacts, at the same
// exact instants, by features that do meet there.
#ifndef KINEX_TESTS_EXPERIMENTS_COLLISION_RUNS_H
#define KINEX_TESTS_EXPERIMENTS_COLLISION_RUNS_H

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/real_root.h"
#include "experiments/collision_witness.h"
#include "structures/collision_pairs.h"
#include "tests/experiments/body_fixture.h"
#include "tests/structures/test_run.h"

namespace kinex::test {

// All structures that can follow the scene: one of them only where nothing turns against anything.
inline std::vector<std::string> collision_structures(bool turning) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (!info.collisions || (turning && info.name == "separation_minkowski")) continue;
    names.emplace_back(info.name);
  }
  return names;
}

inline Scene scene_of_bodies(std::vector<SceneObject> bodies, Rational start,
                             std::optional<Rational> end) {
  Scene scene;
  scene.name = "bodies";
  scene.dimension = 2;
  scene.start = std::move(start);
  scene.end = std::move(end);
  scene.objects = std::move(bodies);
  return scene;
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
    const Trial& trial, std::uint8_t kind = CollisionPairs::kContact) {
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
inline bool are_met(const SeenContact& seen, const BodyContact& witness, const SceneObject& a,
                    const SceneObject& b) {
  const auto number = [](const std::string& name) {
    return static_cast<std::uint32_t>(std::stoul(name.substr(1)));
  };
  const std::uint32_t i = number(seen.of_a), j = number(seen.of_b);
  const auto is_met = [&](FeaturePair pair) {
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
                         last->trajectory.meets(piece.trajectory, *piece.from);
    if (piece.from && !goes_on) result.push_back(*piece.from);
    last = &piece;
  }
  return result;
}

struct Meetings {
  std::vector<BodyContact> contacts, grazes;
};

// What the witness sees: the first contact, and, after a change of motion after which the bodies do
// not overlap, the next; and the grazes on the way, but for touches that were there from the start,
// from an appearance or out of a contact.
inline Meetings expected_meetings(const SceneObject& a, const SceneObject& b, const Scene& scene) {
  std::vector<Rational> seams, appeared;
  for (const SceneObject* body : {&a, &b}) {
    for (const MotionPiece& piece : body->motion.pieces) {
      if (piece.from) seams.push_back(*piece.from);
    }
    for (const Rational& t : appearances(*body)) appeared.push_back(t);
  }
  std::sort(seams.begin(), seams.end());
  Meetings all;
  std::vector<BodyContact>& result = all.contacts;
  RootCounters counters;
  Rational from = scene.start;
  std::size_t next = 0;
  for (;;) {
    CollisionWitness found = find_contacts(a, b, from, scene.end);
    for (BodyContact& graze : found.grazes) {
      bool old = compare(graze.instant, from, counters) == 0;
      for (const Rational& t : appeared) old = old || compare(graze.instant, t, counters) == 0;
      if (!old) all.grazes.push_back(std::move(graze));
    }
    if (!found.penetration) return all;
    // Those that overlap right after the change are in contact as before, or from a jump or an
    // arrival on, which is no event.
    const bool arrived = found.penetration->features.empty();
    if (!arrived && (result.empty() || compare(found.penetration->instant, from, counters) != 0)) {
      result.push_back(*found.penetration);
    }
    RealRoot instant = found.penetration->instant;
    while (next < seams.size() && compare(instant, seams[next], counters) >= 0) ++next;
    if (next == seams.size()) return all;
    from = seams[next];
  }
}

using BodyContacts = std::map<std::pair<ObjectId, ObjectId>, std::vector<BodyContact>>;
struct Expected {
  BodyContacts contacts, grazes;
};

inline Expected expected_contacts(const Scene& scene) {
  Expected result;
  for (ObjectId a = 0; a < scene.objects.size(); ++a) {
    for (ObjectId b = a + 1; b < scene.objects.size(); ++b) {
      Meetings found = expected_meetings(scene.objects[a], scene.objects[b], scene);
      if (!found.contacts.empty()) result.contacts[{a, b}] = std::move(found.contacts);
      if (!found.grazes.empty()) result.grazes[{a, b}] = std::move(found.grazes);
    }
  }
  return result;
}

inline void expect_meetings(const Trial& trial, const Scene& scene, const BodyContacts& expected,
                            std::uint8_t kind) {
  SCOPED_TRACE(kind == CollisionPairs::kContact ? "contacts" : "grazes");
  RootCounters counters;
  auto seen = contacts_of(trial, kind);
  EXPECT_EQ(seen.size(), expected.size());
  for (const auto& [pair, witnesses] : expected) {
    const std::string who = scene.objects[pair.first].id + " and " + scene.objects[pair.second].id;
    std::vector<SeenContact>& mine = seen[pair];
    ASSERT_EQ(mine.size(), witnesses.size()) << who;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      BodyContact witness = witnesses[i];
      EXPECT_EQ(compare(mine[i].instant, witness.instant, counters), 0) << who;
      EXPECT_TRUE(are_met(mine[i], witness, scene.objects[pair.first], scene.objects[pair.second]))
          << who << ": " << mine[i].of_a << " " << mine[i].of_b;
    }
  }
}

inline void expect_contacts(const Trial& trial, const Scene& scene, const Expected& expected) {
  expect_meetings(trial, scene, expected.contacts, CollisionPairs::kContact);
  expect_meetings(trial, scene, expected.grazes, CollisionPairs::kGraze);
}

// Every structure over the scene, with all audits, against the witness and against `sturm`; and in
// `double` to its end. The numbers of contacts and of grazes.
struct MeetingCounts {
  std::size_t contacts = 0, grazes = 0;
};
inline MeetingCounts check_meetings(const Scene& scene, AuditLevel audit = AuditLevel::kEvents) {
  const Expected expected = expected_contacts(scene);
  MeetingCounts counts;
  for (const auto& [pair, witnesses] : expected.contacts) counts.contacts += witnesses.size();
  for (const auto& [pair, witnesses] : expected.grazes) counts.grazes += witnesses.size();
  for (const std::string& name : collision_structures(turns(scene))) {
    SCOPED_TRACE(name);
    {
      Trial trial(scene, name, "exact", audit);
      trial.to_end();
      trial.expect_clean();
      expect_contacts(trial, scene, expected);
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
