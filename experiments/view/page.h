// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `kinex view`: one file with its style, its scripts and its data, and no network. Long data
// are packed.
#ifndef KINEX_EXPERIMENTS_VIEW_PAGE_H
#define KINEX_EXPERIMENTS_VIEW_PAGE_H

#include <string>
#include <string_view>

namespace kinex::view {

// `data`: JSON, the result of page_data (page_data.h).
std::string view_page(const std::string& title, std::string_view data);

// The files of page/, made part of the program by embed.cmake.
extern const std::string_view kViewFrame;   // page.html
extern const std::string_view kViewStyle;   // style.css
extern const std::string_view kViewScript;  // all of *.js but the next, in order
extern const std::string_view kViewUnpack;  // unpack.js

}  // namespace kinex::view

#endif
