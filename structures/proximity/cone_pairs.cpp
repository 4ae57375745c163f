// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_pairs.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace kinex {
namespace {

// splitmix64: priorities of treaps that are the same everywhere.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Calls better(a, b): a is to be kept rather than b.
struct KeepOne {
  static constexpr std::size_t kKept = 1;
  static constexpr std::array<std::array<std::uint8_t, 2>, 1> kOffered{{{0, 0}}};
  using Points = std::array<ObjectId, kKept>;

  template <class Better>
  void add(Points& kept, ObjectId point, const Better& better) const {
    if (kept[0] == kNoObject || better(point, kept[0])) kept[0] = point;
  }
};

struct KeepTwo {  // the better one first
  static constexpr std::size_t kKept = 2;
  static constexpr std::array<std::array<std::uint8_t, 2>, 3> kOffered{{{0, 0}, {0, 1}, {1, 0}}};
  using Points = std::array<ObjectId, kKept>;

  template <class Better>
  void add(Points& kept, ObjectId point, const Better& better) const {
    if (kept[0] == kNoObject || better(point, kept[0])) std::swap(kept[0], point);
    if (point == kNoObject) return;
    if (kept[1] == kNoObject || better(point, kept[1])) kept[1] = point;
  }
};

struct KeepOneOfEachColour {
  static constexpr std::size_t kKept = 2;
  static constexpr std::array<std::array<std::uint8_t, 2>, 2> kOffered{{{0, 1}, {1, 0}}};
  using Points = std::array<ObjectId, kKept>;
  const TwoClasses* classes;

  template <class Better>
  void add(Points& kept, ObjectId point, const Better& better) const {
    ObjectId& one = kept[classes->is_first(point) ? 0 : 1];
    if (one == kNoObject || better(point, one)) one = point;
  }
};

template <class Kept>
class Treaps final : public ConePairs {
 public:
  Treaps(Kept kept, const Orders& orders, std::size_t objects, Offered offered)
      : kept_(kept),
        alpha_(orders.alpha),
        beta_(orders.beta),
        projection_(orders.projection),
        objects_(objects),
        offered_(std::move(offered)) {}

  void build(std::span<const ObjectId> points) override;
  void alpha_changed(ObjectId a, ObjectId b) override;
  void beta_changed(ObjectId a, ObjectId b) override;
  void projection_changed(ObjectId a, ObjectId b) override;
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffffu;
  using Points = typename Kept::Points;
  static constexpr std::size_t kOffers = Kept::kOffered.size();
  struct Offer {
    ObjectId looker = kNoObject, seen = kNoObject;
    friend bool operator==(const Offer&, const Offer&) = default;
  };
  using Offers = std::array<Offer, 2 * kOffers>;
  static constexpr Points nothing() {
    Points none;
    none.fill(kNoObject);
    return none;
  }
  struct TreapNode {
    ObjectId object = kNoObject;
    bool looks = false;
    std::uint64_t priority = 0;
    std::array<Node, 2> child{kNone, kNone};
    Node parent = kNone;
    Points last = nothing(), first = nothing();  // lookers and seen, of the subtree
    Offers offers;
  };
  // A node of the tree over places, on the way to a leaf.
  struct Step {
    std::size_t tree;      // its number: 1 for the root, 2v and 2v + 1 for the children of v
    std::uint32_t middle;  // the first place of its right child
  };

  std::vector<Step> way_to(std::uint32_t place) const;
  void keep_last(Points& kept, ObjectId looker) const {
    if (looker == kNoObject) return;
    kept_.add(kept, looker, [this](ObjectId a, ObjectId b) { return projection_.before(b, a); });
  }
  void keep_first(Points& kept, ObjectId seen) const {
    if (seen == kNoObject) return;
    kept_.add(kept, seen, [this](ObjectId a, ObjectId b) { return projection_.before(a, b); });
  }
  // Into offers, from a place on: lookers with seen.
  static void pair_up(Offers& offers, std::size_t from, const Points& lookers, const Points& seen) {
    for (const auto& [i, j] : Kept::kOffered) {
      Offer& offer = offers[from++];
      if (lookers[i] != kNoObject && seen[j] != kNoObject) offer = {lookers[i], seen[j]};
    }
  }
  void set_offers(TreapNode& node, const Offers& offers);
  void renew(Node t);
  void renew_upwards(Node t);
  void rotate_up(Node t);
  void insert(std::size_t tree, std::size_t depth, ObjectId object, bool looks);
  void erase(std::size_t tree, std::size_t depth, ObjectId object);
  Node& node_of(std::size_t depth, ObjectId object) { return node_of_[depth][object]; }
  void check_subtree(Node t, Node parent, std::vector<ObjectId>& order, AuditReport& report) const;

