// SPDX-License-Identifier: GPL-3.0-or-later
// kinex view from outside: pages of scenes and logs, bad input, limits, files that exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/spawn.h"

namespace kinex {
namespace view_verb_test {

using testing::HasSubstr;
using testing::StartsWith;

class ViewVerb : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "near-one-point", "--n", "6", "--dimension", "1", "--maintain",
                         "sorted_list,maximum_heap", "-o", scene_})
                  .exit_code,
              0);
    ASSERT_EQ(run_kinex({"run", scene_, "--events", log_}).exit_code, 0);
  }
  // Refused with this message and no page.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& message,
                      int exit_code = 2) {
    std::vector<std::string> command{"view"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Finished finished = run_kinex(command);
    EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
    EXPECT_EQ(finished.out, "");
    EXPECT_THAT(finished.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(page_));
    for (const auto& file : std::filesystem::directory_iterator(scratch_.path())) {
      EXPECT_EQ(file.path().string().find("partial"), std::string::npos) << file.path();
    }
  }

  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
  const std::string log_ = scratch_.file("exact.jsonl");
  const std::string page_ = scratch_.file("page.html");
};

TEST_F(ViewVerb, MakesAPageOfASceneAndOfALog) {
  const Finished finished = run_kinex({"view", scene_, "-o", page_});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("run       exact, "));
  const std::string page = read_file(page_);
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("\"format\": \"kinex-view\""));
  // The same of its log, and on standard output.
  const Finished of_log = run_kinex({"view", log_, "--scene", scene_, "-o", "-"});
  EXPECT_EQ(of_log.exit_code, 0) << of_log.err;
  EXPECT_EQ(of_log.out, page);
}

TEST_F(ViewVerb, ASceneWithoutAName) {
  write_file(scene_, R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 1}, "objects": [],
                         "maintain": ["delaunay_2"]})");
  const Finished finished = run_kinex({"view", scene_, "-o", page_});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("scene     (no name), 0 objects\n"));
  EXPECT_THAT(read_file(page_), HasSubstr("<title>kinex view: (no name)</title>"));
}

TEST_F(ViewVerb, LaysASecondRunOverIt) {
  const std::string other = scratch_.file("double.jsonl");
  run_kinex({"run", scene_, "--arithmetic", "double", "--events", other});
  const Finished by_log = run_kinex({"view", log_, "--scene", scene_, "--with", other, "-o", "-"});
  const Finished by_name = run_kinex({"view", scene_, "--with", "double", "-o", page_});
  EXPECT_EQ(by_log.exit_code, 0) << by_log.err;
  EXPECT_EQ(by_name.exit_code, 0) << by_name.err;
  EXPECT_THAT(by_name.out, HasSubstr("compared  the runs part at log record "));
  EXPECT_EQ(by_log.out, read_file(page_));
  EXPECT_THAT(run_kinex({"view", scene_, "--with", "sturm", "-o", page_, "--force"}).out,
              HasSubstr("compared  the same log records"));
}

TEST_F(ViewVerb, NeverReplacesAFile) {
  EXPECT_EQ(run_kinex({"view", scene_, "-o", page_}).exit_code, 0);
  const std::string before = read_file(page_);
  const Finished again = run_kinex({"view", scene_, "--with", "double", "-o", page_});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("exists already; give another name, or --force"));
  EXPECT_EQ(read_file(page_), before);
  EXPECT_EQ(run_kinex({"view", scene_, "--with", "double", "-o", page_, "--force"}).exit_code, 0);
  EXPECT_NE(read_file(page_), before);
  const std::string scene = read_file(scene_);
  for (const std::string& input : {scene_, log_}) {
    const Finished over = run_kinex({"view", log_, "--scene", scene_, "-o", input, "--force"});
    EXPECT_EQ(over.exit_code, 2);
    EXPECT_THAT(over.err, HasSubstr("is the input itself"));
  }
  EXPECT_EQ(read_file(scene_), scene);
}

