/* The 1 kHz tick and the watchdog. */
#ifndef CLOCK_H
#define CLOCK_H

#include <avr/io.h>
#include <stdbool.h>
#include <stdint.h>

void clock_init(void);

/* Give the ticks that came since the last asking. */
uint8_t clock_ticks(void);

/* Tell whether a tick waits. */
bool clock_is_due(void);

/* Cycles since the last tick's moment. */
static inline uint16_t clock_phase(void)
{
    return TCNT3;
}

/* Start the watchdog: 15 ms without `watchdog_kick` turn the motors off and start the program anew. */
void watchdog_init(void);
void watchdog_kick(void);

/* Tell whether the watchdog started this run; asked once, after the start. */
bool watchdog_barked(void);

/* Why the processor was last reset: MCUSR. */
extern uint8_t reset_cause;

#endif
