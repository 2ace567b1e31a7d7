// gpsim 0.31 never lets an interrupt of high priority break into one of low priority; on the chip it does, and an edge
// is not kept waiting. This lends gpsim what it lacks: to be called just after such an edge.
#pragma once

#include "simulation.h"

namespace board {

class Nesting {
public:
    Nesting();

    void after_edge();

    // To be called when the processor is reset: no interrupt runs any more, which gpsim forgets.
    void after_reset();

private:
    Timer watcher;
    // What gpsim holds back has been set free for the one of high priority, and whether that has begun.
    bool lent = false;
    bool begun = false;
};

} // namespace board
