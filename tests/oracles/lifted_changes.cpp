// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation is the lower side of the convex hull of the points lifted to |x|^2 - w. It changes when
// d + 2 lifted points are in one hyperplane and all others above it, or when d + 1 points are in one
// hyperplane and all others on one side of it. So all sets of d + 2 and of d + 1 points are gone through.
#include "tests/oracles/lifted_changes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "tests/oracles/polynomials.h"

namespace oracles {

namespace {

// Gaussian elimination; 0 if the matrix is singular. `right`, if there is one, becomes the solution.
template <std::size_t kSize>
double eliminate(std::array<std::array<double, kSize>, kSize> m, std::array<double, kSize>* right) {
  double determinant = 1;
  for (std::size_t column = 0; column < kSize; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < kSize; ++row) {
      if (std::fabs(m[row][column]) > std::fabs(m[pivot][column])) pivot = row;
    }
    if (m[pivot][column] == 0) return 0;
    if (pivot != column) {
      std::swap(m[pivot], m[column]);
      if (right != nullptr) std::swap((*right)[pivot], (*right)[column]);
      determinant = -determinant;
    }
    determinant *= m[column][column];
    for (std::size_t row = column + 1; row < kSize; ++row) {
      const double factor = m[row][column] / m[column][column];
      for (std::size_t k = column; k < kSize; ++k) m[row][k] -= factor * m[column][k];
      if (right != nullptr) (*right)[row] -= factor * (*right)[column];
    }
  }
  if (right != nullptr) {
    for (std::size_t row = kSize; row-- > 0;) {
      for (std::size_t k = row + 1; k < kSize; ++k) (*right)[row] -= m[row][k] * (*right)[k];
      (*right)[row] /= m[row][row];
    }
  }
  return determinant;
}

// The polynomial through the values at the nodes: divided differences, multiplied out.
Polynomial interpolation(const std::vector<double>& nodes, std::vector<double> values) {
  const std::size_t n = nodes.size();
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t i = n - 1; i >= order; --i) {
      values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - order]);
    }
  }
  Polynomial p{values[n - 1]};
  for (std::size_t i = n - 1; i-- > 0;) {
    p.insert(p.begin(), 0);
    for (std::size_t k = 0; k + 1 < p.size(); ++k) p[k] -= nodes[i] * p[k + 1];
    p[0] += values[i];
  }
  return p;
}

// True if the coefficients in the Bernstein basis of [0, 1] have one sign: then p has no zero there.
bool has_one_sign(const Polynomial& p) {
  std::vector<double> b = p;
  const std::size_t degree = p.size() - 1;
  double choose = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    b[i] /= choose;
    choose = choose * static_cast<double>(degree - i) / static_cast<double>(i + 1);
  }
  for (std::size_t order = 1; order <= degree; ++order) {
    for (std::size_t i = degree; i >= order; --i) b[i] += b[i - 1];
  }
  bool positive = true, negative = true;
  for (const double c : b) {
    positive = positive && c > 0;
    negative = negative && c < 0;
  }
  return positive || negative;
}

