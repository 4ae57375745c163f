// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/direction_meanings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "experiments/formats/log_rules.h"
#include "predicates/points/box_order.h"
#include "predicates/points/shared_arguments.h"
#include "predicates/predicates.h"

namespace kinex::formats {
namespace {

// The object that is each of the four ends.
using Ends = std::array<int, 4>;

std::vector<Ends> ends_of(std::size_t arity) {
  if (arity == 4) return {{0, 1, 2, 3}};
  if (arity == 3) return {{0, 1, 0, 2}, {0, 1, 2, 0}, {0, 1, 1, 2}, {0, 1, 2, 1}};
  return {{0, 1, 0, 1}, {0, 1, 1, 0}};
}

constexpr std::string_view kBox = "order_box_";

std::vector<Rational> opposite(std::vector<Rational> vector) {
  for (Rational& entry : vector) entry = -entry;
  return vector;
}

}  // namespace

DirectionMeanings::DirectionMeanings(std::vector<std::vector<Rational>> vectors)
    : vectors_(std::move(vectors)) {}

std::optional<std::size_t> DirectionMeanings::arity_of(std::string_view predicate) {
  if (predicate == "order_direction" || predicate == "order_extent_2") return 2;
  if (predicate == "order_extent_3") return 3;
  if (predicate == "order_extent") return 4;
  return predicate.starts_with(kBox) ? formats::arity_of(predicate) : std::nullopt;
}

// A double and a product of doubles are off by 2^-53 of their size; a few dozen of them make up a place.
DirectionMeanings::Places DirectionMeanings::places(std::span<const Trajectory* const> motions,
                                                    const Instant& at) const {
  constexpr double kRounding = 1e-12;
  const double t = at.lower + (at.upper - at.lower) / 2;
  const double size = std::max(std::abs(at.lower), std::abs(at.upper)), width = at.upper - at.lower;
  Places result(vectors_.size(), std::vector<Place>(motions.size()));
  for (std::size_t object = 0; object < motions.size(); ++object) {
    for (std::size_t axis = 0; axis < motions[object]->coordinates.size(); ++axis) {
      Place along;  // the axis
      double power = 1, size_power = 1, size_before = 0;
      double degree = 0;
      for (const Rational& coefficient : motions[object]->coordinates[axis]) {
        const double c = coefficient.to_double();
        along.value += c * power;
        along.margin += std::abs(c) * (kRounding * size_power + degree * size_before * width);
        size_before = size_power;
        power *= t;
        size_power *= size;
        ++degree;
      }
      for (std::size_t i = 0; i < vectors_.size() && axis < vectors_[i].size(); ++i) {
        const double u = vectors_[i][axis].to_double();
        result[i][object].value += u * along.value;
        result[i][object].margin += std::abs(u) * along.margin;
      }
    }
  }
  return result;
}

// The order of two boxes, of which the objects that touch them are named.
bool DirectionMeanings::any_box(std::string_view predicate, const std::optional<Places>& at,
                                const std::function<bool(const Predicate&)>& fits) const {
  const std::size_t slash = predicate.find('/'), k = vectors_.size() / 2;
  const bool area = predicate.substr(0, slash) == "order_box_area";
  std::vector<std::uint8_t> named{0, 1, 2, 3, 4, 5, 6, 7};
  if (slash != std::string_view::npos) {
    for (std::size_t i = 0; i < named.size(); ++i) {
      named[i] = static_cast<std::uint8_t>(predicate[slash + 1 + i] - '0');
    }
  }
  const auto extent = [&](std::size_t vector, std::size_t first) {
    const Place &high = (*at)[vector][named[first]], &low = (*at)[vector][named[first + 1]];
    return Place{high.value - low.value, high.margin + low.margin};
  };
  const auto size = [&](std::size_t vector, std::size_t first) {
    const Place w = extent(vector, first), h = extent(vector + k, first + 2);
    if (!area) return Place{w.value + h.value, w.margin + h.margin};
    return Place{w.value * h.value, (std::abs(w.value) + w.margin) * h.margin +
                                        std::abs(h.value) * w.margin +
                                        1e-15 * std::abs(w.value * h.value)};
  };
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) {
      if (at) {
        const Place a = size(i, 0), b = size(j, 4);
        if (std::abs(b.value - a.value) > a.margin + b.margin && std::isfinite(b.value - a.value)) {
          continue;
        }
      }
      for (const SmallerBox smaller : {SmallerBox::kFirst, SmallerBox::kSecond}) {
        std::shared_ptr<const Predicate> order =
            make_box_order(area ? BoxMeasure::kArea : BoxMeasure::kPerimeter, vectors_[i],
                           vectors_[j], smaller);
        if (slash != std::string_view::npos) order = make_shared_arguments(std::move(order), named);
        if (fits(*order)) return true;
      }
    }
  }
  return false;
}

bool DirectionMeanings::any(std::string_view predicate, std::span<const Trajectory* const> motions,
                            const std::optional<Instant>& vanishing,
                            const std::function<bool(const Predicate&)>& fits) const {
  const Places at = vanishing ? places(motions, *vanishing) : Places{};
  if (predicate.starts_with(kBox)) {
    return any_box(predicate, vanishing ? std::optional(at) : std::nullopt, fits);
  }
  // Of the sum of places with signs; not finite: it may be zero.
  const auto is_zero = [](std::initializer_list<std::pair<int, const Place*>> sum) {
    Place all;
    for (const auto& [sign, place] : sum) {
      all.value += sign * place->value;
      all.margin += place->margin;
    }
    return !(std::abs(all.value) > all.margin) || !std::isfinite(all.value);
  };
  if (predicate == "order_direction") {
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      if (vanishing && !is_zero({{1, &at[i][1]}, {-1, &at[i][0]}})) continue;
      if (fits(*make_direction_order(vectors_[i]))) return true;
    }
    return false;
  }
  for (const Ends& ends : ends_of(motions.size())) {
    const auto place = [&](std::size_t vector, std::size_t end) {
      return &at[vector][static_cast<std::size_t>(ends[end])];
    };
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      for (std::size_t j = i + 1; j < vectors_.size(); ++j) {
        if (vanishing && !is_zero({{1, place(i, 0)}, {-1, place(i, 1)}, {-1, place(j, 2)}, {1, place(j, 3)}})) {
          continue;
        }
        if (fits(*make_extent_order(vectors_[i], vectors_[j], ends))) return true;
        if (fits(*make_extent_order(opposite(vectors_[i]), opposite(vectors_[j]), ends))) return true;
      }
    }
  }
  return false;
}

}  // namespace kinex::formats
