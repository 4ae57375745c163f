// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_hanger.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {

MaximumHanger::MaximumHanger(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                             Extremum extremum, std::uint64_t seed)
    : MaximumStructure(kernel, id, scene, Contest(extremum, kernel, key, scene), "maximum_hanger",
                       "minimum_hanger", kReplace),
      slots_(kernel, id, "hanger"),
      seed_(seed),
      place_of_(scene.objects.size(), kNone) {}

std::vector<std::string_view> MaximumHanger::event_kinds() const {
  return common_event_kinds({"swap", "tie", "replace"});
}

// The next bit of a fixed sequence: a counter, scrambled (Steele, Lea, Flood, "Fast splittable
// pseudorandom number generators", 2014).
bool MaximumHanger::coin() {
  std::uint64_t z = seed_ + ++coins_ * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return ((z ^ (z >> 31)) >> 63) != 0;
}

// ---- the static algorithm

void MaximumHanger::build(std::span<const ObjectId> objects) {
  construct(contest_.order().members(objects));
  events_.begin(winner());
}

void MaximumHanger::rebuild() {
  std::vector<ObjectId> members;
  for (Node& node : nodes_) {
    if (node.object == kNoObject) continue;
    members.push_back(node.object);
    slots_.drop(node.certificate);
  }
  std::sort(members.begin(), members.end());
  construct(std::move(members));
  events_.begin(winner());
}

// All objects hang before the first certificate is made, so only n - 1 are.
void MaximumHanger::construct(std::vector<ObjectId> members) {
  nodes_.clear();
  free_.clear();
  ties_.clear();
  root_ = kNone;
  size_ = 0;
  std::vector<Place> moved;
  for (const ObjectId object : members) {
    moved.clear();
    hang(object, moved);
  }
  for (Place p = 0; p < nodes_.size(); ++p) set_certificate(p);
  settle_ties();
}

// ---- certificates

void MaximumHanger::set_certificate(Place p) {
  Node& node = nodes_[p];
  if (node.parent == kNone) return;
  const Query query = contest_.claim(above(p), node.object);
  if (node.certificate != kNoCertificate && kernel_->claims(node.certificate, query)) return;
  ties_.set(slots_, node.certificate, query, p);
}

void MaximumHanger::set_certificates_below(Place p, Place except) {
  for (const Place child : nodes_[p].child) {
    if (child != kNone && child != except) set_certificate(child);
  }
}

// The object at `child` and its parent change places. The certificate between them comes first: the
// arithmetic reuses its polynomial.
void MaximumHanger::exchange(Place child) {
  const Place parent = nodes_[child].parent;
  const ObjectId up = nodes_[child].object, down = nodes_[parent].object;
  put(parent, up);
  put(child, down);
  set_certificate(child);
  set_certificate(parent);
  set_certificates_below(parent, child);
  set_certificates_below(child, kNone);
}

void MaximumHanger::certificate_failed(CertificateId failed) {
  const Place child = slots_.failed(failed);
  const ObjectId up = nodes_[child].object, down = above(child);
  exchange(child);
  settle_ties();
  events_.repaired(kSwap, {down, up}, winner());
}

// Each exchange moves a smaller id up, so there are at most as many as pairs of an ancestor and a
// descendant.
void MaximumHanger::settle_ties() {
  ties_.settle([this](Place p) {
    if (p >= nodes_.size() || !slots_.is_tie(nodes_[p].certificate)) return;
    const ObjectId up = nodes_[p].object, down = above(p);
    if (down < up) return;
    exchange(p);
    kernel_->report(id_, kTie, {down, up}, false);
  });
}

void MaximumHanger::motions_changed(std::span<const ObjectId> objects) {
  ties_.note_of(slots_, objects);
  settle_ties();
}

// ---- insertion and erasure

// Moves objects only; `moved` collects the places whose object has changed. Returns the new place.
MaximumHanger::Place MaximumHanger::hang(ObjectId object, std::vector<Place>& moved) {
  Place parent = kNone;
  std::size_t side = 0;
  for (Place p = root_; p != kNone; p = nodes_[p].child[side]) {
    const ObjectId there = nodes_[p].object;
    if (contest_.beats(object, there)) {
      put(p, object);
      moved.push_back(p);
      object = there;
    }
    side = coin() ? 1 : 0;
    parent = p;
  }
  if (free_.empty()) {
    free_.push_back(static_cast<Place>(nodes_.size()));
    nodes_.emplace_back();
  }
  const Place place = free_.back();
  free_.pop_back();
  nodes_[place] = Node();
  nodes_[place].parent = parent;
  (parent == kNone ? root_ : nodes_[parent].child[side]) = place;
  put(place, object);
  moved.push_back(place);
  ++size_;
  return place;
}

