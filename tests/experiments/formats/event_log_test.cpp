// SPDX-License-Identifier: GPL-3.0-or-later
// Event logs of real runs: written, re-verified, compared, and the summary beside them.
#include "experiments/formats/event_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/log_check.h"
#include "experiments/formats/log_diff.h"
#include "experiments/formats/log_rules.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/formats/summary.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex {
namespace event_log_test {

struct Finished {
  std::string log, summary, digest;
};

Finished run(Scene scene, const std::string& arithmetic,
             InstantDetail instants = InstantDetail::kName) {
  const std::string path =
      (std::filesystem::temp_directory_path() /
       ("kinex-log-" + std::to_string(::getpid()) + "-" + formats::sha256_hex(scene.name + arithmetic)))
          .string();
  SimulatorOptions options;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  formats::OutputFile file(path, true);
  formats::EventLog log(*simulator, formats::scene_hash(scene), &file, instants);
  simulator->set_sink(&log);
  const formats::RunOutcome outcome = lab::run_scene(*simulator, {Rational(Integer(1), Integer(3))});
  log.finish(outcome.status);
  Finished finished;
  finished.log = formats::read_text_file(path);
  finished.digest = log.digest();
  finished.summary = formats::write_summary(*simulator, outcome, formats::scene_hash(scene), log.digest(), {});
  std::filesystem::remove(path);
  EXPECT_TRUE(arithmetic != "exact" || outcome.clean(*simulator));
  return finished;
}

Scene workload(const char* name, int n, std::uint64_t seed = 5) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.seed = seed;
  return lab::generate_scene(*lab::find_workload(name), parameters);
}

TEST(EventLog, ExactLogsVerify) {
  for (const char* name : {"uniform-square", "meet", "rotating-circle", "hull-worst"}) {
    Scene scene = workload(name, 8);
    formats::set_maintain(scene, {"sorted_list", "sorted_list:y", "delaunay_2"});
    const Finished finished = run(scene, "exact");
    const formats::LogVerdict verdict = formats::check_log(finished.log, "log", &scene, formats::scene_hash(scene));
    EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << name;
    EXPECT_GT(verdict.certificates, 0u) << name;
    EXPECT_EQ(verdict.unchecked.count(), 0u) << name;
    EXPECT_EQ(verdict.digest, finished.digest);
    EXPECT_EQ(verdict.status, "done");
    EXPECT_EQ(verdict.header.scene_hash, formats::scene_hash(scene));
    EXPECT_GT(verdict.records, 0u) << name;
  }
}

// Certificates that cannot be checked are counted, each with its reason.
TEST(EventLog, UncheckedCertificatesHaveAReason) {
  const auto unchecked = [](Scene scene, const char* structure, InstantDetail instants) {
    formats::set_maintain(scene, {structure});
    return formats::check_log(run(scene, "exact", instants).log, "log", &scene,
                              formats::scene_hash(scene))
        .unchecked;
  };
  const formats::UncheckedCertificates cones =
      unchecked(workload("uniform-square", 8), "closest_pair_cones", InstantDetail::kName);
  ASSERT_EQ(cones.unsaid.size(), 1u);
  EXPECT_EQ(
      cones.text(),
      "not checked: " + std::to_string(cones.count()) +
          " certificates of order_direction, since the log does not say along which directions or "
          "lines of a grid they compare objects");
  const formats::UncheckedCertificates unnamed =
      unchecked(workload("uniform-square", 8), "sorted_list", InstantDetail::kInterval);
  EXPECT_GT(unnamed.without_instant, 0u);
  EXPECT_EQ(unnamed.text(),
            "not checked: " + std::to_string(unnamed.count()) +
                " certificates, since the log does not name their instants exactly");
  formats::UncheckedCertificates bodies;
  EXPECT_EQ(bodies.text(), "");
  bodies.of_bodies = 1;
  bodies.unsaid = {{"order_x", 1}, {"order_y", 2}};
  EXPECT_EQ(bodies.count(), 4u);
  EXPECT_EQ(bodies.text().find(
                "not checked: 1 certificate of bodies, which are about vertices and edges"),
            0u);
  EXPECT_NE(bodies.text().find("; 3 certificates of order_x, order_y, since"), std::string::npos);
}

