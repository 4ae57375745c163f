// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/families/check_scene.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/refused_change.h"
#include "core/engine/simulator.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/run_report.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/scene_run.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

// One line a record: kind, objects, and a mark for what is external.
class Lines final : public EventSink {
 public:
  Lines(const Simulator& simulator, StructureId asked) : simulator_(&simulator), asked_(asked) {}

  void event(const Event& event, Arithmetic& arithmetic) override {
    const std::vector<std::string_view> kinds = simulator_->event_kinds(event.structure);
    std::string objects;
    for (std::size_t i = 0; i < event.count; ++i) {
      objects += " " + simulator_->object_name(event.ids[i]);
    }
    all += std::to_string(event.structure) + " " + std::string(kinds[event.kind]) + objects +
           (event.external ? " !\n" : "\n");
    if (!event.external || event.structure != asked_) return;
    now_ = arithmetic.now_approximate();
    external_now_.push_back(std::string(kinds[event.kind]) + objects + "\n");
    changes_now_.push_back((event.has_difference() ? difference(event) : objects) + "\n");
  }
  // What happens at one instant has no order that structures of one attribute would share.
  void instant_ended() override {
    if (!changes_now_.empty()) note_state();
    for (const auto& [lines, text] : {std::pair(&external_now_, &external), {&changes_now_, &changes}}) {
      std::sort(lines->begin(), lines->end());
      for (const std::string& line : *lines) *text += line;
      lines->clear();
    }
  }

  std::string all;
  std::string external;  // external events of the structure that was asked for: kinds and objects
  std::string changes;   // the change of the attribute alone, or the objects that determine it
  // The attribute after each of its changes. Changes at what may be one instant are one: certificates
  // that fail together in `exact` (where sides are parallel, two strips on them are equally wide) fail
  // one after the other where instants are rounded.
  // `first` is the attribute at the start: certificates that fail one after the other may lead away
  // from it and back.
  std::string states(const Attribute& first) const {
    std::string text = "\n" + line_of(first);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const bool last = i + 1 == states_.size() || states_[i + 1].first - states_[i].first > kClose;
      if (last && !text.ends_with("\n" + states_[i].second)) text += states_[i].second;
    }
    return text;
  }

 private:
  static constexpr double kClose = 1e-12;

  void note_state() {
    states_.emplace_back(now_, line_of(simulator_->structure(asked_).attribute()));
  }

  std::string line_of(const Attribute& attribute) const {
    std::string text;
    for (const ObjectId id : attribute.ids) text += simulator_->object_name(id) + " ";
    return text + "\n";
  }

  std::string difference(const Event& event) const {
    std::string text;
    for (const auto& [sign, ids] : {std::pair(" -", &event.gone), {" +", &event.came}}) {
      for (const ObjectId id : *ids) text += sign + simulator_->object_name(id);
    }
    return text;
  }

  std::vector<std::string> external_now_, changes_now_;  // of the instant in hand
  double now_ = 0;
  std::vector<std::pair<double, std::string>> states_;  // after an instant: the attribute
  const Simulator* simulator_;
  StructureId asked_;
};

// Structures that maintain one attribute and report it alike are in one group; empty: alone.
struct Group {
  std::string name;
  bool kinds = false;  // the kinds of external events are the same, too
};

Group group_of(const StructureInfo& info) {
  return {std::string(info.group), info.bodies || info.shape == Attribute::Shape::kCycle};
}

struct Seen {
  std::string all, external, changes, states;
  bool ended = false;
  bool corrupt = false;
};

class Check {
 public:
  Check(const std::string& text, const SceneCheck& what, Tally& tally)
      : text_(text), what_(what), tally_(tally) {}

  void structure(const StructureInfo& info) {
    Scene scene = formats::parse_scene(text_, "scene.json");
    try {
      formats::set_maintain(scene, {std::string(info.name)});
    } catch (const formats::InputError&) {
      ++tally_.refused;
      return;
    }
    const std::optional<Seen> exact = run(scene, "exact", AuditLevel::kEvents);
    if (!exact || !exact->ended) return;
    compare_group(info, *exact);
    for (const std::string& arithmetic : what_.arithmetics) {
      const std::optional<Seen> seen = run(scene, arithmetic, AuditLevel::kEnd);
      if (seen && seen->ended && arithmetic == "sturm")
        expect_same(info, arithmetic, *exact, *seen);
    }
    // Where sides become parallel or perpendicular, the order of two rectangles on them vanishes: an
    // inexact arithmetic does not know which one is smaller right after it (seed 5 of every_arithmetic).
    const bool on_sides = info.shares.needs == 4;
    for (const std::string& arithmetic : what_.faithful) {
      if (on_sides) continue;
      const std::optional<Seen> seen = run(scene, arithmetic, AuditLevel::kEnd);
      if (seen && seen->ended) expect_faithful(info, arithmetic, *exact, *seen);
    }
  }

