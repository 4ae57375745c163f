// SPDX-License-Identifier: GPL-3.0-or-later
// What a person types, mistypes and reads: list, explain, help, log, messages, -q, -v, --color.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "experiments/formats/json_document.h"
#include "structures/family_summary.h"
#include "structures/registry.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace typing_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

std::vector<std::string> first_words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    words.push_back(line.substr(0, line.find(' ')));
  return words;
}

class Typing : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "12", "-o", scene_}).exit_code, 0);
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json"), log_ = scratch_.file("run.log");
};

// One line that begins "kinex: ", and says what to do instead.
TEST_F(Typing, MistakesOnTheCommandLine) {
  const std::string plan = scratch_.file("plan.json");
  write_file(plan, "{\"kinex_plan\": 1, \"cells\": []}");
  const std::vector<std::pair<Words, std::string>> mistakes{
      {{}, "no verb is given; write one of run, check"},
      {{"rnu"}, "\"rnu\" is not a verb; did you mean run? kinex help lists them"},
      {{"swim"}, "\"swim\" is not a verb; write one of run"},
      {{"sweep", "lst"},
       "sweep: \"lst\" is not a verb; did you mean list? kinex help sweep lists them"},
      {{"sweep"}, "sweep: no verb is given; write one of list"},
      {{"run"}, "run: SCENE is missing: scene file, - reads standard input; write kinex run SCENE"},
      {{"view", scene_},
       "view: --output is missing; write -o FILE.html, as in kinex view square.json -o square.html "
       "(kinex help view"},
      {{"sweep", "run", "plan.json"}, "sweep run: --output is missing; write -o FOLDER"},
      {{"run", scene_, "--maximum"}, "run: \"--maximum\" is not an option; "},
      {{"run", scene_, "--untli", "1"},
       "run: \"--untli\" is not an option; did you mean --until? kinex help run"},
      {{"run", scene_, "-o", "x"},
       "kinex: run: \"-o\" is not an option; write --events FILE for the event log, --summary FILE "
       "for the summary ("},
      {{"run", scene_, "--output=x"}, "run: \"--output\" is not an option; write --events FILE"},
      {{"run", scene_, "--maintain", "separation_mixed"},
       "kinex: --maintain: \"separation_mixed\" is for convex polygons, the scene has points; "
       "maintain a structure for points "
       "(kinex list structures), or give the objects polygons (kinex import --polygons)\n"},
      {{"run", plan}, ": this is a plan, not a scene; run a plan by kinex sweep run"},
      {{"sweep", "run", scene_, "-o", scene_ + ".out"},
       ": this is a scene, not a plan; run the scene by kinex run; a plan names workloads, of "
       "which kinex sweep run makes scenes"},
      {{"gen", "grid", "--sead=3"}, "gen: \"--sead\" is not an option; did you mean --seed?"},
      {{"diff", scene_, scene_, scene_}, "is more than it takes; leave it out"},
      {{"gen", "grid", "--n"}, "gen: --n has no value; write --n VALUE"},
      {{"gen", "grid", "--n", "many"},
       "--n: \"many\" is not a whole number that fits; write one from 1 to 10000000"},
      {{"list", "workloads", "--family", "proximity"},
       "--family: is for structures, not for workloads; write kinex list structures --family "
       "proximity"},
      {{"run", scene_, "--color", "pink"},
       "kinex: --color: \"pink\" is not a choice; write auto, always or never"},
      {{"run", scene_, "-q", "-v"}, "does not go with"},
      {{"gen", "unifrom-square"}, "is not a workload; did you mean uniform-square?"},
      {{"run", scene_, "--maintain", "delauney_2"},
       "is not a known structure; did you mean delaunay_2?"},
      {{"run", scene_, "--arithmetic", "exat"}, "did you mean exact?"},
      {{"verify", "delaunay"}, "is not a structure; did you mean delaunay_2 or delaunay_3?"},
      {{"reproduce", "kds-report"}, "there is no such paper; did you mean kds-report-1998?"},
      {{"list", "structure"}, "did you mean structures?"},
      {{"explain", "sorted"}, "did you mean sorted_list"},
      {{"help", "rn"}, "\"rn\" is not a verb; did you mean run?"},
      // Words of other programs.
      {{"compare", scene_, scene_}, "\"compare\" is not a verb; did you mean diff?"},
      {{"show", scene_}, "did you mean view?"},
      {{"generate"}, "did you mean gen?"},
      {{"version"}, "did you mean --version?"},
      {{"query", scene_}, "\"query\" is not a verb; did you mean run --query?"},
      // All that is missing is named.
      {{"diff", scene_},
       "diff: OTHER is missing: the log that may miss or invent events; write kinex diff LOG OTHER "
       "(kinex help diff"},
      {{"view"}, "view: FILE is missing; write kinex view FILE --output .. (kinex help view"},
      {{"gen"},
       "gen: WORKLOAD is missing: the workload, as kinex list workloads names it; write kinex gen "
       "WORKLOAD (kinex help gen"},
      {{"list"},
       "list: WHAT is missing: structures, workloads, papers or arithmetics; write kinex list "
       "WHAT"},
      {{"sweep", "merge"}, "write kinex sweep merge FOLDER .. --output .. (kinex help sweep merge"},
      // Beginnings of names, and names of other things.
      {{"reproduce", "kds"}, "did you mean kds-report-1998?"},
      {{"sweep", "run", "verfy", "-o", scratch_.file("out")},
       "\"verfy\" is neither a file nor an experiment; did you mean verify?"},
      {{"gen", "delaunay"},
       "is not a workload; delaunay_2 is a structure; write kinex gen uniform-square --maintain "
       "delaunay_2"},
      {{"gen", "bounding_box"}, "bounding_box is a structure; write kinex gen "},
      // Where nothing is near, a list is named, not printed.
      {{"run", scene_, "--maintain", ""},
       "--maintain: the word \"\" is empty; write one, or leave the option out"},
      {{"run", scene_, "--events", ""}, "--events: the word \"\" is empty"},
      {{"run", scene_, "--at", "1/4,,1/2"},
       "--at: \"1/4,,1/2\" has an empty word; write one, or leave its comma out"},
      {{"run", scene_, "--at", "1/4,"}, "--at: \"1/4,\" has an empty word"},
      {{"trade", scene_, "--arithmetic", ",gsl"}, "--arithmetic: \",gsl\" has an empty word"},
      {{"log", scene_, "--columns", "time,,ids"}, "--columns: \"time,,ids\" has an empty word"},
      {{"sweep", "run", "trade", "-o", scratch_.file("out"), "--arithmetic", "gsl,"},
       "--arithmetic: \"gsl,\" has an empty word"},
      {{"gen", "grid", "-o", ""}, "the word \"\" is empty"},
      // What is given twice, or says something of a file that is not written.
      {{"run", scene_, "--events", "a", "--events", "b"},
       "run: --events is given more than once, as \"a\" and \"b\"; leave one (kinex help run "
       "tells"},
      {{"gen", "grid", "-o", "a", "--output", "b"},
       "gen: --output is given more than once, as \"a\" and \"b\"; leave"},
      {{"gen", "grid", "--n", "3", "--n", "3"},
       "gen: --n is given more than once, as \"3\" and \"3\"; leave one"},
      {{"check", scene_, "--color", "auto", "--color", "auto"},
       "check: --color is given more than once"},
      {{"run", scene_, "--instants", "none"},
       "--instants: no event log is written, and this is about the log alone; give --events FILE, "
       "too, or leave"},
      {{"run", scene_, "--provenance"},
       "--provenance: no event log is written, and this is about the log alone"},
      {{"view", scene_, "-o", ""}, "the word \"\" is empty"},
      {{"run", ""}, "the word \"\" is empty"},
      {{"run", "--maintain", "sorted_list", "delaunay_2", scene_},
       "write --maintain sorted_list,delaunay_2, with commas between the structures"},
      {{"run", scene_, "--explain", "--events", scratch_.file("no.jsonl")},
       "--events does not go with --explain"},
      {{"verify", "sorted_list", "--quick", "-o", "-"},
       "--output: standard output takes no folder of files"},
      {{"trade", "nosuch"}, "name a scene, or one of kinex list structures, or all"},
      {{"trade", "outer_hierarchy"},
       "trade: outer_hierarchy has no scenes of its own here; name a scene"},
      {{"verify", "swim"}, "kinex list structures names them"},
      {{"run", scene_, "--arithmetic", "mpfr:1"},
       "\"mpfr:1\" is not mpfr:P for P from 2 to 100000 bits; write such a number of bits"},
      {{"run", scene_, "--arithmetic", "mpfr:x"}, "is not mpfr:P for P from 2 to 100000 bits"},
      // Files of another kind.
      {{"run", scratch_.file("table.csv")},
       "table.csv: line 1: this is a table, not a scene; kinex import "},
      {{"view", scratch_.file("features.json"), "-o", scratch_.file("page.html")},
       "features.json: these are features, not a scene; kinex import "},
      {{"run", scratch_.file("a.log")},
       "a.log: line 1: this is an event log, not a scene; give the scene"},
      {{"import", scratch_.file("a.log")},
       "a.log: line 1: this is an event log, neither a table nor GeoJSON; give the data"},
      {{"roots", scratch_.file("line")}, "line 1: 1 coefficient for degree 2; write 3"}};
  write_file(scratch_.file("line"), "2 1\n");
  write_file(scratch_.file("table.csv"), "id,t,x\na,0,1\n");
  write_file(scratch_.file("features.json"), "{\"type\": \"FeatureCollection\", \"features\": []}");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--events", scratch_.file("a.log")}).exit_code, 0);
  for (const auto& [words, message] : mistakes) {
    const Finished finished = run_kinex(words);
    SCOPED_TRACE(testing::PrintToString(words));
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_THAT(finished.err, StartsWith("kinex: "));
    EXPECT_THAT(finished.err, HasSubstr(message));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1);
    EXPECT_LT(finished.err.size(), 320u) << finished.err;
  }
}

