#pragma once

#include <string>
#include <vector>

namespace forge {

/// Returns true if a scene is in the validation share (0..1) of the split by scene. Depends on a
/// hash of the scene's name alone (FNV-1a, mixed), so not on which clips are present.
bool isHeldOutScene(const std::string& scene, double share);

/// Returns the paths of the clips in DIRECTORY/trajectory/SPLIT, sorted by file name. Throws
/// CollideError for a folder that does not exist or has no clip, and for an entry whose name is not
/// a clip's.
std::vector<std::string> listCollideClips(const std::string& directory, const std::string& split);

/// Returns the paths of the clips of a split by scene, sorted by file name: all clips of the
/// published train and val, redistributed so that no scene is in both; scenes with isHeldOutScene()
/// for `held_out_share` are in val. `split`: "train" or "val"; another throws
/// std::invalid_argument. Throws CollideError as listCollideClips(), and if the split is empty.
std::vector<std::string> listCollideClipsByScene(const std::string& directory,
                                                 const std::string& split, double held_out_share);

/// Paths of clips in two halves that share no scene.
struct ClipHalves {
  std::vector<std::string> first;
  std::vector<std::string> second;
};

/// Assigns the clips of the scenes, sorted by name, alternately to the first and the second half
/// (of an odd number of scenes, one more to the first); clips of one scene keep their order. Throws
/// CollideError if all clips are of one scene or there are none, and as parseCollideName().
ClipHalves halvesByScene(const std::vector<std::string>& paths);

}  // namespace forge
