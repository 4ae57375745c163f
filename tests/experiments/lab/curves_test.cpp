// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of curves: what no picture may hide.
#include "experiments/lab/curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kinex::lab {
namespace {

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
  EXPECT_THAT(script, HasSubstr("$curve0 using 1:2 with linespoints lw 6 "));
  EXPECT_THAT(script, HasSubstr("$curve1 using 1:2 with linespoints lw 1.5 "));
  EXPECT_THAT(script, HasSubstr("$curve2 using 1:2 with linespoints lw 1.5 "));
}

TEST(Curves, BarsWhereSeedsDiffer) {
  const Curve mean{"mean", {{1, 4, 1}, {10, 40, 3}}, ""};
  EXPECT_THAT(script_of(kLogarithmic, {mean}), HasSubstr("using 1:2:3:4 with yerrorlines"));
  EXPECT_THAT(script_of(kLogarithmic, {mean}), HasSubstr("\n1 4 2 6\n"));
}

TEST(Curves, OneFormOfNumbersPerAxis) {
  EXPECT_EQ(log_tics('x', 1, 1000), "set format x '10^{%L}'\nset xtics 1e1\n");
  EXPECT_EQ(log_tics('y', 1, 1e12), "set format y '10^{%L}'\nset ytics 1e2\n");
  EXPECT_EQ(log_tics('x', 1.6, 40), "set xtics ('2' 2, '5' 5, '10' 10, '20' 20)\n");
}

TEST(Curves, LegendsOfLongEntriesHaveOneColumn) {
  const std::string word = "twenty-five characters!!!";
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

}  // namespace
}  // namespace kinex::lab
