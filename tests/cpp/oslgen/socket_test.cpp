// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/socket.h"

#include <gtest/gtest.h>

#include <vector>

namespace nacre::oslgen {
namespace {

constexpr material::FieldInfo kPitch{
    .key = "pitch_nm", .label = "Pitch", .help = "of grooves", .unit = "nm"};

TEST(Socket, OfAFieldHasItsWordsAndRange)
{
    const Socket socket = slider_socket(kPitch, {.value = 5.0, .min = 1.0, .max = std::nullopt});
    EXPECT_EQ(socket.name, "pitch_nm");
    EXPECT_EQ(socket.label, "Pitch (nm)");
    EXPECT_EQ(socket.description, "of grooves");
    EXPECT_EQ(socket.min, 1.0);
    EXPECT_EQ(socket.max, 10.0);
}

TEST(Socket, OfANormalHasAnotherParameter)
{
    EXPECT_EQ(parameter_name(normal_socket()), "surface_normal");
    EXPECT_EQ(parameter_name(slider_socket(kPitch, {})), "pitch_nm");
}

TEST(Socket, TakesTheTemplatesWords)
{
    material::TemplateHead head;
    head.roughness = 0.25;
    std::vector<Socket> sockets{roughness_socket(head), normal_socket()};
    EXPECT_EQ(sockets[0].value, 0.25);
    head.parameters = {
        {.name = "roughness", .label = "Blur", .description = "", .value = 0.5, .max = 0.75}};
    apply_parameters(head, sockets);
    EXPECT_EQ(sockets[0].label, "Blur");
    EXPECT_EQ(sockets[0].description, "0: mirror; GGX alpha is the square");
    EXPECT_EQ(sockets[0].value, 0.5);
    EXPECT_EQ(sockets[0].max, 0.75);
    EXPECT_EQ(sockets[1].label, "Normal");
}

TEST(Socket, OfAColourHasItsDefault)
{
    EXPECT_EQ(colour_socket("tint", "Tint", "of metal", {0.1, 0.2, 0.3}).colour[2], 0.3);
}

}  // namespace
}  // namespace nacre::oslgen
