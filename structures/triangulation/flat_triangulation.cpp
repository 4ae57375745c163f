// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/flat_triangulation.h"

#include <algorithm>

#include "structures/parts/sort_unique.h"
#include "structures/triangulation/static_regular.h"

namespace kinex {

FlatTriangulation::FlatTriangulation(Kernel& kernel, StructureId id, std::size_t objects,
                                     const FlatKinds& kinds)
    : InPlane(kernel, id, objects, Extents::kNone,
              PlaneKinds{kinds.flip, kinds.enter, kinds.leave, kinds.retile}, "edges",
              Kinds{kinds.retile, kinds.blocked, kinds.touch}),
      kinds_(kinds),
      line_(kernel, id, "line", AlongLine{}) {}

// ---- certificates

// A triangle that is identically flat is mended when the instant is settled.
void FlatTriangulation::set_certificate(Facet f) {
  if (corrupt_) return;
  const Query query = claim_of(f);
  if (!kernel_->is_exact() && repeats_an_object(query)) {
    return give_up("two triangles on the same points");
  }
  CertificateId label = store_.label(f);
  Outlook outlook = facets_.set(label, query, f);
  if (outlook == Outlook::kIdenticallyZero) {
    ++ties_;
    outlook = facets_.set(label, tie_claim_of(f), f);
  }
  store_.set_label(f, label);
  if (outlook != Outlook::kIdenticallyZero) return;
  suspect_all(points_of(f));
  kernel_->settle_later(id_);
}

void FlatTriangulation::certificate_failed(CertificateId failed) {
  change_.reset();
  if (corrupt_) return;
  if (line_.slots().owns(failed)) return pass(failed);
  const Facet f = facets_.failed(failed);
  if (stands_upright())
    return rebuild_because("in projection all points of the plane are on one line");
  if (touched(f)) return;
  note_change(points_of(f));
  if (flippable(f)) {
    flip(f);
  } else {
    blocked(f);
  }
}

void FlatTriangulation::pass(CertificateId failed) {
  if (!stale_ && stands_upright()) {
    return rebuild_because("in projection all points of the line are at one place");
  }
  ++passes_;
  const auto [before, after] = line_.failed(failed);
  line_.settle(kNoReport);
  kernel_->report(id_, kinds_.pass, {before, after}, false);
  kernel_->report_changed_within(id_);
}

// Of a chain: no link has a length in projection at now itself. Two links fail or touch zero then.
bool FlatTriangulation::stands_upright() {
  bool all = InPlane::stands_upright();
  line_.each_link([&](ObjectId a, ObjectId b, CertificateId) {
    all = all && kernel_->sign(line_.claims().claim(a, b), When::kNow) == Sign::kZero;
  });
  return all;
}

// ---- construction

void FlatTriangulation::build(std::span<const ObjectId> vertices) {
  vertices_.assign(vertices.begin(), vertices.end());
  construct();
}

void FlatTriangulation::construct() {
  drop_all_certificates();
  line_.clear();
  forget_instant();
  change_.reset();
  stale_ = false;
  hint_ = kNone;
  StaticResult built = StaticResult::kFlat;
  for (std::size_t pair = 0; pair < kAxisPairs.size() && built == StaticResult::kFlat; ++pair) {
    if (pair != 0 && vertices_.size() < 3) break;
    take_axes(pair);
    built = build_static<PlaneComplex>(geometry_, vertices_, true, store_);
  }
  flat_ = built == StaticResult::kFlat;
  if (built == StaticResult::kFailed || (!flat_ && store_.vertices() != vertices_.size())) {
    return give_up("the static construction found no place for a point of a plane");
  }
  certify_everything();
  if (flat_) construct_line();
}

// The points are on one line.
void FlatTriangulation::construct_line() {
  if (vertices_.size() < 2) return;
  for (const PredicateId order : {on_axes(0).order(0), on_axes(0).order(1), on_axes(1).order(1)}) {
    line_.claims().order = order;
    if (kernel_->sign_after(order, {vertices_[0], vertices_[1]}) != Sign::kZero) break;
  }
  line_.build({vertices_.begin(), vertices_.end()}, kNoReport);
}

StaticResult FlatTriangulation::build_patch(std::span<const ObjectId> vertices) {
  return build_static<PlaneComplex>(geometry_, vertices, false, patch_);
}

void FlatTriangulation::let_go() {
  stale_ = true;
  change_.reset();
  drop_all_certificates();
}

void FlatTriangulation::insert(ObjectId object) {
  vertices_.insert(std::lower_bound(vertices_.begin(), vertices_.end(), object), object);
  construct();
}

void FlatTriangulation::erase(ObjectId object) {
  std::erase(vertices_, object);
  construct();
}

// ---- what there is

std::vector<std::array<ObjectId, 2>> FlatTriangulation::edges() const {
  std::vector<std::array<ObjectId, 2>> result;
  for (Facet h = 0; h < 3 * store_.triangle_capacity(); ++h) {
    if (!store_.live(PlaneComplex::cell(h))) continue;
    const ObjectId a = store_.origin(h), b = store_.target(h);
    if (a < b && b != store_.infinity()) result.push_back({a, b});
  }
  line_.each_link([&result](ObjectId a, ObjectId b, CertificateId) {
    result.push_back({std::min(a, b), std::max(a, b)});
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<ObjectId> FlatTriangulation::neighbours(ObjectId vertex) const {
  std::vector<ObjectId> result;
  if (line_.size() != 0 && std::binary_search(vertices_.begin(), vertices_.end(), vertex)) {
    for (const ObjectId beside : {line_.previous(vertex), line_.next(vertex)}) {
      if (beside != kNoItem) result.push_back(beside);
    }
    std::sort(result.begin(), result.end());
  }
  if (!store_.has(vertex)) return result;
  const HalfEdge first = store_.out(vertex);
  HalfEdge at = first;
  do {
    if (store_.target(at) != store_.infinity()) result.push_back(store_.target(at));
    at = store_.around(at);
  } while (at != first);
  std::sort(result.begin(), result.end());
  return result;
}

// ---- the proof as data

void FlatTriangulation::visit_proof(ProofVisitor& visitor) const {
  const ObjectId infinity = store_.infinity();
  ProofGroup group;
  for (Facet h = 0; h < 3 * store_.triangle_capacity(); ++h) {
    if (!store_.live(PlaneComplex::cell(h)) || store_.twin(h) < h) continue;
    const ObjectId a = std::min(store_.origin(h), store_.target(h));
    const ObjectId b = std::max(store_.origin(h), store_.target(h));
    const bool to_infinity = b == infinity;
    const bool on_hull = store_.apex(h) == infinity || store_.apex(store_.twin(h)) == infinity;
    group.kind = to_infinity ? "hull vertex" : on_hull ? "hull edge" : "edge";
    group.about = {a};
    if (!to_infinity) group.about.push_back(b);
    visitor.group(group);
    if (store_.label(h) == kNoCertificate) continue;
    visitor.certificate(store_.label(h), to_infinity ? "the hull turns left"
                                         : on_hull   ? "the third vertex is inside"
                                                     : "the circle is empty");
  }
  line_.each_link([&](ObjectId a, ObjectId b, CertificateId certificate) {
    group.kind = "neighbours on a line";
    group.about = {std::min(a, b), std::max(a, b)};
    visitor.group(group);
    visitor.certificate(certificate, "in order along the line");
  });
}

std::size_t FlatTriangulation::bytes() const {
  return sizeof(*this) + common_bytes() + line_.bytes() + vertices_.capacity() * sizeof(ObjectId);
}

}  // namespace kinex
