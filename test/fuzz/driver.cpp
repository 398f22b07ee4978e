#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/reading.h"
#include "fuzz/targets.h"

/// The entry point of libFuzzer; FUZZ_TARGET is the function of one target.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  try {
    forge::FUZZ_TARGET(input);
  } catch (const forge::BareMessage& bare) {
    // A message may quote the input, and libFuzzer learns these words from the code that compares
    // them.
    if (input.find(bare.words) == std::string::npos) throw;
  }
  return 0;
}
