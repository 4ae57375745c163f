// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_3.h"

#include "structures/triangulation/edge_winding.h"

namespace kinex {

Regular3::Regular3(Kernel& kernel, StructureId id, const Scene& scene)
    : SpaceFlips(kernel, id, scene, "facets",
                 RegularTriangulation::Kinds{kShow, kHide, kWitness, kRetile, kBlocked, kTouch}),
      extents_(scene.extents) {}

std::vector<std::string_view> Regular3::event_kinds() const {
  return common_event_kinds(
      {"flip_2_3",     "flip_3_2",      "enter",       "leave",      "hull_2_3",   "hull_3_2",
       "show",         "hide",          "witness",     "retile",     "blocked",    "touch",
       "plane_flip",   "plane_enter",   "plane_leave", "plane_show", "plane_hide", "plane_witness",
       "plane_retile", "plane_blocked", "plane_touch"});
}

// ---- events

void Regular3::certificate_failed(CertificateId failed) {
  if (corrupt_) return;
  if (plane_ != nullptr && plane_->owns(failed)) return plane_->certificate_failed(failed);
  RegularTriangulation::certificate_failed(failed);
}

// Where four cells have only vertices of the facet and its two apices, the one vertex that is in all of
// them, of degree 4, is a vertex of the facet.
bool Regular3::repair(Facet f) {
  if (store_.around(f).cells <= 3) return flip(f);
  const ObjectId q = store_.apex(store_.mate(f));
  for (Facet g = 4 * Triangulation3::cell(f); g < 4 * Triangulation3::cell(f) + 4; ++g) {
    if (g != f && store_.apex(store_.mate(g)) != q) return hide(store_.apex(g));
  }
  return false;
}

void Regular3::add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) {
  kinex::add_windings(geometry_, store_, near, wrong);
}

void Regular3::instant_settled() {
  if (corrupt_) return;
  if (plane_ != nullptr) plane_->forget_change();
  if (!flat_ || !moved_.empty()) return RegularTriangulation::instant_settled();
  if (plane_ != nullptr) plane_->instant_settled();
}

// ---- construction

void Regular3::construct() {
  RegularTriangulation::construct();
  if (!corrupt_) construct_plane();
}

// The triangulation of all objects in one plane, if they are. Three objects need none: they have all pairs for edges,
// and hide none of them unless they are on one line.
void Regular3::construct_plane() {
  std::vector<ObjectId> present;
  if (flat_) present = RegularTriangulation::hidden();
  if (present.size() < 4) present.clear();
  if (plane_ == nullptr) {
    if (present.empty()) return;
    plane_ = std::make_unique<FlatRegular>(
        *kernel_, id_, objects(), extents_,
        FlatRegular::FlatKinds{kPlaneFlip, kPlaneEnter, kPlaneLeave, kPlaneShow, kPlaneHide,
                               kPlaneWitness, kPlaneRetile, kPlaneBlocked, kPlaneTouch});
  }
  plane_->build(present);
  corrupt_ = plane_->corrupt();
}

void Regular3::motions_changed(std::span<const ObjectId> objects) {
  RegularTriangulation::motions_changed(objects);
  if (!corrupt_ && flat_ && plane_ != nullptr) plane_->let_go();
}

// New motions while all objects are in one plane.
void Regular3::sort_out_flat() {
  RegularTriangulation::sort_out_flat();
  if (corrupt_ || !flat_) return;
  if (has_all_pairs()) {
    kernel_->report_changed_within(id_);
  } else {
    kernel_->count_rebuild(id_, "new motions in a common plane");
  }
}

// ---- what there is

bool Regular3::is_vertex(ObjectId object) const {
  return planar() ? plane_->is_vertex(object) : RegularTriangulation::is_vertex(object);
}

std::vector<ObjectId> Regular3::hidden() const {
  return planar() ? plane_->hidden() : RegularTriangulation::hidden();
}

std::vector<std::array<ObjectId, 2>> Regular3::edges() const {
  return planar() ? plane_->edges() : RegularTriangulation::edges();
}

void Regular3::visit_proof(ProofVisitor& visitor) const {
  RegularTriangulation::visit_proof(visitor);
  if (planar()) plane_->visit_proof(visitor);
}

std::size_t Regular3::bytes() const {
  return RegularTriangulation::bytes() + sizeof(*this) - sizeof(RegularTriangulation) +
         (plane_ == nullptr ? 0 : plane_->bytes());
}

}  // namespace kinex
