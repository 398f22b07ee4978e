#include "collision_forge/planner_test/report/junit_file.h"

#include <pugixml.hpp>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

/// A suite that counts its cases while they are added.
class Suite {
 public:
  Suite(pugi::xml_node parent, const std::string& name)
      : name_(name), node_(addElement(parent, "testsuite", {{"name", name}})) {}

  pugi::xml_node add(const std::string& name, double seconds) {
    ++cases_;
    return addElement(node_, "testcase",
                      {{"classname", name_}, {"name", name}, {"time", xmlNumber(seconds)}});
  }

  void fail(pugi::xml_node entry, const std::string& message) {
    ++failures_;
    addElement(entry, "failure", {{"message", message}});
  }

  void skip(pugi::xml_node entry, const std::string& message) {
    ++skipped_;
    addElement(entry, "skipped", {{"message", message}});
  }

  void finish() {
    node_.append_attribute("tests") = cases_;
    node_.append_attribute("failures") = failures_;
    node_.append_attribute("skipped") = skipped_;
  }

 private:
  std::string name_;
  pugi::xml_node node_;
  int cases_ = 0;
  int failures_ = 0;
  int skipped_ = 0;
};

std::string describe(const PlannerRow& row) {
  const RolloutOutcome& outcome = row.outcome;
  if (outcome.failure != PlannerFailure::kNone) {
    return std::string(toString(outcome.failure)) + ": " + outcome.failure_message;
  }
  if (!outcome.contact) return "no contact";
  return "contact with " + outcome.contact->other_id + " at " +
         numberText(outcome.contact->impact_speed) + " m/s" +
         (row.is_fair ? ", avoidable" : ", not avoidable") +
         (outcome.contact->at_fault ? ", ego at fault" : "");
}

void addCase(const PlannerTestResult& result, const std::string& name,
             const std::vector<Criterion>& criteria, Suite& suite) {
  if (!result.isTested()) {
    suite.skip(suite.add(result.name, 0.0), result.status + ": " + result.message);
    return;
  }
  for (const PlannerRow& row : result.rows) {
    if (rowName(row) != name) continue;
    const pugi::xml_node entry = suite.add(result.name, row.outcome.duration);
    const std::string criterion = failedBy(criteria, row);
    if (!criterion.empty()) suite.fail(entry, criterion + ": " + describe(row));
  }
}

}  // namespace

std::string junitText(const std::vector<PlannerTestResult>& results,
                      const std::vector<Criterion>& criteria,
                      const std::vector<CriterionVerdict>& verdicts,
                      const std::vector<std::string>& rows) {
  pugi::xml_document document;
  const pugi::xml_node root = addElement(document, "testsuites");
  for (const std::string& name : rows) {
    Suite suite(root, name);
    for (const PlannerTestResult& result : results) addCase(result, name, criteria, suite);
    for (const CriterionVerdict& verdict : verdicts) {
      if (verdict.row != name) continue;
      const pugi::xml_node entry = suite.add("fails if " + verdict.criterion.text, 0.0);
      if (!verdict.is_failed) continue;
      suite.fail(entry, verdict.criterion.measure + " = " + numberText(verdict.value));
    }
    suite.finish();
  }
  return xmlText(document);
}

}  // namespace forge
