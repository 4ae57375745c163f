// SPDX-License-Identifier: GPL-3.0-or-later
// Base 91: bytes as text that is safe inside a <script> element, 16 characters for 13 bytes (base 64
// takes 17 and a third). Two characters hold 13 bits, or 14 where the lower 13 are small. The reader is
// page/unpack.js.
// Source: J. Henke, basE91, 2006; here the digits are the characters from "!" to "~" without "&",
// "<" and "\".
#ifndef KINEX_EXPERIMENTS_VIEW_BASE91_H
#define KINEX_EXPERIMENTS_VIEW_BASE91_H

#include <string>
#include <string_view>

namespace kinex::view {

std::string base91(std::string_view bytes);

}  // namespace kinex::view

#endif