template <std::size_t kAxes>
class Lifted {
 public:
  Lifted(bool weighted, int n, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    const double root = kAxes == 3 ? std::cbrt(n) : std::sqrt(n);
    for (int i = 0; i < n; ++i) {
      Line line{};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        line.at[axis] = uniform();
        line.by[axis] = uniform() - line.at[axis];
      }
      if (weighted) {
        line.at[kAxes] = uniform() / root / root;
        line.by[kAxes] = uniform() / root / root - line.at[kAxes];
      }
      lines_.push_back(line);
    }
    for (std::size_t i = 0; i <= kAxes + 2; ++i) {  // as many as a polynomial of degree d + 2 needs
      nodes_.push_back(static_cast<double>(i) / (kAxes + 2));
      at_nodes_.push_back(positions(nodes_.back()));
    }
  }

  std::uint64_t changes() {
    std::uint64_t sum = 0;
    std::array<std::size_t, kAxes + 2> cell{};
    for_each(cell, 0, 0, [&] { sum += touches<kAxes + 2>(cell); });
    std::array<std::size_t, kAxes + 1> facet{};
    for_each(facet, 0, 0, [&] { sum += touches<kAxes + 1>(facet); });
    return sum;
  }

 private:
  struct Line {
    std::array<double, kAxes + 1> at, by;  // the weight last
  };
  using Row = std::array<double, kAxes + 1>;  // a lifted point

  std::vector<Row> positions(double t) const {
    std::vector<Row> rows;
    for (const Line& line : lines_) {
      Row row{};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        row[axis] = line.at[axis] + t * line.by[axis];
        row[kAxes] += row[axis] * row[axis];
      }
      row[kAxes] -= line.at[kAxes] + t * line.by[kAxes];
      rows.push_back(row);
    }
    return rows;
  }
  template <std::size_t kCount, class Visit>
  void for_each(std::array<std::size_t, kCount>& ids, std::size_t place, std::size_t first,
                const Visit& visit) {
    if (place == kCount) return visit();
    for (ids[place] = first; ids[place] < lines_.size(); ++ids[place]) {
      for_each(ids, place + 1, ids[place] + 1, visit);
    }
  }
  // The determinant of the last kCount - 1 points minus the first, in as many coordinates.
  template <std::size_t kCount>
  static double volume(const std::vector<Row>& rows, const std::array<std::size_t, kCount>& ids) {
    std::array<std::array<double, kCount - 1>, kCount - 1> m{};
    for (std::size_t i = 0; i + 1 < kCount; ++i) {
      for (std::size_t k = 0; k + 1 < kCount; ++k) m[i][k] = rows[ids[i + 1]][k] - rows[ids[0]][k];
    }
    return eliminate<kCount - 1>(m, nullptr);
  }
  // How often the points are in one hyperplane that has no other point on the wrong side.
  template <std::size_t kCount>
  std::uint64_t touches(const std::array<std::size_t, kCount>& ids) const {
    std::vector<double> values;
    for (const std::vector<Row>& rows : at_nodes_) values.push_back(volume(rows, ids));
    const Polynomial p = interpolation(nodes_, std::move(values));
    if (has_one_sign(p)) return 0;
    std::vector<double> times;
    zeros(p, 0, 1, times);
    std::uint64_t sum = 0;
    for (const double t : times) {
      const std::vector<Row> rows = positions(t);
      if constexpr (kCount == kAxes + 2) {
        sum += all_above(rows, ids) ? 1 : 0;
      } else {
        sum += all_on_one_side(rows, ids) ? 1 : 0;
      }
    }
    return sum;
  }
  // The hyperplane through the lifted points, by those d + 1 of them that span the largest simplex.
  static bool all_above(const std::vector<Row>& rows,
                        const std::array<std::size_t, kAxes + 2>& ids) {
    std::array<std::size_t, kAxes + 1> best{};
    double largest = -1;
    for (std::size_t out = 0; out < ids.size(); ++out) {
      std::array<std::size_t, kAxes + 1> simplex{};
      for (std::size_t i = 0, k = 0; i < ids.size(); ++i) {
        if (i != out) simplex[k++] = ids[i];
      }
      const double size = std::fabs(volume(rows, simplex));
      if (size > largest) largest = size, best = simplex;
    }
    std::array<std::array<double, kAxes>, kAxes> m{};
    std::array<double, kAxes> slope{};
    const Row& origin = rows[best[0]];
    for (std::size_t i = 0; i < kAxes; ++i) {
      for (std::size_t k = 0; k < kAxes; ++k) m[i][k] = rows[best[i + 1]][k] - origin[k];
      slope[i] = rows[best[i + 1]][kAxes] - origin[kAxes];
    }
    eliminate<kAxes>(m, &slope);
    return of_others(rows, ids, [&](const Row& row) {
      double height = row[kAxes] - origin[kAxes];
      for (std::size_t k = 0; k < kAxes; ++k) height -= slope[k] * (row[k] - origin[k]);
      return height > 0;
    });
  }
  // The hyperplane through the points, by those d of them that span the largest face.
  static bool all_on_one_side(const std::vector<Row>& rows,
                              const std::array<std::size_t, kAxes + 1>& ids) {
    Row normal{};
    double largest = -1;
    std::size_t origin = ids[0];
    for (std::size_t out = 0; out < ids.size(); ++out) {
      std::array<std::size_t, kAxes> face{};
      for (std::size_t i = 0, k = 0; i < ids.size(); ++i) {
        if (i != out) face[k++] = ids[i];
      }
      const Row candidate = normal_of(rows, face);
      double size = 0;
      for (std::size_t k = 0; k < kAxes; ++k) size += candidate[k] * candidate[k];
      if (size > largest) largest = size, normal = candidate, origin = face[0];
    }
    for (const bool side : {true, false}) {
      const bool all = of_others(rows, ids, [&](const Row& row) {
        double height = 0;
        for (std::size_t k = 0; k < kAxes; ++k) height += normal[k] * (row[k] - rows[origin][k]);
        return (height > 0) == side;
      });
      if (all) return true;
    }
    return false;
  }
  static Row normal_of(const std::vector<Row>& rows, const std::array<std::size_t, kAxes>& face) {
    const auto along = [&](std::size_t i, std::size_t k) {
      return rows[face[i]][k] - rows[face[0]][k];
    };
    if constexpr (kAxes == 2)
      return {-along(1, 1), along(1, 0), 0};
    else {
      return {along(1, 1) * along(2, 2) - along(1, 2) * along(2, 1),
              along(1, 2) * along(2, 0) - along(1, 0) * along(2, 2),
              along(1, 0) * along(2, 1) - along(1, 1) * along(2, 0), 0};
    }
  }
  template <class Ids, class Holds>
  static bool of_others(const std::vector<Row>& rows, const Ids& ids, const Holds& holds) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      bool is_one = false;
      for (const std::size_t id : ids) is_one = is_one || id == i;
      if (!is_one && !holds(rows[i])) return false;
    }
    return true;
  }

  std::vector<Line> lines_;
  std::vector<double> nodes_;
  std::vector<std::vector<Row>> at_nodes_;
};

}  // namespace

std::uint64_t lifted_changes(int dimension, bool weighted, int n, std::uint64_t seed) {
  if (dimension == 2) return Lifted<2>(weighted, n, seed).changes();
  return Lifted<3>(weighted, n, seed).changes();
}

}  // namespace oracles
