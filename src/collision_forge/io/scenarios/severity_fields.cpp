#include "collision_forge/io/scenarios/severity_fields.h"

#include <iterator>

#include "collision_forge/attack/drivers/driver_models.h"
#include "collision_forge/io/scenarios/relative_time.h"

namespace forge {
namespace {

constexpr std::uint64_t kMaxClass = 3;     // S3 of ISO 26262
constexpr double kLongestAttack = 3600.0;  // s

void writeEffect(JsonLineWriter& writer, const char* key, const CrashEffect& effect) {
  writer.beginObject(key);
  writer.number("delta_v", effect.delta_v);
  writer.number("force_from", effect.force_from);
  writer.number("yaw_rate_change", effect.yaw_rate_change);
  writer.number("mais2", effect.mais2);
  writer.number("mais3", effect.mais3);
  writer.text("curve", effect.curve);
  writer.count("least_class", static_cast<std::uint64_t>(effect.least_class));
  writer.count("most_class", static_cast<std::uint64_t>(effect.most_class));
  writer.endObject();
}

int readClass(JsonObject& object, const char* key) {
  const std::uint64_t value = object.count(key);
  if (value > kMaxClass) object.fail(key, "is not a class from 0 to 3");
  return static_cast<int>(value);
}

CrashEffect readEffect(JsonObject object) {
  CrashEffect effect;
  effect.delta_v = object.number("delta_v");
  effect.force_from = object.number("force_from");
  effect.yaw_rate_change = object.number("yaw_rate_change");
  effect.mais2 = object.within("mais2", 0.0, 1.0);
  effect.mais3 = object.within("mais3", 0.0, 1.0);
  effect.curve = object.text("curve");
  effect.least_class = readClass(object, "least_class");
  effect.most_class = readClass(object, "most_class");
  object.finish();
  return effect;
}

}  // namespace

void writeSeverity(JsonLineWriter& writer, const char* key, const CrashSeverity& severity) {
  writer.beginObject(key);
  writeEffect(writer, "ego", severity.ego);
  writeEffect(writer, "other", severity.other);
  writer.number("energy_lost", severity.energy_lost);
  writer.endObject();
}

CrashSeverity readSeverity(JsonObject object) {
  CrashSeverity severity;
  severity.ego = readEffect(object.object("ego"));
  severity.other = readEffect(object.object("other"));
  severity.energy_lost = object.number("energy_lost");
  object.finish();
  return severity;
}

void writeCarefulDrivers(JsonLineWriter& writer, const std::vector<CarefulDrive>& drives,
                         double now) {
  writer.beginArray("careful_drivers");
  for (const CarefulDrive& drive : drives) {
    writer.beginObject();
    writer.text("driver", drive.driver);
    writer.flag("avoids", drive.avoids);
    if (drive.brakes_at) {
      writer.number("brakes_t", fromNow(*drive.brakes_at, now));
    } else {
      writer.null("brakes_t");
    }
    writer.endObject();
  }
  writer.endArray();
}

std::vector<CarefulDrive> readCarefulDrivers(JsonObject& object, double now) {
  std::vector<CarefulDrive> drives;
  for (JsonObject& entry : object.objects("careful_drivers", std::size(kDriverModels))) {
    CarefulDrive& drive = drives.emplace_back();
    drive.driver = entry.text("driver");
    if (!driverModelFromString(drive.driver)) entry.fail("driver", "is not a driver model");
    drive.avoids = entry.flag("avoids");
    if (const auto time = entry.numberOrNull("brakes_t")) {
      if (*time < 0.0 || *time > kLongestAttack) entry.fail("brakes_t", "is beyond the attack");
      drive.brakes_at = now + *time;
    }
    entry.finish();
  }
  return drives;
}

}  // namespace forge
