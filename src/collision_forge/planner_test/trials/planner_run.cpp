#include "collision_forge/planner_test/trials/planner_run.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

#include <stdexcept>
#include <utility>

namespace forge {
namespace {

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

}  // namespace

std::vector<PlannerTestResult> testCases(
    Run run, const PlannerCases& cases,
    const std::function<PlannerTestResult(const PlannerCase&)>& test) {
  std::vector<PlannerTestResult> results;
  run.items = "cases";
  run.count = cases.names().size();
  run.work = [&](std::size_t index) { return plannerResultLine(testCase(cases, index, test)); };
  run.take = [&](std::size_t index, const std::string& where, const std::string& line) {
    PlannerTestResult result = readPlannerResultLine(where, line);
    if (result.name != cases.names()[index]) {
      throw std::runtime_error(
          where + ": name = \"" + result.name +
          "\" is not the case of this line; delete the file, or choose another --out");
    }
    dropMotions(result);
    results.push_back(std::move(result));
  };
  carryOut(run);
  return results;
}

}  // namespace forge
