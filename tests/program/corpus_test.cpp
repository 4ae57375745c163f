// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of tests/corpus is a test of its own: the program must give the exit code that
// index.json says, and for a bad file name it, the place, the text and the remedy. A corpus that is
// missing, empty, or not what the index says, fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "experiments/formats/file_io.h"
#include "experiments/formats/json_document.h"
#include "tests/places.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace corpus_test {

const std::filesystem::path kCorpus = std::filesystem::path(KINEX_SOURCE_DIR) / "tests" / "corpus";
constexpr std::size_t kFewestBadScenes = 80, kFewestBadTraces = 40, kFewestBadFeatures = 40,
                      kFewestBadQueries = 30;

// The verb that reads such a file.
std::string verb_for(const std::string& file) {
  if (file.rfind("polynomials/", 0) == 0) return "roots";
  if (file.rfind("traces/", 0) == 0 || file.rfind("features/", 0) == 0) return "import";
  if (file.rfind("queries/", 0) == 0) return "ccd";
  return "check";
}

struct Entry {
  std::string file;
  int exit_code;
  std::vector<std::string> message;
};

std::vector<Entry> read_index() {
  std::vector<Entry> entries;
  const std::string path = (kCorpus / "index.json").string();
  const formats::JsonDocument index = formats::parse_json(formats::read_text_file(path), path);
  for (const formats::JsonValue& item : index->items()) {
    Entry entry{std::string(item.find("file")->text()), std::stoi(std::string(item.find("exit")->text())), {}};
    for (const formats::JsonValue& part : item.find("message")->items()) entry.message.emplace_back(part.text());
    entries.push_back(std::move(entry));
  }
  return entries;
}

class CorpusTest : public testing::Test {
 public:
  explicit CorpusTest(Entry entry) : entry_(std::move(entry)) {}
  void TestBody() override {
    const std::string path = (kCorpus / entry_.file).string();
    const std::string verb = verb_for(entry_.file);
    const Finished finished = run_kinex({verb, path});
    EXPECT_EQ(finished.exit_code, entry_.exit_code) << finished.err;
    for (const std::string& part : entry_.message) {
      EXPECT_THAT(finished.err, testing::HasSubstr(part));
    }
    if (entry_.exit_code == 2) {
      EXPECT_THAT(finished.err, testing::StartsWith("kinex: " + path + ": "));
      EXPECT_THAT(finished.err, testing::HasSubstr("; "));  // before the remedy
      EXPECT_EQ(finished.out, "");
    }
    if (entry_.exit_code != 0) return;
    if (verb == "import") {  // it counts what it read, and what it makes must be a scene
      const Finished check = run_kinex({"check", "-"}, finished.out);
      EXPECT_EQ(check.exit_code, 0) << check.err;
    } else {
      EXPECT_EQ(finished.err, "");
    }
  }

 private:
  Entry entry_;
};

TEST(Corpus, IsWhatTheIndexSays) {
  const std::vector<Entry> entries = read_index();
  std::set<std::string> listed, found;
  std::size_t bad_scenes = 0, bad_traces = 0, bad_features = 0, bad_queries = 0;
  for (const Entry& entry : entries) {
    EXPECT_TRUE(listed.insert(entry.file).second) << entry.file << " is listed twice";
    const bool in_bad = entry.file.find("/bad/") != std::string::npos;
    EXPECT_EQ(entry.exit_code != 0, in_bad) << entry.file;
    EXPECT_EQ(entry.message.empty(), !in_bad) << entry.file;
    if (entry.file.rfind("scenes/bad/", 0) == 0) ++bad_scenes;
    if (entry.file.rfind("traces/bad/", 0) == 0) ++bad_traces;
    if (entry.file.rfind("features/bad/", 0) == 0) ++bad_features;
    if (entry.file.rfind("queries/bad/", 0) == 0) ++bad_queries;
  }
  for (const auto& file : std::filesystem::recursive_directory_iterator(kCorpus)) {
    if (!file.is_regular_file() || file.path().filename() == "index.json") continue;
    const std::string name = std::filesystem::relative(file.path(), kCorpus).string();
    if (name.rfind("extremes/", 0) != 0) found.insert(name);  // that has an index of its own
  }
  EXPECT_EQ(listed, found);
  EXPECT_GE(bad_scenes, kFewestBadScenes);
  EXPECT_GE(bad_traces, kFewestBadTraces);
  EXPECT_GE(bad_features, kFewestBadFeatures);
  EXPECT_GE(bad_queries, kFewestBadQueries);
}

// Registered before main runs; a corpus that cannot be read leaves only the test above, which
// fails.
const bool kRegistered = [] {
  try {
    for (const Entry& entry : read_index()) {
      std::string name = entry.file;
      for (char& c : name) {
        if (c == '/' || c == '.' || c == '-') c = '_';
      }
      testing::RegisterTest("CorpusFile", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [entry]() -> testing::Test* { return new CorpusTest(entry); });
    }
  } catch (const std::exception&) {
    return false;
  }
  return true;
}();

}  // namespace corpus_test
}  // namespace kinex
