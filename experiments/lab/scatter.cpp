// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/lab/curves.h"
#include "experiments/lab/label_placer.h"

namespace kinex::lab {

namespace {

constexpr const char* kMedianStyle = "pt 6 ps 1.6 lw 2 lc rgb '#222222'";
constexpr double kMedianSize = 1.6, kWiderMedian = 1;  // a ring around a median that another covers
constexpr double kMedianRadius = 7;                    // pixels
constexpr double kLegendHeight = 0.03;
constexpr int kPictureWidth = 640, kPictureHeight = 560;
// Of the picture, from the left and from below.
constexpr double kLeft = 0.15, kRight = 0.97, kBelow = 0.17, kAbove = 0.97;
constexpr double kPartingLine = 1 / 28.0;  // of the axis of y, between zeros, at the bottom, and numbers

// Of logarithms.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : std::sqrt(values[middle - 1] * values[middle]);
}

class ScatterDrawing {
 public:
  ScatterDrawing(const ScatterPicture& picture, const std::vector<ScatterGroup>& groups)
      : picture_(picture), groups_(groups) {
    double least = 1, most = 0;
    for (const ScatterGroup& group : groups) {
      for (const ScatterPoint& point : group.points) {
        low_ = std::min(low_, point.x);
        high_ = std::max(high_, point.x);
        if (point.y > 0) least = std::min(least, point.y);
        most = std::max(most, std::min(point.y, picture.most_y));
      }
    }
    low_ /= 1.6;
    high_ *= 2;
    const int top = most > 0 ? static_cast<int>(std::ceil(std::log10(most))) : 0;
    const int lowest = static_cast<int>(std::floor(std::log10(least)));
    const int room = std::max(2, (top - lowest) / 12);  // below the smallest one
    bottom_ = std::min(lowest, top - 4) - room;
    top_ = top + 1;
  }

  void draw(Figure& figure) {
    figure.width = kPictureWidth;
    figure.height = kPictureHeight;
    add_data();
    figure.script = kFrame +
                    fmt::format(
                        "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen "
                        "{}\nset tmargin at screen {}\n",
                        kLeft, kRight, kBelow, kAbove) +
                    "unset key\n" + legend() + "set logscale xy\n" +
                    log_tics('x', low_, high_, TicForm::kPowers) + "set xlabel " +
                    quoted(picture_.x) + "\nset ylabel " + quoted(picture_.y) + " offset 1,0\n" +
                    fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [1e{}:1e{}]\n", low_, high_,
                                bottom_, top_) +
                    y_tics() + labels_ + data_ + plot_ + "\n";
  }

 private:
  double height_of(double y) const {
    return y > 0 ? std::min(y, picture_.most_y) : std::pow(10, bottom_);
  }
  double pixel_x(double x) const {
    return kPictureWidth * (kLeft + (kRight - kLeft) * std::log(x / low_) / std::log(high_ / low_));
  }
  double pixel_y(double y) const {
    const double share = (std::log10(height_of(y)) - bottom_) / (top_ - bottom_);
    return kPictureHeight * (kBelow + (kAbove - kBelow) * share);
  }

  std::string y_tics() const {
    int step = 1;
    for (const int candidate : {1, 2, 5, 10, 20, 50, 100, 200}) {
      step = candidate;
      if ((top_ - bottom_) / step <= 10) break;
    }
    std::string tics = fmt::format("set ytics ('none' 1e{}", bottom_);
    for (int k = top_ - (top_ % step + step) % step; k > bottom_ + step / 2; k -= step) {
      tics += fmt::format(", '10^{{{0}}}' 1e{0}", k);
    }
    // Zero is no number of this axis: a line parts it from those that are.
    return tics + fmt::format(")\nset arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} "
                              "nohead dt 2 lw 1 lc rgb '#888888'\n",
                              std::pow(10, bottom_ + (top_ - bottom_) * kPartingLine));
  }

