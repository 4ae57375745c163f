// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene maintains and what is only read for it are counted apart: in reports of runs and of logs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/log_check.h"
#include "experiments/formats/log_table.h"
#include "experiments/formats/log_uses.h"
#include "experiments/formats/run_report.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/family.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex {
namespace uses_test {

using ::testing::HasSubstr;
using ::testing::Not;

Scene scene_with(const std::vector<std::string>& maintain, int n = 8) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  formats::set_maintain(scene, maintain);
  return scene;
}

struct Ran {
  std::string report, log;
  formats::CountsByUse counts;
  std::uint64_t external = 0;  // of the structures with these labels
};

Ran run(const Scene& scene, const std::set<std::string>& labels) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("kinex-uses-" + std::to_string(::getpid())))
          .string();
  const auto simulator = lab::make_simulator(scene, "exact", {});
  Ran ran;
  {
    formats::OutputFile file(path, true);
    formats::EventLog log(*simulator, formats::scene_hash(scene), &file);
    simulator->set_sink(&log);
    const formats::RunOutcome outcome = lab::run_scene(*simulator, {});
    log.finish(outcome.status);
    ran.report = formats::describe_results(*simulator, outcome);
  }
  ran.log = formats::read_text_file(path);
  std::filesystem::remove(path);
  ran.counts = formats::counts_by_use(*simulator);
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    if (labels.contains(simulator->label(id))) ran.external += simulator->ledger(id).external;
  }
  return ran;
}

TEST(Uses, TheLastLineCountsWhatIsMaintained) {
  const Ran ran = run(scene_with({"convex_hull_2_delaunay"}), {"convex_hull_2_delaunay"});
  EXPECT_EQ(ran.counts.maintained.external, ran.external);
  EXPECT_GT(ran.counts.read.external, 0u);
  EXPECT_THAT(ran.report, HasSubstr("\ndone: " + std::to_string(ran.counts.maintained.events()) +
                                    " events (" + std::to_string(ran.external) + " external, "));
  EXPECT_THAT(ran.report,
              HasSubstr(", and " + std::to_string(ran.counts.read.events()) + " events (" +
                        std::to_string(ran.counts.read.external) + " external, "));
  EXPECT_THAT(ran.report, HasSubstr(" of structures that these read, at "));
  const Ran both = run(scene_with({"convex_hull_2_delaunay", "delaunay_2"}),
                       {"convex_hull_2_delaunay", "delaunay_2"});
  EXPECT_EQ(both.counts.maintained.external, both.external);
  EXPECT_EQ(both.counts.read.records, 0u);
  EXPECT_THAT(both.report, Not(HasSubstr("that these read")));
}

TEST(Uses, LogsSayItToo) {
  const Scene scene = scene_with({"convex_hull_2_delaunay"});
  const Ran ran = run(scene, {"convex_hull_2_delaunay"});
  formats::LogReader reader(ran.log, "log");
  const formats::LogTable table = formats::log_table(reader, {}, formats::LogTableForm::kPlain);
  EXPECT_EQ(table.external.maintained, ran.external);
  EXPECT_EQ(table.external.read, ran.counts.read.external);
  const formats::LogVerdict verdict = formats::check_log(ran.log, "log");
  EXPECT_EQ(verdict.external_by_use.maintained, ran.external);
  EXPECT_EQ(verdict.external, ran.external + ran.counts.read.external);
  EXPECT_EQ(verdict.external_by_use.text(), std::to_string(ran.external) + " external (and " +
                                                std::to_string(ran.counts.read.external) +
                                                " of structures that these read)");
}

// The labels alone say what the plan knows, of every structure, and of labels of one's own.
TEST(Uses, LabelsOfALogSayWhatIsOnlyRead) {
  std::size_t read = 0;
  const auto compare = [&read](const Scene& scene) {
    formats::LogHeader header;
    std::set<std::string> right;
    for (const PlannedStructure& planned : plan_structures(scene)) {
      header.structures.push_back({planned.request.label, planned.request.structure, "", {}});
      if (!planned.asked) right.insert(planned.request.label);
    }
    EXPECT_EQ(formats::labels_only_read(header), right);
    read += right.size();
  };
  for (const StructureInfo& info : structure_infos()) {
    SCOPED_TRACE(info.name);
    Scene scene;
    scene.dimension = std::max(2, info.min_dimension);
    scene.maintain = {{std::string(info.name), std::string(info.name), {}}};
    compare(scene);
    for (const Reading& reading : info.reads) {
      scene.maintain.push_back(
          {std::string(reading.structure), std::string(reading.structure) + " of mine", {}});
    }
    scene.maintain.front().label = "a.b:x";
    compare(scene);
  }
  EXPECT_GT(read, 30u);
}

TEST(Uses, ColumnsStayStraightBesideLongLabels) {
  const Ran ran =
      run(scene_with(
              {R"({"structure": "sorted_list", "as": "a list of objects with a very long name"})",
               "delaunay_2"}),
          {});
  std::istringstream lines(ran.report);
  std::string line;
  std::getline(lines, line);
  std::vector<std::size_t> lengths;
  for (int i = 0; i < 3 && std::getline(lines, line); ++i) lengths.push_back(line.size());
  ASSERT_EQ(lengths.size(), 3u);
  EXPECT_EQ(lengths[0], lengths[1]) << ran.report;
  EXPECT_EQ(lengths[0], lengths[2]) << ran.report;
}

}  // namespace uses_test
}  // namespace kinex
