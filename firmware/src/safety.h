/* Whether there may be force: the states, the faults and the share of force that is let through. */
#ifndef SAFETY_H
#define SAFETY_H

#include <stdbool.h>
#include <stdint.h>

#define LATCHING 0x00FF /* the faults that turn the force off until they are cleared */

struct safety {
    uint8_t state;
    uint16_t faults;
    uint8_t missed; /* ticks so far, modulo 256 */
};

extern struct safety safety;

/* Start in IDLE, or in FAULT when the watchdog started this run. */
void safety_init(bool barked, bool defaults);

/* A sound frame came: the host lives. */
void safety_hear(void);

/* Let `ticks` ticks (1: none missed) pass, look at everything that forbids force, and give the share
 * of force that is let through, 0 .. 256; at 0 the motors are already off. */
uint16_t safety_judge(uint8_t ticks);

/* Answer the requests; each gives an Outcome. */
uint8_t safety_arm(uint32_t key);
uint8_t safety_disarm(void);
uint8_t safety_clear(void);

/* IDLE or FAULT: settings may change. */
bool safety_is_off(void);

bool estop_is_pressed(void);
bool dead_man_is_held(void);

#endif
