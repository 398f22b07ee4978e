#include "collision_forge/trials/planner_result_lines.h"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace forge {

PlannerTestResult testCase(const PlannerCases& cases, std::size_t index,
                           const std::function<PlannerTestResult(const PlannerCase&)>& test) {
  PlannerCase one;
  try {
    one = cases.at(index);
  } catch (const std::exception& error) {
    one.name = cases.names()[index];
    return untested(one, kUnreadable, error.what());
  }
  return test(one);
}

PlannerResultLines::PlannerResultLines(const std::string& path,
                                       const ResumableFile::Options& options,
                                       const std::vector<std::string>& names)
    : file_(path, options), names_(names) {
  if (file_.isComplete()) {
    std::ifstream complete(path);
    for (std::string line; std::getline(complete, line);) keep(path, line);
  } else {
    file_.resume([&](const std::string& where, const std::string& line) { keep(where, line); });
  }
  first_ = results_.size();
}

void PlannerResultLines::take(const std::string& line) {
  file_.append(line);
  keep("a new result", line);
}

void PlannerResultLines::complete() {
  if (!file_.isComplete()) file_.complete();
}

void PlannerResultLines::keep(const std::string& where, const std::string& line) {
  PlannerTestResult result = readPlannerResultLine(where, line);
  if (results_.size() >= names_.size() || result.name != names_[results_.size()]) {
    throw std::runtime_error(where + ": name = \"" + result.name + "\" is not expected there");
  }
  results_.push_back(std::move(result));
}

}  // namespace forge
