#include "collision_forge/network/method_maker.h"

#include <stdexcept>
#include <utility>

namespace forge {
namespace {

MethodForesight foresightOf(const AttackOptions& options, const Foresight& foresight,
                            const std::string& left_out_scene) {
  return {foresight.egoFutures(options.ego_futures, left_out_scene),
          foresight.patterns(options, left_out_scene)};
}

}  // namespace

MethodMaker::MethodMaker(const std::string& name, const MethodRegistry& methods,
                         const AttackOptions& options, Foresight foresight)
    : options_(options),
      foresight_(std::move(foresight)),
      entry_(methods.at(name.empty() ? defaultMethod(foresight_.networks != nullptr) : name)) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("method " + entry_.name + ": " + error.what());
  }
}

std::unique_ptr<const AttackMethod> MethodMaker::make(const std::string& left_out_scene) const {
  MethodSetup setup{
      options_, foresightOf(options_, foresight_.withoutNetworks(), left_out_scene), {}};
  if (foresight_.networks) setup.networks = foresightOf(options_, foresight_, left_out_scene);
  return entry_.make(setup);
}

}  // namespace forge
