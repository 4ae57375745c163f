// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, a copy of this one: a measurement that finds memory as it is at the start,
// and not as a long series of other measurements has left it.
#ifndef KINEX_EXPERIMENTS_LAB_OWN_PROCESS_H
#define KINEX_EXPERIMENTS_LAB_OWN_PROCESS_H

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>

namespace kinex::lab {

// Fills `result`, of a child process, by `work`, whose changes to all other memory are lost. Throws
// std::runtime_error with the message of what `work` throws there, or if the child ends by a signal or
// cannot be started. One thread at a time; what is buffered in streams of C is written before.
void fill_in_own_process(std::span<std::byte> result, const std::function<void()>& work);

// The result of `work()`. It may point to what lives before the call, but to nothing that `work` makes.
template <class Work>
auto in_own_process(const Work& work) {
  using Result = decltype(work());
  static_assert(std::is_trivially_copyable_v<Result>);
  Result result{};
  fill_in_own_process(std::as_writable_bytes(std::span(&result, 1)), [&] { result = work(); });
  return result;
}

}  // namespace kinex::lab

#endif
