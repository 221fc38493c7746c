// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "files/image_file.h"
#include "nacre/spectral/named_spectrum.h"
#include "nacre/textures/texture.h"

/// @file
/// What the bakers of spectra share.

namespace nacre::tool {

struct Session;

/// Schema, version, quantity and the axis of a texture of spectra. Lists are JSON, because text is
/// all that a PNG keeps.
[[nodiscard]] Attributes texture_attributes(const std::string& quantity);
/// Names, kinds and citations.
void describe_spectra(Attributes& attributes, const std::vector<spectral::NamedSpectrum>& spectra);

/// Key, else name.
[[nodiscard]] std::string label_of(const spectral::NamedSpectrum& spectrum);

/// Channels R, G, B, A, or Y for one.
[[nodiscard]] Image image_of(spectral::Texture texture);

/// Writes the image, stating in nacre:error by how much spectra that are read back are off, and
/// warning where that is a byte's doing.
/// @param spectra  what the texture holds, in the order in which spectra_of_image() returns them
void write_texture(const Session& session, const std::string& output, const Image& image,
                   Attributes attributes, const Encoding& encoding,
                   const std::vector<spectral::NamedSpectrum>& spectra);

/// `wavelength_nm` and a column for each spectrum, over all wavelengths that one of them has;
/// numbers in the shortest form that reads back as the same double.
/// @param comments  for the head of the file, one line; may be empty
[[nodiscard]] std::string spectra_csv(const std::vector<spectral::NamedSpectrum>& spectra,
                                      const std::string& comments = {});

}  // namespace nacre::tool
