// SPDX-License-Identifier: GPL-3.0-or-later
// RegularTriangulation: certificates, construction, and changes from outside.
#include "structures/triangulation/regular_triangulation.h"

#include <utility>

#include "structures/parts/sort_unique.h"

namespace kinex {

template <class Complex>
RegularTriangulation<Complex>::RegularTriangulation(Kernel& kernel, StructureId id,
                                                    const Scene& scene, const std::string& facets,
                                                    Kinds kinds)
    : RegularTriangulation(kernel, id, scene.objects.size(),
                           RegularGeometry<Complex>(kernel, scene.extents,
                                                    static_cast<ObjectId>(scene.objects.size())),
                           {facets, "witnesses"}, kinds) {}

template <class Complex>
RegularTriangulation<Complex>::RegularTriangulation(Kernel& kernel, StructureId id,
                                                    std::size_t objects,
                                                    RegularGeometry<Complex> geometry,
                                                    const PartNames& parts, Kinds kinds)
    : Base(kernel, id, objects, std::move(geometry), parts.facets,
           {kinds.retile, kinds.blocked, kinds.touch}),
      present_(objects, false),
      kinds_(kinds),
      witnesses_(kernel, id, parts.witnesses),
      witness_(objects) {}

// ---- certificates

// A cell that is identically flat is mended when the instant is settled.
template <class Complex>
void RegularTriangulation<Complex>::set_certificate(Facet f) {
  if (this->corrupt_) return;
  const Query query = this->claim_of(f);
  if (!this->kernel_->is_exact() && repeats_an_object(query)) {
    return this->give_up("two cells on the same points");
  }
  CertificateId label = this->store_.label(f);
  Outlook outlook = this->facets_.set(label, query, f);
  if (outlook == Outlook::kIdenticallyZero) {
    ++ties_;
    outlook = this->facets_.set(label, this->tie_claim_of(f), f);
  }
  this->store_.set_label(f, label);
  if (outlook != Outlook::kIdenticallyZero) return;
  this->suspect_all(this->points_of(f));
  this->kernel_->settle_later(this->id_);
}

template <class Complex>
void RegularTriangulation<Complex>::certificate_failed(CertificateId failed) {
  if (this->corrupt_) return;
  if (witnesses_.owns(failed)) return witness_failed(witnesses_.failed(failed));
  const Facet f = this->facets_.failed(failed);
  if (this->touched(f)) return;
  this->note_change(this->points_of(f));
  if (repair(f)) {
    ++changes_;
  } else {
    this->blocked(f);
  }
}

template <class Complex>
void RegularTriangulation<Complex>::count_failure(CertificateId failed) {
  (witnesses_.owns(failed) ? witnesses_ : this->facets_).failed(failed);
}

template <class Complex>
void RegularTriangulation<Complex>::drop_all_witnesses() {
  for (ObjectId h = 0; h < witness_.size(); ++h) drop_witness(h);
  waiting_.clear();
  witness_ties_.clear();
}

// ---- construction

template <class Complex>
void RegularTriangulation<Complex>::build(std::span<const ObjectId> objects) {
  std::fill(present_.begin(), present_.end(), false);
  for (const ObjectId id : objects) present_[id] = true;
  construct();
}

template <class Complex>
StaticResult RegularTriangulation<Complex>::build_patch(std::span<const ObjectId> vertices) {
  return build_static<Complex>(this->geometry_, vertices, false, this->patch_);
}

template <class Complex>
void RegularTriangulation<Complex>::construct() {
  this->drop_all_certificates();
  drop_all_witnesses();
  this->forget_instant();
  this->hint_ = this->kNone;
  std::vector<ObjectId> objects;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    if (present_[id]) objects.push_back(id);
  }
  const StaticResult built = build_static<Complex>(this->geometry_, objects, true, this->store_);
  if (built == StaticResult::kFailed) {
    return this->give_up("the static construction found no place for a point");
  }
  this->flat_ = built == StaticResult::kFlat;
  this->certify_everything();
  if (this->flat_) return;
  for (const ObjectId id : objects) {
    if (this->corrupt_ || this->store_.has(id)) continue;
    const Cell c = locate<Complex>(this->geometry_, this->store_, id, this->hint()).cell;
    if (c == this->kNone || shows_in(c, id)) {
      return this->give_up("the static construction hides a point that shows");
    }
    this->hint_ = c;
    set_witness(id, c);
  }
}

// ---- changes from outside

template <class Complex>
void RegularTriangulation<Complex>::insert(ObjectId object) {
  if (this->corrupt_) return;
  this->comes_or_goes_ = true;
  present_[object] = true;
  if (this->flat_) {
    construct();
  } else {
    put_in(object);
    settle_hidden();
  }
  this->comes_or_goes_ = false;
  this->untold_.clear();
}

