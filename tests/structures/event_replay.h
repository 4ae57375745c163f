// SPDX-License-Identifier: GPL-3.0-or-later
// EventReplay: checks that the external events of structures report every change of their
// attributes. It replays the events of a run and compares at the end of every instant; a difference
// is a violation of the run's audit (AuditLevel::kEvents).
//
// An insertion or erasure changes the attribute as the structure's own call does (a new body does
// not change the contacts). All other changes must be reported: by the ids of an event, or by its
// difference (Event::gone, Event::came).
#ifndef KINEX_TESTS_STRUCTURES_EVENT_REPLAY_H
#define KINEX_TESTS_STRUCTURES_EVENT_REPLAY_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/structures/replayed_orders.h"

namespace kinex::test {

// One attribute, changed by events.
class ReplayedAttribute {
 public:
  // `exact`: no edge may exist twice.
  void begin(const Attribute& attribute, bool exact) {
    value_ = attribute;
    exact_ = exact;
    begin_orders();
  }
  // The defect of the event; empty: none.
  std::string apply(std::string_view kind, const Event& event) {
    const auto id = [&event](std::size_t i) { return event.ids[i]; };
    std::vector<ObjectId>& ids = value_.ids;
    if (event.has_difference()) return apply_difference(event);
    switch (value_.shape) {
      case Attribute::Shape::kSequence: {
        if (kind == "above" || kind == "below") return exchange_next(kind == "above" ? 1 : 2, event);
        if (kind == "wall_up" || kind == "wall_down") return exchange_wall(kind == "wall_up" ? 2 : 3, event);
        // Of two sequences, one behind the other, the second.
        const std::size_t half = kind == "swap_y" ? ids.size() / 2 : 0;
        const auto at =
            std::find(ids.begin() + static_cast<std::ptrdiff_t>(half), ids.end(), id(0));
        if (at == ids.end() || at + 1 == ids.end() || *(at + 1) != id(1)) return "no neighbours";
        std::swap(*at, *(at + 1));
        return "";
      }
      case Attribute::Shape::kObject:
        if (ids != std::vector<ObjectId>{id(0)}) return "another object than the old one";
        ids = {id(1)};
        return "";
      case Attribute::Shape::kTuples:
        if (value_.width == 4) return apply_in_space(kind, event);
        if (value_.width == 3) return apply_in_plane(kind, event);
        if (kind == "flip") return remove(id(0), id(1)) + add(id(2), id(3));
        if (kind == "enter") return remove(id(1), id(2));
        if (kind == "leave") return add(id(1), id(2));
        if (kind == "pass") return exchange(id(0), id(1));
        if (kind == "contact" || kind == "overlap" || kind == "meet") return add(id(0), id(1));
        if (kind == "separation" || kind == "part") return remove(id(0), id(1));
        if (kind == "graze") return "";
        return "an external event of another kind";
      case Attribute::Shape::kOrders:
        return orders_.apply(kind, event);
      case Attribute::Shape::kCycle:
        if (kind == "leave") return leave(id(0));
        if (kind == "enter") return enter(event);
        return "a turn without a difference";
    }
    return "";
  }
  Attribute value() const {
    return value_.shape == Attribute::Shape::kOrders ? orders_.attribute() : value_;
  }

 private:
  void begin_orders() {
    if (value_.shape == Attribute::Shape::kOrders) orders_ = ReplayedOrders(value_);
  }
  // Of points, each with what is above it and below it.
  std::string exchange_next(std::size_t place, const Event& event) {
    std::vector<ObjectId>& ids = value_.ids;
    for (std::size_t i = 0; i + 2 < ids.size(); i += 3) {
      if (ids[i] != event.ids[0]) continue;
      if (event.ids[1] == event.ids[2] || ids[i + place] != event.ids[1]) return "another one was next";
      ids[i + place] = event.ids[2];
      return "";
    }
    return "no such point";
  }
  // Of pairs of lines, each with what is above their crossing and below it.
  std::string exchange_wall(std::size_t place, const Event& event) {
    std::vector<ObjectId>& ids = value_.ids;
    for (std::size_t i = 0; i + 3 < ids.size(); i += 4) {
      if (ids[i] != event.ids[0] || ids[i + 1] != event.ids[1]) continue;
      if (event.ids[2] == event.ids[3] || ids[i + place] != event.ids[2]) return "another one was next";
      ids[i + place] = event.ids[3];
      return "";
    }
    return "no such crossing";
  }
  using Edge = std::pair<ObjectId, ObjectId>;

