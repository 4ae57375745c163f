// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/direction_maxima.h"

#include "structures/extent/line_maxima.h"
#include "structures/extent/tournament_maxima.h"

namespace kinex {

std::unique_ptr<DirectionMaxima> make_direction_maxima(Kernel& kernel, StructureId structure,
                                                       const Scene& scene,
                                                       const std::vector<DirectionVector>& half,
                                                       MaximaChoice choice) {
  if (choice == MaximaChoice::kByDegree && scene.degree_without_weights() <= 1) {
    return std::make_unique<LineMaxima>(kernel, structure, scene, half);
  }
  return std::make_unique<TournamentMaxima>(kernel, structure, scene, half);
}

}  // namespace kinex
