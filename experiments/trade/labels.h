// SPDX-License-Identifier: GPL-3.0-or-later
// LabelPlacer: places labels beside their points so that they cover neither points nor each other.
#ifndef KINEX_EXPERIMENTS_TRADE_LABELS_H
#define KINEX_EXPERIMENTS_TRADE_LABELS_H

#include <string>
#include <vector>

namespace kinex::trade {

// All in pixels, y upwards.
class LabelPlacer {
 public:
  struct Box {
    double left, bottom, right, top;
  };
  struct Label {
    double x, y;                                // of the middle of its left or right side
    const char* align;                          // "left": x is its left side; "right"
    bool far;                                   // a line should lead to it
    double anchor_x, anchor_y, from_x, from_y;  // that line
  };

  // Labels stay inside.
  explicit LabelPlacer(const Box& area) : area_(area) {}
  void add_point(double x, double y, double radius);
  // The nearest free place for the label of the point at (x, y), which is then taken; if there is
  // none, the place that covers the fewest others.
  Label place(const std::string& text, double x, double y);

 private:
  int covered(const Box& box) const;

  Box area_;
  std::vector<Box> taken_;
};

}  // namespace kinex::trade

#endif
