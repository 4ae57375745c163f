// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/lifted_geometry.h"

#include <utility>

#include "predicates/points/space_predicates.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

template <class Complex>
std::array<PredicateId, static_cast<std::size_t>(Complex::kAxes)> bound_orders(Kernel& kernel) {
  std::array<PredicateId, static_cast<std::size_t>(Complex::kAxes)> orders{};
  for (int axis = 0; axis < Complex::kAxes; ++axis) {
    orders[static_cast<std::size_t>(axis)] = kernel.bind(make_coordinate_order(axis));
  }
  return orders;
}

template <class Complex>
std::array<PredicateId, Complex::kAxes == 2 ? 1 : 3> bound_projections(Kernel& kernel) {
  if constexpr (Complex::kAxes == 2) {
    return {kernel.bind(make_orientation_2())};
  } else {
    return {kernel.bind(make_projected_orientation(0, 1)),
            kernel.bind(make_projected_orientation(0, 2)),
            kernel.bind(make_projected_orientation(1, 2))};
  }
}

}  // namespace

template <class Complex>
LiftedGeometry<Complex>::LiftedGeometry(Kernel& kernel, ObjectId infinity,
                                        std::shared_ptr<const Predicate> power)
    : kernel_(&kernel),
      infinity_(infinity),
      order_(bound_orders<Complex>(kernel)),
      projected_(bound_projections<Complex>(kernel)),
      orientation_(kernel.bind(Complex::kAxes == 2 ? make_orientation_2() : make_orientation_3())),
      power_(kernel.bind(std::move(power))) {}

template <class Complex>
LiftedGeometry<Complex>::LiftedGeometry(Kernel& kernel, ObjectId infinity, AxisPair axes,
                                        std::shared_ptr<const Predicate> power)
    : kernel_(&kernel),
      infinity_(infinity),
      order_{kernel.bind(make_coordinate_order(axes.first)),
             kernel.bind(make_coordinate_order(axes.second))},
      projected_{kernel.bind(make_projected_orientation(axes.first, axes.second))},
      orientation_(projected_[0]),
      power_(kernel.bind(std::move(power))) {}

template <class Complex>
bool LiftedGeometry<Complex>::equal(ObjectId a, ObjectId b, When when) const {
  return std::all_of(order_.begin(), order_.end(), [&](PredicateId order) {
    return kernel_->sign(Query(order, {a, b}), when) == Sign::kZero;
  });
}

template <class Complex>
bool LiftedGeometry<Complex>::on_line(ObjectId a, ObjectId b, ObjectId c, When when) const {
  return std::all_of(projected_.begin(), projected_.end(), [&](PredicateId turn) {
    return kernel_->sign(Query(turn, {a, b, c}), when) == Sign::kZero;
  });
}

template <class Complex>
Query LiftedGeometry<Complex>::tie_claim(const Simplex& s, ObjectId v) const {
  std::array<ObjectId, Complex::kCorners + 1> ids{};
  std::copy(s.begin(), s.end(), ids.begin());
  ids.back() = v;
  std::sort(ids.begin(), ids.end());
  for (const ObjectId u : ids) {
    if (u == v) break;
    const Simplex with = replaced(s, u, v);
    if (orientation(with) != Sign::kZero) return orientation_claim(with);
  }
  return orientation_claim(turned(s));  // v is below
}

template <class Complex>
bool LiftedGeometry<Complex>::below(const Simplex& s, ObjectId v) const {
  const Sign sign = kernel_->sign_after(query(power_, s, v));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return kernel_->sign_after(tie_claim(s, v)) != Sign::kPositive;
}

template <class Complex>
bool LiftedGeometry<Complex>::conflict(const Store& store, Cell c, ObjectId v) const {
  const Simplex s = Complex::simplex(store, c);
  for (unsigned i = 0; i < Complex::kCorners; ++i) {
    if (s[i] != infinity_) continue;
    const Sign sign = orientation(replaced(s, infinity_, v));
    if (sign != Sign::kZero) return sign == Sign::kPositive;
    const auto within = Complex::mate(store, Complex::facet(c, i));
    return store.apex(within) != v && below(Complex::simplex(store, Complex::cell(within)), v);
  }
  return below(s, v);
}

template class LiftedGeometry<PlaneComplex>;
template class LiftedGeometry<SpaceComplex>;

}  // namespace kinex