  std::string apply_difference(const Event& event) {
    if (value_.shape != Attribute::Shape::kTuples) {
      const std::vector<ObjectId> ids = value().ids;
      if (!std::equal(ids.begin(), ids.end(), event.gone.begin(), event.gone.end())) {
        return "what went was not there";
      }
      value_.ids.assign(event.came.begin(), event.came.end());
      begin_orders();
      return "";
    }
    if (value_.width == 1) return apply_members(event);
    if (value_.width > 2) return apply_cells(event);
    std::string wrong;
    const auto ascending = [](std::span<const ObjectId> flat) {
      for (std::size_t i = 0; i < flat.size(); i += 2) {
        if (flat[i] >= flat[i + 1]) return false;
        if (i >= 2 && Edge{flat[i], flat[i + 1]} < Edge{flat[i - 2], flat[i - 1]}) return false;
      }
      return true;
    };
    if (!ascending(event.gone) || !ascending(event.came)) wrong = "edges out of order; ";
    for (std::size_t i = 0; i < event.gone.size(); i += 2) {
      wrong += remove(event.gone[i], event.gone[i + 1]);
    }
    for (std::size_t i = 0; i < event.came.size(); i += 2) {
      wrong += add(event.came[i], event.came[i + 1]);
    }
    return wrong;
  }
  // Of a set of objects.
  std::string apply_members(const Event& event) {
    std::vector<ObjectId>& ids = value_.ids;
    for (const ObjectId id : event.gone) {
      const auto place = std::lower_bound(ids.begin(), ids.end(), id);
      if (place == ids.end() || *place != id) return "what went was not there";
      ids.erase(place);
    }
    for (const ObjectId id : event.came) {
      const auto place = std::lower_bound(ids.begin(), ids.end(), id);
      if (place != ids.end() && *place == id) return "what came was there";
      ids.insert(place, id);
    }
    return "";
  }
  using Cell = std::vector<ObjectId>;
  // Triangles: a flip of two, one at the hull, or a vertex that shows in one, or beyond a hull edge.
  std::string apply_in_plane(std::string_view kind, const Event& event) {
    const auto& v = event.ids;
    std::string wrong;
    if (kind == "flip") {
      for (const ObjectId end : {v[2], v[3]}) wrong += change(false, {v[0], v[1], end});
      for (const ObjectId end : {v[0], v[1]}) wrong += change(true, {v[2], v[3], end});
      return wrong;
    }
    const bool joins = kind == "leave" || kind == "show";
    if (event.count == 3) return change(joins, {v[0], v[1], v[2]});
    wrong += change(!joins, {v[1], v[2], v[3]});
    wrong += change(joins, {v[0], v[1], v[2]});
    wrong += change(joins, {v[0], v[2], v[3]});
    return wrong + change(joins, {v[0], v[1], v[3]});
  }
  // A flip in space: two cells on five points for three, or the reverse; a vertex that shows in a cell, or
  // the reverse; or one cell at the hull.
  std::string apply_in_space(std::string_view kind, const Event& event) {
    const auto& v = event.ids;
    const bool joins =
        kind == "flip_2_3" || kind == "leave" || kind == "hull_2_3" || kind == "show";
    if (event.count == 4) return change(joins, {v[0], v[1], v[2], v[3]});
    std::string wrong;
    if (kind == "show" || kind == "hide") {
      wrong += change(!joins, {v[1], v[2], v[3], v[4]});
      for (std::size_t out = 1; out < 5; ++out) {
        Cell cell{v[0]};
        for (std::size_t i = 1; i < 5; ++i) {
          if (i != out) cell.push_back(v[i]);
        }
        wrong += change(joins, std::move(cell));
      }
      return wrong;
    }
    for (const ObjectId end : {v[0], v[1]}) wrong += change(!joins, {end, v[2], v[3], v[4]});
    for (std::size_t out = 2; out < 5; ++out) {
      const std::size_t a = out == 2 ? 3 : 2, b = out == 4 ? 3 : 4;
      wrong += change(joins, {v[0], v[1], v[a], v[b]});
    }
    return wrong;
  }
  std::string apply_cells(const Event& event) {
    std::string wrong;
    for (const auto& [ids, joins] : {std::pair(event.gone, false), std::pair(event.came, true)}) {
      for (std::size_t i = 0; i < ids.size(); i += value_.width) {
        wrong += change(joins, Cell(ids.begin() + static_cast<std::ptrdiff_t>(i),
                                    ids.begin() + static_cast<std::ptrdiff_t>(i + value_.width)));
      }
    }
    return wrong;
  }
  std::string change(bool joins, Cell cell) {
    std::sort(cell.begin(), cell.end());
    std::vector<Cell> cells;
    for (auto at = value_.ids.begin(); at != value_.ids.end(); at += value_.width) {
      cells.emplace_back(at, at + value_.width);
    }
    const auto at = std::lower_bound(cells.begin(), cells.end(), cell);
    const bool there = at != cells.end() && *at == cell;
    if (joins && there && exact_) return "a cell came twice; ";
    if (!joins && !there) return "a cell went that was not there; ";
    if (joins) {
      cells.insert(at, cell);
    } else {
      cells.erase(at);
    }
    value_.ids.clear();
    for (const Cell& one : cells) value_.ids.insert(value_.ids.end(), one.begin(), one.end());
    return "";
  }
  std::vector<Edge> edges() const {
    std::vector<Edge> result;
    for (std::size_t i = 0; i < value_.ids.size(); i += 2) {
      result.emplace_back(value_.ids[i], value_.ids[i + 1]);
    }
    return result;
  }
  void set(std::vector<Edge> edges) {
    std::sort(edges.begin(), edges.end());
    value_.ids.clear();
    for (const auto& [a, b] : edges) value_.ids.insert(value_.ids.end(), {a, b});
  }
  std::string add(ObjectId a, ObjectId b) {
    std::vector<Edge> all = edges();
    const Edge edge = std::minmax(a, b);
    if (exact_ && std::count(all.begin(), all.end(), edge) != 0) return "an edge came twice; ";
    all.push_back(edge);
    set(std::move(all));
    return "";
  }
  std::string remove(ObjectId a, ObjectId b) {
    std::vector<Edge> all = edges();
    const Edge edge = std::minmax(a, b);
    const auto at = std::find(all.begin(), all.end(), edge);
    if (at == all.end()) return "an edge went that was not there; ";
    all.erase(at);
    set(std::move(all));
    return "";
  }
  std::string exchange(ObjectId a, ObjectId b) {
    std::vector<Edge> all = edges();
    if (std::count(all.begin(), all.end(), Edge(std::minmax(a, b))) != 1) return "no neighbours";
    for (Edge& edge : all) {
      for (ObjectId* end : {&edge.first, &edge.second}) *end = *end == a ? b : *end == b ? a : *end;
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
    }
    set(std::move(all));
    return "";
  }
  std::string leave(ObjectId id) {
    const auto at = std::find(value_.ids.begin(), value_.ids.end(), id);
    if (at == value_.ids.end()) return "no vertex";
    value_.ids.erase(at);
    start_at_smallest();
    return "";
  }
  std::string enter(const Event& event) {
    std::vector<ObjectId>& ids = value_.ids;
    if (event.count == 1) {
      if (!ids.empty()) return "an edge is not named";
      ids = {event.ids[0]};
      return "";
    }
    const auto at = std::find(ids.begin(), ids.end(), event.ids[1]);
    if (at == ids.end()) return "no edge that it splits";
    const auto next = at + 1 == ids.end() ? ids.begin() : at + 1;
    if (*next != event.ids[2]) return "another edge than it splits";
    ids.insert(at + 1, event.ids[0]);
    start_at_smallest();
    return "";
  }
  void start_at_smallest() {
    std::vector<ObjectId>& ids = value_.ids;
    std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  }

