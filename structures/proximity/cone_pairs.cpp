// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_pairs.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "structures/proximity/place_tree.h"

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
        offered_(std::move(offered)),
        places_(objects) {}

  void build(std::span<const ObjectId> points) override;
  void insert(ObjectId object, ObjectId previous) override;
  void erase(ObjectId object) override;
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
  using Step = PlaceTree::Step;

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
  // Into and out of the treap of a node of the tree over places.
  void plant(Step step, std::size_t depth, ObjectId object);
  void uproot(PlaceTree::Node tree, std::size_t depth, ObjectId object);
  // All treaps below such a node go; they come back with points that are inserted one by one.
  void clear(PlaceTree::Node subtree);
  void fill(PlaceTree::Node subtree, std::span<const ObjectId> points);
  Node& node_of(std::size_t depth, ObjectId object) { return node_of_[depth][object]; }
  void check_subtree(Node t, Node parent, const std::vector<bool>& looks,
                     std::vector<ObjectId>& order, AuditReport& report) const;

  Kept kept_;
  PlacesAlong alpha_, beta_, projection_;
  std::size_t objects_;
  Offered offered_;
  PlaceTree places_;
  std::vector<Node> root_;                  // of the treap of a node of places_
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
void Treaps<Kept>::plant(Step step, std::size_t depth, ObjectId object) {
  if (depth == node_of_.size()) node_of_.emplace_back(objects_, kNone);
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
  node.looks = !step.right;
  node.priority = mixed(places_.number(step.node) * objects_ + object);
  node_of(depth, object) = t;
  Node above = kNone;
  std::size_t side = 0;
  for (Node s = root_[step.node]; s != kNone; s = nodes_[s].child[side]) {
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
  if (nodes_[t].parent == kNone) root_[step.node] = t;
  renew_upwards(t);
}

template <class Kept>
void Treaps<Kept>::uproot(PlaceTree::Node tree, std::size_t depth, ObjectId object) {
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

template <class Kept>
void Treaps<Kept>::clear(PlaceTree::Node subtree) {
  for (const PlaceTree::Node tree : places_.inner_nodes(subtree)) {
    const std::size_t depth = places_.depth(tree);
    std::vector<Node> left;
    const auto later = [&](Node t) {
      if (t != kNone) left.push_back(t);
    };
    later(std::exchange(root_[tree], kNone));
    while (!left.empty()) {
      const Node t = left.back();
      left.pop_back();
      for (const Node child : nodes_[t].child) later(child);
      node_of(depth, nodes_[t].object) = kNone;
      set_offers(nodes_[t], {});
      nodes_[t] = TreapNode{};
      free_.push_back(t);
    }
  }
}

template <class Kept>
void Treaps<Kept>::fill(PlaceTree::Node subtree, std::span<const ObjectId> points) {
  if (root_.size() < places_.capacity()) root_.resize(places_.capacity(), kNone);
  const std::size_t top = places_.depth(subtree);
  for (const ObjectId object : points) {
    const std::vector<Step> way = places_.way_to(object);
    for (std::size_t depth = top; depth < way.size(); ++depth) plant(way[depth], depth, object);
  }
}

template <class Kept>
void Treaps<Kept>::build(std::span<const ObjectId> points) {
  if (places_.root() != kNone) clear(places_.root());
  std::vector<ObjectId> order(points.begin(), points.end());
  std::sort(order.begin(), order.end(),
            [this](ObjectId a, ObjectId b) { return alpha_.before(a, b); });
  places_.build(order);
  nodes_.clear();
  free_.clear();
  root_.clear();
  if (!order.empty()) fill(places_.root(), points);
}

template <class Kept>
void Treaps<Kept>::insert(ObjectId object, ObjectId previous) {
  const PlaceTree::Node subtree = places_.subtree_to_insert(previous);
  if (subtree != kNone) clear(subtree);
  places_.insert(object, previous, subtree);
  if (subtree == kNone) return fill(places_.root(), {});
  fill(subtree, places_.objects(subtree));
  const std::vector<Step> way = places_.way_to(object);
  const std::size_t above = places_.depth(subtree);
  for (std::size_t depth = 0; depth < above; ++depth) plant(way[depth], depth, object);
}

template <class Kept>
void Treaps<Kept>::erase(ObjectId object) {
  const PlaceTree::Node subtree = places_.subtree_to_erase(object);
  clear(subtree);
  const std::vector<Step> way = places_.way_to(object);
  const std::size_t above = places_.depth(subtree);
  for (std::size_t depth = 0; depth < above; ++depth) uproot(way[depth].node, depth, object);
  places_.erase(object, subtree);
  if (places_.size() > 0) fill(subtree, places_.objects(subtree));
}

// ---- two neighbours that have changed places

// Below the node at which they part each takes the other's place; at it they change their roles.
template <class Kept>
void Treaps<Kept>::alpha_changed(ObjectId a, ObjectId b) {
  if (alpha_.before(b, a)) std::swap(a, b);  // a is in front now
  const std::vector<Step> left = places_.way_to(b), right = places_.way_to(a);
  std::size_t parting = 0;
  while (left[parting].right == right[parting].right) ++parting;
  for (std::size_t depth = parting + 1; depth < left.size(); ++depth) {
    uproot(left[depth].node, depth, b);
  }
  for (std::size_t depth = parting + 1; depth < right.size(); ++depth) {
    uproot(right[depth].node, depth, a);
  }
  places_.exchange(a, b);
  for (std::size_t depth = parting + 1; depth < left.size(); ++depth) plant(left[depth], depth, a);
  for (std::size_t depth = parting + 1; depth < right.size(); ++depth) {
    plant(right[depth], depth, b);
  }
  nodes_[node_of(parting, a)].looks = true;
  nodes_[node_of(parting, b)].looks = false;
  renew_upwards(node_of(parting, a));
  renew_upwards(node_of(parting, b));
}

// In every treap that has both they are neighbours: they change nodes.
template <class Kept>
void Treaps<Kept>::beta_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = places_.way_to(a), other = places_.way_to(b);
  for (std::size_t depth = 0; depth < std::min(one.size(), other.size()); ++depth) {
    if (one[depth].node != other[depth].node) return;
    const Node s = node_of(depth, a), t = node_of(depth, b);
    std::swap(nodes_[s].object, nodes_[t].object);
    std::swap(nodes_[s].looks, nodes_[t].looks);
    std::swap(node_of(depth, a), node_of(depth, b));
    renew_upwards(s);
    renew_upwards(t);
  }
}

template <class Kept>
void Treaps<Kept>::projection_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = places_.way_to(a), other = places_.way_to(b);
  for (std::size_t depth = 0; depth < std::min(one.size(), other.size()); ++depth) {
    const Node s = node_of(depth, a), t = node_of(depth, b);
    if (one[depth].right != other[depth].right) return;  // they part here
    renew_upwards(s);
    renew_upwards(t);
  }
}

