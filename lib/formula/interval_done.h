/* Ends a kind of number: what interval_sums.h was told of it, and says. */
#undef REAL
#undef FN
#undef NAME
#undef OWN
#undef UNIT
#undef PHI
#undef LEAST
#undef MOST
#undef ENDLESS
