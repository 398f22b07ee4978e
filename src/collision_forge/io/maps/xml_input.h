#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace forge {

/// The result of rootOf() for a JSON object.
inline constexpr char kJsonRoot[] = "{";

/// Returns the root of a file from its first 64 KiB: kJsonRoot for a JSON object, "<NAME>" for XML
/// with the root element NAME, "" for other content. Throws MapError for a file that cannot be
/// read.
std::string rootOf(const std::string& path);

/// Reads the XML file `path`, without its comments, into `document`. Throws MapError for a file
/// that cannot be read, and for malformed XML, with the position in bytes.
void loadXml(const std::string& path, pugi::xml_document& document);

/// Returns the number in a text, which may have white space around it, a sign and an exponent;
/// nullopt if the text is not one finite number.
std::optional<double> finiteNumber(std::string_view text);

/// Returns "<NAME id="ID">", or "<NAME> at byte N" for an element without an id, for messages.
std::string describedElement(const pugi::xml_node& element);

/// Returns the number in an attribute. Throws MapError, naming path, element, attribute and value,
/// if the attribute is missing or is not a finite number. `path`: the file's, for the message.
double numberIn(const pugi::xml_node& element, const char* attribute, const std::string& path);

}  // namespace forge
