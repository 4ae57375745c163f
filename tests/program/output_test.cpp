// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs: never over a file that is there, never half a file, and where one cannot be written the
// program says so and exits with 2.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/numbers/show_text.h"
#include "tests/places.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace output_test {

using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

class Output : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "12", "-o", scene_}).exit_code, 0);
    write_file(table_, "id,x,y,vx,vy\na,0,0,1,1\nb,1,0,-1,1\n");
  }
  // Every way to make the program write to a file.
  std::vector<Words> writers() const {
    return {{"gen", "grid", "-o"},
            {"import", table_, "-o"},
            {"run", scene_, "--events"},
            {"run", scene_, "--summary"}};
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& file : std::filesystem::recursive_directory_iterator(scratch_.path())) {
      names.insert(file.path().string());
    }
    return names;
  }
  // The writer with this file is refused with the message, and the folder is what it was.
  void expect_refused(Words writer, const std::string& file, const std::string& message) const {
    writer.push_back(file);
    const std::set<std::string> before = files();
    const Finished finished = run_kinex(writer);
    const std::string command = testing::PrintToString(writer);
    EXPECT_EQ(finished.exit_code, 2) << command;
    EXPECT_THAT(finished.err, StartsWith("kinex: " + file + ": ")) << command;
    EXPECT_THAT(finished.err, HasSubstr(message)) << command;
    EXPECT_THAT(finished.err, HasSubstr("; ")) << command;  // before the remedy
    EXPECT_EQ(files(), before) << command;
    // Seen before any work is done; only a full disk is seen late.
    if (file != "/dev/full") {
      EXPECT_EQ(finished.out, "") << command;
    }
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
  const std::string table_ = scratch_.file("table.csv");
};

TEST_F(Output, FilesAreNotReplacedUnlessForced) {
  const std::string file = scratch_.file("precious");
  for (const Words& writer : writers()) {
    write_file(file, "precious");
    expect_refused(writer, file, "exists already; give another name, or --force");
    EXPECT_EQ(read_file(file), "precious");
    Words forced = writer;
    forced.insert(forced.end(), {file, "--force"});
    EXPECT_EQ(run_kinex(forced).exit_code, 0);
    EXPECT_THAT(read_file(file), StartsWith("{\""));
  }
}

TEST_F(Output, FoldersThatAreMissingOrAreThere) {
  for (const Words& writer : writers()) {
    expect_refused(writer, scratch_.file("no/such/folder"),
                   "cannot be written: No such file or directory");
    expect_refused(writer, scratch_.path().string(), "cannot be written: it is a directory");
    expect_refused(writer, scene_ + "/in-a-file", "cannot be written: Not a directory");
    expect_refused(writer, scratch_.file(std::string(300, 'a')), "File name too long");
  }
}

TEST_F(Output, ReadOnlyFolders) {
  // To root only a file system like that of /proc is read-only.
  const bool root = ::geteuid() == 0;
  const std::string folder = root ? "/proc" : scratch_.file("locked");
  if (!root) {
    std::filesystem::create_directory(folder);
    std::filesystem::permissions(folder, std::filesystem::perms(0555));
  }
  for (const Words& writer : writers()) {
    expect_refused(writer, folder + "/kinex-output", "cannot be written: ");
  }
}

TEST_F(Output, FullDisks) {
  for (const Words& writer : writers()) {
    expect_refused(writer, "/dev/full", "cannot be written: No space left on device");
  }
  // Enough to fail before the file is closed.
  expect_refused({"gen", "grid", "--n", "2000", "-o"}, "/dev/full", "No space left on device");
  expect_refused({"run", scene_, "--summary", "/dev/full", "--events"}, "/dev/full",
                 "No space left on device");
}

TEST_F(Output, StandardOutputThatIsFull) {
  for (const Words& command :
       {Words{"gen", "grid"}, Words{"import", table_}, Words{"run", scene_},
        Words{"run", scene_, "--json"}, Words{"check", scene_}, Words{"gen", "--list"}, Words{"--help"},
        Words{"run", "--help"}, Words{"sweep", "run", "--help"}, Words{"--version"}, Words{"help"}}) {
    const Finished finished = run_kinex(command, "", "/dev/full");
    EXPECT_EQ(finished.exit_code, 2) << command[0];
    EXPECT_THAT(finished.err, HasSubstr("standard output: cannot be written: No space left"));
  }
}

