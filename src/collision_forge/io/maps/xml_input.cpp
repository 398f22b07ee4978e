#include "collision_forge/io/maps/xml_input.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "collision_forge/io/maps/map_error.h"

namespace forge {
namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kWhiteSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1);
}

}  // namespace

std::string rootOf(const std::string& path) {
  constexpr std::size_t kBytes = 1 << 16;
  std::string start(kBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) throw MapError(path + ": cannot be opened: " + std::strerror(errno));
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (file.bad()) throw MapError(path + ": cannot be read: " + std::strerror(errno));
  start.resize(static_cast<std::size_t>(file.gcount()));
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string_view text = start;
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    text.remove_prefix(kByteOrderMark.size());
  }
  const std::string_view first = trimmed(text).substr(0, 1);
  if (first == kJsonRoot) return kJsonRoot;
  if (first != "<") return "";
  pugi::xml_document document;
  document.load_buffer(start.data(), start.size());  // keeps the elements before an error
  const std::string name = document.document_element().name();
  return name.empty() ? "" : "<" + name + ">";
}

void loadXml(const std::string& path, pugi::xml_document& document) {
  const pugi::xml_parse_result result = document.load_file(path.c_str());
  if (result) return;
  const bool is_read =
      result.status != pugi::status_file_not_found && result.status != pugi::status_io_error;
  throw MapError(
      path + ": " +
      (is_read ? "invalid XML at byte " + std::to_string(result.offset) : "cannot be read") + ": " +
      result.description());
}

std::optional<double> finiteNumber(std::string_view text) {
  text = trimmed(text);
  if (text.substr(0, 1) == "+" && text.substr(1, 1) != "-") text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string describedElement(const pugi::xml_node& element) {
  const std::string name = element.name();
  if (const pugi::xml_attribute id = element.attribute("id")) {
    return "<" + name + " id=\"" + id.value() + "\">";
  }
  return "<" + name + "> at byte " + std::to_string(element.offset_debug());
}

double numberIn(const pugi::xml_node& element, const char* attribute, const std::string& path) {
  const pugi::xml_attribute found = element.attribute(attribute);
  const std::string where = path + ": " + describedElement(element) + ": attribute " + attribute;
  if (!found) throw MapError(where + " is missing");
  if (const auto value = finiteNumber(found.value())) return *value;
  throw MapError(where + " is \"" + found.value() + "\", not a finite number");
}

}  // namespace forge
