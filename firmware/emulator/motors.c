#include "inside.h"

#include <stddef.h>

/* control register, its connecting bit, compare register, port, direction, bit of the pin */
static const struct {
    uint16_t control;
    uint8_t connect;
    uint16_t compare, port, direction;
    uint8_t bit;
} pins[2 * AXES] = {
    { 0xA0, 0x80, 0xA8, 0x102, 0x101, 3 }, /* D6 OC4A */
    { 0xA0, 0x20, 0xAA, 0x102, 0x101, 4 }, /* D7 OC4B */
    { 0xA0, 0x08, 0xAC, 0x102, 0x101, 5 }, /* D8 OC4C */
    { 0xB0, 0x20, 0xB4, 0x102, 0x101, 6 }, /* D9 OC2B */
    { 0xB0, 0x80, 0xB3, 0x25, 0x24, 4 },   /* D10 OC2A */
    { 0x80, 0x80, 0x88, 0x25, 0x24, 5 },   /* D11 OC1A */
};

int emulator_duty(const struct emulator *emulator, int pin)
{
    const uint8_t *data = emulator->avr->data;

    if (!(data[pins[pin].direction] >> pins[pin].bit & 1))
        return 0;
    if (data[pins[pin].control] & pins[pin].connect)
        return data[pins[pin].compare];
    return (data[pins[pin].port] >> pins[pin].bit & 1) * 255;
}

static void on_motor_write(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct emulator *emulator = param;

    for (int axis = 0; axis < AXES; axis++) {
        int plus = emulator_duty(emulator, 2 * axis), minus = emulator_duty(emulator, 2 * axis + 1);
        int greater = plus > minus ? plus : minus;

        if (plus && minus)
            emulator->overlaps++;
        if (greater > emulator->greatest)
            emulator->greatest = greater;
    }
}

bool emulator_enabled(const struct emulator *emulator)
{
    const uint8_t *data = emulator->avr->data;

    return (data[0x21] & 1) && (data[0x22] & 1); /* DDRA, PORTA */
}

int emulator_greatest_duty(struct emulator *emulator)
{
    int greatest = emulator->greatest;

    emulator->greatest = 0;
    on_motor_write(NULL, 0, emulator);
    return greatest > emulator->greatest ? greatest : emulator->greatest;
}

uint32_t emulator_overlaps(struct emulator *emulator)
{
    uint32_t overlaps = emulator->overlaps;

    emulator->overlaps = 0;
    return overlaps;
}

void motors_watch(struct emulator *emulator)
{
    for (int i = 0; i < 2 * AXES; i++) {
        const uint16_t watched[] = { pins[i].control, pins[i].compare, pins[i].port };

        for (int j = 0; j < 3; j++)
            avr_irq_register_notify(
                avr_iomem_getirq(emulator->avr, watched[j], NULL, AVR_IOMEM_IRQ_ALL),
                on_motor_write, emulator);
    }
}
