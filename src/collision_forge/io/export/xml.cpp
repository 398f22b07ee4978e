#include "collision_forge/io/export/xml.h"

#include <charconv>
#include <cmath>
#include <ctime>
#include <sstream>
#include <stdexcept>

namespace forge {

pugi::xml_node addElement(pugi::xml_node parent, const char* name,
                          std::initializer_list<std::pair<const char*, std::string>> attributes) {
  pugi::xml_node element = parent.append_child(name);
  for (const auto& [key, value] : attributes) element.append_attribute(key) = value.c_str();
  return element;
}

std::string xmlNumber(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a number for XML is not finite");
  char text[32];
  const auto result = std::to_chars(text, text + sizeof(text), value);
  return std::string(text, result.ptr);
}

std::string xmlDate(double seconds) {
  const auto whole = static_cast<std::time_t>(std::floor(seconds));
  std::tm parts{};
  gmtime_r(&whole, &parts);
  char text[32];
  return std::string(text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%S", &parts));
}

std::string xmlText(const pugi::xml_document& document) {
  std::ostringstream stream;
  document.save(stream, "  ", pugi::format_default, pugi::encoding_utf8);
  return stream.str();
}

}  // namespace forge
