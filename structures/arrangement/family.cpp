// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/family.h"

#include <utility>
#include <vector>

#include "structures/arrangement/incidences_all.h"

namespace kinex {
namespace {

StructureInfo incidences() {
  StructureInfo all;
  all.name = "incidences_all";
  all.group = "incidences";
  all.summary = "which points are above which lines, all pairs watched: the baseline";
  all.min_dimension = 2;
  all.shape = Attribute::Shape::kTuples;
  all.lines = LineUse::kWithPoints;
  all.kinds = {{"above", Effect::kAlways},
               {"below", Effect::kAlways},
               {"change", Effect::kNever},
               {"tie", Effect::kNever}};
  all.certificates = "nm for n lines and m points, one for each of both";
  all.ties = "a point that is identically on a line is below it";
  all.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  all.make = make_plain<IncidencesAll>;
  return all;
}

}  // namespace

StructureFamily arrangement_family() { return {"arrangement", {incidences()}}; }

}  // namespace kinex
