// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the build uses AddressSanitizer, which slows everything down many times: large tests are
// smaller there, and run at full size in the ordinary build.
#ifndef KINEX_TESTS_SANITIZED_H
#define KINEX_TESTS_SANITIZED_H

namespace kinex::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

// How many of `count` seeds or trials run: all, or under sanitizers a quarter of them, at least one.
template <class Count>
constexpr Count fewer(Count count) {
  return kSanitized ? (count + 3) / 4 : count;
}

// What is expected of the scenes that run: `count` of all, or under sanitizers an eighth, for few scenes vary.
template <class Count>
constexpr Count seen_in_fewer(Count count) {
  return kSanitized ? count / 8 : count;
}

}  // namespace kinex::test

#endif
