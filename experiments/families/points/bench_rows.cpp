// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/bench_rows.h"

#include <string>

namespace kinex::families {

namespace {

constexpr std::string_view kRandom = "uniform-square";

}  // namespace

lab::BenchRow random_row(std::string_view structure, int degree, int n, std::uint64_t events) {
  lab::BenchRow row = lab::speed_row(structure, kRandom, degree, n);
  row.events = events;
  return row;
}

lab::BenchRow plans_row(std::string_view structure, int plans, int scale) {
  lab::BenchRow row = lab::speed_row(structure, "walks", 1, lab::scaled_size(308, scale));
  row.parameters.m = lab::scaled_size(plans, scale);
  return row;
}

void add_common_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale,
                     int most) {
  for (const int size : {10, 30}) {
    for (const int degree : {1, 3}) rows.push_back(random_row(structure, degree, size));
  }
  for (const char* workload : {"lattice", "meet", "grid"}) {
    for (const int size : {30, lab::scaled_size(400, scale), lab::scaled_size(2000, scale)}) {
      if (size <= most) rows.push_back(lab::speed_row(structure, workload, 1, size));
    }
  }
}

lab::BenchRow plane_row(std::string_view benchmark, std::string_view structure, int degree, int n,
                        int rounds) {
  lab::BenchRow row = lab::speed_row(structure, kRandom, degree, n, {"exact"});
  row.benchmark = benchmark;
  row.parameters.dimension = 2;
  row.rounds = rounds;
  return row;
}

void add_scheduling_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale,
                         int n, const std::array<int, 3>& slow) {
  for (const char* arithmetic : {"exact", "double", "sturm"}) {
    const bool is_slow = arithmetic == std::string_view("sturm");
    for (const int degree : {1, 2, 3}) {
      const int size = is_slow ? slow[static_cast<std::size_t>(degree - 1)] : n;
      rows.push_back(plane_row("scheduling", structure, degree, lab::scaled_size(size, scale),
                               is_slow ? 1 : 3));
      rows.back().arithmetics = {arithmetic};
    }
  }
}

lab::BenchRow queue_row(std::string_view structure, int degree, int n, int scale) {
  lab::BenchRow row = plane_row("queue", structure, degree, lab::scaled_size(n, scale), 5);
  row.events = 30000 / static_cast<std::uint64_t>(scale);
  return row;
}

void add_fall_through_rows(std::vector<lab::BenchRow>& rows, std::string_view structure,
                           int scale) {
  const auto add = [&](std::string_view workload, int n) {
    rows.push_back(plane_row("fall_through", structure, 1, lab::scaled_size(n, scale), 5));
    rows.back().workload = workload;
  };
  add(kRandom, 500);
  add("grid", 400);
  add("near-one-point", 60);
}

void add_requires_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale) {
  const auto add = [&](std::string_view table, int n, int rounds) {
    rows.push_back(plane_row(table, structure, 1, lab::scaled_size(n, scale), rounds));
    rows.back().parameters.dimension = 0;
  };
  for (const int n : {2500, 10000, 40000}) add("requires_moving", n, 3);
  add("requires_padded", 1500, 7);
  add("requires_unread", 1500, 7);
}

lab::BenchRow shared_row(const std::vector<std::string_view>& structures, int scale) {
  lab::BenchRow row =
      plane_row("requires_shared", structures.back(), 1, lab::scaled_size(2000, scale), 3);
  for (const std::string_view structure : structures) {
    row.maintain.push_back({std::string(structure), std::string(structure), {}});
  }
  return row;
}

std::vector<lab::BenchRow> point_bench_rows(int scale) {
  std::vector<lab::BenchRow> rows{plane_row("loading", "", 1, lab::scaled_size(100000, scale), 9),
                                  plane_row("loading", "", 1, lab::scaled_size(308, scale), 9)};
  rows[1].workload = "walks";
  rows[1].parameters.m = lab::scaled_size(369, scale);
  return rows;
}

}  // namespace kinex::families
