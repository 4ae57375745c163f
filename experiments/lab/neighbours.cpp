// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/neighbours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinex::lab {

namespace {

constexpr std::size_t kFewestPoints = 4;
constexpr int kMostLogs = 3;
constexpr double kTwice = 2;         // so much more scatter is worse
constexpr double kNoScatter = 1e-9;  // relative: below that a law is met exactly

double relative_scatter(const Fit& fit) {
  double squares = 0;
  for (const double residual : fit.residuals) squares += residual * residual;
  return std::max(kNoScatter, std::sqrt(squares / static_cast<double>(fit.residuals.size())));
}

BetterFit better_scatter(double ratio) {
  return ratio >= kTwice       ? BetterFit::kFirst
         : ratio <= 1 / kTwice ? BetterFit::kSecond
                               : BetterFit::kNeither;
}

// The better one of two fits; `scatters` of them, which decide where there are no standard errors.
BetterFit compare(bool weighted, const Fit& first, double first_scatter, const Fit& second,
                  double second_scatter) {
  return weighted ? better_fit(first, second) : better_scatter(second_scatter / first_scatter);
}

std::string margin_text(const Neighbours& neighbours, double lead) {
  const std::string number =
      std::fabs(lead) < 100 ? fmt::format("{:.2g}", lead) : fmt::format("{:.0f}", lead);
  return number + (neighbours.weighted ? " chi squared" : " times the scatter");
}

std::string left_text(bool weighted, const Fit& fit, double scatter) {
  if (weighted) return fmt::format("chi^2 = {:.1f} on {}", fit.chi_square, fit.degrees);
  return fmt::format("scatter {:.2g} %", 100 * scatter);
}

std::string standing_text(const Neighbours& neighbours, const Neighbours::Rival& rival) {
  const char* const standing = rival.better == BetterFit::kFirst    ? "beaten"
                               : rival.better == BetterFit::kSecond ? "fits better"
                                                                    : "cannot be excluded";
  const int places = std::fabs(rival.lead) < 100 ? 1 : 0;
  if (neighbours.weighted) return fmt::format("{}: {:+.{}f} chi^2", standing, rival.lead, places);
  return fmt::format("{}: {:.{}f} times the scatter", standing, rival.lead, places);
}

}  // namespace

double Law::at(double n) const { return std::pow(n, power) * std::pow(std::log(n), logs); }

std::string Law::text(const std::string& x) const {
  std::string text;
  if (power != 0) text = power == 1 ? x : fmt::format("{}^{:.4g}", x, power);
  if (logs == 0) return text.empty() ? "1" : text;
  return text + (text.empty() ? "" : " ") + (logs == 1 ? "log " : fmt::format("log^{} ", logs)) + x;
}

bool Neighbours::beats_all() const {
  return std::all_of(rivals.begin(), rivals.end(),
                     [](const Rival& rival) { return rival.better == BetterFit::kFirst; });
}

bool Neighbours::is_beaten() const {
  return std::any_of(rivals.begin(), rivals.end(),
                     [](const Rival& rival) { return rival.better == BetterFit::kSecond; });
}

bool Neighbours::beats_faster() const {
  return std::all_of(rivals.begin(), rivals.end(), [this](const Rival& fast) {
    if (!fast.faster || fast.better == BetterFit::kFirst) return true;
    return std::any_of(rivals.begin(), rivals.end(), [&](const Rival& slow) {
      return !slow.faster && compare(weighted, slow.fit, slow.scatter, fast.fit, fast.scatter) ==
                                 BetterFit::kFirst;
    });
  });
}

