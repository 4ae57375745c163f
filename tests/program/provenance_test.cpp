// SPDX-License-Identifier: GPL-3.0-or-later
// What made a result: always in summaries, in logs on request only, and in no digest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/formats/event_log.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/log_reader.h"
#include "experiments/lab/machine.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace {

using testing::HasSubstr;
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

TEST_F(ProvenanceOfResults, VersionTellsTheBuildAndTheProcessor) {
  const Finished version = run_kinex({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, StartsWith(formats::build_name() + "\n"));
  const lab::BuildFacts build = lab::build_facts();
  EXPECT_THAT(version.out, HasSubstr("\ncommit     " + lab::commit_text(build) + "\n"));
  EXPECT_THAT(version.out, HasSubstr("\ncompiler   " + build.compiler + "\n"));
  EXPECT_THAT(version.out, HasSubstr("\nflags      " + build.flags + "\n"));
  EXPECT_THAT(version.out, HasSubstr("\nprocessor  " + lab::machine_facts().cpu));
}

TEST_F(ProvenanceOfResults, LogsHaveItOnRequestOnly) {
  const std::string plain = log("plain.jsonl"), again = log("again.jsonl");
  EXPECT_EQ(plain, again);  // in another command: the same bytes
  EXPECT_THAT(plain, Not(HasSubstr("provenance")));
  EXPECT_THAT(plain, Not(HasSubstr(lab::build_facts().commit)));
  const std::string made = log("made.jsonl", {"--provenance"});
  formats::LogReader reader(made, "made");
  ASSERT_TRUE(reader.header().provenance);
  const formats::Provenance& provenance = *reader.header().provenance;
  EXPECT_EQ(provenance.commit, lab::build_facts().commit);
  EXPECT_EQ(provenance.dirty, lab::build_facts().dirty);
  EXPECT_EQ(provenance.flags, lab::build_facts().flags);
  EXPECT_EQ(provenance.cpu, lab::machine_facts().cpu);
  EXPECT_EQ(provenance.command, "kinex run '" + scene_ + "' --events " + scratch_.file("made.jsonl") + " --provenance");
  // Its events are the same: digest and records; the whole is sealed.
  EXPECT_EQ(digest_of(made), digest_of(plain));
  EXPECT_EQ(made.substr(made.find('\n'), 200), plain.substr(plain.find('\n'), 200));
  EXPECT_EQ(run_kinex({"check", scratch_.file("made.jsonl"), "--scene", scene_}).exit_code, 0);
  EXPECT_EQ(run_kinex({"diff", scratch_.file("made.jsonl"), scratch_.file("plain.jsonl")}).exit_code, 0);
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
  EXPECT_EQ(made->find("commit")->text(), lab::build_facts().commit);
}

TEST_F(ProvenanceOfResults, PagesHaveTheCommit) {
  const Finished page = run_kinex({"view", scene_, "-o", "-"});
  ASSERT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, HasSubstr(formats::build_name() + " at " + lab::commit_text(lab::build_facts())));
}

}  // namespace
}  // namespace kinex