// ---- checks

// looks: by object.
template <class Kept>
void Treaps<Kept>::check_subtree(Node t, Node parent, const std::vector<bool>& looks,
                                 std::vector<ObjectId>& order, AuditReport& report) const {
  if (t == kNone) return;
  const TreapNode& node = nodes_[t];
  report.check(node.parent == parent, [] { return "a broken link in a treap"; });
  report.check(node.looks == looks[node.object], [] { return "a point in the wrong role"; });
  const std::size_t begin = order.size();
  check_subtree(node.child[0], t, looks, order, report);
  const std::size_t own = order.size();
  order.push_back(node.object);
  check_subtree(node.child[1], t, looks, order, report);
  Points last = nothing(), first = nothing(), before = nothing(), from_here = nothing();
  Points looker = nothing(), after = nothing();
  for (std::size_t i = begin; i < order.size(); ++i) {
    if (looks[order[i]]) {
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
  report.check(places_.consistent(), [] { return "a tree over places that is broken"; });
  const std::vector<ObjectId> points = places_.objects(places_.root());
  report.check(std::is_sorted(points.begin(), points.end(),
                              [this](ObjectId a, ObjectId b) { return alpha_.before(a, b); }),
               [] { return "a tree over places in another order"; });
  std::size_t nodes = 0;
  for (const PlaceTree::Node tree : places_.inner_nodes(places_.root())) {
    const std::size_t depth = places_.depth(tree);
    std::vector<bool> looks(objects_);
    std::vector<ObjectId> below = places_.objects(tree), order;
    for (const ObjectId object : below) {
      looks[object] = !places_.way_to(object)[depth].right;
      const Node t = node_of_[depth][object];
      report.check(t != kNone && nodes_[t].object == object, [] { return "a lost treap node"; });
    }
    check_subtree(root_[tree], kNone, looks, order, report);
    report.check(std::is_sorted(order.begin(), order.end(),
                                [this](ObjectId a, ObjectId b) { return beta_.before(a, b); }),
                 [] { return "a treap in another order"; });
    nodes += order.size();
    std::sort(below.begin(), below.end());
    std::sort(order.begin(), order.end());
    report.check(below == order, [] { return "a treap of other points"; });
  }
  report.check(nodes + free_.size() == nodes_.size(), [] { return "treap nodes of no treap"; });
}

template <class Kept>
std::size_t Treaps<Kept>::bytes() const {
  std::size_t total = places_.bytes() + root_.capacity() * sizeof(Node) +
                      nodes_.capacity() * sizeof(TreapNode) + free_.capacity() * sizeof(Node);
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
