// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of six and eight arguments, on points with weights and on objects derived from them, in
// a whole run: failures follow the flight plans, and are the same in both exact arithmetics and under
// both schedulings.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "tests/core/arithmetic/general_predicates.h"
#include "tests/sanitized.h"

namespace kinex {
namespace derived_certificates_test {

using test::GeneralPredicate;
using test::Place;

// The sum of its bases, axis by axis, times 1/2: of two points the middle, with the mean weight.
class Middle final : public Construction {
 public:
  std::string_view name() const override { return "middle"; }
  Trajectory derive(std::span<const Trajectory* const> bases) const override {
    Trajectory result;
    for (const Trajectory* base : bases) {
      for (std::size_t axis = 0; axis < base->coordinates.size(); ++axis) {
        if (result.coordinates.size() <= axis) result.coordinates.emplace_back(1);
        auto& sum = result.coordinates[axis];
        const auto& c = base->coordinates[axis];
        if (sum.size() < c.size()) sum.resize(c.size());
        for (std::size_t k = 0; k < c.size(); ++k) sum[k] += c[k] / Rational(2);
      }
    }
    result.normalise();
    return result;
  }
};

constexpr ObjectId kPoints = 9;

// The objects that the forms are about: the points, middles of points, middles of middles (ids as they
// are derived), and a constant.
constexpr std::array<std::array<ObjectId, 2>, 5> kMiddles{{{0, 1}, {2, 3}, {9, 10}, {11, 4}, {9, 11}}};
constexpr ObjectId kConstant = kPoints + kMiddles.size();

std::vector<std::vector<ObjectId>> forms_of(const GeneralPredicate& general) {
  switch (general.predicate->arity()) {
    case 8:
      return {{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 2, 11, 12, 13, 5}, {11, 12, 0, 1, kConstant, 9, 3, 8}};
    case 6:
      return {{0, 1, 2, 3, 4, 5}, {9, 10, 11, 6, 7, 8}, {12, 13, kConstant, 0, 3, 5}};
    case 4:
      return {{0, 1, 2, 3}, {4, 9, 10, 8}, {11, 12, 7, kConstant}};
    default:
      return {{0, 5}, {9, 12}, {11, kConstant}};
  }
}

// Watches the signs of forms: one certificate for the present side of each.
class SignWatch final : public Structure {
 public:
  SignWatch(Kernel& kernel, StructureId id) : kernel_(&kernel), id_(id) {
    for (const GeneralPredicate& general : test::general_predicates()) {
      if (general.negating.empty()) continue;
      const PredicateId predicate = kernel.bind(general.predicate);
      for (const auto& objects : forms_of(general)) forms_.push_back({general, predicate, objects, false, 0});
    }
  }

  std::vector<std::string> calls;
  std::uint32_t flips = 0;

  std::string_view name() const override { return "sign_watch"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"flip"});
  }

  void build(std::span<const ObjectId>) override {
    const auto middle = std::make_shared<Middle>();
    for (const auto& bases : kMiddles) kernel_->derive("middle", middle, bases);
    EXPECT_EQ(kernel_->constant("c", {Rational(1), Rational(2), Rational(1)}), kConstant);
    for (std::uint32_t i = 0; i < forms_.size(); ++i) {
      forms_[i].negative = kernel_->sign_after(query(i)) == Sign::kNegative;
      forms_[i].certificate = kernel_->create(id_, query(i), i).id;
    }
  }
  void rebuild() override { calls.push_back("rebuild"); }
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    const InstantText now = static_cast<Scheduler*>(kernel_)->arithmetic().describe_now();
    calls.push_back(std::to_string(i) + " at " + now.lower + " " + now.upper + " root " +
                    std::to_string(now.root));
    ++flips;
    EXPECT_EQ(kernel_->query(failed), query(i));
    forms_[i].negative = !forms_[i].negative;
    kernel_->replace(forms_[i].certificate, query(i), i);
    kernel_->report(id_, 0, {0, 1, 2, 3, 4, 5, 6, 7}, true);
  }
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  Attribute attribute() const override { return {Attribute::Shape::kSequence, {}}; }
  std::vector<BoundCheck> bounds(const BoundContext&) const override { return {}; }
  void check_invariants(AuditReport&) const override {}
  std::size_t bytes() const override { return 0; }

  void audit(const Snapshot& snapshot, AuditReport& report) const override {
    std::vector<Place> places;
    for (ObjectId id = 0; id < kPoints; ++id) {
      Place& place = places.emplace_back();
      for (int axis = 0; axis < 3; ++axis) place.push_back(snapshot.position(id, axis));
    }
    for (const auto& [a, b] : kMiddles) {
      Place place;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        place.push_back((places[a][axis] + places[b][axis]) / Rational(2));
      }
      places.push_back(std::move(place));
    }
    places.push_back({1, 2, 1});
    for (const Form& form : forms_) {
      std::vector<Place> arguments;
      for (const ObjectId id : form.objects) arguments.push_back(places[id]);
      const int sign = form.general.value(arguments).sign();
      report.check(sign != (form.negative ? 1 : -1),
                   [&] { return std::string(form.general.predicate->name()); });
    }
    ++audits;
  }
  mutable int audits = 0;

 private:
  struct Form {
    GeneralPredicate general;
    PredicateId predicate;
    std::vector<ObjectId> objects;
    bool negative;
    CertificateId certificate;
  };
  Query query(std::uint32_t i) const {
    const Form& form = forms_[i];
    Query q;
    q.predicate = form.predicate;
    for (std::size_t k = 0; k < form.objects.size(); ++k) {
      const std::size_t place = form.negative ? static_cast<std::size_t>(form.general.negating[k]) : k;
      q.ids[q.arity++] = form.objects[place];
    }
    return q;
  }

  Kernel* kernel_;
  StructureId id_;
  std::vector<Form> forms_;
};

