// SPDX-License-Identifier: GPL-3.0-or-later
// Event logs of real runs: written, re-verified, compared, and the summary beside them.
#include "experiments/event_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "experiments/json_value.h"
#include "experiments/log_check.h"
#include "experiments/log_diff.h"
#include "experiments/scene_reader.h"
#include "experiments/scene_run.h"
#include "experiments/scene_writer.h"
#include "experiments/sha256.h"
#include "experiments/summary.h"
#include "experiments/workload.h"

namespace kinex {
namespace {

struct Finished {
  std::string log, summary, digest;
};

Finished run(Scene scene, const std::string& arithmetic) {
  const std::string path =
      (std::filesystem::temp_directory_path() /
       ("kinex-log-" + std::to_string(::getpid()) + "-" + sha256_hex(scene.name + arithmetic)))
          .string();
  SimulatorOptions options;
  const auto simulator = make_simulator(scene, arithmetic, options);
  OutputFile file(path, true);
  EventLog log(*simulator, scene_hash(scene), &file);
  simulator->set_sink(&log);
  const RunOutcome outcome = run_scene(*simulator, {Rational(Integer(1), Integer(3))});
  log.finish(outcome.status);
  Finished finished;
  finished.log = read_text_file(path);
  finished.digest = log.digest();
  finished.summary = write_summary(*simulator, outcome, scene_hash(scene), log.digest());
  std::filesystem::remove(path);
  EXPECT_TRUE(arithmetic != "exact" || outcome.clean(*simulator));
  return finished;
}

Scene workload(const char* name, int n, std::uint64_t seed = 5) {
  WorkloadParameters parameters;
  parameters.n = n;
  parameters.seed = seed;
  return generate_scene(*find_workload(name), parameters);
}

TEST(EventLog, ExactLogsVerify) {
  for (const char* name : {"uniform-square", "meet", "rotating-circle", "hull-worst"}) {
    Scene scene = workload(name, 8);
    set_maintain(scene, {"sorted_list", "sorted_list:y", "delaunay_2"});
    const Finished finished = run(scene, "exact");
    const LogVerdict verdict = check_log(finished.log, "log");
    EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << name;
    EXPECT_EQ(verdict.digest, finished.digest);
    EXPECT_EQ(verdict.status, "done");
    EXPECT_EQ(verdict.header.scene_hash, scene_hash(scene));
    EXPECT_GT(verdict.events, 0u) << name;
  }
}

TEST(EventLog, SturmWritesTheSameEvents) {
  for (const char* name : {"uniform-square", "lattice"}) {
    const Scene scene = workload(name, 10);
    const Finished exact = run(scene, "exact");
    const Finished sturm = run(scene, "sturm");
    const LogDifference difference = diff_logs(exact.log, "exact", sturm.log, "sturm");
    EXPECT_TRUE(difference.equal()) << name << " " << difference.text_a << "\n"
                                    << difference.text_b;
    EXPECT_EQ(exact.digest, sturm.digest);
  }
}

TEST(EventLog, RunsAreDeterministic) {
  const Scene scene = workload("uniform-square", 12);
  EXPECT_EQ(run(scene, "exact").log, run(scene, "exact").log);
}

// A change of any one line is noticed.
TEST(EventLog, ChangesAreNoticed) {
  const std::string log = run(workload("uniform-square", 8), "exact").log;
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < log.size();) {
    const std::size_t end = log.find('\n', at);
    lines.push_back(log.substr(at, end - at));
    at = end + 1;
  }
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += part + "\n";
    return text;
  };
  ASSERT_GT(lines.size(), 6u);
  for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
    std::vector<std::string> swapped = lines;
    std::swap(swapped[i], swapped[i + 1]);
    EXPECT_FALSE(check_log(joined(swapped), "log").problems.empty()) << i;
    EXPECT_FALSE(diff_logs(log, "a", joined(swapped), "b").equal()) << i;
    EXPECT_EQ(diff_logs(log, "a", joined(swapped), "b").out_of_order, 1u) << i;
    std::vector<std::string> shorter = lines;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(check_log(joined(shorter), "log").problems.empty()) << i;
    const LogDifference difference = diff_logs(log, "a", joined(shorter), "b");
    EXPECT_EQ(difference.first, i);
    EXPECT_EQ(difference.missing, 1u);
    EXPECT_EQ(difference.invented, 0u);
    EXPECT_EQ(difference.out_of_order, 0u);
    EXPECT_EQ(diff_logs(joined(shorter), "a", log, "b").invented, 1u);
  }
}

