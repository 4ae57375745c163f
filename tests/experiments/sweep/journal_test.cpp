// SPDX-License-Identifier: GPL-3.0-or-later
// The journal of an experiment that this process runs, and the fields of its records.
#include "experiments/sweep/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/formats/input_error.h"
#include "experiments/lab/cell_record.h"
#include "experiments/sweep/fields_report.h"
#include "experiments/verbs/experiment_files.h"
#include "experiments/verify/runner.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace journal_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class SweepJournal : public ::testing::Test {
 protected:
  SweepJournal()
      : path_(fs::temp_directory_path() / ("kinex-journal-" + std::to_string(::getpid()))) {
    fs::remove(path_);
  }
  ~SweepJournal() override { fs::remove(path_); }
  std::string name() const { return path_.string(); }
  std::string text() const {
    std::ostringstream out;
    out << std::ifstream(path_, std::ios::binary).rdbuf();
    return out.str();
  }
  void append(const std::string& what) const {
    std::ofstream(path_, std::ios::binary | std::ios::app) << what;
  }
  static sweep::AttemptProvenance by(const std::string& program) {
    sweep::Selection selection;
    selection.experiment = "test";
    sweep::AttemptProvenance provenance =
        sweep::provenance_of(sweep::plan_text(selection), "kinex test", "0/1");
    provenance.program = program;
    return provenance;
  }
  static sweep::PlanCell cell(int n) {
    return sweep::make_cell("test", "{\"test\": {\"n\": " + std::to_string(n) + "}}", 1);
  }
  static sweep::Record record(int n, const std::string& exact, const std::string& times = "") {
    return sweep::record_of(cell(n), sweep::report_of(sweep::Outcome::kDone, "", {exact, times}),
                            1);
  }
  fs::path path_;
};

TEST_F(SweepJournal, KeepsWhatIsWholeAndDropsTheRest) {
  const std::string odd = "two\nlines, a \"quote\" and an umlaut: \xc3\xbc";
  {
    sweep::Journal journal(name(), by("p"), sweep::Leftover::kKeep);
    EXPECT_EQ(journal.found(), 0u);
    journal.add(record(1, odd, "0x1p+3 "));
    journal.add(record(2, ""));
  }
  const std::string whole = text();
  append("{\"key\": \"c\", \"cell\": \"");
  sweep::Journal journal(name(), by("p"), sweep::Leftover::kKeep);
  EXPECT_EQ(journal.found(), 2u);
  EXPECT_EQ(journal.found_seconds(), 2);  // a second each
  ASSERT_NE(journal.find(cell(1).key), nullptr);
  EXPECT_EQ(sweep::fields_of(*journal.find(cell(1).key))->exact, odd);
  EXPECT_EQ(sweep::fields_of(*journal.find(cell(1).key))->times, "0x1p+3 ");
  EXPECT_EQ(journal.find(cell(1).key)->cell, cell(1).text);
  EXPECT_EQ(journal.find(cell(3).key), nullptr);
  EXPECT_EQ(text(), whole);
  EXPECT_EQ(sweep::fields_of(journal.add(record(3, "3")))->exact, "3");
  EXPECT_NE(journal.find(cell(3).key), nullptr);
  EXPECT_EQ(journal.found_seconds(), 2);  // what is added is no earlier work
}

TEST_F(SweepJournal, RefusesWhatIsNotItsOwn) {
  const auto message = [&](const char* program) -> std::string {
    try {
      sweep::Journal journal(name(), by(program), sweep::Leftover::kKeep);
    } catch (const formats::InputError& error) {
      return error.what();
    }
    return "";
  };
  { sweep::Journal(name(), by("p"), sweep::Leftover::kKeep).add(record(1, "1")); }
  EXPECT_THAT(message("another"), HasSubstr("--fresh"));
  EXPECT_EQ(message("p"), "");
  append("{\"something\": 1}\n");
  EXPECT_THAT(message("p"), HasSubstr("line 3"));
  append("no json\n");
  EXPECT_THAT(message("p"), HasSubstr("line"));
  {
    sweep::Journal fresh(name(), by("another"), sweep::Leftover::kDrop);
    EXPECT_EQ(fresh.found(), 0u);
    EXPECT_THAT(message("another"), HasSubstr("at work"));  // one process at a time
  }
  EXPECT_FALSE(fs::exists(path_));  // nothing is finished: nothing is kept
}

