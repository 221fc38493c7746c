// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// @file
/// The kernels of stack_batch.cpp compiled for one instruction set each, whatever the machine would
/// choose by itself.

namespace nacre_clones {

/// Lanes side by side: index, cosine and thickness over wavelength of every one.
struct Input {
    std::size_t layers;
    std::vector<double> values;  ///< filled up from the front, in the order that the kernels need
};

/// Every number that the kernels make of `input`.
using Kernels = std::vector<double> (*)(const Input& input);

std::vector<double> run_portable(const Input& input);
#if defined(__x86_64__)
std::vector<double> run_avx2(const Input& input);
std::vector<double> run_avx512(const Input& input);
#endif

}  // namespace nacre_clones
