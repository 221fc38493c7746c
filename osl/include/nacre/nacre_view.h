// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Direction to the viewer. Renderers disagree about I: by OSL's specification it points from the
// viewer to the surface; in Cycles, the other way. For all but Cycles define NACRE_I_TO_SURFACE.
// Where |dot(n, I)| is meant, I itself does. `nacre compile` puts I in place of the macro.
#ifdef NACRE_I_TO_SURFACE
#define NACRE_TO_VIEWER (-I)
#else
#define NACRE_TO_VIEWER I
#endif
