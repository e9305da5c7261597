/* The settings: defaults, EEPROM, and what is worked out from them once. */
#ifndef CONFIG_H
#define CONFIG_H

#include <stdbool.h>

#include "protocol.h"

/* What each tick needs of the settings. */
struct derived {
    int16_t angle_per_count[3];  /* 65536 a turn, times 256 */
    uint16_t rise;               /* share of all force that comes in a tick, 65535 is all */
    uint16_t fall;
};

extern struct configuration config;
extern struct derived derived;

/* Load from EEPROM; false when nothing sound is there and the defaults are in use. */
bool config_load(void);

void config_use(const struct configuration *wanted);

/* Begin to write the settings to EEPROM; `config_write` writes a byte when EEPROM can take one and
 * tells whether it wrote the last one. */
void config_save(void);
bool config_is_writing(void);
bool config_write(void);

#endif
