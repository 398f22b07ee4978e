#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/files/worker_process.h"
#include "collision_forge/planner_test/planners/planner_contract.h"
#include "collision_forge/planner_test/worker/planner_module.h"

namespace forge {
namespace {

/// Returns false if the caller has closed the stream.
bool receive(void* data, std::size_t size) {
  char* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t received = recv(kWorkerStream, bytes, size, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    bytes += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

/// Ignores a closed stream; the next receive() detects it.
void send(const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::send(kWorkerStream, bytes, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

void answer(const std::vector<float>& numbers) {
  send(&kAnswerOk, 1);
  send(numbers.data(), numbers.size() * sizeof(float));
}

void answerError(const std::string& text) {
  const auto size = static_cast<std::uint32_t>(text.size());
  send(&kAnswerError, 1);
  send(&size, sizeof(size));
  send(text.data(), text.size());
}

/// Runs `call` and sends its result or error; returns whether it succeeded. If the call exceeds
/// `longest` seconds, ends the process, because the caller no longer waits.
template <typename Call>
bool answerWith(const Call& call, double longest) {
  constexpr double kGrace = 2.0;  // s; a caller that still waits reports the timeout first
  alarm(static_cast<unsigned>(std::ceil(longest + kGrace)));
  bool is_done = false;
  try {
    answer(call());
    is_done = true;
  } catch (const std::exception& error) {
    answerError(error.what());
  }
  alarm(0);
  return is_done;
}

int serve(const std::string& file, const std::string& device, double longest,
          const ModelContract& contract) {
  std::optional<PlannerModule> module;
  const auto load = [&] {
    module.emplace(file, device, contract);
    return std::vector<float>();
  };
  if (!answerWith(load, longest)) return EXIT_FAILURE;
  std::vector<float> inputs(contract.numbers());
  char request = 0;
  while (receive(&request, 1)) {
    if (request == kRequestPlan && !receive(inputs.data(), inputs.size() * sizeof(float))) {
      break;
    }
    const auto obey = [&] {
      if (request == kRequestPlan) return module->plan(inputs);
      module->begin();
      return std::vector<float>();
    };
    answerWith(obey, longest);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace forge

/// Runs a model file for PlannerWorker, which starts it.
int main(int argc, char** argv) {
  const std::string contract = argc == 5 ? argv[4] : "";
  const bool is_traffic = contract == forge::kTrafficContract.name;
  if (!is_traffic && contract != forge::kPlannerContract.name) {
    std::cerr << "usage: planner_worker FILE DEVICE SECONDS planner|traffic, with a stream as file "
                 "descriptor "
              << forge::kWorkerStream << "; forge starts it\n";
    return 2;
  }
  return forge::serve(argv[1], argv[2], std::atof(argv[3]),
                      is_traffic ? forge::kTrafficContract : forge::kPlannerContract);
}
