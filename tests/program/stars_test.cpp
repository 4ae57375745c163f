// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest star to the Sun, from 100,000 years ago to 100,000 years from now: 294 stars in
// linear motion. The witness reads the table by itself and computes in integers of 128 bits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/formats/json_document.h"
#include "tests/program/spawn.h"
#include "tests/program/star_witness.h"
#include "tests/shared_data.h"

namespace kinex {
namespace stars_test {

using testing::HasSubstr;
using Wide = __int128;

constexpr int kSteps = 100;  // samples at k / 1000 million years, |k| <= kSteps
constexpr const char* kEntry =
    R"({"structure":"minimum_tournament","key":{"squared_distance_to":"Sun"},"as":"nearest"})";

// The squared distance at k / 1000, in units of 1e-18 square parsec.
Wide squared_distance(const Star& star, int k) {
  Wide sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Wide x = Wide(1000) * star.position[axis] + Wide(k) * star.velocity[axis];
    sum += x * x;
  }
  return sum;
}

std::string nearest(const std::map<std::string, Star>& stars, int k) {
  std::string best;
  for (const auto& [id, star] : stars) {
    if (best.empty() || squared_distance(star, k) < squared_distance(stars.at(best), k)) best = id;
  }
  return best;
}

// |a(t)|^2 - |b(t)|^2 as c0 + c1 t + c2 t^2.
std::array<Wide, 3> difference(const Star& a, const Star& b) {
  std::array<Wide, 3> c{};
  const auto add = [&c](const Star& star, Wide factor) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Wide x = star.position[axis], v = star.velocity[axis];
      c[0] += factor * x * x;
      c[1] += factor * 2 * x * v;
      c[2] += factor * v * v;
    }
  };
  add(a, 1);
  add(b, -1);
  return c;
}

struct HandOver {
  std::string from, to, decimal;
  std::array<Wide, 3> polynomial;
};

std::vector<HandOver> hand_overs(const std::string& log) {
  std::vector<HandOver> result;
  std::istringstream lines(read_file(log));
  std::string line;
  while (std::getline(lines, line)) {
    const formats::JsonDocument event_document = formats::parse_json(line, log);
    const formats::JsonValue& event = *event_document;
    const formats::JsonValue* external = event.find("external");
    if (external == nullptr || !external->boolean()) continue;
    const auto ids = event.find("ids")->items();
    const formats::JsonValue* time = event.find("time");
    HandOver one{std::string(ids[0].text()), std::string(ids[1].text()),
                std::string(time->find("decimal")->text()), {}};
    const auto coefficients = time->find("polynomial")->items();
    if (coefficients.size() != 3) throw std::runtime_error("not of degree 2: " + line);
    for (std::size_t i = 0; i < 3; ++i) one.polynomial[i] = std::stoll(std::string(coefficients[i].text()));
    result.push_back(one);
  }
  return result;
}

class Stars : public testing::Test {
 protected:
  void SetUp() override {
    KINEX_REQUIRE_DATA(table_);
    const Finished made = run_kinex({"import", table_, "--start", "-0.1", "--end", "0.1", "--fixed",
                                     "Sun,0,0,0", "--maintain", kEntry, "-o", scene_});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    ASSERT_THAT(made.err, HasSubstr("294 rows, 295 objects"));
  }
  void simulate(const std::string& arithmetic) {
    std::string times = "-1/10";
    for (int k = -kSteps + 1; k <= kSteps; ++k) times += "," + std::to_string(k) + "/1000";
    const Finished run = run_kinex({"run", scene_, "--arithmetic", arithmetic, "--audit", "events",
                                    "--at", times, "--events", scratch_.file(arithmetic + ".log"),
                                    "--summary", scratch_.file(arithmetic + ".json")});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
  }
  const std::string table_ = shared_data("nearest_stars.csv");
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("stars.json");
};