// Points on flight plans of two pieces, that meet at instants of their own or, some, at 1.
Scene random_scene(std::uint64_t seed, bool integers) {
  std::mt19937_64 engine(seed);
  const auto number = [&] {
    const int p = static_cast<int>(engine() % 13) - 6, q = integers ? 1 : 1 + static_cast<int>(engine() % 3);
    return Rational(Integer(p), Integer(q));
  };
  Scene scene;
  scene.dimension = 2;
  scene.extents = Extents::kWeight;
  scene.start = 0;
  scene.end = 3;
  for (ObjectId i = 0; i < kPoints; ++i) {
    SceneObject object;
    object.id = std::to_string(i);
    const Rational weight = i % 3 != 0 ? number() : Rational();
    const Rational seam(Integer(i % 2 == 0 ? 2 : static_cast<int>(2 + i)), Integer(2));
    Trajectory first{{{number(), number()}, {number(), number()}}}, second;
    for (const auto& axis : first.coordinates) {
      const Rational slope = number(), bend = number();  // bent, but not at the seam
      second.coordinates.push_back({axis[0] + axis[1] * seam - slope * seam + bend * seam * seam,
                                    slope - Rational(2) * bend * seam, bend});
    }
    for (Trajectory* const motion : {&first, &second}) motion->coordinates.push_back({weight});
    second.normalise();
    object.motion.pieces.push_back({std::nullopt, seam, std::move(first)});
    object.motion.pieces.push_back({seam, std::nullopt, std::move(second)});
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

NumberNeeds needs_of(const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  needs.add({"middle", 3, scene.degree(), false});
  return needs;
}

std::vector<std::string> run(const Scene& scene, const char* arithmetic, Scheduling scheduling,
                             int* audits = nullptr) {
  SimulatorOptions options;
  options.audit = AuditLevel::kEvents;
  options.scheduling = scheduling;
  Simulator simulator(scene, make_arithmetic(arithmetic, scene, needs_of(scene)), options);
  const StructureId id = simulator.reserve();
  auto owned = std::make_unique<SignWatch>(simulator.kernel(), id);
  SignWatch* watch = owned.get();
  simulator.add(id, std::move(owned), "watch");
  simulator.start();
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kDone);
  if (!simulator.arithmetic().is_exact()) return watch->calls;
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{}) << arithmetic;
  if (audits != nullptr) *audits += watch->audits;
  // A point is in at most every certificate, once, however many of its arguments depend on it.
  EXPECT_LE(simulator.ledger(id).max_per_object, simulator.ledger(id).live);
  return watch->calls;
}

TEST(DerivedCertificates, FollowTheFlightPlansOfAllBases) {
  std::size_t failures = 0;
  int audits = 0;
  for (std::uint64_t seed = 0; seed < test::fewer(16u); ++seed) {
    const Scene scene = random_scene(seed, seed % 2 == 0);
    const auto exact = run(scene, "exact", Scheduling::kLazy, &audits);
    EXPECT_EQ(run(scene, "exact", Scheduling::kEager), exact) << seed;
    EXPECT_EQ(run(scene, "sturm", Scheduling::kEager), exact) << seed;
    failures += exact.size();
  }
  EXPECT_GT(failures, test::seen_in_fewer(200u));
  EXPECT_GT(audits, test::seen_in_fewer(200));
}

// Inexact arithmetics get to the end. Where a value only touches zero they may flip twice, and few bits
// may leave no end of repairs at one instant.
TEST(DerivedCertificates, RunInEveryArithmetic) {
  const Scene scene = random_scene(3, true);
  const std::size_t exact = run(scene, "exact", Scheduling::kLazy).size();
  for (const char* name : {"double", "gsl", "mpfr:200"}) {
    const std::size_t flips = run(scene, name, Scheduling::kEager).size();
    EXPECT_GT(flips, 0u) << name;
    if (std::string_view(name) != "mpfr:200") continue;
    EXPECT_GE(flips + 4, exact) << name;
    EXPECT_LE(flips, exact + 4) << name;
  }
}

}  // namespace derived_certificates_test
}  // namespace kinex
