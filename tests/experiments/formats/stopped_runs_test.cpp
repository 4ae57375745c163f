// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of every structure that are stopped in the k-th call of their arithmetic, for k = 1, 2, ..:
// in the midst of set-up, of a repair, of a change, of an audit. What they leave is readable and
// true, and what is not finished is not judged.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/log_check.h"
#include "experiments/formats/run_report.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/summary.h"
#include "experiments/lab/scene_run.h"
#include "experiments/view/stage_watch.h"
#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/sanitized.h"

namespace kinex {
namespace stopped_runs_test {

// Points that pass each other, some at one instant; one turns off, one comes and goes.
constexpr const char* kPoints = R"({"kinex": 1, "name": "points", "dimension": 2,
  "time": {"start": 0, "end": 4}, "objects": [
  {"id": "a", "motion": [[0, 1], [0]]},
  {"id": "b", "motion": [[4, -1], [1]]},
  {"id": "c", "motion": [[2], [-3, 2]]},
  {"id": "d", "motion": [{"to": 2, "coordinates": [[1, 1], [3, -1]]},
                         {"from": 2, "coordinates": [[5, -1], [-1, 1]]}]},
  {"id": "e", "motion": [{"from": 1, "to": 3, "coordinates": [[-1, 1], [5, -2]]}]},
  {"id": "f", "motion": [["-1/3", "2/3"], ["7/2", "-1/2"]]}]})";

// Squares of which two fly at the third; one turns off on its way, one comes and goes.
constexpr const char* kBodies = R"({"kinex": 1, "name": "bodies", "dimension": 2,
  "time": {"start": 0, "end": 5}, "objects": [
  {"id": "a", "polygon": [[0, 0], [2, 0], [2, 2], [0, 2]], "motion": [[0], [0]]},
  {"id": "b", "polygon": [[0, 0], [2, 0], [2, 2], [0, 2]], "motion": [[8, -2], [1]]},
  {"id": "c", "polygon": [[0, 0], [2, 0], [1, 2]], "motion": [
    {"to": 1, "coordinates": [[0], [9, -1]]}, {"from": 1, "coordinates": [[0], [10, -2]]}]},
  {"id": "d", "polygon": [[0, 0], [2, 0], [1, 2]], "motion": [
    {"from": 2, "to": 4, "coordinates": [[9, -2], [-9, 1]]}]}]})";

// Says that the run is late, in its call of a given number.
class LateArithmetic final : public view::StageWatch, public SignNow {
 public:
  using view::StageWatch::StageWatch;
  // Counted from now on.
  void be_late_in(std::uint64_t call) { left_ = call; }
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override {
    count();
    view::StageWatch::set_motion(object, trajectory, until);
  }
  void set_now(const Rational& t) override {
    count();
    view::StageWatch::set_now(t);
  }
  void advance(const Query& query, FailureTime& time) override {
    count();
    view::StageWatch::advance(query, time);
  }
  const InstantName& name_now(InstantDetail detail) override {
    count();
    return view::StageWatch::name_now(detail);
  }
  Sign sign_after(const Query& query) override {
    count();
    return view::StageWatch::sign_after(query);
  }
  Sign sign_now(const Query& query) override {
    count();
    return dynamic_cast<SignNow&>(inner()).sign_now(query);
  }
  Outlook failure(const Query& query, FailureTime& time) override {
    count();
    return view::StageWatch::failure(query, time);
  }
  Outlook look_ahead(const Query& query, double limit, FailureTime& time) override {
    count();
    return view::StageWatch::look_ahead(query, limit, time);
  }
  Outlook look_further(const Query& query, double from, double limit, FailureTime& time) override {
    count();
    return view::StageWatch::look_further(query, from, limit, time);
  }
  int compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) override {
    count();
    return view::StageWatch::compare(a, ta, b, tb);
  }
  int compare_with_now(const Query& a, FailureTime& ta) override {
    count();
    return view::StageWatch::compare_with_now(a, ta);
  }
  int compare(const Query& a, FailureTime& ta, const Rational& t) override {
    count();
    return view::StageWatch::compare(a, ta, t);
  }
  std::optional<Rational> rational_between(const Query* query, FailureTime* time) override {
    count();
    return view::StageWatch::rational_between(query, time);
  }

 private:
  void count() {
    if (left_ != 0 && --left_ == 0) throw Stopped();
  }
  std::uint64_t left_ = 0;
};

struct Left {
  bool torn = false;
  RunStatus status = RunStatus::kDone;
  std::vector<std::string> lines;  // of the log, but the last
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

class StoppedRuns : public testing::Test {
 protected:
  ~StoppedRuns() override { std::filesystem::remove(path_); }

