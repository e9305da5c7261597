/* CRC-16/IBM-3740: polynomial 0x1021, start 0xFFFF; "123456789" gives 0x29B1. */
#ifndef CRC_H
#define CRC_H

#include <stdint.h>

#define CRC_START 0xFFFF

/* What each byte does to the register; filled by `crc_init`. */
extern uint16_t crc_table[256];

void crc_init(void);

static inline uint16_t crc_update(uint16_t crc, uint8_t byte)
{
    return (crc << 8) ^ crc_table[(uint8_t)(crc >> 8) ^ byte];
}

#endif