 private:
  // nullopt if the scene is refused, or if the run has thrown, which is a problem.
  std::optional<Seen> run(const Scene& scene, const std::string& arithmetic, AuditLevel audit) {
    const std::string name = scene.maintain.front().structure + " in " + arithmetic;
    ++tally_.runs;
    const double begin = lab::cpu_seconds();
    std::optional<Seen> seen = watched_run(scene, arithmetic, audit, name);
    tally_.time(name, lab::cpu_seconds() - begin);
    return seen;
  }

  std::optional<Seen> watched_run(const Scene& scene, const std::string& arithmetic,
                                  AuditLevel audit, const std::string& name) {
    try {
      SimulatorOptions options;
      options.audit = audit;
      options.max_seconds = what_.max_seconds;
      const auto simulator = lab::make_simulator(scene, arithmetic, options);
      const StructureId asked = asked_structure(scene);
      Lines lines(*simulator, asked);
      simulator->set_sink(&lines);
      const formats::RunOutcome outcome = lab::run_scene(*simulator, {scene.start});
      const Attribute first = outcome.samples.empty() ? Attribute{} : outcome.samples[0].values[asked];
      Seen seen{std::move(lines.all), std::move(lines.external), std::move(lines.changes),
                lines.states(first), outcome.status == RunStatus::kDone, false};
      if (!seen.ended) ++tally_.limits;
      for (StructureId id = 0; id < simulator->structures(); ++id) {
        seen.corrupt = seen.corrupt || simulator->ledger(id).corrupt;
        if (arithmetic == "exact") tally_.events += simulator->ledger(id).processed;
      }
      if (seen.corrupt) ++tally_.corrupt;
      if (simulator->kernel().is_exact() && !outcome.clean(*simulator)) {
        for (const std::string& failure : formats::failures_of(*simulator, outcome)) {
          tally_.problem(name + ": " + failure, text_);
        }
      }
      return seen;
    } catch (const formats::InputError& error) {
      ++tally_.refused;
      return std::nullopt;
    } catch (const RefusedChange& refused) {
      // A body that appears touching another one and then enters it: the run alone can tell.
      // Structures of one attribute, and exact arithmetics, have to refuse it alike.
      ++tally_.refused;
      const std::string all = std::string("refused: ") + refused.what();
      return Seen{all, all, all, all, true, false};
    } catch (const std::exception& error) {
      tally_.problem(name + " has thrown: " + error.what(), text_);
      return std::nullopt;
    }
  }

  void expect_same(const StructureInfo& info, const std::string& arithmetic, const Seen& exact,
                   const Seen& other) {
    if (other.all == exact.all) return;
    tally_.problem(std::string(info.name) + ": other records in " + arithmetic +
                       " than in exact\n" + arithmetic + ":\n" + other.all + "exact:\n" + exact.all,
                   text_);
  }

  // Certificates that fail at one instant fail in whatever order their roots were rounded to: the
  // attribute is the same between such instants, and nothing else need be.
  void expect_faithful(const StructureInfo& info, const std::string& arithmetic, const Seen& exact,
                       const Seen& other) {
    if (other.states == exact.states) return;
    expect_same(info, arithmetic, exact, other);
  }

  void compare_group(const StructureInfo& info, const Seen& seen) {
    const Group group = group_of(info);
    if (group.name.empty()) return;
    const std::string& events = group.kinds ? seen.external : seen.changes;
    const auto [first, is_new] = groups_.try_emplace(group.name, std::string(info.name), events);
    if (is_new || first->second.second == events) return;
    tally_.problem(std::string(info.name) + ": other external events than " + first->second.first +
                       "\n" + events + "instead of\n" + first->second.second,
                   text_);
  }

  const std::string& text_;
  const SceneCheck& what_;
  Tally& tally_;
  std::map<std::string, std::pair<std::string, std::string>>
      groups_;  // first structure, its events
};

}  // namespace

void check_scene(const std::string& text, const SceneCheck& what, Tally& tally) {
  ++tally.scenes;
  try {
    formats::parse_scene(text, "scene.json");
  } catch (const formats::InputError&) {
    ++tally.refused;
    return;
  } catch (const std::exception& error) {
    return tally.problem(std::string("the reader has thrown: ") + error.what(), text);
  }
  Check check(text, what, tally);
  for (const StructureInfo& info : structure_infos()) check.structure(info);
}

void Tally::problem(const std::string& what, std::string_view scene) {
  problems.push_back(what);
  if (problems.size() <= kMostProblems) problems.back() += "\nscene:\n" + std::string(scene);
}

void Tally::time(const std::string& run, double seconds) {
  if (seconds <= slowest) return;
  slowest = seconds;
  slowest_run = run;
}

}  // namespace kinex::families
