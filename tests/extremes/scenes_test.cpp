// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene of the corpus of extremes in both exact arithmetics: the events at the instants that
// the index says, audited, and the same events in both. The other structures that fit the scene are
// audited and compared too.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "experiments/lab/scene_run.h"
#include "structures/registry.h"
#include "tests/extremes/extreme.h"
#include "tests/sanitized.h"
#include "tests/structures/recorder.h"

namespace kinex::extremes {
namespace scenes_test {

// Up to so many objects every event is audited, and other structures are run too; these are audited after
// every event, and run in `sturm`, up to kFew.
constexpr std::size_t kFew = 30, kSmall = 40, kMedium = 50;
// Others are not run in `sturm` where numbers have more bits: products of them take minutes there.
constexpr std::size_t kLongNumbers = 600;
constexpr std::size_t kFewestExtremes = 150;

// Counts events by instant; each instant is described once.
class InstantSink final : public EventSink {
 public:
  explicit InstantSink(const Simulator& simulator) : simulator_(simulator) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    recorder.event(event, arithmetic);
    if (event.certificate.arity == 0) return;  // the scene changed
    ++events;
    const std::uint64_t instant = simulator_.ledger().instants;
    if (counts.empty() || instant != instant_) {
      counts.push_back(0);
      texts.push_back(arithmetic.describe_now());
    }
    instant_ = instant;
    ++counts.back();
  }
  std::size_t events = 0;
  std::vector<std::size_t> counts;
  std::vector<InstantText> texts;
  test::Recorder recorder;

 private:
  const Simulator& simulator_;
  std::uint64_t instant_ = 0;
};

struct ExactRun {
  ExactRun(const Scene& scene, const std::string& arithmetic, AuditLevel audit)
      : simulator(lab::make_simulator(scene, arithmetic, options(audit))), sink(*simulator) {
    simulator->set_sink(&sink);
    simulator->start();
    at_start = simulator->structure(0).attribute().ids;
    EXPECT_EQ(simulator->run_until(std::nullopt), RunStatus::kDone);
    at_end = simulator->structure(0).attribute().ids;
    EXPECT_EQ(simulator->violations(), std::vector<std::string>{});
    EXPECT_GT(simulator->ledger(0).audit_checks, 0u);
    for (const BoundCheck& bound : simulator->bounds(0)) EXPECT_TRUE(bound.holds) << bound.id;
  }
  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    return result;
  }
  std::unique_ptr<Simulator> simulator;
  InstantSink sink;
  std::vector<ObjectId> at_start, at_end;
};

RealRoot root_of(const InstantText& text) {
  std::vector<Integer> coefficients;
  for (const std::string& c : text.polynomial) {
    coefficients.push_back(Rational::parse(c)->numerator());
  }
  const Rational lower = *Rational::parse(text.lower), upper = *Rational::parse(text.upper);
  if (lower == upper) return RealRoot(lower);
  return RealRoot(Polynomial(std::move(coefficients)), lower, upper);
}

void expect_instants(const InstantSink& sink, Extreme& extreme) {
  if (extreme.events_known) {
    EXPECT_EQ(sink.events, extreme.events);
  }
  if (!extreme.instants) return;
  ASSERT_EQ(sink.counts.size(), extreme.instants->size());
  for (std::size_t i = 0; i < sink.counts.size(); ++i) {
    auto& [place, count] = (*extreme.instants)[i];
    EXPECT_EQ(sink.counts[i], count) << "at " << place.text;
    RealRoot instant = root_of(sink.texts[i]);
    EXPECT_TRUE(is_at(instant, place))
        << "instant " << i << " is " << sink.texts[i].approximate << ", not " << place.text;
  }
}

// 2k and 2k + 1 exchanged in edges.
std::vector<ObjectId> exchanged(const std::vector<ObjectId>& edges) {
  std::vector<std::pair<ObjectId, ObjectId>> result;
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    const ObjectId a = edges[i] ^ 1u, b = edges[i + 1] ^ 1u;
    result.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(result.begin(), result.end());
  std::vector<ObjectId> flat;
  for (const auto& [a, b] : result) flat.insert(flat.end(), {a, b});
  return flat;
}

void expect_final(const ExactRun& run, const Extreme& extreme, const Scene& scene) {
  if (extreme.final_state == "start") {
    EXPECT_EQ(run.at_end, run.at_start);
  } else if (extreme.final_state == "exchanged") {
    EXPECT_EQ(run.at_end, exchanged(run.at_start));
  } else if (extreme.final_state == "list") {
    std::vector<std::string> names;
    for (const ObjectId id : run.at_end) names.push_back(scene.objects[id].id);
    EXPECT_EQ(names, extreme.final_list);
  } else {
    EXPECT_EQ(extreme.final_state, "");
  }
}

