// SPDX-License-Identifier: GPL-3.0-or-later
// LabelPlacer: places labels beside their points so that they cover neither points nor each other.
#ifndef KINEX_EXPERIMENTS_LAB_LABEL_PLACER_H
#define KINEX_EXPERIMENTS_LAB_LABEL_PLACER_H

#include <string>
#include <utility>
#include <vector>

namespace kinex::lab {

// All in pixels, y upwards.
class LabelPlacer {
 public:
  struct Box {
    double left, bottom, right, top;
  };
  struct Label {
    double x, y;        // of the middle of its left or right side, or of itself
    const char* align;  // "left": x is its left side; "right"; "center"
    bool far;                                   // draw a line from the label to its point
    double anchor_x, anchor_y, from_x, from_y;  // that line: its end at the label, the point
  };

  // Labels stay inside the area wherever a place inside is among those tried.
  explicit LabelPlacer(const Box& area) : area_(area) {}
  // `named`: it has a label, which is not placed nearer to another point with one, or has a line.
  void add_point(double x, double y, double radius, bool named = false);
  void add_obstacle(const Box& box);  // something else that is drawn: it counts as a point
  // Takes the first free place for the label of the point at (x, y), the nearest rows first. If no
  // place that is tried is free, it takes the one that covers the fewest points, and no label if
  // that can be. The text is set at 13 points, 7.2 pixels a byte. Cost: O(points and labels).
  Label place(const std::string& text, double x, double y);

 private:
  int covered(const Box& box) const;
  // True if the end of a label's line is nearer to another named point than to its own.
  bool misleads(const Label& label) const;

  Box area_;
  std::vector<Box> points_, labels_;
  std::vector<std::pair<double, double>> named_;
};

}  // namespace kinex::lab

#endif
