// SPDX-License-Identifier: GPL-3.0-or-later
// The built program from outside: verbs, files, exit codes, messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <tuple>

#include "experiments/formats/json_document.h"
#include "tests/places.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace program_test {

using testing::HasSubstr;
using testing::StartsWith;

void expect_bad_input(const std::vector<std::string>& arguments, const std::string& message) {
  const Finished finished = run_kinex(arguments);
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr(message));
}

class Program : public testing::Test {
 protected:
  void SetUp() override {
    const Finished made =
        run_kinex({"gen", "uniform-square", "--n", "12", "--seed", "3", "-o", scene_});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  ScratchFolder scratch_;
  std::string scene_ = scratch_.file("scene.json");
};

TEST_F(Program, UsageErrorsExitWith2) {
  EXPECT_EQ(run_kinex({}).exit_code, 2);
  EXPECT_EQ(run_kinex({"dance"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"run"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"run", scene_, "--unheard-of"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"gen"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"gen", "uniform-square", "--n", "many"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"--version"}).exit_code, 0);
}

TEST_F(Program, EveryVerbHasHelpWithAnExample) {
  const Finished top = run_kinex({"--help"});
  EXPECT_EQ(top.exit_code, 0);
  EXPECT_THAT(top.out, HasSubstr("Example:"));
  EXPECT_THAT(top.out, HasSubstr("\n  kinex gen uniform-square"));
  // The verbs are those that the top level lists.
  std::size_t verbs = 0;
  std::istringstream list(top.out.substr(top.out.find("Subcommands:")));
  std::string line;
  for (std::getline(list, line); std::getline(list, line) && !line.empty(); ++verbs) {
    if (line.starts_with("   ")) continue;  // the rest of a long line
    std::string verb;
    std::istringstream(line) >> verb;
    const Finished help = run_kinex({verb, "--help"});
    EXPECT_EQ(help.exit_code, 0) << verb;
    EXPECT_THAT(help.out, HasSubstr("Example:")) << verb;
    // Options, and the rest of what is said of them.
    std::istringstream options(help.out);
    for (std::string one; std::getline(options, one);) {
      if (one.starts_with("  -") || one.starts_with(std::string(30, ' '))) {
        EXPECT_LE(one.size(), 80u) << verb << ": " << one;
      }
    }
    const std::string examples =
        help.out.substr(std::min(help.out.find("Example:"), help.out.size()));
    EXPECT_THAT(examples, HasSubstr("kinex " + verb + " ")) << verb;
  }
  EXPECT_GE(verbs, 7u);
}

TEST_F(Program, RunWritesLogAndSummary) {
  const std::string log = scratch_.file("run.log");
  const std::string summary = scratch_.file("run.json");
  const Finished run = run_kinex({"run", scene_, "--events", log, "--summary", summary, "--at",
                                  "1/3,0.5", "--audit", "events"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");  // no progress where there is no terminal
  EXPECT_THAT(run.out, HasSubstr("left out"));
  EXPECT_THAT(run.out, HasSubstr("numbers   exact"));
  const formats::JsonDocument parsed_document = formats::parse_json(read_file(summary), summary);
  const formats::JsonValue& parsed = *parsed_document;
  EXPECT_EQ(parsed.find("samples")->items().size(), 2u);
  const Finished check = run_kinex({"check", log});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr(parsed.find("log_digest")->text()));
  EXPECT_EQ(run_kinex({"diff", log, log}).exit_code, 0);
  for (const auto& file : std::filesystem::directory_iterator(scratch_.path())) {
    EXPECT_EQ(file.path().string().find("partial"), std::string::npos) << file.path();
  }
}

// The report says of which objects a structure is, and an object that jumps leaves and comes again.
TEST_F(Program, TheReportSaysWhatIsMaintained) {
  const std::string scene = scratch_.file("jump.json");
  write_file(
      scene,
      R"({"kinex": 1, "name": "j", "dimension": 2, "time": {"start": 0, "end": 4}, "jumps": true,
 "objects": [
  {"id": "a", "colour": "red", "motion": [{"to": 2, "coordinates": [[0], [0]]},
                                          {"from": 2, "coordinates": [[9], [0]]}]},
  {"id": "b", "colour": "red", "motion": [[1], [1]]},
  {"id": "c", "colour": "blue", "motion": [[2], [1, 1]]},
  {"id": "d", "colour": "blue", "motion": [[3], [7]]}],
 "maintain": [{"structure": "closest_pair_all", "of": "red", "as": "mine"}]})");
  const Finished given = run_kinex({"run", scene});
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_THAT(given.out, HasSubstr("maintain  closest_pair_all {\"of\": \"red\"} as \"mine\"\n"));
  EXPECT_THAT(given.out, HasSubstr("plan      0 changes, 1 insertion, 1 erasure\n"));
  // As kinex gen --maintain does: the two colours of the scene.
  const Finished two = run_kinex({"run", scene, "--maintain", "bichromatic_pair_all", "--at", "1"});
  EXPECT_THAT(two.out,
              HasSubstr("maintain  bichromatic_pair_all {\"colours\": [\"red\", \"blue\"]}\n"));
  EXPECT_THAT(two.out, HasSubstr("[[\"b\", \"c\"]]"));
}

TEST_F(Program, StandardOutputIsJsonWhenAskedFor) {
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--json"}, std::vector<std::string>{"--summary", "-"}}) {
    std::vector<std::string> arguments{"run", scene_};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Finished run = run_kinex(arguments);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NO_THROW(formats::parse_json(run.out, "out")) << run.out;
    EXPECT_THAT(run.err, HasSubstr("left out"));
  }
}

