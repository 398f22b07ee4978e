#pragma once

#include <collision_forge/GenerateCollision.h>

#include <string>
#include <variant>
#include <vector>

#include "collision_forge/attack/search/request_phrase.h"

namespace forge {

/// A request, and the scenario or cell of a catalogue from which it was made.
struct NamedRequest {
  std::string name;  ///< CatalogueCell::name, for a text PhraseReading::name; "": no catalogue
  CollisionRequest request;
};

/// Returns the requests that a message means, in the order in which the caller tries them until one
/// has an attack: the cells that `message.name` names (namedCells()), at least one, else exactly
/// one, from `message.text` or, if both are empty, from the other fields. Other fields of the
/// message override the fields that a cell or text sets. `vocabulary`: catalogue and words for
/// names and texts. For a text, sets `understood` and `not_understood` of `response`; the rest of
/// it stays. `crash`: definition for all requests, as in fromMessage(). Returns kInvalidInput for
/// an unknown name or one that the catalogue lists as not expressible, for a text that readPhrase()
/// rejects, and if more than one of name, text and collision_type is set; else the status of
/// fromMessage() or withFieldsOf(). Throws nothing for invalid messages.
std::variant<std::vector<NamedRequest>, Status> requestsOf(
    const collision_forge::GenerateCollision::Request& message, const RequestVocabulary& vocabulary,
    const CrashDefinition& crash, collision_forge::GenerateCollision::Response& response);

}  // namespace forge
