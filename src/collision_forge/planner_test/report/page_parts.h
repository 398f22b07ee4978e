#pragma once

namespace forge {

// Made of the files of page/ by page/embed.py when the library is built.

/// The page up to its data, with the style.
extern const char* const kPageHead;
/// The program, and the end of the page.
extern const char* const kPageFoot;

}  // namespace forge
