// A ROS 2 node that says what a sonar would hear of one obstacle, from the robot's odometry.
//
// Not tried in ROS 2: compiled and run only against small stand-ins for its headers.
//
// It needs sonar.h beside it, a header that Simbad Sonar exported under the name "sonar".
//
// Subscribes: odom (nav_msgs/Odometry). Publishes: sonar (sensor_msgs/Range), one for each odometry.
// Parameters, metres and radians, frames as in REP-103 (x forward, y left, z up):
//   obstacle_x, obstacle_y, obstacle_yaw   the obstacle in the frame of the odometry
//   sensor_x, sensor_y, sensor_yaw         the sensor on the robot
//   sensor_frame                           frame_id of what is published
// No echo is +Inf, as REP-117 wants it. A place that is no number is NaN, an invalid reading.
// The header tells no difference between nothing and too near: -Inf is never said.

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/range.hpp"
#include "sonar.h"

namespace {

// x forward, y left, yaw counter-clockwise as seen from above.
struct Pose2 {
  double x;
  double y;
  double yaw;
};

// Where a pose is that is told in the frame of another.
Pose2 outOf(const Pose2& frame, const Pose2& inside) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  return {frame.x + c * inside.x - s * inside.y, frame.y + s * inside.x + c * inside.y,
          frame.yaw + inside.yaw};
}

// The other way round.
Pose2 into(const Pose2& frame, const Pose2& outside) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const double x = outside.x - frame.x;
  const double y = outside.y - frame.y;
  return {c * x + s * y, c * y - s * x, outside.yaw - frame.yaw};
}

Pose2 flat(const geometry_msgs::msg::Pose& pose) {
  const auto& q = pose.orientation;
  return {pose.position.x, pose.position.y,
          std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

// Metres. The header's z points the other way than y.
float rangeOf(const Pose2& own) {
  if (!std::isfinite(own.x) || !std::isfinite(own.y) || !std::isfinite(own.yaw)) {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const float read = sonar_read_m(static_cast<float>(own.x), static_cast<float>(-own.y),
                                  static_cast<float>(own.yaw));
  return read < 0 ? std::numeric_limits<float>::infinity() : read;
}

class SonarNode : public rclcpp::Node {
 public:
  SonarNode()
      : Node("simbad_sonar"),
        obstacle_(pose("obstacle")),
        sensor_(pose("sensor")),
        frame_(declare_parameter<std::string>("sensor_frame", "sonar")) {
    publisher_ = create_publisher<sensor_msgs::msg::Range>("sonar", 10);
    subscription_ = create_subscription<nav_msgs::msg::Odometry>(
        "odom", 10, [this](nav_msgs::msg::Odometry::ConstSharedPtr odometry) { ping(*odometry); });
  }

 private:
  Pose2 pose(const std::string& of) {
    return {declare_parameter<double>(of + "_x", 0.0), declare_parameter<double>(of + "_y", 0.0),
            declare_parameter<double>(of + "_yaw", 0.0)};
  }

  void ping(const nav_msgs::msg::Odometry& odometry) {
    const Pose2 sensor = outOf(flat(odometry.pose.pose), sensor_);
    sensor_msgs::msg::Range range;
    range.header.stamp = odometry.header.stamp;
    range.header.frame_id = frame_;
    range.radiation_type = sensor_msgs::msg::Range::ULTRASOUND;
    range.field_of_view = 2 * SONAR_CONE_HALF_ANGLE_RAD;
    range.min_range = SONAR_LEAST_M;
    range.max_range = SONAR_MOST_M;
    range.range = rangeOf(into(obstacle_, sensor));
    publisher_->publish(range);
  }

  const Pose2 obstacle_;
  const Pose2 sensor_;
  const std::string frame_;
  rclcpp::Publisher<sensor_msgs::msg::Range>::SharedPtr publisher_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr subscription_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SonarNode>());
  rclcpp::shutdown();
  return 0;
}
