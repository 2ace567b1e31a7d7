// What a driving program may ask for.
#pragma once

#include <string>

namespace board {

// Carries out one line:
//   distance METRES|none    what the next pings meet        temperature CELSIUS
//   longest US              the sensor's longest echo       trigger US   the shortest trigger that it takes
//   burst US                from the trigger until the pulse begins
//   fault none|no-echo|high|low                             wake TIME_US "wake" is sent then
//   reset power-on|brown-out|watchdog|master-clear DELAY_US
//   garbage COUNT           bytes on the serial line that nobody sent
//   baud RATE               of the far end                  silence US   the far end hears nothing so long
//   pace FACTOR             simulated per real second, 0: as fast as it goes
//   stop                    ends the simulation
// What is none of these is said on standard error and left.
void obey(const std::string &line);

// Ends the run; gpsim goes on with its script.
void halt();

// What halts before the run begins would be forgotten: the run ends at its first tick then.
void halt_if_ending();

} // namespace board
