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

#define MULTIPLY_AND_ADD \
    "ld r20, X+\n\t"    \
    "ld r21, X+\n\t"    \
    "ld r22, Z+\n\t"    \
    "ld r23, Z+\n\t"    \
    "mul r20, r22\n\t"  \
    "add %A[sum], r0\n\t" \
    "adc %B[sum], r1\n\t" \
    "adc %C[sum], %[zero]\n\t" \
    "adc %D[sum], %[zero]\n\t" \
    "muls r21, r23\n\t" \
    "add %C[sum], r0\n\t" \
    "adc %D[sum], r1\n\t" \
    "mulsu r21, r22\n\t" \
    "sbc %D[sum], %[zero]\n\t" \
    "add %B[sum], r0\n\t" \
    "adc %C[sum], r1\n\t" \
    "adc %D[sum], %[zero]\n\t" \
    "mulsu r23, r20\n\t" \
    "sbc %D[sum], %[zero]\n\t" \
    "add %B[sum], r0\n\t" \
    "adc %C[sum], r1\n\t" \
    "adc %D[sum], %[zero]\n\t"

/* a[0]b[0] + a[1]b[1] + a[2]b[2] in 92 cycles; the compiler takes three times as long. */
static inline __attribute__((always_inline)) int32_t dot3(const int16_t *a, const int16_t *b)
{
    int32_t sum = 0;
    uint8_t zero;

    __asm__("clr %[zero]\n\t" MULTIPLY_AND_ADD MULTIPLY_AND_ADD MULTIPLY_AND_ADD "clr r1"
            : [sum] "+r"(sum), [zero] "=&r"(zero), "+x"(a), "+z"(b)
            :
            : "r20", "r21", "r22", "r23", "memory");
    return sum;
}

#endif
