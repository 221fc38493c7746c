// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/limits.h"

#include <gtest/gtest.h>

// That readers keep to them is tested beside the readers; here, that no allowed file can be large
// enough to fill the memory of a small machine.
static_assert(nacre::kMaxTextBytes <= nacre::kMaxBatchBytes);
static_assert(nacre::kMaxSamples * 2 <= nacre::kMaxTextBytes);

TEST(Limits, LeaveRoomForWhatIsMeasured)
{
    EXPECT_GE(nacre::kMaxSamples, 471u * 100u);  // 10 pm over the visible
    EXPECT_GE(nacre::kMaxSpectra, 2000u);        // an IT8.7/4 chart has 1617 patches
}
