#pragma once

#include <cstdint>
#include <string>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// Now is 100 s. On a road that leads east (y from -4 to 4) the ego drives at 5 m/s along y = 0 and
/// is at (10, 0) at 102.04 s, when the attacker, "veh", at 10 m/s from behind, touches its rear. A
/// parked truck, "truck", stands at (10, 8). After the contact both stay where they are: the view
/// has no PostCrashMotion, and an animation of it goes on for 0.5 s.
ScenarioView sampleView();

/// After the contact both slide on and stand 1 s later, 3.875 m farther along x.
ScenarioView sampleCrash();

/// Small pictures with colours that are easy to tell apart.
DrawingOptions sampleOptions();

/// 0x00RRGGBB.
std::uint32_t packedColor(const Color& color);

/// A path in the folder for temporary files that differs for every test.
std::string temporaryPath(const std::string& name);

bool exists(const std::string& path);
std::string readBytes(const std::string& path);

}  // namespace forge
