#include "collision_forge/io/scenarios/request_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/scenarios/request_fields.h"

namespace forge {

std::string requestLine(const SceneRequest& request, const CrashDefinition& defaults) {
  JsonLineWriter writer;
  writer.beginObject();
  if (!request.scene.empty()) {
    writer.text("scene", request.scene);
    writer.number("now", request.now);
  }
  writer.text("type", toString(request.request.type));
  writer.number("tta", request.request.tta);
  if (request.request.attacker) {
    writer.text("attacker", *request.request.attacker);
  } else {
    writer.null("attacker");
  }
  writer.count("seed", request.request.seed);
  writeControls(writer, request.request, &defaults);
  if (!request.name.empty()) writer.text("name", request.name);
  writer.endObject();
  return writer.line();
}

SceneRequest readRequestLine(const std::string& where, const std::string& line,
                             const CrashDefinition& crash) {
  const JsonLine parsed(where, line);
  JsonObject object = parsed.root();
  SceneRequest request;
  request.scene = object.text("scene");
  request.now = object.number("now");
  const auto type = collisionTypeFromString(object.text("type"));
  if (!type) object.fail("type", "is not a collision type");
  request.request.type = *type;
  request.request.tta = object.number("tta");
  request.request.attacker = object.textOrNull("attacker");
  request.request.seed = object.count("seed");
  request.request.crash = crash;
  readControls(object, request.request, true);
  if (object.has("name")) request.name = object.text("name");
  object.finish();
  return request;
}

std::vector<SceneRequest> readRequests(const std::string& path, const std::set<std::string>& scenes,
                                       const InputLimits& limits, const CrashDefinition& crash) {
  std::ifstream file(path);
  if (!file) throw JsonLineError(path + ": cannot be opened: " + std::strerror(errno));
  std::vector<SceneRequest> requests;
  const auto where = [&] { return path + ": line " + std::to_string(requests.size() + 1); };
  for (std::string line; readInputLine(file, line, where(), limits);) {
    const SceneRequest request = readRequestLine(where(), line, crash);
    if (scenes.count(request.scene) == 0) {
      throw JsonLineError(where() + ": field scene = \"" + request.scene +
                          "\" is not a scene of the data");
    }
    requests.push_back(request);
  }
  if (file.bad()) throw JsonLineError(path + ": cannot be read: " + std::strerror(errno));
  if (requests.empty()) throw JsonLineError(path + ": has no request");
  return requests;
}

std::string fingerprintOf(const std::vector<SceneRequest>& requests) {
  std::string hash;
  for (const SceneRequest& request : requests) {
    hash = fingerprint(requestLine(request) + "\n", hash);
  }
  return std::to_string(requests.size()) + " of fingerprint " + hash;
}

void writeRequests(const std::string& path, const std::vector<SceneRequest>& requests,
                   const CrashDefinition& defaults) {
  AsideFile file(path);
  for (const SceneRequest& request : requests) {
    file.stream() << requestLine(request, defaults) << '\n';
  }
  file.commit();
}

}  // namespace forge
