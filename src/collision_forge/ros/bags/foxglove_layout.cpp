#include "collision_forge/ros/bags/foxglove_layout.h"

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

/// The ego from above, a little from the south, on white as the colours are meant.
std::string scenePanel() {
  return R"({
      "cameraState": {
        "distance": 50, "perspective": true, "phi": 30, "thetaOffset": 0, "targetOffset": [0, 0, 0],
        "target": [0, 0, 0], "targetOrientation": [0, 0, 0, 1], "fovy": 45, "near": 0.5, "far": 5000
      },
      "followMode": "follow-position",
      "followTf": ")" +
         std::string(names::kBaseFrame) + R"(",
      "scene": {
        "backgroundColor": "#ffffff",
        "transforms": {"showLabel": false, "lineWidth": 0}
      },
      "topics": {
        ")" +
         bagTopic(names::kCrashMap) + R"(": {"visible": true},
        ")" +
         bagTopic(names::kCrashScene) + R"(": {"visible": true},
        "/lidar_top": {"visible": true, "pointSize": 2, "colorMode": "colormap", "colorField": "z"}
      },
      "layers": {},
      "transforms": {}
    })";
}

std::string speedPath(const char* topic, const char* label, const char* color) {
  return R"({
          "value": ")" +
         bagTopic(topic) + R"(.data", "label": ")" + label + R"(", "color": ")" + color + R"(",
          "enabled": true, "timestampMethod": "receiveTime"
        })";
}

std::string speedPanel() {
  return R"({
      "foxglovePanelTitle": "Speeds, m/s",
      "paths": [
        )" +
         speedPath(names::kEgoSpeed, "ego", "#1f66cc") +
         R"(,
        )" +
         speedPath(names::kAttackerSpeed, "attacker", "#d62629") +
         R"(
      ],
      "minYValue": 0, "isSynced": true, "xAxisVal": "timestamp", "sidebarDimension": 240,
      "showLegend": true, "legendDisplay": "floating", "showPlotValuesInLegend": true,
      "showXAxisLabels": true, "showYAxisLabels": true
    })";
}

}  // namespace

std::string foxgloveLayout() {
  return R"({
  "configById": {
    "3D!crash": )" +
         scenePanel() + R"(,
    "Plot!speeds": )" +
         speedPanel() + R"(
  },
  "globalVariables": {},
  "userNodes": {},
  "playbackConfig": {"speed": 1},
  "layout": {
    "first": "3D!crash", "second": "Plot!speeds", "direction": "column", "splitPercentage": 72
  }
}
)";
}

}  // namespace forge
