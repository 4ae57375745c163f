// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments that are killed or interrupted go on where they were, with the same command; too few
// scenes are said to be too few.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <memory>

#include "tests/program/spawn.h"
#include "tests/sanitized.h"

namespace kinex {
namespace resume_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

// Everything in a database that is exact: no times, nothing that is measured in them, and nothing
// of the machine.
std::string exact_content(const std::string& path) {
  sqlite3* opened = nullptr;
  EXPECT_EQ(sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  std::string text;
  const auto rows = [&](const std::string& query, const auto& row) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(opened, query.c_str(), -1, &statement, nullptr), SQLITE_OK)
        << query;
    while (sqlite3_step(statement) == SQLITE_ROW) row(statement);
    sqlite3_finalize(statement);
  };
  Words tables;
  rows("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name", [&](sqlite3_stmt* s) {
    tables.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(s, 0)));
  });
  for (const std::string& table : tables) {
    if (table == "build" || table == "machine") continue;
    rows("SELECT * FROM " + table, [&](sqlite3_stmt* s) {
      text += table;
      for (int i = 0; i < sqlite3_column_count(s); ++i) {
        const std::string name = sqlite3_column_name(s, i);
        const bool timed = sqlite3_column_type(s, i) == SQLITE_FLOAT || name == "started_utc" ||
                           name.find("over_double") != name.npos ||
                           name.find("_ratio") != name.npos;
        const unsigned char* value = sqlite3_column_text(s, i);
        text += std::string(" ") + name + "=" +
                (timed || value == nullptr ? "" : reinterpret_cast<const char*>(value));
      }
      text += "\n";
    });
  }
  EXPECT_GT(text.size(), 1000u);
  return text;
}

Words files_in(const std::string& folder) {
  Words names;
  for (const auto& file : fs::directory_iterator(folder)) names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

struct Verb {
  std::string name;
  Words command;
};

class Resume : public ::testing::Test {
 protected:
  // Small ones where everything takes many times as long.
  std::vector<Verb> verbs() const {
    if (test::kSanitized) {
      return {{"verify", {"verify", "minimum_sorted_list", "--quick"}},
              {"trade", {"trade", "sorted_list", "--quick", "--arithmetic", "gsl"}}};
    }
    return {{"verify", {"verify", "maximum_envelope", "--quick"}},
            {"trade", {"trade", "delaunay_2", "--quick", "--arithmetic", "gsl"}}};
  }
  static Words in(const Verb& verb, const std::string& folder) {
    Words command = verb.command;
    command.insert(command.end(), {"-o", folder});
    return command;
  }
  ScratchFolder scratch_;
};

TEST_F(Resume, AKilledRunGoesOn) {
  for (const Verb& verb : verbs()) {
    const std::string whole = scratch_.file(verb.name + "-whole");
    const Finished uninterrupted = run_kinex(in(verb, whole));
    ASSERT_EQ(uninterrupted.exit_code, 0) << uninterrupted.err << uninterrupted.out;
    EXPECT_THAT(uninterrupted.out, Not(HasSubstr("earlier commands")));
    const Words results = files_in(whole);
    EXPECT_THAT(results, ElementsAre(verb.name + ".html", verb.name + ".sqlite", verb.name + ".txt"));

    const std::string folder = scratch_.file(verb.name);
    const std::string kept = folder + "/" + verb.name + ".unfinished";
    const Finished killed = run_kinex_until(in(verb, folder), kept, 4, SIGKILL);
    ASSERT_EQ(killed.exit_code, -SIGKILL);
    EXPECT_THAT(files_in(folder), ElementsAre(verb.name + ".unfinished"));
    // A write that the power cut short.
    const std::string finished = read_file(kept);
    write_file(kept, finished + "{\"piece\": \"half a li");

    const Finished again = run_kinex_until(in(verb, folder), kept, 7, SIGKILL);
    ASSERT_EQ(again.exit_code, -SIGKILL);
    EXPECT_EQ(read_file(kept).substr(0, finished.size()), finished);

    const Finished last = run_kinex(in(verb, folder));
    EXPECT_EQ(last.exit_code, 0) << last.err;
    EXPECT_THAT(last.err, HasSubstr("kinex: going on: "));
    EXPECT_THAT(last.out, HasSubstr(" of them by earlier commands"));
    EXPECT_EQ(files_in(folder), results);
    EXPECT_EQ(exact_content(folder + "/" + verb.name + ".sqlite"),
              exact_content(whole + "/" + verb.name + ".sqlite"));
  }
}

// Ctrl-C writes what is finished; the same command resumes and replaces that, and nothing else.
TEST_F(Resume, AnInterruptedRunGoesOn) {
  for (const Verb& verb : verbs()) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      if (test::kSanitized && signal != SIGTERM) continue;  // a handler for all of them
      const std::string folder = scratch_.file(verb.name + std::to_string(signal));
      const std::string database = folder + "/" + verb.name + ".sqlite";
      const std::string kept = folder + "/" + verb.name + ".unfinished";
      const Finished stopped = run_kinex_until(in(verb, folder), kept, 4, signal);
      ASSERT_EQ(stopped.exit_code, 3) << stopped.err;
      EXPECT_THAT(stopped.err, HasSubstr("the same command resumes"));
      ASSERT_TRUE(fs::exists(database));
      const std::string partial = read_file(database);
      write_file(database, "mine");
      EXPECT_EQ(run_kinex(in(verb, folder)).exit_code, 2);  // no result of ours is there to replace
      EXPECT_EQ(read_file(database), "mine");
      write_file(database, partial);
      const Finished last = run_kinex(in(verb, folder));
      EXPECT_EQ(last.exit_code, 0) << last.err;
      EXPECT_FALSE(fs::exists(kept));
      EXPECT_NE(read_file(database), partial);
      EXPECT_EQ(run_kinex(in(verb, folder)).exit_code, 2);  // complete results need --force
    }
  }
}