  // One line below the axes.
  std::string legend() const {
    const auto entry = [](const char* title, double place, const char* style) {
      return fmt::format("set label {} at screen {},{} left point {} offset 1.1,-0.35\n",
                         quoted(title), place, kLegendHeight, style);
    };
    std::string text = entry("median", picture_.median_place, kMedianStyle);
    for (const ScatterKind& kind : picture_.kinds) text += entry(kind.title, kind.place, kind.style);
    return text;
  }

  void add_data() {
    LabelPlacer placer({kPictureWidth * kLeft, kPictureHeight * kBelow, kPictureWidth * kRight, kPictureHeight * kAbove});
    const double line = kPictureHeight * (kBelow + (kAbove - kBelow) * kPartingLine);
    placer.add_obstacle({kPictureWidth * kLeft, line - 1, kPictureWidth * kRight, line + 1});
    std::vector<std::string> blocks(picture_.kinds.size());
    std::vector<std::pair<double, double>> medians;
    for (const ScatterGroup& group : groups_) {
      std::vector<double> x, y;
      for (const ScatterPoint& point : group.points) {
        x.push_back(point.x);
        y.push_back(std::min(point.y, picture_.most_y));
        blocks[point.kind] += fmt::format("{:.6g} {:.6g}\n", point.x, height_of(point.y));
        placer.add_point(pixel_x(point.x), pixel_y(point.y), 3);
      }
      medians.emplace_back(median(std::move(x)), median(std::move(y)));
    }
    const std::vector<double> sizes = sizes_of(medians);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      placer.add_point(pixel_x(medians[i].first), pixel_y(medians[i].second),
                       kMedianRadius * sizes[i] / kMedianSize, true);
    }
    data_ = "$medians << EOD\n";
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const auto& [x, y] = medians[i];
      data_ += fmt::format("{:.6g} {:.6g} {:.3g}\n", x, height_of(y), sizes[i]);
      add_label(groups_[i].label, placer.place(groups_[i].label, pixel_x(x), pixel_y(y)));
    }
    data_ += "EOD\n";
    plot_ = "plot $medians using 1:2:3 with points pt 6 ps variable lw 2 lc rgb '#222222'";
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      data_ += fmt::format("$kind{} << EOD\n{}EOD\n", i, blocks[i].empty() ? "NaN NaN\n" : blocks[i]);
      plot_ += fmt::format(", \\\n  $kind{} using 1:2 with points {}", i, picture_.kinds[i].style);
    }
  }

  // Of the medians' circles: one that lies on others is a ring around them.
  std::vector<double> sizes_of(const std::vector<std::pair<double, double>>& medians) const {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < medians.size(); ++i) {
      double size = kMedianSize;
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = std::hypot(pixel_x(medians[i].first) - pixel_x(medians[j].first),
                                        pixel_y(medians[i].second) - pixel_y(medians[j].second));
        if (apart < kMedianRadius) size = std::max(size, sizes[j] + kWiderMedian);
      }
      sizes.push_back(size);
    }
    return sizes;
  }

  void add_label(const std::string& text, const LabelPlacer::Label& label) {
    labels_ += fmt::format("set label {} at screen {:.5f},{:.5f} {} front\n", quoted(text),
                           label.x / kPictureWidth, label.y / kPictureHeight, label.align);
    if (!label.far) return;
    labels_ += fmt::format(
        "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead lc rgb '#888888' lw 0.7\n",
        label.anchor_x / kPictureWidth, label.anchor_y / kPictureHeight, label.from_x / kPictureWidth,
        label.from_y / kPictureHeight);
  }

  const ScatterPicture& picture_;
  const std::vector<ScatterGroup>& groups_;
  double low_ = 1, high_ = 1;     // of x
  int bottom_ = 0, top_ = 0;      // of y, powers of ten; zeros are at the bottom
  std::string labels_, data_, plot_;
};

}  // namespace

void set_scatter(Figure& figure, const ScatterPicture& picture,
                 const std::vector<ScatterGroup>& groups) {
  ScatterDrawing(picture, groups).draw(figure);
}

}  // namespace kinex::lab
