// SPDX-License-Identifier: GPL-3.0-or-later
// The kinetic list of CGAL's packages for kinetic data structures (dropped in 2018), in floating point:
// CGAL::Kinetic::Sort. It is compiled against headers of these packages, which are no part of this
// project; measure.py does that.
//
// usage: list FILE END LAST
// FILE: "n degree", then for each point the coefficients of its motion, low degree first. LAST: the end of
// its simulator's time, END or later.
// Prints the number of events up to END, their CPU seconds, and the neighbours out of order at END.
#include <CGAL/Kinetic/Inexact_simulation_traits.h>
#include <CGAL/Kinetic/Insert_event.h>
#include <CGAL/Kinetic/Sort.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <vector>

// What the library of these packages defines, for headers that come without it.
namespace CGAL {
Log::State Log::state_;
namespace Kinetic {
namespace internal {
unsigned int zero_certificates__ = 0;
unsigned int function_degeneracies__ = 0;
unsigned int io_errors__ = 0;
unsigned int audit_failures__ = 0;
}  // namespace internal
}  // namespace Kinetic
}  // namespace CGAL

namespace {

double cpu_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  using Traits = CGAL::Kinetic::Inexact_simulation_traits;
  using Sort = CGAL::Kinetic::Sort<Traits>;
  using Point = Traits::Kinetic_kernel::Point_1;
  using Function = Traits::Kinetic_kernel::Motion_function;

  std::ifstream file(argc == 4 ? argv[1] : "");
  int n = 0, degree = 0;
  if (!(file >> n >> degree)) {
    std::fputs("usage: list FILE END LAST\n", stderr);
    return 2;
  }
  const double end = std::atof(argv[2]);
  Traits traits(0, std::atof(argv[3]));
  Sort sort(traits);
  Traits::Active_points_1_table* const table = traits.active_points_1_table_handle();
  table->set_is_editing(true);
  std::vector<double> coefficients(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i < n; ++i) {
    for (double& c : coefficients) file >> c;
    table->insert(Point(Function(coefficients.begin(), coefficients.end())));
  }
  table->set_is_editing(false);
  if (!file) {
    std::fprintf(stderr, "list: %s ends early\n", argv[1]);
    return 2;
  }
  Traits::Simulator* const simulator = traits.simulator_handle();
  const double begin = cpu_seconds();
  simulator->set_current_time(Traits::Simulator::Time(end));
  const double seconds = cpu_seconds() - begin;

  long out_of_order = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (auto it = sort.begin(); it != sort.end(); ++it) {
    const double x = table->at(it->object()).x()(end);
    if (x < last) ++out_of_order;
    last = x;
  }
  std::printf("%u %.6f %ld\n", simulator->current_event_number(), seconds, out_of_order);
  return 0;
}
