#include "collision_forge/io/drawing/caption_text.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/verify/untested_contact.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/io/drawing/decimal_text.h"
#include "collision_forge/io/drawing/scenario_motion.h"

namespace forge {

namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

/// Returns a name for people, as "construction vehicle".
std::string plainName(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Returns the first condition of verified() that fails; at least one must fail.
std::string shortcoming(const CollisionReport& report) {
  if (!report.contact) return "no contact";
  if (!report.type_kept) return "another type";
  if (!report.on_time) return "another time";
  if (!report.limits_kept) return "a limit broken";
  return "hits " + shortId(report.first_other_id) + " first";
}

std::string speedText(const std::optional<double>& now, const std::optional<double>& then,
                      bool has_contact) {
  const auto text = [](const std::optional<double>& speed) {
    return speed ? decimalText(*speed, 1) : std::string("?");
  };
  return text(now) + " now, " + text(then) + (has_contact ? " at contact" : " then");
}

std::vector<CaptionRow> speedRows(const ScenarioView& view) {
  const ScenarioMotion motion(view);
  const double then = motion.keyTime();
  const bool has_contact = view.report.contact;
  return {
      {"Ego, m/s", speedText(motion.egoSpeedAt(motion.now()), motion.egoSpeedAt(then), has_contact),
       std::nullopt},
      {"Attacker, m/s",
       speedText(motion.attackerSpeedAt(motion.now()), motion.attackerSpeedAt(then), has_contact),
       std::nullopt}};
}

/// Returns the contact time and the relative heading at contact.
std::vector<CaptionRow> impactRows(const ScenarioView& view) {
  const CollisionReport& report = view.report;
  const std::string time = signedSeconds(report.contact_time - view.snapshot.now, 2);
  const std::string heading = decimalText(report.relative_heading * kDegreesPerRadian, 0) + "°";
  if (!view.planner.empty()) {
    return {{"Contact", time, false}, {"Relative heading", heading, std::nullopt}};
  }
  return {{"Contact", time + (report.on_time ? ", on time" : ", not on time"), report.on_time},
          {"Relative heading",
           heading + (report.type_kept ? ", fits the type" : ", does not fit the type"),
           report.type_kept}};
}

/// Without the name of the curve, which has no space in the caption.
std::string severityText(const CrashEffect& effect) {
  return "MAIS 3+ " + decimalText(100.0 * effect.mais3, 1) + " %, " + severityClass(effect);
}

std::vector<CaptionRow> contactRows(const ScenarioView& view) {
  const CollisionReport& report = view.report;
  if (view.avoided_hit) {
    const std::string time = signedSeconds(*view.avoided_hit - view.snapshot.now, 2);
    return {{"Contact", "none (hit: " + time + ")", true}};
  }
  if (!report.contact) return {{"Contact", "none", !view.planner.empty()}};
  const std::string ego_side = toString(report.ego_side);
  std::vector<CaptionRow> rows = impactRows(view);
  rows.insert(rows.end(),
              {{"Sides", std::string(toString(report.attacker_side)) + " to ego's " + ego_side,
                std::nullopt},
               {"Impact speed", decimalText(report.impact_speed, 1) + " m/s", std::nullopt},
               {"Ego's delta-v", deltaVText(report.severity.ego), std::nullopt},
               {"Severity", severityText(report.severity.worse()), std::nullopt},
               {"Overlap", percentText(report.overlap) + " of ego's " + ego_side, std::nullopt}});
  return rows;
}

std::vector<CaptionRow> drivingRows(const ScenarioView& view) {
  const CollisionReport& report = view.report;
  const double now = view.snapshot.now;
  std::vector<CaptionRow> rows;
  if (report.contact) {
    rows.push_back({"Manoeuvre",
                    plainName(toString(report.manoeuvre)) + " from " +
                        signedSeconds(report.manoeuvre_begin - now, 1),
                    std::nullopt});
  }
  if (report.contact && !report.conditions.hidden_by_id.empty()) {
    rows.push_back({"Seen for",
                    decimalText(report.conditions.visible_for, 1) + " s, before hidden by " +
                        shortId(report.conditions.hidden_by_id),
                    std::nullopt});
  }
  rows.push_back({"Plausible", report.believable() ? "yes" : "no: it " + report.unbelievable,
                  report.believable()});
  rows.push_back({"Limits kept", report.limits_kept ? "yes" : "no", report.limits_kept});
  if (!report.broken_limit.empty()) rows.push_back({"", report.broken_limit, false});
  const bool no_hit = report.first_other_id.empty();
  rows.push_back({"Hits before ego",
                  no_hit ? "none"
                         : signedSeconds(report.first_other_time - now, 1) + ", " +
                               shortId(report.first_other_id),
                  no_hit});
  rows.push_back({"Off road", percentText(report.off_road_share), std::nullopt});
  rows.push_back({"Confidence", percentText(report.confidence), std::nullopt});
  return rows;
}

}  // namespace

std::string typeTitle(CollisionType type) {
  switch (type) {
    case CollisionType::kLaneChange:
      return "Lane change";
    case CollisionType::kOppositeDirection:
      return "Opposite direction";
    case CollisionType::kRearEnd:
      return "Rear end";
    case CollisionType::kJunctionCrossing:
      return "Junction crossing";
    case CollisionType::kLtap:
      return "Left turn across path";
    case CollisionType::kSideswipeSameDirection:
      return "Sideswipe, same direction";
    case CollisionType::kAngleSameDirection:
      return "Angle, same direction";
    case CollisionType::kAngleOppositeDirection:
      return "Angle, opposite direction";
    case CollisionType::kAny:
      break;
  }
  return toString(type);
}

Verdict verdictOf(const ScenarioView& view) {
  if (!view.planner.empty()) return view.report.contact ? Verdict::kUnwanted : Verdict::kWanted;
  if (view.report.verified()) return Verdict::kWanted;
  return view.report.contact ? Verdict::kPartial : Verdict::kUnwanted;
}

std::string titleText(const ScenarioView& view) {
  const std::string title = typeTitle(view.pattern.type) + " in " + view.scene_name;
  return view.planner.empty() ? title : view.planner + ": " + title;
}

std::string detailsText(const ScenarioView& view) {
  const AttackerTrajectory& attacker = view.trajectory;
  const std::string vehicle = plainName(toString(attacker.agent_class));
  return "TTA " + decimalText(view.tta, 1) + " s  ·  " + toString(view.mode) + " mode  ·  by " +
         (attacker.isAdded() ? "an added " + vehicle
                             : "a recorded " + vehicle + ", " + shortId(attacker.attacker_id));
}

std::string verdictText(const ScenarioView& view) {
  if (view.avoided_hit) return "avoids the hit";
  if (!view.planner.empty()) return view.report.contact ? "hit by the attacker" : "no contact";
  if (view.report.verified()) return "requested crash in the recording";
  if (endsBeforeContact(view.future.ego, view.pattern, view.report)) {
    return "the recording ends before the contact";
  }
  if (!view.report.contact) return "no contact in the recording";
  return "other contact in the recording: " + shortcoming(view.report);
}

std::vector<CaptionRow> reportRows(const ScenarioView& view) {
  std::vector<CaptionRow> rows = contactRows(view);
  const auto append = [&rows](const std::vector<CaptionRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  append(speedRows(view));
  if (view.planner.empty()) append(drivingRows(view));
  return rows;
}

}  // namespace forge
