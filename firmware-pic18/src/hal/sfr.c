/* The registers themselves: the one place where their addresses become objects for the linker. */
#define SFR_DEFINE
#include "hal/p18f4320.h"
