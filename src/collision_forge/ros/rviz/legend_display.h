#pragma once

#include <rviz/display.h>

#include <QPointer>
#include <QString>

class QLabel;

namespace forge {

/// What the colours of the picture mean, as rich text.
QString legendText();

/// The legend in the upper left corner of the picture.
class LegendDisplay : public rviz::Display {
  Q_OBJECT

 public:
  ~LegendDisplay() override;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private:
  QPointer<QLabel> legend_;  ///< owned by the picture, which may be gone before
};

}  // namespace forge
