// SPDX-License-Identifier: GPL-3.0-or-later
// Labels cover neither points nor each other.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/lab/label_placer.h"

namespace kinex {
namespace label_placer_test {

// The left side of a label of so many letters.
double left_of(const lab::LabelPlacer::Label& label, double letters) {
  const std::string align = label.align;
  return label.x - (align == "left" ? 0 : align == "right" ? 1 : 0.5) * letters * 7.2;
}

TEST(LabelPlacer, CoversNothingWhereThereIsRoom) {
  lab::LabelPlacer placer({0, 0, 600, 400});
  std::vector<lab::LabelPlacer::Label> labels;
  for (int i = 0; i < 8; ++i) placer.add_point(300 + i, 200 + 2 * i, 5);
  for (int i = 0; i < 8; ++i) labels.push_back(placer.place("a label", 300 + i, 200 + 2 * i));
  const auto left = [](const lab::LabelPlacer::Label& label) { return left_of(label, 7); };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_GE(left(labels[i]), 0);
    EXPECT_LE(left(labels[i]) + 7 * 7.2, 600);
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = std::fabs(labels[i].y - labels[j].y) >= 15 ||
                         std::fabs(left(labels[i]) - left(labels[j])) >= 7 * 7.2;
      EXPECT_TRUE(apart) << i << " " << j;
    }
  }
}

// Where points leave room for one label the others lie on points, but not on each other.
TEST(LabelPlacer, CoversPointsRatherThanLabels) {
  lab::LabelPlacer placer({0, 0, 600, 500});
  for (int x = 0; x < 600; x += 6) {
    for (int y = 0; y < 500; y += 6) {
      const bool room = x > 300 && x < 385 && y > 235 && y < 265;
      if (!room) placer.add_point(x, y, 3);
    }
  }
  std::vector<double> left, middle;
  for (int i = 0; i < 9; ++i) {
    const lab::LabelPlacer::Label label = placer.place("mpfr:100", 300, 250);
    left.push_back(left_of(label, 8));
    middle.push_back(label.y);
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(std::fabs(middle[i] - middle[j]) >= 15 || std::fabs(left[i] - left[j]) >= 8 * 7.2)
          << i << " " << j;
    }
  }
}

// The label of the left one of two points beside each other, at the edge: the right one would seem to have it.
TEST(LabelPlacer, NoLabelIsAtAnotherPoint) {
  lab::LabelPlacer placer({0, 0, 600, 400});
  placer.add_point(40, 200, 7, true);
  placer.add_point(56, 200, 7, true);
  for (const double x : {40.0, 56.0}) {
    const lab::LabelPlacer::Label label = placer.place("double 5/6", x, 200);
    const double own = std::hypot(label.anchor_x - x, label.anchor_y - 200);
    EXPECT_LE(own, std::hypot(label.anchor_x - (96 - x), label.anchor_y - 200) + 0.5) << x;
  }
}

// A line across the picture beside the point: the label is above it or below.
TEST(LabelPlacer, CoversNoObstacle) {
  for (const double y : {192.0, 196.0, 200.0, 203.0}) {
    lab::LabelPlacer placer({0, 0, 600, 400});
    placer.add_point(300, 200, 5);
    placer.add_obstacle({0, y - 1, 600, y + 1});
    EXPECT_GE(std::fabs(placer.place("a label", 300, 200).y - y), 8.5) << y;
  }
}

TEST(LabelPlacer, StaysInside) {
  lab::LabelPlacer placer({0, 0, 100, 50});
  const lab::LabelPlacer::Label label = placer.place("1234567", 95, 25);
  EXPECT_STREQ(label.align, "right");
  EXPECT_LT(label.x, 95);
}

}  // namespace label_placer_test
}  // namespace kinex
