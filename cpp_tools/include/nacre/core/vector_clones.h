// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// NACRE_VECTOR_CLONES compiles a function for several instruction sets and picks one when the
/// program starts: AVX-512, AVX2 with fused multiply-add, or what the compiler was told to build
/// for. Nothing is reordered; products and sums are fused only in sources that ask for contraction,
/// whose results then depend on the choice by a rounding. Sanitizers run before the resolver could,
/// so they get the portable version. A test that wants one particular instruction set defines the
/// macro itself.

#if defined(NACRE_VECTOR_CLONES)
#elif defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define NACRE_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define NACRE_VECTOR_CLONES
#endif

/// What a clone calls must become part of it.
#define NACRE_INLINE [[gnu::always_inline]] inline