// What goes wrong after the output has been opened leaves neither it nor its temporary.
TEST_F(Output, FailedRunsLeaveNothing) {
  const std::string log = scratch_.file("run.log"), summary = scratch_.file("run.json");
  const std::set<std::string> before = files();
  for (const Words& wrong :
       {Words{"--arithmetic", "abacus"}, Words{"--audit", "never"}, Words{"--until", "7"},
        Words{"--at", "7"}, Words{"--maintain", "tap"}, Words{"--max-events", "-1"}}) {
    Words command{"run", scene_, "--events", log, "--summary", summary};
    command.insert(command.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run_kinex(command).exit_code, 2) << wrong[0];
    EXPECT_EQ(files(), before) << wrong[0];
  }
  // The other output cannot be written, before the run or after it.
  for (const std::string& other : {scratch_.file("no/such/folder"), std::string("/dev/full")}) {
    EXPECT_EQ(run_kinex({"run", scene_, "--events", other, "--summary", summary}).exit_code, 2);
    EXPECT_EQ(files(), before) << other;
  }
  EXPECT_EQ(run_kinex({"import", scene_, "-o", log}).exit_code, 2);
  EXPECT_EQ(run_kinex({"gen", "grid", "--maintain", "tap", "-o", log}).exit_code, 2);
  EXPECT_EQ(files(), before);
}

// The error gives the reason why a folder cannot be made or written in.
TEST_F(Output, FoldersOfResultsThatCannotBeMade) {
  const std::string deep = scene_ + "/deep", locked = scratch_.file("locked");
  std::filesystem::create_directory(locked);
  std::filesystem::permissions(locked, std::filesystem::perms(0555));
  const std::set<std::string> before = files();
  for (const Words& verb : {Words{"verify", "sorted_list", "--quick", "-o"},
                            {"trade", scene_, "-o"},
                            {"reproduce", "kds-report-1998", "section-7-lifting", "-o"},
                            {"sweep", "run", "verify", "--quick", "-o"}}) {
    for (const auto& [folder, problem] :
         {std::pair(scene_, " is a file, not a folder; name a folder"),
          {deep, " cannot be made: Not a directory; name another one"},
          {locked + "/deep", " cannot be made: Permission denied; name another one"}}) {
      if (::geteuid() == 0 && folder.starts_with(locked)) continue;  // root may write there
      Words words = verb;
      words.push_back(folder);
      const Finished refused = run_kinex(words);
      EXPECT_EQ(refused.exit_code, 2) << verb[0];
      EXPECT_THAT(refused.err, StartsWith("kinex: --output: ")) << verb[0];
      EXPECT_THAT(refused.err, HasSubstr("\"" + folder + "\"" + problem)) << verb[0];
      EXPECT_EQ(files(), before) << verb[0];
    }
  }
}

// A file where the folder of plots must be is refused before the experiments, which would be lost.
TEST_F(Output, PlotsNeedAFolder) {
  const std::string file = scratch_.file("plots"), results = scratch_.file("results");
  write_file(file, "precious");
  const std::set<std::string> before = files();
  for (const auto& [folder, problem] :
       {std::pair(file, " is a file, not a folder; name a folder"), {file + "/deep", " cannot be made: Not a directory; "}}) {
    const Finished refused = run_kinex({"verify", "sorted_list", "--quick", "--seeds", "1", "-o", results, "--plots", folder});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, StartsWith("kinex: --plots: "));
    EXPECT_THAT(refused.err, HasSubstr("\"" + folder + "\"" + problem));
    EXPECT_EQ(files(), before);
  }
}

