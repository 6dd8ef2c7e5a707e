/* e^u - 1 = 2 e^(u/2) sinh(u/2) keeps the digits that e^u - 1 loses near 0,
 * and so does z ln(w)/(w - 1), w = 1 + z as rounded, for ln(1 + z) (Kahan). */
#include "function.h"

#include <ctype.h>
#include <string.h>

/* clang-format off */
const struct function functions[FUNCTIONS] = {
    [FUNCTION_EXP] = { "exp", "exp", "u_", NULL, NULL },
    [FUNCTION_LN] = { "ln", "ln", "u_", NULL, NULL },
    [FUNCTION_SQRT] = { "sqrt", "sqrt", "u_", NULL, NULL },
    [FUNCTION_SINH] = { "sinh", "sinh", "u_", NULL, NULL },
    [FUNCTION_TAN] = { "tan", "tan", "u_", NULL, NULL },
    [FUNCTION_ABS] = { NULL, "abs", "u_", NULL, NULL },
    [FUNCTION_MAX] = { NULL, "max", "u_,w_", NULL, NULL },
    [FUNCTION_SIN] = { "sin", "sin", "u_", NULL, NULL },
    [FUNCTION_COS] = { "cos", "cos", "u_", NULL, NULL },
    [FUNCTION_COSH] = { "cosh", "cosh", "u_", NULL, NULL },
    [FUNCTION_TANH] = { "tanh", "tanh", "u_", NULL, NULL },
    [FUNCTION_ASIN] = { "asin", "asin", "u_", NULL, NULL },
    [FUNCTION_ATAN] = { "atan", "atan", "u_", NULL, NULL },
    [FUNCTION_POWER] = { NULL, "power", "u_,p_",
      "u_^p_",
      "u to the power p" },
    [FUNCTION_EM1] = { NULL, "em1", "u_",
      "2*exp(max(u_,-100)/2)*sinh(max(u_,-100)/2)",
      "e^u - 1" },
    [FUNCTION_LN1P] = { NULL, "ln1p", "z_",
      "(if((1+z_)==1)then(z_)else(z_*ln(1+z_)/((1+z_)-1)))",
      "ln(1 + z)" },
    [FUNCTION_ASINH] = { "asinh", "asinh0", "z_",
      "sign(z_)*ln1p(abs(z_)+z_*z_/(1+sqrt(1+z_*z_)))",
      "inverse of sinh" },
    [FUNCTION_CHOOSE] = { NULL, "choose", "u_,p_,q_,r_",
      "(if(u_<p_)then(q_)else(r_))",
      "q where u < p, else r" },
    [FUNCTION_LAMSTEP] = { NULL, "lamstep", "w_,k_",
      "w_-(w_+exp(w_)+k_)/(1+exp(w_))",
      "a Newton step towards w + e^w + k = 0" },
    [FUNCTION_LAMBERT] = { "lambert", "lambert", "k_",
      "exp(lamstep(lamstep(lamstep(lamstep(lamstep(lamstep("
      "0-max(k_,1),k_),k_),k_),k_),k_),k_))",
      "W(exp(-k)), Lambert's W" },
    [FUNCTION_GROWTH] = { NULL, "growth", "p_,l_,u_",
      "(if(u_>1)then(exp(l_)-p_)else(p_*em1(u_)))",
      "p (e^u - 1), l = u + ln p" },
    [FUNCTION_APART] = { NULL, "apart", "p_,u_,w_",
      "(if(u_>w_)then(p_*exp(u_/2)*exp(u_/2)*(0-em1(w_-u_)))"
      "else(p_*exp(w_/2)*exp(w_/2)*em1(u_-w_)))",
      "p (e^u - e^w)" },
    [FUNCTION_SINHS] = { NULL, "sinhs", "u_",
      "0-sign(u_)*em1(0-2*abs(u_))/2",
      "e^-|u| sinh u" },
    [FUNCTION_MIXED] = { NULL, "mixed", "r_,s_,u_",
      "(if(u_>700)then(u_+ln(r_+s_*exp(0-u_)))else("
      "(if((2*r_*em1(u_)+1)>0)then(ln1p(r_*em1(u_)))"
      "else(ln(s_+r_*exp(u_))))))",
      "ln(r e^u + s), r + s = 1" },
    [FUNCTION_ASINHEXP] = { NULL, "asinhexp", "w_",
      "(if(w_>1)then(w_+ln1p((sqrt(1+4*exp(0-2*w_))-1)/2))"
      "else(asinh0(exp(w_)/2)))",
      "inverse of sinh, of e^w/2" },
    [FUNCTION_BENDFAR] = { NULL, "bendfar", "w_,q_,u_",
      "u_+ln1p((if(u_<0)then((0-q_)*em1(2*u_))else(w_*em1(0-2*u_)))"
      "/((sqrt(1+q_)+sqrt(1+w_))*(1+sqrt(1+w_))))",
      "bend where sinh has become e^w/2; w and q: 4 e^(-2 w) before, after" },
    [FUNCTION_BENDNEAR] = { NULL, "bendnear", "w_,u_",
      "asinh0(w_/2*em1(2*u_)"
      "/(exp(u_)*sqrt(1+w_*w_/4)+sqrt(1+w_*w_*exp(2*u_)/4)))",
      "bend for a small u; w: e^w" },
    [FUNCTION_BEND] = { NULL, "bend", "w_,q_,u_",
      "(if(min(w_,w_+u_)>0.7)then(bendfar(q_,4*exp(0-2*(w_+u_)),u_))else("
      "(if(abs(u_)<1)then(bendnear(exp(w_),u_))"
      "else(asinhexp(w_+u_)-asinhexp(w_)))))",
      "asinhexp(w + u) - asinhexp(w), q = 4 e^(-2 w)" },
};
/* clang-format on */

int function_arguments(enum formula_function f)
{
    int n = 1;

    for (const char *at = functions[f].arguments; *at; at++)
        n += *at == ',';
    return n;
}

bool function_is_called(const char *text, const char *name)
{
    const size_t size = strlen(name);

    for (const char *at = text; (at = strstr(at, name)) != NULL; at += size) {
        const bool begins =
            at == text || !(isalnum((unsigned char) at[-1]) || at[-1] == '_');
        if (begins && at[size] == '(')
            return true;
    }
    return false;
}

void function_complete(bool needed[FUNCTIONS])
{
    for (int i = FUNCTIONS; i-- > 0;)
        for (int j = 0; needed[i] && functions[i].body && j < i; j++)
            needed[j] = needed[j] || function_is_called(functions[i].body,
                                                        functions[j].name);
}