  // Checks what a run leaves that is stopped in this call.
  Left run(const Scene& scene, std::string_view arithmetic, std::uint64_t call) {
    SimulatorOptions options;
    options.audit = AuditLevel::kEvents;
    auto late = std::make_unique<LateArithmetic>(planned_arithmetic(arithmetic, scene));
    LateArithmetic& lateness = *late;
    const auto simulator = std::make_unique<Simulator>(scene, std::move(late), options);
    add_structures(*simulator, scene);
    const std::string hash = formats::scene_hash(scene);
    formats::OutputFile file(path_, true);
    formats::EventLog log(*simulator, hash, &file);
    simulator->set_sink(&log);
    lateness.be_late_in(call);
    const formats::RunOutcome outcome = lab::run_scene(*simulator, {});
    lateness.be_late_in(0);
    log.finish(outcome.status);

    EXPECT_TRUE(outcome.clean(*simulator));
    EXPECT_LT(simulator->ledger().instants, 1000u);
    for (const std::string& failure : formats::failures_of(*simulator, outcome)) ADD_FAILURE() << failure;
    const std::string text = formats::read_text_file(path_);
    const formats::LogVerdict verdict = formats::check_log(text, "log", &scene, hash);
    for (const std::string& problem : verdict.problems) ADD_FAILURE() << problem;
    EXPECT_EQ(verdict.status, formats::status_name(outcome.status));
    const formats::RunCounts counts = formats::counts_of(*simulator);
    EXPECT_EQ(verdict.records, counts.records);
    check_summary(*simulator, outcome, log.digest());
    Left left{simulator->is_torn(), outcome.status, lines_of(text)};
    left.lines.pop_back();
    return left;
  }

  // All k for one structure. False if it does not take the scene.
  bool check(const char* text, const StructureInfo& info, std::string_view arithmetic) {
    Scene scene = formats::parse_scene(text, "scene");
    try {
      formats::set_maintain(scene, {std::string(info.name)});
    } catch (const formats::InputError&) {
      return false;
    }
    SCOPED_TRACE(std::string(info.name) + " in " + std::string(arithmetic));
    const Left whole = run(scene, arithmetic, 0);
    EXPECT_EQ(whole.status, RunStatus::kDone);
    const std::uint64_t rate = test::kSanitized ? 3 : 12;
    for (std::uint64_t k = 1;; k += 1 + k / rate) {
      SCOPED_TRACE("call " + std::to_string(k));
      const Left left = run(scene, arithmetic, k);
      if (left.status == RunStatus::kDone) break;
      EXPECT_EQ(left.status, RunStatus::kLimit);
      // What it says is how the whole run begins.
      EXPECT_LE(left.lines.size(), whole.lines.size());
      for (std::size_t i = 0; i < left.lines.size(); ++i) EXPECT_EQ(left.lines[i], whole.lines[i]);
      ++(left.torn ? torn_ : whole_);
      if (HasFailure()) break;
    }
    return true;
  }

  void check_summary(const Simulator& simulator, const formats::RunOutcome& outcome,
                     const std::string& digest) {
    const formats::JsonDocument summary =
        formats::parse_json(formats::write_summary(simulator, outcome, "hash", digest, {}), "summary");
    EXPECT_EQ(summary->find("status")->text(), formats::status_name(outcome.status));
    for (const formats::JsonValue& structure : summary->find("structures")->items()) {
      const bool has_value = structure.find("attribute")->kind() != formats::JsonValue::Kind::kNull;
      const bool has_bounds = !structure.find("bounds")->items().empty();
      if (simulator.is_torn()) {
        EXPECT_FALSE(has_value);
        EXPECT_FALSE(has_bounds);
      } else {
        ++judged_;
      }
    }
    EXPECT_EQ(formats::describe_results(simulator, outcome).find("not judged") != std::string::npos,
              simulator.is_torn());
  }

  std::uint64_t torn_ = 0, whole_ = 0, judged_ = 0;

 private:
  const std::string path_ = (std::filesystem::temp_directory_path() /
                             ("kinex-stopped-" + std::to_string(::getpid())))
                                .string();
};

TEST_F(StoppedRuns, LeaveWhatIsReadableAndTrue) {
  int taken = 0;
  for (const char* scene : {kPoints, kBodies}) {
    for (const StructureInfo& info : structure_infos()) {
      for (const char* arithmetic : {"exact", "sturm"}) {
        taken += check(scene, info, arithmetic) ? 1 : 0;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GE(taken, 40);
  EXPECT_GT(torn_, 400u);
  EXPECT_GT(whole_, 160u);
  EXPECT_GT(judged_, 160u);
}

}  // namespace stopped_runs_test
}  // namespace kinex
