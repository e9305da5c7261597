/* Interrupts that come dozens of times a tick, by hand: they save the four registers they use, where
 * the compiler saves ten. */
#ifndef QUICK_INTERRUPT_H
#define QUICK_INTERRUPT_H

#define QUICK_ENTRY        \
    "push r24\n\t"         \
    "in r24, __SREG__\n\t" \
    "push r24\n\t"         \
    "push r25\n\t"         \
    "push r30\n\t"         \
    "push r31\n\t"

#define QUICK_EXIT          \
    "pop r31\n\t"           \
    "pop r30\n\t"           \
    "pop r25\n\t"           \
    "pop r24\n\t"           \
    "out __SREG__, r24\n\t" \
    "pop r24\n\t"           \
    "reti\n\t"

#endif
