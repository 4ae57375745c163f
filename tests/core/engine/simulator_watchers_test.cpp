// SPDX-License-Identifier: GPL-3.0-or-later
// Structures that watch others are notified of every change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/engine/simulator_fixture.h"

namespace kinex::test {
namespace simulator_watchers_test {

using testing::ElementsAre;

// The first object of a list that it watches.
class First final : public PlainList {
 public:
  First(Kernel& kernel, StructureId id, const PlainList* watched)
      : PlainList(kernel, id), watched_(watched) {}
  void build(std::span<const ObjectId>) override { look(); }
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  void watched_changed(const Event* event) override {
    calls.push_back(event == nullptr ? "anew" : "event");
    look();
  }
  Attribute attribute() const override { return {Attribute::Shape::kObject, order_}; }
  void audit(const Snapshot&, AuditReport& report) const override {
    const std::vector<ObjectId> all = watched_->attribute().ids;
    report.check(all.empty() ? order_.empty() : order_ == std::vector<ObjectId>{all[0]},
                 [] { return std::string("not the first"); });
  }

 private:
  void look() {
    const std::vector<ObjectId> all = watched_->attribute().ids;
    if (all.empty()) {
      order_.clear();
    } else if (order_.empty() || order_[0] != all[0]) {
      order_ = {all[0]};
      kernel_->report(id_, 0, {all[0]}, true);
    }
  }
  const PlainList* watched_;
};

struct Composition {
  template <class Watched = PlainList>
  static std::unique_ptr<Composition> make(const Scene& scene,
                                           const std::string& arithmetic = "exact") {
    auto c = std::make_unique<Composition>();
    c->simulator =
        std::make_unique<Simulator>(scene, make_arithmetic(arithmetic, scene), Fixture<>::every());
    Simulator& s = *c->simulator;
    auto list = std::make_unique<Watched>(s.kernel(), s.reserve());
    PlainList* watched = list.get();
    s.add(0, std::move(list), "list");
    auto first = std::make_unique<First>(s.kernel(), s.reserve(), watched);
    c->first = first.get();
    s.add(1, std::move(first), "first", {0});
    s.start();
    return c;
  }
  std::unique_ptr<Simulator> simulator;
  First* first = nullptr;
};

TEST(Simulator, WatchersAreToldOfEveryChange) {
  // The list swaps at 1 (0, 1) and 2 (0, 2); 1 is erased at 3 and inserted at 4.
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2}})}, 0, Rational(6));
  const auto c = Composition::make(scene);
  c->simulator->schedule_erasure(Rational(3), 1);
  c->simulator->schedule_insertion(Rational(4), 1, path({{-1}}));
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(c->first->calls, ElementsAre("event", "event", "anew", "anew"));
  EXPECT_EQ(c->simulator->ledger(1).by_kind.at("swap"), 4u);
  EXPECT_EQ(c->simulator->ledger(1).failures, 0u);
  EXPECT_EQ(c->simulator->ledger(1).external, 4u);
  EXPECT_EQ(c->simulator->ledger(1).processed, 4u);
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

// Reports its swaps only when the instant is over.
class Late final : public PlainList {
 public:
  using PlainList::PlainList;
  void build(std::span<const ObjectId> objects) override {
    PlainList::build(objects);
    told_ = attribute();
  }
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    std::swap(order_[i], order_[i + 1]);
    certify();
    kernel_->report(id_, 0, {}, false);
    kernel_->settle_later(id_);
  }
  void instant_over() override {
    calls.push_back("over");
    const AttributeDifference change = difference_between(told_, attribute());
    told_ = attribute();
    kernel_->report_settled(id_, change.gone, change.came);
  }

 private:
  Attribute told_;
};

TEST(Simulator, WhatChangedIsToldWhenTheInstantIsOver) {
  // All three meet at 1: three swaps, one difference.
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2, -1}})}, 0, Rational(6));
  const auto c = Composition::make<Late>(scene);
  DifferenceSink sink(*c->simulator);
  c->simulator->set_sink(&sink);
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(sink.lines, ElementsAre("settled -0 -1 -2 +2 +1 +0 !"));
  const StructureLedger& l = c->simulator->ledger(0);
  EXPECT_EQ(l.failures, 3u);
  EXPECT_EQ(l.internal, 3u);
  EXPECT_EQ(l.external, 1u);
  EXPECT_EQ(l.processed, 4u);
  EXPECT_EQ(l.records, 4u);
  EXPECT_EQ(l.by_kind.at("settled"), 1u);
  EXPECT_EQ(c->first->attribute().ids, (std::vector<ObjectId>{2}));
  EXPECT_THAT(c->first->calls, ElementsAre("event"));
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

TEST(Simulator, WatchersAreToldOfRebuilds) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(6));
  const auto c = Composition::make<Stubborn>(scene);
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(c->first->calls, ElementsAre("anew"));
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

TEST(Simulator, CorruptionSpreadsToWatchers) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(6));
  const auto c = Composition::make<Fragile>(scene, "double");
  c->simulator->run_until(std::nullopt);
  EXPECT_TRUE(c->simulator->ledger(1).corrupt);
  EXPECT_TRUE(c->first->calls.empty());
}

}  // namespace simulator_watchers_test
}  // namespace kinex::test