TEST_F(Resume, FreshBeginsAnew) {
  const Verb verb = verbs()[1];
  const std::string folder = scratch_.file("fresh");
  const std::string kept = folder + "/trade.unfinished";
  ASSERT_EQ(run_kinex_until(in(verb, folder), kept, 4, SIGKILL).exit_code, -SIGKILL);
  std::string text = read_file(kept);
  text.replace(text.find("\"program\": \"") + 12, 4, "beef");
  write_file(kept, text);
  const Finished refused = run_kinex(in(verb, folder));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("another version of the program"));
  EXPECT_THAT(refused.err, HasSubstr("--fresh"));
  EXPECT_EQ(read_file(kept), text);
  for (const char* option : {"--fresh", "--force"}) {
    write_file(kept, text);
    Words command = in(verb, folder);
    command.push_back(option);
    const Finished anew = run_kinex(command);
    EXPECT_EQ(anew.exit_code, 0) << anew.err;
    EXPECT_THAT(anew.err, Not(HasSubstr("going on")));
    EXPECT_EQ(anew.err.find("beginning anew: " + kept) != anew.err.npos, option == std::string("--force"));
    EXPECT_FALSE(fs::exists(kept));
  }
}

// What one command has begun in a folder another one neither goes on with nor removes.
TEST_F(Resume, AnotherCommandIsRefused) {
  const Verb verb = verbs()[0];
  const std::string folder = scratch_.file("two");
  const std::string kept = folder + "/" + verb.name + ".unfinished";
  ASSERT_EQ(run_kinex_until(in(verb, folder), kept, 4, SIGKILL).exit_code, -SIGKILL);
  const std::string text = read_file(kept);
  const Finished refused = run_kinex({"verify", "maximum_heap", "--quick", "-o", folder});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("it was begun by another command, \"verify"));
  EXPECT_EQ(read_file(kept), text);
}

// Nothing is finished before the first piece is: no file is left to go on from.
TEST_F(Resume, ARefusedRunLeavesNothing) {
  const std::string folder = scratch_.file("mine");
  fs::create_directories(folder);
  write_file(folder + "/verify.html", "mine");
  EXPECT_EQ(run_kinex(in(verbs()[0], folder)).exit_code, 2);
  EXPECT_THAT(files_in(folder), ElementsAre("verify.html"));
}

TEST(Seeds, TooFewAreSaidToBeTooFew) {
  const ScratchFolder scratch;
  for (const char* seeds : {"1", "2", "3", "5"}) {
    const Finished run = run_kinex(
        {"verify", "maximum_tournament", "--quick", "--seeds", seeds, "-o", scratch.file(seeds)});
    EXPECT_EQ(run.exit_code, 3) << seeds << run.out;
    EXPECT_THAT(run.out, Not(HasSubstr("inf ")));
    EXPECT_THAT(run.out, HasSubstr("needed)"));
    EXPECT_THAT(run.out, HasSubstr(" 0 fail;"));
    EXPECT_THAT(run.out, HasSubstr("would do"));
  }
}

}  // namespace resume_test
}  // namespace kinex
