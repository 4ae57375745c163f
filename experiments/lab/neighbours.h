// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours: a law of growth against the laws that are easily taken for it, each with two numbers:
// those with more or fewer logarithms, and, for a law with a logarithm, a power.
#ifndef KINEX_EXPERIMENTS_LAB_NEIGHBOURS_H
#define KINEX_EXPERIMENTS_LAB_NEIGHBOURS_H

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/fit.h"
#include "experiments/lab/table.h"

namespace kinex::lab {

// n^power log^logs n.
struct Law {
  double power = 0;
  int logs = 0;

  double at(double n) const;
  // "x^1.5 log^2 x" for x; "x^0" is left out.
  std::string text(const std::string& x) const;
};

struct Neighbours {
  struct Rival {
    std::string law;
    Fit fit;
    // Chi squared more than that of the claimed law, where every point has a standard error; else
    // the scatter in units of that of the claimed law.
    double lead = 0;
    BetterFit better = BetterFit::kNeither;  // kFirst: the claimed law
    double scatter = 0;
    bool faster = false;  // it grows faster than the claimed law: with more logarithms, or a larger power
  };
  std::string law;
  Fit claimed;         // a + b law(n)
  double scatter = 0;  // root of the mean of the squared relative residuals
  bool weighted = false;
  std::vector<Rival> rivals;  // more logarithms later, the power last

  bool beats_all() const;
  bool is_beaten() const;  // by some rival
  // The claimed law, or one that is no faster, beats all that are faster: the test of a bound.
  bool beats_faster() const;
};

// The rivals of n^p log^k n are the others of n^p log^0 .. log^3 n that grow, and a n^b if k > 0
// (n^p is a power itself). With standard errors fits are weighted and compared as in better_fit;
// without, relative residuals are minimised, and a scatter twice as large is worse. nullopt for
// fewer than four points, or points that are not positive.
std::optional<Neighbours> neighbours_of(std::span<const FitPoint> points, const Law& law,
                                        const std::string& x);

// Of a rival, for programs: "beaten", "better" (kSecond) or "undecided".
std::string_view outcome_word(BetterFit better);

// "beats n log n by 41 chi squared", "scatters 3.1 times less than n log n", "cannot be told from
// n log n (by 2 chi squared)", "is beaten by n log n by 12 chi squared".
std::string rival_text(const Neighbours& neighbours, const Neighbours::Rival& rival);
// "consistent with n" and the texts of all rivals; "is not the best of its neighbours" if it is
// beaten.
std::string neighbours_text(const Neighbours& neighbours);

// A row for each law: what it leaves, and how the rivals stand against the claimed one.
struct FittedLaws {
  std::string family;     // of the counts
  std::size_t sizes = 0;  // that are fitted
  Neighbours neighbours;
};
Table neighbours_table(const std::vector<FittedLaws>& fitted);

}  // namespace kinex::lab

#endif
