/*
 * fuzz.h -- a fuzz target: reads any bytes as a kind of input and checks what
 * must hold whatever they are.
 *
 * Each target is built twice: with libFuzzer, which invents inputs
 * (-Dfuzz=true, clang), and with replay.c, which reads those of files.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "status.h"
#include "text.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the program where it does not hold: a finding. */
#define MUST(cond)                                                             \
    do {                                                                       \
        if (!(cond)) {                                                         \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #cond);         \
            abort();                                                           \
        }                                                                      \
    } while (0)

/* One printable line, not empty. */
static inline void must_be_a_line(const struct fault *why)
{
    char shown[sizeof why->text + 8];
    size_t i = 0;

    text_show(why->text, shown, sizeof shown);
    while (i < sizeof why->text && why->text[i] == shown[i] && shown[i])
        i++;
    MUST(i > 0 && i < sizeof why->text && !why->text[i] && !shown[i]);
}
