// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/predicates/ccd/contact_support.h"

#include <cmath>

namespace kinex::test {

ContactQuery query_of(ContactKind kind, const Points& points) {
  std::vector<Rational> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
  return ContactQuery(kind, std::move(coordinates));
}

Points points_of(const ContactQuery& query) {
  Points points;
  for (std::size_t i = 0; i < ContactQuery::kCoordinates; ++i) {
    points[i / 3][i % 3] = query.coordinate(i);
  }
  return points;
}

std::array<Point, 4> positions(const Points& points, const Rational& t) {
  std::array<Point, 4> result;
  for (std::size_t p = 0; p < 4; ++p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[p][axis] = points[p][axis] + t * (points[p + 4][axis] - points[p][axis]);
    }
  }
  return result;
}

std::string show(ContactKind kind, const Points& points) {
  std::string text = kind == ContactKind::kVertexFace ? "vertex-face" : "edge-edge";
  for (const Point& p : points) {
    text += " (" + p[0].to_string() + ", " + p[1].to_string() + ", " + p[2].to_string() + ")";
  }
  return text;
}

Points QueryMaker::small() {
  constexpr std::array<int, 7> kSizes{1, 1, 2, 2, 3, 5, 20};
  const std::int64_t size = kSizes[static_cast<std::size_t>(integer(0, 6))];
  Points points;
  for (Point& p : points) {
    for (Rational& x : p) x = Rational(integer(-size, size));
  }
  switch (integer(0, 8)) {
    case 0:  // in a plane
      for (Point& p : points) p[2] = Rational(0);
      break;
    case 1:  // three points at rest
      for (std::size_t i = 1; i < 4; ++i) points[i + 4] = points[i];
      break;
    case 2: {  // two points that start as one, and may stay so
      const auto i = static_cast<std::size_t>(integer(0, 3));
      const auto j = static_cast<std::size_t>(integer(0, 3));
      points[i] = points[j];
      if (chance(2)) points[i + 4] = points[j + 4];
      break;
    }
    case 3:  // on a line
      for (Point& p : points) p[1] = p[2] = Rational(0);
      break;
    case 4:  // in a plane that moves
      for (std::size_t i = 0; i < 8; ++i) {
        points[i][2] = points[i][0] - Rational(2) * points[i][1] + Rational(i < 4 ? 0 : 3);
      }
      break;
    case 5:
      for (Point& p : points) {
        for (Rational& x : p) x /= Rational(integer(1, 3));
      }
      break;
    case 6:  // all at rest
      for (std::size_t i = 0; i < 4; ++i) points[i + 4] = points[i];
      break;
    default:
      break;
  }
  return points;
}

ContactQuery::Doubles QueryMaker::ordinary(ContactKind kind) {
  ContactQuery::Doubles c;
  for (double& x : c) x = unit();
  // The first body passes from one side to the other.
  const std::size_t points = kind == ContactKind::kVertexFace ? 1 : 2;
  for (std::size_t p = 0; p < points; ++p) {
    c[ContactQuery::index(0, p, 2)] += 1.5;
    c[ContactQuery::index(1, p, 2)] -= 1.5;
  }
  return c;
}

ContactQuery::Doubles QueryMaker::near(ContactKind kind, double gap) {
  ContactQuery::Doubles c = ordinary(kind);
  // All points are moved so that a point of one body comes within the gap of a point of the other's
  // border at a random time.
  const double t = 0.5 + unit() / 2, along = 0.5 + unit() / 2, other = 0.5 + unit() / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = [&](std::size_t p) {
      return c[ContactQuery::index(0, p, axis)] * (1 - t) + c[ContactQuery::index(1, p, axis)] * t;
    };
    const bool face = kind == ContactKind::kVertexFace;
    const double first = face ? at(0) : at(0) * (1 - other) + at(1) * other;
    const double second = face ? at(1) * (1 - along) + at(2) * along : at(2);
    const double shift = second - first + gap * unit();
    for (std::size_t p = 0; p < (face ? 1u : 2u); ++p) {
      c[ContactQuery::index(0, p, axis)] += shift;
      c[ContactQuery::index(1, p, axis)] += shift;
    }
  }
  return c;
}

}  // namespace kinex::test
