// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates that name an object twice: the writer of a structure may arrive at them, for example
// by the gap (b - a) - (d - c) with b = c. The kernel refuses them where they are created or
// replaced, and the structure that asked continues unharmed.
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/arithmetic/predicate_formula.h"
#include "core/engine/simulator.h"
#include "structures/plan.h"
#include "tests/core/engine/plain_list.h"
#include "tests/families/family.h"
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

// x(1) - x(0) minus the differences of the arguments that follow, two by two, or one from the
// first.
template <int kArguments>
struct Gap {
  static constexpr int kArity = kArguments;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  std::string_view name() const { return "gap"; }
  int dimension() const { return 1; }
  template <class Points>
  auto value(const Points& p) const {
    auto sum = p(1, 0) - p(0, 0);
    for (int i = 2; i < kArguments; ++i) sum = sum - (p(i, 0) - p(i - 2, 0));
    return widen(sum);
  }
};

// A list that now and then asks for a certificate with an object in two places.
class TwiceList final : public test::PlainList {
 public:
  TwiceList(Kernel& kernel, StructureId id, Random& random)
      : PlainList(kernel, id),
        random_(&random),
        gaps_{less_, bind<3>(kernel), bind<4>(kernel), bind<5>(kernel)} {}

  void build(std::span<const ObjectId> objects) override {
    PlainList::build(objects);
    provoke();
  }
  void certificate_failed(CertificateId failed) override {
    PlainList::certificate_failed(failed);
    provoke();
  }
  void insert(ObjectId object) override {
    PlainList::insert(object);
    provoke();
  }
  void erase(ObjectId object) override {
    PlainList::erase(object);
    provoke();
  }

  int asked = 0, refused = 0;

 private:
  template <int kArguments>
  static PredicateId bind(Kernel& kernel) {
    return kernel.bind(std::make_shared<FormulaPredicate<Gap<kArguments>>>());
  }

  void provoke() {
    if (order_.size() < 2 || random_->chance(30)) return;
    Query query;
    const int arity = random_->between(2, 5);
    query.predicate = gaps_[arity - 2];
    query.arity = static_cast<std::uint8_t>(arity);
    for (int i = 0; i < arity; ++i) query.ids[static_cast<std::size_t>(i)] = random_->pick(order_);
    const int a = random_->between(0, arity - 1);
    const int b = (a + random_->between(1, arity - 1)) % arity;
    query.ids[static_cast<std::size_t>(a)] = query.ids[static_cast<std::size_t>(b)];
    ++asked;
    try {
      if (certificates_.empty() || random_->chance(50)) {
        kernel_->create(id_, query, 0);
      } else {
        kernel_->replace(random_->pick(certificates_), query, 0);
      }
    } catch (const std::exception& error) {
      const std::string what = error.what();
      const std::string id = std::to_string(query.ids[static_cast<std::size_t>(a)]);
      if (what.find(id) != std::string::npos || what.find("twice") != std::string::npos) ++refused;
    }
  }

  Random* random_;
  PredicateId gaps_[4];
};

Scene lines(Random& random) {
  Scene scene;
  scene.name = "lines";
  scene.dimension = 1;
  scene.start = 0;
  scene.end = Rational(4);
  const int n = random.between(2, 6);
  for (int i = 0; i < n; ++i) {
    MotionPiece piece;
    if (random.chance(25)) piece.from = Rational(random.between(1, 2));
    if (random.chance(25)) piece.to = Rational(3);
    piece.trajectory.coordinates = {{random.between(-3, 3), random.between(-2, 2)}};
    piece.trajectory.normalise();
    scene.objects.push_back({"o" + std::to_string(i), {{std::move(piece)}}});
  }
  return scene;
}

}  // namespace

void named_twice(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const Scene scene = lines(random);
  ++tally.scenes;
  for (const char* arithmetic : {"exact", "sturm", "double", "gsl", "mpfr:60"}) {
    ++tally.runs;
    SimulatorOptions options;
    options.audit = AuditLevel::kEvents;
    Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
    const StructureId id = simulator.reserve();
    auto owned = std::make_unique<TwiceList>(simulator.kernel(), id, random);
    const TwiceList& list = *owned;
    simulator.add(id, std::move(owned), "list");
    const std::string seen = "seed " + std::to_string(seed) + " in " + arithmetic;
    try {
      simulator.start();
      simulator.run_until({});
    } catch (const std::exception& error) {
      tally.problem(seen + " has thrown: " + error.what(), "");
      continue;
    }
    tally.refused += static_cast<std::uint64_t>(list.refused);
    const StructureLedger& ledger = simulator.ledger(id);
    tally.events += arithmetic == std::string_view("exact") ? ledger.processed : 0;
    if (list.refused != list.asked) {
      tally.problem(seen + ": " + std::to_string(list.asked - list.refused) + " of " +
                        std::to_string(list.asked) + " certificates were not refused by name",
                    "");
    }
    if (!simulator.violations().empty() || ledger.corrupt) {
      tally.problem(seen + ": " + (ledger.corrupt ? ledger.corruption : simulator.violations()[0]),
                    "");
    }
  }
}

}  // namespace kinex::families
