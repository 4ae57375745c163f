// SPDX-License-Identifier: GPL-3.0-or-later
// Structures two layers above a hull: what they report when the hull settles, and what they keep when
// its points come and go.
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "predicates/predicates.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/slots.h"
#include "tests/structures/extent/calipers_support.h"

namespace kinex::test {
namespace layers_test {

// The smallest and the largest object of an attribute that it watches, from left to right. It looks at
// the attribute when its instant is settled, and reports when that is over; a pair that it finds out of
// order is put in order by the failure of its certificate, at the same instant.
class OutermostIds : public Structure {
 public:
  enum Kind : std::uint8_t { kSwap };

  OutermostIds(Kernel& kernel, StructureId id, const Structure& watched)
      : kernel_(&kernel),
        id_(id),
        watched_(&watched),
        order_(kernel.bind(make_coordinate_order(0))),
        slots_(kernel, id, "pair"),
        events_(kernel, id, Attribute::Shape::kSequence) {}

  std::string_view name() const override { return "outermost_ids"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override {
    slots_.drop(slot_);
    pair_.clear();
    begin();
  }
  void certificate_failed(CertificateId failed) override {
    slots_.failed(failed);
    std::swap(pair_[0], pair_[1]);
    slots_.set(slot_, Query(order_, {pair_[0], pair_[1]}), 0);
    events_.repaired(kSwap, {pair_[0], pair_[1]}, pair_);
  }
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void watched_changed(const Event*) override { kernel_->settle_later(id_); }
  void instant_settled() override { look(); }
  void instant_over() override { events_.over(pair_); }
  Attribute attribute() const override { return {Attribute::Shape::kSequence, pair_}; }
  Attribute told() const override { return events_.told(); }
  std::vector<BoundCheck> bounds(const BoundContext&) const override { return {}; }
  std::size_t bytes() const override { return sizeof *this + events_.bytes(); }
  void check_invariants(AuditReport& report) const override {
    report.check(events_.told().ids == pair_, [] { return "a change was not reported"; });
  }
  void audit(const Snapshot&, AuditReport& report) const override {
    report.check(std::ranges::is_permutation(pair_, outermost()), [] { return "not outermost"; });
  }

 protected:
  // The watched attribute has no id twice: two objects or none.
  std::vector<ObjectId> outermost() const {
    const std::vector<ObjectId> all = watched_->told().ids;
    if (all.size() < 2) return {};
    const auto [least, most] = std::ranges::minmax(all);
    return {least, most};
  }
  // Two new objects are in no order yet: the smaller id comes first.
  void look() {
    const std::vector<ObjectId> now = outermost();
    if (std::ranges::is_permutation(now, pair_)) return;
    pair_ = now;
    if (pair_.empty()) return slots_.drop(slot_);
    slots_.set(slot_, Query(order_, {pair_[0], pair_[1]}), 0);
  }
  // Right after now, without an event.
  void begin() {
    look();
    if (slot_ != kNoCertificate && kernel_->sign_after(kernel_->query(slot_)) == Sign::kNegative) {
      std::swap(pair_[0], pair_[1]);
      slots_.set(slot_, Query(order_, {pair_[0], pair_[1]}), 0);
    }
    events_.begin(pair_);
  }

  Kernel* kernel_;
  StructureId id_;
  const Structure* watched_;
  PredicateId order_;
  Slots slots_;
  std::vector<ObjectId> pair_;  // from left to right
  CertificateId slot_ = kNoCertificate;
  AttributeEvents events_;
};

// It waits for the notice that the hull has lost a point.
class Waiting final : public OutermostIds {
 public:
  using OutermostIds::OutermostIds;
  void erase(ObjectId) override {}
};

// T2: a point passes through two opposite vertices of a square.
Scene through_vertices() {
  return scene_of({path({{1}, {0}}), path({{0}, {1}}), path({{-1}, {0}}), path({{0}, {-1}}),
                   path({{-3, 1}, {0}})},
                  0, Rational(6));
}

// A hull and what it reads, then `Lower`, which watches it, then OutermostIds, which watches that.
template <class Lower = OutermostIds>
class Layers {
 public:
  Layers(const Scene& given, const std::string& hull)
      : scene_(asking(given, hull, "")),
        simulator_(scene_, planned_arithmetic("exact", scene_),
                   Trial::options(AuditLevel::kEvents)),
        sink_(*this) {
    add_structures(simulator_, scene_);
    const StructureId ring = asked_structure(scene_);
    lower_ = add<Lower>(ring, "lower");
    upper_ = add<OutermostIds>(lower_, "upper");
    simulator_.set_sink(&sink_);
    simulator_.start();
  }
  Simulator& simulator() { return simulator_; }
  // Their external events with times: "upper settled 2.00000000000".
  const std::vector<std::string>& told() const { return sink_.lines; }
  std::vector<ObjectId> upper() const { return simulator_.structure(upper_).attribute().ids; }

