# SPDX-License-Identifier: GPL-3.0-or-later
"""What counts as the output that a page shows."""
from page_blocks import agrees

SAME = [("a b\n c", "a  b c\n"), ("a ... c", "a b c"), ("a ... c", "a c"), ("...", ""), ("... c", "x c"),
        ("a\n...", "a b\nd"), ("1.5*x (y)", "1.5*x (y)"), ("", "\n")]
OTHER = [("a ... c", "a b d"), ("a b", "a b c"), ("a.*b", "a x b"), ("a... c", "a b c"), ("a", ""), ("", "a"),
         ("... c", "c d")]
wrong = [pair for pair in SAME if not agrees(*pair)] + [pair for pair in OTHER if agrees(*pair)]
if wrong:
    raise SystemExit(f"judged wrongly: {wrong}")
print(f"{len(SAME) + len(OTHER)} outputs judged")
