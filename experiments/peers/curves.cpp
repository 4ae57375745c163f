// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "experiments/peers/tables.h"

namespace kinex::peers {

lab::Figure figure_of(const std::string& title, const std::string& caption, const std::string& x_label,
                 const std::string& y_label, const std::vector<Curve>& curves) {
  lab::Figure figure;
  figure.title = title;
  figure.caption = caption;
  std::string plot;
  std::string& script = figure.script;
  script =
      "set logscale xy\nset grid lc rgb '#dddddd' lw 0.7\nset border 3 lc rgb '#444444'\n"
      "set tics nomirror\nset format y '10^{%L}'\nset format x '%g'\nset rmargin 4\n"
      "set key outside below center horizontal Left reverse samplen 2.5 maxcols 3 width 2\n";
  script += "set xlabel " + lab::quoted(x_label) + " offset 0,0.5\nset ylabel " + lab::quoted(y_label) + "\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].points.empty()) continue;
    const std::string block = "$c" + std::to_string(i);
    script += block + " << EOD\n";
    for (const auto& [x, y] : curves[i].points) {
      char line[80];
      std::snprintf(line, sizeof line, "%.17g %.17g\n", x, y);
      script += line;
    }
    script += "EOD\n";
    const lab::Look& style = lab::look(i);
    plot += (plot.empty() ? "plot " : ", \\\n  ") + block +
            " using 1:2 with linespoints lw 1.5 pt " + std::to_string(style.symbol) +
            " ps 0.7 lc rgb '" + style.colour + "' title " + lab::quoted(curves[i].name);
  }
  script += plot + "\n";
  return figure;
}

}  // namespace kinex::peers
