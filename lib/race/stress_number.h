/* stress_number.h -- the numbers of a slope that 113 bits can confirm. */
#ifndef RACE_STRESS_NUMBER_H
#define RACE_STRESS_NUMBER_H

enum stress_number {
    STRESS_V_SP,
    STRESS_PSI_SP,
    STRESS_LAMBDA_MINUS,
    STRESS_LAMBDA_PLUS,
    STRESS_V_PLUS,
    STRESS_LN_V_PLUS,
    STRESS_V_MINUS,
    STRESS_LN_V_MINUS,
    STRESS_PSI_AT_V0,
    STRESS_X_EXCESS,
    STRESS_X_DEFICIT,
    STRESS_MU_S_NUM,
    STRESS_MU_S_MEAN,
    STRESS_FRACTURE_ENERGY,
    STRESS_KNEE_UPPER_V, /* the first ones */
    STRESS_KNEE_UPPER_PSI,
    STRESS_KNEE_LOWER_V,
    STRESS_KNEE_LOWER_PSI,
    STRESS_NUMBERS
};

#endif
