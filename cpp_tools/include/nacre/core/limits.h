// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// @file
/// How much a reader takes before it refuses: every reader of files keeps to these.

namespace nacre {

/// Largest text input, in bytes: optical constants, spectra, templates.
inline constexpr std::size_t kMaxTextBytes = std::size_t{16} << 20;
/// Largest batch of records in JSON, in bytes.
inline constexpr std::size_t kMaxBatchBytes = std::size_t{256} << 20;

inline constexpr int kMaxJsonDepth = 64;
inline constexpr int kMaxXmlDepth = 16;
/// Parts of a dotted key of TOML.
inline constexpr std::size_t kMaxKeyParts = 16;

/// Samples of one spectrum, and spectra in one file.
inline constexpr std::size_t kMaxSamples = 100'000;
inline constexpr std::size_t kMaxSpectra = 10'000;

/// Problems that are told of one file: one of another kind is wrong in every line.
inline constexpr int kMaxProblems = 50;

/// Files of a user's own library, and how long a key may be.
inline constexpr std::size_t kMaxUserEntries = 10'000;
inline constexpr std::size_t kMaxKeyBytes = 200;

}  // namespace nacre
