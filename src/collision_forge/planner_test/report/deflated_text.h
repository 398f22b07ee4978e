#pragma once

#include <string>

namespace forge {

/// The text as zlib's deflate packs it (RFC 1950), in base64. Browsers unpack it by
/// DecompressionStream("deflate"). Throws std::runtime_error where memory is short.
std::string deflatedText(const std::string& text);

}  // namespace forge