template <class Complex>
void RegularTriangulation<Complex>::erase(ObjectId object) {
  if (this->corrupt_) return;
  this->comes_or_goes_ = true;
  present_[object] = false;
  for (ObjectId h = 0; h < witness_.size(); ++h) {
    if (witness_[h].names(object)) wait(h);
  }
  drop_witness(object);
  if (this->flat_) {
    construct();
  } else if (this->store_.has(object)) {
    std::vector<Cell> cells;
    Complex::star(this->store_, object, cells);
    if (!this->sew(cells, {{object}, {}})) {
      this->rebuild_because(Complex::kAxes == 2
                                ? "erasure of a point whose triangles are everywhere"
                                : "erasure of a point whose cells are everywhere");
    }
  }
  if (!this->flat_) settle_hidden();
  this->comes_or_goes_ = false;
  this->untold_.clear();
}

template <class Complex>
void RegularTriangulation<Complex>::motions_changed(std::span<const ObjectId> objects) {
  this->moved_.insert(this->moved_.end(), objects.begin(), objects.end());
  if (this->corrupt_) return;
  witness_ties_.note_of(witnesses_, objects);
  for (const ObjectId v : objects) this->renew_about(v);
}

// ---- what there is

template <class Complex>
std::vector<ObjectId> RegularTriangulation<Complex>::hidden() const {
  std::vector<ObjectId> result;
  for (ObjectId v = 0; v < present_.size(); ++v) {
    if (present_[v] && !this->store_.has(v)) result.push_back(v);
  }
  return result;
}

template <class Complex>
std::vector<std::array<ObjectId, 2>> RegularTriangulation<Complex>::edges() const {
  std::vector<std::array<ObjectId, 2>> result;
  const auto add_pairs = [&result](const auto& ids, ObjectId infinity) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        if (ids[j] != infinity) result.push_back({ids[i], ids[j]});
      }
    }
  };
  if (this->flat_) {
    add_pairs(hidden(), this->store_.infinity());
    return result;
  }
  for (Cell c = 0; c < Complex::capacity(this->store_); ++c) {
    if (!this->store_.live(c)) continue;
    Simplex s = Complex::simplex(this->store_, c);
    std::sort(s.begin(), s.end());
    add_pairs(s, this->store_.infinity());
  }
  sort_unique(result);
  return result;
}

template <class Complex>
std::size_t RegularTriangulation<Complex>::bytes() const {
  return sizeof(*this) + this->common_bytes() + witness_ties_.bytes() + present_.capacity() / 8 +
         witness_.capacity() * sizeof(Witness) +
         (waiting_.capacity() + rim_.capacity()) * sizeof(std::uint32_t);
}

// ---- the proof as data

template <class Complex>
void RegularTriangulation<Complex>::visit_proof(ProofVisitor& visitor) const {
  // Inner facets, those of the hull, those with the vertex at infinity.
  static constexpr std::array<const char*, 3> kKinds =
      Complex::kAxes == 2 ? std::array{"edge", "hull edge", "hull vertex"}
                          : std::array{"facet", "hull facet", "hull edge"};
  static constexpr std::array<const char*, 3> kMeanings =
      Complex::kAxes == 2 ? std::array{"the lifted edge is convex", "the third vertex is inside",
                                       "the hull turns left"}
                          : std::array{"the lifted facet is convex", "the fourth vertex is inside",
                                       "the hull is convex"};
  const ObjectId infinity = this->store_.infinity();
  ProofGroup group;
  for (Cell c = 0; c < Complex::capacity(this->store_); ++c) {
    if (!this->store_.live(c)) continue;
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet g = Complex::mate(this->store_, f);
      if (g < f) continue;
      const ObjectId apex = this->store_.apex(f);
      group.about.clear();
      for (const ObjectId v : Complex::simplex(this->store_, c)) {
        if (v != apex && v != infinity) group.about.push_back(v);
      }
      std::sort(group.about.begin(), group.about.end());
      const bool to_infinity = group.about.size() + 1 < Complex::kCorners;
      const bool on_hull = apex == infinity || this->store_.apex(g) == infinity;
      const std::size_t kind = to_infinity ? 2 : on_hull ? 1 : 0;
      group.kind = kKinds[kind];
      visitor.group(group);
      const CertificateId label = this->store_.label(f);
      if (label != kNoCertificate) visitor.certificate(label, kMeanings[kind]);
    }
  }
  group.kind = "hidden point";
  for (ObjectId h = 0; h < witness_.size(); ++h) {
    if (!witness_[h].there()) continue;
    group.about = {h};
    visitor.group(group);
    for (std::size_t i = 0; i < kClaims; ++i) {
      if (witness_[h].certificates[i] == kNoCertificate) continue;
      visitor.certificate(witness_[h].certificates[i], i + 1 == kClaims
                                                           ? "above the plane of its witness"
                                                           : "inside its witness");
    }
  }
}

template class RegularTriangulation<PlaneComplex>;
template class RegularTriangulation<SpaceComplex>;

}  // namespace kinex