void MaximumHanger::insert(ObjectId object) {
  std::vector<Place> moved;
  hang(object, moved);
  for (const Place p : moved) set_certificate(p);
  for (const Place p : moved) set_certificates_below(p, kNone);
  settle_ties();
  events_.begin(winner());
}

void MaximumHanger::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  std::vector<Place> moved;
  Place hole = place_of_[object];
  place_of_[object] = kNone;
  for (;;) {
    const auto [left, right] = nodes_[hole].child;
    if (left == kNone && right == kNone) break;
    Place up = left == kNone ? right : left;
    if (left != kNone && right != kNone &&
        contest_.beats(nodes_[right].object, nodes_[left].object)) {
      up = right;
    }
    put(hole, nodes_[up].object);
    moved.push_back(hole);
    hole = up;
  }
  Node& leaf = nodes_[hole];
  slots_.drop(leaf.certificate);
  if (leaf.parent == kNone) {
    root_ = kNone;
  } else {
    std::array<Place, 2>& siblings = nodes_[leaf.parent].child;
    siblings[siblings[0] == hole ? 0 : 1] = kNone;
  }
  leaf = Node();
  free_.push_back(hole);
  --size_;
  for (const Place p : moved) set_certificate(p);
  for (const Place p : moved) set_certificates_below(p, kNone);
  settle_ties();
  events_.begin(winner());
}

// ---- bounds, invariants

// Per place, the number of its ancestors; 0 for free places.
std::vector<std::uint64_t> MaximumHanger::depths() const {
  std::vector<std::uint64_t> result(nodes_.size(), 0);
  std::vector<Place> open;
  if (root_ != kNone) open.push_back(root_);
  while (!open.empty()) {
    const Place p = open.back();
    open.pop_back();
    for (const Place child : nodes_[p].child) {
      if (child == kNone) continue;
      result[child] = result[p] + 1;
      open.push_back(child);
    }
  }
  return result;
}

std::size_t MaximumHanger::depth() const {
  const std::vector<std::uint64_t> all = depths();
  return all.empty() ? 0 : static_cast<std::size_t>(*std::max_element(all.begin(), all.end()));
}

std::vector<BoundCheck> MaximumHanger::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context);
  const std::string own(name());
  if (contest_.order().reference() == kNoObject) {
    result.push_back(at_most(own + ".locality", "a parent and two children", Integer(3),
                             counted(context.ledger->max_per_object)));
  }
  if (context.plain() && contest_.order().degree(context.degree) <= 1) {
    std::uint64_t pairs = 0;
    for (const std::uint64_t d : depths()) pairs += d;
    result.push_back(at_most(own + ".events",
                             "affine motions: pairs of an ancestor and a descendant in the tree; "
                             "the argument of Basch, Guibas, Ramkumar 1996",
                             counted(pairs), counted(context.ledger->failures)));
  } else {
    result.push_back(crossing_bound(name(), contest_.order(), context));
  }
  return result;
}

void MaximumHanger::check_invariants(AuditReport& report) const {
  check_told(report);
  std::size_t found = 0;
  for (Place p = 0; p < nodes_.size(); ++p) {
    const Node& node = nodes_[p];
    if (node.object == kNoObject) continue;
    ++found;
    const auto where = [&] { return " at place " + std::to_string(p); };
    report.check(place_of_[node.object] == p, [&] { return "a lost object" + where(); });
    for (const Place child : node.child) {
      report.check(
          child == kNone || (nodes_[child].parent == p && nodes_[child].object != kNoObject),
          [&] { return "a broken link" + where(); });
    }
    const CertificateId c = node.certificate;
    if (node.parent == kNone) {
      report.check(p == root_ && c == kNoCertificate, [&] { return "a second root" + where(); });
      continue;
    }
    const ObjectId parent = nodes_[node.parent].object;
    report.check(slots_.holds(c, contest_.claim(parent, node.object), p),
                 [&] { return "a certificate of something else" + where(); });
    report.check(!slots_.is_tie(c) || parent < node.object,
                 [&] { return "a tie in the wrong order" + where(); });
  }
  report.check(found == size_, [] { return std::string("a wrong number of objects"); });
}

std::size_t MaximumHanger::bytes() const {
  return nodes_.capacity() * sizeof(Node) +
         (free_.capacity() + place_of_.capacity()) * sizeof(Place) + ties_.bytes();
}

}  // namespace kinex
