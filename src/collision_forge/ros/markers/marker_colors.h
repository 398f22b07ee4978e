#pragma once

#include <std_msgs/ColorRGBA.h>

#include <array>
#include <cstddef>
#include <cstdint>

/// Colours of the markers in RViz, for a white background. Ego, attacker, pattern and contact have
/// the colours of the figures (config/drawing.yaml).
namespace forge::colors {

/// A colour; each part in [0, 1].
struct MarkerColor {
  float red = 0.0F;
  float green = 0.0F;
  float blue = 0.0F;
  float alpha = 1.0F;  ///< 0: transparent, 1: opaque
};

// The map.
inline constexpr MarkerColor kDrivableArea{0.90F, 0.91F, 0.92F};
inline constexpr MarkerColor kWalkway{0.93F, 0.89F, 0.82F};
inline constexpr MarkerColor kLane{0.66F, 0.69F, 0.72F};       ///< centrelines of lanes
inline constexpr MarkerColor kConnector{0.78F, 0.80F, 0.82F};  ///< centrelines of connectors
inline constexpr MarkerColor kRoadEdge{0.45F, 0.47F, 0.50F};
inline constexpr MarkerColor kPainted{0.97F, 0.97F, 0.98F};  ///< crosswalks and speed bumps

// Attacks and planner tests.
inline constexpr MarkerColor kEgo{0.12F, 0.40F, 0.80F};
inline constexpr MarkerColor kAttacker{0.84F, 0.15F, 0.16F};
inline constexpr MarkerColor kAdded{0.93F, 0.45F, 0.45F};       ///< past of an added attacker
inline constexpr MarkerColor kSupport{0.15F, 0.17F, 0.20F};     ///< support vehicles of the attack
inline constexpr MarkerColor kPatternEgo{0.52F, 0.20F, 0.68F};  ///< ego in a collision pattern
inline constexpr MarkerColor kPatternAttacker{0.98F, 0.58F, 0.10F};  ///< attacker in a pattern
inline constexpr MarkerColor kContact{1.00F, 0.87F, 0.12F};          ///< the contact point
inline constexpr MarkerColor kRecordedEgo{0.33F, 0.34F, 0.38F};      ///< in planner tests
inline constexpr MarkerColor kProposal{0.10F, 0.60F, 0.42F, 0.6F};   ///< Planner::proposals()

inline constexpr MarkerColor kText{0.13F, 0.15F, 0.18F};
inline constexpr MarkerColor kPlate{1.00F, 1.00F, 1.00F, 0.8F};  ///< under texts
inline constexpr MarkerColor kNose{1.00F, 1.00F, 1.00F, 0.75F};  ///< the arrow head on a box

/// Colours of agents, in the order of the constants in Agent.msg.
inline constexpr std::array<MarkerColor, 14> kAgentClasses{{
    {0.44F, 0.53F, 0.62F},  // car
    {0.05F, 0.45F, 0.45F},  // truck
    {0.52F, 0.50F, 0.05F},  // bus
    {0.35F, 0.68F, 0.64F},  // trailer
    {0.50F, 0.31F, 0.16F},  // construction vehicle
    {0.85F, 0.25F, 0.62F},  // emergency vehicle
    {0.10F, 0.50F, 0.16F},  // motorcycle
    {0.42F, 0.74F, 0.20F},  // bicycle
    {0.05F, 0.68F, 0.85F},  // pedestrian
    {0.70F, 0.66F, 0.42F},  // animal
    {0.60F, 0.60F, 0.60F},  // static object
    {0.35F, 0.85F, 0.95F},  // child
    {0.02F, 0.42F, 0.62F},  // runner
    {0.62F, 0.80F, 0.45F},  // scooter
}};

inline constexpr std::size_t kStaticObject = 10;  ///< index in kAgentClasses

/// Colours of traffic lights, in the order of the constants in TrafficLight.msg.
inline constexpr std::array<MarkerColor, 4> kLights{{
    {0.60F, 0.60F, 0.60F},  // unknown
    {0.84F, 0.10F, 0.10F},  // red
    {0.95F, 0.75F, 0.05F},  // yellow
    {0.10F, 0.62F, 0.25F},  // green
}};

/// Returns the colour of a traffic light; an unknown constant counts as TrafficLight::UNKNOWN.
inline MarkerColor lightColor(std::uint8_t color) {
  return color < kLights.size() ? kLights[color] : kLights.front();
}

/// Returns the colour of a class; an unknown class gets the colour of static objects.
inline MarkerColor agentColor(std::uint8_t agent_class) {
  return agent_class < kAgentClasses.size() ? kAgentClasses[agent_class]
                                            : kAgentClasses[kStaticObject];
}

/// Returns `color` with another alpha.
inline MarkerColor withAlpha(MarkerColor color, float alpha) {
  color.alpha = alpha;
  return color;
}

inline std_msgs::ColorRGBA toMessage(const MarkerColor& color) {
  std_msgs::ColorRGBA message;
  message.r = color.red;
  message.g = color.green;
  message.b = color.blue;
  message.a = color.alpha;
  return message;
}

}  // namespace forge::colors
