# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The C interface as ctypes has it. Written by cpp_tools/generators/write_ctypes.py."""

from __future__ import annotations

from ctypes import POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_void_p
from typing import Any

# fmt: off

API_VERSION = 1
WAVELENGTHS = 471


class Light(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("count", c_size_t),
        ("wavelength_nm", c_void_p),
        ("power", c_void_p),
        ("lines", c_size_t),
        ("line_nm", c_void_p),
        ("line_power", c_void_p),
    ]


class BandNeeds(Structure):
    _fields_ = [
        ("lights", c_size_t),
        ("light", POINTER(Light)),
        ("samples", c_size_t),
        ("wavelength_nm", c_void_p),
        ("reflectances", c_size_t),
        ("reflectance", c_void_p),
        ("films", c_size_t),
        ("film_nm", c_void_p),
        ("film_reflectance", c_void_p),
        ("spreads", c_size_t),
        ("spread_px", c_void_p),
        ("mean_error", c_double),
        ("max_error", c_double),
    ]


class BandChoice(Structure):
    _fields_ = [
        ("passes", c_int),
        ("mean_error", c_double),
        ("max_error", c_double),
        ("film_error", c_double),
        ("step_px", c_double),
        ("held", c_char_p),
        ("met", c_int),
    ]


class Colour(Structure):
    _fields_ = [
        ("XYZ", c_double * 3),
        ("Lab", c_double * 3),
        ("rgb", c_double * 3),
    ]


class ColourOptions(Structure):
    _fields_ = [
        ("illuminant", c_char_p),
        ("observer", c_char_p),
        ("space", c_char_p),
        ("adaptation", c_char_p),
        ("gamut", c_char_p),
        ("reflectance", c_int),
    ]


class Viewer(Structure):
    _fields_ = [
        ("observer", c_char_p),
        ("camera", c_char_p),
        ("samples", c_size_t),
        ("wavelength_nm", c_void_p),
        ("sensitivity", c_void_p),
        ("raw", c_int),
        ("white", c_void_p),
        ("adaptation", c_char_p),
        ("exposure", c_double),
    ]


class Table(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("quantity", c_char_p),
        ("x_name", c_char_p),
        ("y_name", c_char_p),
        ("x_min", c_double),
        ("x_max", c_double),
        ("y_min", c_double),
        ("y_max", c_double),
        ("width", c_int),
        ("height", c_int),
        ("channels", c_int),
        ("error_max", c_double),
        ("error_mean", c_double),
        ("texels", c_void_p),
    ]


class FilmQuery(Structure):
    _fields_ = [
        ("n_ambient", c_double),
        ("n_film", c_double),
        ("n_base", c_double),
        ("k_base", c_double),
        ("d_nm", c_double),
        ("angle_deg", c_double),
        ("wavelength_nm", c_double),
        ("mirror_reflectance", c_double),
    ]


class Film(Structure):
    _fields_ = [
        ("layers", c_size_t),
        ("n", c_void_p),
        ("d_nm", c_void_p),
        ("coherent", c_void_p),
        ("varying", c_int),
        ("min", c_double),
        ("max", c_double),
        ("illuminant", c_char_p),
        ("observer", c_char_p),
        ("space", c_char_p),
        ("adaptation", c_char_p),
        ("tolerance", c_double),
        ("width", c_int),
        ("height", c_int),
        ("transmittance", c_int),
        ("single_precision", c_int),
    ]


class Grating(Structure):
    _fields_ = [
        ("pitch_nm", c_double),
        ("wavelength_nm", c_double),
        ("grating_vector", c_double * 3),
        ("normal", c_double * 3),
        ("k_in", c_double * 3),
        ("profile", c_char_p),
        ("phase_rad", c_double),
        ("duty", c_double),
    ]


class Medium(Structure):
    _fields_ = [
        ("key", c_char_p),
        ("name", c_char_p),
        ("references", c_char_p),
        ("comments", c_char_p),
        ("first_nm", c_double),
        ("last_nm", c_double),
    ]


class Spectrum(Structure):
    _fields_ = [
        ("key", c_char_p),
        ("name", c_char_p),
        ("kind", c_char_p),
        ("references", c_char_p),
        ("licence", c_char_p),
        ("comments", c_char_p),
        ("count", c_size_t),
        ("wavelength_nm", c_void_p),
        ("values", c_void_p),
    ]


class LibraryWords(Structure):
    _fields_ = [
        ("formula", c_char_p),
        ("tags", c_char_p),
        ("changes", c_char_p),
    ]


class Shape(Structure):
    _fields_ = [
        ("kind", c_int),
        ("numbers", c_double * 4),
        ("count", c_size_t),
        ("wavelength_nm", c_void_p),
        ("values", c_void_p),
        ("key", c_char_p),
        ("of_kind", c_char_p),
    ]


