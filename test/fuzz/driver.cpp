#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/targets.h"

/// What libFuzzer calls; FUZZ_TARGET is the function of one target.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  forge::FUZZ_TARGET(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
