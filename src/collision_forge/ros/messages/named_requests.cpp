#include "collision_forge/ros/messages/named_requests.h"

#include <stdexcept>

#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

/// Returns the requests without the other fields of the message. Throws std::invalid_argument.
std::vector<NamedRequest> basesOf(const collision_forge::GenerateCollision::Request& message,
                                  const RequestVocabulary& vocabulary,
                                  collision_forge::GenerateCollision::Response& response) {
  std::vector<NamedRequest> bases;
  if (!message.text.empty()) {
    PhraseReading reading = readPhrase(message.text, vocabulary);
    response.understood = std::move(reading.understood);
    response.not_understood = std::move(reading.unknown);
    bases.push_back({reading.name, reading.request});
  } else {
    for (const CatalogueCell& cell : namedCells(vocabulary.catalogue, message.name)) {
      bases.push_back({cell.name, cell.request});
    }
  }
  return bases;
}

}  // namespace

std::variant<std::vector<NamedRequest>, Status> requestsOf(
    const collision_forge::GenerateCollision::Request& message, const RequestVocabulary& vocabulary,
    const CrashDefinition& crash, collision_forge::GenerateCollision::Response& response) {
  const collision_forge::CollisionRequest fields = requestIn(message);
  if (message.name.empty() && message.text.empty()) {
    const auto parsed = fromMessage(fields, crash);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    return std::vector<NamedRequest>{{"", std::get<CollisionRequest>(parsed)}};
  }
  if (!message.collision_type.empty() || (!message.name.empty() && !message.text.empty())) {
    return Status{StatusCode::kInvalidInput,
                  "collision_type = \"" + message.collision_type + "\", name = \"" + message.name +
                      "\" and text = \"" + message.text + "\": only one of the three can be set"};
  }
  try {
    std::vector<NamedRequest> requests = basesOf(message, vocabulary, response);
    for (NamedRequest& named : requests) {
      named.request.crash = crash;
      const auto whole = withFieldsOf(fields, named.request);
      if (const Status* refusal = std::get_if<Status>(&whole)) return *refusal;
      named.request = std::get<CollisionRequest>(whole);
    }
    return requests;
  } catch (const std::invalid_argument& error) {
    return Status{StatusCode::kInvalidInput, error.what()};
  }
}

}  // namespace forge
