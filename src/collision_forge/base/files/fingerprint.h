#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace forge {

/// Where FNV-1a begins.
constexpr std::uint64_t kHashBasis = 0xcbf29ce484222325u;

/// FNV-1a of 64 bits; `before` continues one.
std::uint64_t hashOf(std::string_view text, std::uint64_t before = kHashBasis);

/// Mixes all bits (the finalizer of splitmix64), so that the upper ones depend on all.
std::uint64_t mixed(std::uint64_t bits);

/// hashOf() in hexadecimal, to tell whether texts are the same; `before` continues one.
std::string fingerprint(const std::string& text, const std::string& before = "");

}  // namespace forge
