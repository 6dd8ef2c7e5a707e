/* utf8.h -- characters of a text in UTF-8, one by one. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Bytes of the character that the text, ended by a zero, begins with, and its
 * code point; 0 where that is no UTF-8: a stray or a missing byte, an overlong
 * form, a surrogate, a code beyond 0x10ffff. */
size_t utf8_read(const char *text, uint32_t *code);
