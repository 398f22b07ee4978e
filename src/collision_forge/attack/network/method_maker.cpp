#include "collision_forge/attack/network/method_maker.h"

#include <stdexcept>
#include <utility>

namespace forge {
namespace {

MethodForesight foresightOf(const AttackOptions& options, const Foresight& foresight) {
  return {foresight.egoFutures(options.ego_futures), foresight.patterns(options)};
}

}  // namespace

MethodMaker::MethodMaker(const std::string& name, const MethodRegistry& methods,
                         const AttackOptions& options, Foresight foresight)
    : options_(options),
      foresight_(std::move(foresight)),
      entry_(methods.at(name.empty() ? defaultMethod(foresight_.network != nullptr) : name)) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("method " + entry_.name + ": " + error.what());
  }
}

std::unique_ptr<const AttackMethod> MethodMaker::makeOf(const Foresight& foresight) const {
  MethodSetup setup{
      options_, foresightOf(options_, foresight.withoutNetwork()), {}, foresight.unseen_scene};
  if (foresight.network) setup.networks = foresightOf(options_, foresight);
  return entry_.make(setup);
}

}  // namespace forge
