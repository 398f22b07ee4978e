#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <torch/cuda.h>

#include "collision_forge/planner_test/planners/planner_contract.h"
#include "planner_test/worker/script_files.h"

namespace forge {
namespace {

using testing::HasSubstr;

/// Returns the error for a file; empty if it is accepted.
std::string refusalOf(const TorchscriptOptions& options) {
  try {
    PlannerWorker worker(options);
    return "";
  } catch (const PlannerFileError& error) {
    return error.what();
  }
}

/// Expects a one-line error with the file's name and these words.
void expectRefusal(const TorchscriptOptions& options, const std::vector<std::string>& words) {
  const std::string refusal = refusalOf(options);
  EXPECT_THAT(refusal, testing::StartsWith(options.file + ": "));
  EXPECT_THAT(refusal, testing::Not(HasSubstr("\n")));
  for (const std::string& word : words) EXPECT_THAT(refusal, HasSubstr(word));
}

void expectRefusal(const std::string& body, const std::vector<std::string>& words,
                   const std::string& arguments = kContractArguments) {
  expectRefusal(ScriptFile(body, arguments).options(), words);
}

TEST(PlannerModule, AcceptsAValidFile) {
  EXPECT_EQ(refusalOf(ScriptFile(kConstantVelocity).options()), "");
}

TEST(PlannerModule, AcceptsFurtherInputsWithDefaults) {
  const std::string more = std::string(kContractArguments) + ", gain: float = 2.0";
  EXPECT_EQ(refusalOf(ScriptFile(kConstantVelocity, more).options()), "");
}

TEST(PlannerModule, RejectsAMissingFile) {
  const TemporaryFolder folder;
  expectRefusal(ScriptFile::optionsOf(folder.path() + "/nothing.pt"), {"cannot be read"});
}

TEST(PlannerModule, RejectsAFileThatIsNotTorchScript) {
  const TemporaryFolder folder;
  for (const std::string& content : {std::string(), std::string("PK\3\4 no archive")}) {
    expectRefusal(ScriptFile::optionsOf(folder.write("text.pt", content)),
                  {"is not a TorchScript file"});
  }
  expectRefusal(ScriptFile::optionsOf(folder.path()), {"is not a TorchScript file"});
}

TEST(PlannerModule, RejectsAModuleWithoutForward) {
  const TemporaryFolder folder;
  torch::jit::Module module("Planner");
  module.define("def drive(self, x):\n    return x\n");
  module.save(folder.path() + "/planner.pt");
  expectRefusal(ScriptFile::optionsOf(folder.path() + "/planner.pt"), {"has no forward()"});
}

TEST(PlannerModule, RejectsOtherInputsByName) {
  const std::string body = "    return torch.zeros([80, 3])\n";
  expectRefusal(body, {"no input route"},
                "self, ego_history, agents, agents_mask, lanes, lanes_mask");
  expectRefusal(body, {"input 3", "others", "agents_mask"},
                "self, ego_history, agents, others, lanes, lanes_mask, route");
  expectRefusal(body, {"input route", "int", "Tensor"},
                "self, ego_history, agents, agents_mask, lanes, lanes_mask, route: int");
  expectRefusal(body, {"unknown input", "goal"}, std::string(kContractArguments) + ", goal");
}

TEST(PlannerModule, RejectsAnOutputOfAnotherShape) {
  expectRefusal("    return torch.zeros([80, 2])\n", {"output", "[80, 2]", "[80, 3]"});
  expectRefusal("    return torch.zeros([1, 80, 3])\n", {"output", "[1, 80, 3]", "[80, 3]"});
}

TEST(PlannerModule, RejectsANonFiniteOutput) {
  expectRefusal("    return torch.zeros([80, 3]) / 0.0\n", {"output", "not finite"});
  expectRefusal("    return torch.zeros([80, 3]) + agents.sum() / agents_mask.sum()\n",
                {"output", "not finite", "no agents or lanes around the ego"});
}

TEST(PlannerModule, RejectsAFileThatNeverFinishesLoading) {
  const ScriptFile file(
      "    i = 0\n"
      "    while bool(ego_history[-1, 3] < 5.0):\n"
      "        i += 1\n"
      "    return torch.zeros([80, 3])\n");
  TorchscriptOptions options = file.options();
  options.start_timeout = 4.0;
  expectRefusal(options, {"no response within 4"});
}

TEST(PlannerModule, ResetsStateAndRandomNumbersInEveryRollout) {
  const ScriptFile file(
      "    self.count += 1.0\n"
      "    return torch.rand([80, 3]) + self.count\n");
  PlannerWorker worker(file.options());
  const std::vector<float> inputs(kContractNumbers);
  const auto rollout = [&] {
    worker.begin();
    const auto first = worker.plan(inputs);
    return std::pair(first, worker.plan(inputs));
  };
  const auto before = rollout();
  EXPECT_GT(before.second[0], before.first[0] - 1.0);
  EXPECT_NE(before.first, before.second);
  EXPECT_EQ(rollout(), before);
}

}  // namespace
}  // namespace forge
