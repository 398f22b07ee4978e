#include "collision_forge/planner_test/planners/planner_worker.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kLongestText = 1 << 20;  // bytes

std::vector<std::string> commandOf(const TorchscriptFileOptions& options) {
  const std::string program = packageProgram("planner_worker");
  if (options.file.empty()) {
    throw PlannerFileError(
        "torchscript.file of planners.yaml is empty, or "
        "models.non_commercial_weights in models.yaml is false");
  }
  if (!fs::exists(program)) {
    throw PlannerFileError(options.file +
                           ": learned models are not available in this build: program " + program +
                           " does not exist; install libtorch and build again");
  }
  const double longest = std::max(options.timeout, options.start_timeout);
  return {program, options.file, options.device, std::to_string(longest), options.contract->name};
}

}  // namespace

std::string workerKey(const TorchscriptFileOptions& options) {
  std::error_code absent;
  const auto written = fs::last_write_time(options.file, absent).time_since_epoch().count();
  return std::string(options.contract->name) + ' ' + options.device + ' ' +
         std::to_string(options.timeout) + ' ' + std::to_string(options.start_timeout) + ' ' +
         std::to_string(written) + ' ' + options.file;
}

PlannerWorker::PlannerWorker(const TorchscriptFileOptions& options)
    : options_(options), key_(workerKey(options)), process_(commandOf(options)) {
  std::vector<float> none;
  try {
    process_.setTimeout(options_.start_timeout);
    receiveAnswer(none);
  } catch (const std::exception& error) {
    throw PlannerFileError(options_.file + ": " + error.what());
  }
}

void PlannerWorker::begin() {
  std::vector<float> none;
  ask(kRequestBegin, {}, none);
}

std::vector<float> PlannerWorker::plan(const std::vector<float>& inputs) {
  std::vector<float> poses(options_.contract->output.count());
  ask(kRequestPlan, inputs, poses);
  return poses;
}

void PlannerWorker::ask(char request, const std::vector<float>& numbers,
                        std::vector<float>& answer) {
  is_usable_ = false;
  try {
    process_.setTimeout(options_.timeout);
    process_.send(&request, 1);
    process_.send(numbers.data(), numbers.size() * sizeof(float));
    receiveAnswer(answer);
  } catch (const WorkerTimeout& error) {
    throw WorkerTimeout(options_.file + ": " + error.what());
  } catch (const std::exception& error) {
    throw std::runtime_error(options_.file + ": " + error.what());
  }
  is_usable_ = true;
}

void PlannerWorker::receiveAnswer(std::vector<float>& numbers) {
  char kind = 0;
  process_.receive(&kind, 1);
  if (kind == kAnswerOk) {
    process_.receive(numbers.data(), numbers.size() * sizeof(float));
    return;
  }
  std::uint32_t size = 0;
  process_.receive(&size, sizeof(size));
  if (kind != kAnswerError || size > kLongestText)
    throw std::runtime_error("its response has an unknown format");
  std::string text(size, '\0');
  process_.receive(text.data(), size);
  throw std::runtime_error(text);
}

}  // namespace forge