// A summary is read alone: it does not refer to the line above it.
TEST_F(Typing, SummariesStandAlone) {
  for (const char* what : {"structures", "workloads"}) {
    const formats::JsonDocument json =
        formats::parse_json(run_kinex({"list", what, "--json"}).out, "out");
    for (const formats::JsonValue& one : json->items()) {
      const std::string summary(one.find("summary")->text());
      EXPECT_THAT(summary, Not(StartsWith("the same"))) << one.find("name")->text();
      EXPECT_THAT(summary, Not(StartsWith("both "))) << one.find("name")->text();
    }
  }
}

TEST_F(Typing, ListsAndTheirExplanations) {
  for (const char* what : {"structures", "workloads", "papers", "arithmetics"}) {
    const Finished list = run_kinex({"list", what});
    EXPECT_EQ(list.exit_code, 0);
    const std::vector<std::string> names = first_words(list.out);
    const formats::JsonDocument json =
        formats::parse_json(run_kinex({"list", what, "--json"}).out, "out");
    ASSERT_EQ(json->items().size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      EXPECT_EQ(json->items()[i].find("name")->text(), names[i]);
    for (const std::string& name : {names.front(), names.back()}) {
      const Finished explained = run_kinex({"explain", name});
      EXPECT_EQ(explained.exit_code, 0) << name << explained.err;
      EXPECT_THAT(explained.out, StartsWith(name + "  "));
      EXPECT_THAT(explained.out, HasSubstr("\nexample       kinex "));
    }
  }
  // Families and groups, too, with a line for each structure.
  std::size_t listed = 0;
  for (const FamilySummary& family : family_summaries()) {
    const Finished explained = run_kinex({"explain", std::string(family.name)});
    EXPECT_EQ(explained.exit_code, 0) << family.name;
    EXPECT_THAT(explained.out, StartsWith(std::string(family.name) + "  a family of structures: " +
                                          std::string(family.summary) + "\n"));
    for (const StructureInfo& info : structure_infos()) {
      if (family_of(info.name) != family.name) continue;
      EXPECT_THAT(explained.out, HasSubstr(" " + std::string(info.name) + ": " +
                                           std::string(info.summary) + "\n"));
      ++listed;
    }
  }
  EXPECT_EQ(listed, structure_infos().size());
  EXPECT_THAT(run_kinex({"explain", "proximity"}).out, HasSubstr(" closest_pair: closest_pair_"));
  EXPECT_THAT(run_kinex({"explain", "convex_hull"}).out,
              HasSubstr("\nstructures    convex_hull_2: "));
  // Trees are asked something: trajectory_tree has no events that would show what it does.
  for (const char* tree : {"range_tree_2", "trajectory_tree"}) {
    const std::string file = scratch_.file("searched.json"), words = " --audit events --at 1/2 --query 1/4,3/4,1/4,3/4\n";
    EXPECT_THAT(run_kinex({"explain", tree}).out, HasSubstr("kinex run " + std::string(tree) + ".json" + words));
    run_kinex({"gen", "uniform-square", "--n", "8", "--seed", "1", "--maintain", tree, "-o", file, "--force"});
    const Finished asked = run_kinex({"run", file, "--audit", "events", "--at", "1/2", "--query", "1/4,3/4,1/4,3/4"});
    EXPECT_EQ(asked.exit_code, 0) << asked.err;
    EXPECT_THAT(asked.out, testing::ContainsRegex("at 1/2  [a-z_2]+ in \\[1/4, 3/4\\] x \\[1/4, 3/4\\]: \\[\"p"));
  }
  EXPECT_THAT(run_kinex({"explain", "maximum"}).out, HasSubstr("maximum_heap: "));
  EXPECT_THAT(run_kinex({"explain", "mpfr:80"}).out, StartsWith("mpfr:P  "));
}

// kinex help VERB is kinex VERB --help.
TEST_F(Typing, Help) {
  EXPECT_EQ(run_kinex({"help"}).out, run_kinex({"--help"}).out);
  EXPECT_EQ(run_kinex({"help", "run"}).out, run_kinex({"run", "--help"}).out);
  EXPECT_EQ(run_kinex({"help", "sweep", "run"}).out, run_kinex({"sweep", "run", "--help"}).out);
  EXPECT_EQ(run_kinex({"-V"}).out, run_kinex({"--version"}).out);
}

TEST_F(Typing, QuietAndVerbose) {
  const Finished usual = run_kinex({"run", scene_});
  const Finished quiet = run_kinex({"run", scene_, "-q"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_EQ(run_kinex({"-q", "run", scene_}).out, "");  // before the verb, too
  EXPECT_THAT(usual.out, Not(HasSubstr("schedules lazily")));
  EXPECT_THAT(run_kinex({"run", scene_, "-v"}).out, HasSubstr("schedules lazily"));
  const Finished check = run_kinex({"check", "-q", scene_});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.out + check.err, "");
  // Results and errors stay.
  EXPECT_THAT(run_kinex({"check", "-q", "--json", scene_}).out, HasSubstr("\"valid\": true"));
  EXPECT_THAT(run_kinex({"gen", "-q", "grid"}).out, HasSubstr("\"kinex\": 1"));
  EXPECT_THAT(run_kinex({"check", "-q", scratch_.file("none")}).err, StartsWith("kinex: "));
  EXPECT_EQ(run_kinex({"import", "-q", "-"}, "id,x,vx\na,0,1\n").err, "");
  EXPECT_EQ(run_kinex({"import", "-"}, "id,x,vx\na,0,1\n").err, "kinex: 1 row, 1 object\n");
  EXPECT_THAT(
      run_kinex({"import", "-", "--maintain", "closest_pair_bins"}, "id,x,y,vx,vy\na,0,0,1,1\n")
          .err,
      HasSubstr("the scene has no end; give --end T, or maintain closest_pair_all"));
  EXPECT_THAT(run_kinex({"gen", "-v", "grid", "--n", "1"}).err, HasSubstr("1 object, hash "));
}

// -q and -v mean something for every verb. With -q nothing is on standard error, and on standard
// output what was asked for alone; -v says more than nothing.
TEST_F(Typing, EveryVerbIsQuietOrVerbose) {
  const std::string other = scratch_.file("other.log"), table = scratch_.file("t.csv"),
                    plan = scratch_.file("plan.json"), folder = scratch_.file("out"),
                    lines = scratch_.file("lines"), linear = scratch_.file("linear.json");
  ASSERT_EQ(run_kinex({"run", scene_, "--events", log_}).exit_code, 0);
  ASSERT_EQ(run_kinex({"run", scene_, "--arithmetic", "sturm", "--events", other}).exit_code, 0);
  ASSERT_EQ(run_kinex({"gen", "static-one-mover", "--dimension", "2", "--n", "6", "-o", linear}).exit_code, 0);
  write_file(table, "name;t;x;y;speed\na;0;0;0;1\na;1;1;1;1\n");
  write_file(lines, "2 -2 0 1\n");
  write_file(plan, R"({"kinex_plan": 1, "name": "few", "blocks": [{"structure": "sorted_list",
      "workload": "uniform-square", "n": [4, 5]}]})");
  const std::string corpus = read_file("/dev/null");
  struct Case {
    Words words;
    bool prints_when_quiet;
    std::string said;  // with -v: a part of it
  };
  const std::vector<Case> cases{
      {{"run", scene_}, false, "schedules lazily"},
      {{"check", scene_}, false, "schedules lazily"},
      {{"check", log_}, false, "without the scene: there is no "},
      {{"diff", log_, other}, false, "delaunay_2 flip: "},
      {{"gen", "grid", "--n", "4"}, true, "4 objects, hash "},
      {{"import", table, "--column", "id=name", "--ignore-columns"},
       true,
       "columns: id from name, t, x, y\nkinex: ignored: speed\nkinex: fields are separated by "
       "semicolons"},
      {{"export", scene_, "--mf-json"}, true, "t = 0 is 1970-01-01T00:00:00Z; "},
      {{"thin", linear}, true, "left are: "},
      {{"roots", lines}, true, "line 1: 4 refinements, 0 gcds"},
      {{"log", log_}, true, "run done, "},
      {{"list", "papers"}, true, "parts: "},
      {{"explain", "sorted_list"}, true, "its model"},
      {{"help", "sweep"}, true, "kinex sweep merge [OPTIONS]"},
      {{"view", scene_, "-o", scratch_.file("page.html"), "--force"}, false, "certificates, digest "},
      {{"sweep", "list", plan}, true, "shard 0/1: 2 of 2 cells"},
      {{"sweep", "run", plan, "-o", folder, "--fresh"}, false, "start   "},
      {{"sweep", "status", folder}, false, "shard 0/1, 2 records, by kinex sweep run "},
      {{"sweep", "merge", folder, "-o", scratch_.file("few.sqlite"), "--force"},
       false,
       "shard 0/1, 2 records, "}};
  for (const Case& one : cases) {
    SCOPED_TRACE(testing::PrintToString(one.words));
    Words quiet = one.words, verbose = one.words;
    quiet.push_back("-q");
    verbose.push_back("-v");
    const Finished usual = run_kinex(one.words), less = run_kinex(quiet), more = run_kinex(verbose);
    EXPECT_EQ(usual.exit_code, 0) << usual.err;
    EXPECT_EQ(less.exit_code, 0);
    EXPECT_EQ(more.exit_code, 0);
    EXPECT_EQ(less.err, "");
    EXPECT_EQ(less.out.empty(), !one.prints_when_quiet) << less.out;
    EXPECT_THAT(more.out + more.err, HasSubstr(one.said));
    EXPECT_THAT(usual.out + usual.err, Not(HasSubstr(one.said)));
  }
  EXPECT_EQ(run_kinex({"list", "arithmetics", "-q"}).out, "exact\nsturm\ndouble\ngsl\nmpfr:P\n");
  EXPECT_EQ(run_kinex({"explain", "sturm", "-q"}).out,
            "rationals and Sturm sequences alone, without filters\n");
}

