// A stand-in of our own for tests: only what sonar_node.cpp uses.
#pragma once
#include <cstdint>

#include "nav_msgs/msg/odometry.hpp"

namespace sensor_msgs::msg {
struct Range {
  static constexpr std::uint8_t ULTRASOUND = 0;
  std_msgs::msg::Header header;
  std::uint8_t radiation_type = 255;
  float field_of_view = 0;
  float min_range = 0;
  float max_range = 0;
  float range = 0;
};
}  // namespace sensor_msgs::msg
