/* Which pin of the Arduino Mega 2560 does what (encoders and motors: Tyagi 2017, App. B; rest ours). */
#ifndef BOARD_H
#define BOARD_H

#include <avr/io.h>

#define AXES 3

/* Encoders: x on D20 (A) and D21 (B), y on D18 and D19, theta on D3 and D2. All six are external
 * interrupts: PD1 and PD0, PD3 and PD2, PE5 and PE4; encoder.c reads a pair as (A << 1) | B. */

/* Amplifiers' enable line: D22, high enables; a resistor to ground on the board keeps it low while
 * the pin floats. */
#define ENABLE_PORT PORTA
#define ENABLE_DDR DDRA
#define ENABLE_BIT PA0

/* Emergency stop: D24, a contact to ground that opens; a broken wire reads as pressed. */
#define ESTOP_PIN PINA
#define ESTOP_PORT PORTA
#define ESTOP_BIT PA2

/* Dead-man's switch: D26, a contact to ground that closes; a broken wire reads as let go. */
#define DEAD_MAN_PIN PINA
#define DEAD_MAN_PORT PORTA
#define DEAD_MAN_BIT PA4

#endif
