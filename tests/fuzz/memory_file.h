/* memory_file.h -- bytes that have a path, so that what opens files by name can
 * read them. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* The path of a new file of these bytes, always the same one; it is removed
 * when the program that asked first ends. */
const char *memory_file(const uint8_t *data, size_t size);
