// A stand-in of our own for tests: only what sonar_node.cpp uses.
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "geometry_msgs/msg/pose.hpp"

namespace builtin_interfaces::msg {
struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};
}  // namespace builtin_interfaces::msg

namespace std_msgs::msg {
struct Header {
  builtin_interfaces::msg::Time stamp;
  std::string frame_id;
};
}  // namespace std_msgs::msg

namespace nav_msgs::msg {
struct PoseWithCovariance {
  geometry_msgs::msg::Pose pose;
};
struct Odometry {
  using ConstSharedPtr = std::shared_ptr<const Odometry>;
  std_msgs::msg::Header header;
  PoseWithCovariance pose;
};
}  // namespace nav_msgs::msg
