// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_geometry.h"

#include <memory>
#include <utility>

#include "predicates/points/power_predicates.h"
#include "predicates/points/space_predicates.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

template <class Complex>
PowerPair powers_of(Extents extents) {
  if constexpr (Complex::kAxes == 2) {
    if (extents == Extents::kRadius) return {make_disc_power_2(), make_disc_power_2_touch()};
    return {make_power_2(), make_power_2_touch()};
  } else {
    if (extents == Extents::kRadius) return {make_disc_power_3(), make_disc_power_3_touch()};
    return {make_power_3(), make_power_3_touch()};
  }
}

PowerPair powers_of(Extents extents, AxisPair axes) {
  const auto [u, v] = axes;
  switch (extents) {
    case Extents::kRadius:
      return {make_disc_power_lifted(u, v), make_disc_power_lifted_touch(u, v)};
    case Extents::kNone:
      return {make_in_circle_lifted(u, v), make_in_circle_lifted_touch(u, v)};
    default:
      return {make_power_lifted(u, v), make_power_lifted_touch(u, v)};
  }
}

}  // namespace

template <class Complex>
RegularGeometry<Complex>::RegularGeometry(Kernel& kernel, Extents extents, ObjectId infinity)
    : RegularGeometry(kernel, powers_of<Complex>(extents), extents == Extents::kRadius, infinity) {}

template <class Complex>
RegularGeometry<Complex>::RegularGeometry(Kernel& kernel,
                                          ObjectId infinity) requires(Complex::kAxes == 3)
    : RegularGeometry(kernel, PowerPair{make_in_sphere_3(), make_in_sphere_3_touch()}, false,
                      infinity) {}

template <class Complex>
RegularGeometry<Complex>::RegularGeometry(Kernel& kernel, AxisPair axes, Extents extents,
                                          ObjectId infinity)
    : RegularGeometry(kernel, axes, powers_of(extents, axes), extents == Extents::kRadius,
                      infinity) {}

template <class Complex>
RegularGeometry<Complex>::RegularGeometry(Kernel& kernel, AxisPair axes, PowerPair powers,
                                          bool radii, ObjectId infinity)
    : Base(kernel, infinity, axes, std::move(powers.plain)),
      radii_(radii),
      power_touch_(kernel.bind(std::move(powers.touch))),
      touch_(kernel.bind(make_projected_orientation_touch(axes.first, axes.second))),
      unfolded_(kernel.bind(make_obtuse_angle_3())) {}

template <class Complex>
RegularGeometry<Complex>::RegularGeometry(Kernel& kernel, PowerPair powers, bool radii,
                                          ObjectId infinity)
    : Base(kernel, infinity, std::move(powers.plain)),
      radii_(radii),
      power_touch_(kernel.bind(std::move(powers.touch))),
      touch_(kernel.bind(Complex::kAxes == 2 ? make_orientation_2_touch()
                                             : make_orientation_3_touch())),
      unfolded_(kernel.bind(Complex::kAxes == 2 ? make_obtuse_angle_2() : make_unfolded_3())) {}

template <class Complex>
Query RegularGeometry<Complex>::claim(const Simplex& s, unsigned i, ObjectId apex) const {
  if (!this->is_ghost(s)) {
    return apex == this->infinity() ? this->query(touch_, s)
                                    : this->query(power_touch_, this->turned(s), apex);
  }
  const Simplex filled = this->turned(this->replaced(s, this->infinity(), apex));
  return s[i] == this->infinity() ? this->query(touch_, filled) : this->orientation_claim(filled);
}

template <class Complex>
Query RegularGeometry<Complex>::claim_of_tie(const Simplex& s, unsigned i, ObjectId apex) const {
  if (this->is_ghost(s)) {
    return s[i] == this->infinity() ? claim(s, i, apex) : unfolded_claim(s, i, apex);
  }
  return apex == this->infinity() ? claim(s, i, apex) : this->tie_claim(s, apex);
}

template <class Complex>
Query RegularGeometry<Complex>::unfolded_claim(const Simplex& s, unsigned i, ObjectId apex) const {
  Query result;
  result.predicate = unfolded_;
  result.ids[result.arity++] = s[i];
  for (unsigned k = 0; k < Complex::kCorners; ++k) {
    if (k != i && s[k] != this->infinity()) result.ids[result.arity++] = s[k];
  }
  result.ids[result.arity++] = apex;
  return result;
}

template <class Complex>
bool RegularGeometry<Complex>::is_bad(const Simplex& s, unsigned i, ObjectId apex) const {
  if (!this->is_ghost(s)) {
    return apex == this->infinity() ? this->orientation(s) != Sign::kPositive
                                    : this->below(s, apex);
  }
  const Sign sign = this->orientation(this->replaced(s, this->infinity(), apex));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return s[i] == this->infinity() ||
         this->kernel().sign_after(unfolded_claim(s, i, apex)) != Sign::kPositive;
}

template class RegularGeometry<PlaneComplex>;
template class RegularGeometry<SpaceComplex>;

}  // namespace kinex
