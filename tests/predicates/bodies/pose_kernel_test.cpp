// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates on a pose in a whole run: their failures follow the flight plans of both bodies, and
// are the same in both exact arithmetics and under both schedulings.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {
namespace pose_kernel_test {

using Line = std::array<Rational, 3>;

// Watches the signs of some forms in the pose of bodies 0 and 1: one certificate for the present
// side of each; a failure exchanges it for the other side.
class SignWatch final : public Structure {
 public:
  struct Form {
    std::array<PredicateId, 2> predicates;  // positive on the positive and on the negative side
    std::array<ObjectId, 2> constants;
  };

  SignWatch(Kernel& kernel, StructureId id, const std::vector<Line>& lines)
      : kernel_(&kernel), id_(id), lines_(lines) {
    for (const Frame frame : {Frame::kA, Frame::kB}) {
      sides_.push_back(
          {kernel.bind(make_pose_side(frame, false)), kernel.bind(make_pose_side(frame, true))});
    }
    orders_ = {kernel.bind(make_pose_normal_order(false)),
               kernel.bind(make_pose_normal_order(true))};
  }

  std::vector<std::string> calls;

  std::string_view name() const override { return "sign_watch"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"turn"});
  }

  void build(std::span<const ObjectId>) override {
    const ObjectId bodies[] = {0, 1};
    pose_ = kernel_->derive("pose", make_pose_2(), bodies);
    std::vector<ObjectId> constants;
    for (const Line& line : lines_) {
      constants.push_back(
          kernel_->constant("c" + std::to_string(constants.size()), {line.begin(), line.end()}));
    }
    for (std::size_t i = 0; i + 1 < constants.size(); ++i) {
      forms_.push_back({sides_[0], {constants[i], constants[i + 1]}});
      forms_.push_back({sides_[1], {constants[i], constants[i + 1]}});
      forms_.push_back({orders_, {constants[i], constants[i + 1]}});
    }
    for (std::uint32_t i = 0; i < forms_.size(); ++i) {
      const Sign sign = kernel_->sign_after(
          forms_[i].predicates[0], {pose_, forms_[i].constants[0], forms_[i].constants[1]});
      negative_.push_back(sign == Sign::kNegative);
      certificates_.push_back(kernel_->create(id_, query(i), i).id);
    }
  }
  void rebuild() override { calls.push_back("rebuild"); }
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    const InstantText now = static_cast<Scheduler*>(kernel_)->arithmetic().describe_now();
    std::string text = std::to_string(i) + " at " + now.approximate + ":";
    for (const std::string& c : now.polynomial) text += " " + c;
    calls.push_back(text + " root " + std::to_string(now.root));
    negative_[i] = !negative_[i];
    kernel_->replace(certificates_[i], query(i), i);
    kernel_->report(id_, 0, {0, 1}, true);
  }
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  Attribute attribute() const override { return {Attribute::Shape::kSequence, {}}; }
  std::vector<BoundCheck> bounds(const BoundContext&) const override { return {}; }
  void check_invariants(AuditReport&) const override {}
  std::size_t bytes() const override { return 0; }

  // The signs in world coordinates.
  void audit(const Snapshot& snapshot, AuditReport& report) const override {
    const auto at = [&](ObjectId body, int axis) { return snapshot.position(body, axis); };
    struct Turn {
      Rational c, s;
    };
    std::array<Turn, 2> turns;
    for (const ObjectId body : {ObjectId{0}, ObjectId{1}}) {
      const Rational p = at(body, 2), q = at(body, 3), n = p * p + q * q;
      turns[body] = {(p * p - q * q) / n, Rational(2) * p * q / n};
    }
    const auto turned = [&](std::size_t body, const Rational& x, const Rational& y) {
      return std::array<Rational, 2>{turns[body].c * x - turns[body].s * y,
                                     turns[body].s * x + turns[body].c * y};
    };
    const Rational x = at(1, 0) - at(0, 0), y = at(1, 1) - at(0, 1);
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      const Line& line = lines_[i / 3];
      const Line& other = lines_[i / 3 + 1];
      const std::size_t own = i % 3 == 1 ? 1 : 0;
      const auto m = turned(own, line[0], line[1]);
      Rational value;
      if (i % 3 == 2) {
        const auto g = turned(1, other[0], other[1]);
        value = g[0] * m[1] - g[1] * m[0];
      } else {
        const auto v = turned(1 - own, other[0] / other[2], other[1] / other[2]);
        value = m[0] * (x - v[0]) + m[1] * (y - v[1]) - line[2];
      }
      report.check(value.sign() != (negative_[i] ? 1 : -1),
                   [&] { return "form " + std::to_string(i); });
    }
    ++audits_;
  }
  int audits() const { return audits_; }

 private:
  Query query(std::uint32_t i) const {
    const Form& form = forms_[i];
    return Query(form.predicates[negative_[i] ? 1 : 0],
                 {pose_, form.constants[0], form.constants[1]});
  }

  Kernel* kernel_;
  StructureId id_;
  std::vector<Line> lines_;
  std::vector<std::array<PredicateId, 2>> sides_;
  std::array<PredicateId, 2> orders_;
  ObjectId pose_ = kNoObject;
  std::vector<Form> forms_;
  std::vector<bool> negative_;
  std::vector<CertificateId> certificates_;
  mutable int audits_ = 0;
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  Rational rational() {
    const int p = static_cast<int>(engine_() % 13) - 6, q = 1 + static_cast<int>(engine_() % 3);
    return Rational(Integer(p), Integer(q));
  }

 private:
  std::mt19937_64 engine_;
};