// As under --force: what this program has left is used, what another has left gives way.
TEST_F(SweepJournal, DropsWhatAnotherProgramHasLeftIfItMay) {
  { sweep::Journal(name(), by("p"), sweep::Leftover::kKeepOwn).add(record(1, "1")); }
  {
    const sweep::Journal own(name(), by("p"), sweep::Leftover::kKeepOwn);
    EXPECT_EQ(own.found(), 1u);
    EXPECT_EQ(own.dropped_other(), "");
  }
  {
    sweep::Journal other(name(), by("another"), sweep::Leftover::kKeepOwn);
    EXPECT_EQ(other.found(), 0u);
    EXPECT_EQ(other.dropped_other(), "another version of the program");
    EXPECT_EQ(other.find(cell(1).key), nullptr);
    other.add(record(2, "2"));
  }
  const sweep::Journal again(name(), by("another"), sweep::Leftover::kKeep);
  EXPECT_EQ(again.found(), 1u);
  EXPECT_NE(again.find(cell(2).key), nullptr);
}

// Another command in the folder of an interrupted one neither goes on with its records nor removes them.
TEST_F(SweepJournal, RefusesWhatAnotherCommandHasLeft) {
  sweep::AttemptProvenance mine = by("p"), other = by("p");
  mine.plan_name = "verify sorted_list --quick";
  mine.plan_hash = "1";
  other.plan_name = "verify maximum_heap --quick";
  other.plan_hash = "2";
  { sweep::Journal(name(), mine, sweep::Leftover::kKeep).add(record(1, "1")); }
  const std::string before = text();
  try {
    sweep::Journal(name(), other, sweep::Leftover::kKeep);
    ADD_FAILURE() << "not refused";
  } catch (const formats::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("it was begun by another command, \"verify sorted_list --quick\""));
  }
  EXPECT_EQ(text(), before);
  EXPECT_EQ(sweep::Journal(name(), mine, sweep::Leftover::kKeep).found(), 1u);
  const sweep::Journal anew(name(), other, sweep::Leftover::kKeepOwn);
  EXPECT_EQ(anew.found(), 0u);
  EXPECT_EQ(anew.dropped_other(), "another command, \"verify sorted_list --quick\"");
}

TEST_F(SweepJournal, KnowsItsOwnOutputs) {
  const std::string output = name() + ".output";
  sweep::Journal journal(name(), by("p"), sweep::Leftover::kKeep);
  EXPECT_FALSE(journal.is_own_output(output));
  journal.note_output(output, "result");
  EXPECT_FALSE(journal.is_own_output(output));
  std::ofstream(output) << "result";
  EXPECT_TRUE(journal.is_own_output(output));
  // However its folder is spelt.
  const fs::path folder = path_.parent_path(), file = fs::path(output).filename();
  EXPECT_TRUE(journal.is_own_output((folder / "." / file).string()));
  EXPECT_TRUE(journal.is_own_output((folder / ".." / folder.filename() / file).string()));
  EXPECT_TRUE(journal.is_own_output((fs::relative(folder) / file).string()));
  std::ofstream(output, std::ios::app) << "!";
  EXPECT_FALSE(journal.is_own_output(output));
  fs::remove(output);
  EXPECT_EQ(journal.found(), 0u);
  journal.remove();
  EXPECT_FALSE(fs::exists(path_));
}

// Where two attempts are at one cell the settled one is taken; what was killed is no record.
TEST_F(SweepJournal, TakesTheSettledRecordsOfASweep) {
  sweep::Record killed = record(1, "1"), lost = record(2, "2");
  killed.outcome = lost.outcome = sweep::Outcome::kKilled;
  const sweep::Journal journal(std::vector<sweep::Attempt>{
      {"a", by("p"), {killed, lost}}, {"b", by("p"), {record(1, "right"), record(3, "3")}}});
  EXPECT_FALSE(journal.runs());
  EXPECT_EQ(sweep::fields_of(*journal.find(cell(1).key))->exact, "right");
  EXPECT_EQ(journal.find(cell(2).key), nullptr);
  EXPECT_NE(journal.find(cell(3).key), nullptr);
  EXPECT_EQ(journal.found_seconds(), 2);  // what is added is no earlier work
}

