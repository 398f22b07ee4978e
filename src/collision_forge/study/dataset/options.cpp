#include "collision_forge/study/dataset/options.h"

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, DatasetOptions& options, double time_margin) {
  constexpr double kShareRounding = 1e-9;  // 1 - 0.8 is less than 0.2
  options.begin_stride = section.positive("begin_stride");
  // t0 is 3.5 s after the begin and the shortest TTA is 0.5 s, so a clip has at least 8 frames.
  options.min_length = section.atLeast("min_length", 4.0);
  options.max_length = section.atLeast("max_length", options.min_length);
  options.min_ego_speed = section.nonNegative("min_ego_speed");
  std::vector<std::pair<std::string, AttackerChoice>> choices;
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    choices.emplace_back(toString(choice), choice);
  }
  options.choice = section.choice("choice", choices);
  Section attempts = section.section("attempts");
  for (const CollisionType type : kCollisionTypes) {
    options.attempts[type] = attempts.count(toString(type), 0);
  }
  attempts.finish();
  options.heading_spread = section.positive("heading_spread");
  options.time_tolerance = section.within("time_tolerance", time_margin, kMaxTimeTolerance);
  options.max_off_road_share = section.share("max_off_road_share");
  options.balance.min_type_share =
      section.within("min_type_share", 0.0, 1.0 / static_cast<double>(std::size(kCollisionTypes)));
  options.balance.max_tta_ratio = section.atLeast("max_tta_ratio", 1.0);
  options.split.train_share = section.share("train_share");
  options.split.val_share =
      section.within("val_share", 0.0, 1.0 - options.split.train_share + kShareRounding);
}

}  // namespace forge
