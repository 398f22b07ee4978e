#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Returns the median length, width and height (m), each taken alone; the upper one of two. `sizes`
/// must not be empty.
Eigen::Vector3d medianSize(const std::vector<Eigen::Vector3d>& sizes);

/// Returns true if length or width of `size` differ from `median` by more than 1 m, so that the
/// smaller box misleads. Sizes: length, width, height, m.
bool isOtherSize(const Eigen::Vector3d& size, const Eigen::Vector3d& median);

/// Returns the warning about the agents `ids` with an isOtherSize() first size; `ids` must not be
/// empty.
std::string sizeWarning(const std::vector<std::string>& ids);

/// Returns the indices of the positions (m, at strictly ascending `times`, s; as many of both) that
/// jump, ascending; none for fewer than two positions.
/// - A step is impossible if it is longer than (v + 20 m/s) times its duration plus 1 m. v: the
///   speed that three quarters of the track's steps do not exceed, at most 20 m/s above their
///   median. The chain of stretches with most positions and without an impossible step between them
///   is kept; all other positions jump.
/// - A single position jumps if it is more than 2 m beside the line between its neighbours, would
///   need more than 20 m/s2 to get there, and each neighbour is not beside the line between the
///   other one and the next position beyond.
std::vector<std::size_t> jumpsOf(const std::vector<double>& times,
                                 const std::vector<Vector2>& positions);

/// Repairs defects of recordings, whatever their format, in place, before anything is computed from
/// them:
/// - removes ego poses and annotations that jump (jumpsOf()), and derives the velocities of these
///   agents again;
/// - removes agents whose middle is in the ego's box in at least 3, and at least 90 %, of their
///   frames: the ego among its own agents;
/// - gives agents of `options.categories` the category of nuScenes with the same class, and warns
///   of unknown categories, whose agents become static objects;
/// - gives every agent its median size in all frames: boxes of partly seen agents are too small.
///
/// Appends one line per kind of defect to `warnings`, if not null. A recording without frames stays
/// unchanged.
void repair(NuScenesRecording& recording, const DataOptions& options,
            std::vector<std::string>* warnings);

}  // namespace forge
