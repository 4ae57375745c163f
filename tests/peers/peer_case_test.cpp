// SPDX-License-Identifier: GPL-3.0-or-later
// Questions, their exact answers, and what answers are worth.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/peers/judge.h"

namespace kinex::peers {
namespace peer_case_test {

PeerShape box(double w, double h) { return {{-w, -h}, {w, -h}, {w, h}, {-w, h}}; }

PeerCase one_step(PeerShape a, PeerShape b, const PeerPose& from, const PeerPose& to) {
  return {"test", "case", std::move(a), std::move(b), {{{}, from}, {{}, to}}};
}

TEST(PeerCase, DistancesKnownByHand) {
  const PeerCase c = one_step(box(1, 1), box(1, 1), {}, {});
  EXPECT_DOUBLE_EQ(signed_distance(c, {{}, {3, 0.5, 0}}), 1);
  EXPECT_DOUBLE_EQ(signed_distance(c, {{}, {5, 6, 0}}), 5);
  EXPECT_DOUBLE_EQ(signed_distance(c, {{}, {1.75, 0, 0}}), -0.25);
  EXPECT_NEAR(signed_distance(c, {{}, {4, 0, std::numbers::pi / 4}}), 3 - std::sqrt(2), 1e-15);
  EXPECT_DOUBLE_EQ(inner_radius(box(2, 0.5)), 0.5);
  EXPECT_DOUBLE_EQ(outer_radius(box(3, 4)), 5);
}

TEST(PeerCase, PosesAreLinearBetweenFrames) {
  PeerCase c = one_step(box(1, 1), box(1, 1), {0, 0, 0}, {4, 2, 1});
  c.frames.push_back({{}, {4, 4, 3}});
  EXPECT_DOUBLE_EQ(c.at(0.25).b.x, 2);
  EXPECT_DOUBLE_EQ(c.at(0.75).b.y, 3);
  EXPECT_DOUBLE_EQ(c.at(1).b.angle, 3);
  EXPECT_DOUBLE_EQ(c.largest_turn(), 2);
  const PeerCase single = one_step({{0.1, 0.2}}, {{0, 0}}, {0.1, 0.2, 0.3}, {0.4, 0, 0}).as_float();
  EXPECT_EQ(single.a[0][0], 0.1f);
  EXPECT_EQ(single.a[0][1], 0.2f);
  EXPECT_EQ(single.frames[0].b.x, 0.1f);
  EXPECT_EQ(single.frames[0].b.y, 0.2f);
  EXPECT_EQ(single.frames[0].b.angle, 0.3f);
  EXPECT_EQ(single.frames[1].b.x, 0.4f);
}

TEST(PeerTruth, StraightLinesAreExact) {
  const Truth hit = find_truth(one_step(box(1, 1), box(1, 1), {-5, 0.5, 0}, {5, 0.5, 0}));
  EXPECT_EQ(hit.kind, TruthKind::kOverlap);
  EXPECT_NEAR(hit.earliest, 0.3, 1e-15);
  EXPECT_TRUE(hit.by_witness);
  EXPECT_EQ(find_truth(line_case(8, 1e-12)).kind, TruthKind::kApart);
  EXPECT_EQ(find_truth(line_case(8, -1e-12)).kind, TruthKind::kOverlap);
  EXPECT_EQ(find_truth(touch_case(8)).kind, TruthKind::kTouch);
  // Apart by less than floats can tell: they are given a touch.
  EXPECT_EQ(find_truth(line_case(8, 1e-9).as_float()).kind, TruthKind::kTouch);
  EXPECT_EQ(find_truth(one_step(box(1, 1), box(1, 1), {1, 0, 0}, {1, 0, 0})).kind,
            TruthKind::kOverlap);
}

// The angles of peers are linear in time: the distance on both sides of the time found says so.
TEST(PeerTruth, TurnsAreEnclosed) {
  for (const PeerCase& c : {one_step(box(0.25, 0.25), box(2, 0.125), {0, 1.5, 0}, {0, 1.5, 3.1}),
                            one_step(box(0.5, 0.25), box(1, 0.5), {-4, 0.5, 0}, {4, 1, 2})}) {
    const Truth truth = find_truth(c);
    ASSERT_EQ(truth.kind, TruthKind::kOverlap);
    EXPECT_LT(truth.earliest, truth.latest);
    EXPECT_LT(truth.latest - truth.earliest, 1e-4);
    EXPECT_GE(signed_distance(c, c.at(truth.earliest)), 0);
    EXPECT_LE(signed_distance(c, c.at(truth.latest)), 0);
    EXPECT_GT(signed_distance(c, c.at(truth.earliest - 1e-3)), 1e-5);
    EXPECT_LT(signed_distance(c, c.at(truth.latest + 1e-3)), -1e-5);
  }
  // Closer than the enclosure: the truth is unknown.
  const PeerCase graze = one_step(box(1, 1), box(1, 1), {-5, 2, 0}, {5, 2, 4 * std::acos(0.0)});
  EXPECT_EQ(find_truth(one_step(box(1, 1), box(1, 1), {2 + 1e-9, 0, 0}, {3, 0, 0.3})).kind,
            TruthKind::kUnknown);
  EXPECT_EQ(find_truth(graze).kind, TruthKind::kOverlap);
}

TEST(PeerTruth, ThePaceOfAnOrbitDoesNotMatter) {
  EXPECT_TRUE(orbit_case(8, 0.5).turns_alike());
  EXPECT_FALSE(spin_case(8, 4).turns_alike());
  EXPECT_EQ(find_truth(orbit_case(8, 1e-6)).kind, TruthKind::kApart);
  EXPECT_EQ(find_truth(orbit_case(8, -1e-6)).kind, TruthKind::kOverlap);
  EXPECT_FALSE(run_ours(orbit_scene(orbit_case(8, 1e-6)), "separation_mixed", "exact").contact);
}

TEST(PeerJudge, AnswersAgainstTruths) {
  PeerQuestions questions;
  PeerMethod method;
  method.tolerance = 0.01;
  const PeerQuestion& meet = questions.of(one_step(box(1, 1), box(1, 1), {-5, 0, 0}, {5, 0, 0}));
  PeerCase past = one_step(box(1, 1), box(1, 1), {-5, 2.005, 0}, {5, 2.005, 0});
  past.name = "past";
  const PeerQuestion& miss = questions.of(past);
  const auto grade = [&](const PeerQuestion& question, PeerReply reply, double time) {
    return judge(method, question, {reply, time, {}, 0, 0}).grade;
  };
  EXPECT_EQ(grade(meet, PeerReply::kHit, 0.3), PeerGrade::kRight);
  EXPECT_EQ(grade(meet, PeerReply::kMiss, 1), PeerGrade::kMissed);
  EXPECT_EQ(grade(meet, PeerReply::kNotANumber, 0), PeerGrade::kNone);
  EXPECT_EQ(grade(miss, PeerReply::kMiss, 1), PeerGrade::kRight);
  EXPECT_EQ(grade(miss, PeerReply::kHit, 0.5), PeerGrade::kTolerated);
  EXPECT_EQ(grade(miss, PeerReply::kHit, 0.2), PeerGrade::kAlarm);
  method.tolerance = 0.001;
  EXPECT_EQ(grade(miss, PeerReply::kHit, 0.5), PeerGrade::kAlarm);
  const Judgement late = judge(method, meet, {PeerReply::kHit, 0.35, {}, 0, 0});
  EXPECT_NEAR(late.late, 0.05, 1e-12);
  EXPECT_NEAR(late.gap, -0.5, 1e-12);
  PeerTally tally;
  tally.add(late);
  EXPECT_NEAR(tally.deepest_overlap, 0.5, 1e-12);
}

}  // namespace peer_case_test
}  // namespace kinex::peers
