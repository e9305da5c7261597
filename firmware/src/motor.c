#include "motor.h"

#include "board.h"

/* A compare output: the register and bits that connect its pin, and its compare register. All
 * compare registers are written as bytes: a timer's high byte comes from its TEMP register, which
 * `motors_off` leaves at zero and nothing else touches. */
struct output {
    volatile uint8_t *control;
    uint8_t connect;
    volatile uint8_t *compare;
};

/* x: D6 OC4A, D7 OC4B; y: D8 OC4C, D9 OC2B; theta: D10 OC2A, D11 OC1A. */
static const struct output outputs[AXES][2] = {
    { { &TCCR4A, 1 << COM4A1, &OCR4AL }, { &TCCR4A, 1 << COM4B1, &OCR4BL } },
    { { &TCCR4A, 1 << COM4C1, &OCR4CL }, { &TCCR2A, 1 << COM2B1, &OCR2B } },
    { { &TCCR2A, 1 << COM2A1, &OCR2A }, { &TCCR1A, 1 << COM1A1, &OCR1AL } },
};

void motors_off(void)
{
    ENABLE_PORT &= ~(1 << ENABLE_BIT);
    /* Outputs disconnected: the pins follow PORT, which is low. */
    TCCR4A = 1 << WGM40;
    TCCR2A = 1 << WGM20;
    TCCR1A = 1 << WGM10;
    OCR4A = OCR4B = OCR4C = 0;
    OCR2A = OCR2B = 0;
    OCR1A = 0;
}

void motor_init(void)
{
    PORTH &= ~0x78;
    PORTB &= ~0x30;
    motors_off();
    DDRH |= 0x78; /* D6..D9 */
    DDRB |= 0x30; /* D10, D11 */
    ENABLE_DDR |= 1 << ENABLE_BIT;
    /* Phase-correct, 8 bits, no prescaler: 16 MHz / 510 = 31.37 kHz. */
    TCCR4B = 1 << CS40;
    TCCR2B = 1 << CS20;
    TCCR1B = 1 << CS10;
}

void motor_drive(uint8_t axis, int16_t duty)
{
    const struct output *on = &outputs[axis][duty < 0];
    const struct output *off = &outputs[axis][duty >= 0];

    /* The idle side is disconnected first, which acts at once, and its compare value, which acts at
     * the end of a period, is zero long before the side is connected again. */
    *off->control &= ~off->connect;
    *off->compare = 0;
    *on->compare = (uint8_t)(duty < 0 ? -duty : duty);
    *on->control |= on->connect;
}

void amplifiers_on(void)
{
    ENABLE_PORT |= 1 << ENABLE_BIT;
}

bool amplifiers_are_on(void)
{
    return ENABLE_PORT & (1 << ENABLE_BIT);
}
