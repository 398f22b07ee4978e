#pragma once

#include <rviz/display.h>

#include <QPointer>
#include <QString>

class QLabel;

namespace forge {

/// Returns the legend of the colours of the markers as rich text.
QString legendText();

/// RViz display that shows the legend in the upper left corner of the 3D view.
class LegendDisplay : public rviz::Display {
  Q_OBJECT

 public:
  ~LegendDisplay() override;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private:
  QPointer<QLabel> legend_;  ///< owned by the picture, which may be destroyed first
};

}  // namespace forge
