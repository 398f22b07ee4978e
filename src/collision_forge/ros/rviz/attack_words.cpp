#include "collision_forge/ros/rviz/attack_words.h"

#include <cmath>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {

namespace {

constexpr double kDegrees = 180.0 / M_PI;
constexpr char kVerifiedColor[] = "#1a7f37";
constexpr char kViolatedColor[] = "#c62828";

QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().replace("\n", "<br>");
}

QString row(const QString& name, const QString& value) {
  return "<tr><td>" + name + "&nbsp;</td><td>" + value + "</td></tr>";
}

QString number(double value, int decimals, const char* unit) {
  return QString::number(value, 'f', decimals) + unit;
}

QString titleOf(const collision_forge::Attack& attack) {
  const collision_forge::AttackerTrajectory& attacker = attack.trajectory;
  return "<b>" + escaped(attack.pattern.collision_type) + "</b> by " +
         (attacker.added ? "an added " : "the recorded ") +
         toString(static_cast<AgentClass>(attacker.agent_class)) + " " +
         escaped(shortId(attacker.attacker_id));
}

QString plausibleText(const collision_forge::CollisionReport& report) {
  return report.believable ? QString("yes") : "no: it " + escaped(report.unbelievable);
}

}  // namespace

QString attackText(const collision_forge::Attack& attack) {
  if (isNone(attack)) return {};
  const auto& report = attack.report;
  if (!report.contact) return titleOf(attack) + "<br>No contact is predicted.";
  return titleOf(attack) + "<br><i>Predicted</i><table>" +
         row("Contact after",
             number((report.contact_time - attack.header.stamp).toSec(), 2, " s")) +
         row("Manoeuvre", escaped(report.manoeuvre)) + row("Plausible", plausibleText(report)) +
         row("Confidence", number(100.0 * report.confidence, 0, " %")) +
         row("Sides", escaped(report.attacker_side + " to ego's " + report.ego_side) +
                          number(report.relative_heading * kDegrees, 0, " deg").prepend(", ")) +
         row("Impact", number(report.impact_speed, 1, " m/s, overlap ") +
                           number(100.0 * report.overlap, 0, " %")) +
         "</table>";
}

QString crashText(const collision_forge::Attack& attack,
                  const collision_forge::CollisionReport* tested, const ros::Time& now) {
  if (isNone(attack)) return {};
  const collision_forge::CollisionReport* verdict = verdictBy(now, attack, tested);
  const QString words = escaped(crashWords(attack, verdict, now));
  if (!verdict) return words;
  return QString("<font color=%1>Measured: %2</font>")
      .arg(verdict->verified ? kVerifiedColor : kViolatedColor, words);
}

QString outcomeText(const collision_forge::PlannerOutcome& outcome) {
  QString text = QString("<b>%1</b>: ").arg(escaped(outcome.planner));
  if (outcome.collided) {
    text += "touches " +
            (outcome.is_attacker ? QString("the attacker") : escaped(shortId(outcome.other_id))) +
            " after " + number((outcome.contact_time - outcome.header.stamp).toSec(), 2, " s, ") +
            number(outcome.impact_speed, 1, " m/s, ") +
            (outcome.at_fault ? "at fault" : "not at fault");
  } else if (outcome.failure != "none") {
    text += "fails, " + escaped(outcome.failure + ": " + outcome.failure_message);
  } else {
    text += "no contact in " + number(outcome.duration, 1, " s");
  }
  return text;
}

QString failureText(std::uint8_t code, const std::string& message) {
  return QString("<b>%1</b> (%2)<br>%3")
      .arg(toString(static_cast<StatusCode>(code)))
      .arg(code)
      .arg(escaped(message));
}

}  // namespace forge