bool reads_cones(const StructureInfo& info) {
  for (const char* name : {"closest_pair_bins", "closest_pair_range_tree", "bichromatic_pair_maximum_norm",
                           "octants_listed", "octants_local", "cones_local"}) {
    if (info.name == name) return true;
  }
  return std::any_of(info.reads.begin(), info.reads.end(), [](const Reading& reading) {
    return reading.structure.starts_with("octants") || reading.structure == "cones_local";
  });
}

// At degenerate instants, too: certificates that are made negative, since what the structure reads has
// changed or much has been repaired at once, need not be zero there.
TEST(EventLog, DegenerateLogsOfEveryStructureVerify) {
  std::uint64_t certificates = 0;
  for (const StructureInfo& info : structure_infos()) {
    if (info.bodies || info.graph) continue;
    for (const char* name : {"grid", "lattice", "meet"}) {
      for (const std::uint64_t seed : {28u, 29u}) {
        lab::WorkloadParameters parameters;
        parameters.n = 8;
        parameters.seed = seed;
        parameters.dimension = std::max(2, info.min_dimension);
        Scene scene = lab::generate_scene(*lab::find_workload(name), parameters);
        lab::give_extents(scene, info.usual_extents());
        lab::make_lines(scene, info.lines);
        formats::set_maintain(scene, {std::string(info.name)});
        const formats::LogVerdict verdict = formats::check_log(
            run(scene, "exact").log, "log", &scene, formats::scene_hash(scene));
        EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << info.name << " " << scene.name;
        certificates += verdict.certificates;
        // Those along the directions of octants and polygons, and of lines of a grid, are left to kinex-logcheck.
        if (!reads_cones(info)) {
          EXPECT_EQ(verdict.unchecked.count(), 0u) << info.name << " " << scene.name;
        }
      }
    }
  }
  EXPECT_GT(certificates, 2000u);
}

// The records of a log would all be wrong for another scene: its hash and header say why, and that is enough.
TEST(EventLog, OfAnotherScene) {
  Scene scene = workload("uniform-square", 5, 1), other = workload("uniform-square", 5, 2);
  for (Scene* one : {&scene, &other}) formats::set_maintain(*one, {"closest_pair_all"});
  other.name = scene.name;
  const std::string log = run(scene, "exact").log;
  const auto problems = [&log](const Scene& of) {
    return formats::check_log(log, "log", &of, formats::scene_hash(of)).problems;
  };
  EXPECT_EQ(problems(scene), std::vector<std::string>{});
  ASSERT_EQ(problems(other).size(), 1u);
  EXPECT_NE(problems(other)[0].find("give the scene that was run"), std::string::npos);
}

// Two lengths that are level for ever are compared after a turn. If edges of both are exchanged at one instant, the
// second certificate is negative without having been zero.
TEST(EventLog, LevelLengthsThatAreExchangedAtOneInstant) {
  for (const auto& [n, seed] : {std::pair(6, 20), {8, 13}, {10, 6}}) {
    for (const char* name :
         {"mst_maximum_norm_list", "mst_maximum_norm_cycles", "mst_maximum_norm_clusters"}) {
      Scene scene = workload("grid", n, static_cast<std::uint64_t>(seed));
      formats::set_maintain(scene, {name});
      const formats::LogVerdict verdict =
          formats::check_log(run(scene, "exact").log, "log", &scene, formats::scene_hash(scene));
      EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << name << " " << scene.name;
    }
  }
}

