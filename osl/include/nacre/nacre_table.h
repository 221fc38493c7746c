// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Bilinear read of a table whose edge texels' centres hold the ends of both axes; row 0 of the
// image (the top) holds y = 0. Clamps here and sends zero derivatives, because renderers disagree
// on "wrap", on filtering and on mip choice. `origin_top` is 1 where t = 0 names the top row (the
// texture system's own convention, Cycles up to 5.1), 0 where it names the bottom (Cycles
// from 5.2).
color nacre_table(string file, float x, float y, float width, float height, int origin_top)
{
    float s = (clamp(x, 0.0, 1.0) * (width - 1.0) + 0.5) / width;
    float t = (clamp(y, 0.0, 1.0) * (height - 1.0) + 0.5) / height;
    return (color)texture(file, s, origin_top ? t : 1.0 - t, 0.0, 0.0, 0.0, 0.0, "interp", "linear",
                          "wrap", "clamp");
}

// The colour of a film: as it was looked up outside, or from the table where one is named.
color nacre_film_colour(string file, color given, float x, float y, float width, float height,
                        int origin_top)
{
    // No early return: what follows one is not optimised away, and Cycles 5.2 would look for a file
    // without a name.
    color found = given;
    if (file != "") found = nacre_table(file, x, y, width, height, origin_top);
    return found;
}
