#include "collision_forge/ros/rviz/fit_view_display.h"

#include <rviz/display_context.h>
#include <rviz/properties/tf_frame_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

namespace {

constexpr char kTopDown[] = "rviz/TopDownOrtho";

// Names of its properties.
constexpr char kTargetFrame[] = "Target Frame";
constexpr char kX[] = "X";
constexpr char kY[] = "Y";
constexpr char kScale[] = "Scale";

}  // namespace

void FitViewDisplay::onEnable() {
  subscriber_ = update_nh_.subscribe(names::kShownArea, 1, &FitViewDisplay::receive, this);
}

void FitViewDisplay::onDisable() {
  subscriber_.shutdown();
  area_.reset();
  following_.reset();
}

void FitViewDisplay::reset() {
  rviz::Display::reset();
  following_.reset();
}

void FitViewDisplay::receive(const geometry_msgs::PolygonStampedConstPtr& area) {
  if (area->polygon.points.size() > 2) area_ = area;
}

bool FitViewDisplay::canFit(rviz::ViewController& view) const {
  const QString frame = view.subProp(kTargetFrame)->getValue().toString();
  return view.getClassId() == kTopDown &&
         (frame == rviz::TfFrameProperty::FIXED_FRAME_STRING || frame == fixed_frame_);
}

void FitViewDisplay::update(float wall_dt, float /*ros_dt*/) {
  rviz::ViewManager* views = context_->getViewManager();
  rviz::ViewController* view = views->getCurrent();
  if (!area_ || !view || !canFit(*view)) return;
  const rviz::RenderPanel* picture = views->getRenderPanel();
  const auto number = [view](const char* name) {
    return view->subProp(name)->getValue().toDouble();
  };
  const TopView next =
      following_.next({number(kX), number(kY), number(kScale)},
                      viewOf(area_->polygon, picture->width(), picture->height()), wall_dt);
  view->subProp(kX)->setValue(static_cast<float>(next.x));
  view->subProp(kY)->setValue(static_cast<float>(next.y));
  view->subProp(kScale)->setValue(static_cast<float>(next.scale));
}

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::FitViewDisplay, rviz::Display)
