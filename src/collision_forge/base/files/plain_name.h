#pragma once

#include <string>

namespace forge {

/// Why a name that was read cannot be the name of a file, or a part of it, as a message that quotes
/// it; empty where it can. It can when it is not empty, "." or "..", has no '/' and no control
/// characters, and is not longer than 200 bytes.
std::string nameFault(const std::string& name);

/// FOLDER/NAME. Throws std::runtime_error for a name with a nameFault(): no name that was read
/// leads out of the folder.
std::string pathIn(const std::string& folder, const std::string& name);

}  // namespace forge
