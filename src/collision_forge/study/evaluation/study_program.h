#pragma once

#include <string>
#include <vector>

namespace forge {

/// Runs a program of python/collision_forge_study, e.g. "charts.py", with /usr/bin/python3 and
/// waits for its end; its output goes to stderr. Throws std::runtime_error if the program cannot be
/// started or its exit code is not 0.
void runStudyProgram(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace forge
