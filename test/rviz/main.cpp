#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QApplication>

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rviz_tests", ros::init_options::NoSigintHandler);
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