  Kept kept_;
  PlacesAlong alpha_, beta_, projection_;
  std::size_t objects_;
  Offered offered_;
  std::size_t size_ = 0;
  std::vector<Node> root_;                  // of the treap of a tree node
  std::vector<std::vector<Node>> node_of_;  // by depth and object
  std::vector<TreapNode> nodes_;
  std::vector<Node> free_;
};

// ---- what is kept and offered

template <class Kept>
void Treaps<Kept>::set_offers(TreapNode& node, const Offers& offers) {
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const Offer old = node.offers[i], fresh = offers[i];
    if (old == fresh) continue;
    if (old.looker != kNoObject) offered_(old.looker, old.seen, -1);
    node.offers[i] = fresh;
    if (fresh.looker != kNoObject) offered_(fresh.looker, fresh.seen, 1);
  }
}

// From its children.
template <class Kept>
void Treaps<Kept>::renew(Node t) {
  TreapNode& node = nodes_[t];
  const auto [left, right] = node.child;
  const Points before = left == kNone ? nothing() : nodes_[left].last;
  const Points after = right == kNone ? nothing() : nodes_[right].first;
  Points looker = nothing(), from_here = after;
  if (node.looks) {
    keep_last(looker, node.object);
  } else {
    keep_first(from_here, node.object);
  }
  node.last = before;
  for (const ObjectId one : looker) keep_last(node.last, one);
  if (right != kNone) {
    for (const ObjectId one : nodes_[right].last) keep_last(node.last, one);
  }
  node.first = from_here;
  if (left != kNone) {
    for (const ObjectId one : nodes_[left].first) keep_first(node.first, one);
  }
  Offers offers;
  pair_up(offers, 0, before, from_here);
  pair_up(offers, kOffers, looker, after);
  set_offers(node, offers);
}

template <class Kept>
void Treaps<Kept>::renew_upwards(Node t) {
  for (; t != kNone; t = nodes_[t].parent) renew(t);
}

// ---- treaps

// t takes the place of its parent, which becomes its child. The aggregates above stay.
template <class Kept>
void Treaps<Kept>::rotate_up(Node t) {
  const Node p = nodes_[t].parent, g = nodes_[p].parent;
  const std::size_t side = nodes_[p].child[1] == t ? 1 : 0;
  const Node inner = nodes_[t].child[1 - side];
  nodes_[p].child[side] = inner;
  if (inner != kNone) nodes_[inner].parent = p;
  nodes_[t].child[1 - side] = p;
  nodes_[p].parent = t;
  nodes_[t].parent = g;
  if (g != kNone) nodes_[g].child[nodes_[g].child[1] == p ? 1 : 0] = t;
}

template <class Kept>
void Treaps<Kept>::insert(std::size_t tree, std::size_t depth, ObjectId object, bool looks) {
  Node t;
  if (free_.empty()) {
    t = static_cast<Node>(nodes_.size());
    nodes_.emplace_back();
  } else {
    t = free_.back();
    free_.pop_back();
  }
  TreapNode& node = nodes_[t];
  node.object = object;
  node.looks = looks;
  node.priority = mixed(tree * objects_ + object);
  node_of(depth, object) = t;
  Node above = kNone;
  std::size_t side = 0;
  for (Node s = root_[tree]; s != kNone; s = nodes_[s].child[side]) {
    above = s;
    side = beta_.before(nodes_[s].object, object) ? 1 : 0;
  }
  node.parent = above;
  if (above != kNone) nodes_[above].child[side] = t;
  while (nodes_[t].parent != kNone && nodes_[nodes_[t].parent].priority < nodes_[t].priority) {
    const Node down = nodes_[t].parent;
    rotate_up(t);
    renew(down);
  }
  if (nodes_[t].parent == kNone) root_[tree] = t;
  renew_upwards(t);
}

