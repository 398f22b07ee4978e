#pragma once

#include <rviz/display.h>

#include <QPointer>
#include <QString>

class QLabel;

namespace forge {

/// Returns the legend of the colours of the markers (marker_colors.h) as rich text, a line each.
QString legendText();

/// RViz display that shows the legend in the upper left corner of the 3D view while it is enabled.
class LegendDisplay : public rviz::Display {
  Q_OBJECT

 public:
  ~LegendDisplay() override;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private:
  QPointer<QLabel> legend_;  ///< child of the 3D view, which may be destroyed first (then null)
};

}  // namespace forge
