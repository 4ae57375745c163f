// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_tournament.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {

MaximumTournament::MaximumTournament(Kernel& kernel, StructureId id, const Key& key,
                                     const Scene& scene, Extremum extremum)
    : kernel_(&kernel),
      id_(id),
      contest_(extremum, kernel, key, scene),
      events_(kernel, id, kReplace),
      leaf_of_(scene.objects.size(), 0) {}

std::string_view MaximumTournament::name() const {
  return contest_.extremum() == Extremum::kMaximum ? "maximum_tournament" : "minimum_tournament";
}

std::vector<std::string_view> MaximumTournament::event_kinds() const {
  return common_event_kinds({"replace", "tie"});
}

void MaximumTournament::build(std::span<const ObjectId> objects) {
  construct(contest_.order().members(objects));
  events_.begin(winner());
}

void MaximumTournament::rebuild() {
  std::vector<ObjectId> members;
  for (std::size_t v = leaves_; v < 2 * leaves_; ++v) members.push_back(winner_[v]);
  for (std::size_t v = 1; v < leaves_; ++v) kernel_->retract(certificate_[v]);
  construct(std::move(members));
  events_.begin(winner());
}

void MaximumTournament::construct(std::vector<ObjectId> members) {
  leaves_ = members.size();
  winner_.assign(2 * std::max<std::size_t>(leaves_, 1), kNoObject);
  certificate_.assign(std::max<std::size_t>(leaves_, 1), kNoCertificate);
  for (std::size_t i = 0; i < leaves_; ++i) {
    winner_[leaves_ + i] = members[i];
    leaf_of_[members[i]] = static_cast<Node>(leaves_ + i);
  }
  for (std::size_t v = leaves_; v-- > 1;) decide(static_cast<Node>(v));
  ++trees_[leaves_];
}

// ---- epochs

// v's descendants k levels below it are v 2^k .. (v + 1) 2^k - 1. Counts those on the lowest level,
// in pairs of siblings, and those one level above without children.
std::size_t MaximumTournament::leaves_below(Node v) const {
  std::size_t width = 1;
  while (2 * width * v < 2 * leaves_) width *= 2;
  if (width == 1) return 1;
  const std::size_t lowest = std::min(width, 2 * leaves_ - width * v);
  return width / 2 + lowest / 2;
}

// Changes begin at these nodes: sorts them and adds all nodes above them, children first.
void MaximumTournament::begin_epochs(std::vector<Node>& nodes) {
  const std::size_t given = nodes.size();
  for (std::size_t i = 0; i < given; ++i) {
    for (Node v = nodes[i] / 2; v >= 1; v /= 2) nodes.push_back(v);
  }
  std::sort(nodes.begin(), nodes.end(), std::greater<>());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  while (!nodes.empty() && nodes.back() == 0) nodes.pop_back();
  for (const Node v : nodes) ++epochs_[leaves_below(v)];
}

// ---- certificates

// `winner` has won, or is expected to: if it has not, the certificate fails at once.
void MaximumTournament::set_node(Node v, ObjectId winner, ObjectId loser) {
  const auto certify = [&] {
    const Query query = contest_.claim(winner, loser);
    CertificateId& c = certificate_[v];
    if (c != kNoCertificate) return kernel_->replace(c, query, v);
    const Kernel::Created created = kernel_->create(id_, query, v);
    c = created.id;
    return created.outlook;
  };
  if (certify() == Outlook::kIdenticallyZero && loser < winner) {
    std::swap(winner, loser);
    certify();
    kernel_->report(id_, kTie, {loser, winner}, false);
  }
  winner_[v] = winner;
}

// The other child's winner becomes the winner of v, and so on upwards to where it loses. Wherever
// the old winner won it was at least as good as its opponent, and the new one is better still right
// after now.
void MaximumTournament::flip(Node v) {
  ObjectId old = winner_[v], fresh = loser(v);
  set_node(v, fresh, old);
  while (v > 1 && old != (fresh = winner_[v])) {
    const ObjectId sibling = winner_[v ^ 1];
    v /= 2;
    const ObjectId before = winner_[v];
    if (before == old) {
      set_node(v, fresh, sibling);
    } else {
      set_node(v, sibling, fresh);
    }
    old = before;
  }
}

void MaximumTournament::certificate_failed(CertificateId failed) {
  const Node v = kernel_->tag(failed);
  const ObjectId old = winner_[v], fresh = loser(v);
  flip(v);
  events_.repaired(kReplace, old, fresh, winner());
}

void MaximumTournament::motions_changed(std::span<const ObjectId> objects) {
  std::vector<Node> ties;
  bool everywhere = false;  // the reference of the distances has a new motion
  touched_.clear();
  for (const ObjectId object : objects) {
    everywhere = everywhere || leaf_of_[object] == 0;
    touched_.push_back(leaf_of_[object] / 2);
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (kernel_->is_tie_of(id_, c)) ties.push_back(kernel_->tag(c));
    }
  }
  if (everywhere) {
    ++trees_[leaves_];
  } else {
    begin_epochs(touched_);
  }
  std::sort(ties.begin(), ties.end(), std::greater<>());
  for (const Node v : ties) {
    const ObjectId old = winner_[v], fresh = loser(v);
    if (kernel_->outlook(certificate_[v]) != Outlook::kIdenticallyZero || old < fresh) continue;
    flip(v);
    kernel_->report(id_, kTie, {old, fresh}, false);
  }
}

