#include "collision_forge/io/scenarios/request_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a request list.
bool fuzzRequests(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("requests.jsonl", input);
  return isTaken(path, [&] {
    const CrashDefinition& crash = configuration().crash;
    for (const SceneRequest& request :
         readRequests(path, {"scene-0001"}, configuration().input_limits, crash)) {
      const std::string line = requestLine(request, crash);
      requireSame(line, requestLine(readRequestLine(path, line, crash), crash));
    }
  });
}

}  // namespace forge
