// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of curves: what no picture may hide.
#include "experiments/lab/curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

namespace kinex::lab {
namespace curves_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::string script_of(const CurvesPicture& picture, const std::vector<Curve>& curves) {
  Figure figure;
  set_curves(figure, picture, curves);
  return figure.script;
}

const CurvesPicture kLogarithmic{"n", "events", true, true, {}};

TEST(Curves, NoZeroIsOnALogarithmicAxis) {
  const Curve calm{"calm", {{1, 0, 0}, {10, 0, 0}}, ""},
      busy{"busy", {{1, 0, 0}, {10, 5, 0}, {100, 50, 0}}, ""};
  const std::string script = script_of(kLogarithmic, {calm, busy});
  EXPECT_THAT(script, HasSubstr("title 'calm: 0 throughout'"));
  EXPECT_THAT(script, HasSubstr("title 'busy: 0 at 1'"));
  EXPECT_THAT(script, Not(HasSubstr("\n1 0 ")));
  const std::string linear = script_of({"n", "events", true, false, {}}, {busy});
  EXPECT_THAT(linear, HasSubstr("\n1 0 "));
  EXPECT_THAT(linear, HasSubstr("title 'busy'"));
}

TEST(Curves, CurvesThatRunAlongOthersAreWiderBelow) {
  const Curve one{"one", {{1, 4, 0}, {10, 40, 0}}, ""},
      same{"same", {{1, 4, 0}, {10, 40.1, 0}}, ""};
  const Curve other{"other", {{1, 4, 0}, {10, 60, 0}}, ""};
  const std::string script = script_of(kLogarithmic, {one, same, other});
  EXPECT_THAT(script, HasSubstr("$curve0 using 1:2 with linespoints lw 10 "));
  EXPECT_THAT(script, HasSubstr("$curve1 using 1:2 with linespoints lw 6 "));
  EXPECT_THAT(script, HasSubstr("$curve2 using 1:2 with linespoints lw 1.5 "));
}

// Each is seen beside the one above it: of three that cover one another in turn, each in another part.
TEST(Curves, WidthsFallAlongAChain) {
  std::vector<Curve> curves{{"below", {}, ""}, {"between", {}, ""}, {"above", {}, ""}};
  for (int n = 1; n <= 512; n *= 2) {
    curves[0].points.push_back({n * 1.0, n < 30 ? 3.0 * n : n, 0});
    curves[1].points.push_back({n * 1.0, n * 1.0, 0});
    if (n < 30) curves[2].points.push_back({n * 1.0, n * 1.0, 0});
  }
  const std::string script = script_of(kLogarithmic, curves);
  EXPECT_THAT(script, HasSubstr("$curve0 using 1:2 with linespoints lw 10 ps 2.6 pt 6 "));
  EXPECT_THAT(script, HasSubstr("$curve1 using 1:2 with linespoints lw 6 ps 1.7 pt 4 "));
  EXPECT_THAT(script, HasSubstr("$curve2 using 1:2 with linespoints lw 1.5 ps 0.8 pt 9 "));
}

// Two per cent apart, or five: the symbols lie on each other all the same.
TEST(Curves, SymbolsCoverWhatIsNearInThePicture) {
  Curve one{"one", {}, ""}, near{"near", {}, ""}, apart{"apart", {}, ""};
  for (double n = 10; n < 1e5; n *= 10) {
    one.points.push_back({n, n, 0});
    near.points.push_back({2 * n, 2.1 * n, 0});  // beside its line, between its points
    apart.points.push_back({n, 2 * n, 0});
  }
  EXPECT_THAT(script_of(kLogarithmic, {one, apart}),
              HasSubstr("$curve0 using 1:2 with linespoints lw 1.5 "));
  EXPECT_THAT(script_of(kLogarithmic, {near, one}),
              HasSubstr("$curve0 using 1:2 with linespoints lw 6 "));
}

// A legend of as many entries as there are looks: none is like another, with colours or without.
TEST(Curves, NoTwoEntriesLookAlike) {
  std::vector<Curve> curves;
  for (int i = 0; i < 15; ++i)
    curves.push_back(
        {"c" + std::to_string(i), {{1, std::pow(2, i), 0}, {10, std::pow(2, i) * 10, 0}}, ""});
  for (int i = 0; i < 6; ++i) {
    curves.push_back(
        {"b" + std::to_string(i), {{1, std::pow(3, i), 0}, {10, std::pow(3, i) * 10, 0}}, ""});
    curves.back().is_bound = true;
  }
  CurvesPicture picture = kLogarithmic;
  picture.slopes = {0.8, 0.9, 1, 1.1, 1.2, 1.3};
  const std::string script = script_of(picture, curves);
  const std::regex item("with [a-z]+ ([^']*)lc rgb '([^']*)' title '"), number("(lw|ps) [0-9.]+ ");
  std::set<std::string> coloured;
  std::set<std::pair<bool, std::string>> plain;  // a guide is grey, whatever it is printed on
  int entries = 0;
  for (std::sregex_iterator it(script.begin(), script.end(), item), end; it != end;
       ++it, ++entries) {
    const std::string style = std::regex_replace((*it)[1].str(), number, "");
    coloured.insert(style + (*it)[2].str());
    plain.emplace((*it)[2] == "#555555", style);
  }
  EXPECT_EQ(entries, 27);
  EXPECT_EQ(coloured.size(), 27u);
  EXPECT_EQ(plain.size(), 27u);
}

// However many there are, they stay lines, and the legend's symbols stay in their rows.
TEST(Curves, ManyAlongOneAnotherFitIntoTheLegend) {
  std::vector<Curve> curves;
  for (int i = 0; i < 6; ++i)
    curves.push_back({"c" + std::to_string(i), {{1, 4, 0}, {10, 40, 0}}, ""});
  const std::string script = script_of(kLogarithmic, curves);
  const std::regex item("with linespoints lw ([0-9.]+) ps ([0-9.]+) [^,]*title '");
  int titled = 0;
  for (std::sregex_iterator it(script.begin(), script.end(), item), end; it != end;
       ++it, ++titled) {
    EXPECT_LE(std::stod((*it)[1]), 6);
    EXPECT_LE(std::stod((*it)[2]), 1.1);
  }
  EXPECT_EQ(titled, 6);
  EXPECT_THAT(script, HasSubstr("$curve0 using 1:2 with linespoints lw 14 "));
}

TEST(Curves, BarsWhereSeedsDiffer) {
  const Curve mean{"mean", {{1, 4, 1}, {10, 40, 3}}, ""};
  EXPECT_THAT(script_of(kLogarithmic, {mean}), HasSubstr("using 1:2:3:4 with yerrorlines"));
  EXPECT_THAT(script_of(kLogarithmic, {mean}), HasSubstr("\n1 4 2 6\n"));
}

// A guide beside curves that do not rise would cross a corner of the picture.
TEST(Curves, AGuideNeedsACurveThatRisesLikeIt) {
  const Curve flat{"flat", {{8, 4, 0}, {64, 4, 0}}, ""}, square{"square", {{8, 64, 0}, {64, 4096, 0}}, ""};
  CurvesPicture picture = kLogarithmic;
  picture.slopes = {1, 2};
  EXPECT_THAT(script_of(picture, {flat}), Not(HasSubstr("slope")));
  const std::string both = script_of(picture, {flat, square});
  EXPECT_THAT(both, HasSubstr("title 'slope 2'"));
  EXPECT_THAT(both, Not(HasSubstr("title 'slope 1'")));
}

TEST(Curves, OneFormOfNumbersPerAxis) {
  const std::string two = log_tics('x', 8, 1000, TicForm::kPowers);
  EXPECT_THAT(two, HasSubstr("'10^{1}' 1e1, '' 2e1 1, "));
  EXPECT_THAT(two, HasSubstr("'10^{2}' 1e2"));
  EXPECT_THAT(two, HasSubstr("'10^{3}' 1e3)"));
  EXPECT_THAT(two, testing::StartsWith("set xtics ('' 8e0 1, '' 9e0 1, "));
  EXPECT_EQ(log_tics('y', 1, 1.1e10, TicForm::kPowers),
            "set ytics ('10^{0}' 1e0, '' 1e1 1, '10^{2}' 1e2, '' 1e3 1, '10^{4}' 1e4, '' 1e5 1, "
            "'10^{6}' 1e6, '' 1e7 1, '10^{8}' 1e8, '' 1e9 1, '10^{10}' 1e10)\n");
  EXPECT_EQ(log_tics('x', 1.6, 12, TicForm::kPlain),
            "set xtics ('2' 2e0, '' 3e0 1, '' 4e0 1, '5' 5e0, '' 6e0 1, '' 7e0 1, '' 8e0 1, "
            "'' 9e0 1, '10' 1e1)\n");
  EXPECT_THAT(log_tics('x', 8, 30, TicForm::kPowers), HasSubstr("'2\u00b710^{1}' 2e1"));
  // On a short axis 1, 2 and 5 would name one place, or none.
  EXPECT_EQ(log_tics('x', 4.5, 8.9, TicForm::kPlain),
            "set xtics ('5' 5e0, '6' 6e0, '7' 7e0, '8' 8e0)\n");
}

// One form of numbers in a figure: powers on a short axis, too, where the other one needs them.
TEST(Curves, OneFormOfNumbersPerFigure) {
  const auto script = [](double most) {
    return script_of(kLogarithmic, {{"one", {{10, 50, 0}, {80, most, 0}}, ""}});
  };
  EXPECT_THAT(script(2e5), HasSubstr("'50' 5e1"));
  EXPECT_THAT(script(2e5), HasSubstr("'100000' 1e5"));
  EXPECT_THAT(script(2e5), Not(HasSubstr("10^")));
  EXPECT_THAT(script(2e6), HasSubstr("'5\u00b710^{1}' 5e1"));
  EXPECT_THAT(script(2e6), HasSubstr("'10^{6}' 1e6"));
  EXPECT_THAT(script(2e6), Not(HasSubstr("'50'")));
}

// What is drawn at a tic is what its label says: of a decade that begins anywhere.
TEST(Curves, TicsAreWhereTheirLabelsSay) {
  Figure figure;
  set_curves(figure, {"n", "events", true, true, {}},
             {{"one", {{12, 830, 0}, {100, 1e4, 0}, {1e5, 1e6, 0}}, ""}});
  const Drawings drawings = draw({figure});
  ASSERT_EQ(drawings.problem, "");
  // Pixels of the points and of the labels on the x axis: log10 is linear in them.
  const std::string& svg = drawings.svg.at(0);
  std::vector<double> points, labels;
  const std::regex mark("<use xlink:href='#gpPt6' transform='translate\\(([0-9.]+),");
  for (std::sregex_iterator it(svg.begin(), svg.end(), mark), end; it != end; ++it)
    points.push_back(std::stod((*it)[1]));
  ASSERT_GE(points.size(), 3u);
  const double decade = (points[2] - points[1]) / 3;
  const std::regex label(
      "translate\\(([0-9.]+),[0-9.]+\\)\" "
      "stroke=\"none\"[^>]*text-anchor=\"middle\">\\s*<text><tspan[^>]*>10</"
      "tspan><tspan[^>]*>([0-9]+)<");
  std::size_t seen = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), label), end; it != end; ++it, ++seen) {
    const double power = std::stod((*it)[2]);
    EXPECT_NEAR(std::stod((*it)[1]), points[1] + (power - 2) * decade, 1.0) << power;
  }
  EXPECT_EQ(seen, 5u);
}

