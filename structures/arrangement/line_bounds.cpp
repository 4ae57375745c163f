// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_bounds.h"

#include "structures/parts/binomial.h"

namespace kinex {
namespace {

Integer sum_of(const std::vector<int>& pieces) {
  Integer sum(0);
  for (const int p : pieces) sum += Integer(p);
  return sum;
}

}  // namespace

std::vector<bool> lines_of(const Scene& scene) {
  std::vector<bool> result;
  for (const SceneObject& object : scene.objects) result.push_back(object.line);
  return result;
}

LinesAndPoints::LinesAndPoints(const BoundContext& context, const std::vector<bool>& is_line) {
  for (std::size_t i = 0; i < context.pieces.size(); ++i) {
    const std::size_t object = context.members.empty() ? i : context.members[i];
    (is_line[object] ? lines : points).push_back(context.pieces[i]);
  }
}

// Of all pairs, those of two lines and of two points are too many.
Integer side_changes(const LinesAndPoints& both, int degree) {
  std::vector<int> all = both.lines;
  all.insert(all.end(), both.points.begin(), both.points.end());
  return pair_sign_changes(all, degree) - pair_sign_changes(both.lines, degree) -
         pair_sign_changes(both.points, degree);
}

// Of n lines and m points every line is in m (n - 1) of these sets, every point in C(n, 2).
Integer order_changes(const LinesAndPoints& both, int degree) {
  const Integer n = counted(both.lines.size()), m = counted(both.points.size());
  if (n.is_zero()) return n;
  const Integer sets = m * pairs(n);
  const Integer joint = m * (n - Integer(1)) * sum_of(both.lines) + pairs(n) * sum_of(both.points) -
                        Integer(2) * sets;
  return Integer(degree + 1) * joint - sets;
}

// Every object is in C(n - 1, 2) triples. k joint pieces have degree * k roots and k - 1 ends.
Integer triple_sign_changes(const std::vector<int>& pieces, int degree) {
  const Integer n = counted(pieces.size());
  if (n.is_zero()) return n;
  const Integer triples = binomial(n, 3);
  const Integer joint = binomial(n - Integer(1), 2) * sum_of(pieces) - Integer(2) * triples;
  return Integer(degree + 1) * joint - triples;
}

// p, q, r and s pieces make at most p + q + r + s - 3 joint ones.
Integer quadruple_sign_changes(const std::vector<int>& pieces, int degree) {
  const Integer n = counted(pieces.size());
  if (n.is_zero()) return n;
  const Integer quadruples = binomial(n, 4);
  const Integer joint = binomial(n - Integer(1), 3) * sum_of(pieces) - Integer(3) * quadruples;
  return Integer(degree + 1) * joint - quadruples;
}

}  // namespace kinex