template <class Kept>
void Treaps<Kept>::erase(std::size_t tree, std::size_t depth, ObjectId object) {
  const Node t = node_of(depth, object);
  node_of(depth, object) = kNone;
  for (;;) {  // downwards, until it is a leaf
    const auto [left, right] = nodes_[t].child;
    if (left == kNone && right == kNone) break;
    const bool up_left =
        right == kNone || (left != kNone && nodes_[left].priority > nodes_[right].priority);
    const Node up = up_left ? left : right;
    rotate_up(up);
    if (nodes_[up].parent == kNone) root_[tree] = up;
  }
  TreapNode& node = nodes_[t];
  const Node above = node.parent;
  if (above == kNone) {
    root_[tree] = kNone;
  } else {
    nodes_[above].child[nodes_[above].child[1] == t ? 1 : 0] = kNone;
  }
  set_offers(node, {});
  node = TreapNode{};
  free_.push_back(t);
  renew_upwards(above);
}

// ---- the tree over places

// The inner nodes above a leaf, from the root.
template <class Kept>
std::vector<typename Treaps<Kept>::Step> Treaps<Kept>::way_to(std::uint32_t place) const {
  std::vector<Step> way;
  std::size_t tree = 1;
  std::uint32_t begin = 0, end = static_cast<std::uint32_t>(size_);
  while (end - begin > 1) {
    const std::uint32_t middle = begin + (end - begin) / 2;
    way.push_back({tree, middle});
    const bool right = place >= middle;
    (right ? begin : end) = middle;
    tree = 2 * tree + (right ? 1 : 0);
  }
  return way;
}

template <class Kept>
void Treaps<Kept>::build(std::span<const ObjectId> points) {
  for (TreapNode& node : nodes_) set_offers(node, {});
  nodes_.clear();
  free_.clear();
  size_ = points.size();
  std::size_t depth = 0;
  while ((std::size_t{1} << depth) < size_) ++depth;
  root_.assign(std::size_t{2} << depth, kNone);
  node_of_.assign(depth, std::vector<Node>(objects_, kNone));
  for (const ObjectId object : points) {
    const std::uint32_t place = alpha_.place(object, size_);
    std::size_t level = 0;
    for (const Step& step : way_to(place)) {
      insert(step.tree, level++, object, place < step.middle);
    }
  }
}

// ---- two neighbours that have changed places

// Below the node at which they part each takes the other's place; at it they change their roles.
template <class Kept>
void Treaps<Kept>::alpha_changed(ObjectId a, ObjectId b) {
  if (alpha_.before(b, a)) std::swap(a, b);  // a is in front now
  const std::uint32_t front = alpha_.place(a, size_);
  const std::vector<Step> left = way_to(front), right = way_to(front + 1);
  std::size_t parting = 0;
  while (left[parting].middle != front + 1) ++parting;
  for (std::size_t level = parting + 1; level < left.size(); ++level) {
    erase(left[level].tree, level, b);
  }
  for (std::size_t level = parting + 1; level < right.size(); ++level) {
    erase(right[level].tree, level, a);
  }
  for (std::size_t level = parting + 1; level < left.size(); ++level) {
    insert(left[level].tree, level, a, front < left[level].middle);
  }
  for (std::size_t level = parting + 1; level < right.size(); ++level) {
    insert(right[level].tree, level, b, front + 1 < right[level].middle);
  }
  nodes_[node_of(parting, a)].looks = true;
  nodes_[node_of(parting, b)].looks = false;
  renew_upwards(node_of(parting, a));
  renew_upwards(node_of(parting, b));
}

// In every treap that has both they are neighbours: they change nodes.
template <class Kept>
void Treaps<Kept>::beta_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = way_to(alpha_.place(a, size_));
  const std::vector<Step> other = way_to(alpha_.place(b, size_));
  for (std::size_t level = 0; level < std::min(one.size(), other.size()); ++level) {
    if (one[level].tree != other[level].tree) return;
    const Node s = node_of(level, a), t = node_of(level, b);
    std::swap(nodes_[s].object, nodes_[t].object);
    std::swap(nodes_[s].looks, nodes_[t].looks);
    std::swap(node_of(level, a), node_of(level, b));
    renew_upwards(s);
    renew_upwards(t);
  }
}

