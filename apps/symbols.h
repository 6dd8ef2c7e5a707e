/* symbols.h -- the quantities' letters as figures show them (mark.h). */
#pragma once

#include "mark.h"

#define S_V       ITALIC("v")
#define S_BIG_V   ITALIC("V")
#define S_V_STAR  ITALIC("V") SUB("∗")
#define S_V_RATIO S_V " = " S_BIG_V "/" S_V_STAR
#define S_PSI     ITALIC("ψ")
#define S_PHI     ITALIC("φ")
#define S_T       ITALIC("t")
#define S_X       ITALIC("x")
#define S_L       ITALIC("L")
#define S_ALPHA   ITALIC("α")
#define S_TAN     "tan " S_ALPHA
#define S_MU      ITALIC("μ")
#define S_MU_SS   ITALIC("μ") SUB("ss")
#define S_MU_S    ITALIC("μ") SUB("s")
#define S_V_PLUS  ITALIC("v") SUB("+")
#define S_V_MINUS ITALIC("v") SUB("−")
#define S_L_K     ITALIC("l") SUB(ITALIC("k"))
#define S_X_K     ITALIC("x") SUB(ITALIC("k"))
#define S_S_K     ITALIC("s") SUB(ITALIC("k"))
#define S_SLIP    S_X "/" S_L
#define S_TIME    S_T S_V_STAR "/" S_L
#define S_CM(m)   S_ALPHA SUB("c" ITALIC(m))

/* d of a quantity by dt. */
#define S_RATE_OF(quantity) "d" quantity "/d" S_T
