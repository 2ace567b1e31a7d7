package simbad.experiments.bag;

/**
 * A commanded speed: a geometry_msgs/msg/Twist, with a stamp or without.
 *
 * @param topic on which it was sent
 * @param stampNs when, nanoseconds; of one without a stamp when it was recorded
 * @param speedMPerS ahead
 * @param turnRadPerS counter-clockwise
 */
record TwistMessage(String topic, long stampNs, double speedMPerS, double turnRadPerS) {}
