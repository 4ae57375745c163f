// SPDX-License-Identifier: GPL-3.0-or-later
// Whether this is built with AddressSanitizer, under which everything takes many times as long:
// large tests are smaller there. They run at full size in the ordinary build.
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

}  // namespace kinex::test

#endif
