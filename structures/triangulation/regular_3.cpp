// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_3.h"

#include "structures/triangulation/edge_winding.h"

namespace kinex {

Regular3::Regular3(Kernel& kernel, StructureId id, const Scene& scene)
    : SpaceFlips(kernel, id, scene, "facets",
                 RegularTriangulation::Kinds{kShow, kHide, kWitness, kRetile, kBlocked, kTouch}) {}

std::vector<std::string_view> Regular3::event_kinds() const {
  return common_event_kinds({"flip_2_3", "flip_3_2", "enter", "leave", "hull_2_3", "hull_3_2",
                             "show", "hide", "witness", "retile", "blocked", "touch"});
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

}  // namespace kinex
