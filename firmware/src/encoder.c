#include "encoder.h"

#include <avr/interrupt.h>
#include <string.h>
#include <util/atomic.h>

#include "board.h"
#include "quick_interrupt.h"

#define ILLEGAL 2

/* [old pair << 2 | new pair] -> step; A leads B when the count grows. Both lines changed at once is
 * illegal: a step was lost, or the line is noisy. In a page of its own, as an index is the low half of
 * its address. */
static const int8_t steps[16] __attribute__((aligned(256))) = {
    0, -1, +1, ILLEGAL,
    +1, 0, ILLEGAL, -1,
    -1, ILLEGAL, 0, +1,
    ILLEGAL, +1, -1, 0,
};

static volatile struct encoder_reading now;
static volatile uint8_t old_x, old_y, old_theta; /* pair << 2 */

/* Read a pair from a port, shifted down by `shift` instructions, and count its step. */
#define COUNT(port, shift, old_pair, axis)                                                  \
    __asm__ volatile(QUICK_ENTRY                                                            \
                     "in r24, %[pins]\n\t" shift                                            \
                     "andi r24, 3\n\t"                                                      \
                     "lds r30, %[old]\n\t"                                                  \
                     "or r30, r24\n\t"                                                      \
                     "lsl r24\n\t"                                                          \
                     "lsl r24\n\t"                                                          \
                     "sts %[old], r24\n\t"                                                  \
                     "ldi r31, hi8(%[table])\n\t"                                           \
                     "ld r24, Z\n\t"                                                        \
                     "cpi r24, %[illegal]\n\t"                                              \
                     "breq 1f\n\t"                                                          \
                     "mov r25, r24\n\t"                                                     \
                     "lsl r25\n\t"                                                          \
                     "sbc r25, r25\n\t" /* the sign, in every bit */                        \
                     "lds r30, %[low]\n\t"                                                  \
                     "lds r31, %[low]+1\n\t"                                                \
                     "add r30, r24\n\t"                                                     \
                     "adc r31, r25\n\t"                                                     \
                     "sts %[low]+1, r31\n\t"                                                \
                     "sts %[low], r30\n\t"                                                  \
                     "2:\n\t" QUICK_EXIT                                                    \
                     "1: lds r24, %[glitches]\n\t"                                          \
                     "inc r24\n\t"                                                          \
                     "sts %[glitches], r24\n\t"                                             \
                     "rjmp 2b\n\t"                                                          \
                     :                                                                      \
                     : [pins] "I"(_SFR_IO_ADDR(port)), [old] "i"(&old_pair),                \
                       [table] "i"(steps), [illegal] "M"(ILLEGAL),                          \
                       [low] "i"(&now.count[axis]), [glitches] "i"(&now.glitches))

ISR(INT0_vect, ISR_NAKED)
{
    COUNT(PIND, "", old_x, 0);
}
ISR(INT1_vect, ISR_ALIASOF(INT0_vect));

ISR(INT2_vect, ISR_NAKED)
{
    COUNT(PIND, "lsr r24\n\tlsr r24\n\t", old_y, 1);
}
ISR(INT3_vect, ISR_ALIASOF(INT2_vect));

ISR(INT4_vect, ISR_NAKED)
{
    COUNT(PINE, "swap r24\n\t", old_theta, 2);
}
ISR(INT5_vect, ISR_ALIASOF(INT4_vect));

void encoder_init(void)
{
    PORTD |= 0x0F;
    PORTE |= 0x30;
    old_x = (PIND & 3) << 2;
    old_y = PIND & 12;
    old_theta = (PINE >> 4 & 3) << 2;
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
