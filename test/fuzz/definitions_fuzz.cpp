#include <sstream>
#include <vector>

#include "collision_forge/ros/bags/message_fields.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

/// Returns the paths: one per line, after its kind (n, t or s).
std::vector<FieldPath> pathsIn(const std::string& text) {
  std::vector<FieldPath> paths;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 3) continue;
    const FieldKind kind = line[0] == 't'   ? FieldKind::kTime
                           : line[0] == 's' ? FieldKind::kText
                                            : FieldKind::kNumber;
    paths.push_back({line.substr(2), kind});
  }
  return paths;
}

}  // namespace

/// Input: the definition of a foreign message type, paths of its fields, and a message of it, as
/// parts "definition", "paths" and "bytes".
bool fuzzDefinitions(const std::string& input) {
  Parts parts = partsOf(input);
  return isTaken("", [&] {
    const MessageFields fields("zoo_msgs/Cage", parts["definition"], pathsIn(parts["paths"]));
    const std::string& bytes = parts["bytes"];
    fields.read(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  });
}

}  // namespace forge
