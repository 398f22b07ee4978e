#pragma once

namespace forge {

// Generated from the files in page/ by page/embed.py during the build.

/// HTML from the start of the page up to its data (PageFile), including style and security policy.
extern const char* const kPageHead;
/// HTML after the data: the program (JavaScript) and the end of the page.
extern const char* const kPageFoot;

}  // namespace forge