TEST_F(Program, UnreadableInputs) {
  for (const char* verb : {"run", "check", "roots", "import"}) {
    expect_bad_input({verb, scratch_.file("missing")}, "missing: cannot be read: No such file");
    expect_bad_input({verb, scratch_.path().string()}, "it is a directory; give a file");
  }
  expect_bad_input({"diff", scene_, scene_}, "does not begin an event log; make one with");
}

// Ten megabytes that are nothing: refused soon, by every verb that reads.
TEST_F(Program, BinaryGarbage) {
  std::string garbage(10 << 20, '\0');
  std::uint64_t state = 88172645463325252u;  // xorshift64
  for (char& byte : garbage) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    byte = static_cast<char>(state >> 32);
  }
  const std::string path = scratch_.file("garbage");
  write_file(path, garbage);
  for (const char* verb : {"run", "check", "roots", "import"}) {
    expect_bad_input({verb, path}, "kinex: " + path + ": line ");
  }
  expect_bad_input({"diff", path, path}, path + ": line 1");
}

TEST_F(Program, DeepNestingAndLongNumbers) {
  const std::string deep = scratch_.file("deep.json");
  write_file(deep, std::string(5000000, '['));
  expect_bad_input({"check", deep}, "nested deeper than 64 levels");
  const std::string text =
      R"({"kinex": 1, "dimension": 1, "time": {"start": 0}, "objects": [{"id": "a", "motion": [[")";
  write_file(deep, text + std::string(1000001, '7') + "\"]]}]}");
  expect_bad_input({"check", deep}, "/objects/0/motion/0/0: a number of more than 1000000");
  write_file(deep, text + std::string(100000, '7') + "\"]]}]}");
  EXPECT_EQ(run_kinex({"check", deep}).exit_code, 0);
}

