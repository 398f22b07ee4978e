#include "collision_forge/study/training/mirrored_sample.h"

#include <initializer_list>

namespace forge {
namespace {

void negate(RowMatrix& rows, std::initializer_list<Eigen::Index> columns) {
  for (const Eigen::Index column : columns) rows.col(column) *= -1.0F;
}

AnchorFeatures mirroredAnchors(AnchorFeatures features) {
  negate(features.poses, {1, 3});
  negate(features.groups, {8, 9, 15, 16, 17, 18, 19, 20});  // lateral position, heading, bends
  const bool on_ways = features.arc_lengths.size() > 0;
  if (on_ways) {
    negate(features.anchors, {10, 11});
  } else {
    negate(features.anchors, {3, 5});
  }
  return features;
}

}  // namespace

Pose2 mirrored(const Pose2& pose) { return {pose.x, -pose.y, -pose.yaw}; }

SceneFeatures mirrored(SceneFeatures features) {
  negate(features.agents, {1, 3, 5});
  negate(features.lanes, {1, 3, 9, 10});
  features.lanes.col(9).swap(features.lanes.col(10));  // leftmost and rightmost
  features.ego[8] *= -1.0F;                            // turn rate
  return features;
}

TimedSample mirrored(TimedSample sample) {
  return {sample.tta, mirroredAnchors(std::move(sample.anchors)), mirrored(sample.ego)};
}

AttackSample mirrored(AttackSample attack) {
  attack.ego = mirrored(attack.ego);
  attack.offset = mirrored(attack.offset);
  for (CandidateNow& candidate : attack.candidates) candidate.pose = mirrored(candidate.pose);
  return attack;
}

}  // namespace forge
