// SPDX-License-Identifier: GPL-3.0-or-later
// UTF-8: names come from tables and command lines as bytes; scenes are UTF-8.
#ifndef KINEX_EXPERIMENTS_FORMATS_UTF8_H
#define KINEX_EXPERIMENTS_FORMATS_UTF8_H

#include <string_view>

namespace kinex {

// True if `text` is well-formed UTF-8 (RFC 3629: no surrogates, nothing longer than needed).
bool is_utf8(std::string_view text);

}  // namespace kinex

#endif
