// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/points/point_grid_lines.h"

#include <algorithm>
#include <string>
#include <utility>

namespace kinex {
namespace {

Rational rational(std::size_t whole) { return Rational(Integer(static_cast<std::int64_t>(whole))); }

// The coefficients of c in powers of u, t = a + (b - a) u.
std::vector<Rational> over_unit(const std::vector<Rational>& c, const Rational& a,
                                const Rational& b) {
  std::vector<Rational> result;
  for (std::size_t k = c.size(); k-- > 0;) {  // Horner
    std::vector<Rational> next(result.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i] += result[i] * a;
      next[i + 1] += result[i] * (b - a);
    }
    next[0] += c[k];
    result = std::move(next);
  }
  return result;
}

// On [a, b] a polynomial is between its smallest and its largest Bernstein coefficient.
void widen(const std::vector<Rational>& coordinate, const Rational& a, const Rational& b,
           std::vector<Rational>& values) {
  const std::vector<Rational> c = over_unit(coordinate, a, b);
  const std::size_t degree = c.empty() ? 0 : c.size() - 1;
  for (std::size_t i = 0; i <= degree && !c.empty(); ++i) {
    Rational value, ratio(1);  // C(i, k) / C(degree, k)
    for (std::size_t k = 0; k <= i; ++k) {
      value += ratio * c[k];
      if (k < i) ratio = ratio * rational(i - k) / rational(degree - k);
    }
    values.push_back(value);
  }
}

// The smallest m 2^e that is not less, with m = 16 .. 31; requires length > 0. `unit`: 2^e.
Rational rounded_up(const Rational& length, Rational& unit) {
  unit = Rational(1);
  while (Rational(16) * unit < length) unit *= Rational(2);
  while (length < Rational(16) * unit) unit /= Rational(2);
  Rational result = Rational(16) * unit;
  while (result < length) result += unit;
  return result;
}

// The multiple of unit at or below a number.
Rational rounded_down(const Rational& x, const Rational& unit) {
  const Rational quotient = x / unit;
  const Integer below = floor_divide(quotient.numerator(), quotient.denominator());
  return Rational(below) * unit;
}

// Bounds of the coordinates of all objects along one axis; none without objects.
std::vector<Rational> values_along(const Scene& scene, std::size_t axis) {
  std::vector<Rational> values;
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) {
      const Rational from = piece.from ? std::max(*piece.from, scene.start) : scene.start;
      const Rational to = piece.to ? std::min(*piece.to, *scene.end) : *scene.end;
      if (to < from) continue;
      widen(piece.trajectory.coordinates[axis], from, to, values);
    }
  }
  return values;
}

// How many cells a grid has along each axis, and the smallest side that they need.
struct Layout {
  std::vector<std::size_t> count;
  Rational side;
};

// Of c1, .. cells with c1 c2 .. <= cells those of the smallest side. The first line is a short
// number, up to 1/16 of a side before it has to be: that much less fits into c columns.
class LayoutSearch {
 public:
  explicit LayoutSearch(const FlightBox& box) : box_(box), count_(box.low.size()) {}
  Layout best(std::size_t cells) {
    search(0, cells, Rational());
    return best_;
  }

 private:
  void search(std::size_t axis, std::size_t cells, const Rational& so_far) {
    const bool last = axis + 1 == count_.size();
    for (std::size_t c = last ? cells : 1; c <= cells; ++c) {
      const Rational slack(Integer(1), Integer(16));
      count_[axis] = c;
      const Rational needed =
          std::max(so_far, (box_.high[axis] - box_.low[axis]) / (rational(c) - slack));
      if (!last) {
        search(axis + 1, cells / c, needed);
      } else if (best_.count.empty() || needed < best_.side) {
        best_ = {count_, needed};
      }
    }
  }

  const FlightBox& box_;
  std::vector<std::size_t> count_;
  Layout best_;
};

}  // namespace

FlightBox FlightBox::of(const Scene& scene) {
  const auto axes = static_cast<std::size_t>(scene.dimension);
  FlightBox box{std::vector<Rational>(axes), std::vector<Rational>(axes), {}};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::vector<Rational> values = values_along(scene, axis);
    if (values.empty()) continue;
    box.low[axis] = *std::min_element(values.begin(), values.end());
    box.high[axis] = *std::max_element(values.begin(), values.end());
  }
  return box;
}

FlightBox FlightBox::of_discs(const Scene& scene) {
  FlightBox box = of(scene);
  const std::vector<Rational> radii =
      values_along(scene, static_cast<std::size_t>(scene.dimension));
  if (!radii.empty()) box.diameter = Rational(2) * *std::max_element(radii.begin(), radii.end());
  return box;
}

PointGridLines::PointGridLines(Kernel& kernel, FlightBox box)
    : kernel_(kernel), box_(std::move(box)), axes_(box_.low.size()) {}

ObjectId PointGridLines::line(std::size_t axis, const Rational& at) {
  const auto [place, is_new] = axes_[axis].known.try_emplace(at, kNoObject);
  if (is_new) {
    place->second = kernel_.constant(std::string{"xyz"[axis]} + "=" + at.to_string(),
                                     std::vector<Rational>(axes_.size(), at));
  }
  return place->second;
}

void PointGridLines::lay(std::size_t cells) {
  const Layout layout = LayoutSearch(box_).best(cells);
  for (Axis& axis : axes_) {
    axis.lines.clear();
    axis.at.clear();
  }
  width_ = Rational();
  if (layout.side.sign() == 0) return;  // all points are at one place
  Rational unit;
  width_ = rounded_up(std::max(layout.side, box_.diameter), unit);
  if (!(box_.diameter < width_)) width_ += unit;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    Rational at = rounded_down(box_.low[i] + width_, unit);
    for (std::size_t k = 1; k < layout.count[i] && at < box_.high[i]; ++k, at += width_) {
      axis.lines.push_back(line(i, at));
      axis.at.push_back(at);
    }
  }
}

bool PointGridLines::is_in_column(std::size_t axis, std::int64_t column, const Rational& x) const {
  const std::vector<Rational>& at = axes_[axis].at;
  const auto k = static_cast<std::size_t>(column);
  return (k == 0 || at[k - 1] <= x) && (k == at.size() || x <= at[k]);
}

std::size_t PointGridLines::bytes() const {
  constexpr std::size_t kNode = 48;
  std::size_t total = 0;
  for (const Axis& axis : axes_) {
    total += axis.known.size() * (sizeof(Rational) + sizeof(ObjectId) + kNode) +
             axis.lines.capacity() * sizeof(ObjectId) + axis.at.capacity() * sizeof(Rational);
  }
  return total;
}

}  // namespace kinex
