#include "uart.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "protocol.h"
#include "quick_interrupt.h"

/* 256 bytes each, so that an index wraps by itself, and each in a page of its own, so that an index is
 * the low half of an address. */
static uint8_t in[256] __attribute__((aligned(256)));
static uint8_t out[256] __attribute__((aligned(256)));
static volatile uint8_t in_head, in_tail, out_head, out_tail;
static uint8_t written;
static volatile uint8_t lost;

/* A byte that is damaged, came too late or finds no room is lost, and said so. */
ISR(USART0_RX_vect, ISR_NAKED)
{
    __asm__ volatile(QUICK_ENTRY
                     "lds r25, %[status]\n\t"
                     "lds r24, %[data]\n\t"
                     "andi r25, %[damage]\n\t"
                     "brne 1f\n\t"
                     "lds r30, %[head]\n\t"
                     "mov r25, r30\n\t"
                     "inc r25\n\t"
                     "lds r31, %[tail]\n\t"
                     "cp r25, r31\n\t"
                     "breq 1f\n\t"
                     "ldi r31, hi8(%[in])\n\t"
                     "st Z, r24\n\t"
                     "sts %[head], r25\n\t"
                     "2:\n\t" QUICK_EXIT
                     "1: ldi r24, 1\n\t"
                     "sts %[lost], r24\n\t"
                     "rjmp 2b\n\t"
                     :
                     : [status] "i"(_SFR_MEM_ADDR(UCSR0A)), [data] "i"(_SFR_MEM_ADDR(UDR0)),
                       [damage] "i"((1 << FE0) | (1 << DOR0)), [head] "i"(&in_head),
                       [tail] "i"(&in_tail), [in] "i"(in), [lost] "i"(&lost));
}

ISR(USART0_UDRE_vect, ISR_NAKED)
{
    __asm__ volatile(QUICK_ENTRY
                     "lds r30, %[tail]\n\t"
                     "lds r25, %[head]\n\t"
                     "cp r30, r25\n\t"
                     "breq 1f\n\t"
                     "ldi r31, hi8(%[out])\n\t"
                     "ld r24, Z\n\t"
                     "sts %[data], r24\n\t"
                     "inc r30\n\t"
                     "sts %[tail], r30\n\t"
                     "2:\n\t" QUICK_EXIT
                     "1: lds r24, %[control]\n\t"
                     "andi r24, %[others]\n\t"
                     "sts %[control], r24\n\t"
                     "rjmp 2b\n\t"
                     :
                     : [tail] "i"(&out_tail), [head] "i"(&out_head), [out] "i"(out),
                       [data] "i"(_SFR_MEM_ADDR(UDR0)), [control] "i"(_SFR_MEM_ADDR(UCSR0B)),
                       [others] "i"((uint8_t)~(1 << UDRIE0)));
}

void uart_init(void)
{
    in_head = in_tail = out_head = out_tail = written = 0;
    lost = 0;
    /* In this order: simavr works the speed out when UBRR0 is written. */
    UCSR0A = 1 << U2X0;
    UBRR0 = F_CPU / (8 * BAUD) - 1;
    UCSR0C = (1 << UCSZ01) | (1 << UCSZ00);
    UCSR0B = (1 << RXCIE0) | (1 << RXEN0) | (1 << TXEN0);
}

bool uart_read(uint8_t *byte)
{
    uint8_t tail = in_tail;

    if (tail == in_head)
        return false;
    *byte = in[tail];
    in_tail = tail + 1;
    return true;
}

bool uart_lost(void)
{
    bool was = lost;

    if (was)
        lost = 0;
    return was;
}

uint8_t uart_room(void)
{
    return out_tail - written - 1;
}

uint8_t uart_write(uint8_t byte)
{
    out[written] = byte;
    return written++;
}

void uart_fill(uint8_t place, uint8_t byte)
{
    out[place] = byte;
}

void uart_send(void)
{
    out_head = written;
    UCSR0B |= 1 << UDRIE0;
}
