#include "collision_forge/study/dataset/clip_requests.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/collide/collide_frames.h"
#include "collision_forge/study/dataset/seeds.h"

namespace forge {
namespace {

constexpr auto kNow = static_cast<std::size_t>(kCollideNowFrame);

/// Returns true if the time between two frames corresponds to their number at 2 Hz.
bool comesAtTwoHertz(const std::vector<double>& frames, std::size_t from, std::size_t to) {
  const auto counted = std::lround((frames[to] - frames[from]) / kCollideFrameInterval);
  return counted == static_cast<long>(to - from);
}

/// Returns the indices of the frames at which clips begin; `stride` in s.
std::vector<std::size_t> beginsOf(const std::vector<double>& frames, double stride) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (begins.empty() ||
        frames[i] - frames[begins.back()] > stride - 0.5 * kCollideFrameInterval) {
      begins.push_back(i);
    }
  }
  return begins;
}

/// Lists the requests of one scene.
class Lister {
 public:
  Lister(const Scene& scene, const DatasetOptions& options, const PredictionOptions& prediction,
         std::uint64_t seed)
      : scene_(scene),
        frames_(collideFrames(scene.frame_times)),
        options_(options),
        prediction_(prediction),
        seed_(seed) {}

  std::vector<SceneRequest> list() {
    for (const std::size_t begin : beginsOf(frames_, options_.begin_stride)) {
      addBegin(begin);
    }
    return std::move(requests_);
  }

 private:
  void addBegin(std::size_t begin) {
    if (begin + kNow >= frames_.size() || !comesAtTwoHertz(frames_, begin, begin + kNow)) return;
    const Snapshot snapshot = snapshotAt(scene_, frames_[begin + kNow], kCollideNowFrame + 1);
    if (snapshot.ego.states.size() < 2 ||
        estimateMotion(snapshot.ego).speed < options_.min_ego_speed) {
      return;
    }
    const std::vector<int> lengths = possibleLengths(begin);
    for (const CollisionType type : kCollisionTypes) addType(begin, type, lengths, snapshot);
  }

  std::vector<int> possibleLengths(std::size_t begin) const {
    std::vector<int> possible;
    for (const int length : clipLengths(options_)) {
      const std::size_t impact = begin + static_cast<std::size_t>(length);
      if (impact + 1 < frames_.size() && comesAtTwoHertz(frames_, begin + kNow, impact) &&
          frames_[impact + 1] <= scene_.ego.states.back().time) {
        possible.push_back(length);
      }
    }
    return possible;
  }

  void addType(std::size_t begin, CollisionType type, std::vector<int> lengths,
               const Snapshot& snapshot) {
    const std::string place =
        scene_.name + "/" + std::to_string(begin) + "/" + toString(type) + "/";
    const int count = std::min(options_.attempts.at(type), static_cast<int>(lengths.size()));
    for (int draw = 0; draw < count; ++draw) {
      const std::uint64_t seed = seedOf(place + std::to_string(draw), seed_);
      const auto chosen = lengths.begin() + static_cast<std::ptrdiff_t>(seed % lengths.size());
      const std::size_t impact = begin + static_cast<std::size_t>(*chosen);
      lengths.erase(chosen);
      const double tta = frames_[impact] - snapshot.now;
      CollisionRequest request;
      request.type = type;
      request.tta = tta;
      request.mode = Mode::kReplay;
      request.seed = seed;
      if (checkRequest(request, snapshot, prediction_).code != StatusCode::kOk) continue;
      requests_.push_back({scene_.name, snapshot.now, request});
    }
  }

  const Scene& scene_;
  const std::vector<double> frames_;  ///< s, at 2 Hz
  const DatasetOptions& options_;
  const PredictionOptions& prediction_;
  std::uint64_t seed_;
  std::vector<SceneRequest> requests_;
};

}  // namespace

std::vector<int> clipLengths(const DatasetOptions& options) {
  std::vector<int> lengths;
  const auto first = static_cast<int>(std::ceil(options.min_length / kCollideFrameInterval - 1e-9));
  const auto last = static_cast<int>(std::floor(options.max_length / kCollideFrameInterval + 1e-9));
  for (int length = first; length <= last; ++length) lengths.push_back(length);
  return lengths;
}

std::vector<SceneRequest> listClipRequests(const Scene& scene, const DatasetOptions& options,
                                           const PredictionOptions& prediction,
                                           std::uint64_t seed) {
  return Lister(scene, options, prediction, seed).list();
}

}  // namespace forge
