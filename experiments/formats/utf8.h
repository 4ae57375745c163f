// SPDX-License-Identifier: GPL-3.0-or-later
// UTF-8: tables and command lines give names as bytes, while scenes must be UTF-8.
#ifndef KINEX_EXPERIMENTS_FORMATS_UTF8_H
#define KINEX_EXPERIMENTS_FORMATS_UTF8_H

#include <cstddef>
#include <string>
#include <string_view>

namespace kinex::formats {

// The first byte of `text` that is no part of a well-formed character, or its size. Cost: linear;
// ASCII goes by eight bytes.
std::size_t first_not_utf8(std::string_view text);

// True if `text` is well-formed UTF-8 (RFC 3629: no surrogates, no overlong forms).
bool is_utf8(std::string_view text);

// The text, for a file of JSON: as messages show it if it is not UTF-8.
std::string utf8_or_shown(const std::string& text);

// Of well-formed UTF-8: how many characters (code points) it has.
std::size_t characters(std::string_view text);

}  // namespace kinex::formats

#endif
