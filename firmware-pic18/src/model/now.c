#include "model/now.h"

uint16_t now_ms;
