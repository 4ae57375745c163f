// SPDX-License-Identifier: GPL-3.0-or-later
// Every structure shows its proof as data: each live certificate once, with a role, in groups that
// can be distinguished; and every predicate names the roles of its arguments.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/sanitized.h"
#include "tests/structures/collision/body_polygons.h"
#include "tests/structures/collision/scene_of_bodies.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace proof_test {

class Visited final : public ProofVisitor {
 public:
  explicit Visited(std::string where) : where_(std::move(where)) {}
  void group(const ProofGroup& group) override {
    EXPECT_FALSE(group.kind.empty()) << where_;
    const std::vector<ObjectId> about =
        group.place == ProofGroup::kNoPlace ? group.about : std::vector<ObjectId>{};
    EXPECT_TRUE(groups.insert({group.place, about}).second)
        << where_ << ": two groups are one, " << group.kind;
    if (group.parent != ProofGroup::kNoPlace) parents.insert(group.parent);
    marks += group.marks.size();
  }
  void certificate(CertificateId id, std::string_view role) override {
    EXPECT_FALSE(groups.empty()) << where_ << ": a certificate before the first group";
    EXPECT_FALSE(role.empty()) << where_;
    EXPECT_TRUE(certificates.insert(id).second) << where_ << ": a certificate is shown twice";
  }
  std::set<std::pair<std::uint64_t, std::vector<ObjectId>>> groups;
  std::set<std::uint64_t> parents;
  std::set<CertificateId> certificates;
  std::size_t marks = 0;

 private:
  std::string where_;
};

void expect_form(const Predicate& predicate, const std::string& where) {
  const ClaimForm form = predicate.form();
  const std::string name = where + ": " + std::string(predicate.name());
  ASSERT_EQ(form.roles.size(), static_cast<std::size_t>(predicate.arity())) << name;
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < form.roles.size(); ++i) {
    EXPECT_FALSE(form.roles[i].name.empty()) << name;
    EXPECT_TRUE(names.insert(form.roles[i].name).second) << name << ": two roles are one";
    if (form.roles[i].kind == ArgumentRole::Kind::kPose) continue;
    EXPECT_NE(form.says.find("{" + std::to_string(i) + "}"), std::string_view::npos) << name;
  }
  // Without a figure a segment is drawn between two objects, and lines as they are, which says enough.
  const bool simple = predicate.arity() <= 2 || predicate.name().find("line_") != std::string_view::npos;
  EXPECT_TRUE(simple || form.figure != ClaimFigure::kNone) << name;
  std::set<std::uint8_t> placed;
  for (const std::uint8_t place : form.places) {
    EXPECT_LT(place, form.roles.size()) << name;
    placed.insert(place);
  }
  EXPECT_TRUE(form.places.empty() || placed.size() == form.roles.size()) << name;
  EXPECT_TRUE(form.sign == 1 || form.sign == -1) << name;
}

// Every structure that the scene can have.
std::vector<std::string> ask_for_all(Scene& scene) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (refusal_of(info, scene)) continue;
    names.emplace_back(info.name);
    scene.maintain.push_back({names.back(), names.back(), {}});
  }
  return names;
}

// The number of certificates seen, by structure.
std::map<std::string, std::size_t> check(Scene scene, int stops) {
  std::map<std::string, std::size_t> seen;
  ask_for_all(scene);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  for (int i = 0; i <= stops; ++i) {
    const Rational t = scene.start + (*scene.end - scene.start) * Rational(i) / Rational(stops);
    simulator.run_until(t);
    std::vector<std::set<CertificateId>> live(simulator.structures());
    for (CertificateId c = 0; c < simulator.queue().capacity(); ++c) {
      const Certificate& certificate = simulator.queue().certificate(c);
      if (certificate.live) live[certificate.structure].insert(c);
    }
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      const std::string where = scene.name + ", " + simulator.label(id) + " at " + t.to_string();
      Visited visited(where);
      simulator.structure(id).visit_proof(visited);
      EXPECT_EQ(visited.certificates, live[id]) << where;
      for (const std::uint64_t parent : visited.parents) {
        EXPECT_TRUE(visited.groups.contains({parent, {}})) << where << ": a parent is missing";
      }
      for (const CertificateId c : visited.certificates) {
        expect_form(
            simulator.arithmetic().predicate(simulator.queue().query(c).predicate),
            where);
      }
      seen[simulator.label(id)] += visited.certificates.size() + visited.marks;
    }
  }
  return seen;
}

Scene boxes(int n, bool turning) {
  Random random(7);
  std::vector<SceneObject> bodies;
  for (int i = 0; i < n; ++i) {
    const int x = 5 * (i % 3), y = 5 * (i / 3);
    std::vector<std::vector<Rational>> motion{{x, random.between(-2, 2)},
                                              {y, random.between(-2, 2)}};
    motion.push_back({1});
    motion.push_back(turning ? std::vector<Rational>{0, Rational(Integer(1), Integer(3))}
                             : std::vector<Rational>{0});
    bodies.push_back(
        rigid("b" + std::to_string(i), regular(5 + i % 3, 0.1 * i), std::move(motion)));
  }
  return scene_of_bodies(std::move(bodies), 0, Rational(4));
}

TEST(Proof, EveryLiveCertificateIsShownOnce) {
  std::map<std::string, std::size_t> seen;
  const auto add = [&seen](const std::map<std::string, std::size_t>& more) {
    for (const auto& [name, count] : more) seen[name] += count;
  };
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    if (kSanitized && seed > 2) break;
    add(check(random_flights(seed, 12, 2, 1, seed % 2 == 0), 16));
    add(check(random_flights(seed, 9, 2, 2, seed % 2 == 1), 16));
    add(check(random_flights(seed, 9, 1, 1, true), 8));
    const StructureInfo& graph = *find_structure_info("graph_mst_list");
    add(check(suited(random_flights(seed, 9, 1, 1, true), graph), 8));
    add(check(random_flights(seed, 7, 3, 1, seed % 2 == 0), 8));
    const StructureInfo& discs = *find_structure_info("disc_pairs_boxes");
    add(check(suited(random_flights(seed, 8, 2, 1, true), discs), 8));
    const StructureInfo& lines = *find_structure_info("incidences_all");
    add(check(suited(random_flights(seed, 8, 2, 1, true), lines), 8));
  }
  add(check(boxes(2, true), 40));
  add(check(boxes(2, false), 40));
  add(check(boxes(6, true), 40));
  add(check(boxes(6, false), 40));
  for (const StructureInfo& info : structure_infos()) {
    if (!info.reads.empty()) continue;  // the proof is that of the structure that it reads
    if (!info.bodies && info.kinds.empty()) continue;  // without certificates
    EXPECT_GT(seen[std::string(info.name)], 0u) << info.name;
  }
}

}  // namespace proof_test
}  // namespace kinex::test
