#pragma once

#include <string>
#include <vector>

namespace forge {

/// True for a scene of the validation share of the split by scene: told from the scene's name alone
/// (the FNV-1a hash of it, mixed), so that the share does not depend on which clips are there.
bool isHeldOutScene(const std::string& scene, double share);

/// Paths of the clips in DIRECTORY/trajectory/SPLIT, sorted. Throws CollideError for a folder that
/// does not exist or has no clip, and for a file that is no clip by its name.
std::vector<std::string> listCollideClips(const std::string& directory, const std::string& split);

/// The split by scene: all clips of the published train and val, dealt anew so that no scene is in
/// both. `split` is "train" or "val"; throws std::invalid_argument for another, CollideError where
/// none is dealt to it, and as above.
std::vector<std::string> listCollideClipsByScene(const std::string& directory,
                                                 const std::string& split, double held_out_share);

/// Clips in two halves that share no scene.
struct ClipHalves {
  std::vector<std::string> first;
  std::vector<std::string> second;
};

/// Deals clips by their scenes' names in order, the first scene to the first half, the next to the
/// second. Throws CollideError where all are of one scene.
ClipHalves halvesByScene(const std::vector<std::string>& paths);

}  // namespace forge
