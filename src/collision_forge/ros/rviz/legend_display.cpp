#include "collision_forge/ros/rviz/legend_display.h"

#include <rviz/display_context.h>
#include <rviz/render_panel.h>
#include <rviz/view_manager.h>

#include <QColor>
#include <QLabel>

#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/markers/marker_colors.h"

namespace forge {

namespace {

constexpr int kMargin = 8;               // pixels
constexpr float kRecordedAlpha = 0.35F;  // of vehicles as recorded, beside the attack

/// CSS colour, blended with the white background.
QString cssColor(const colors::MarkerColor& color) {
  const auto on_white = [&color](float value) { return 1.0 - color.alpha * (1.0 - value); };
  return QColor::fromRgbF(on_white(color.red), on_white(color.green), on_white(color.blue)).name();
}

QString entry(const colors::MarkerColor& color, const QString& words) {
  return QString("<font color=%1>&#9632;</font>&nbsp;%2<br>").arg(cssColor(color), words);
}

}  // namespace

QString legendText() {
  QString text =
      entry(colors::kEgo, "ego") + entry(colors::kAttacker, "attacker, its plan") +
      entry(colors::kAdded, "its past, if added") + entry(colors::kSupport, "support vehicle") +
      entry(colors::withAlpha(colors::kEgo, kRecordedAlpha), "pale: as recorded") +
      entry(colors::kPatternEgo, "pattern: ego") +
      entry(colors::kPatternAttacker, "pattern: attacker") + entry(colors::kContact, "contact");
  for (std::size_t i = 0; i < colors::kAgentClasses.size(); ++i) {
    QString name = toString(static_cast<AgentClass>(i));
    text += entry(colors::kAgentClasses[i], name.replace('_', ' '));
  }
  text.chop(QString("<br>").size());
  return text;
}

LegendDisplay::~LegendDisplay() { delete legend_; }

/// A native child window: OpenGL draws the 3D view without Qt.
void LegendDisplay::onInitialize() {
  legend_ = new QLabel(legendText(), context_->getViewManager()->getRenderPanel());
  legend_->setAttribute(Qt::WA_NativeWindow);
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  legend_->setAutoFillBackground(true);
  legend_->setMargin(kMargin);
  legend_->move(kMargin, kMargin);
  legend_->adjustSize();
  legend_->hide();
}

void LegendDisplay::onEnable() {
  if (legend_) legend_->show();
}

void LegendDisplay::onDisable() {
  if (legend_) legend_->hide();
}

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::LegendDisplay, rviz::Display)
