#pragma once

#include <string>
#include <vector>

namespace forge {

/// Runs a program of python/collision_forge_study, as "charts.py", with Debian's Python and waits
/// for its end; its output goes to stderr. Throws std::runtime_error if the program cannot be
/// started or ends with an exit code other than 0.
void runStudyProgram(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace forge
