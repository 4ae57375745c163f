// SPDX-License-Identifier: GPL-3.0-or-later
// Style and script of the pages of results.
#ifndef KINEX_EXPERIMENTS_LAB_HTML_STYLE_H
#define KINEX_EXPERIMENTS_LAB_HTML_STYLE_H

namespace kinex::lab {

extern const char* const kPageStyle;
// Tables with the class "data" can be filtered and sorted; their rows "more" fold.
extern const char* const kPageScript;

}  // namespace kinex::lab

#endif
