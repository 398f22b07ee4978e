#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <utility>

namespace forge {

/// Appends an element with attributes (pairs of name and value), in the given order, to the
/// children of `parent`, after the existing ones, and returns it.
pugi::xml_node addElement(
    pugi::xml_node parent, const char* name,
    std::initializer_list<std::pair<const char*, std::string>> attributes = {});

/// Returns the shortest text that reads back as the same double. Throws std::invalid_argument for a
/// number that is not finite.
std::string xmlNumber(double value);

/// Returns seconds since 1970, rounded down, as xs:dateTime in UTC, "2018-08-01T15:26:43".
std::string xmlDate(double seconds);

/// Returns the document as UTF-8 text, indented by two spaces per level. The function puts the
/// declaration <?xml version="1.0"?> first, unless the document has a declaration of its own.
std::string xmlText(const pugi::xml_document& document);

}  // namespace forge
