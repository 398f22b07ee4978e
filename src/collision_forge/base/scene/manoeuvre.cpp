#include "collision_forge/base/scene/manoeuvre.h"

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {

namespace {

constexpr EnumWord<Manoeuvre> kWords[] = {
    {Manoeuvre::kLeadStopped, "lead_stopped"},
    {Manoeuvre::kLeadBrakes, "lead_brakes"},
    {Manoeuvre::kLeadSlow, "lead_slow"},
    {Manoeuvre::kFollowerCloses, "follower_closes"},
    {Manoeuvre::kCutIn, "cut_in"},
    {Manoeuvre::kDrift, "drift"},
    {Manoeuvre::kMerge, "merge"},
    {Manoeuvre::kPullOut, "pull_out"},
    {Manoeuvre::kCentreLineCrossing, "centre_line_crossing"},
    {Manoeuvre::kOvertaking, "overtaking"},
    {Manoeuvre::kWrongWay, "wrong_way"},
    {Manoeuvre::kStraightCrossing, "straight_crossing"},
    {Manoeuvre::kTurnIntoPath, "turn_into_path"},
    {Manoeuvre::kTurnAcrossPath, "turn_across_path"},
    {Manoeuvre::kSameDirectionTurn, "same_direction_turn"},
    {Manoeuvre::kBackOut, "back_out"},
};

}  // namespace

const char* toString(Manoeuvre manoeuvre) { return wordOf(kWords, manoeuvre); }

std::optional<Manoeuvre> manoeuvreFromString(const std::string& name) {
  return valueOf(kWords, name);
}

}  // namespace forge