TEST_F(Program, BadOptionValues) {
  expect_bad_input({"run", scene_, "--arithmetic", "abacus"}, "--arithmetic");
  expect_bad_input({"run", scene_, "--arithmetic", "mpfr:1"}, "--arithmetic");
  expect_bad_input({"run", scene_, "--maintain", "tap"}, "kinex list structures names them");
  expect_bad_input({"run", scene_, "--until", "soon"}, "--until: \"soon\" is not a number");
  expect_bad_input({"run", scene_, "--until", "2"}, "--until: \"2\" is outside");
  expect_bad_input({"run", scene_, "--at", "1/2,-1"}, "--at: \"-1\" is outside");
  expect_bad_input({"run", scene_, "--audit", "never"}, "--audit: \"never\" is not a level");
  expect_bad_input({"run", scene_, "--max-events", "-1"},
                   "kinex: --max-events: -1 is below 0; write a number from 0 on, 0 for no limit");
  for (const char* verb : {"run", "view"}) {
    expect_bad_input({verb, scene_, "--max-events", "18446744073709551616"},
                     "--max-events: \"18446744073709551616\" is not a whole number that fits; write one, as 100");
  }
  expect_bad_input({"run", scene_, "--max-seconds", "-2.5"}, "kinex: --max-seconds: -2.5 is below 0; write a number from");
  expect_bad_input({"trade", scene_, "--max-seconds", "-1"},
                   "kinex: --max-seconds: -1 is not above 0; write a number above 0, or leave it out for 120");
  expect_bad_input({"trade", scene_, "--max-seconds", "0"}, "kinex: --max-seconds: 0 is not above 0");
  expect_bad_input({"run", scene_, "--until", "1e999999999"},
                   "--until: \"1e999999999\" has an exponent beyond 100000; write a number with an exponent from -100000 to 100000");
  expect_bad_input({"run", scene_, "--max-seconds", "soon"},
                   "--max-seconds: \"soon\" is not a number; write one, as 2.5");
  expect_bad_input({"gen", "grid", "--n", "3.5"}, "--n: \"3.5\" is not a whole number that fits");
  expect_bad_input({"gen", "polygon-fan", "--n", "3", "--m", "3", "--separation", "1e30"},
                   "polygon-fan cannot be made of these sizes: ");
  expect_bad_input({"gen", "swarm"}, "\"swarm\" is not a workload");
  expect_bad_input({"roots", scene_, "--digits", "-1"}, "--digits");
}

TEST_F(Program, NumbersOutOfRangeAreNotTakenForOthers) {
  for (const char* seed : {"-1", "18446744073709551616", "1.5", "many"}) {
    expect_bad_input({"gen", "grid", "--seed", seed},
                     std::string("--seed: \"") + seed +
                         "\" is not a seed; write an integer from 0 to 18446744073709551615");
  }
  EXPECT_EQ(run_kinex({"gen", "grid", "--n", "3", "--seed", "18446744073709551615"}).exit_code, 0);
  expect_bad_input({"gen", "grid", "--n", "0"},
                   "--n: 0 objects; write a number from 1 to 10000000");
  expect_bad_input({"gen", "hull-worst", "--m", "0"},
                   "--m: 0 is out of range; write a number from 1 to 10000000");
  expect_bad_input({"gen", "grid", "--m", "0"}, "--m: this workload has one size only");
  expect_bad_input({"gen", "grid", "--dimension", "0"},
                   "--dimension: 0 is out of range; write a number from 1 to 3");
  expect_bad_input({"verify", "sorted_list", "--seeds", "0"},
                   "--seeds: 0 is out of range; write a number from 1 to 1000000");
  expect_bad_input({"run", scene_, "--max-seconds", "nan"}, "--max-seconds: nan is not a number; write a number from 0 on");
  expect_bad_input({"trade", scene_, "--max-seconds", "nan"}, "--max-seconds: nan is not a number; write a number above 0");
}

TEST_F(Program, LimitsExitWith3AndLeaveAReadableLog) {
  const std::string log = scratch_.file("run.log");
  const Finished run = run_kinex({"run", scene_, "--events", log, "--max-events", "5"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("the run was stopped: the limit of --max-events is reached"));
  const Finished check = run_kinex({"check", log});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("run       limit"));
  EXPECT_THAT(check.out, HasSubstr("records   5 log records,"));
}

