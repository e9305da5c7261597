#include "sine.h"

#include <avr/pgmspace.h>

#include "multiply.h"

/* round(32767 sin(i/64 quarter turns)) */
static const int16_t quarter[65] PROGMEM = {
    0, 804, 1608, 2410, 3212, 4011, 4808, 5602,
    6393, 7179, 7962, 8739, 9512, 10278, 11039, 11793,
    12539, 13279, 14010, 14732, 15446, 16151, 16846, 17530,
    18204, 18868, 19519, 20159, 20787, 21403, 22005, 22594,
    23170, 23731, 24279, 24811, 25329, 25832, 26319, 26790,
    27245, 27683, 28105, 28510, 28898, 29268, 29621, 29956,
    30273, 30571, 30852, 31113, 31356, 31580, 31785, 31971,
    32137, 32285, 32412, 32521, 32609, 32678, 32728, 32757,
    32767,
};

int16_t sine(uint16_t angle)
{
    uint16_t within = angle & 0x3FFF;
    int16_t low, high, value;
    uint8_t index, part;

    if (angle & 0x4000)
        within = 0x4000 - within;
    index = within >> 8;
    part = within;
    low = pgm_read_word(&quarter[index]);
    high = part ? (int16_t)pgm_read_word(&quarter[index + 1]) : low;
    value = low + (int16_t)((multiply(high - low, part) + 128) >> 8);
    return angle & 0x8000 ? -value : value;
}
