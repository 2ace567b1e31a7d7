// A stand-in of our own for tests: only what sonar_node.cpp uses.
// Parameters come from the command line as NAME VALUE; odometry from standard input as x, y and half
// the yaw's sine and cosine (the quaternion's z and w); what is published goes to standard output.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>

#include "nav_msgs/msg/odometry.hpp"
#include "sensor_msgs/msg/range.hpp"

namespace rclcpp {
inline std::map<std::string, double> parameters;
inline std::function<void(nav_msgs::msg::Odometry::ConstSharedPtr)> listener;

template <typename Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message& m) {
    std::printf("%s %d %u %.6f %.6f %.6f %.6f\n", m.header.frame_id.c_str(), m.header.stamp.sec,
                static_cast<unsigned>(m.radiation_type), static_cast<double>(m.field_of_view),
                static_cast<double>(m.min_range), static_cast<double>(m.max_range),
                static_cast<double>(m.range));
  }
};

template <typename Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
};

class Node {
 public:
  explicit Node(const std::string&) {}

  template <typename Value>
  Value declare_parameter(const std::string& name, const Value& preset) {
    if constexpr (std::is_same_v<Value, double>) {
      return parameters.count(name) == 0 ? preset : parameters.at(name);
    } else {
      return preset;
    }
  }

  template <typename Message>
  std::shared_ptr<Publisher<Message>> create_publisher(const std::string&, int) {
    return std::make_shared<Publisher<Message>>();
  }

  template <typename Message, typename Callback>
  std::shared_ptr<Subscription<Message>> create_subscription(const std::string&, int, Callback of) {
    listener = of;
    return std::make_shared<Subscription<Message>>();
  }
};

inline void init(int argc, char** argv) {
  for (int i = 1; i + 1 < argc; i += 2) {
    parameters[argv[i]] = std::atof(argv[i + 1]);
  }
}

inline void spin(const std::shared_ptr<Node>&) {
  nav_msgs::msg::Odometry read;
  auto& pose = read.pose.pose;
  while (std::scanf("%lf %lf %lf %lf", &pose.position.x, &pose.position.y, &pose.orientation.z,
                    &pose.orientation.w) == 4) {
    read.header.stamp.sec++;
    listener(std::make_shared<const nav_msgs::msg::Odometry>(read));
  }
}

inline void shutdown() {}
}  // namespace rclcpp