 private:
  struct Sink final : EventSink {
    explicit Sink(Layers& layers) : of(&layers) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (!event.external || event.structure < of->lower_) return;
      const Simulator& s = of->simulator_;
      lines.push_back(s.label(event.structure) + " " +
                      std::string(s.event_kinds(event.structure)[event.kind]) + " " +
                      arithmetic.describe_now().approximate);
    }
    Layers* of;
    std::vector<std::string> lines;
  };
  template <class Reader>
  StructureId add(StructureId watched, const std::string& label) {
    const StructureId id = simulator_.reserve();
    simulator_.add(id,
                   std::make_unique<Reader>(simulator_.kernel(), id, simulator_.structure(watched)),
                   label, {watched});
    return id;
  }

  Scene scene_;
  Simulator simulator_;
  StructureId lower_ = 0, upper_ = 0;
  Sink sink_;
};

// The hull is {0, 1, 3, 4}, then {0, 1, 2, 3} from 2 on, {1, 2, 3, 4} from 4 on. At 2 the upper pair
// {0, 3} is made in the wrong order, after the lower layer has reported.
TEST(Layers, BothSettleAtTheInstantOfTheHull) {
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    Layers<> layers(through_vertices(), hull);
    EXPECT_EQ(layers.upper(), (std::vector<ObjectId>{4, 0}));
    EXPECT_EQ(layers.simulator().run_until(Rational(3)), RunStatus::kDone);
    EXPECT_EQ(layers.upper(), (std::vector<ObjectId>{3, 0}));
    EXPECT_EQ(layers.simulator().run_until(std::nullopt), RunStatus::kDone);
    EXPECT_EQ(layers.upper(), (std::vector<ObjectId>{1, 4}));
    EXPECT_EQ(layers.told(), (std::vector<std::string>{
                                 "lower settled 2.00000000000", "upper settled 2.00000000000",
                                 "lower settled 4.00000000000", "upper settled 4.00000000000"}));
    EXPECT_EQ(layers.simulator().violations(), std::vector<std::string>{});
  }
}

// Every object goes and comes back, before, at and after the instants at which the hull changes.
TEST(Layers, BothDropWhatIsErased) {
  for (const std::string& hull : kHulls) {
    for (ObjectId object = 0; object < 5; ++object) {
      for (const int t : {1, 2, 3, 4, 5}) {
        SCOPED_TRACE(hull + ": " + std::to_string(object) + " at " + std::to_string(t));
        const Scene scene = through_vertices();
        Layers<> layers(scene, hull);
        layers.simulator().schedule_erasure(Rational(t), object);
        layers.simulator().schedule_insertion(quotient(2 * t + 1, 2), object,
                                              scene.objects[object].motion.pieces[0].trajectory);
        EXPECT_EQ(layers.simulator().run_until(std::nullopt), RunStatus::kDone);
        EXPECT_EQ(layers.upper(), (std::vector<ObjectId>{1, 4}));
        EXPECT_EQ(layers.simulator().violations(), std::vector<std::string>{});
      }
    }
  }
}

TEST(Layers, AReaderThatWaitsForTheNoticeOfAnErasureIsFound) {
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    Layers<Waiting> layers(through_vertices(), hull);
    layers.simulator().schedule_erasure(Rational(1), 0);
    EXPECT_THROW(layers.simulator().run_until(std::nullopt), std::logic_error);
  }
}

// The structures of the family that read what reads a hull, against the baseline that reads nothing.
TEST(Layers, TheDiameterFollowsErasures) {
  for (const std::string& hull : kHulls) {
    for (ObjectId object = 0; object < 5; ++object) {
      for (const int t : {1, 2, 3, 4, 5}) {
        SCOPED_TRACE(hull + ": " + std::to_string(object) + " at " + std::to_string(t));
        Scene scene = through_vertices();
        Motion& motion = scene.objects[object].motion;
        motion.pieces[0].to = Rational(t);
        motion.pieces.push_back({quotient(2 * t + 1, 2), Rational(6), motion.pieces[0].trajectory});
        const CaliperRun baseline(scene, "diameter_all_pairs", "");
        const CaliperRun layered(scene, "diameter_2", hull);
        EXPECT_EQ(layered.values(), baseline.values());
        EXPECT_EQ(layered.ids(), baseline.ids());
      }
    }
  }
}

}  // namespace layers_test
}  // namespace kinex::test
