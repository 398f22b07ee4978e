#pragma once

#include <string>

namespace forge {

/// Returns the bytes in base64 (RFC 4648) with padding, without line breaks.
std::string base64Text(const std::string& bytes);

/// Returns the text compressed by zlib's deflate (RFC 1950), in base64 without line breaks.
/// Browsers decompress it with DecompressionStream("deflate"). Throws std::runtime_error if memory
/// runs out.
std::string deflatedText(const std::string& text);

}  // namespace forge
