#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

/// A request as one line of a list, without a line end:
/// {"scene":"scene-0001","now":100.5,"type":"ltap","tta":4,"attacker":null,"seed":0}
/// now: seconds on the scene's clock (nuScenes: timestamp * 1e-6); tta: seconds from now; attacker:
/// an agent's id, null for any. What is not as by default (writeControls(); believable and limits
/// as in `defaults`) has a field more.
std::string requestLine(const SceneRequest& request, const CrashDefinition& defaults = {});

/// The opposite of requestLine(), in mode history. Every field must be there, but for those of
/// writeControls(), once, and no other. What counts as the crash is `crash`, unless the line says
/// otherwise. Throws JsonLineError, naming `where`.
SceneRequest readRequestLine(const std::string& where, const std::string& line,
                             const CrashDefinition& crash = {});

/// Reads a whole list. `scenes`: the names there are; `crash`: as readRequestLine(). Throws
/// JsonLineError naming file, line, field and value for a file that cannot be read or holds no
/// request, a malformed line, and a scene that is not in `scenes`; InputError as readInputLine().
std::vector<SceneRequest> readRequests(const std::string& path, const std::set<std::string>& scenes,
                                       const InputLimits& limits,
                                       const CrashDefinition& crash = {});

/// The number of the requests and a fingerprint of their lines, to tell lists apart.
std::string fingerprintOf(const std::vector<SceneRequest>& requests);

/// Writes a list; `defaults` as requestLine(). Throws as AsideFile does.
void writeRequests(const std::string& path, const std::vector<SceneRequest>& requests,
                   const CrashDefinition& defaults = {});

}  // namespace forge
