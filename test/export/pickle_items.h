#pragma once

#include <string>
#include <type_traits>

#include "collision_forge/export/pickle_writer.h"

namespace forge {

/// The items of a dict as their bytes.
inline std::string itemsOf(const PickleWriter& writer) {
  const std::string dict = writer.dict();
  return dict.substr(2, dict.size() - 3);
}

/// An item of a dict as its bytes.
template <class... Arguments>
std::string item(void (PickleWriter::*write)(const std::string&, Arguments...),
                 const std::string& key, std::decay_t<Arguments>... arguments) {
  PickleWriter writer;
  (writer.*write)(key, arguments...);
  return itemsOf(writer);
}

inline std::string textItem(const std::string& key, const std::string& value) {
  return item(&PickleWriter::text, key, value);
}

}  // namespace forge
