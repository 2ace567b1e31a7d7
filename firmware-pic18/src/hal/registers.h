/* The registers: the chip's, or on the host a stand-in's. */
#ifndef HAL_REGISTERS_H
#define HAL_REGISTERS_H

#ifdef __SDCC_pic16
#include "hal/p18f4320.h"
#else
#include "standin/p18f4320.h"
#endif

#endif
