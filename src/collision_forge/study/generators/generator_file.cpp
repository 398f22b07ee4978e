#include "collision_forge/study/generators/generator_file.h"
#include "collision_forge/study/generators/make_traffic_model.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/base/config/config_file.h"

namespace forge {
namespace {

constexpr const char* kFormat = "collision_forge traffic generator 2";

/// Returns the message of a libtorch exception without its backtrace.
std::string firstLine(const std::exception& error) {
  const std::string text = error.what();
  return text.substr(0, text.find('\n'));
}

/// Returns the result of `read`; converts exceptions to errors that name the file.
template <typename Read>
auto readNamed(const std::string& path, Read read) {
  try {
    return read();
  } catch (const TrafficGeneratorError&) {
    throw;
  } catch (const std::exception& error) {
    throw TrafficGeneratorError(path + ": cannot be read as a generator: " + firstLine(error));
  }
}

/// Calls `read` with the archive of the file.
template <typename Read>
void withArchive(const std::string& path, Read read) {
  readNamed(path, [&] {
    torch::serialize::InputArchive archive;
    archive.load_from(path, torch::Device(torch::kCPU));
    read(archive);
  });
}

std::string textIn(torch::serialize::InputArchive& archive, const std::string& key) {
  c10::IValue value;
  archive.read(key, value);
  return value.toStringRef();
}

int countIn(torch::serialize::InputArchive& archive, const std::string& key, int min, int max) {
  c10::IValue value;
  archive.read(key, value);
  const std::int64_t count = value.toInt();
  if (count < min || count > max) {
    throw std::runtime_error(key + " = " + std::to_string(count) + " is not within " +
                             std::to_string(min) + " to " + std::to_string(max));
  }
  return static_cast<int>(count);
}

std::vector<std::string> textsIn(torch::serialize::InputArchive& archive, const std::string& key) {
  c10::IValue value;
  archive.read(key, value);
  std::vector<std::string> texts;
  for (const c10::IValue& text : value.toListRef()) texts.push_back(text.toStringRef());
  return texts;
}

/// Copies the weights of an archive, by name, into a network with the same parameters.
void copyWeights(const std::string& path, torch::serialize::InputArchive& archive,
                 torch::nn::Module& network) {
  const torch::NoGradGuard no_gradients;
  for (auto& item : network.named_parameters()) {
    torch::Tensor read;
    if (!archive.try_read(item.key(), read)) {
      throw TrafficGeneratorError(path + ": has no weights " + item.key());
    }
    if (read.sizes() != item.value().sizes()) {
      std::ostringstream text;
      text << path << ": weights " << item.key() << " are of shape " << read.sizes() << ", not "
           << item.value().sizes();
      throw TrafficGeneratorError(text.str());
    }
    if (!read.isfinite().all().item<bool>()) {
      throw TrafficGeneratorError(path + ": weights " + item.key() + " are not finite");
    }
    item.value().copy_(read);
  }
}

/// A model and the scenes that were left out in its training.
struct LoadedModel {
  std::shared_ptr<const TrafficModel> model;
  std::vector<std::string> left_out_scenes;
};

LoadedModel loadModel(const std::string& name, const std::string& path) {
  const GeneratorHeader header = readGeneratorHeader(path, name);
  const GeneratorOptions options = optionsOf(header, path);
  const auto model = readNamed(
      path, [&] { return makeTrafficModel(name, options, torch::Device(torch::kCPU), 0); });
  readGenerator(path, *model, false);
  model->network()->eval();
  for (torch::Tensor& parameter : model->network()->parameters()) {
    parameter.set_requires_grad(false);  // methods differentiate by latents, on many threads
  }
  return {model, header.left_out_scenes};
}

class LoadedModels : public TrafficMethods {
 public:
  explicit LoadedModels(std::vector<LoadedModel> models) : models_(std::move(models)) {}

  std::unique_ptr<const AttackMethod> method(const AttackOptions& options,
                                             const std::string& unseen_scene) const override {
    return of(unseen_scene).method(options);
  }

 private:
  const TrafficModel& of(const std::string& unseen_scene) const {
    for (const LoadedModel& loaded : models_) {
      const std::vector<std::string>& scenes = loaded.left_out_scenes;
      if (std::find(scenes.begin(), scenes.end(), unseen_scene) != scenes.end()) {
        return *loaded.model;
      }
    }
    return *models_.front().model;
  }

  std::vector<LoadedModel> models_;
};

}  // namespace

GeneratorOptions optionsOf(const GeneratorHeader& header, const std::string& path) {
  GeneratorOptions options;
  readConfigFile(openConfigText(path, header.config), options, sectionsOf(header.name),
                 header.history_frames);
  return options;
}

std::string generatorBytes(const GeneratorHeader& header, const TrafficModel& model,
                           bool training) {
  torch::serialize::OutputArchive archive;
  archive.write("format", c10::IValue(std::string(kFormat)));
  archive.write("name", c10::IValue(header.name));
  archive.write("config", c10::IValue(header.config));
  archive.write("history_frames", c10::IValue(static_cast<std::int64_t>(header.history_frames)));
  archive.write("epochs", c10::IValue(static_cast<std::int64_t>(header.epochs)));
  c10::List<std::string> left_out;
  for (const std::string& scene : header.left_out_scenes) left_out.push_back(scene);
  archive.write("left_out_scenes", c10::IValue(left_out));
  torch::serialize::OutputArchive weights;
  for (const auto& item : model.network()->named_parameters()) {
    weights.write(item.key(), item.value().detach().to(torch::kCPU));
  }
  archive.write("weights", weights);
  if (training) {
    torch::serialize::OutputArchive rest;
    model.saveTraining(rest);
    archive.write("training", rest);
  }
  std::ostringstream bytes;  // writing an archive to a file directly aborts on errors
  archive.save_to(bytes);
  return bytes.str();
}

GeneratorHeader readGeneratorHeader(const std::string& path, const std::string& name) {
  GeneratorHeader header;
  withArchive(path, [&](torch::serialize::InputArchive& archive) {
    const std::string format = textIn(archive, "format");
    if (format != kFormat) {
      throw TrafficGeneratorError(path + ": format is \"" + format + "\", not \"" + kFormat + "\"");
    }
    header.name = textIn(archive, "name");
    if (header.name != name) {
      throw TrafficGeneratorError(path + ": holds the generator " + header.name + ", not " + name);
    }
    header.config = textIn(archive, "config");
    header.history_frames = countIn(archive, "history_frames", 1, kMaxHistoryFrames);
    header.epochs = countIn(archive, "epochs", 0, std::numeric_limits<int>::max());
    header.left_out_scenes = textsIn(archive, "left_out_scenes");
  });
  return header;
}

void readGenerator(const std::string& path, TrafficModel& model, bool training) {
  withArchive(path, [&](torch::serialize::InputArchive& archive) {
    torch::serialize::InputArchive weights;
    archive.read("weights", weights);
    copyWeights(path, weights, *model.network());
    if (!training) return;
    torch::serialize::InputArchive rest;
    archive.read("training", rest);
    model.loadTraining(rest);
  });
}

}  // namespace forge

void forgeLoadGenerator(const std::string& name, const std::vector<std::string>& paths,
                        std::shared_ptr<const forge::TrafficMethods>& methods) {
  torch::set_num_threads(1);
  std::vector<forge::LoadedModel> models;
  for (const std::string& path : paths) models.push_back(forge::loadModel(name, path));
  methods = std::make_shared<forge::LoadedModels>(std::move(models));
}
