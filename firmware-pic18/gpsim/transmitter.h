// gpsim 0.31 takes a byte that is written to the transmit register for sent when the one before it leaves the shift
// register within the same microsecond: it never goes out, its flag never comes back, and the program waits for it for
// ever. The chip sends it.
#pragma once

namespace board {

// Sends the byte that was left; to be called every now and then.
void wake_transmitter();

} // namespace board
