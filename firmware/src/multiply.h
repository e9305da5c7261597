#ifndef MULTIPLY_H
#define MULTIPLY_H

#include <stdint.h>

/* a·b in 20 cycles; the compiler's own call takes 70. */
static inline __attribute__((always_inline)) int32_t multiply(int16_t a, int16_t b)
{
    int32_t product;
    uint8_t zero;

    __asm__("clr %[zero]\n\t"
            "muls %B[a], %B[b]\n\t"
            "movw %C[product], r0\n\t"
            "mul %A[a], %A[b]\n\t"
            "movw %A[product], r0\n\t"
            "mulsu %B[a], %A[b]\n\t"
            "sbc %D[product], %[zero]\n\t"
            "add %B[product], r0\n\t"
            "adc %C[product], r1\n\t"
            "adc %D[product], %[zero]\n\t"
            "mulsu %B[b], %A[a]\n\t"
            "sbc %D[product], %[zero]\n\t"
            "add %B[product], r0\n\t"
            "adc %C[product], r1\n\t"
            "adc %D[product], %[zero]\n\t"
            "clr r1"
            : [product] "=&r"(product), [zero] "=&r"(zero)
            : [a] "a"(a), [b] "a"(b));
    return product;
}

#endif
