// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/finished_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/formats/input_error.h"
#include "experiments/lab/cell_record.h"
#include "experiments/lab/field_archive.h"
#include "experiments/verify/runner.h"

namespace kinex {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class WorkFile : public ::testing::Test {
 protected:
  WorkFile()
      : path_(fs::temp_directory_path() / ("kinex-finished-work-" + std::to_string(::getpid()))) {
    fs::remove(path_);
  }
  ~WorkFile() override { fs::remove(path_); }
  std::string name() const { return path_.string(); }
  std::string text() const {
    std::ostringstream out;
    out << std::ifstream(path_, std::ios::binary).rdbuf();
    return out.str();
  }
  void append(const std::string& what) const {
    std::ofstream(path_, std::ios::binary | std::ios::app) << what;
  }
  fs::path path_;
};

TEST_F(WorkFile, KeepsWhatIsWholeAndDropsTheRest) {
  const std::string odd = "two\nlines, a \"quote\" and an umlaut: \xc3\xbc";
  {
    FinishedWork work(name(), "p", false);
    EXPECT_EQ(work.found(), 0u);
    work.add("a", odd);
    work.add("b", "");
  }
  const std::string whole = text();
  append("{\"piece\": \"c\", \"data\": \"");
  FinishedWork work(name(), "p", false);
  EXPECT_EQ(work.found(), 2u);
  EXPECT_EQ(work.find("a"), odd);
  EXPECT_EQ(work.find("b"), "");
  EXPECT_EQ(work.find("c"), std::nullopt);
  EXPECT_EQ(text(), whole);
  work.add("c", "3");
  EXPECT_EQ(work.find("c"), "3");
}

TEST_F(WorkFile, RefusesWhatIsNotItsOwn) {
  const auto message = [&](const char* program) -> std::string {
    try {
      FinishedWork work(name(), program, false);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  { FinishedWork(name(), "p", false).add("a", "1"); }
  EXPECT_THAT(message("another"), HasSubstr("--fresh"));
  EXPECT_EQ(message("p"), "");
  append("{\"something\": 1}\n");
  EXPECT_THAT(message("p"), HasSubstr("line 3"));
  append("no json\n");
  EXPECT_THAT(message("p"), HasSubstr("line"));
  {
    FinishedWork fresh(name(), "another", true);
    EXPECT_EQ(fresh.found(), 0u);
    EXPECT_THAT(message("another"), HasSubstr("at work"));  // one process at a time
  }
  EXPECT_FALSE(fs::exists(path_));  // nothing is finished: nothing is kept
}

TEST_F(WorkFile, KnowsItsOwnOutputs) {
  const std::string output = name() + ".output";
  FinishedWork work(name(), "p", false);
  EXPECT_FALSE(work.is_own_output(output));
  work.note_output(output, "result");
  EXPECT_FALSE(work.is_own_output(output));
  std::ofstream(output) << "result";
  EXPECT_TRUE(work.is_own_output(output));
  std::ofstream(output, std::ios::app) << "!";
  EXPECT_FALSE(work.is_own_output(output));
  fs::remove(output);
  EXPECT_EQ(work.found(), 0u);
  work.remove();
  EXPECT_FALSE(fs::exists(path_));
}

TEST(FieldArchive, GivesBackWhatItWasGiven) {
  std::string text = "a b:3 \n", other;
  double number = 0.1;
  std::optional<double> none, some = 1e-300;
  std::vector<std::string> words{"", "x"};
  std::map<std::string, std::uint64_t> counts{{"k", ~std::uint64_t{0}}};
  Integer large = Integer::power_of_two(200);
  FieldWriter writer;
  writer(text, number, none, some, words, counts, large);
  decltype(number) number2 = 0;
  decltype(none) none2 = 1, some2;
  decltype(words) words2;
  decltype(counts) counts2;
  Integer large2;
  FieldReader reader(writer.text);
  reader(other, number2, none2, some2, words2, counts2, large2);
  EXPECT_TRUE(reader.at_end());
  EXPECT_EQ(other, text);
  EXPECT_EQ(number2, number);
  EXPECT_EQ(none2, none);
  EXPECT_EQ(some2, some);
  EXPECT_EQ(words2, words);
  EXPECT_EQ(counts2, counts);
  EXPECT_EQ(large2, large);
  // Every part of it is refused.
  for (std::size_t length = 0; length < writer.text.size(); ++length) {
    FieldReader part(std::string_view(writer.text).substr(0, length));
    EXPECT_THROW(part(other, number2, none2, some2, words2, counts2, large2), std::runtime_error)
        << length;
  }
}

TEST(CellRecord, IsTheCellAgain) {
  Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "uniform-square";
  cell.parameters.n = 12;
  cell.parameters.dimension = 1;
  cell.random = true;
  cell.min_seeds = cell.max_seeds = 2;
  const CellResult run = run_cell(cell, {}, nullptr).value();
  const std::string record = cell_record(run);
  const std::optional<CellResult> read = read_cell_record(record, cell);
  ASSERT_TRUE(read);
  EXPECT_EQ(cell_record(*read), record);
  ASSERT_EQ(read->trials.size(), 2u);
  EXPECT_EQ(read->trials[1].measurement.ledger.processed,
            run.trials[1].measurement.ledger.processed);
  EXPECT_EQ(read->trials[1].measurement.attribute, run.trials[1].measurement.attribute);
  EXPECT_FALSE(read_cell_record(record.substr(1), cell));
  EXPECT_FALSE(read_cell_record(record + "1 ", cell));
  Cell other = cell;
  other.parameters.seed = 2;
  EXPECT_NE(cell_key(cell, {}), cell_key(other, {}));
  EXPECT_NE(cell_key(cell, {}), cell_key(cell, 3));
  other = cell;
  other.parameters.degree = 2;
  EXPECT_NE(cell_key(cell, {}), cell_key(other, {}));
}

}  // namespace
}  // namespace kinex
