#pragma once

#include <cstdint>
#include <string>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// t0 is 100 s. On a road that leads east (y from -4 to 4) the ego drives at 5 m/s along y = 0 and
/// is at (10, 0) at 102.04 s, when the attacker, "veh", at 10 m/s from behind, touches its rear. A
/// parked truck, "truck", stands at (10, 8). After the contact both stay in place: the view has no
/// PostCrashMotion, and an animation continues for 0.5 s.
ScenarioView sampleView();

/// As sampleView(); after the contact both brake and stand about 1 s later, 3.7 m farther along x.
ScenarioView sampleCrash();

/// Small pictures with colours that are easy to tell apart.
DrawingOptions sampleOptions();

/// 0x00RRGGBB.
std::uint32_t packedColor(const Color& color);

/// Returns a path in the temporary folder, different for every test.
std::string temporaryPath(const std::string& name);

bool exists(const std::string& path);
std::string readBytes(const std::string& path);

}  // namespace forge
