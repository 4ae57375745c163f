// SPDX-License-Identifier: GPL-3.0-or-later
// Whole runs of the corpus of extremes: every instant has one name and one interval, the same in
// `exact` and `sturm`, lazily and eagerly scheduled; the interval holds what the name stands for.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/numbers/real_root.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/lab/scene_run.h"
#include "tests/places.h"

namespace kinex {
namespace instant_runs_test {

constexpr std::uintmax_t kLargestFile = 12000;
constexpr std::size_t kFewestScenes = 80, kFewestInstants = 300;

struct NamedInstant {
  InstantName name, interval;
};

std::string words(const InstantName& name) {
  const InstantText text = to_text(name);
  std::string out;
  for (const std::string& c : text.polynomial) out += c + " ";
  return out + "root " + std::to_string(text.root) + " [" + text.lower + ", " + text.upper + "] " +
         text.approximate;
}

// Of every event.
class Namer final : public EventSink {
 public:
  void event(const Event&, Arithmetic& arithmetic) override {
    NamedInstant now;
    now.interval = arithmetic.name_now(InstantDetail::kInterval);
    now.name = arithmetic.name_now(InstantDetail::kName);
    EXPECT_EQ(arithmetic.name_now(InstantDetail::kName).number, now.name.number);
    instants.push_back(std::move(now));
  }
  std::vector<NamedInstant> instants;
};

std::vector<NamedInstant> run(const Scene& scene, const std::string& arithmetic,
                              Scheduling scheduling) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.scheduling = scheduling;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  Namer namer;
  simulator->set_sink(&namer);
  simulator->start();
  EXPECT_EQ(simulator->run_until(std::nullopt), RunStatus::kDone);
  return std::move(namer.instants);
}

void expect_equal(const std::vector<NamedInstant>& a, const std::vector<NamedInstant>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(words(a[i].name), words(b[i].name));
    EXPECT_EQ(words(a[i].interval), words(b[i].interval));
  }
}

// A double holds zero exactly: its enclosure has no width, and no ends at which signs differ.
TEST(InstantRuns, ZeroIsNamedAlike) {
  for (const std::string motion : {"[2, 1]", "[2, -3]", "[2, 1, 1]", "[2, 1, -2, 1]"}) {
    SCOPED_TRACE(motion);
    const Scene scene = formats::parse_scene(
        R"({"kinex": 1, "name": "zero", "dimension": 1, "time": {"start": "-1/3", "end": 0},
            "objects": [{"id": "a", "motion": [[2]]}, {"id": "b", "motion": [)" +
            motion +
            R"(]}], "maintain": [{"structure": "sorted_list", "key": "x"},
                                 {"structure": "maximum_hanger", "key": "x"}, "bounding_box"]})",
        "s.json");
    const std::vector<NamedInstant> exact = run(scene, "exact", Scheduling::kLazy);
    ASSERT_FALSE(exact.empty());
    EXPECT_EQ(words(exact[0].interval), "root 0 [0, 0] 0");
    EXPECT_EQ(words(exact[0].name), "0 1 root 1 [0, 0] 0");
    expect_equal(exact, run(scene, "exact", Scheduling::kEager));
    expect_equal(exact, run(scene, "sturm", Scheduling::kLazy));
  }
}

TEST(InstantRuns, OfExtremesAreNamedAlike) {
  std::size_t scenes = 0, instants = 0;
  std::vector<std::filesystem::path> files;
  const std::filesystem::path corpus(KINEX_SOURCE_DIR "/tests/corpus/extremes");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".json" || file.filename() == "index.json") continue;
    if (entry.file_size() <= kLargestFile) files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    SCOPED_TRACE(file.string());
    const Scene scene = formats::read_scene(file.string());
    if (scene.maintain.empty()) continue;
    ++scenes;
    const std::vector<NamedInstant> exact = run(scene, "exact", Scheduling::kLazy);
    expect_equal(exact, run(scene, "exact", Scheduling::kEager));
    expect_equal(exact, run(scene, "sturm", Scheduling::kLazy));
    RootCounters counters;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const InstantName& name = exact[i].name;
      EXPECT_TRUE(name.is_rational() ||
                  (name.polynomial.degree() > 1 && name.polynomial.leading().sign() > 0));
      RealRoot instant = to_root(name);
      EXPECT_GE(compare(instant, exact[i].interval.lower, counters), 0);
      EXPECT_LE(compare(instant, exact[i].interval.upper, counters), 0);
      EXPECT_EQ(exact[i].interval.decimal, name.decimal);
      if (i == 0) continue;
      // Equal instants are named alike.
      const int order = compare(exact[i - 1].name, name, counters);
      EXPECT_LE(order, 0);
      if (order == 0) {
        EXPECT_EQ(words(exact[i - 1].name), words(name));
      }
    }
    instants += exact.size();
  }
  EXPECT_GE(scenes, kFewestScenes);
  EXPECT_GE(instants, kFewestInstants);
}

}  // namespace instant_runs_test
}  // namespace kinex