// ---- insertion and erasure

// Compares the two children's winners, unless they are the opponents of last time.
void MaximumTournament::decide(Node v) {
  const ObjectId a = winner_[2 * v], b = winner_[2 * v + 1];
  if (certificate_[v] != kNoCertificate) {
    const Query& query = kernel_->query(certificate_[v]);
    if (query == contest_.claim(a, b) || query == contest_.claim(b, a)) return;
  }
  if (contest_.beats(a, b)) {
    set_node(v, a, b);
  } else {
    set_node(v, b, a);
  }
}

// Decides all nodes on the paths from these inner nodes to the root, children first, after an
// insertion or erasure.
void MaximumTournament::replay(Node a, Node b) {
  touched_.assign({a, b});
  begin_epochs(touched_);
  for (const Node v : touched_) decide(v);
  events_.begin(winner());
}

// The first leaf becomes an inner node above its object and the new one.
void MaximumTournament::insert(ObjectId object) {
  const Node v = static_cast<Node>(leaves_);
  ++leaves_;
  winner_.resize(2 * leaves_, kNoObject);
  certificate_.resize(leaves_, kNoCertificate);
  if (leaves_ == 1) {
    winner_[1] = object;
    leaf_of_[object] = 1;
    return events_.begin(object);
  }
  winner_[2 * v] = winner_[v];
  winner_[2 * v + 1] = object;
  leaf_of_[winner_[v]] = 2 * v;
  leaf_of_[object] = 2 * v + 1;
  replay(v, 0);
}

// The last two leaves are removed: one moves up into their parent, the other to the place of the
// erased object.
void MaximumTournament::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  const Node hole = leaf_of_[object];
  leaf_of_[object] = 0;
  --leaves_;
  if (leaves_ == 0) {
    winner_[1] = kNoObject;
    return events_.begin(kNoObject);
  }
  const Node parent = static_cast<Node>(leaves_);
  const ObjectId a = winner_[2 * parent], b = winner_[2 * parent + 1];
  kernel_->retract(certificate_[parent]);
  certificate_.resize(leaves_);
  winner_.resize(2 * leaves_);
  const ObjectId up = object == a ? b : a;
  winner_[parent] = up;
  leaf_of_[up] = parent;
  Node above_hole = 0;
  if (object != a && object != b) {
    winner_[hole] = b;
    leaf_of_[b] = hole;
    above_hole = hole / 2;
  }
  replay(parent / 2, above_hole);
}

// ---- attribute, bounds, invariants

Attribute MaximumTournament::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (leaves_ > 0) result.ids.push_back(winner_[1]);
  return result;
}

std::vector<BoundCheck> MaximumTournament::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context);
  const Integer n(static_cast<std::int64_t>(contest_.order().member_pieces(context).size()));
  std::int64_t depth = 0;
  while (Integer::power_of_two(static_cast<unsigned long>(depth)) < n) ++depth;
  if (contest_.order().reference() == kNoObject) {
    result.push_back(at_most(std::string(name()) + ".locality",
                             "an object plays at most once per level: ceil(log2 n)", Integer(depth),
                             Integer(static_cast<std::int64_t>(context.ledger->max_per_object))));
  }
  const int degree = contest_.order().degree(context.degree);
  Integer events(0);
  const auto add = [&](std::size_t leaves, std::uint64_t epochs) {
    events +=
        Integer(static_cast<std::int64_t>(epochs)) *
        (davenport_schinzel_bound(degree, Integer(static_cast<std::int64_t>(leaves))) - Integer(1));
  };
  for (const auto& [leaves, epochs] : epochs_) add(leaves, epochs);
  for (const auto& [leaves, trees] : trees_) {
    std::vector<std::size_t> below(2 * std::max<std::size_t>(leaves, 1), 1);
    std::map<std::size_t, std::uint64_t> nodes;
    for (std::size_t v = leaves; v-- > 1;) {
      below[v] = below[2 * v] + below[2 * v + 1];
      ++nodes[below[v]];
    }
    for (const auto& [size, count] : nodes) add(size, trees * count);
  }
  result.push_back(at_most(std::string(name()) + ".events",
                           "sum over nodes, and their epochs between changes below, of the changes "
                           "of the upper envelope of their leaves, Davenport-Schinzel numbers; "
                           "Guibas 1998, section 5",
                           events, Integer(static_cast<std::int64_t>(context.ledger->failures))));
  return result;
}

std::size_t MaximumTournament::bytes() const {
  return winner_.capacity() * sizeof(ObjectId) + certificate_.capacity() * sizeof(CertificateId) +
         (leaf_of_.capacity() + touched_.capacity()) * sizeof(Node) +
         (epochs_.size() + trees_.size()) * 64;  // nodes of maps, about
}

}  // namespace kinex