class MediumIndex(Structure):
    _fields_ = [
        ("key", c_char_p),
        ("n", c_void_p),
        ("count", c_size_t),
    ]


class ColourStacks(Structure):
    _fields_ = [
        ("layers", c_size_t),
        ("media", POINTER(MediumIndex)),
        ("coherent", c_void_p),
        ("count", c_size_t),
        ("d_nm", c_void_p),
        ("angle_deg", c_void_p),
        ("polarisation", c_int),
        ("sampling", c_char_p),
    ]


class Coherence(Structure):
    _fields_ = [
        ("coherent", c_void_p),
        ("spread_nm", c_void_p),
        ("bandwidth_nm", c_double),
    ]


class GridArray(Structure):
    _fields_ = [
        ("values", c_void_p),
        ("steps", POINTER(c_size_t)),
    ]


class TableSize(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("width", c_int),
        ("height", c_int),
    ]


class Texture(Structure):
    _fields_ = [
        ("width", c_int),
        ("height", c_int),
        ("channels", c_int),
        ("texels", c_void_p),
    ]


SIGNATURES: dict[str, tuple[Any, list[Any]]] = {
    "nacre_api_version": (c_int, []),
    "nacre_version": (c_char_p, []),
    "nacre_last_error": (c_char_p, []),
    "nacre_bands_make": (c_int, [c_size_t, c_size_t, POINTER(Light), c_char_p, POINTER(c_void_p)]),
    "nacre_bands_choose": (c_int, [POINTER(BandNeeds), c_char_p, POINTER(c_void_p),
        POINTER(BandChoice)]),
    "nacre_bands_count": (c_size_t, [c_void_p]),
    "nacre_bands_get": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_void_p]),
    "nacre_light_in_bands": (c_int, [c_void_p, POINTER(Light), c_void_p]),
    "nacre_band_error": (c_int, [c_void_p, POINTER(Light), c_size_t, c_void_p, c_size_t, c_void_p,
        c_void_p, c_void_p]),
    "nacre_bands_free": (None, [c_void_p]),
    "nacre_spectrum_to_colour": (c_int, [c_size_t, c_void_p, c_void_p, c_int, c_char_p, c_char_p,
        c_char_p, c_void_p]),
    "nacre_spectra_to_colours": (c_int, [c_size_t, c_size_t, c_void_p, c_void_p,
        POINTER(ColourOptions), c_void_p]),
    "nacre_rgb_to_spectrum": (c_int, [c_size_t, c_void_p, c_char_p, c_char_p, c_int, c_void_p,
        c_void_p, c_void_p]),
    "nacre_rgb_basis": (c_int, [c_void_p]),
    "nacre_bands_of": (c_int, [c_size_t, c_void_p, c_void_p, c_void_p, c_char_p,
        POINTER(c_void_p)]),
    "nacre_colours_of_bands": (c_int, [c_void_p, POINTER(Viewer), c_void_p]),
    "nacre_camera_count": (c_size_t, []),
    "nacre_camera_key": (c_char_p, [c_size_t]),
    "nacre_exchange_light": (c_int, [c_void_p, c_void_p, c_char_p, POINTER(Light), c_void_p]),
    "nacre_metamerism": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_char_p, POINTER(Light),
        c_void_p, c_void_p]),
    "nacre_result_tables": (c_size_t, [c_void_p]),
    "nacre_result_table": (c_int, [c_void_p, c_size_t, POINTER(Table)]),
    "nacre_result_text": (c_char_p, [c_void_p, c_char_p]),
    "nacre_result_free": (None, [c_void_p]),
    "nacre_film_reflectance": (c_int, [c_char_p, c_size_t, c_void_p, c_int, c_void_p]),
    "nacre_film_lut": (c_int, [POINTER(Film), POINTER(c_void_p)]),
    "nacre_grating_orders": (c_int, [POINTER(Grating), c_int, c_int, c_void_p, c_void_p]),
    "nacre_slit_intensity": (c_int, [c_size_t, c_void_p, c_void_p]),
    "nacre_library_count": (c_size_t, []),
    "nacre_library_key": (c_char_p, [c_size_t]),
    "nacre_library_medium": (c_int, [c_char_p, POINTER(Medium)]),
    "nacre_library_index": (c_int, [c_char_p, c_size_t, c_void_p, c_void_p]),
    "nacre_library_spectrum_count": (c_size_t, []),
    "nacre_library_spectrum_key": (c_char_p, [c_size_t]),
    "nacre_library_spectrum": (c_int, [c_char_p, POINTER(Spectrum)]),
    "nacre_library_search": (c_int, [c_int, c_char_p, c_char_p, c_void_p]),
    "nacre_library_found": (c_char_p, [c_size_t]),
    "nacre_library_words_of": (c_int, [c_int, c_char_p, POINTER(LibraryWords)]),
    "nacre_sum_of_shapes": (c_int, [c_size_t, POINTER(Shape), c_char_p, c_size_t, c_void_p,
        c_void_p]),
    "nacre_illuminant": (c_int, [c_char_p, c_void_p]),
    "nacre_colour_matching": (c_int, [c_char_p, c_void_p]),
    "nacre_colour_temperature": (c_int, [c_size_t, c_void_p, c_void_p, c_void_p]),
    "nacre_read_spectra": (c_int, [c_char_p, c_size_t, c_char_p, c_char_p, c_double,
        POINTER(c_void_p)]),
    "nacre_spectra_count": (c_size_t, [c_void_p]),
    "nacre_spectra_at": (c_int, [c_void_p, c_size_t, POINTER(Spectrum), POINTER(c_char_p)]),
    "nacre_spectra_free": (None, [c_void_p]),
    "nacre_library_add_spectra": (c_int, [c_size_t, POINTER(Spectrum), POINTER(c_char_p), c_int]),
    "nacre_library_add_medium": (c_int, [c_char_p, c_char_p, c_size_t, c_char_p, c_char_p, c_int]),
    "nacre_stack_colours": (c_int, [POINTER(ColourStacks), POINTER(ColourOptions), c_void_p,
        c_void_p, c_void_p]),
    "nacre_map_range": (c_int, [c_size_t, c_void_p, c_char_p]),
    "nacre_stack": (c_int, [c_size_t, c_size_t, c_void_p, c_void_p, c_void_p, c_void_p,
        POINTER(Coherence), c_int, c_void_p, c_void_p, c_void_p]),
    "nacre_stack_grid": (c_int, [c_size_t, c_void_p, c_size_t, GridArray, GridArray, GridArray,
        GridArray, POINTER(Coherence), c_int, c_void_p, c_void_p, c_void_p]),
    "nacre_compile_template": (c_int, [c_char_p, c_char_p, c_char_p, c_char_p, c_char_p, c_char_p,
        c_double, POINTER(c_void_p)]),
    "nacre_preview_template": (c_int, [c_char_p, c_char_p, c_char_p, c_char_p, c_char_p, c_char_p,
        c_size_t, POINTER(TableSize), POINTER(c_void_p)]),
    "nacre_band_tables": (c_int, [c_char_p, c_char_p, c_void_p, c_size_t, c_void_p, c_size_t,
        POINTER(TableSize), POINTER(c_void_p)]),
    "nacre_template_optical_thickness": (c_int, [c_char_p, c_char_p, c_void_p]),
    "nacre_template_fringes": (c_int, [c_char_p, c_char_p, c_size_t, c_double, c_void_p]),
    "nacre_template_spectrum": (c_int, [c_char_p, c_char_p, c_char_p, c_char_p, c_char_p, c_char_p,
        c_double, c_double, c_void_p, c_void_p, c_void_p]),
    "nacre_texture_samples": (c_int, [c_size_t, c_void_p, c_void_p, c_int, c_void_p]),
    "nacre_pack_spectra": (c_int, [c_size_t, c_void_p, c_char_p, c_size_t, c_void_p]),
    "nacre_unpack_spectra": (c_int, [POINTER(Texture), c_char_p, c_size_t, c_size_t, c_void_p]),
    "nacre_pack_materials": (c_int, [c_size_t, c_void_p, c_void_p, c_void_p, c_void_p, c_int,
        c_void_p]),
    "nacre_unpack_materials": (c_int, [POINTER(Texture), c_void_p, c_void_p, c_void_p, c_void_p]),
    "nacre_pack_lights": (c_int, [c_size_t, c_void_p, c_void_p, c_void_p]),
    "nacre_unpack_lights": (c_int, [POINTER(Texture), c_size_t, c_void_p, c_void_p]),
    "nacre_read_ftxt": (c_int, [c_char_p, c_size_t, c_char_p, POINTER(c_void_p)]),
    "nacre_write_ftxt": (c_int, [POINTER(Texture), c_size_t, POINTER(c_char_p), POINTER(c_char_p),
        POINTER(c_void_p)]),
    "nacre_ftxt_texture": (c_int, [c_void_p, POINTER(Texture)]),
    "nacre_ftxt_comments": (c_size_t, [c_void_p]),
    "nacre_ftxt_key": (c_char_p, [c_void_p, c_size_t]),
    "nacre_ftxt_value": (c_char_p, [c_void_p, c_size_t]),
    "nacre_ftxt_text": (c_char_p, [c_void_p]),
    "nacre_ftxt_free": (None, [c_void_p]),
    "nacre_library_index_on_grid": (c_int, [c_char_p, c_int, c_void_p]),
    "nacre_library_held_ends": (c_int, [c_char_p, c_char_p, c_char_p, c_int, c_void_p,
        POINTER(c_char_p)]),
    "nacre_template_held_ends": (c_int, [c_char_p, c_char_p, c_char_p, c_char_p, c_int,
        POINTER(c_char_p)]),
}
