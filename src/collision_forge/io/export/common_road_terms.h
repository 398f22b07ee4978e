#pragma once

#include <set>
#include <string>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// Returns a number as xs:decimal, which has no exponent, with at most six decimals. Throws
/// std::invalid_argument for a number that is not finite.
std::string decimal(double value);

/// Returns CommonRoad's type of a static obstacle; "" for classes that are dynamic obstacles even
/// at rest, because no static type describes them.
const char* staticTypeOf(AgentClass agent_class);

/// Returns CommonRoad's type of a dynamic obstacle.
const char* dynamicTypeOf(AgentClass agent_class);

/// Returns CommonRoad's name of a traffic light's colour.
const char* nameOf(LightColor color);

/// Returns the direction in which a lane turns, as a traffic light names it.
const char* directionOf(const Lane& lane);

/// Returns the benchmark id, as "SGP_SingaporeOnenorthScene0061-1_17_T-1": map, line of the
/// scenario, trajectory prediction.
std::string benchmarkOf(const CrashRecord& record);

/// Returns facts for which the format has no field, as "KEY=VALUE; KEY=VALUE".
std::string sourceOf(const CrashRecord& record);

/// Returns the scenario tags.
std::set<std::string> tagsOf(const CrashRecord& record);

}  // namespace forge
