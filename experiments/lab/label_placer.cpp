// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/label_placer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex::lab {

namespace {

constexpr double kCharacter = 7.2;  // width at 13 points, with some room
constexpr double kHalfHeight = 7.5;
constexpr double kNear = 12;  // from a point to its label
constexpr double kStep = 8;   // between the places that are tried
constexpr int kRings = 40;
constexpr double kFar = 22;     // up or down, from which on a line leads to the label
constexpr int kOnLabel = 100;   // covering a label counts as covering this many points
constexpr int kOutside = 1000;  // likewise, leaving the area

bool overlap(const LabelPlacer::Box& a, const LabelPlacer::Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

}  // namespace

void LabelPlacer::add_point(double x, double y, double radius, bool named) {
  add_obstacle({x - radius, y - radius, x + radius, y + radius});
  if (named) named_.emplace_back(x, y);
}

bool LabelPlacer::misleads(const Label& label) const {
  const double own = std::hypot(label.anchor_x - label.from_x, label.anchor_y - label.from_y);
  return std::any_of(named_.begin(), named_.end(), [&](const auto& other) {
    return std::hypot(label.anchor_x - other.first, label.anchor_y - other.second) < own - 0.5;
  });
}

void LabelPlacer::add_obstacle(const Box& box) { points_.push_back(box); }

int LabelPlacer::covered(const Box& box) const {
  int count = 0;
  for (const Box& other : points_) count += overlap(box, other) ? 1 : 0;
  for (const Box& other : labels_) count += overlap(box, other) ? kOnLabel : 0;
  if (box.left < area_.left || box.right > area_.right || box.bottom < area_.bottom ||
      box.top > area_.top) {
    count += kOutside;
  }
  return count;
}

LabelPlacer::Label LabelPlacer::place(const std::string& text, double x, double y) {
  const double width = kCharacter * static_cast<double>(text.size());
  int fewest = std::numeric_limits<int>::max();
  Label best{};
  Box best_box{};
  const auto attempt = [&](const Box& box, Label label) {
    const bool misled = misleads(label);
    const int count = covered(box) + (misled ? 1 : 0);
    if (count >= fewest) return;
    fewest = count;
    best_box = box;
    label.far = label.far || misled;
    best = label;
  };
  // Beside the point first, then in growing rings.
  for (int ring = 0; ring <= kRings && fewest > 0; ++ring) {
    for (const int sideways : {0, 1, 3, 6}) {
      for (const int vertical : {ring, -ring}) {
        for (const bool right : {true, false}) {
          const double away = kNear + kStep * sideways;
          const double middle = y + kStep * vertical;
          const double left = right ? x + away : x - away - width;
          const Box box{left, middle - kHalfHeight, left + width, middle + kHalfHeight};
          const bool far = std::max(kStep * ring, away - kNear) >= kFar;
          attempt(box, {right ? box.left : box.right, middle, right ? "left" : "right", far,
                        right ? box.left - 2 : box.right + 2, middle, x, y});
        }
      }
    }
    for (const int vertical : {ring, -ring}) {  // above or below
      if (ring < 2) continue;
      const double middle = y + kStep * vertical,
                   end = middle - (vertical > 0 ? 1 : -1) * kHalfHeight;
      attempt({x - width / 2, middle - kHalfHeight, x + width / 2, middle + kHalfHeight},
              {x, middle, "center", kStep * ring >= kFar, x, end, x, y});
    }
  }
  labels_.push_back(best_box);
  return best;
}

}  // namespace kinex::lab
