// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// NACRE_VECTOR_CLONES compiles a function for several instruction sets and picks one when the
/// program starts. Results do not depend on the choice: nothing is contracted or reordered.
/// Sanitizers run before the resolver could, so they get the portable version. A test that wants
/// one particular instruction set defines the macro itself.

#if defined(NACRE_VECTOR_CLONES)
#elif defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define NACRE_VECTOR_CLONES [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define NACRE_VECTOR_CLONES
#endif

/// What a clone calls must become part of it.
#define NACRE_INLINE [[gnu::always_inline]] inline
