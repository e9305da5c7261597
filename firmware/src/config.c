#include "config.h"

#include <avr/eeprom.h>
#include <stddef.h>

#include "crc.h"

struct stored {
    uint8_t version;
    struct configuration settings;
    uint16_t crc; /* over all before it */
} __attribute__((packed));

static const struct configuration defaults = DEFAULT_CONFIGURATION;
static struct stored image;
static uint8_t writing; /* bytes yet to be written */

struct configuration config;
struct derived derived;

_Static_assert(sizeof(struct stored) < 256, "an index of one byte");

static uint16_t crc_of(const struct stored *stored)
{
    const uint8_t *bytes = (const uint8_t *)stored;
    uint16_t crc = CRC_START;

    for (uint8_t i = 0; i < offsetof(struct stored, crc); i++)
        crc = crc_update(crc, bytes[i]);
    return crc;
}

void config_use(const struct configuration *wanted)
{
    config = *wanted;
    for (uint8_t i = 0; i < 3; i++)
        /* 65536 * 256 / 360 degrees; counts_per_degree has 256 steps a unit. */
        derived.angle_per_count[i] = 11930465UL / config.counts_per_degree[i];
    derived.rise = 65535U / config.soft_start;
    derived.fall = 65535U / config.fade;
}

bool config_load(void)
{
    bool sound;

    writing = 0;
    eeprom_read_block(&image, (const void *)0, sizeof(image));
    sound = image.version == PROTOCOL_VERSION && image.crc == crc_of(&image) &&
            configuration_is_legal(&image.settings);
    config_use(sound ? &image.settings : &defaults);
    return sound;
}

void config_save(void)
{
    image.version = PROTOCOL_VERSION;
    image.settings = config;
    image.crc = crc_of(&image);
    writing = sizeof(image);
}

bool config_is_writing(void)
{
    return writing != 0;
}

bool config_write(void)
{
    uint8_t at = sizeof(image) - writing;

    if (writing == 0 || !eeprom_is_ready())
        return false;
    eeprom_update_byte((uint8_t *)(uint16_t)at, ((const uint8_t *)&image)[at]);
    return --writing == 0;
}