TEST_F(ViewVerb, BadInput) {
  expect_refused({scene_}, "--output");
  expect_refused({scratch_.file("none.json"), "-o", page_}, "cannot be read");
  expect_refused({log_, "-o", page_}, "give the scene too: --scene SCENE.json");
  expect_refused({scene_, "--scene", scene_, "-o", page_}, "is a scene itself");
  expect_refused({log_, "--scene", log_, "-o", page_}, "");
  expect_refused({log_, "--scene", scene_, "--arithmetic", "gsl", "-o", page_}, "--arithmetic");
  expect_refused({scene_, "--arithmetic", "exakt", "-o", page_}, "unknown arithmetic \"exakt\"");
  expect_refused({scene_, "--arithmetic", std::string(999, 'x'), "-o", page_},
                 "unknown arithmetic \"" + std::string(40, 'x') + "\" (999 bytes); ");
  expect_refused({scene_, "--with", "exakt", "-o", page_},
                 "--with: \"exakt\" is neither an arithmetic nor a file; write exact, sturm");
  expect_refused({scene_, "--with", "mpfr:many", "-o", page_}, "--with: ");
  expect_refused({scene_, "--with", scene_, "-o", page_}, "does not begin an event log");
  expect_refused({scene_, "--maintain", "delaunay_2", "-o", page_}, "the scene has 1");
  expect_refused({scene_, "--from", "2", "-o", page_}, "--from: \"2\" is outside");
  expect_refused({scene_, "--from", "1", "-o", page_}, "nothing is left");
  expect_refused({scene_, "--from", "1/2", "--until", "1/2", "-o", page_}, "nothing is left");
  expect_refused({scene_, "--max-events", "0", "-o", page_}, "--max-events");
  expect_refused({scene_, "-o", scratch_.file("no/such/page.html")}, "cannot be written");
}

TEST_F(ViewVerb, ALogOfSomethingElse) {
  const std::string other = scratch_.file("other.json");
  ASSERT_EQ(run_kinex({"gen", "meet", "--n", "6", "--dimension", "1", "--maintain",
                       "sorted_list,maximum_heap", "-o", other})
                .exit_code,
            0);
  expect_refused({log_, "--scene", other, "-o", page_}, "it is a log of another scene");
  for (const char* maintain :
       {"sorted_list", "maximum_heap,sorted_list", "sorted_list,minimum_heap",
        "sorted_list,maximum_heap,maximum_tournament"}) {
    expect_refused(
        {log_, "--scene", scene_, "--maintain", maintain, "-o", page_},
        "--maintain: " + log_ + " is a log of sorted_list, maximum_heap; leave --maintain");
  }
  // A second log of something else.
  const std::string second = scratch_.file("second.jsonl");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--events", second}).exit_code,
            0);
  expect_refused({log_, "--scene", scene_, "--with", second, "-o", page_},
                 "the log is of sorted_list, the page of sorted_list, maximum_heap");
}

// What the run had instead of what the scene says, it has again.
TEST_F(ViewVerb, TheLogSaysWhatIsMaintained) {
  const std::string log = scratch_.file("other.jsonl");
  for (const char* maintain :
       {"maximum_tournament", "minimum_tournament,sorted_list:x", "maximum_sorted_list",
        R"({"structure": "maximum_heap", "as": "the highest, of \"all\""},sorted_list)",
        "maximum_heap,sorted_list"}) {
    SCOPED_TRACE(maintain);
    ASSERT_EQ(
        run_kinex({"run", scene_, "--maintain", maintain, "--events", log, "--force"}).exit_code,
        0);
    const Finished with =
        run_kinex({"view", log, "--scene", scene_, "--maintain", maintain, "-o", "-"});
    const Finished without = run_kinex({"view", log, "--scene", scene_, "-o", "-"});
    EXPECT_EQ(with.exit_code, 0) << with.err;
    EXPECT_EQ(without.exit_code, 0) << without.err;
    EXPECT_EQ(with.out, without.out);
    // Beneath the run of the scene, too.
    const Finished second = run_kinex({"view", scene_, "--with", log, "-o", "-"});
    EXPECT_EQ(second.exit_code, 0) << second.err;
  }
}