// So is a folder that has a file of a name that a plot may have, whatever its number of panels; other files stay.
TEST_F(Output, PlotsAreNotReplaced) {
  const std::string folder = scratch_.file("plots");
  std::filesystem::create_directories(folder);
  const std::set<std::string> at_first = files();
  const auto run = [&](const std::string& results, const Words& more) {
    Words command{"verify", "sorted_list", "--quick", "--seeds", "2", "-o", scratch_.file(results), "--plots", folder};
    command.insert(command.end(), more.begin(), more.end());
    return run_kinex(command);
  };
  for (const char* name : {"sorted_list-events-over-n.svg", "sorted_list-residuals-of-the-fit-uniform-2.svg"}) {
    const std::string file = folder + "/" + name;
    write_file(file, "precious");
    std::set<std::string> before = at_first;
    before.insert(file);
    const Finished refused = run("refused", {});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(refused.err, "kinex: --plots: " + file + ": exists already, and a plot may have this name; name "
                           "another folder, or --force to replace it\n");
    std::set<std::string> after = files();
    after.erase(scratch_.file("refused"));  // the folder of the results, empty
    EXPECT_EQ(after, before);
    EXPECT_EQ(read_file(file), "precious");
    std::filesystem::remove(file);
  }
  const Words others{"sorted_list-events.svg", "sorted_list-events-over-n.png", "convex_hull_2-events-over-n.svg"};
  for (const std::string& name : others) write_file(folder + "/" + name, "other");
  EXPECT_EQ(run("first", {}).exit_code, 3);  // two scenes are too few to tell
  const std::string plot = folder + "/sorted_list-events-over-n.svg";
  EXPECT_THAT(read_file(plot), HasSubstr("<svg"));
  for (const std::string& name : others) EXPECT_EQ(read_file(folder + "/" + name), "other");
  EXPECT_EQ(run("second", {}).exit_code, 2);
  write_file(plot, "old");
  EXPECT_EQ(run("third", {"--force"}).exit_code, 3);
  EXPECT_THAT(read_file(plot), HasSubstr("<svg"));
}

// --force replaces results, never what they are made of.
TEST_F(Output, TheInputIsKept) {
  const std::string link = scratch_.file("link");
  std::filesystem::create_symlink(scene_, link);
  const std::string scene = read_file(scene_), table = read_file(table_);
  const std::set<std::string> before = files();
  for (const std::string& name : {scene_, link, scratch_.path().string() + "/./scene.json"}) {
    for (const Words& command :
         {Words{"run", scene_, "--force", "--events", name},
          Words{"run", link, "--force", "--summary", name},
          Words{"trade", scene_, "--force", "-o", scratch_.path(), "--markdown", name}}) {
      const Finished finished = run_kinex(command);
      EXPECT_EQ(finished.exit_code, 2) << testing::PrintToString(command);
      EXPECT_THAT(finished.err, HasSubstr("is the input itself; give the output another name"));
      EXPECT_EQ(read_file(scene_), scene);
    }
  }
  const std::string html = scratch_.file("trade.html");
  EXPECT_EQ(run_kinex({"import", table_, "--force", "-o", table_}).exit_code, 2);
  EXPECT_EQ(read_file(table_), table);
  EXPECT_EQ(files(), before);
  write_file(html, scene);
  const Finished trade = run_kinex({"trade", html, "--force", "-o", scratch_.path()});
  EXPECT_EQ(trade.exit_code, 2);
  EXPECT_THAT(trade.err, HasSubstr("is the input itself"));
  EXPECT_EQ(read_file(html), scene);
  EXPECT_EQ(run_kinex({"run", "-", "--force", "--events", link}, scene).exit_code, 0);
}

// The files of a sweep are the input of what is made of them: merge could replace one, with what was in it alone.
TEST_F(Output, TheFilesOfASweepAreKept) {
  namespace fs = std::filesystem;
  const std::string plan = scratch_.file("plan.json"), folder = scratch_.file("sweep");
  write_file(
      plan,
      R"({"kinex_plan": 1, "name": "p", "blocks": [{"structure": ["sorted_list"], "workload": ["grid"], "n": [4, 9]}]})");
  ASSERT_EQ(run_kinex({"sweep", "run", plan, "-o", folder}).exit_code, 0);
  std::string name;
  for (const auto& file : fs::directory_iterator(folder)) name = file.path().filename().string();
  const std::string text = read_file(folder + "/" + name), link = scratch_.file("link"),
                    around = scratch_.file("around");
  fs::create_symlink(folder + "/" + name, link);
  fs::create_directory_symlink(folder, around);
  const std::set<std::string> before = files();
  for (const std::string& output :
       {folder + "/" + name, folder + "/./" + name, around + "/" + name, link}) {
    for (const std::string& from : {folder, around}) {
      const Finished merge = run_kinex({"sweep", "merge", from, "-o", output, "--force"});
      EXPECT_EQ(merge.exit_code, 2) << output;
      EXPECT_EQ(merge.err, "kinex: --output: " + show_text(output) +
                               " is the input itself; give the output another name\n");
    }
    const Finished trade = run_kinex({"trade", "--quick", "--from", folder, "-o",
                                      scratch_.file("t"), "--markdown", output, "--force"});
    EXPECT_EQ(trade.exit_code, 2) << output;
    EXPECT_EQ(trade.err, "kinex: --markdown: " + show_text(output) +
                             " is the input itself; give the output another name\n");
    EXPECT_EQ(files(), before);
    EXPECT_EQ(read_file(folder + "/" + name), text);
  }
  const std::string database = folder + "/results.sqlite";
  EXPECT_EQ(run_kinex({"sweep", "merge", folder, "-o", database}).exit_code, 0);
  EXPECT_EQ(run_kinex({"sweep", "merge", folder, "-o", database, "--force"}).exit_code, 0);
}