void expect_same(const ExactRun& a, const ExactRun& b) {
  EXPECT_EQ(a.sink.recorder.events, b.sink.recorder.events);
  EXPECT_EQ(a.at_start, b.at_start);
  EXPECT_EQ(a.at_end, b.at_end);
  ASSERT_EQ(a.sink.counts, b.sink.counts);
  for (std::size_t i = 0; i < a.sink.texts.size(); ++i) {
    EXPECT_EQ(a.sink.texts[i].polynomial, b.sink.texts[i].polynomial);
    EXPECT_EQ(a.sink.texts[i].root, b.sink.texts[i].root);
    EXPECT_EQ(a.sink.texts[i].approximate, b.sink.texts[i].approximate);
  }
}

class ExtremeScene : public testing::Test {
 public:
  explicit ExtremeScene(Extreme extreme) : extreme_(std::move(extreme)) {}
  void TestBody() override {
    Scene scene = extreme_.scene();
    SCOPED_TRACE(extreme_.name + ": " + extreme_.source);
    const std::size_t n = scene.objects.size();
    const AuditLevel audit = n <= kSmall ? AuditLevel::kEvents : AuditLevel::kEnd;
    const ExactRun exact(scene, "exact", audit);
    expect_instants(exact.sink, extreme_);
    expect_final(exact, extreme_, scene);
    if (extreme_.sturm) {
      const ExactRun sturm(scene, "sturm", AuditLevel::kEnd);
      expect_instants(sturm.sink, extreme_);
      expect_final(sturm, extreme_, scene);
      expect_same(exact, sturm);
    }
    const bool others_in_sturm = extreme_.sturm && n <= kFew && !has_long_numbers(scene);
    if (n <= kMedium)
      run_others(scene, n <= kFew ? audit : AuditLevel::kEnd, others_in_sturm,
                 extreme_.name.size());
  }

 private:
  static bool has_long_numbers(const Scene& scene) {
    for (const SceneObject& object : scene.objects) {
      for (const MotionPiece& piece : object.motion.pieces) {
        for (const std::vector<Rational>& axis : piece.trajectory.coordinates) {
          for (const Rational& c : axis) {
            if (c.numerator().bit_length() > kLongNumbers ||
                c.denominator().bit_length() > kLongNumbers)
              return true;
          }
        }
      }
    }
    return false;
  }

  // All others in `exact`, a third of them in `sturm`, which third depends on the scene; under
  // sanitizers a quarter of them, at the end alone.
  static void run_others(Scene& scene, AuditLevel audit, bool in_sturm, std::size_t scene_number) {
    const std::string own = scene.maintain[0].structure;
    std::size_t number = scene_number;
    for (const StructureInfo& info : structure_infos()) {
      ++number;
      if (test::kSanitized && number % 4 != 0) continue;
      const std::string name(info.name);
      if (name == own || info.min_dimension > scene.dimension || info.bodies) continue;
      if (!info.any_dimension && info.min_dimension < scene.dimension) continue;
      if (info.linear() && scene.degree() > 1) continue;
      // These scenes have only points.
      if (info.graph || info.extents != Extents::kNone || info.lines != LineUse::kNone) continue;
      SCOPED_TRACE(name);
      scene.maintain = {{name, name, {}}};
      const ExactRun exact(scene, "exact", test::kSanitized ? AuditLevel::kEnd : audit);
      if (in_sturm && !test::kSanitized && number % 3 == 0) expect_same(exact, ExactRun(scene, "sturm", AuditLevel::kEnd));
    }
  }
  Extreme extreme_;
};

// An index that has lost its entries proves nothing.
TEST(Extremes, TheIndexIsThere) {
  const std::vector<Extreme> extremes = read_extremes();
  EXPECT_GE(extremes.size(), kFewestExtremes);
  for (const Extreme& e : extremes) {
    EXPECT_FALSE(e.source.empty()) << e.name;
    EXPECT_TRUE(e.events_known || !e.final_state.empty()) << e.name;
    EXPECT_EQ(e.file.empty() + e.polynomial.empty() + e.crowd.empty(), 2) << e.name;
  }
}

const bool kRegistered = [] {
  try {
    for (const Extreme& extreme : read_extremes()) {
      std::string name = extreme.name;
      for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      }
      testing::RegisterTest("ExtremeScene", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [extreme]() -> testing::Test* { return new ExtremeScene(extreme); });
    }
  } catch (const std::exception&) {
    return false;  // TheIndexIsThere says why
  }
  return true;
}();

}  // namespace scenes_test
}  // namespace kinex::extremes