std::optional<Neighbours> neighbours_of(std::span<const FitPoint> points, const Law& law,
                                        const std::string& x) {
  if (points.size() < kFewestPoints) return std::nullopt;
  std::vector<FitPoint> fitted(points.begin(), points.end());
  const bool weighted = std::all_of(fitted.begin(), fitted.end(),
                                    [](const FitPoint& point) { return point.error > 0; });
  for (FitPoint& point : fitted) {
    if (!(point.n > 1) || !(point.count > 0)) return std::nullopt;
    if (!weighted) point.error = point.count;
  }
  const auto fit_of = [&](const Law& one) {
    return fit_law("a + b " + one.text(x), fitted, [one](double n) { return one.at(n); });
  };
  std::optional<Fit> claimed = fit_of(law);
  if (!claimed) return std::nullopt;
  Neighbours result;
  result.law = law.text(x);
  result.claimed = *std::move(claimed);
  result.scatter = relative_scatter(result.claimed);
  result.weighted = weighted;
  const auto add = [&](std::string name, std::optional<Fit> fit, bool faster) {
    if (!fit) return;
    Neighbours::Rival rival;
    rival.faster = faster;
    rival.law = std::move(name);
    rival.fit = *std::move(fit);
    rival.scatter = relative_scatter(rival.fit);
    rival.lead = weighted ? rival.fit.chi_square - result.claimed.chi_square
                          : rival.scatter / result.scatter;
    rival.better = compare(weighted, result.claimed, result.scatter, rival.fit, rival.scatter);
    result.rivals.push_back(std::move(rival));
  };
  for (int logs = 0; logs <= kMostLogs; ++logs) {
    const Law rival{law.power, logs};
    if (logs == law.logs || (logs == 0 && law.power == 0)) continue;
    add(rival.text(x), fit_of(rival), logs > law.logs);
  }
  if (law.logs > 0) {
    std::optional<Fit> power = fit_power(fitted);
    const bool faster = power && power->b > law.power;
    add("a power of " + x, std::move(power), faster);
  }
  return result;
}

std::string rival_text(const Neighbours& neighbours, const Neighbours::Rival& rival) {
  const std::string margin = margin_text(neighbours, rival.lead);
  switch (rival.better) {
    case BetterFit::kFirst:
      return neighbours.weighted ? "beats " + rival.law + " by " + margin
                                 : "beats " + rival.law + ", which has " + margin;
    case BetterFit::kNeither:
      return "cannot be told from " + rival.law + " (" + margin + ")";
    case BetterFit::kSecond:
      break;
  }
  return neighbours.weighted
             ? "is beaten by " + rival.law + " by " + margin_text(neighbours, -rival.lead)
             : "is beaten by " + rival.law + ", which has " + margin;
}

std::string neighbours_text(const Neighbours& neighbours) {
  std::string text = neighbours.is_beaten() ? neighbours.law + " is not the best of its neighbours"
                                            : "consistent with " + neighbours.law;
  for (std::size_t i = 0; i < neighbours.rivals.size(); ++i) {
    text += (i == 0 ? ": it " : "; ") + rival_text(neighbours, neighbours.rivals[i]);
  }
  return text;
}

std::string_view outcome_word(BetterFit better) {
  return better == BetterFit::kFirst    ? "beaten"
         : better == BetterFit::kSecond ? "better"
                                        : "undecided";
}

Table neighbours_table(const std::vector<FittedLaws>& fitted) {
  Table table;
  table.title = "Laws against their neighbours";
  table.header = {"family", "sizes", "law", "left by a + b law", "against the claimed law"};
  table.verdict = table.header.back();
  table.note =
      "Each law has two numbers, a + b law, and a power a n^b; they are fitted to the same means. "
      "With standard errors a neighbour is beaten if it leaves 9 more of chi^2 (times what the better "
      "one leaves for each degree of freedom, if that is more than 1); without, if it scatters twice "
      "as much.";
  for (const FittedLaws& one : fitted) {
    const Neighbours& neighbours = one.neighbours;
    const auto add = [&](const std::string& law, std::string left, std::string standing) {
      table.rows.push_back(
          {one.family, std::to_string(one.sizes), law, std::move(left), std::move(standing)});
    };
    add(neighbours.law, left_text(neighbours.weighted, neighbours.claimed, neighbours.scatter),
        neighbours.is_beaten() ? "claimed" : "claimed; the counts are consistent with it");
    for (const Neighbours::Rival& rival : neighbours.rivals) {
      add(rival.law, left_text(neighbours.weighted, rival.fit, rival.scatter),
          standing_text(neighbours, rival));
    }
  }
  return table;
}

}  // namespace kinex::lab