TEST_F(Program, InterruptLeavesAReadableLog) {
  const std::string large = scratch_.file("large.json");
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "20000", "-o", large}).exit_code, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string log = scratch_.file("large-" + std::to_string(signal) + ".log");
    const std::string summary = scratch_.file("large-" + std::to_string(signal) + ".json");
    const Finished run =
        run_kinex({"run", large, "--events", log, "--summary", summary}, "", "", log, signal);
    EXPECT_EQ(run.exit_code, 3) << run.err;
    EXPECT_THAT(run.err, HasSubstr("the run was stopped: interrupted; what was finished is in"));
    const std::string text = read_file(log);
    ASSERT_GT(text.size(), 200u);
    EXPECT_THAT(text.substr(text.size() - 400), HasSubstr("{\"end\": \"interrupted\""));
    EXPECT_EQ(run_kinex({"diff", log, log}).exit_code, 0);
    EXPECT_EQ(formats::parse_json(read_file(summary), summary)->find("status")->text(), "interrupted");
  }
}

// Long enough for several lines of progress: they are for people, not for files.
TEST_F(Program, ProgressIsForTerminalsOnly) {
  const std::string large = scratch_.file("large.json");
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "20000", "-o", large}).exit_code, 0);
  const Finished plain = run_kinex({"run", large, "--max-seconds", "1.5"});
  EXPECT_EQ(plain.exit_code, 3) << plain.err;
  EXPECT_THAT(plain.err, testing::Not(HasSubstr("a second")));
  EXPECT_THAT(plain.out, testing::Not(HasSubstr("a second")));
  const std::string command =
      std::string(KINEX_PROGRAM) + " run " + large + " --max-seconds 6 --json > /dev/null";
  const std::string terminal = scratch_.file("terminal");
  const std::string script =
      "script -qc '" + command + "' " + terminal + " < /dev/null > /dev/null";
  ASSERT_EQ(std::system(script.c_str()), 0);
  const std::string shown = read_file(terminal);
  EXPECT_THAT(shown, testing::ContainsRegex("\r.*certificate failures, t = 0[.0-9]*, .* a second, .* s left"));
  EXPECT_THAT(shown, HasSubstr("\r\x1b[K"));  // and the line is wiped
}

TEST_F(Program, CheckInJson) {
  const std::string log = scratch_.file("a.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--events", log}).exit_code, 0);
  const Finished scene = run_kinex({"check", "--json", scene_});
  EXPECT_EQ(scene.exit_code, 0);
  EXPECT_EQ(formats::parse_json(scene.out, "out")->find("kind")->text(), "scene");
  EXPECT_EQ(run_kinex({"check", "--json", log}).exit_code, 0);
  std::string tampered = read_file(log);
  tampered.replace(tampered.find("\"digest\": \"") + 11, 4, "0000");
  write_file(log, tampered);
  const Finished broken = run_kinex({"check", "--json", log});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.out, HasSubstr("\"kind\": \"log\", \"valid\": false"));
  EXPECT_EQ(formats::parse_json(broken.out, "out")->find("problems")->items().size(), 2u);  // and the seal
}

TEST_F(Program, DiffShowsBothLines) {
  const std::string a = scratch_.file("a.log");
  const std::string b = scratch_.file("b.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--events", a}).exit_code, 0);
  ASSERT_EQ(run_kinex({"run", scene_, "--events", b, "--until", "1/2"}).exit_code, 0);
  const Finished diff = run_kinex({"diff", a, b});
  EXPECT_EQ(diff.exit_code, 1);
  EXPECT_THAT(diff.out, HasSubstr(b + ": has ended"));
  EXPECT_THAT(diff.out, HasSubstr(" 0 invented, 0 out of order, 0 with another effect, 0 at another instant; "
                                  "instants compared exactly\n"));
}

