#pragma once

#include <string>

namespace forge {

/// Texts of OpenDRIVE elements.
namespace open_drive {

inline std::string lane(int id, const std::string& type, const std::string& content) {
  return "<lane id='" + std::to_string(id) + "' type='" + type + "' level='false'>" + content +
         "</lane>";
}

/// Width a + b ds, m.
inline std::string width(double a, double b = 0.0) {
  return "<width sOffset='0' a='" + std::to_string(a) + "' b='" + std::to_string(b) +
         "' c='0' d='0'/>";
}

inline std::string link(const std::string& predecessor, const std::string& successor) {
  return "<link>" + (predecessor.empty() ? "" : "<predecessor id='" + predecessor + "'/>") +
         (successor.empty() ? "" : "<successor id='" + successor + "'/>") + "</link>";
}

inline std::string section(double s, const std::string& left, const std::string& right) {
  return "<laneSection s='" + std::to_string(s) + "'><left>" + left +
         "</left><center><lane id='0' type='none'/></center><right>" + right +
         "</right></laneSection>";
}

inline std::string geometry(double s, double x, double y, double hdg, double length,
                            const std::string& shape = "<line/>") {
  return "<geometry s='" + std::to_string(s) + "' x='" + std::to_string(x) + "' y='" +
         std::to_string(y) + "' hdg='" + std::to_string(hdg) + "' length='" +
         std::to_string(length) + "'>" + shape + "</geometry>";
}

/// A road; `before` is all content before <planView>, such as <link>.
inline std::string road(const std::string& id, const std::string& geometries,
                        const std::string& lanes, const std::string& before = "",
                        const std::string& attributes = "junction='-1'") {
  return "<road id='" + id + "' " + attributes + ">" + before + "<planView>" + geometries +
         "</planView><lanes>" + lanes + "</lanes></road>";
}

inline std::string roadLink(const std::string& name, const std::string& id,
                            const std::string& contact) {
  return "<" + name + " elementType='road' elementId='" + id + "' contactPoint='" + contact + "'/>";
}

inline std::string junctionLink(const std::string& name, const std::string& id) {
  return "<" + name + " elementType='junction' elementId='" + id + "'/>";
}

inline std::string file(const std::string& content, const std::string& header = "") {
  return "<?xml version='1.0'?><OpenDRIVE><header revMajor='1' revMinor='6'>" + header +
         "</header>" + content + "</OpenDRIVE>";
}

}  // namespace open_drive

/// A crossing: roads w and e from west to east, s from the south; they meet at (0, 0) in junction J
/// with a road straight on (we) and a left turn (sw). One lane each way, 3 m wide.
inline std::string openDriveCrossing() {
  using namespace open_drive;
  const std::string plain = section(0, lane(1, "driving", width(3)), lane(-1, "driving", width(3)));
  const std::string linked = section(0, "", lane(-1, "driving", link("-1", "-1") + width(3)));
  const std::string turned = section(0, "", lane(-1, "driving", link("-1", "1") + width(3)));
  const auto inside = [](const std::string& from, const std::string& to, const char* contact) {
    return "<link>" + roadLink("predecessor", from, "end") + roadLink("successor", to, contact) +
           "</link>";
  };
  const auto connection = [](const char* from, const char* by) {
    return std::string("<connection incomingRoad='") + from + "' connectingRoad='" + by +
           "' contactPoint='start'><laneLink from='-1' to='-1'/></connection>";
  };
  return file(
      road("w", geometry(0, -60, 0, 0, 50), plain,
           "<link>" + junctionLink("successor", "J") + "</link>") +
      road("e", geometry(0, 10, 0, 0, 50), plain,
           "<link>" + junctionLink("predecessor", "J") + "</link>") +
      road("s", geometry(0, 0, -60, 1.5707963267948966, 50), plain,
           "<link>" + junctionLink("successor", "J") + "</link>") +
      road("we", geometry(0, -10, 0, 0, 20), linked, inside("w", "e", "start"), "junction='J'") +
      road("sw", geometry(0, 0, -10, 1.5707963267948966, 15.707963, "<arc curvature='0.1'/>"),
           turned, inside("s", "w", "end"), "junction='J'") +
      "<junction id='J'>" + connection("w", "we") + connection("s", "sw") + "</junction>");
}

}  // namespace forge