// Where the finished part of a run that was stopped is, and what to do.
TEST_F(Typing, StoppedRunsSayWhatIsKept) {
  const Finished bare = run_kinex({"run", scene_, "--max-events", "1"});
  EXPECT_EQ(bare.exit_code, 3);
  EXPECT_EQ(bare.err,
            "kinex: the run was stopped: the limit of --max-events is reached; no file was asked for "
            "(--events FILE keeps what is finished); raise it, or set an earlier end with --until\n");
  const Finished kept = run_kinex({"run", scene_, "--max-events", "1", "--events", log_});
  EXPECT_THAT(kept.err, HasSubstr("is reached; what was finished is in " + log_ + "; raise it"));
  EXPECT_THAT(run_kinex({"run", scene_, "--max-events", "1", "--events", "-"}).err,
              HasSubstr("what was finished is printed"));
}

TEST_F(Typing, Colours) {
  EXPECT_THAT(run_kinex({"rnu"}).err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(run_kinex({"--color", "always", "rnu"}).err,
              StartsWith("\x1b[1;31mkinex:\x1b[0m \"rnu\""));
  EXPECT_THAT(run_kinex({"list", "papers", "--color", "always"}).out, StartsWith("\x1b[1m"));
  EXPECT_THAT(run_kinex({"list", "papers", "--color", "never"}).out, Not(HasSubstr("\x1b")));
}

TEST_F(Typing, LogsAsTables) {
  ASSERT_EQ(run_kinex({"run", scene_, "--events", log_}).exit_code, 0);
  const Finished all = run_kinex({"log", log_});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(all.err, "");
  EXPECT_EQ(run_kinex({"log", log_, "--table"}).out, all.out);
  EXPECT_THAT(all.out, HasSubstr("seq  time"));
  const Finished flips = run_kinex({"log", log_, "--filter", "kind=flip"});
  EXPECT_THAT(flips.err, testing::MatchesRegex("kinex: [0-9]+ of [0-9]+ log records\n"));
  EXPECT_LT(flips.out.size(), all.out.size());
  const Finished two = run_kinex({"log", log_, "--filter", "kind=flip,enter,external=true"});
  EXPECT_EQ(two.out,
            run_kinex({"log", log_, "--filter", "kind=flip", "--filter", "kind=enter"}).out);
  EXPECT_GT(two.out.size(), flips.out.size());
  EXPECT_THAT(run_kinex({"log", log_, "--filter", "kind=flip,filp"}).err,
              HasSubstr("--filter: there is no kind \"filp\" in " + log_ + "; did you mean flip?"));
  const std::string file = scratch_.file("log.csv");
  EXPECT_EQ(run_kinex({"log", log_, "--csv", "-o", file}).exit_code, 0);
  EXPECT_THAT(read_file(file), StartsWith("seq,time,polynomial"));
  EXPECT_THAT(run_kinex({"log", log_, "--csv", "-o", file}).err,
              HasSubstr("exists already; give another name"));
  EXPECT_EQ(run_kinex({"log", log_, "--csv", "-o", file, "--force"}).exit_code, 0);
  EXPECT_THAT(run_kinex({"log", log_, "-o", log_, "--force"}).err,
              HasSubstr("is the input itself"));
  EXPECT_THAT(run_kinex({"log", log_, "--csv", "--table"}).err, HasSubstr("does not go with"));
  EXPECT_THAT(run_kinex({"log", scene_}).err, HasSubstr("does not begin an event log"));
  const Finished few = run_kinex({"log", log_, "--filter", "kind=flip", "--columns", "kind,seq"});
  EXPECT_THAT(few.out, StartsWith("kind  seq\nflip"));
  EXPECT_THAT(run_kinex({"log", log_, "--csv", "--columns", "root,kind"}).out, StartsWith("root,kind\n"));
  EXPECT_THAT(run_kinex({"log", log_, "--columns", "knid"}).err,
              HasSubstr("--columns: \"knid\" is not a column of the table; did you mean kind?"));
  EXPECT_THAT(run_kinex({"log", log_, "--filter", "kind=filp"}).err,
              HasSubstr("did you mean flip?"));
  // The log of a run that was cut off is shown as far as it goes.
  const std::string text = read_file(log_);
  write_file(log_, text.substr(0, text.find("\n{\"end\"") + 1));
  const Finished cut = run_kinex({"log", log_});
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_EQ(cut.out, all.out);
  EXPECT_THAT(cut.err, HasSubstr("its run was cut off"));
}

// Logs of different structures: what both have is compared, the rest is named.
TEST_F(Typing, DiffOfOtherStructures) {
  const std::string other = scratch_.file("other.log"), third = scratch_.file("third.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "delaunay_2,sorted_list", "--events", log_})
                .exit_code,
            0);
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list,maximum_heap", "--events", other})
                .exit_code,
            0);
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "bounding_box", "--events", third}).exit_code,
            0);
  const Finished diff = run_kinex({"diff", log_, other});
  EXPECT_EQ(diff.exit_code, 0) << diff.out;
  EXPECT_THAT(diff.out, HasSubstr("only in " + log_ + ", not compared: delaunay_2\n"));
  EXPECT_THAT(diff.out, HasSubstr("only in " + other + ", not compared: maximum_heap\n"));
  EXPECT_THAT(diff.out, HasSubstr("equal: "));
  const Finished none = run_kinex({"diff", log_, third});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err,
              HasSubstr("it has no structure in common with " + log_ +
                        ": it maintains bounding_box, the other delaunay_2, sorted_list; compare"));
  EXPECT_EQ(run_kinex({"diff", "-q", log_, other}).out, "");
}

