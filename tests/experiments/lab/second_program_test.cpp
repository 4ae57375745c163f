// SPDX-License-Identifier: GPL-3.0-or-later
// The second program of `kinex reproduce`: what it finds fine, refuses or does not check, and what
// becomes of the claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "experiments/formats/file_io.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/second_program.h"
#include "experiments/lab/temporary_folder.h"
#include "experiments/reproduce/runner.h"
#include "tests/places.h"

namespace kinex {
namespace second_program_test {

namespace fs = std::filesystem;
using Finding = lab::CheckedBy::Finding;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const auto kGoOn = [] { return true; };

// Beside the built program.
std::string real_program() { return fs::path(KINEX_PROGRAM).parent_path() / "kinex-logcheck"; }

lab::RunKey run_of(const std::string& structure, const std::string& workload) {
  lab::RunKey key;
  key.structure = structure;
  key.workload = workload;
  return lab::small_run(key);
}

class ASecondProgram : public ::testing::Test {
 protected:
  // A program that is a shell script.
  std::string stub(const std::string& text) {
    const std::string path = folder_.path() / ("stub-" + std::to_string(++stubs_));
    std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  lab::CheckedBy check(const std::string& program) {
    return lab::SecondProgram(program, kGoOn, nullptr).check(run_of("sorted_list", "uniform-square"));
  }
  std::string file(const std::string& name) { return folder_.path() / name; }

 private:
  lab::TemporaryFolder folder_;
  int stubs_ = 0;
};

TEST_F(ASecondProgram, ChecksEveryLevelOfPoints) {
  for (const char* structure :
       {"sorted_list", "maximum_tournament", "convex_hull_2", "convex_hull_2_brute_force",
        "convex_hull_2_delaunay", "delaunay_2"}) {
    lab::RunKey run = run_of(structure, "uniform-square");
    const lab::CheckedBy checked = lab::SecondProgram(real_program(), kGoOn, nullptr).check(run);
    EXPECT_EQ(checked.finding, Finding::kFine) << checked.text();
    EXPECT_THAT(checked.levels, ElementsAre(0, 1, 2, 3, 4, 5)) << checked.text();
    EXPECT_EQ(checked.left_out, "");
  }
}

TEST_F(ASecondProgram, SaysWhatOfBodiesIsNotReplayed) {
  const lab::CheckedBy checked = lab::SecondProgram(real_program(), kGoOn, nullptr)
                                .check(run_of("separation_mixed", "polygon-orbit"));
  EXPECT_EQ(checked.finding, Finding::kFine) << checked.text();
  EXPECT_THAT(checked.levels, ElementsAre(0, 1, 5));
  EXPECT_EQ(checked.left_out,
            "levels 2, 3, 4: not for rigid bodies; not followed: internal events");
}

TEST_F(ASecondProgram, MayRefuseTheLog) {
  const lab::CheckedBy plain = check(stub("echo 'log.jsonl:3: it is wrong' >&2\nexit 1"));
  EXPECT_EQ(plain.finding, Finding::kRefused);
  EXPECT_THAT(plain.verdict(), HasSubstr("refused: log.jsonl:3: it is wrong"));
  const lab::CheckedBy report = check(
      stub("echo '{\"message\": \"a swap is missing\", \"line\": 7, \"levels\": []}'\nexit 1"));
  EXPECT_EQ(report.finding, Finding::kRefused);
  EXPECT_EQ(report.verdict(), "refused: line 7: a swap is missing");
}

// A log that the real one is given with one thing changed.
TEST_F(ASecondProgram, RefusesAWrongLog) {
  const std::string spoiling = stub("sed -i '2s/\"external\": true/\"external\": false/' \"$1\"\n" +
                                    ("exec " + real_program()) + " \"$@\"");
  const lab::CheckedBy checked = check(spoiling);
  EXPECT_EQ(checked.finding, Finding::kRefused) << checked.text();
}

TEST_F(ASecondProgram, MayNotBeThere) {
  EXPECT_EQ(check(file("none")).verdict(), "not checked: " + file("none") + " was not found");
  const std::string text = stub("exit 0");
  fs::permissions(text, fs::perms::owner_read);
  EXPECT_EQ(check(text).verdict(), "not checked: " + text + " is not executable");
  ::setenv("PYTHON", "no-such-python", 1);
  const lab::CheckedBy checked = check(real_program());
  ::unsetenv("PYTHON");
  EXPECT_EQ(checked.verdict(), "not checked: python3 was not found");
  EXPECT_EQ(check(stub("kill -9 $$")).verdict().substr(0, 12), "not checked:");
  EXPECT_EQ(check(stub("exit 3")).finding, Finding::kNotChecked);
  EXPECT_EQ(check(stub("exit 0")).finding, Finding::kNotChecked);  // nothing is said to be done
}

// A folder that python3 runs, as that of the sources.
TEST_F(ASecondProgram, MayBeAFolderOfPython) {
  const std::string folder = file("checker");
  fs::create_directory(folder);
  EXPECT_FALSE(lab::SecondProgram(folder, kGoOn, nullptr).exists());
  EXPECT_EQ(check(folder).verdict(), "not checked: " + folder + " was not found");
  std::ofstream(folder + "/__main__.py") << "import sys\nsys.exit(' '.join(sys.argv[2:3]))\n";
  EXPECT_TRUE(lab::SecondProgram(folder, kGoOn, nullptr).exists());
  EXPECT_EQ(check(folder).verdict(), "refused: --scene");
  ::setenv("PYTHON", "no-such-python", 1);
  EXPECT_EQ(check(folder).verdict(), "not checked: python3 was not found");
  ::unsetenv("PYTHON");
  const lab::CheckedBy real = check(KINEX_SOURCE_DIR "/experiments/logcheck");
  EXPECT_EQ(real.finding, Finding::kFine) << real.text();
}

TEST_F(ASecondProgram, IsStoppedAtOnce) {
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  const lab::SecondProgram slow(
      stub("sleep 100"), [&] { return seconds() < 0.2; }, nullptr);
  EXPECT_EQ(slow.check(run_of("sorted_list", "uniform-square")).verdict(),
            "not checked: interrupted");
  EXPECT_LT(seconds(), 1);
}

lab::PaperClaim claim_of(const std::string& structure) {
  lab::PaperClaim claim;
  claim.id = structure;
  claim.observed = "so much";
  claim.verdict = lab::Verdict::kConfirmed;
  if (structure.empty()) {
    claim.no_small_run = "nothing moves";
  } else {
    claim.small_run = run_of(structure, "uniform-square");
  }
  return claim;
}

TEST_F(ASecondProgram, ConfirmsNoClaimWhoseLogItRefuses) {
  std::vector<lab::PaperClaim> claims{claim_of("sorted_list"), claim_of("sorted_list"), claim_of(""),
                                      claim_of("maximum_tournament")};
  claims[3].verdict = lab::Verdict::kRefuted;
  int runs = 0;
  const lab::SecondProgram program(stub("exit 1"), kGoOn, nullptr);
  const auto check = [&](const lab::RunKey& run) {
    ++runs;
    return program.check(run);
  };
  EXPECT_THAT(lab::check_claims(claims, program.name(), check), SizeIs(2));
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(claims[0].verdict, lab::Verdict::kOpen);
  EXPECT_EQ(claims[1].verdict, lab::Verdict::kOpen);
  EXPECT_THAT(claims[1].checked_by.verdict(), HasSubstr("refused"));
  EXPECT_THAT(claims[1].observed, HasSubstr("refuses"));
  EXPECT_EQ(claims[2].verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(claims[2].checked_by.verdict(), "not checked: nothing moves");
  EXPECT_EQ(claims[3].verdict, lab::Verdict::kRefuted);
}

// A part of one point, over a journal.
struct OnePart {
  lab::PaperPart part{"one", "one run", 1,
                      [](bool) {
                        lab::SeriesPoint point;
                        point.key.structure = "sorted_list";
                        point.key.workload = "uniform-square";
                        point.key.parameters.n = 10;
                        point.min_seeds = point.max_seeds = 3;
                        return std::vector{point};
                      },
                      [](const std::vector<lab::SeriesResult>&, const std::string&) {
                        lab::PartReport report;
                        report.claims = {claim_of("sorted_list")};
                        return report;
                      }};
  int runs = 0, checks = 0;

  reproduce::ReproducedPart run(const std::string& path, const lab::SecondProgram& program) {
    sweep::Journal journal(path, sweep::provenance_of({"plan", "{}", std::string(64, '0')}, "test", "0/1"), sweep::Leftover::kKeep);
    reproduce::RunnerOptions options;
    options.source.journal = &journal;
    options.on_start = [this](std::size_t, const lab::SeriesPoint&) { ++runs; };
    options.on_check = [this](const lab::RunKey&) { ++checks; };
    return reproduce::run_part(part, program, options);
  }
};

TEST_F(ASecondProgram, ChecksNothingTwice) {
  const std::string fine =
      stub("echo '{\"levels\": [{\"level\": 0, \"done\": true, \"detail\": \"all\"}]}'");
  OnePart one;
  const lab::SecondProgram program(fine, kGoOn, nullptr);
  std::string first;
  for (int i = 0; i < 2; ++i) {
    const reproduce::ReproducedPart done = one.run(file("journal"), program);
    EXPECT_THAT(done.troubles, IsEmpty());
    EXPECT_EQ(done.report.claims[0].verdict, lab::Verdict::kConfirmed);
    if (i == 0) first = done.report.claims[0].checked_by.text();
    EXPECT_EQ(done.report.claims[0].checked_by.text(), first);
  }
  EXPECT_EQ(one.runs, 1);
  EXPECT_EQ(one.checks, 1);
  one.run(file("journal"), lab::SecondProgram(stub("exec " + fine + " \"$@\""), kGoOn, nullptr));
  EXPECT_EQ(one.runs, 1);
  EXPECT_EQ(one.checks, 2);  // by another program
}

TEST_F(ASecondProgram, IsAskedAgainAfterARefusal) {
  OnePart one;
  const lab::SecondProgram program(stub("exit 1"), kGoOn, nullptr);
  for (int i = 1; i <= 2; ++i) {
    EXPECT_THAT(one.run(file("journal"), program).troubles, SizeIs(1));
    EXPECT_EQ(one.checks, i);
  }
}

TEST(CheckedByJson, HasWhatWasRunAndSaid) {
  lab::CheckedBy checked;
  checked.program = "kinex-logcheck";
  checked.run = run_of("delaunay_2", "uniform-square");
  checked.levels = {0, 1, 5};
  checked.left_out = "levels 2-4";
  checked.finding = Finding::kFine;
  std::string text;
  formats::JsonWriter json(text);
  lab::write_checked_by(json, checked);
  const formats::JsonDocument document = formats::parse_json(text, "json");
  const formats::JsonValue& value = *document;
  EXPECT_EQ(value.find("program")->text(), "kinex-logcheck");
  EXPECT_THAT(value.find("levels")->items(), SizeIs(3));
  EXPECT_EQ(value.find("structure")->text(), "delaunay_2");
  EXPECT_EQ(value.find("workload")->text(), "uniform-square");
  EXPECT_EQ(value.find("n")->text(), std::to_string(checked.run.parameters.n));
  EXPECT_EQ(value.find("seed")->text(), "2");
  EXPECT_EQ(value.find("verdict")->text(), "nothing wrong");
  const lab::CheckedBy again = lab::check_of(lab::check_fields(checked)).value();
  EXPECT_EQ(again.program, checked.program);
  EXPECT_EQ(again.levels, checked.levels);
  EXPECT_EQ(again.left_out, checked.left_out);
  EXPECT_EQ(again.finding, checked.finding);
}

}  // namespace second_program_test
}  // namespace kinex