// A flight plan that begins at the given place, turned by the rotor p, q.
Trajectory onwards(Draw& draw, const Rational& t, const std::array<Rational, 4>& from) {
  for (;;) {
    Trajectory trajectory;
    for (const Rational& value : from) {
      const Rational slope = draw.rational();
      trajectory.coordinates.push_back({value - slope * t, slope});
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {  // bent, but not at t
      const Rational bend = draw.rational();
      auto& c = trajectory.coordinates[axis];
      c[0] += bend * t * t;
      c[1] -= Rational(2) * bend * t;
      c.push_back(bend);
    }
    const auto& p = trajectory.coordinates[2];
    const auto& q = trajectory.coordinates[3];
    if (p[0] * q[1] == p[1] * q[0]) continue;  // the rotor might vanish
    trajectory.normalise();
    return trajectory;
  }
}

Scene random_scene(Draw& draw) {
  Scene scene;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = 3;
  for (const char* id : {"a", "b"}) {
    SceneObject body{id, {}, {{0, 0}, {1, 0}, {0, 1}}};
    std::array<Rational, 4> place{draw.rational(), draw.rational(), 1, draw.rational()};
    // The bodies change at different instants, and both at 2.
    const std::vector<Rational> seams =
        id[0] == 'a' ? std::vector<Rational>{0, 1, 2}
                     : std::vector<Rational>{0, Rational(Integer(3), Integer(2)), 2};
    for (std::size_t k = 0; k < seams.size(); ++k) {
      MotionPiece piece{std::nullopt, std::nullopt, onwards(draw, seams[k], place)};
      if (k > 0) piece.from = seams[k];
      if (k + 1 < seams.size()) {
        piece.to = seams[k + 1];
        for (int axis = 0; axis < 4; ++axis) {
          place[static_cast<std::size_t>(axis)] = piece.trajectory.position(axis, seams[k + 1]);
        }
      }
      body.motion.pieces.push_back(std::move(piece));
    }
    scene.objects.push_back(std::move(body));
  }
  return scene;
}

NumberNeeds needs_of(const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  needs.add(pose_2_kind(scene));
  return needs;
}

struct Outcome {
  std::vector<std::string> calls;
  int audits;
};

Outcome run(const Scene& scene, const std::vector<Line>& lines, const char* arithmetic,
            Scheduling scheduling) {
  SimulatorOptions options;
  options.audit = AuditLevel::kEvents;
  options.scheduling = scheduling;
  Simulator simulator(scene, make_arithmetic(arithmetic, scene, needs_of(scene)), options);
  const StructureId id = simulator.reserve();
  auto owned = std::make_unique<SignWatch>(simulator.kernel(), id, lines);
  SignWatch* watch = owned.get();
  simulator.add(id, std::move(owned), "watch");
  simulator.start();
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kDone);
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{}) << arithmetic;
  return {watch->calls, watch->audits()};
}

