// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/order/floor.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "experiments/families/points/floor.h"
#include "experiments/families/points/floor_timetable.h"
#include "experiments/lab/cpu_clock.h"

namespace kinex::families {

namespace floors {

namespace {

// Certificate i: objects at places i and i + 1 are in order.
template <std::size_t D>
lab::BenchRun run_list(const Scene& scene, double start, double end, std::uint64_t most) {
  const std::vector<Coordinate<D>> x = coordinates<D>(scene, 0);
  std::vector<std::uint32_t> order(x.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return value(x[a], start) < value(x[b], start);
  });
  const auto failure = [&](std::uint32_t i, double now, double limit, bool fresh) {
    const Coordinate<D> gap = x[order[i + 1]] - x[order[i]];
    return fresh ? first_root(without_root(gap, now), now, limit) : first_root(gap, now, limit);
  };
  const auto places = static_cast<std::uint32_t>(x.size() - 1);
  FloorTimetable times(places, start, end);
  for (std::uint32_t i = 0; i < places; ++i) times.renew(i, start, false, failure);

  std::uint64_t events = 0;
  const double begin = lab::cpu_seconds();
  std::uint32_t i = 0;
  for (double now = start; (most == 0 || events < most) && times.next(i, now, failure);) {
    ++events;
    std::swap(order[i], order[i + 1]);
    times.renew(i, now, true, failure);
    if (i > 0) times.renew(i - 1, now, false, failure);
    if (i + 1 < places) times.renew(i + 1, now, false, failure);
    times.note(3, now);
  }
  return {.seconds = lab::cpu_seconds() - begin, .events = events};
}

}  // namespace

}  // namespace floors

lab::BenchRun run_list_floor(const Scene& scene, std::uint64_t most) {
  return floors::run_of_degree(scene, [&]<std::size_t D>(double start, double end) {
    return floors::run_list<D>(scene, start, end, most);
  });
}

}  // namespace kinex::families
