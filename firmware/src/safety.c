#include "safety.h"

#include <stdlib.h>

#include "board.h"
#include "config.h"
#include "motor.h"
#include "stick.h"

#define MISSED_LIMIT 10

struct safety safety;

static uint16_t share;    /* of force, 65535 is all */
static uint16_t unheard;  /* ticks since the last sound frame */
static uint16_t window;   /* ticks of the present second */
static uint8_t glitches_before, missed_before; /* this second */

void safety_init(bool barked, bool defaults)
{
    ESTOP_PORT |= 1 << ESTOP_BIT;
    DEAD_MAN_PORT |= 1 << DEAD_MAN_BIT;
    safety.state = barked ? STATE_FAULT : STATE_IDLE;
    safety.faults = (barked ? FAULT_WATCHDOG : 0) | (defaults ? FAULT_DEFAULTS : 0);
    safety.missed = 0;
    share = window = 0;
    glitches_before = stick.glitches;
    missed_before = 0;
}

bool estop_is_pressed(void)
{
    return ESTOP_PIN & (1 << ESTOP_BIT);
}

bool dead_man_is_held(void)
{
    return !(DEAD_MAN_PIN & (1 << DEAD_MAN_BIT));
}

bool safety_is_off(void)
{
    return safety.state == STATE_IDLE || safety.state == STATE_FAULT;
}

static void turn_off(uint8_t state, uint16_t fault)
{
    stick_let_go();
    share = 0;
    safety.state = state;
    safety.faults |= fault;
}

static uint16_t motion_faults(void)
{
    uint16_t faults = 0;

    for (uint8_t i = 0; i < AXES; i++) {
        if ((uint16_t)abs(stick.motion.rate[i]) > config.velocity_trip[i])
            faults |= FAULT_VELOCITY;
        if ((uint16_t)abs(stick.motion.position[i]) > config.travel[i])
            faults |= FAULT_TRAVEL;
    }
    return faults;
}

/* A hand may move a stick that has no force as it likes. */
static uint16_t present_faults(void)
{
    uint16_t faults = safety_is_off() ? 0 : motion_faults();

    if (estop_is_pressed())
        faults |= FAULT_ESTOP;
    if ((uint8_t)(stick.glitches - glitches_before) > config.glitch_limit)
        faults |= FAULT_ENCODER;
    if ((uint8_t)(safety.missed - missed_before) >= MISSED_LIMIT)
        faults |= FAULT_OVERRUN;
    return faults;
}

static void let_time_pass(uint8_t ticks)
{
    safety.missed += ticks - 1;
    if (unheard < 0xFF00)
        unheard += ticks;
    window += ticks;
    if (window >= TICK_HZ) {
        window = 0;
        glitches_before = stick.glitches;
        missed_before = safety.missed;
    }
}

void safety_hear(void)
{
    unheard = 0;
}

static void rise(void)
{
    safety.state = STATE_RISING;
    if (share > 65535U - derived.rise) {
        share = 65535U;
        safety.state = STATE_FORCE;
    } else {
        share += derived.rise;
    }
}

static void fall(void)
{
    safety.state = STATE_FADING;
    if (share > derived.fall)
        share -= derived.fall;
    else
        turn_off(STATE_IDLE, FAULT_SILENT);
}

uint16_t safety_judge(uint8_t ticks)
{
    uint16_t faults;

    let_time_pass(ticks);
    faults = present_faults();
    if (faults)
        turn_off(STATE_FAULT, faults);
    if (safety_is_off())
        return 0;
    if (!dead_man_is_held())
        turn_off(STATE_IDLE, FAULT_DEAD_MAN);
    else if (unheard > config.silence)
        fall();
    else if (share != 65535U)
        rise();
    return share == 65535U ? 256 : share >> 8;
}

uint8_t safety_arm(uint32_t key)
{
    if (key != ARM_KEY)
        return OUTCOME_WRONG_KEY;
    if (safety.faults & LATCHING)
        return OUTCOME_FAULTY;
    if (safety.state != STATE_IDLE || config_is_writing())
        return OUTCOME_NOT_NOW;
    if (estop_is_pressed())
        return OUTCOME_ESTOP;
    if (!dead_man_is_held())
        return OUTCOME_DEAD_MAN;
    if (motion_faults())
        return OUTCOME_MOVING;
    stick_let_go();
    safety.faults &= ~(FAULT_DEAD_MAN | FAULT_SILENT);
    share = 0;
    safety.state = STATE_RISING;
    amplifiers_on();
    return OUTCOME_DONE;
}

uint8_t safety_disarm(void)
{
    if (!safety_is_off())
        turn_off(STATE_IDLE, 0);
    return OUTCOME_DONE;
}

uint8_t safety_clear(void)
{
    uint16_t still;

    glitches_before = stick.glitches;
    missed_before = safety.missed;
    still = present_faults();
    safety.faults = (safety.faults & ~LATCHING) | still;
    if (still)
        return OUTCOME_FAULTY;
    if (safety.state == STATE_FAULT)
        safety.state = STATE_IDLE;
    return OUTCOME_DONE;
}
