#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace forge {

/// Offset basis of 64-bit FNV-1a.
constexpr std::uint64_t kHashBasis = 0xcbf29ce484222325u;

/// Returns the 64-bit FNV-1a hash of `text`; pass an earlier hash as `before` to continue it.
std::uint64_t hashOf(std::string_view text, std::uint64_t before = kHashBasis);

/// Returns `bits` with all bits mixed (finalizer of splitmix64): each output bit depends on all.
std::uint64_t mixed(std::uint64_t bits);

/// Returns hashOf() as 16 hexadecimal digits, in lower case; pass an earlier fingerprint as
/// `before` to continue it, or "" to begin.
std::string fingerprint(const std::string& text, const std::string& before = "");

}  // namespace forge
