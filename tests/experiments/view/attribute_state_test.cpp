// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording reads of an attribute of pairs after an event: the same as a comparison of all of it.
#include "experiments/view/attribute_state.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

namespace kinex::test {
namespace {

// Pairs that a test changes; counts how often all of them are read.
class Pairs final : public Structure, public LocalPairs {
 public:
  std::string_view name() const override { return "pairs"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"flip"});
  }
  void build(std::span<const ObjectId>) override {}
  void rebuild() override {}
  void certificate_failed(CertificateId) override {}
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  std::vector<BoundCheck> bounds(const BoundContext&) const override { return {}; }
  void check_invariants(AuditReport&) const override {}
  void audit(const Snapshot&, AuditReport&) const override {}
  std::size_t bytes() const override { return 0; }

  Attribute attribute() const override {
    ++reads;
    Attribute all{Attribute::Shape::kTuples, {}, 2};
    for (const auto& [a, b] : pairs) all.ids.insert(all.ids.end(), {a, b});
    return all;
  }
  std::vector<ObjectId> neighbours(ObjectId object) const override {
    std::set<ObjectId> found;
    for (const auto& [a, b] : pairs) {
      if (a == object) found.insert(b);
      if (b == object) found.insert(a);
    }
    return {found.begin(), found.end()};
  }

  std::set<std::pair<ObjectId, ObjectId>> pairs;
  mutable int reads = 0;
};

TEST(AttributeState, WhatFailuresChangeIsReadNearTheNamedObjects) {
  std::mt19937 random(7);
  const auto object = [&](ObjectId n) { return static_cast<ObjectId>(random() % n); };
  Pairs structure;
  for (int i = 0; i < 40; ++i) {
    const ObjectId a = object(15), b = object(15);
    if (a != b) structure.pairs.insert(std::minmax(a, b));
  }
  view::AttributeState state(structure);
  Attribute known = state.begin();
  structure.reads = 0;
  for (int event = 0; event < 300; ++event) {
    std::vector<ObjectId> named{object(15),
                                object(18)};  // objects 15 to 17 are in no pair at first
    for (int i = 0; i < 3; ++i) {
      const ObjectId a = named[random() % 2], b = object(18);
      if (a == b) continue;
      const std::pair<ObjectId, ObjectId> pair = std::minmax(a, b);
      if (structure.pairs.erase(pair) == 0) structure.pairs.insert(pair);
    }
    state.note_event(named, false);
    state.note_call(true);
    const view::AttributeChange change = state.read();
    ASSERT_EQ(structure.reads, 0);
    const Attribute now = structure.attribute();
    structure.reads = 0;
    ASSERT_EQ(change, view::difference(known, now)) << event;
    ASSERT_EQ(state.value(), now) << event;
    known = now;
  }
}

// Calls other than failures, and events that name no objects, are followed by a comparison of everything.
TEST(AttributeState, EverythingElseIsComparedAsAWhole) {
  const std::array<ObjectId, 1> named{0};
  for (const bool common : {true, false}) {
    Pairs structure;
    structure.pairs = {{0, 1}, {2, 3}};
    view::AttributeState state(structure);
    state.begin();
    structure.pairs = {{0, 1}, {2, 4}};
    state.note_event(named, common);
    state.note_call(common);
    const view::AttributeChange change = state.read();
    EXPECT_EQ(change.removed, (std::vector<ObjectId>{2, 3}));
    EXPECT_EQ(change.added, (std::vector<ObjectId>{2, 4}));
    EXPECT_EQ(state.value(), structure.attribute());
  }
}

}  // namespace
}  // namespace kinex::test
