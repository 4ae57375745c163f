// SPDX-License-Identifier: GPL-3.0-or-later
// Runs gnuplot, if it is installed.
#ifndef KINEX_EXPERIMENTS_LAB_GNUPLOT_H
#define KINEX_EXPERIMENTS_LAB_GNUPLOT_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace kinex::lab {

// A picture that gnuplot draws: commands and data, without "set terminal" and "set output".
struct Figure {
  std::string title;    // of the page's caption
  std::string caption;  // a description of the picture
  std::string script;
  int width = 640, height = 460;
  bool joins = false;  // in one frame with the figure before it, sharing its caption
  std::string panel = {};  // of several in a frame: what this one shows
  std::vector<std::string> names =
      {};  // of what is plotted, in plain text, in that order; empty: gnuplot's own
};

// The title with that of the panel: what a picture is called where nothing is beside it.
std::string picture_title(const Figure& figure);

struct Drawings {
  std::vector<std::string> svg;  // by figure; empty if it could not be drawn
  std::string problem;           // the reason why some are missing; empty if none is
};

// Draws all figures as SVG, each with its title and its caption as a description, in one run of `program`, in a fresh temporary folder that is removed.
// When `go_on` returns false, drawing ends; the rest is not drawn.
Drawings draw(
    const std::vector<Figure>& figures, const std::string& program = "gnuplot",
    const std::function<bool()>& go_on = [] { return true; });

// Colour and symbol of the i-th curve, distinct without colours for fifteen curves; the first six with any
// colour vision (Okabe and Ito, 2008). `hollow`: the symbol through which a curve above shows.
struct Look {
  const char* colour;
  int symbol, hollow;
};
const Look& look(std::size_t i);
// Dash types of the i-th bound and of the i-th guide, distinct for six of each.
const char* dash(std::size_t i);
const char* guide_dash(std::size_t i);

// A string in gnuplot's notation, without markup; `marked` without the quotes, to be put together
// with markup.
std::string quoted(const std::string& text);
std::string marked(const std::string& text);
// The command for a title above the picture, in plain text: a line, and below it a second one if it is not
// empty. A line of 640 pixels has room for some 80 letters.
std::string title_command(const std::string& first, const std::string& second = "");
// A formula in plain text ("Theta(n^(3/2)) log^2 n") with its markup: raised exponents, Greek letters.
std::string formula(const std::string& text);

}  // namespace kinex::lab

#endif
