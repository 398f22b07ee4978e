#include "collision_forge/io/scenarios/request_fields.h"

#include <limits>

#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

/// Sets a field that is a word. `may_be_null`: null leaves the request unchanged. Fails, giving
/// `problem`, for an unknown word.
void readWord(JsonObject& object, const char* key, bool may_be_null, const char* problem,
              CollisionRequest& request) {
  const auto word = may_be_null ? object.textOrNull(key) : object.text(key);
  if (word && !setRequestWord(key, *word, request)) object.fail(key, problem);
}

std::optional<Range> readRange(JsonObject& object, const char* key) {
  auto range = object.objectOrNull(key);
  if (!range) return std::nullopt;
  const Range read{range->number("min"), range->number("max")};
  range->finish();
  return read;
}

/// Writes the word; without a value, writes null or, with `leaves_out`, nothing.
template <typename Value>
void writeWord(JsonLineWriter& writer, const char* key, const std::optional<Value>& value,
               bool leaves_out) {
  if (value) {
    writer.text(key, toString(*value));
  } else if (!leaves_out) {
    writer.null(key);
  }
}

void writeRange(JsonLineWriter& writer, const char* key, const std::optional<Range>& range,
                bool leaves_out) {
  if (range) {
    writer.beginObject(key);
    writer.number("min", range->min);
    writer.number("max", range->max);
    writer.endObject();
  } else if (!leaves_out) {
    writer.null(key);
  }
}

/// Writes the fields that files lack unless the request sets them.
void writeConditions(JsonLineWriter& writer, const CollisionRequest& request) {
  if (request.turning != Turning::kAttacker) writer.text("turning", toString(request.turning));
  writeWord(writer, "from_side", request.from_side, true);
  writeWord(writer, "hidden_by", request.hidden_by, true);
  if (request.queue) writer.flag("queue", true);
  for (const RangeControl& control : kRangeControls) {
    writeRange(writer, control.name, request.*control.asked, true);
  }
}

void readConditions(JsonObject& object, CollisionRequest& request) {
  if (object.has("turning")) {
    readWord(object, "turning", false, "is neither attacker nor ego", request);
  }
  if (object.has("from_side")) {
    readWord(object, "from_side", true, "is neither left nor right", request);
  }
  if (object.has("hidden_by")) {
    readWord(object, "hidden_by", true, "is neither parked_vehicle nor leader", request);
  }
  if (object.has("queue")) request.queue = object.flag("queue");
  for (const RangeControl& control : kRangeControls) {
    if (object.has(control.name)) request.*control.asked = readRange(object, control.name);
  }
}

}  // namespace

void writeControls(JsonLineWriter& writer, const CollisionRequest& request,
                   const CrashDefinition* defaults) {
  const bool leaves_out = defaults != nullptr;
  const CrashDefinition& crash = request.crash;
  if (!leaves_out || request.choice != AttackerChoice::kAny) {
    writer.text("choice", toString(request.choice));
  }
  if (!leaves_out || crash.believable != defaults->believable) {
    writer.flag("believable", crash.believable);
  }
  if (!leaves_out || crash.limits != defaults->limits) {
    writer.text("limits", toString(crash.limits));
  }
  writeWord(writer, "attacker_class", request.attacker_class, leaves_out);
  writeWord(writer, "manoeuvre", request.manoeuvre, leaves_out);
  writeWord(writer, "ego_side", request.ego_side, leaves_out);
  writeRange(writer, "impact_speed", request.impact_speed, leaves_out);
  writeRange(writer, "overlap", request.overlap, leaves_out);
  writeConditions(writer, request);
  if (!leaves_out || request.alternatives != 1) {
    writer.count("alternatives", static_cast<std::uint64_t>(request.alternatives));
  }
}

void readControls(JsonObject& object, CollisionRequest& request, bool may_lack) {
  const auto has = [&](const char* key) { return !may_lack || object.has(key); };
  if (has("choice")) {
    readWord(object, "choice", false, "is not one of any, existing, new", request);
  }
  if (has("believable")) request.crash.believable = object.flag("believable");
  if (has("limits")) {
    readWord(object, "limits", false, "is neither drivable nor strict", request);
  }
  if (has("attacker_class")) {
    readWord(object, "attacker_class", true, "is not an agent class", request);
  }
  if (has("manoeuvre")) {
    readWord(object, "manoeuvre", true, "is not a manoeuvre", request);
  }
  if (has("ego_side")) readWord(object, "ego_side", true, "is not a side of a box", request);
  if (has("impact_speed")) request.impact_speed = readRange(object, "impact_speed");
  if (has("overlap")) request.overlap = readRange(object, "overlap");
  readConditions(object, request);
  if (has("alternatives")) {
    const std::uint64_t count = object.count("alternatives");
    if (count > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
      object.fail("alternatives", "is too large");
    }
    request.alternatives = static_cast<int>(count);
  }
}

}  // namespace forge
