#include "collision_forge/generators/generator_file.h"

#include <sstream>

#include "collision_forge/attack/method_registry.h"
#include "collision_forge/config/section.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/generators/generator_method.h"

namespace forge {
namespace {

constexpr const char* kFormat = "collision_forge traffic generator 1";

/// What libtorch complains of, without the backtrace that follows.
std::string firstLine(const std::exception& error) {
  const std::string text = error.what();
  return text.substr(0, text.find('\n'));
}

/// Does `read` with the file's archive; whatever goes wrong names the file.
template <typename Read>
void withArchive(const std::string& path, Read read) {
  try {
    torch::serialize::InputArchive archive;
    archive.load_from(path, torch::Device(torch::kCPU));
    read(archive);
  } catch (const TrafficGeneratorError&) {
    throw;
  } catch (const std::exception& error) {
    throw TrafficGeneratorError(path + ": cannot be read as a generator: " + firstLine(error));
  }
}

std::string textIn(torch::serialize::InputArchive& archive, const std::string& key) {
  c10::IValue value;
  archive.read(key, value);
  return value.toStringRef();
}

int countIn(torch::serialize::InputArchive& archive, const std::string& key) {
  c10::IValue value;
  archive.read(key, value);
  return static_cast<int>(value.toInt());
}

/// Weights under their names, copied into a network that has the same ones.
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

class LoadedGenerator : public TrafficMethods {
 public:
  LoadedGenerator(std::shared_ptr<const TrafficGenerator> generator, const TrafficOptions& traffic)
      : generator_(std::move(generator)), traffic_(traffic) {}

  std::unique_ptr<const AttackMethod> method(const AttackOptions& options) const override {
    return std::make_unique<GeneratorMethod>(generator_, traffic_, options);
  }

 private:
  std::shared_ptr<const TrafficGenerator> generator_;
  TrafficOptions traffic_;
};

}  // namespace

GeneratorOptions optionsOf(const GeneratorHeader& header, const std::string& path) {
  GeneratorOptions options;
  readConfigFile(openConfigText(path, header.config), options, header.history_frames);
  return options;
}

void writeGenerator(const std::string& path, const GeneratorHeader& header,
                    const TrafficGenerator& generator, bool training) {
  torch::serialize::OutputArchive archive;
  archive.write("format", c10::IValue(std::string(kFormat)));
  archive.write("name", c10::IValue(header.name));
  archive.write("config", c10::IValue(header.config));
  archive.write("history_frames", c10::IValue(static_cast<std::int64_t>(header.history_frames)));
  archive.write("epochs", c10::IValue(static_cast<std::int64_t>(header.epochs)));
  torch::serialize::OutputArchive weights;
  for (const auto& item : generator.network()->named_parameters()) {
    weights.write(item.key(), item.value().detach().to(torch::kCPU));
  }
  archive.write("weights", weights);
  if (training) {
    torch::serialize::OutputArchive rest;
    generator.saveTraining(rest);
    archive.write("training", rest);
  }
  std::ostringstream bytes;  // an archive that cannot write to a file ends the process
  archive.save_to(bytes);
  writeText(path, bytes.str());
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
    header.history_frames = countIn(archive, "history_frames");
    header.epochs = countIn(archive, "epochs");
  });
  return header;
}

void readGenerator(const std::string& path, TrafficGenerator& generator, bool training) {
  withArchive(path, [&](torch::serialize::InputArchive& archive) {
    torch::serialize::InputArchive weights;
    archive.read("weights", weights);
    copyWeights(path, weights, *generator.network());
    if (!training) return;
    torch::serialize::InputArchive rest;
    archive.read("training", rest);
    generator.loadTraining(rest);
  });
}

}  // namespace forge

std::shared_ptr<const forge::TrafficMethods> forgeLoadGenerator(const std::string& name,
                                                                const std::string& path) {
  torch::set_num_threads(1);
  const forge::GeneratorHeader header = forge::readGeneratorHeader(path, name);
  const forge::GeneratorOptions options = forge::optionsOf(header, path);
  std::shared_ptr<forge::TrafficGenerator> generator =
      forge::makeGenerator(name, options, torch::Device(torch::kCPU), 0);
  forge::readGenerator(path, *generator, false);
  generator->network()->eval();
  return std::make_shared<forge::LoadedGenerator>(std::move(generator), options.traffic);
}
