#include "collision_forge/study/generators/make_traffic_model.h"

#include <algorithm>
#include <stdexcept>

#include "collision_forge/study/generators/mid.h"
#include "collision_forge/study/generators/published_network.h"
#include "collision_forge/study/generators/social_gan.h"
#include "collision_forge/study/generators/strive.h"

namespace forge {

std::shared_ptr<TrafficModel> makeTrafficModel(const std::string& name, GeneratorOptions options,
                                               torch::Device device, std::uint64_t seed) {
  torch::manual_seed(seed);
  const std::vector<std::string> sections = sectionsOf(name);
  if (std::find(sections.begin(), sections.end(), "lanes") == sections.end()) {
    options.traffic.lanes = {};
  }
  if (name == "c_sgan") return makeSocialGan(options.c_sgan, options.traffic, device);
  if (name == "c_mid") return makeMid(options.c_mid, options.traffic, device);
  if (name == "c_strive") return makeStrive(options.c_strive, options.traffic, device);
  if (name == "published_network") {
    return makePublishedNetwork(options.published_network, options.traffic, device);
  }
  std::string known;
  for (const std::string& model : trafficModelNames()) known += (known.empty() ? "" : ", ") + model;
  throw std::invalid_argument("generator \"" + name + "\" is none of " + known);
}

}  // namespace forge