// What a link leads to is written, and the link stays: a file, with the permissions that it had, or a file
// that the program has open, as by /dev/stdout.
TEST_F(Output, LinksStay) {
  namespace fs = std::filesystem;
  const std::string link = scratch_.file("link"), target = scratch_.file("target");
  write_file(target, "old");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target", link);
  EXPECT_EQ(run_kinex({"run", scene_, "--events", link}).exit_code, 2);
  EXPECT_EQ(read_file(target), "old");
  EXPECT_EQ(run_kinex({"run", scene_, "--events", link, "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_THAT(read_file(target), StartsWith("{\"format\": \"kinex-log\""));
  EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const std::string log = read_file(target), out = scratch_.file("out");
  for (const int number : {1, 3}) {
    const std::string open = scratch_.file("open" + std::to_string(number));
    fs::create_symlink("/proc/self/fd/" + std::to_string(number), open);
    for (const char* force : {"", " --force"}) {
      const std::string command = std::string(KINEX_PROGRAM) + " run '" + scene_ +
                                  "' -q --events '" + open + "'" + force + " " +
                                  std::to_string(number) + "> '" + out + "'";
      EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << command;
      EXPECT_TRUE(fs::is_symlink(open)) << command;
      EXPECT_EQ(read_file(out), log) << command;
    }
  }
}

// A link to nothing is seen before the run, not after it.
TEST_F(Output, LinksToNothing) {
  const std::string link = scratch_.file("link");
  std::filesystem::create_symlink(scratch_.file("missing"), link);
  for (const Words& writer : writers()) {
    expect_refused(writer, link, "it is a symbolic link to a file that is missing");
  }
}

// A disk that is full in the middle of a log: its whole lines are kept and named, and the next run
// is not in their way. A limit on the size of files stands for the disk.
TEST_F(Output, FullDiskKeepsWholeLines) {
  const std::string scene = scratch_.file("larger.json"), log = scratch_.file("run.log");
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "60", "-o", scene}).exit_code, 0);
  const std::string err = scratch_.file("err");
  const std::string command = "trap '' XFSZ; ulimit -f 16; " + std::string(KINEX_PROGRAM) +
                              " run '" + scene + "' --events '" + log + "' > /dev/null 2> '" + err +
                              "'";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_THAT(read_file(err), StartsWith("kinex: " + log + ": cannot be written: File too large"));
  EXPECT_THAT(read_file(err), HasSubstr("the lines that were written are in " + log + ".partial;"));
  EXPECT_FALSE(std::filesystem::exists(log));
  const std::string kept = read_file(log + ".partial");
  ASSERT_GT(kept.size(), 4000u);
  EXPECT_THAT(kept, StartsWith("{\"format\": \"kinex-log\""));
  EXPECT_EQ(kept.back(), '\n');
  const Finished check = run_kinex({"check", log + ".partial"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.err, HasSubstr("the log has no last line: it was cut off"));
  const Finished again = run_kinex({"run", scene, "--events", log});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("kinex: " + log + ".partial is of a run that was cut off"));
  EXPECT_EQ(run_kinex({"diff", log, log}).exit_code, 0);
  EXPECT_THAT(read_file(log), StartsWith(kept.substr(0, kept.find("\n"))));
  // Once more: the name of the kept lines is taken.
  const Finished third = run_kinex({"run", scene, "--events", log, "--force"});
  EXPECT_EQ(third.exit_code, 0) << third.err;
  EXPECT_EQ(read_file(log + ".partial"), kept);
}

