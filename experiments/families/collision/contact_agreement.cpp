// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do contacts and separations come at the same instants, whatever proved that the bodies
//   were apart before?
// Witness: every vertex against every edge, without structures (contact_witness.h).
// Parameters: pairs of random polygons of at most 10 vertices in random motion of degree 1 and 2,
//   with and without turning.
// Expected: the same algebraic number from all; none where the witness finds none.
// Cost: 2 s, 20 s in full.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "experiments/families/collision/contact_witness.h"
#include "experiments/families/collision/experiments.h"
#include "experiments/lab/scene_run.h"
#include "structures/collision/collision_pairs.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

class ContactSink final : public EventSink {
 public:
  void event(const Event& event, Arithmetic& arithmetic) override {
    if (event.kind != CollisionEvent::kContact && event.kind != CollisionEvent::kSeparation) return;
    instants_.push_back(to_root(arithmetic.name_now(InstantDetail::kName)));
  }
  // Of contacts and separations, alternately.
  std::vector<RealRoot>& instants() { return instants_; }

 private:
  std::vector<RealRoot> instants_;
};

std::vector<RealRoot> instants_by(const StructureInfo& info, Scene scene) {
  Request request;
  request.structure = request.label = info.name;
  scene.maintain = {request};
  const auto simulator = lab::make_simulator(scene, "exact", {});
  ContactSink sink;
  simulator->set_sink(&sink);
  simulator->start();
  simulator->run_until(std::nullopt);
  return std::move(sink.instants());
}

std::vector<RealRoot> instants_of(const CollisionWitness& witness) {
  std::vector<RealRoot> instants;
  for (std::size_t i = 0; i < witness.contacts.size(); ++i) {
    instants.push_back(witness.contacts[i].instant);
    if (i < witness.separations.size()) instants.push_back(witness.separations[i].instant);
  }
  return instants;
}

bool same(std::vector<RealRoot> a, std::vector<RealRoot> b) {
  RootCounters counters;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](RealRoot& x, RealRoot& y) { return compare(x, y, counters) == 0; });
}

void stop_turning(Scene& scene) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      piece.trajectory.coordinates[2] = {Rational(1)};
      piece.trajectory.coordinates[3] = {Rational()};
      piece.trajectory.normalise();
    }
  }
}

struct Tally {
  int right = 0, scenes = 0;
  std::string first_wrong;
};

}  // namespace

lab::StudyResult study_contacts(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "contacts";
  result.table.title = "collision: instants of contact and separation, against the witness";
  result.table.header = {"structure", "scenes", "with a contact", "contacts and separations",
                         "scenes with the same instants"};
  std::map<std::string, Tally> tallies;
  std::map<std::string, int> contacts;
  std::map<std::string, std::size_t> instants;
  for (int k = 0; k < (quick ? 24 : 200) && go_on(); ++k) {
    lab::WorkloadParameters parameters;
    parameters.n = parameters.m = 10;
    parameters.degree = 1 + k % 2;
    parameters.seed = static_cast<std::uint64_t>(k) + 1;
    Scene scene = lab::generate_scene(*lab::find_workload("polygon-random"), parameters);
    const bool turning = k % 4 < 2;
    if (!turning) stop_turning(scene);
    const CollisionWitness witness =
        find_contacts(scene.objects[0], scene.objects[1], scene.start, scene.end);
    const std::vector<RealRoot> truth = instants_of(witness);
    for (const StructureInfo& info : structure_infos()) {
      if (!info.follows_bodies() || refusal_of(info, scene)) continue;
      const std::string name(info.name);
      Tally& tally = tallies[name];
      ++tally.scenes;
      contacts[name] += truth.empty() ? 0 : 1;
      instants[name] += truth.size();
      std::string wrong = "other instants";
      bool right = false;
      try {
        right = same(instants_by(info, scene), truth);
      } catch (const std::exception& error) {
        wrong = error.what();
      }
      tally.right += right ? 1 : 0;
      if (!right && tally.first_wrong.empty()) {
        tally.first_wrong = fmt::format("; first in {}{}: {}", scene.name,
                                        turning ? "" : " without turning", wrong);
      }
    }
  }
  for (const StructureInfo& info : structure_infos()) {
    const auto found = tallies.find(std::string(info.name));
    if (found == tallies.end()) continue;
    const auto& [name, tally] = *found;
    result.table.rows.push_back({name, std::to_string(tally.scenes), std::to_string(contacts[name]),
                                 std::to_string(instants[name]), std::to_string(tally.right)});
    result.checks.push_back(
        {"contact." + name, "witness", "", fmt::format("{} right", tally.scenes),
         fmt::format("{} right{}", tally.right, tally.first_wrong),
         "every vertex against every edge",
         tally.right == tally.scenes ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

}  // namespace kinex::families
