#pragma once

namespace forge {

// Generated from the files in page/ by page/embed.py during the build.

/// The page up to its data, including the style.
extern const char* const kPageHead;
/// The program and the end of the page.
extern const char* const kPageFoot;

}  // namespace forge