TEST_F(Stars, NearestIsThatOfTheTableAtEverySample) {
  simulate("exact");
  const std::map<std::string, Star> stars = read_stars(table_);
  ASSERT_EQ(stars.size(), 294u);
  const std::string file = scratch_.file("exact.json");
  const formats::JsonDocument summary_document = formats::parse_json(read_file(file), file);
  const formats::JsonValue& summary = *summary_document;
  const auto samples = summary.find("samples")->items();
  ASSERT_EQ(samples.size(), static_cast<std::size_t>(2 * kSteps + 1));
  for (int k = -kSteps; k <= kSteps; ++k) {
    const formats::JsonValue& sample = samples[static_cast<std::size_t>(k + kSteps)];
    EXPECT_EQ(sample.find("nearest")->text(), nearest(stars, k)) << sample.find("t")->text();
  }
  EXPECT_EQ(samples[kSteps - 80].find("nearest")->text(), "Scholz's Star");
  EXPECT_EQ(samples[kSteps].find("nearest")->text(), "Proxima Cen");
  const formats::JsonValue* ledger = summary.find("structures")->find("nearest");
  EXPECT_EQ(ledger->find("audit")->find("violations")->text(), "0");
  EXPECT_GT(std::stoll(std::string(ledger->find("audit")->find("checks")->text())), 1000);
  EXPECT_EQ(ledger->find("rebuilds")->text(), "0");
  for (const formats::JsonValue& bound : ledger->find("bounds")->items()) {
    EXPECT_TRUE(bound.find("holds")->boolean()) << bound.find("id")->text();
  }
}

// Every hand-over is the root of the very polynomial that the table gives, and the sample before it
// and the one after it name the two stars.
TEST_F(Stars, HandOversAreAtTheirExactInstants) {
  simulate("exact");
  const std::map<std::string, Star> stars = read_stars(table_);
  const std::vector<HandOver> found = hand_overs(scratch_.file("exact.log"));
  ASSERT_FALSE(found.empty());
  std::string now = nearest(stars, -kSteps);
  for (const HandOver& one : found) {
    EXPECT_EQ(one.from, now);
    now = one.to;
    const std::array<Wide, 3> expected = difference(stars.at(one.from), stars.at(one.to));
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(expected[i] * one.polynomial[2] == expected[2] * one.polynomial[i])
          << one.from << " to " << one.to;
    }
    const double t = std::stod(one.decimal);
    EXPECT_EQ(nearest(stars, static_cast<int>(std::floor(t * 1000))), one.from) << t;
    EXPECT_EQ(nearest(stars, static_cast<int>(std::ceil(t * 1000))), one.to) << t;
    std::printf("  %12.6f  %s -> %s\n", t, one.from.c_str(), one.to.c_str());
  }
  EXPECT_EQ(now, nearest(stars, kSteps));
  const auto at = [&](const std::string& from, const std::string& to) {
    for (const HandOver& one : found) {
      if (one.from == from && one.to == to) return std::stod(one.decimal);
    }
    ADD_FAILURE() << "no hand-over from " << from << " to " << to;
    return 0.0;
  };
  EXPECT_NEAR(at("Proxima Cen", "Ross 248"), 0.033, 0.0005);
  EXPECT_NEAR(at("Ross 248", "GJ 445"), 0.042, 0.0005);
  EXPECT_EQ(found.front().from, "Scholz's Star");
}

TEST_F(Stars, SturmGivesTheSameLog) {
  simulate("exact");
  simulate("sturm");
  const Finished diff = run_kinex({"diff", scratch_.file("exact.log"), scratch_.file("sturm.log")});
  EXPECT_EQ(diff.exit_code, 0) << diff.out;
  EXPECT_THAT(diff.out, testing::StartsWith("equal: "));
  for (const char* arithmetic : {"exact", "sturm"}) {
    const Finished check = run_kinex({"check", scratch_.file(std::string(arithmetic) + ".log")});
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_THAT(check.out, HasSubstr("levels 0, 1"));
  }
}

}  // namespace stars_test
}  // namespace kinex
