// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/farthest_delaunay_2.h"

#include <algorithm>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

FarthestDelaunay2::FarthestDelaunay2(Kernel& kernel, StructureId id, const Scene& scene,
                                     const HullSource& hull)
    : kernel_(&kernel),
      id_(id),
      hull_(&hull),
      in_circle_(kernel.bind(make_in_circle_2())),
      slots_(kernel, id, "diagonals"),
      store_(scene.objects.size()) {}

void FarthestDelaunay2::give_up(const char* what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

bool FarthestDelaunay2::repeats(const Query& failed) {
  return !kernel_->is_exact() && repeats_.failed(failed);
}

// ---- certificates

// "q is not outside the circle through u, v, p" by an even permutation: "u is not inside the circle
// through v, q, p", which is clockwise.
Query FarthestDelaunay2::query_of(HalfEdge h) const {
  return Query(in_circle_,
               {store_.target(h), store_.apex(store_.twin(h)), store_.apex(h), store_.origin(h)});
}

void FarthestDelaunay2::note_outlook(HalfEdge h, Outlook outlook) {
  if (outlook == Outlook::kFailsNow) failing_.push_back(h);
}

void FarthestDelaunay2::set_certificate(HalfEdge any) {
  if (corrupt_ || !is_diagonal(any)) return;
  const HalfEdge h = named(any);
  CertificateId slot = store_.label(h);
  ties_.set(slots_, slot, query_of(h), h);
  store_.set_label(h, slot);
  note_outlook(h, kernel_->outlook(slot));
}

void FarthestDelaunay2::drop_certificate(HalfEdge h) {
  CertificateId slot = store_.label(h);
  if (!corrupt_) slots_.drop(slot);
  store_.set_label(h, kNoCertificate);
}

// ---- flips

FarthestDelaunay2::HalfEdge FarthestDelaunay2::flip(HalfEdge h) {
  untold_.gone({store_.origin(h), store_.target(h)});
  const HalfEdge d = store_.flip(h), e = store_.twin(d);
  untold_.came({store_.origin(d), store_.target(d)});
  set_certificate(d);  // first: the arithmetic reuses the polynomial of the failure
  for (const HalfEdge side : {d, e}) {
    set_certificate(Triangulation2::next(side));
    set_certificate(Triangulation2::previous(side));
  }
  return d;
}

// Its four points are identically cocircular and the smallest id is not on the diagonal.
bool FarthestDelaunay2::wants_other_diagonal(HalfEdge h) const {
  if (!is_tie(h)) return false;
  const HalfEdge g = store_.twin(h);
  return std::min(store_.apex(h), store_.apex(g)) < std::min(store_.origin(h), store_.origin(g));
}

// A flip raises the degree of the smallest of its four points and lowers those of larger ones, so
// this ends.
void FarthestDelaunay2::settle_ties() {
  ties_.settle([this](HalfEdge h) {
    if (corrupt_ || h >= store_.half_edge_capacity()) return;
    if (store_.live(Triangulation2::triangle(h)) && wants_other_diagonal(h)) flip(h);
  });
}

// Flips until every diagonal holds.
void FarthestDelaunay2::finish() {
  const std::uint64_t h = store_.vertices();
  std::uint64_t left = 64 + h * h;
  settle_ties();
  while (!failing_.empty() && !corrupt_) {
    const HalfEdge edge = failing_.back();
    failing_.pop_back();
    if (!store_.live(Triangulation2::triangle(edge))) continue;
    const CertificateId slot = store_.label(edge);
    if (slot == kNoCertificate || kernel_->outlook(slot) != Outlook::kFailsNow) continue;
    if (left-- == 0) return give_up("flips without end");
    flip(edge);
    settle_ties();
  }
}

// ---- events

bool FarthestDelaunay2::instant_may_go_on() const {
  return !kernel_->instant_is_over(id_) || hull_->shares_instant();
}

void FarthestDelaunay2::settle_below() const {
  if (hull_->shares_instant()) kernel_->settle_later(hull_->id());
  kernel_->settle_later(id_);
}

void FarthestDelaunay2::certificate_failed(CertificateId failed) {
  const HalfEdge h = slots_.failed(failed);
  const Query query = kernel_->query(failed);
  if (repeats(query)) return give_up("a certificate fails again and again");
  const ObjectId u = store_.origin(h), v = store_.target(h);
  const auto [p, q] = std::minmax({store_.apex(h), store_.apex(store_.twin(h))});
  const bool first = untold_.size() == 0;
  flip(h);
  settle_ties();
  failing_.clear();  // they fail next
  if (corrupt_) return;
  const bool says_all = first && untold_.size() == 2 && !instant_may_go_on();
  kernel_->report(id_, kFlip, {u, v, p, q}, says_all);
  if (says_all) return untold_.clear();
  settle_below();
}

// What changes with the hull is reported when the instant is over: certificates of this structure
// may fail at it, too.
void FarthestDelaunay2::watched_changed(const Event* event) {
  if (corrupt_) return;
  if (event == nullptr || !follow(*event)) synchronise();
  settle_ties();
  failing_.clear();  // they fail next
  if (untold_.size() != 0) kernel_->settle_later(id_);
}

void FarthestDelaunay2::motions_changed(std::span<const ObjectId> objects) {
  repeats_.clear();
  ties_.note_of(slots_, objects);
  settle_ties();
  failing_.clear();
}

// The hull may have changes that it has not reported yet.
void FarthestDelaunay2::instant_settled() {
  if (corrupt_) return;
  synchronise();
  settle_ties();
  failing_.clear();
}

void FarthestDelaunay2::instant_over() {
  if (untold_.size() == 0) return;
  const AttributeDifference change = untold_.take();
  kernel_->report_settled(id_, change.gone, change.came);
}

Attribute FarthestDelaunay2::attribute() const {
  Attribute result;
  result.shape = Attribute::Shape::kTuples;
  if (few_.size() == 2) result.ids = few_;
  std::vector<std::pair<ObjectId, ObjectId>> edges;
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || to_infinity(h) || named(h) != h) continue;
    edges.emplace_back(store_.origin(h), store_.target(h));
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [a, b] : edges) result.ids.insert(result.ids.end(), {a, b});
  return result;
}

void FarthestDelaunay2::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "diagonal";
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || !is_diagonal(h) || named(h) != h) continue;
    group.about = {store_.origin(h), store_.target(h)};
    visitor.group(group);
    if (store_.label(h) == kNoCertificate) continue;
    visitor.certificate(store_.label(h), "the circle of each side holds the vertex of the other");
  }
}

std::size_t FarthestDelaunay2::bytes() const {
  return sizeof *this + store_.bytes() + untold_.bytes() + ties_.bytes() +
         (failing_.capacity() + few_.capacity() + rim_.capacity() + stack_.capacity() +
          filled_.capacity()) *
             sizeof(std::uint32_t);
}

}  // namespace kinex
