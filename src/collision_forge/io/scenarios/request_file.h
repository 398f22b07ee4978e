#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

/// Returns a request as one line of a list, without a line end:
/// {"scene":"scene-0001","now":100.5,"type":"ltap","tta":4,"attacker":null,"seed":0};
/// docs/scenarios.md lists all fields. now: t0, s on the scene's clock (nuScenes: timestamp *
/// 1e-6); tta: s from t0; attacker: agent id, null for any. Constraints that differ from the
/// defaults add fields (writeControls(); believable and limits are compared with `defaults`), and a
/// name of a catalogue the field `name`. Without a scene (""), `scene` and `now` are left out; a
/// list needs them.
std::string requestLine(const SceneRequest& request, const CrashDefinition& defaults = {});

/// Parses a line of requestLine(), mode history. Each field must be present exactly once, except
/// `name` and the fields of writeControls(), which are optional; unknown fields are errors. `crash`
/// gives the crash definition, which the line may override. Throws JsonLineError, naming `where`.
SceneRequest readRequestLine(const std::string& where, const std::string& line,
                             const CrashDefinition& crash = {});

/// Reads a request list: each line is one request, so empty lines and comments are errors.
/// `scenes`: names of the existing scenes; `crash` as in readRequestLine(). Throws JsonLineError
/// naming file, line, field and value for a file that cannot be read or has no request, a malformed
/// line, and a scene not in `scenes`; InputError as readInputLine(). Returns the requests in the
/// order of the file.
std::vector<SceneRequest> readRequests(const std::string& path, const std::set<std::string>& scenes,
                                       const InputLimits& limits,
                                       const CrashDefinition& crash = {});

/// Returns a text with the number of requests and the fingerprint() of their lines in order, "10 of
/// fingerprint HASH", to compare lists; without requests HASH is "". Lists have different texts if
/// they differ in a field of requestLine() (with its default `defaults`), also `seed` and `name`,
/// or in their order. The mode and fields of the crash definition other than `believable` and
/// `limits` do not count.
std::string fingerprintOf(const std::vector<SceneRequest>& requests);

/// Writes a request list; `defaults` as in requestLine(). Throws as AsideFile.
void writeRequests(const std::string& path, const std::vector<SceneRequest>& requests,
                   const CrashDefinition& defaults = {});

}  // namespace forge
