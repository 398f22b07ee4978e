#include "collision_forge/io/weights/pattern_network_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/io/weights/traffic_generators.h"

namespace forge {
namespace {

const char* const kFormat = "collision_forge pattern network 1";

static_assert(sizeof(float) == 4 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);

void writeFeatures(const PatternFeatureOptions& features, JsonLineWriter& writer) {
  const auto count = [&](const char* key, int value) {
    writer.count(key, static_cast<std::uint64_t>(value));
  };
  writer.beginObject("features");
  writer.text("head", toString(features.head));
  count("history_frames", features.history_frames);
  count("agent_frames", features.agent_frames);
  count("max_agents", features.max_agents);
  writer.number("lane_radius", features.encoding.lane_radius);
  count("max_lanes", features.encoding.max_lanes);
  count("lane_points", features.encoding.lane_points);
  writer.number("lane_point_spacing", features.encoding.lane_point_spacing);
  count("max_ways", features.max_ways);
  count("way_anchors", features.way_anchors);
  writer.number("spacing_floor", features.spacing_floor);
  writer.number("spacing_rate", features.spacing_rate);
  writer.number("spacing_exponent", features.spacing_exponent);
  count("target_lanes", features.target_lanes);
  count("target_points", features.target_points);
  writer.number("target_spacing", features.target_spacing);
  writer.endObject();
}

std::string headerOf(const PatternWeights& weights) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("format", kFormat);
  writer.texts("left_out_scenes", weights.left_out_scenes);
  writeFeatures(weights.features, writer);
  writer.beginObject("network");
  writer.count("hidden", static_cast<std::uint64_t>(weights.network.hidden));
  writer.count("scene", static_cast<std::uint64_t>(weights.network.scene));
  writer.count("anchor", static_cast<std::uint64_t>(weights.network.anchor));
  writer.endObject();
  writer.beginArray("layers");
  for (const auto& [name, layer] : weights.layers) {
    writer.beginObject();
    writer.text("name", name);
    writer.count("outputs", static_cast<std::uint64_t>(layer.matrix.rows()));
    writer.count("inputs", static_cast<std::uint64_t>(layer.matrix.cols()));
    writer.endObject();
  }
  writer.endArray();
  writer.endObject();
  return writer.line();
}

int boundedCountOf(JsonObject& object, const char* key, int min, int max) {
  const std::uint64_t value = object.count(key);
  if (value < static_cast<std::uint64_t>(min) || value > static_cast<std::uint64_t>(max)) {
    object.fail(key, "is not within " + std::to_string(min) + " to " + std::to_string(max));
  }
  return static_cast<int>(value);
}

int countOf(JsonObject& object, const char* key, int min = 1) {
  return boundedCountOf(object, key, min, kMaxFeatureCount);
}

int widthOf(JsonObject& object, const char* key) {
  return boundedCountOf(object, key, 1, kMaxLayerWidth);
}

double lengthOf(JsonObject& object, const char* key) {
  return object.within(key, kMinFeatureNumber, kMaxFeatureLength);
}

PatternFeatureOptions readFeatures(JsonObject object) {
  PatternFeatureOptions features;
  try {
    features.head = egoHeadFromString(object.text("head"));
  } catch (const std::invalid_argument& error) {
    object.fail("head", error.what());
  }
  features.history_frames = boundedCountOf(object, "history_frames", 1, kMaxHistoryFrames);
  features.agent_frames = boundedCountOf(object, "agent_frames", 1, features.history_frames);
  features.max_agents = countOf(object, "max_agents");
  features.encoding.lane_radius = lengthOf(object, "lane_radius");
  features.encoding.max_lanes = countOf(object, "max_lanes");
  features.encoding.lane_points = countOf(object, "lane_points", kMinPolylinePoints);
  features.encoding.lane_point_spacing = lengthOf(object, "lane_point_spacing");
  features.max_ways = countOf(object, "max_ways");
  features.way_anchors = countOf(object, "way_anchors", kMinWayAnchors);
  features.spacing_floor = lengthOf(object, "spacing_floor");
  features.spacing_rate = lengthOf(object, "spacing_rate");
  features.spacing_exponent =
      object.within("spacing_exponent", kMinFeatureNumber, kMaxSpacingExponent);
  features.target_lanes = countOf(object, "target_lanes");
  features.target_points = countOf(object, "target_points", kMinPolylinePoints);
  features.target_spacing = lengthOf(object, "target_spacing");
  object.finish();
  return features;
}

PatternNetworkOptions readNetwork(JsonObject object) {
  PatternNetworkOptions network;
  network.hidden = widthOf(object, "hidden");
  network.scene = widthOf(object, "scene");
  network.anchor = widthOf(object, "anchor");
  object.finish();
  return network;
}

PatternWeights readHeader(const std::string& where, const std::string& line) {
  const JsonLine parsed(where, line);
  JsonObject object = parsed.root();
  if (object.text("format") != kFormat) object.fail("format", std::string("is not ") + kFormat);
  PatternWeights weights;
  weights.left_out_scenes = object.texts("left_out_scenes");
  weights.features = readFeatures(object.object("features"));
  weights.network = readNetwork(object.object("network"));
  constexpr int kMaxLayers = 1000;
  for (JsonObject& layer : object.objects("layers", kMaxLayers)) {
    const std::string name = layer.text("name");
    const int outputs = widthOf(layer, "outputs");
    const int inputs = widthOf(layer, "inputs");
    layer.finish();
    weights.layers[name] = {RowMatrix(outputs, inputs), Eigen::VectorXf(outputs)};
  }
  object.finish();
  return weights;
}

void readNumbers(std::istream& file, const std::string& where, const std::string& layer,
                 float* data, Eigen::Index count) {
  const auto bytes = static_cast<std::streamsize>(count) * 4;
  file.read(reinterpret_cast<char*>(data), bytes);
  if (file.gcount() != bytes) {
    throw PatternNetworkFileError(where + ": the file ends within layer " + layer);
  }
}

PatternWeights readOne(std::istream& file, const std::string& where, const std::string& line) {
  try {
    PatternWeights weights = readHeader(where, line);
    for (auto& [name, layer] : weights.layers) {
      readNumbers(file, where, name, layer.matrix.data(), layer.matrix.size());
      readNumbers(file, where, name, layer.bias.data(), layer.bias.size());
    }
    checkWeights(weights);
    return weights;
  } catch (const JsonLineError& error) {
    throw PatternNetworkFileError(error.what());
  } catch (const std::invalid_argument& error) {
    throw PatternNetworkFileError(where + ": " + error.what());
  }
}

void writeNumbers(std::ostream& file, const float* data, Eigen::Index count) {
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count) * 4);
}

}  // namespace

