#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Writes small CommonRoad files.
class SmallCommonRoad {
 public:
  explicit SmallCommonRoad(std::string benchmark = "ZAM_Town-1_1_T-1")
      : benchmark_(std::move(benchmark)) {}

  static std::string ref(const std::string& element, const std::string& id,
                         const std::string& more = "") {
    return "<" + element + " ref='" + id + "' " + more + "/>";
  }

  /// A lanelet 20 m long in direction x from (x, y), 3 m wide; `rest` follows the bounds.
  SmallCommonRoad& lanelet(const std::string& id, double x, double y, const std::string& rest = "",
                           const char* bounds = "leftBound rightBound") {
    const std::string names = bounds;
    const std::size_t space = names.find(' ');
    text_ << "<lanelet id='" << id << "'>" << bound(names.substr(0, space), x, y + 1.5)
          << bound(names.substr(space + 1), x, y - 1.5) << rest << "</lanelet>\n";
    return *this;
  }

  static std::string state(const std::string& name, const Pose2& pose, double step, double speed) {
    std::ostringstream text;
    text << "<" << name << "><position>" << point("point", pose.position()) << "</position>"
         << "<orientation><exact>" << pose.yaw << "</exact></orientation><time><exact>" << step
         << "</exact></time><velocity><exact>" << speed << "</exact></velocity></" << name << ">";
    return text.str();
  }

  /// An obstacle in version 2020a that drives along x at `speed` from step `first` to `last`.
  SmallCommonRoad& moving(const std::string& id, const std::string& type, const Vector2& start,
                          double speed, int first, int last) {
    text_ << "<dynamicObstacle id='" << id << "'><type>" << type << "</type>" << kBox
          << drive(start, speed, first, last) << "</dynamicObstacle>\n";
    return *this;
  }

  /// The initial state and the trajectory.
  static std::string drive(const Vector2& start, double speed, int first, int last) {
    std::string text;
    for (int step = first; step <= last; ++step) {
      const Pose2 pose{start.x() + 0.1 * speed * (step - first), start.y(), 0.0};
      text += state(step == first ? "initialState" : "state", pose, step, speed);
      if (step == first) text += "<trajectory>";
    }
    return text + "</trajectory>";
  }

  SmallCommonRoad& add(const std::string& text) {
    text_ << text << "\n";
    return *this;
  }

  SmallCommonRoad& problem(const Pose2& start, int step) {
    return add("<planningProblem id='900'>" + state("initialState", start, step, 5.0) +
               "<goalState/></planningProblem>");
  }

  std::string text(const std::string& version = "2020a") const {
    return "<?xml version='1.0'?>\n<commonRoad commonRoadVersion='" + version + "' benchmarkID='" +
           benchmark_ + "' timeStepSize='0.1'>\n" + text_.str() + "</commonRoad>\n";
  }

  static constexpr const char* kBox =
      "<shape><rectangle><length>4.5</length><width>1.9</width></rectangle></shape>";

 private:
  static std::string point(const std::string& name, const Vector2& at) {
    std::ostringstream text;
    text << "<" << name << "><x>" << at.x() << "</x><y>" << at.y() << "</y></" << name << ">";
    return text.str();
  }

  static std::string bound(const std::string& name, double x, double y) {
    return "<" + name + ">" + point("point", {x, y}) + point("point", {x + 20.0, y}) + "</" + name +
           ">";
  }

  std::string benchmark_;
  std::ostringstream text_;
};

}  // namespace forge