// Points that meet in pairs turn triangles over. A certificate on line 18, made at that instant, is negative without
// having been zero; the log says only later that the instant is degenerate, by "blocked" and "rebuild".
TEST(EventLog, CertificatesMadeAtADegenerateInstant) {
  Scene scene = workload("meet", 8, 23);
  formats::set_maintain(scene, {"delaunay_2"});
  const std::string log = run(scene, "exact").log;
  const auto problems = [&scene](const std::string& text) {
    return formats::check_log(text, "log", &scene, formats::scene_hash(scene)).problems;
  };
  EXPECT_EQ(problems(log), std::vector<std::string>{});
  std::string regular;
  for (std::size_t at = 0; at < log.size();) {
    const std::string line = log.substr(at, log.find('\n', at) + 1 - at);
    at += line.size();
    const auto is = [&line](const char* kind) {
      return line.find(std::string("\"kind\": \"") + kind) != std::string::npos;
    };
    if (!is("blocked") && !is("reinsert") && !is("rebuild")) regular += line;
  }
  const std::vector<std::string> found = problems(regular);
  EXPECT_EQ(std::count(found.begin(), found.end(), "line 18: its certificate does not vanish at that time"), 1);
}

// Lengths that are identically equal are in the order after a turn. One that takes the place of another one at a
// degenerate instant is decided anew, so that no certificate is negative without having been zero.
TEST(EventLog, CertificatesOfEqualLengthsVanish) {
  for (const std::uint64_t seed : {15u, 21u}) {
    Scene scene = workload("grid", 10, seed);
    formats::set_maintain(scene, {"bichromatic_pair_maximum_norm"});
    const formats::LogVerdict verdict = formats::check_log(run(scene, "exact").log, "log", &scene,
                                                           formats::scene_hash(scene));
    EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << scene.name;
  }
}

TEST(EventLog, SturmWritesTheSameEvents) {
  for (const char* name : {"uniform-square", "lattice"}) {
    const Scene scene = workload(name, 10);
    const Finished exact = run(scene, "exact");
    const Finished sturm = run(scene, "sturm");
    const formats::LogDifference difference = formats::diff_logs(exact.log, "exact", sturm.log, "sturm");
    EXPECT_TRUE(difference.equal()) << name << " " << difference.row_a << "\n"
                                    << difference.row_b;
    EXPECT_EQ(exact.digest, sturm.digest);
  }
}

// The digest is the same whatever the log says of its instants, and where there is no log.
TEST(EventLog, OneDigestForEveryDetail) {
  for (const char* name : {"uniform-square", "lattice", "polygon-fan"}) {
    const Scene scene = workload(name, 8);
    const Finished names = run(scene, "exact");
    const auto simulator = lab::make_simulator(scene, "exact", {});
    formats::EventLog without(*simulator, "", nullptr);
    simulator->set_sink(&without);
    lab::run_scene(*simulator, {Rational(Integer(1), Integer(3))});
    EXPECT_EQ(without.digest(), names.digest) << name;
    for (const InstantDetail detail : {InstantDetail::kInterval, InstantDetail::kNone}) {
      const Finished other = run(scene, "exact", detail);
      EXPECT_EQ(other.digest, names.digest) << name;
      EXPECT_LT(other.log.size(), names.log.size());
      const formats::LogVerdict verdict = formats::check_log(other.log, "log");
      EXPECT_EQ(verdict.problems, std::vector<std::string>{}) << name;
      const formats::LogDifference difference = formats::diff_logs(names.log, "names", other.log, "other");
      EXPECT_TRUE(difference.equal()) << name << difference.row_a << difference.row_b;
      EXPECT_EQ(difference.instants, detail == InstantDetail::kInterval
                                         ? formats::InstantsCompared::kIntervals
                                         : formats::InstantsCompared::kNot);
    }
  }
}