TEST(FieldArchive, GivesBackWhatItWasGiven) {
  std::string text = "a b:3 \n", other;
  double number = 0.1;
  std::optional<double> none, some = 1e-300;
  std::vector<std::string> words{"", "x"};
  std::map<std::string, std::uint64_t> counts{{"k", ~std::uint64_t{0}}};
  Integer large = Integer::power_of_two(200);
  lab::FieldWriter writer;
  writer(text, number, none, some, words, counts, large);
  decltype(number) number2 = 0;
  decltype(none) none2 = 1, some2;
  decltype(words) words2;
  decltype(counts) counts2;
  Integer large2;
  lab::FieldReader reader(writer.text);
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
    lab::FieldReader part(std::string_view(writer.text).substr(0, length));
    EXPECT_THROW(part(other, number2, none2, some2, words2, counts2, large2), std::runtime_error)
        << length;
  }
}

// What two runs do not have alike is in the times alone.
TEST(CellRecord, IsTheCellAgain) {
  lab::Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "uniform-square";
  cell.parameters.n = 12;
  cell.parameters.dimension = 1;
  cell.random = true;
  cell.min_seeds = cell.max_seeds = 2;
  const lab::CellResult run = verify::run_cell(cell, {}).value();
  const lab::Fields fields = lab::cell_fields(run);
  const std::optional<lab::CellResult> read = lab::cell_of(fields, cell);
  ASSERT_TRUE(read);
  EXPECT_EQ(lab::cell_fields(*read).exact, fields.exact);
  EXPECT_EQ(lab::cell_fields(*read).times, fields.times);
  ASSERT_EQ(read->trials.size(), 2u);
  EXPECT_EQ(read->trials[1].measurement.ledger.processed,
            run.trials[1].measurement.ledger.processed);
  EXPECT_EQ(read->trials[1].measurement.attribute, run.trials[1].measurement.attribute);
  EXPECT_EQ(read->trials[1].measurement.seconds, run.trials[1].measurement.seconds);
  EXPECT_EQ(read->seconds, run.seconds);
  EXPECT_EQ(lab::cell_fields(verify::run_cell(cell, {}).value()).exact, fields.exact);
  EXPECT_FALSE(lab::cell_of({fields.exact.substr(1), fields.times}, cell));
  EXPECT_FALSE(lab::cell_of({fields.exact + "1 ", fields.times}, cell));
  EXPECT_FALSE(lab::cell_of({fields.exact, fields.times + "1 "}, cell));
}

// Plots that an interrupted run has written are replaced when the same command goes on; no others are, nor any that
// were changed since.
TEST_F(SweepJournal, PlotsOfAnInterruptedRunAreItsOwn) {
  const std::string folder = name() + "-plots";
  fs::create_directories(folder);
  const auto write = [&](sweep::Journal& journal, bool force, const std::string& svg) {
    const verbs::PlotFiles plots(folder, force, {"a: b", "c"}, journal);
    lab::Figure figure;
    figure.title = "a: b";
    plots.write({figure, figure}, {{svg, svg + " again"}, ""});
  };
  const auto plot = [&](const char* file) {
    std::ostringstream out;
    out << std::ifstream(folder + "/" + file, std::ios::binary).rdbuf();
    return out.str();
  };
  {
    sweep::Journal journal(name(), by("p"), sweep::Leftover::kKeep);
    write(journal, false, "<svg>partial</svg>");
  }
  {
    sweep::Journal journal(name(), by("p"), sweep::Leftover::kKeep);
    write(journal, false, "<svg>whole</svg>");
    EXPECT_EQ(plot("a-b.svg"), "<svg>whole</svg>");
    EXPECT_EQ(plot("a-b-2.svg"), "<svg>whole</svg> again");
    std::ofstream(folder + "/a-b-2.svg") << "mine";
    EXPECT_INPUT_ERROR(write(journal, false, "<svg>other</svg>"), folder + "/a-b-2.svg: exists already, and a plot may");
    std::ofstream(folder + "/c.svg") << "mine";
    EXPECT_INPUT_ERROR(write(journal, false, "<svg>other</svg>"), folder + "/a-b-2.svg: exists");  // the first by name
    EXPECT_EQ(plot("a-b.svg"), "<svg>whole</svg>");
    write(journal, true, "<svg>forced</svg>");
    EXPECT_EQ(plot("a-b-2.svg"), "<svg>forced</svg> again");
    EXPECT_EQ(plot("c.svg"), "mine");  // it is no plot of this run
    journal.remove();
  }
  sweep::Journal another(name(), by("p"), sweep::Leftover::kKeep);
  EXPECT_INPUT_ERROR(write(another, false, "<svg></svg>"), folder + "/a-b-2.svg: exists");
  fs::remove_all(folder);
}

}  // namespace journal_test
}  // namespace kinex
