// SPDX-License-Identifier: GPL-3.0-or-later
// run_in_order: does independent pieces of work on several threads and delivers the results in
// order.
#ifndef KINEX_EXPERIMENTS_LAB_RUN_IN_ORDER_H
#define KINEX_EXPERIMENTS_LAB_RUN_IN_ORDER_H

#include <mpfr.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace kinex::lab {

template <class Result>
struct InOrder {
  std::vector<Result> finished;  // in the order of their indices
  bool interrupted = false;      // some are missing
};

// Calls work(i) for i in [0, count) from `jobs` threads; nullopt interrupts: no further work is
// started. on_result(i, result) is called in the order of i, one at a time, as soon as all before i
// are done. An exception of `work` or `on_result` is rethrown when all threads have ended.
template <class Result>
InOrder<Result> run_in_order(std::size_t count, int jobs,
                             const std::function<std::optional<Result>(std::size_t)>& work,
                             const std::function<void(std::size_t, const Result&)>& on_result) {
  InOrder<Result> result;
  std::mutex mutex;  // of all below
  std::vector<std::optional<Result>> waiting(count);
  std::size_t first_waiting = 0;
  std::exception_ptr trouble;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> interrupted{false};
  const auto hand_over = [&] {
    if (on_result) on_result(first_waiting, *waiting[first_waiting]);
    result.finished.push_back(std::move(*waiting[first_waiting]));
  };
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count && !interrupted; i = next++) {
        std::optional<Result> one = work(i);
        if (!one) {
          interrupted = true;
          return;
        }
        const std::lock_guard lock(mutex);
        waiting[i] = std::move(one);
        for (; first_waiting < count && waiting[first_waiting]; ++first_waiting) hand_over();
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!trouble) trouble = std::current_exception();
      interrupted = true;
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < jobs; ++k) {
    threads.emplace_back([&run] {
      run();
      mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // MPFR's cache of this thread
    });
  }
  run();
  for (std::thread& thread : threads) thread.join();
  if (trouble) std::rethrow_exception(trouble);
  for (; first_waiting < count; ++first_waiting) {  // what was finished after a gap
    if (waiting[first_waiting]) hand_over();
  }
  result.interrupted = interrupted;
  return result;
}

}  // namespace kinex::lab

#endif
