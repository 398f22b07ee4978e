#include "collision_forge/io/weights/speed_model_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {
namespace {

const char* const kFormat = "collision_forge speed model 1";

double rounded(double value) {
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.5g", value);
  return std::strtod(digits, nullptr) + 0.0;
}

void writeMatrix(JsonLineWriter& writer, const char* key, const Eigen::MatrixXd& matrix) {
  std::vector<double> values;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      values.push_back(rounded(matrix(row, column)));
    }
  }
  writer.beginObject(key);
  writer.count("rows", static_cast<std::uint64_t>(matrix.rows()));
  writer.count("columns", static_cast<std::uint64_t>(matrix.cols()));
  writer.numbers("values", values);
  writer.endObject();
}

Eigen::MatrixXd readMatrix(JsonObject& parent, const char* key) {
  JsonObject object = parent.object(key);
  const std::uint64_t rows = object.count("rows");
  const std::uint64_t columns = object.count("columns");
  const std::vector<double> values = object.numbers("values");
  if (columns == 0 ? !values.empty()
                   : values.size() % columns != 0 || values.size() / columns != rows) {
    object.fail("values", "has " + std::to_string(values.size()) + " numbers, not " +
                              std::to_string(rows) + " x " + std::to_string(columns));
  }
  object.finish();
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(values.data(), static_cast<Eigen::Index>(rows),
                                    static_cast<Eigen::Index>(columns));
}

void writeVector(JsonLineWriter& writer, const char* key, const Eigen::VectorXd& vector) {
  std::vector<double> values;
  for (const double value : vector) values.push_back(rounded(value));
  writer.numbers(key, values);
}

Eigen::VectorXd readVector(JsonObject& parent, const char* key) {
  const std::vector<double> values = parent.numbers(key);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void writeProfiles(JsonLineWriter& writer, const char* key, const WeightedProfiles& profiles) {
  writer.beginObject(key);
  writeVector(writer, "weights", profiles.weights);
  writeMatrix(writer, "profiles", profiles.profiles);
  writer.endObject();
}

WeightedProfiles readProfiles(JsonObject& parent, const char* key) {
  JsonObject object = parent.object(key);
  WeightedProfiles profiles;
  profiles.weights = readVector(object, "weights");
  profiles.profiles = readMatrix(object, "profiles");
  object.finish();
  return profiles;
}

std::string lineOf(const SpeedModelWeights& weights) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("format", kFormat);
  writer.texts("left_out_scenes", weights.left_out_scenes);
  writeVector(writer, "feature_weights", weights.feature_weights);
  writeVector(writer, "lowest", weights.lowest);
  writeVector(writer, "highest", weights.highest);
  writeMatrix(writer, "centers", weights.centers);
  writeMatrix(writer, "gains", weights.gains);
  writeMatrix(writer, "log_spreads", weights.log_spreads);
  writeProfiles(writer, "residuals", weights.residuals);
  writer.number("standing_speed", weights.standing_speed);
  writeMatrix(writer, "standing", weights.standing);
  writeMatrix(writer, "standing_shares", weights.standing_shares);
  writer.endObject();
  return writer.line();
}

SpeedModelWeights readLine(const std::string& where, const std::string& line) {
  const JsonLine parsed(where, line);
  JsonObject object = parsed.root();
  if (object.text("format") != kFormat) object.fail("format", std::string("is not ") + kFormat);
  SpeedModelWeights weights;
  weights.left_out_scenes = object.texts("left_out_scenes");
  weights.feature_weights = readVector(object, "feature_weights");
  weights.lowest = readVector(object, "lowest");
  weights.highest = readVector(object, "highest");
  weights.centers = readMatrix(object, "centers");
  weights.gains = readMatrix(object, "gains");
  weights.log_spreads = readMatrix(object, "log_spreads");
  weights.residuals = readProfiles(object, "residuals");
  weights.standing_speed = object.number("standing_speed");
  weights.standing = readMatrix(object, "standing");
  weights.standing_shares = readMatrix(object, "standing_shares");
  object.finish();
  return weights;
}

/// Reads and checks one model of the file.
SpeedModelWeights readWeights(const std::string& where, const std::string& line) {
  try {
    SpeedModelWeights weights = readLine(where, line);
    checkWeights(weights);
    return weights;
  } catch (const JsonLineError& error) {
    throw SpeedModelFileError(error.what());
  } catch (const std::invalid_argument& error) {
    throw SpeedModelFileError(where + ": " + error.what());
  }
}

}  // namespace

SpeedModel readSpeedModel(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw SpeedModelFileError(path + ": cannot be opened: " + std::strerror(errno));
  std::vector<SpeedModelWeights> models;
  for (std::string line; std::getline(file, line);) {
    models.push_back(readWeights(path + ": line " + std::to_string(models.size() + 1), line));
  }
  if (file.bad()) throw SpeedModelFileError(path + ": cannot be read: " + std::strerror(errno));
  if (models.empty()) throw SpeedModelFileError(path + ": has no model");
  SpeedModelWeights whole = std::move(models.front());
  models.erase(models.begin());
  try {
    return SpeedModel(std::move(whole), std::move(models));
  } catch (const std::invalid_argument& error) {
    throw SpeedModelFileError(path + ": " + error.what());
  }
}

void writeSpeedModel(const SpeedModel& model, const std::string& path) {
  AsideFile aside(path);
  std::ostream& file = aside.stream();
  file << lineOf(model.weights()) << '\n';
  for (const auto& fold : model.folds()) file << lineOf(fold->weights()) << '\n';
  aside.commit();
}

std::shared_ptr<const SpeedForecaster> loadSpeedForecaster(const ModelOptions& options) {
  if (options.speed_model.empty()) return nullptr;
  return std::make_shared<const SpeedModel>(readSpeedModel(options.speed_model));
}

}  // namespace forge
