/* Firmware of the 3-DOF force-feedback stick: one loop, woken a thousand times a second. */
#include <avr/interrupt.h>
#include <string.h>

#include "clock.h"
#include "commands.h"
#include "config.h"
#include "crc.h"
#include "motor.h"
#include "safety.h"
#include "stick.h"
#include "uart.h"

/* Frames are read while the tick has this much time left; so the next one is never late by them. */
#define READING_ENDS 14500
#define OBEYING_ENDS 11500

static uint32_t tick;
static uint16_t busy;

static void report(uint16_t late, uint16_t worked)
{
    struct telemetry told = {
        .tick = tick,
        .state = safety.state,
        .signs = stick.signs,
        .faults = safety.faults,
        .field = field_sequence,
        .refused = refused,
        .glitches = stick.glitches,
        .missed = safety.missed,
        .late = late,
        .worked = worked,
        .busy = busy,
    };

    memcpy(told.position, stick.motion.position, sizeof(told.position));
    memcpy(told.rate, stick.motion.rate, sizeof(told.rate));
    memcpy(told.motor, stick.motor, sizeof(told.motor));
    told.signs |= field_is_fresh() ? SIGN_FIELD : 0;
    told.signs |= amplifiers_are_on() ? SIGN_ENABLED : 0;
    told.signs |= dead_man_is_held() ? SIGN_HELD : 0;
    told.signs |= estop_is_pressed() ? SIGN_STOPPED : 0;
    frame_send(MESSAGE_TELEMETRY, &told, sizeof(told));
}

static void run_tick(uint8_t ticks)
{
    uint16_t late = clock_phase();
    uint16_t share;

    watchdog_kick();
    tick += ticks;
    stick_feel();
    share = safety_judge(ticks);
    if (!safety_is_off())
        stick_push(share);
    report(late, clock_phase());
    go_on_saving();
    busy = clock_phase();
}

/* Asked in this order: a tick that comes between is seen. */
static bool there_is_time(uint16_t until)
{
    return clock_phase() < until && !clock_is_due();
}

static void listen(void)
{
    static struct frame frame;
    static bool whole;
    uint8_t byte;

    if (uart_lost())
        frame_spoil();
    while (!whole && there_is_time(READING_ENDS) && uart_read(&byte)) {
        enum reception reception = frame_take(&frame, byte);

        whole = reception == RECEPTION_FRAME;
        if (reception == RECEPTION_DAMAGED)
            refused++;
    }
    if (whole && there_is_time(OBEYING_ENDS)) {
        obey(&frame);
        whole = false;
    }
}

int main(void)
{
    bool sound;

    motor_init();
    crc_init();
    sound = config_load();
    encoder_init();
    stick_settle();
    field_forget();
    safety_init(watchdog_barked(), !sound);
    uart_init();
    clock_init();
    watchdog_init();
    sei();
    for (;;) {
        uint8_t ticks = clock_ticks();

        if (ticks)
            run_tick(ticks);
        else
            listen();
    }
}
