// SPDX-License-Identifier: GPL-3.0-or-later
// Fixes of an object as a motion: what all imports of traces have in common.
#ifndef KINEX_EXPERIMENTS_FORMATS_TRACE_H
#define KINEX_EXPERIMENTS_FORMATS_TRACE_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/heading.h"

namespace kinex::formats {

struct Fix {
  Rational t;
  std::vector<Rational> position;
  Rational heading;  // of a body, in [0, 360)
};

// Appends the rotor of a body to a trajectory.
void add_rotor(Trajectory& trajectory, RotorMotion rotor);

// Appends the motion through the fixes, linear between two of them; fixes on one straight flight at one
// speed are one piece. The headings of bodies turn the short way round. Requires two fixes or more, in
// ascending order of time, none before the end of `motion`.
void append_linear(Motion& motion, const std::vector<Fix>& fixes, bool body);
// The same, at rest at a fix until the next one: the object jumps.
void append_steps(Motion& motion, const std::vector<Fix>& fixes, bool body);

// Adds an object at rest, at all times, from "ID,X[,Y[,Z]]" of --fixed, with the radius, the weight or the half extents
// behind it if the scene's objects have them. Throws InputError that names it.
void add_fixed(Scene& scene, const std::string& text, bool body);

// Throws InputError unless the scene ends after its start and, if it has traces, one of them is there in that time.
// Appends a note that names those that are not.
void check_time(const Scene& scene, const std::string& file, std::vector<std::string>& notes);

}  // namespace kinex::formats

#endif