template <class Kept>
void Treaps<Kept>::projection_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = way_to(alpha_.place(a, size_));
  const std::vector<Step> other = way_to(alpha_.place(b, size_));
  for (std::size_t level = 0; level < std::min(one.size(), other.size()); ++level) {
    if (one[level].tree != other[level].tree) return;
    const Node s = node_of(level, a), t = node_of(level, b);
    if (nodes_[s].looks != nodes_[t].looks) return;  // they part here
    renew_upwards(s);
    renew_upwards(t);
  }
}

// ---- checks

template <class Kept>
void Treaps<Kept>::check_subtree(Node t, Node parent, std::vector<ObjectId>& order,
                                 AuditReport& report) const {
  if (t == kNone) return;
  const TreapNode& node = nodes_[t];
  report.check(node.parent == parent, [] { return "a broken link in a treap"; });
  const std::size_t begin = order.size();
  check_subtree(node.child[0], t, order, report);
  const std::size_t own = order.size();
  order.push_back(node.object);
  check_subtree(node.child[1], t, order, report);
  const auto looks = [&](ObjectId object) {
    for (const auto& level : node_of_) {
      if (level[object] == kNone) continue;
      Node top = level[object];
      while (nodes_[top].parent != kNone) top = nodes_[top].parent;
      Node mine = t;
      while (nodes_[mine].parent != kNone) mine = nodes_[mine].parent;
      if (top == mine) return nodes_[level[object]].looks;
    }
    return false;
  };
  Points last = nothing(), first = nothing(), before = nothing(), from_here = nothing();
  Points looker = nothing(), after = nothing();
  for (std::size_t i = begin; i < order.size(); ++i) {
    if (looks(order[i])) {
      keep_last(last, order[i]);
      if (i < own) keep_last(before, order[i]);
      if (i == own) keep_last(looker, order[i]);
    } else {
      keep_first(first, order[i]);
      if (i >= own) keep_first(from_here, order[i]);
      if (i > own) keep_first(after, order[i]);
    }
  }
  report.check(node.last == last && node.first == first,
               [] { return "a treap that keeps other points"; });
  Offers offers;
  pair_up(offers, 0, before, from_here);
  pair_up(offers, kOffers, looker, after);
  report.check(node.offers == offers, [] { return "a wrong offer"; });
}

template <class Kept>
void Treaps<Kept>::check(AuditReport& report) const {
  for (const Node root : root_) {
    std::vector<ObjectId> order;
    check_subtree(root, kNone, order, report);
    for (std::size_t i = 1; i < order.size(); ++i) {
      report.check(beta_.before(order[i - 1], order[i]), [] { return "a treap in another order"; });
    }
  }
}

template <class Kept>
std::size_t Treaps<Kept>::bytes() const {
  std::size_t total = root_.capacity() * sizeof(Node) + nodes_.capacity() * sizeof(TreapNode) +
                      free_.capacity() * sizeof(Node);
  for (const auto& level : node_of_) total += level.capacity() * sizeof(Node);
  return total;
}

}  // namespace

std::size_t most_offers(KeptPoints kept) {
  switch (kept) {
    case KeptPoints::kOne:
      return 2;
    case KeptPoints::kTwo:
      return 5;  // 3 and 2
    case KeptPoints::kOneOfEachColour:
      return 3;  // 2 and 1
  }
  throw std::invalid_argument("no such points to keep");
}

std::unique_ptr<ConePairs> make_cone_pairs(KeptPoints kept, const ConePairs::Orders& orders,
                                           std::size_t objects, const TwoClasses* classes,
                                           ConePairs::Offered offered) {
  const auto make = [&](auto keep) -> std::unique_ptr<ConePairs> {
    return std::make_unique<Treaps<decltype(keep)>>(keep, orders, objects, std::move(offered));
  };
  switch (kept) {
    case KeptPoints::kOne:
      return make(KeepOne{});
    case KeptPoints::kTwo:
      return make(KeepTwo{});
    case KeptPoints::kOneOfEachColour:
      return make(KeepOneOfEachColour{classes});
  }
  throw std::invalid_argument("no such points to keep");
}

}  // namespace kinex