TEST(Summary, HasTheAgreedKeys) {
  const Scene scene = workload("uniform-square", 8);
  const Finished finished = run(scene, "exact");
  const JsonValue summary = parse_json(finished.summary, "summary");
  for (const char* key : {"scene", "scene_hash", "arithmetic", "time", "objects", "log_digest",
                          "structures", "samples", "seconds", "peak_bytes"}) {
    EXPECT_NE(summary.find(key), nullptr) << key;
  }
  EXPECT_EQ(summary.find("arithmetic")->text, "exact");
  EXPECT_EQ(summary.find("log_digest")->text, finished.digest);
  EXPECT_EQ(summary.find("time")->find("end")->text, "1");
  EXPECT_EQ(summary.find("objects")->text, "8");
  const JsonValue* delaunay = summary.find("structures")->find("delaunay_2");
  ASSERT_NE(delaunay, nullptr);
  for (const char* key : {"processed", "external", "internal", "rebuilds", "simultaneous_groups",
                          "certificates", "audit", "bounds", "attribute"}) {
    EXPECT_NE(delaunay->find(key), nullptr) << key;
  }
  for (const char* key : {"created", "max_live", "max_per_object"}) {
    EXPECT_NE(delaunay->find("certificates")->find(key), nullptr) << key;
  }
  EXPECT_NE(delaunay->find("audit")->find("violations"), nullptr);
  EXPECT_EQ(delaunay->find("bounds")->items[0].find("holds")->boolean, true);
  EXPECT_EQ(delaunay->find("attribute")->items[0].items.size(), 2u);
  const JsonValue& sample = summary.find("samples")->items.at(0);
  EXPECT_EQ(sample.find("t")->text, "1/3");
  EXPECT_NE(sample.find("delaunay_2"), nullptr);
}

TEST(LogDiff, CountsByHand) {
  const auto log = [](std::vector<std::string> swaps) {
    std::string text =
        R"({"format": "kinex-log", "version": 1, "scene": "s", "scene_hash": "", "arithmetic": "double",)"
        R"( "exact": false, "build": "", "structures": []})"
        "\n";
    for (std::size_t i = 0; i < swaps.size(); ++i) {
      text += "{\"seq\": " + std::to_string(i + 1) +
              R"(, "structure": "l", "kind": "swap", "ids": [")" + swaps[i] +
              R"("], "certificate": null, "external": true, "time": {"decimal": "0"}})"
              "\n";
    }
    return text;
  };
  const LogDifference difference =
      diff_logs(log({"a", "b", "c", "d", "a"}), "a", log({"a", "c", "b", "x", "a", "a"}), "b");
  EXPECT_EQ(difference.first, 2u);
  EXPECT_EQ(difference.line_a, 3u);
  EXPECT_EQ(difference.missing, 1u);       // d
  EXPECT_EQ(difference.invented, 2u);      // x, the third a
  EXPECT_EQ(difference.out_of_order, 1u);  // b or c
}

// The same events at other times: a difference between exact logs, where an instant has one name.
TEST(LogDiff, InstantsCountInExactLogs) {
  const auto log = [](const char* exact, const char* time) {
    return std::string(R"({"format": "kinex-log", "version": 1, "scene": "s", "scene_hash": "", )"
                       R"("arithmetic": "a", "exact": )") +
           exact + R"(, "build": "", "structures": []})" +
           "\n"
           R"({"seq": 1, "structure": "l", "kind": "swap", "ids": ["a"], "certificate": null, )"
           R"("external": true, "time": )" +
           time + "}\n";
  };
  const std::string one =
      R"({"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "2"], "decimal": ""})";
  const std::string narrow =
      R"({"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "3/2"], "decimal": ""})";
  const std::string other =
      R"({"polynomial": ["-2", "0", "1"], "root": 1, "interval": ["-2", "-1"], "decimal": ""})";
  EXPECT_TRUE(diff_logs(log("true", one.c_str()), "a", log("true", narrow.c_str()), "b").equal());
  const LogDifference difference =
      diff_logs(log("true", one.c_str()), "a", log("true", other.c_str()), "b");
  EXPECT_EQ(difference.first, 1u);
  EXPECT_EQ(difference.other_instants, 1u);
  EXPECT_EQ(difference.missing + difference.invented + difference.out_of_order, 0u);
  const char* inexact = R"({"decimal": "1"})";
  EXPECT_TRUE(diff_logs(log("true", one.c_str()), "a", log("false", inexact), "b").equal());
}

}  // namespace
}  // namespace kinex
