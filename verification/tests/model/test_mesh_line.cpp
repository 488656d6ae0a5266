#include <string>

#include <gtest/gtest.h>

#include "reference/model/mesh_line.h"

namespace type21 {
namespace {

std::string row(std::initializer_list<const char*> fields, int width, const std::string& begin = "") {
    std::string line = begin;
    for (const std::string field : fields)
        line += std::string(static_cast<size_t>(width) - field.size(), ' ') + field;
    return line;
}

TEST(MeshLine, APlainNode) {
    const auto node = plain_node(row({"1.5", "-2.5e-3", "+3."}, 20, "        12"));
    ASSERT_TRUE(node);
    EXPECT_EQ(node->id, 12);
    EXPECT_EQ(node->position, (std::array<double, 3>{1.5, -2.5e-3, 3.0}));
    const auto corner = plain_node("         7");
    ASSERT_TRUE(corner) << "blank coordinates are 0";
    EXPECT_EQ(corner->position, (std::array<double, 3>{0, 0, 0}));
}

TEST(MeshLine, APlainShell) {
    const auto quad = plain_shell(row({"1", "10", "20", "30", "40"}, 10), 4);
    ASSERT_TRUE(quad);
    EXPECT_EQ(quad->node, (std::array<Id, 4>{10, 20, 30, 40}));
    const auto triangle = plain_shell(row({"1", "10", "20", "30", "0"}, 10), 4);
    ASSERT_TRUE(triangle);
    EXPECT_EQ(triangle->node[3], 30);
    const auto sh3n =
        plain_shell(row({"1", "10", "20", "30"}, 10) + std::string(20, ' ') + row({"45.0", "1.2"}, 20), 3);
    ASSERT_TRUE(sh3n);
    EXPECT_EQ(sh3n->node[3], 30);
    EXPECT_EQ(sh3n->thickness, 1.2);
}

/// Every line that is not as plain as that goes to the reader that knows what to say.
TEST(MeshLine, AnythingElseIsNotPlain) {
    EXPECT_FALSE(plain_node(""));
    EXPECT_FALSE(plain_node("         0"));
    EXPECT_FALSE(plain_node("        -3"));
    EXPECT_FALSE(plain_node("       1.0"));
    EXPECT_FALSE(plain_node(row({"nan", "0", "0"}, 20, "         1")));
    EXPECT_FALSE(plain_node(row({"inf", "0", "0"}, 20, "         1")));
    EXPECT_FALSE(plain_node(row({"1.5d0", "0", "0"}, 20, "         1")));
    EXPECT_FALSE(plain_node(row({"1,5", "0", "0"}, 20, "         1")));
    EXPECT_FALSE(plain_node(row({"1", "1", "1"}, 20, "         1") + "  7")) << "text behind the last field";
    EXPECT_FALSE(plain_node("         12")) << "a word across the border";
    EXPECT_FALSE(plain_shell(row({"1", "10", "20", "x", "40"}, 10), 4));
    EXPECT_FALSE(plain_shell(row({"1", "10", "20", "30", "40", "50"}, 10), 4)) << "a number without a field";
    EXPECT_FALSE(plain_shell(row({"1", "10", "20", "30", "40"}, 10) + "          " + row({"--1", "1.0"}, 20), 4));
}

}  // namespace
}  // namespace type21
