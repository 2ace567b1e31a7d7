#include "transmitter.h"

#include "simulation.h"
#include <gpsim/16bit-processors.h>

namespace board {

// A shift register that is empty beside a transmit register that is not: on the chip this lasts for no time at all.
void wake_transmitter()
{
    auto *cpu = dynamic_cast<_16bit_processor *>(get_active_cpu());
    if (!cpu) {
        return;
    }
    USART_MODULE &port = cpu->usart;
    if (port.rcsta.bSPEN() && port.txsta.bTXEN() && port.txsta.bTRMT() && !port.bIsTXempty()) {
        port.txsta.start_transmitting();
        port.emptyTX();
    }
}

} // namespace board
