// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/delaunay_3.h"

#include <algorithm>

#include "structures/parts/sort_unique.h"

namespace kinex {

Delaunay3::Delaunay3(Kernel& kernel, StructureId id, const Scene& scene)
    : SpaceFlips(kernel, id, scene.objects.size(),
                 RegularGeometry<SpaceComplex>(kernel, static_cast<ObjectId>(scene.objects.size())),
                 "facets", Kinds{kRetile, kBlocked, kTouch}),
      points_(scene.objects.size()) {}

std::vector<std::string_view> Delaunay3::event_kinds() const {
  return common_event_kinds({"flip_2_3", "flip_3_2", "enter", "leave", "hull_2_3", "hull_3_2",
                             "retile", "blocked", "touch", "plane_flip", "plane_enter",
                             "plane_leave", "plane_retile", "plane_blocked", "plane_touch",
                             "line_pass"});
}

// ---- certificates

void Delaunay3::set_certificate(Facet f) {
  if (corrupt_) return;
  CertificateId slot = store_.label(f);
  const Outlook outlook = facets_.set(slot, claim_of(f), f);
  store_.set_label(f, slot);
  if (outlook == Outlook::kIdenticallyZero) set_tie(f);
}

// set_certificate for each of several facets, in this order.
void Delaunay3::set_certificates(std::span<const Facet> facets) {
  Kernel::Group group;
  while (!facets.empty() && !corrupt_) {
    group.size = 0;
    while (group.size < std::min(facets.size(), Kernel::Group::kMost)) {
      const Facet f = facets[group.size];
      if (store_.label(f) == kNoCertificate) break;
      group.ids[group.size] = store_.label(f);
      group.queries[group.size] = claim_of(f);
      group.tags[group.size++] = f;
    }
    if (group.size == 0) {
      set_certificate(facets.front());
      facets = facets.subspan(1);
      continue;
    }
    facets_.set(group);
    for (std::size_t i = 0; i < group.size; ++i) {
      if (group.outlooks[i] == Outlook::kIdenticallyZero) set_tie(facets[i]);
    }
    facets = facets.subspan(group.size);
  }
}

// The claim of the facet is identically zero: certifies what the ties say. If that is zero, too, a cell is
// identically flat, or the hull is folded: it is mended when the instant is settled.
void Delaunay3::set_tie(Facet f) {
  ++ties_;
  CertificateId slot = store_.label(f);
  const Outlook outlook = facets_.set(slot, tie_claim_of(f), f);
  if (outlook != Outlook::kIdenticallyZero) return;
  suspect_all(points_of(f));
  kernel_->settle_later(id_);
}

void Delaunay3::certificate_failed(CertificateId failed) {
  if (corrupt_) return;
  if (plane_ != nullptr && plane_->owns(failed)) return plane_->certificate_failed(failed);
  const Facet f = facets_.failed(failed);
  if (touched(f)) return;
  note_change(points_of(f));
  if (!flip(f)) blocked(f);
}

// ---- what there is

std::vector<std::array<ObjectId, 2>> Delaunay3::edges() const {
  if (planar()) return plane_->edges();
  std::vector<std::array<ObjectId, 2>> result;
  if (flat_) {
    for (ObjectId a = 0; a < objects(); ++a) {
      if (!points_.is_vertex(a)) continue;
      for (ObjectId b = a + 1; b < objects(); ++b) {
        if (points_.is_vertex(b)) result.push_back({a, b});
      }
    }
    return result;
  }
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    Quad q = store_.quad(c);
    std::sort(q.begin(), q.end());
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (q[j] != store_.infinity()) result.push_back({q[i], q[j]});
      }
    }
  }
  sort_unique(result);
  return result;
}

std::vector<ObjectId> Delaunay3::neighbours(ObjectId vertex) const {
  if (planar()) return plane_->neighbours(vertex);
  std::vector<ObjectId> result;
  if (flat_) {
    for (ObjectId other = 0; other < objects(); ++other) {
      if (other != vertex && points_.is_vertex(other)) result.push_back(other);
    }
    return result;
  }
  std::vector<Cell> cells;
  store_.star(vertex, cells);
  for (const Cell c : cells) {
    for (const ObjectId other : store_.quad(c)) {
      if (other != vertex && other != store_.infinity()) result.push_back(other);
    }
  }
  sort_unique(result);
  return result;
}

std::size_t Delaunay3::bytes() const {
  return sizeof(*this) + common_bytes() + points_.bytes() +
         (plane_ == nullptr ? 0 : plane_->bytes()) +
         hidden_in_patch_.capacity() * sizeof(hidden_in_patch_[0]);
}

}  // namespace kinex
