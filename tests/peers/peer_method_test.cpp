// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of asking, with a library that computes right distances; and libraries that break.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/peers/worker.h"

namespace kinex::peers {
namespace peer_method_test {

class RightPeer final : public Peer {
 public:
  explicit RightPeer(const PeerCase& question) : question_(question) {}
  bool load(const PeerShape&, const PeerShape&) override { return true; }
  PeerReply overlap(int, const PeerPose& a, const PeerPose& b) override {
    ++work.steps;
    return signed_distance(question_, {a, b}) < 0 ? PeerReply::kHit : PeerReply::kMiss;
  }
  double distance(int, const PeerPose& a, const PeerPose& b) override {
    ++work.steps;
    const double d = signed_distance(question_, {a, b});
    least = std::min(least, d);
    return d;
  }
  Cast cast(int, const PeerPose&, const PeerPose&, const PeerPose& b0,
            const PeerPose& b1) override {
    ++casts;
    turn = std::max(turn, std::abs(b1.angle - b0.angle));
    return {b0.x <= 1 && 1 <= b1.x ? PeerReply::kHit : PeerReply::kMiss, (1 - b0.x) / (b1.x - b0.x)};
  }
  int casts = 0;
  double turn = 0, least = std::numeric_limits<double>::infinity();

 private:
  const PeerCase& question_;
};

TEST(PeerMethod, AdvancingStopsBeforeTheContact) {
  for (int seed = 1; seed <= 40; ++seed) {
    const PeerCase question = random_case(8, seed);
    RightPeer peer(question);
    const PeerAnswer answer = ask(peer, advance_method("box2d", 1e-4), question);
    ASSERT_TRUE(answer.reply == PeerReply::kHit || answer.reply == PeerReply::kMiss);
    EXPECT_GT(peer.least, -1e-12);  // it never jumps into an overlap
    bool overlaps = false;
    for (int i = 0; i <= 2000; ++i) {
      overlaps = overlaps || signed_distance(question, question.at(i / 2000.0)) < 0;
    }
    if (overlaps) {
      EXPECT_EQ(answer.reply, PeerReply::kHit) << seed;
    }
  }
}

// A peer that always reports the same distance.
class NearPeer final : public Peer {
 public:
  bool load(const PeerShape&, const PeerShape&) override { return true; }
  PeerReply overlap(int, const PeerPose&, const PeerPose&) override { return PeerReply::kMiss; }
  double distance(int, const PeerPose&, const PeerPose&) override { return 1e-6; }
  Cast cast(int, const PeerPose&, const PeerPose&, const PeerPose&, const PeerPose&) override {
    return {};
  }
};

TEST(PeerMethod, AdvancingGivesUp) {
  const PeerCase question = line_case(8, 1);
  NearPeer peer;
  EXPECT_EQ(ask(peer, advance_method("box2d", 1e-9), question).reply, PeerReply::kFailed);
  EXPECT_EQ(ask(peer, advance_method("box2d", 1e-5), question).reply, PeerReply::kHit);
}

TEST(PeerMethod, StepsLookAtBothEnds) {
  const PeerCase question = line_case(8, -0.1);
  RightPeer peer(question);
  PeerAnswer answer = ask(peer, steps_method("box2d", 2), question);
  EXPECT_EQ(answer.reply, PeerReply::kHit);
  EXPECT_EQ(answer.time, 0.5);
  answer = ask(peer, steps_method("box2d", 1), question);
  EXPECT_EQ(answer.reply, PeerReply::kMiss);
  EXPECT_EQ(answer.work.steps, 2u);
}

TEST(PeerMethod, LongTurnsAreCut) {
  const PeerCase question = spin_case(8, 1);  // six radians, x from -5 to 5
  RightPeer peer(question);
  PeerMethod method;
  method.most_turn = 2.5;
  const PeerAnswer answer = ask(peer, method, question);
  EXPECT_EQ(peer.casts, 2);  // of three: the middle part meets x = 1
  EXPECT_LT(peer.turn, 2.5);
  EXPECT_NEAR(answer.time, 0.6, 1e-15);
}

TEST(PeerWorker, WhatDiesOrNeverEndsIsAnAnswer) {
  const auto at = [](double x, int n) {
    PeerCase question{"test", "case", regular_shape(n), regular_shape(8), {}};
    question.frames = {{{}, {x, 0, 0}}, {{}, {x, 0, 0}}};
    return question;
  };
  PeerMethod method = steps_method("broken", 1);
  WorkerLimits limits;
  limits.seconds = 0.3;
  const std::vector<PeerAnswer> answers =
      ask_all(method, {at(0, 8), at(1, 8), at(0, 8), at(2, 8), at(0, 9), at(0, 8)}, limits);
  ASSERT_EQ(answers.size(), 6u);
  EXPECT_EQ(answers[0].reply, PeerReply::kMiss);
  EXPECT_EQ(answers[1].reply, PeerReply::kCrash);
  EXPECT_EQ(answers[2].reply, PeerReply::kMiss);
  EXPECT_EQ(answers[3].reply, PeerReply::kNoEnd);
  EXPECT_EQ(answers[4].reply, PeerReply::kUnsupported);
  EXPECT_EQ(answers[5].reply, PeerReply::kMiss);
  method.module = "nothing";
  EXPECT_THROW(ask_all(method, {at(0, 8)}, limits), std::runtime_error);
}

}  // namespace peer_method_test
}  // namespace kinex::peers
