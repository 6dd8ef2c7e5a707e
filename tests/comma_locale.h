/* comma_locale.h -- numbers as in a locale with a decimal comma.
 *
 * Few machines have such a locale, so its two functions that matter are made
 * here: give a test the dependency `comma_locale` (tests/meson.build), and the
 * linker sends localeconv and strtod of our own code to them. */
#pragma once

#include <stdbool.h>

/* From now on numbers have a comma, or again what the true locale says. */
void comma_locale_use(bool comma);
