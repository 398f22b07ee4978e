#pragma once

namespace forge {

/// How nodes handle scenes that arrive over topics (config/live.yaml).
struct LiveOptions {
  /// s, ROS clock; requests on a newest scene that is older are rejected (kStaleScene).
  double max_scene_age = 0.0;
  double kept_for = 0.0;  ///< s, ROS clock, before the newest scene: how long scenes are kept for
                          ///< requests by stamp
  /// s, wall clock; longest wait of a request for a scene whose stamp is still to come.
  double wait_for = 0.0;
  double answer_within = 0.0;  ///< s, wall clock; time limit of a call to another node

  /// Returns the largest age, in s, of an attack's t0 when the attack arrives. Nodes that use an
  /// attack keep poses and frames for this long.
  double maxAttackAge() const { return kept_for + wait_for; }
};

}  // namespace forge
