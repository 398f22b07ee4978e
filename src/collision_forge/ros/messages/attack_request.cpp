#include "collision_forge/ros/messages/attack_request.h"

#include "collision_forge/ros/messages/conversions.h"

namespace forge {

collision_forge::AttackRequest attackRequest(const CollisionRequest& request,
                                             const collision_forge::Attack& attack,
                                             const std::string& configuration,
                                             std::uint32_t alternative) {
  collision_forge::AttackRequest message;
  message.header = attack.header;
  message.request = toMessage(request);
  message.alternative = alternative;
  message.method = attack.method;
  message.version = COLLISION_FORGE_VERSION;
  message.configuration = configuration;
  return message;
}

}  // namespace forge