TEST(PoseKernel, FailuresFollowTheFlightPlansOfBothBodies) {
  Draw draw(9);
  std::size_t failures = 0;
  int audits = 0;
  for (int round = 0; round < 12; ++round) {
    const Scene scene = random_scene(draw);
    std::vector<Line> lines;
    while (lines.size() < 4) {
      Line line{draw.rational(), draw.rational(), draw.rational()};
      if (line[2].sign() > 0 && !(line[0].is_zero() && line[1].is_zero())) lines.push_back(line);
    }
    const Outcome exact = run(scene, lines, "exact", Scheduling::kLazy);
    EXPECT_EQ(run(scene, lines, "exact", Scheduling::kEager).calls, exact.calls);
    EXPECT_EQ(run(scene, lines, "sturm", Scheduling::kEager).calls, exact.calls);
    failures += exact.calls.size();
    audits += exact.audits;
  }
  EXPECT_GT(failures, 60u);
  EXPECT_GT(audits, 60);
}

// Two bodies turn as one: nothing changes between them, although all coefficients do.
TEST(PoseKernel, BodiesThatTurnAsOne) {
  Scene scene;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = 1;
  // In the same place: a common centre other than that of a frame needs a denominator.
  for (const char* id : {"a", "b"}) {
    SceneObject body{id, {}, {{0, 0}, {1, 0}, {0, 1}}};
    body.motion.pieces.push_back(
        {std::nullopt, std::nullopt, {{{0, 1}, {0, 0, 1}, {1}, {0, Rational(5)}}}});
    scene.objects.push_back(std::move(body));
  }
  const std::vector<Line> lines{{1, 0, 2}, {0, 1, 1}, {1, 0, 3}, {2, 0, 5}};
  EXPECT_TRUE(run(scene, lines, "exact", Scheduling::kLazy).calls.empty());
  EXPECT_TRUE(run(scene, lines, "sturm", Scheduling::kLazy).calls.empty());
}

TEST(PoseKernel, PosesAreOfBodies) {
  Scene scene;
  scene.dimension = 2;
  scene.start = 0;
  for (const char* id : {"p", "q"}) {
    SceneObject point{id, {}, {}};
    point.motion.pieces.push_back({std::nullopt, std::nullopt, {{{0}, {0}}}});
    scene.objects.push_back(std::move(point));
  }
  Simulator simulator(scene, make_arithmetic("exact", scene));
  simulator.start();
  const ObjectId both[] = {0, 1};
  EXPECT_THROW(simulator.kernel().derive("pose", make_pose_2(), both), std::logic_error);
}

// An arithmetic that was made for the bodies alone has no room for poses, and says so.
TEST(PoseKernel, PosesAreDeclared) {
  Draw draw(4);
  const Scene scene = random_scene(draw);
  for (const char* name : {"exact", "sturm", "double", "gsl", "mpfr:53"}) {
    Simulator simulator(scene, make_arithmetic(name, scene));
    simulator.start();
    const ObjectId both[] = {0, 1};
    EXPECT_THROW(simulator.kernel().derive("pose", make_pose_2(), both), std::logic_error) << name;
    EXPECT_THROW(simulator.kernel().bind(make_pose_side(Frame::kA, false)), std::logic_error) << name;
  }
}

}  // namespace pose_kernel_test
}  // namespace kinex
