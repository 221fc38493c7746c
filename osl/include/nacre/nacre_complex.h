// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Complex numbers in single precision. `sqrt` of a complex number has its own name, because OSL
// does not let a shader overload a built-in function.
struct nacre_complex {
    float re;
    float im;
};

nacre_complex __operator__add__(nacre_complex a, nacre_complex b)
{
    nacre_complex c = {a.re + b.re, a.im + b.im};
    return c;
}

nacre_complex __operator__sub__(nacre_complex a, nacre_complex b)
{
    nacre_complex c = {a.re - b.re, a.im - b.im};
    return c;
}

nacre_complex __operator__mul__(nacre_complex a, nacre_complex b)
{
    nacre_complex c = {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    return c;
}

nacre_complex __operator__div__(nacre_complex a, nacre_complex b)
{
    float d = b.re * b.re + b.im * b.im;
    nacre_complex c = {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
    return c;
}

nacre_complex nacre_real(float x)
{
    nacre_complex c = {x, 0.0};
    return c;
}

float nacre_norm(nacre_complex z)
{
    return z.re * z.re + z.im * z.im;
}

// exp(i z); the modulus is exp(-Im z).
nacre_complex nacre_exp_i(nacre_complex z)
{
    float s, c;
    sincos(z.re, s, c);
    float modulus = exp(-z.im);
    nacre_complex e = {modulus * c, modulus * s};
    return e;
}

// Root in the upper half plane: Im > 0, or Re >= 0 where Im = 0. The larger part is formed first
// and the other from it, so that nothing cancels.
nacre_complex nacre_sqrt_upper(nacre_complex z)
{
    float modulus = sqrt(nacre_norm(z));
    float larger = sqrt(0.5 * (modulus + fabs(z.re)));
    float smaller = larger > 0.0 ? 0.5 * fabs(z.im) / larger : 0.0;
    nacre_complex root = {z.re >= 0.0 ? larger : smaller, z.re >= 0.0 ? smaller : larger};
    if (z.im < 0.0) root.re = -root.re;
    return root;
}
