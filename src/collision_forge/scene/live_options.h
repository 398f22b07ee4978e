#pragma once

namespace forge {

/// config/live.yaml, where each number's unit and source stand.
struct LiveOptions {
  double max_scene_age = 0.0;
  double kept_for = 0.0;
  double wait_for = 0.0;
};

}  // namespace forge
