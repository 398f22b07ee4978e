#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <utility>

namespace forge {

/// Adds an element with attributes, in their order.
pugi::xml_node addElement(
    pugi::xml_node parent, const char* name,
    std::initializer_list<std::pair<const char*, std::string>> attributes = {});

/// The shortest text that reads back as the same number. Throws std::invalid_argument for one that
/// is not finite.
std::string xmlNumber(double value);

/// Seconds since 1970 as xs:dateTime in UTC, "2018-08-01T15:26:43".
std::string xmlDate(double seconds);

/// The document with its declaration, two spaces a level.
std::string xmlText(const pugi::xml_document& document);

}  // namespace forge
