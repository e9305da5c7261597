#include "encoder.h"

#include <avr/interrupt.h>
#include <string.h>
#include <util/atomic.h>

#include "board.h"

#define ILLEGAL 2

/* [old pair << 2 | new pair] -> step; A leads B when the count grows. Both lines changed at once is
 * illegal: a step was lost, or the line is noisy. */
static const int8_t steps[16] = {
    0, -1, +1, ILLEGAL,
    +1, 0, ILLEGAL, -1,
    -1, ILLEGAL, 0, +1,
    ILLEGAL, +1, -1, 0,
};

static volatile struct encoder_reading now;
static volatile uint8_t pair_x, pair_y, pair_theta;

static inline __attribute__((always_inline)) void
take(uint8_t axis, volatile uint8_t *pair, uint8_t read)
{
    int8_t step = steps[(uint8_t)(*pair << 2) | read];
    *pair = read;
    if (step == ILLEGAL)
        now.glitches++;
    else
        now.count[axis] += step;
}

ISR(INT0_vect)
{
    take(0, &pair_x, READ_X());
}
ISR(INT1_vect, ISR_ALIASOF(INT0_vect));

ISR(INT2_vect)
{
    take(1, &pair_y, READ_Y());
}
ISR(INT3_vect, ISR_ALIASOF(INT2_vect));

ISR(INT4_vect)
{
    take(2, &pair_theta, READ_THETA());
}
ISR(INT5_vect, ISR_ALIASOF(INT4_vect));

void encoder_init(void)
{
    PORTD |= 0x0F;
    PORTE |= 0x30;
    pair_x = READ_X();
    pair_y = READ_Y();
    pair_theta = READ_THETA();
    EICRA = 0x55; /* any edge */
    EICRB = 0x05;
    EIFR = 0x3F;
    EIMSK = 0x3F;
}

void encoder_read(struct encoder_reading *reading)
{
    ATOMIC_BLOCK(ATOMIC_FORCEON) {
        memcpy(reading, (const void *)&now, sizeof(*reading));
    }
}

void encoder_zero(void)
{
    ATOMIC_BLOCK(ATOMIC_FORCEON) {
        now.count[0] = now.count[1] = now.count[2] = 0;
    }
}
