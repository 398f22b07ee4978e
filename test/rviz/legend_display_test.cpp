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

TEST(Legend, ShowsColoursAsThePictureDoes) {
  const std::string text = legendText().toStdString();
  EXPECT_THAT(text, HasSubstr("<font color=#1f66cc>&#9632;</font>&nbsp;ego"));  // 0.12, 0.40, 0.80
  // The same with alpha 0.35 on white: 1 - 0.35 * (1 - 0.12), ...
  EXPECT_THAT(text, HasSubstr("<font color=#b0c9ed>&#9632;</font>&nbsp;pale"));
}

}  // namespace
}  // namespace forge
