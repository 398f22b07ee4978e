#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace forge {

/// Cross-validation models of one kind, each fitted without some scenes. Immutable after
/// construction, so safe to share among threads.
template <class Model>
class Folds {
 public:
  /// Has no models.
  Folds() = default;
  /// Makes one Model from each entry of `weights`, which needs a list `left_out_scenes` of scene
  /// names. Throws std::invalid_argument if two entries leave out the same scene, and as the
  /// constructor of Model.
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

  /// Returns the models in the order of `weights`.
  const std::vector<std::shared_ptr<const Model>>& models() const { return models_; }
  /// Returns the model that was fitted without `scene`; null if there is none.
  std::shared_ptr<const Model> withoutScene(const std::string& scene) const {
    const auto fold = fold_of_.find(scene);
    return fold == fold_of_.end() ? nullptr : models_[fold->second];
  }

 private:
  std::vector<std::shared_ptr<const Model>> models_;
  std::unordered_map<std::string, std::size_t> fold_of_;
};

/// Returns the model to use on a test scene: model->withoutScene(scene), or `model` if that is
/// null; null if `model` is. Copies no weights.
template <class Model>
std::shared_ptr<const Model> withoutScene(const std::shared_ptr<const Model>& model,
                                          const std::string& scene) {
  auto other = model ? model->withoutScene(scene) : nullptr;
  return other ? other : model;
}

}  // namespace forge
