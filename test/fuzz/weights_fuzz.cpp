#include <memory>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/network/network_pattern_predictor.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

/// Requires that the outputs of the networks for a scene are finite, or rejected.
void predict(const std::shared_ptr<const PatternNetwork>& network) {
  static const Snapshot snapshot = junctionSnapshot();
  static const LaneIndex lanes = lanesOf(snapshot);
  const NetworkPatternPredictor predictor(configuration().attack,
                                          PredictionModels{nullptr, network, {}});
  const PatternPrediction found = predictor.predict(snapshot, lanes, requestFor(), nullptr);
  for (const CollisionPattern& pattern : found.patterns) {
    require(pattern.attacker_offset.isFinite(), "a pattern is not finite");
  }
}

}  // namespace

/// Input: a weights file of pattern networks.
bool fuzzWeights(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("network.bin", input);
  std::shared_ptr<const PatternNetwork> network;
  const bool is_taken = isTaken(path, [&] {
    network = loadPatternNetwork(path);
    writePatternWeights(readPatternWeights(path), path);
    const std::string written = bytesOf(path);
    writePatternWeights(readPatternWeights(path), path);
    requireSame(written, bytesOf(path));
  });
  return is_taken && isTaken("", [&] { predict(network); });
}

}  // namespace forge
