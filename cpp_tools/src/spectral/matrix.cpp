// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/matrix.h"

#include <cstddef>

namespace nacre::spectral {

namespace {

/// Of the matrix without a row and a column, with the sign of the cofactor, as indices wrap round.
double cofactor(const Mat3& m, std::size_t row, std::size_t column) noexcept
{
    const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3;
    const std::size_t c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
}

}  // namespace

Vec3 multiply(const Mat3& m, const Vec3& v) noexcept
{
    Vec3 product{};
    for (std::size_t row = 0; row < 3; ++row)
        product[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return product;
}

Mat3 multiply(const Mat3& a, const Mat3& b) noexcept
{
    Mat3 product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            product[row][column] =
                a[row][0] * b[0][column] + a[row][1] * b[1][column] + a[row][2] * b[2][column];
    return product;
}

Mat3 transposed(const Mat3& m) noexcept
{
    Mat3 result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) result[row][column] = m[column][row];
    return result;
}

double determinant(const Mat3& m) noexcept
{
    return m[0][0] * cofactor(m, 0, 0) + m[0][1] * cofactor(m, 0, 1) + m[0][2] * cofactor(m, 0, 2);
}

Mat3 inverse(const Mat3& m) noexcept
{
    const double divisor = determinant(m);
    Mat3 result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            result[row][column] = cofactor(m, column, row) / divisor;
    return result;
}

Mat3 diagonal(const Vec3& v) noexcept
{
    return {{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}};
}

}  // namespace nacre::spectral