// Leftovers of a killed run are reported, and do no harm.
TEST_F(Output, LeftoversAreTold) {
  const std::string log = scratch_.file("run.log"), left = log + ".partial-4194303";
  write_file(left, "{}\n");
  write_file(log + ".partial-notes", "mine");
  const Finished run = run_kinex({"run", scene_, "--events", log});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("kinex: " + left + " is of a run that was cut off"));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("notes")));
  EXPECT_EQ(read_file(left), "{}\n");
}

// The log is that of the file, byte by byte; the report is on standard error.
TEST_F(Output, TheLogOnStandardOutput) {
  const std::string log = scratch_.file("run.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--events", log}).exit_code, 0);
  const Finished run = run_kinex({"run", scene_, "--events", "-"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, read_file(log));
  EXPECT_THAT(run.err, HasSubstr("left out"));
  EXPECT_THAT(run.err, HasSubstr("certificate failures"));
  EXPECT_FALSE(std::filesystem::exists("-"));
  EXPECT_EQ(run_kinex({"check", "-"}, run.out).exit_code, 0);
  const Finished quiet = run_kinex({"run", "-q", scene_, "--events", "-"});
  EXPECT_EQ(quiet.out, run.out);
  EXPECT_EQ(quiet.err, "");
  for (const char* second : {"--json", "--summary"}) {
    Words both{"run", scene_, "--events", "-", second};
    if (both.back() == "--summary") both.emplace_back("-");
    const Finished refused = run_kinex(both);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err,
                HasSubstr(std::string(second) + ": standard output has the event log; give"));
    EXPECT_EQ(refused.out, "");
  }
  const Finished full = run_kinex({"run", scene_, "--events", "-"}, "", "/dev/full");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_THAT(full.err, HasSubstr("standard output: cannot be written: No space left"));
  EXPECT_EQ(run_kinex({"trade", scene_, "--markdown", "-"}).exit_code, 2);
}

TEST_F(Output, LogAndSummaryAreTwoFiles) {
  const std::set<std::string> before = files();
  const std::string file = scratch_.file("both"), same = scratch_.path().string() + "/./both";
  const Finished run = run_kinex({"run", scene_, "--events", file, "--summary", same, "--force"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("is the file of --events too; give two names"));
  EXPECT_EQ(files(), before);
  EXPECT_EQ(run_kinex({"run", scene_, "--events", "/dev/null", "--summary", "/dev/null"}).exit_code,
            0);
}

// Seen before anything is run: the tables would be written over by the results, or the reverse.
TEST_F(Output, TablesAndResultsAreTwoFiles) {
  const std::string results = scratch_.file("results"), link = scratch_.file("link");
  std::filesystem::create_directory_symlink(results, link);
  const std::set<std::string> before = files();
  for (const std::string name : {"trade.txt", "trade.html", "trade.sqlite", "trade.unfinished"}) {
    for (const std::string& file :
         {results + "/" + name, scratch_.path().string() + "/./results/" + name}) {
      for (const Words& more : {Words{}, Words{"--force"}, Words{"--fresh"}}) {
        Words command{"trade", scene_, "--arithmetic", "gsl", "-o", results, "--markdown", file};
        command.insert(command.end(), more.begin(), more.end());
        const Finished trade = run_kinex(command);
        EXPECT_EQ(trade.exit_code, 2);
        EXPECT_EQ(trade.out, "");
        EXPECT_EQ(trade.err, "kinex: --markdown: " + show_text(file) + " is the " + name +
                                 " of --output too; give two names\n");
        EXPECT_EQ(files(), before);
      }
    }
  }
  EXPECT_EQ(run_kinex({"trade", scene_, "--arithmetic", "gsl", "-o", results, "--markdown",
                       results + "/trade.md"})
                .exit_code,
            0);
  EXPECT_EQ(run_kinex({"trade", scene_, "--force", "--arithmetic", "gsl", "-o", results,
                       "--markdown", link + "/trade.txt"})
                .exit_code,
            2);
  // A scene where the records of the run would be.
  const std::string records = results + "/trade.unfinished", scene = read_file(scene_);
  write_file(records, scene);
  EXPECT_THAT(run_kinex({"trade", records, "--fresh", "--arithmetic", "gsl", "-o", results}).err,
              HasSubstr("is the input itself"));
  EXPECT_EQ(read_file(records), scene);
}

}  // namespace output_test
}  // namespace kinex