// Records are counted, as run counts those of the log; of instants it says nothing where it compares none.
TEST_F(Program, DiffCountsRecords) {
  const std::string scene = scratch_.file("grid.json"), a = scratch_.file("a.log"), b = scratch_.file("b.log");
  ASSERT_EQ(run_kinex({"gen", "grid", "--n", "36", "--maintain", "delaunay_2", "-o", scene}).exit_code, 0);
  const Finished exact = run_kinex({"run", scene, "--events", a});
  EXPECT_THAT(exact.out, HasSubstr("done: 269 events "));
  EXPECT_THAT(exact.out, HasSubstr("; 281 log records;"));
  EXPECT_EQ(run_kinex({"diff", a, a}).out, "equal: 281 records; instants compared exactly\n");
  run_kinex({"run", scene, "--arithmetic", "double", "--events", b});
  const Finished diff = run_kinex({"diff", a, b});
  EXPECT_EQ(diff.exit_code, 1);
  EXPECT_THAT(diff.out, testing::StartsWith(b + ": delaunay_2 is corrupt: "));
  EXPECT_THAT(diff.out, HasSubstr("\nfirst difference at record 11\n"));
  EXPECT_THAT(diff.out, testing::ContainsRegex("\n281 and [0-9]+ records: [^\n]* with another effect; instants not compared\n"));
  EXPECT_THAT(diff.out, testing::Not(HasSubstr("at another instant")));
  EXPECT_THAT(run_kinex({"diff", "-v", a, b}).err, testing::ContainsRegex("flip: [0-9]+ and [0-9]+ records, "));
}

TEST_F(Program, RootsInJson) {
  const Finished roots = run_kinex({"roots", "-", "--json", "--digits", "8"},
                                   "2 -2 0 1\n3 2/9 -11/9 4/3 1\n2 1 0 1\n");
  EXPECT_EQ(roots.exit_code, 0) << roots.err;
  std::vector<formats::JsonDocument> lines;
  for (std::size_t at = 0; at < roots.out.size(); at = roots.out.find('\n', at) + 1) {
    lines.push_back(formats::parse_json(roots.out.substr(at, roots.out.find('\n', at) - at), "out"));
  }
  ASSERT_EQ(lines.size(), 3u);
  const auto first = lines[0]->find("roots")->items();
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].find("decimal")->text(), "-1.41421356");
  EXPECT_EQ(first[1].find("decimal")->text(), "1.41421356");
  EXPECT_EQ(first[1].find("interval")->items().size(), 2u);
  const auto second = lines[1]->find("roots")->items();  // (t - 1/3)^2 (t + 2)
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(second[0].find("multiplicity")->text(), "1");
  EXPECT_EQ(second[1].find("multiplicity")->text(), "2");
  EXPECT_EQ(second[1].find("decimal")->text(), "0.33333333");
  EXPECT_TRUE(lines[2]->find("roots")->items().empty());
}

TEST_F(Program, ImportMakesAScene) {
  const Finished made = run_kinex({"import", "-", "--name", "two"},
                                  "id,t,x,y\na,0,0,0\na,1,1,1\nb,0.5,0,1\nb,1,0,0\nc,0,0,0\n");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("kinex: 1 trace of a single fix was left out: \"c\" (line 6)\n"));
  const Finished run = run_kinex({"run", "-", "--audit", "events"}, made.out);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("0 changes, 1 insertion, 0 erasures\n"));
}

