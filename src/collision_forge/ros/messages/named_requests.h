#pragma once

#include <collision_forge/GenerateCollision.h>

#include <string>
#include <variant>
#include <vector>

#include "collision_forge/attack/search/request_phrase.h"

namespace forge {

/// A request, and the scenario or cell of a catalogue from which it was made; "" without one.
struct NamedRequest {
  std::string name;
  CollisionRequest request;
};

/// Returns the requests that a message means, in the order in which they are tried until one has an
/// attack: the cells of the scenario `name`, else one. For `text`, adds to `response` what was
/// understood and what was not. Returns INVALID_INPUT for an unknown or impossible name, for a text
/// that readPhrase() rejects, and for a name, a text and a type together; else as fromMessage().
std::variant<std::vector<NamedRequest>, Status> requestsOf(
    const collision_forge::GenerateCollision::Request& message, const RequestVocabulary& vocabulary,
    const CrashDefinition& crash, collision_forge::GenerateCollision::Response& response);

}  // namespace forge