  Attribute value_;
  ReplayedOrders orders_;  // kOrders
  bool exact_ = true;
};

class EventReplay final : public EventSink {
 public:
  explicit EventReplay(Simulator& simulator) : simulator_(simulator) {}

  // From then on structures are rebuilt instead of repaired, on average after every `one_in`
  // failures.
  void rebuild_at_random(std::uint64_t seed, int one_in) {
    engine_.seed(seed);
    one_in_ = one_in;
  }
  // Adds the scene's structures. Call simulator.set_sink(&replay) and start.
  void add_structures(const Scene& scene) {
    std::vector<const Structure*> made;
    for (const PlannedStructure& planned : plan_structures(scene)) {
      const StructureId id = simulator_.reserve();
      std::vector<const Structure*> watched;
      for (const StructureId read : planned.watches) watched.push_back(made[read]);
      auto inner =
          make_structure(planned.request, scene, simulator_.kernel(), id, watched, planned.watches);
      made.push_back(inner.get());
      simulator_.add(id, watch(id, std::move(inner)), planned.request.label, planned.watches,
                     planned.members);
    }
  }
  std::unique_ptr<Structure> watch(StructureId id, std::unique_ptr<Structure> inner) {
    return std::make_unique<Checked>(*this, id, std::move(inner));
  }

  void event(const Event& event, Arithmetic&) override {
    Replayed& replayed = replayed_[event.structure];
    const auto kinds = simulator_.event_kinds(event.structure);
    const std::string_view kind = kinds[event.kind];
    ++counts[std::string(kind)];
    if (event.external) ++external;
    const bool settles = kind == "settled" || kind == "rebuild";
    if (settles && event.external != event.has_difference()) {
      replayed.wrong += std::string(kind) + ": external without a difference, or not with one; ";
    }
    if (!event.external) {
      if (event.has_difference()) replayed.wrong += "a difference that is not external; ";
      return;
    }
    if (replayed.comes_or_goes) {
      replayed.wrong += std::string(kind) + " while an object comes or goes; ";
      return;
    }
    const std::string wrong = replayed.attribute.apply(kind, event);
    if (!wrong.empty()) replayed.wrong += std::string(kind) + ": " + wrong + "; ";
  }