// --maintain and --fixed as they are written on a command line.
TEST_F(Program, MaintainInJsonAndFixedObjects) {
  const std::string table = "id,x,y,vx,vy\na,1,0,1,0\nb,3,0,-1,0\n";
  const std::string entry =
      R"({"structure":"minimum_tournament","key":{"squared_distance_to":"Sun"},"as":"nearest"})";
  const std::vector<std::string> import_arguments{
      "import", "-", "--fixed", "Sun,0,0", "--fixed", "Moon,2.25,0", "--end", "3", "--maintain"};
  const auto with = [](std::vector<std::string> arguments, const std::string& last) {
    arguments.push_back(last);
    return arguments;
  };
  const Finished made = run_kinex(with(import_arguments, entry + ",sorted_list:y"), table);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("2 rows, 4 objects"));
  // |1 + t| = |3 - t| at 1: a is the nearest until then, b afterwards; the Sun itself never is.
  const Finished run = run_kinex({"run", "-", "--at", "0,1/2,3/2,3"}, made.out);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* line : {"at 0  nearest \"a\"", "at 1/2  nearest \"a\"", "at 3/2  nearest \"b\"",
                           "at 3  nearest \"b\""}) {
    EXPECT_THAT(run.out, HasSubstr(line));
  }
  const Finished other = run_kinex({"run", "-", "--maintain", entry, "--at", "2"}, made.out);
  EXPECT_THAT(other.out, HasSubstr("at 2  nearest \"b\""));
  EXPECT_THAT(other.out, testing::Not(HasSubstr("sorted_list")));
  const Finished generated =
      run_kinex({"gen", "grid", "--n", "4", "--maintain",
                 R"({"structure":"sorted_list","key":{"direction":[1,2]}},delaunay_2)"});
  EXPECT_EQ(generated.exit_code, 0) << generated.err;
  EXPECT_THAT(generated.out, HasSubstr(R"({"direction": [1, 2]}}, "delaunay_2"])"));
  const Finished refused = run_kinex({"import", "-", "--fixed", "Sun,0"}, table);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("--fixed: \"Sun,0\" has 2 fields, not 3; write ID,X,Y"));
  for (const auto& [option, value, place] :
       {std::tuple("--fixed", "Sun,0,1e999999999", "--fixed: \"1e999999999\" in \"Sun,0,1e999999999\""),
        {"--end", "1e999999999", "--end: \"1e999999999\""}}) {
    const Finished large = run_kinex({"import", "-", option, value}, table);
    EXPECT_EQ(large.exit_code, 2);
    EXPECT_THAT(large.err, HasSubstr(std::string(place) + " has an exponent beyond 100000; write a number with an exponent "
                                                          "from -100000 to 100000"));
  }
}

// Inexact arithmetics may fail, but in an orderly way.
TEST_F(Program, EveryArithmeticRuns) {
  for (const char* arithmetic : {"exact", "sturm", "double", "gsl", "mpfr:100"}) {
    const std::string log = scratch_.file(std::string(arithmetic, 3) + ".log");
    const Finished run = run_kinex({"run", scene_, "--arithmetic", arithmetic, "--events", log});
    EXPECT_EQ(run.exit_code, 0) << arithmetic << run.err;
    EXPECT_EQ(run_kinex({"check", log}).exit_code, 0) << arithmetic;
  }
  EXPECT_EQ(run_kinex({"diff", scratch_.file("exa.log"), scratch_.file("stu.log")}).exit_code, 0);
  EXPECT_EQ(run_kinex({"diff", scratch_.file("exa.log"), scratch_.file("dou.log")}).exit_code, 0);
}

// A structure that an inexact arithmetic sends from one rebuild to the next: more of them than there are instants that
// could explain them. In exact arithmetic each rebuild has its degenerate instant, however many there are.
TEST_F(Program, NamesStructuresThatAreRebuiltAgainAndAgain) {
  const auto report = [&](const std::vector<std::string>& gen, const char* arithmetic) {
    const std::string scene = scratch_.file("scene.json");
    std::vector<std::string> command{"gen"};
    command.insert(command.end(), gen.begin(), gen.end());
    command.insert(command.end(), {"--maintain", "delaunay_2", "-o", scene, "--force"});
    EXPECT_EQ(run_kinex(command).exit_code, 0);
    return run_kinex({"run", scene, "--arithmetic", arithmetic, "--audit", "none"}).out;
  };
  const std::vector<std::string> collinear{"collinear-instant", "--n", "40"};
  const std::string inexact = report(collinear, "double");
  EXPECT_THAT(inexact, HasSubstr("\nwarning   delaunay_2 was rebuilt "));
  EXPECT_THAT(inexact, HasSubstr(" explain 1 at most: its counts are those of rebuilds rather than of repairs; "
                                 "compare with --arithmetic exact\n"));
  for (const std::string& exact : {report(collinear, "exact"), report({"grid", "--n", "400"}, "exact")}) {
    EXPECT_THAT(exact, HasSubstr("\nrebuilt   delaunay_2, "));
    EXPECT_THAT(exact, testing::Not(HasSubstr("warning")));
  }
}

}  // namespace program_test
}  // namespace kinex
