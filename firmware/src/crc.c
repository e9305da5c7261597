#include "crc.h"

#include <util/crc16.h>

uint16_t crc_table[256];

void crc_init(void)
{
    uint8_t byte = 0;

    do
        crc_table[byte] = _crc_xmodem_update(0, byte);
    while (++byte);
}