  std::map<std::string, std::uint64_t> counts;  // by kind
  std::uint64_t external = 0;

 private:
  struct Replayed {
    ReplayedAttribute attribute;
    bool comes_or_goes = false;
    std::string wrong;
  };

  class Checked final : public Structure {
   public:
    Checked(EventReplay& replay, StructureId id, std::unique_ptr<Structure> inner)
        : replay_(replay), id_(id), inner_(std::move(inner)) {}

    std::string_view name() const override { return inner_->name(); }
    std::vector<std::string_view> event_kinds() const override { return inner_->event_kinds(); }
    void build(std::span<const ObjectId> objects) override {
      if (tells_of_new_bodies()) {
        replay_.replayed_[id_].attribute.begin({Attribute::Shape::kTuples, {}}, true);
        return inner_->build(objects);
      }
      come_or_go([&] { inner_->build(objects); });
    }
    void insert(ObjectId object) override {
      if (tells_of_new_bodies()) return inner_->insert(object);
      come_or_go([&] { inner_->insert(object); });
    }
    void erase(ObjectId object) override {
      come_or_go([&] { inner_->erase(object); });
    }
    void rebuild() override { inner_->rebuild(); }
    // As the simulator does when its guard fires.
    void certificate_failed(CertificateId failed) override {
      if (!replay_.rebuilds_now()) return inner_->certificate_failed(failed);
      const Attribute before = inner_->told();
      inner_->rebuild();
      if (replay_.simulator_.ledger(id_).corrupt) return;
      const AttributeDifference change = difference_between(before, inner_->attribute());
      replay_.simulator_.kernel().count_rebuild(id_, "test", change.gone, change.came);
    }
    void motions_changed(std::span<const ObjectId> objects) override {
      inner_->motions_changed(objects);
    }
    void instant_settled() override { inner_->instant_settled(); }
    void instant_over() override { inner_->instant_over(); }
    void watched_changed(const Event* event) override { inner_->watched_changed(event); }
    int largest_motion_degree() const override { return inner_->largest_motion_degree(); }
    Attribute attribute() const override { return inner_->attribute(); }
    Attribute told() const override { return inner_->told(); }
    std::vector<BoundCheck> bounds(const BoundContext& c) const override {
      return inner_->bounds(c);
    }
    std::uint64_t most_repairs(std::uint64_t c) const override { return inner_->most_repairs(c); }
    // At the end of every instant.
    void check_invariants(AuditReport& report) const override {
      inner_->check_invariants(report);
      const Replayed& replayed = replay_.replayed_[id_];
      report.check(replayed.wrong.empty(), [&] { return "replay: " + replayed.wrong; });
      const Attribute value = replayed.attribute.value();
      report.check(value == inner_->attribute(), [&] {
        return "replay: events lead to" + text(value) + " and not to" + text(inner_->attribute());
      });
      report.check(inner_->told() == inner_->attribute(),
                   [] { return std::string("replay: something was not told"); });
    }
    void audit(const Snapshot& s, AuditReport& report) const override { inner_->audit(s, report); }
    bool holds_at(const Snapshot& s) const override { return inner_->holds_at(s); }
    std::size_t bytes() const override { return inner_->bytes(); }

   private:
    static std::string text(const Attribute& attribute) {
      std::string result;
      for (const ObjectId id : attribute.ids) result += " " + std::to_string(id);
      return result.empty() ? " nothing" : result;
    }
    // Structures for collisions: a new body brings no contacts but by events.
    bool tells_of_new_bodies() const {
      const auto kinds = inner_->event_kinds();
      return std::find(kinds.begin(), kinds.end(), "overlap") != kinds.end();
    }
    template <class Call>
    void come_or_go(const Call& call) {
      Replayed& replayed = replay_.replayed_[id_];
      replayed.comes_or_goes = true;
      call();
      replayed.comes_or_goes = false;
      if (!replay_.simulator_.ledger(id_).corrupt) {
        replayed.attribute.begin(inner_->attribute(), replay_.simulator_.kernel().is_exact());
      }
    }

    EventReplay& replay_;
    StructureId id_;
    std::unique_ptr<Structure> inner_;
  };

  bool rebuilds_now() {
    return one_in_ > 0 && engine_() % static_cast<std::uint64_t>(one_in_) == 0;
  }

  Simulator& simulator_;
  std::map<StructureId, Replayed> replayed_;
  std::mt19937_64 engine_;
  int one_in_ = 0;
};

}  // namespace kinex::test

#endif