// A picture has a title and a description for screen readers, with its exponents.
TEST(Curves, APictureSaysItsTitleDescriptionAndCurves) {
  Figure figure;
  figure.title = "sorted_list: events";
  figure.caption = "Counts of a & b < c.";
  Curve fitted{"a_b", {{1, 4, 0}, {10, 40, 0}, {100, 400, 0}}, "n^{1.000}"};
  fitted.line = fit_power(fitted.points);
  set_curves(figure, {"n", "events", true, true, {}, {}, "one panel"},
             {fitted, {"c's", {{1, 9, 0}}, ""}});
  const Drawings drawings = draw({figure});
  ASSERT_EQ(drawings.problem, "");
  const std::string& svg = drawings.svg.at(0);
  EXPECT_THAT(svg, HasSubstr("<svg role=\"img\""));
  EXPECT_THAT(svg, HasSubstr("<title>sorted_list: events: one panel</title>\n<desc>Counts of a "
                             "&amp; b &lt; c.</desc>"));
  EXPECT_THAT(svg, HasSubstr("<title>a_b, fitted</title>"));
  EXPECT_THAT(svg, HasSubstr("<title>a_b: n^1.000</title>"));
  EXPECT_THAT(svg, HasSubstr("<title>c's</title>"));
  EXPECT_THAT(svg, Not(HasSubstr("nuplot</title>")));
  EXPECT_THAT(svg, Not(HasSubstr("GNUPLOT")));
}

TEST(Curves, LegendsOfLongEntriesHaveOneColumn) {
  const std::string word = "twenty characters!!!";
  EXPECT_EQ(legend_below({word, word, word}, 640).rows, 2);
  EXPECT_EQ(legend_below({word + word, word, word}, 640).rows, 3);
}

TEST(Curves, FormulasAreMarkedUp) {
  EXPECT_EQ(formula("Theta(n^(3/2)) of a_b."), "\u0398(n^{3/2}) of a\\_b.");
  EXPECT_EQ(formula("a + b ln^2 n"), "a + b ln^{2} n");
  EXPECT_EQ(formula("n^2."), "n^{2}.");
}

TEST(Curves, ConstantsAndExactPowersSaySo) {
  const std::vector<FitPoint> flat{{1, 4, 0}, {10, 4, 0}, {100, 4, 0}},
      square{{1, 3, 0}, {10, 300, 0}, {100, 30000, 0}};
  EXPECT_EQ(power_value(fit_power(flat).value(), "n"), "constant");
  EXPECT_EQ(power_value(fit_power(square).value(), "n"), "n^{2.000}");
  EXPECT_TRUE(is_exact(fit_power(square).value()));
}

}  // namespace curves_test
}  // namespace kinex::lab