// Structures are the same if they maintain the same, whatever their labels.
TEST_F(Typing, DiffOfOtherLabels) {
  const std::string other = scratch_.file("other.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list:x", "--events", log_}).exit_code, 0);
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list,sorted_list:y", "--events", other})
                .exit_code,
            0);
  const Finished diff = run_kinex({"diff", log_, other});
  EXPECT_EQ(diff.exit_code, 0) << diff.out << diff.err;
  EXPECT_THAT(diff.out, HasSubstr("only in " + other + ", not compared: sorted_list:y\n"));
  EXPECT_THAT(diff.out, HasSubstr("sorted_list:x of " + log_ + " is compared with sorted_list of " + other));
  EXPECT_THAT(diff.out, HasSubstr("equal: "));
}

// The first difference is a row of a table, not a line of JSON.
TEST_F(Typing, DiffShowsRows) {
  const std::string other = scratch_.file("other.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--events", log_}).exit_code, 0);
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--until", "1/9", "--events", other})
                .exit_code,
            0);
  const Finished diff = run_kinex({"diff", log_, other});
  EXPECT_EQ(diff.exit_code, 1);
  EXPECT_THAT(diff.out, Not(HasSubstr("\"seq\"")));
  EXPECT_THAT(diff.out, HasSubstr("external  order_x("));
  EXPECT_THAT(diff.out, HasSubstr(other + ": has ended"));
}

// A time in a message is short, however it was written.
TEST_F(Typing, TimesInMessages) {
  const std::string digits(300, '7');
  const std::string scene =
      R"({"kinex": 1, "dimension": 1, "time": {"start": 0, "end": "1)" + digits + "/" + digits +
      R"("}, "objects": [{"id": "a", "motion": [[0, 1]]}], "maintain": ["sorted_list"]})";
  write_file(log_, scene);
  for (const char* option : {"--until", "--at"}) {
    const Finished run = run_kinex({"run", log_, option, "5"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_LT(run.err.size(), 200u) << run.err;
  }
  EXPECT_THAT(run_kinex({"run", log_, "--until", "5"}).err, HasSubstr("at most about 2.28"));
}

}  // namespace typing_test
}  // namespace kinex
