#pragma once

namespace forge {

/// config/live.yaml, where each number's unit and source stand.
struct LiveOptions {
  double max_scene_age = 0.0;
  double kept_for = 0.0;
  double wait_for = 0.0;
  double answer_within = 0.0;

  /// s of the newest poses and frames that an attack may need: its now may be as old when the
  /// answer comes.
  double answerAge() const { return kept_for + wait_for; }
};

}  // namespace forge