// A log holds no keys: those of the scene are taken, or the first axis.
TEST_F(ViewVerb, KeysOfALog) {
  const std::string scene = scratch_.file("keys.json"), log = scratch_.file("keys.jsonl");
  const std::string by_y = R"({"structure": "sorted_list", "key": "y", "as": "order"})";
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "6", "--seed", "3", "--maintain",
                       by_y + ",delaunay_2", "-o", scene})
                .exit_code,
            0);
  const auto run = [&](const std::string& maintain) {
    return run_kinex({"run", scene, "--maintain", maintain, "--events", log, "--force"}).exit_code;
  };
  const auto view = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"view", log, "--scene", scene, "-o", "-"};
    command.insert(command.end(), more.begin(), more.end());
    return run_kinex(command);
  };
  ASSERT_EQ(run(by_y), 0);  // one of the two
  EXPECT_EQ(view({}).exit_code, 0) << view({}).err;
  ASSERT_EQ(run("sorted_list:y,maximum_heap"), 0);
  EXPECT_EQ(view({}).exit_code, 0) << view({}).err;
  const std::string aslant = R"({"structure": "sorted_list", "key": {"direction": [1, 1]}})";
  ASSERT_EQ(run(aslant), 0);
  EXPECT_EQ(view({}).exit_code, 0) << view({}).err;  // the log's header has the key
  EXPECT_EQ(view({"--maintain", aslant}).exit_code, 0);
}

// A structure that this program does not have.
TEST_F(ViewVerb, ALogOfAnUnknownStructure) {
  std::string text = read_file(log_);
  const std::string name = "\"structure\": \"sorted_list\"";
  text.replace(text.find(name), name.size(), "\"structure\": \"sorted_lust\"");
  write_file(log_, text);
  expect_refused({log_, "--scene", scene_, "-o", page_},
                 log_ + ": line 1: \"sorted_lust\" is not a known structure");
}

TEST_F(ViewVerb, ALogThatIsNotWhatTheSceneGives) {
  const std::string log = read_file(log_);
  const std::string changed = scratch_.file("changed.jsonl");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = log;
    const std::size_t at = text.find(from, text.find("\"seq\": 3"));
    text.replace(at, from.size(), to);
    write_file(changed, text);
  };
  with("\"kind\": \"swap\"", "\"kind\": \"tie\"");
  expect_refused({changed, "--scene", scene_, "-o", page_}, "part at record 3: other kind", 1);
  with("\"external\": true", "\"external\": false");
  expect_refused({changed, "--scene", scene_, "-o", page_}, "other effect", 1);
  with("\"ids\": [\"p", "\"ids\": [\"q");
  expect_refused({changed, "--scene", scene_, "-o", page_}, "other objects", 1);
  with("\"root\": 1", "\"root\": 2");
  expect_refused({changed, "--scene", scene_, "-o", page_}, "other time", 1);
  // An event more than the run has.
  std::string more = log;
  const std::size_t end = more.find("{\"end\"");
  const std::size_t last = more.rfind('\n', end - 2) + 1;
  more.insert(end, more.substr(last, end - last));
  write_file(changed, more);
  expect_refused({changed, "--scene", scene_, "-o", page_}, "no such record", 1);
}

