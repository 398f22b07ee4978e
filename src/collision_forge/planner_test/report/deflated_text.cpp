#include "collision_forge/planner_test/report/deflated_text.h"

#include <zlib.h>

#include <stdexcept>

namespace forge {

std::string base64Text(const std::string& bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_padding = i + k > bytes.size();
      text += is_padding ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
    }
  }
  return text;
}

std::string deflatedText(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string packed(size, '\0');
  const auto* bytes = reinterpret_cast<const Bytef*>(text.data());
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes, text.size(),
                Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("cannot compress " + std::to_string(text.size()) + " bytes");
  }
  packed.resize(size);
  return base64Text(packed);
}

}  // namespace forge
