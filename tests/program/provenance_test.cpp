// SPDX-License-Identifier: GPL-3.0-or-later
// What made a result: always in summaries, in logs on request only, and in no digest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "experiments/formats/event_log.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/log_reader.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace provenance_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

class ProvenanceOfResults : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "8", "-o", scene_}).exit_code, 0);
  }
  // The log of a run with these further arguments.
  std::string log(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", scene_, "--events", scratch_.file(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_kinex(arguments).exit_code, 0);
    return read_file(scratch_.file(name));
  }

  ScratchFolder scratch_;
  std::string scene_ = scratch_.file("a scene.json");
};

std::string digest_of(const std::string& log) {
  formats::LogReader reader(log, "log");
  formats::LogRecord record;
  while (reader.next(record)) {
  }
  return reader.end() ? reader.end()->digest : "";
}

// The line of --version that begins with this word, without it.
std::string version_line(const std::string& word) {
  std::istringstream lines(run_kinex({"--version"}).out);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(word + " ", 0) == 0)
      return line.substr(line.find_first_not_of(' ', word.size()));
  }
  return "";
}

// "34be52d..", or "34be52d.. with changes that are not committed".
std::string commit() { return version_line("commit").substr(0, version_line("commit").find(' ')); }
bool dirty() { return version_line("commit") != commit(); }

TEST_F(ProvenanceOfResults, VersionTellsTheBuildAndTheProcessor) {
  const Finished version = run_kinex({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, StartsWith(formats::build_name() + "\n"));
  EXPECT_THAT(version_line("commit"),
              MatchesRegex("([0-9a-f]+|unknown)( with changes that are not committed)?"));
  EXPECT_THAT(version_line("compiler"), Not(IsEmpty()));
  EXPECT_THAT(version_line("flags"), HasSubstr("-ffp-contract=off"));
  EXPECT_THAT(version_line("libraries"), StartsWith("GMP "));
  EXPECT_THAT(version_line("processor"), MatchesRegex(".+, [0-9]+ cores?, [0-9]+ GB"));
}

TEST_F(ProvenanceOfResults, LogsHaveItOnRequestOnly) {
  const std::string plain = log("plain.jsonl"), again = log("again.jsonl");
  EXPECT_EQ(plain, again);  // in another command: the same bytes
  EXPECT_THAT(plain, Not(HasSubstr("provenance")));
  EXPECT_THAT(plain, Not(HasSubstr(commit())));
  const std::string made = log("made.jsonl", {"--provenance"});
  formats::LogReader reader(made, "made");
  ASSERT_TRUE(reader.header().provenance);
  const formats::Provenance& provenance = *reader.header().provenance;
  EXPECT_EQ(provenance.commit, commit());
  EXPECT_EQ(provenance.dirty, dirty());
  EXPECT_EQ(provenance.compiler, version_line("compiler"));
  EXPECT_EQ(provenance.flags, version_line("flags"));
  EXPECT_THAT(version_line("processor"), StartsWith(provenance.cpu + ", "));
  EXPECT_EQ(provenance.command,
            "kinex run '" + scene_ + "' --events " + scratch_.file("made.jsonl") + " --provenance");
  // Its events are the same: digest and records; the whole is sealed.
  EXPECT_EQ(digest_of(made), digest_of(plain));
  EXPECT_EQ(made.substr(made.find('\n'), 200), plain.substr(plain.find('\n'), 200));
  EXPECT_EQ(run_kinex({"check", scratch_.file("made.jsonl"), "--scene", scene_}).exit_code, 0);
  EXPECT_EQ(
      run_kinex({"diff", scratch_.file("made.jsonl"), scratch_.file("plain.jsonl")}).exit_code, 0);
  std::string forged = made;
  forged.replace(forged.find("\"cpu\": \"") + 8, 1, "?");
  write_file(scratch_.file("forged.jsonl"), forged);
  EXPECT_EQ(run_kinex({"check", scratch_.file("forged.jsonl")}).exit_code, 1);
}

TEST_F(ProvenanceOfResults, LogsWithPartOfItAreRefused) {
  const std::string made = log("made.jsonl", {"--provenance"});
  for (const char* member : {"\"dirty\": ", "\"command\": "}) {
    std::string bad = made;
    bad.replace(bad.find(member) + 1, 1, "x");
    write_file(scratch_.file("bad.jsonl"), bad);
    const Finished refused = run_kinex({"check", scratch_.file("bad.jsonl")});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("/provenance"));
  }
}

TEST_F(ProvenanceOfResults, SummariesAlwaysHaveIt) {
  const Finished run = run_kinex({"run", scene_, "--json"});
  ASSERT_EQ(run.exit_code, 0);
  const formats::JsonDocument summary = formats::parse_json(run.out, "summary");
  const formats::JsonValue* made = summary->find("provenance");
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->find("command")->text(), "kinex run '" + scene_ + "' --json");
  EXPECT_EQ(made->find("commit")->text(), commit());
}

TEST_F(ProvenanceOfResults, PagesHaveTheCommit) {
  const Finished page = run_kinex({"view", scene_, "-o", "-"});
  ASSERT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, HasSubstr(formats::build_name() + " at " + version_line("commit")));
}

}  // namespace provenance_test
}  // namespace kinex
