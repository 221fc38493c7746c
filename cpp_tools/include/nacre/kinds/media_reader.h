// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nacre/core/diagnostics.h"
#include "nacre/lut/film_request.h"
#include "nacre/material/medium.h"
#include "nacre/media/working_range.h"

/// @file
/// The media of a template, looked up.

namespace nacre::kinds {

/// Of the Fraunhofer line d: ISO 7944.
inline constexpr double kLineD = 587.5618;

/// A clear medium's data sheet may list a trace of absorption.
inline constexpr double kTraceOfK = 1e-4;

/// Looks up the media of one template. Problems carry the template's file, line and field; they
/// are collected, so that a user sees all of them.
class MediaReader {
public:
    MediaReader(std::string file, spectral::RangeRule rule) : file_(std::move(file)), range_(rule)
    {}

    /// On the 1 nm grid; 1 where a problem was reported.
    [[nodiscard]] lut::IndexOnGrid on_grid(const material::MediumSpec& spec);
    /// The same for a medium that has to be clear; `max_k` is what still counts as clear.
    [[nodiscard]] lut::IndexOnGrid clear_on_grid(const material::MediumSpec& spec, double max_k);
    /// Over 360 … 830 nm. Null where a problem was reported.
    [[nodiscard]] spectral::OpticalConstantsPtr constants(const material::MediumSpec& spec);

    /// @throws InputError when anything was reported.
    void throw_if_any() { problems_.throw_if_any(); }

private:
    void report(const material::MediumSpec& spec, const InputError& error);

    std::string file_;
    spectral::WorkingRange range_;
    DiagnosticList problems_;
};

}  // namespace nacre::kinds
