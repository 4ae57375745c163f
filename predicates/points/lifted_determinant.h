// SPDX-License-Identifier: GPL-3.0-or-later
// The determinant whose rows are the differences of points from a last one, in the plane or in space,
// and the heights of the points over that of the last one; of points of one plane in space in projection on
// two axes, too. For formulas of predicates.
#ifndef KINEX_PREDICATES_POINTS_LIFTED_DETERMINANT_H
#define KINEX_PREDICATES_POINTS_LIFTED_DETERMINANT_H

namespace kinex {

// Rows (x, y, height(x, y, i)) of the points i = 0, 1, 2, from point 3. Expanded along the heights.
template <class Points, class Height>
auto lifted_determinant_2(const Points& p, const Height& height) {
  const auto ax = p(0, 0) - p(3, 0), ay = p(0, 1) - p(3, 1);
  const auto bx = p(1, 0) - p(3, 0), by = p(1, 1) - p(3, 1);
  const auto cx = p(2, 0) - p(3, 0), cy = p(2, 1) - p(3, 1);
  return wide_product(height(ax, ay, 0), bx * cy - by * cx) +
         wide_product(height(bx, by, 1), cx * ay - cy * ax) +
         wide_product(height(cx, cy, 2), ax * by - ay * bx);
}

// The negated determinant of the rows (x, y, z, height(x, y, z, i)) of the points i = 0 .. 3, from
// point 4. By Laplace's expansion along the columns (x, y) and (z, height): six products of a minor of
// two rows with the complementary minor of the other two. A minor is narrow, a product is wide.
template <class Points, class Height>
auto lifted_determinant_3(const Points& p, const Height& height) {
  const auto ex = p(4, 0), ey = p(4, 1), ez = p(4, 2);
  const auto ax = p(0, 0) - ex, ay = p(0, 1) - ey, az = p(0, 2) - ez;
  const auto bx = p(1, 0) - ex, by = p(1, 1) - ey, bz = p(1, 2) - ez;
  const auto cx = p(2, 0) - ex, cy = p(2, 1) - ey, cz = p(2, 2) - ez;
  const auto dx = p(3, 0) - ex, dy = p(3, 1) - ey, dz = p(3, 2) - ez;
  const auto as = height(ax, ay, az, 0), bs = height(bx, by, bz, 1);
  const auto cs = height(cx, cy, cz, 2), ds = height(dx, dy, dz, 3);
  return wide_product(ax * by - ay * bx, cs * dz - ds * cz) +
         wide_product(bx * cy - by * cx, as * dz - ds * az) +
         wide_product(cx * dy - cy * dx, as * bz - bs * az) +
         wide_product(dx * ay - dy * ax, cs * bz - bs * cz) +
         wide_product(ax * cy - ay * cx, ds * bz - bs * dz) +
         wide_product(bx * dy - by * dx, cs * az - as * cz);
}

// For two axes u, v of space and the third one w: the rows (u, v, height(2 u^2 + 2 v^2 + 2 w^2 - s w, i)) of the
// points i = 0, 1, 2, from point 3; s is the sum of w over the three rows. Of points of one plane w is a linear
// combination of u and v, and s w changes nothing. Of others it makes the determinant alternate in point 3, too,
// as it does when that is not taken away: there s is the sum over all four points.
template <class Points, class Height>
auto projected_determinant(const Points& p, int u, int v, const Height& height) {
  const int w = 3 - u - v;
  const auto eu = p(3, u), ev = p(3, v), ew = p(3, w);
  const auto au = p(0, u) - eu, av = p(0, v) - ev, aw = p(0, w) - ew;
  const auto bu = p(1, u) - eu, bv = p(1, v) - ev, bw = p(1, w) - ew;
  const auto cu = p(2, u) - eu, cv = p(2, v) - ev, cw = p(2, w) - ew;
  const auto as = aw - bw - cw, bs = bw - cw - aw, cs = cw - aw - bw;  // 2 w - s
  return wide_product(height(au * au + av * av + au * au + av * av + aw * as, 0),
                      bu * cv - bv * cu) +
         wide_product(height(bu * bu + bv * bv + bu * bu + bv * bv + bw * bs, 1),
                      cu * av - cv * au) +
         wide_product(height(cu * cu + cv * cv + cu * cu + cv * cv + cw * cs, 2),
                      au * bv - av * bu);
}

}  // namespace kinex

#endif