std::vector<PatternWeights> readPatternWeights(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw PatternNetworkFileError(path + ": cannot be opened: " + std::strerror(errno));
  std::vector<PatternWeights> networks;
  for (std::string line; std::getline(file, line);) {
    networks.push_back(
        readOne(file, path + ": network " + std::to_string(networks.size() + 1), line));
  }
  if (file.bad()) throw PatternNetworkFileError(path + ": cannot be read: " + std::strerror(errno));
  if (networks.empty()) throw PatternNetworkFileError(path + ": has no network");
  return networks;
}

void writePatternWeights(const std::vector<PatternWeights>& networks, const std::string& path) {
  AsideFile aside(path);
  std::ostream& file = aside.stream();
  for (const PatternWeights& weights : networks) {
    file << headerOf(weights) << '\n';
    for (const auto& entry : weights.layers) {
      writeNumbers(file, entry.second.matrix.data(), entry.second.matrix.size());
      writeNumbers(file, entry.second.bias.data(), entry.second.bias.size());
    }
  }
  aside.commit();
}

std::shared_ptr<const PatternNetwork> loadPatternNetwork(const std::string& path) {
  if (path.empty()) return nullptr;
  std::vector<PatternWeights> folds = readPatternWeights(path);
  PatternWeights whole = std::move(folds.front());
  folds.erase(folds.begin());
  try {
    return std::make_shared<const PatternNetwork>(std::move(whole), std::move(folds));
  } catch (const std::invalid_argument& error) {
    throw PatternNetworkFileError(path + ": " + error.what());
  }
}

PredictionModels loadPredictionModels(const ModelOptions& options) {
  return {loadSpeedForecaster(options), loadPatternNetwork(options.pattern_network), std::nullopt};
}

MethodRegistry loadMethods(const ModelOptions& options) {
  MethodRegistry methods = methodsWith(options.method_libraries);
  addGeneratorMethods(options, methods);
  return methods;
}

MethodMaker loadMethod(const std::string& name, const ModelOptions& models,
                       const AttackOptions& attack) {
  return {name, loadMethods(models), attack, loadPredictionModels(models)};
}

}  // namespace forge
