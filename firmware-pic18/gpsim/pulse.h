// How long an SRF04's echo line is high after a ping. Knows nothing of gpsim.
#pragma once

#include <cmath>
#include <optional>

namespace board {

// Times in microseconds. Devantech, "SRF04 technical information"; the longest echo by the thesis's 3.16 m in 18.4 ms.
constexpr double least_trigger_us = 10;
constexpr double burst_us = 200;
constexpr double shortest_echo_us = 100;
constexpr double longest_echo_us = 20000;
constexpr double no_echo_us = 36000;

// Speed of sound in dry air, m/s.
inline double sound_speed(double temperature_c)
{
    return 331.3 * std::sqrt(1 + temperature_c / 273.15);
}

// The width of the pulse in microseconds: there and back, no shorter than the blanking lets it be, the no-echo pulse
// when there is nothing or it is too far.
inline double pulse_us(std::optional<double> distance_m, double temperature_c, double longest_us)
{
    if (!distance_m) {
        return no_echo_us;
    }
    double echo_us = 2e6 * *distance_m / sound_speed(temperature_c);
    if (echo_us > longest_us) {
        return no_echo_us;
    }
    return std::fmax(echo_us, shortest_echo_us);
}

} // namespace board