// What the log's rules say of a structure is what the structure says.
TEST(LogRules, KindsAreThoseOfTheStructures) {
  for (const StructureInfo& info : structure_infos()) {
    ASSERT_NE(formats::own_kinds(info.name), nullptr) << info.name;
    Scene scene = workload(
        info.bodies ? "polygon-line" : info.graph ? "random-graph" : "uniform-square", 6);
    if (info.min_dimension == 3) {
      lab::WorkloadParameters parameters;
      parameters.n = 6;
      parameters.dimension = 3;
      scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
    }
    lab::give_extents(scene, info.usual_extents());
    lab::make_lines(scene, info.lines);
    formats::set_maintain(scene, {std::string(info.name)});
    const auto simulator = lab::make_simulator(scene, "exact", {});
    const StructureId id = asked_structure(scene);
    std::vector<std::string_view> kinds;
    for (const KindRule& rule : *formats::own_kinds(info.name)) kinds.push_back(rule.kind);
    EXPECT_EQ(simulator->event_kinds(id), common_event_kinds(std::move(kinds))) << info.name;
    if (!info.bodies) simulator->start();
    EXPECT_EQ(simulator->structure(id).attribute().shape, info.shape) << info.name;
    const Arithmetic& arithmetic = simulator->arithmetic();
    for (PredicateId p = 0; p < arithmetic.predicates(); ++p) {
      const Predicate& predicate = arithmetic.predicate(p);
      EXPECT_EQ(formats::arity_of(predicate.name()), static_cast<std::size_t>(predicate.arity()))
          << predicate.name();
    }
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
    EXPECT_FALSE(formats::check_log(joined(swapped), "log").problems.empty()) << i;
    EXPECT_FALSE(formats::diff_logs(log, "a", joined(swapped), "b").equal()) << i;
    EXPECT_EQ(formats::diff_logs(log, "a", joined(swapped), "b").out_of_order, 1u) << i;
    std::vector<std::string> shorter = lines;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(formats::check_log(joined(shorter), "log").problems.empty()) << i;
    const formats::LogDifference difference = formats::diff_logs(log, "a", joined(shorter), "b");
    EXPECT_EQ(difference.first, i);
    EXPECT_EQ(difference.missing, 1u);
    EXPECT_EQ(difference.invented, 0u);
    EXPECT_EQ(difference.out_of_order, 0u);
    EXPECT_EQ(formats::diff_logs(joined(shorter), "a", log, "b").invented, 1u);
  }
}

TEST(Summary, HasTheAgreedKeys) {
  const Scene scene = workload("uniform-square", 8);
  const Finished finished = run(scene, "exact");
  const formats::JsonDocument summary_document = formats::parse_json(finished.summary, "summary");
  const formats::JsonValue& summary = *summary_document;
  for (const char* key : {"scene", "scene_hash", "arithmetic", "time", "objects", "log_digest",
                          "structures", "samples", "seconds", "peak_bytes", "provenance"}) {
    EXPECT_NE(summary.find(key), nullptr) << key;
  }
  EXPECT_EQ(summary.find("arithmetic")->text(), "exact");
  EXPECT_EQ(summary.find("log_digest")->text(), finished.digest);
  EXPECT_EQ(summary.find("time")->find("end")->text(), "1");
  EXPECT_EQ(summary.find("objects")->text(), "8");
  const formats::JsonValue* delaunay = summary.find("structures")->find("delaunay_2");
  ASSERT_NE(delaunay, nullptr);
  for (const char* key : {"processed", "external", "internal", "rebuilds", "simultaneous_groups",
                          "certificates", "audit", "bounds", "attribute"}) {
    EXPECT_NE(delaunay->find(key), nullptr) << key;
  }
  for (const char* key : {"created", "max_live", "max_per_object"}) {
    EXPECT_NE(delaunay->find("certificates")->find(key), nullptr) << key;
  }
  EXPECT_NE(delaunay->find("audit")->find("violations"), nullptr);
  EXPECT_EQ(delaunay->find("bounds")->items()[0].find("holds")->boolean(), true);
  EXPECT_EQ(delaunay->find("attribute")->items()[0].items().size(), 2u);
  const formats::JsonValue& sample = summary.find("samples")->items()[0];
  EXPECT_EQ(sample.find("t")->text(), "1/3");
  EXPECT_NE(sample.find("delaunay_2"), nullptr);
}

}  // namespace event_log_test
}  // namespace kinex
