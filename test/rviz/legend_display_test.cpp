#include "collision_forge/ros/rviz/legend_display.h"

#include <gmock/gmock.h>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/markers/marker_colors.h"

namespace forge {
namespace {

using testing::HasSubstr;

TEST(Legend, HasEveryClass) {
  const std::string text = legendText().toStdString();
  for (std::size_t i = 0; i < colors::kAgentClasses.size(); ++i) {
    QString name = toString(static_cast<AgentClass>(i));
    EXPECT_THAT(text, HasSubstr(name.replace('_', ' ').toStdString()));
  }
}

TEST(Legend, NamesSupportVehicles) {
  EXPECT_THAT(legendText().toStdString(), HasSubstr("support"));
}

}  // namespace
}  // namespace forge
