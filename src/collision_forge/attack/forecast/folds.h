#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace forge {

/// Models of one kind that left some scenes out each, when they were fitted.
template <class Model>
class Folds {
 public:
  Folds() = default;
  /// `Weights` make a Model and name their `left_out_scenes`. Throws std::invalid_argument for a
  /// scene that two of them left out.
  template <class Weights>
  explicit Folds(std::vector<Weights> weights) {
    for (Weights& entry : weights) {
      for (const std::string& scene : entry.left_out_scenes) {
        if (!fold_of_.emplace(scene, models_.size()).second) {
          throw std::invalid_argument("left_out_scenes has " + scene + " twice");
        }
      }
      models_.push_back(std::make_shared<const Model>(std::move(entry)));
    }
  }

  const std::vector<std::shared_ptr<const Model>>& models() const { return models_; }
  /// The one that left the scene out; null when none did.
  std::shared_ptr<const Model> withoutScene(const std::string& scene) const {
    const auto fold = fold_of_.find(scene);
    return fold == fold_of_.end() ? nullptr : models_[fold->second];
  }

 private:
  std::vector<std::shared_ptr<const Model>> models_;
  std::unordered_map<std::string, std::size_t> fold_of_;
};

/// What `model` has for a scene on test: model->withoutScene(), or itself where that is null. No
/// weights are copied.
template <class Model>
std::shared_ptr<const Model> withoutScene(const std::shared_ptr<const Model>& model,
                                          const std::string& scene) {
  auto other = model ? model->withoutScene(scene) : nullptr;
  return other ? other : model;
}

}  // namespace forge