// What left the attribute and joined it, where the ids do not tell.
TEST_F(ViewVerb, ALogWithAnotherDifference) {
  const std::string scene = scratch_.file("meet.json"), log = scratch_.file("meet.jsonl");
  ASSERT_EQ(
      run_kinex({"gen", "meet", "--n", "6", "--seed", "1", "--maintain", "delaunay_2", "-o", scene})
          .exit_code,
      0);
  ASSERT_EQ(run_kinex({"run", scene, "--events", log}).exit_code, 0);
  ASSERT_EQ(run_kinex({"view", log, "--scene", scene, "-o", scratch_.file("fine")}).exit_code, 0);
  const std::string text = read_file(log), changed = scratch_.file("changed.jsonl");
  for (const char* side : {"\"gone\": [[\"p0\"", "\"came\": [[\"p1\""}) {
    std::string other = text;
    const std::size_t at = other.find(side);
    ASSERT_NE(at, other.npos) << side;
    other.replace(at + std::string(side).size() - 3, 2, "p3");
    write_file(changed, other);
    expect_refused({changed, "--scene", scene, "-o", page_}, "other difference", 1);
  }
}

// A log that was stopped is shown as far as it goes.
TEST_F(ViewVerb, AShortLog) {
  const std::string log = scratch_.file("short.jsonl");
  EXPECT_EQ(run_kinex({"run", scene_, "--max-events", "4", "--events", log}).exit_code, 3);
  const Finished finished = run_kinex({"view", log, "--scene", scene_, "-o", page_});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("(not all: the log ends here)"));
}

TEST_F(ViewVerb, LimitsAreToldAndKept) {
  const Finished finished = run_kinex({"view", scene_, "--max-events", "5", "-o", page_});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_THAT(finished.out, HasSubstr("exact, 5 log records"));
  EXPECT_THAT(finished.err, HasSubstr("--from and --until, or more with --max-events"));
  EXPECT_THAT(read_file(page_), HasSubstr("it has more than 5 log records"));
  const Finished later =
      run_kinex({"view", scene_, "--from", "3/4", "--until", "7/8", "-o", page_, "--force"});
  EXPECT_EQ(later.exit_code, 0) << later.err;
  EXPECT_THAT(later.out, HasSubstr("exact, 0 log records after "));
}

// Scenes of rigid polygons; the log names derived objects.
TEST_F(ViewVerb, Bodies) {
  const std::string bodies = scratch_.file("bodies.json"), log = scratch_.file("bodies.jsonl");
  ASSERT_EQ(run_kinex({"gen", "polygon-random", "--n", "9", "--m", "8", "--seed", "3", "--maintain",
                       "separation_mixed,closest_features", "-o", bodies})
                .exit_code,
            0);
  ASSERT_EQ(run_kinex({"run", bodies, "--events", log}).exit_code, 0);
  const Finished of_scene = run_kinex({"view", bodies, "--with", "double", "-o", page_});
  EXPECT_EQ(of_scene.exit_code, 0) << of_scene.err;
  const Finished of_log =
      run_kinex({"view", log, "--scene", bodies, "--with", "double", "-o", "-"});
  EXPECT_EQ(of_log.exit_code, 0) << of_log.err;
  EXPECT_EQ(of_log.out, read_file(page_));
  EXPECT_THAT(of_log.out, HasSubstr("\"polygons\": [[["));
  // The bodies meet by other features than the log says.
  std::string text = read_file(log);
  const std::size_t contact = text.find("\"kind\": \"contact\"", text.find("\"seq\": 1"));
  ASSERT_NE(contact, std::string::npos);
  const std::size_t feature = text.find("\"b.", contact);
  text.replace(feature, 3, "\"c.");
  write_file(log, text);
  std::filesystem::remove(page_);
  expect_refused({log, "--scene", bodies, "-o", page_}, "other objects", 1);
  expect_refused({bodies, "--maintain", "separation_minkowski", "-o", page_},
                 "do not turn against each other");
  expect_refused({bodies, "--maintain", "delaunay_2", "-o", page_}, "bodies");
}

TEST_F(ViewVerb, MoreObjectsThanAPageDraws) {
  const std::string many = scratch_.file("many.json");
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "20001", "--dimension", "1", "--maintain",
                       "maximum_heap", "-o", many})
                .exit_code,
            0);
  expect_refused({many, "-o", page_}, "20001 objects, and a page draws 20000 at most", 3);
}

}  // namespace view_verb_test
}  // namespace kinex
