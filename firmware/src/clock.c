#include "clock.h"

#include <avr/interrupt.h>
#include <avr/wdt.h>

#include "motor.h"
#include "protocol.h"

#define BARKED 0xB4A2

static volatile uint8_t ticks;
static uint16_t barked __attribute__((section(".noinit")));
uint8_t reset_cause __attribute__((section(".noinit")));

/* Before main and before memory is cleared: a watchdog that is still on would bite again. */
void read_reset_cause(void) __attribute__((naked, used, section(".init3")));
void read_reset_cause(void)
{
    reset_cause = MCUSR;
    MCUSR = 0;
    wdt_disable();
}

ISR(TIMER3_COMPA_vect)
{
    ticks++;
}

void clock_init(void)
{
    OCR3A = CYCLES_PER_TICK - 1;
    TCNT3 = 0;
    TCCR3A = 0;
    TCCR3B = (1 << WGM32) | (1 << CS30);
    TIMSK3 = 1 << OCIE3A;
}

uint8_t clock_ticks(void)
{
    uint8_t come;

    cli();
    come = ticks;
    ticks = 0;
    sei();
    return come;
}

bool clock_is_due(void)
{
    /* The flag too, for the interrupt may still wait behind those of the encoders; and first, for it
     * may come between the two looks. */
    return (TIFR3 & (1 << OCF3A)) || ticks != 0;
}

/* The first bite is an interrupt, for the bootloader of a stock Mega hangs after a watchdog reset
 * (ArduinoCore-avr #183). A program that hangs with interrupts off gets the second, a real reset:
 * pins float, and the resistor on the enable line turns the amplifiers off. */
ISR(WDT_vect, ISR_NAKED)
{
    __asm__ volatile("clr __zero_reg__");
    motors_off();
    barked = BARKED;
    __asm__ volatile("jmp 0");
}

void watchdog_init(void)
{
    wdt_reset();
    WDTCSR = (1 << WDCE) | (1 << WDE);
    WDTCSR = (1 << WDIE) | (1 << WDE); /* 16 ms */
}

void watchdog_kick(void)
{
    wdt_reset();
}

bool watchdog_barked(void)
{
    bool jumped = barked == BARKED && !(reset_cause & (1 << PORF));
    bool was = jumped || (reset_cause & (1 << WDRF));

    if (jumped)
        reset_cause = 1 << WDRF;
    barked = 0;
    return was;
}
