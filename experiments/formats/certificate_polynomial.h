// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomial of a certificate under the motions in force, exactly, whatever the arithmetic.
#ifndef KINEX_EXPERIMENTS_FORMATS_CERTIFICATE_POLYNOMIAL_H
#define KINEX_EXPERIMENTS_FORMATS_CERTIFICATE_POLYNOMIAL_H

#include <span>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/engine/certificate.h"
#include "core/motion/derived_objects.h"
#include "core/motion/scene.h"
#include "core/numbers/polynomial.h"

namespace kinex::formats {

// The motion of each object that a run has in force.
class MotionsInForce {
 public:
  explicit MotionsInForce(const Scene& scene);
  // The object has a new motion from t on.
  void changed(ObjectId object, const Rational& t);
  // nullptr if the object has no motion now.
  const Trajectory* of(ObjectId object) const { return trajectories_[object]; }

 private:
  const Scene& scene_;
  std::vector<const Trajectory*> trajectories_;
};

// A positive multiple of the predicate's value with coprime integer coefficients; zero if it is
// identically zero, or if one of its objects has no motion. `motions`: one for each argument.
Polynomial certificate_polynomial(const Predicate& predicate,
                                  std::span<const Trajectory* const> motions);
// Under the motions that a kernel keeps, derived objects included.
Polynomial certificate_polynomial(const Predicate& predicate, const Query& query,
                                  const DerivedObjects& motions);

}  // namespace kinex::formats

#endif
