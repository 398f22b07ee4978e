#pragma once

#include <string>

namespace forge {

/// Returns why a name from input cannot be (part of) a file name, as a message that quotes the name
/// and gives the reason; "" if it can. A valid name is not empty, "." or "..", has no '/' and no
/// control characters, and at most 200 bytes.
std::string nameFault(const std::string& name);

/// Returns FOLDER/NAME. Throws std::runtime_error if nameFault() rejects the name, so that names
/// from input never lead out of the folder.
std::string pathIn(const std::string& folder, const std::string& name);

}  // namespace forge
