#include "utf8.h"

#include <stdbool.h>

size_t utf8_read(const char *text, uint32_t *code)
{
    static const uint32_t bits[] = { 0, 0x7f, 0x1f, 0x0f, 0x07 };
    static const uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const uint8_t *s = (const uint8_t *) text;
    const size_t size = s[0] < 0x80         ? 1
                        : s[0] >> 5 == 0x06 ? 2
                        : s[0] >> 4 == 0x0e ? 3
                        : s[0] >> 3 == 0x1e ? 4
                                            : 0;

    *code = s[0] & bits[size];
    for (size_t i = 1; i < size; i++) {
        if (s[i] >> 6 != 0x02)
            return 0;
        *code = *code << 6 | (s[i] & 0x3fu);
    }
    const bool surrogate = *code >= 0xd800 && *code <= 0xdfff;
    return *code < least[size] || *code > 0x10ffff || surrogate ? 0 : size;
}
