#include "collision_forge/planner_test/report/deflated_text.h"

#include <zlib.h>

#include <stdexcept>
#include <vector>

namespace forge {
namespace {

std::string base64(const std::vector<Bytef>& bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_padding = i + k > bytes.size();
      text += is_padding ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
    }
  }
  return text;
}

}  // namespace

std::string deflatedText(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::vector<Bytef> packed(size);
  const auto* bytes = reinterpret_cast<const Bytef*>(text.data());
  if (compress2(packed.data(), &size, bytes, text.size(), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("cannot compress " + std::to_string(text.size()) + " bytes");
  }
  packed.resize(size);
  return base64(packed);
}

}  // namespace forge
