#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"
#include "reference/deck/foreign_format.h"

namespace type21 {
namespace {

using test::all_of;
using test::TempFolder;
using namespace std::string_literals;

const std::vector<std::pair<std::string, std::string>> foreign_files{
    {"$# LS-DYNA Keyword file created by a tool\n*KEYWORD\n*TITLE\nx\n", "LS-DYNA"},
    {"*NODE\n$ id x y z\n       1             0.0             0.0             0.0\n", "LS-DYNA"},
    {"*Heading\n** Job name\n*Node\n1, 0., 0., 0.\n", "Abaqus"},
    {"*NODE\n      1, 0.0, 0.0, 0.0\n", "Abaqus"},
    {"*ELEMENT, TYPE=S4R\n1,1,2,3,4\n", "Abaqus"},
    {"SOL 101\nCEND\nBEGIN BULK\n", "Nastran"},
    {"$ comment\nBEGIN BULK\nGRID,1,,0.,0.,0.\n", "Nastran"},
    {"GRID           1              0.      0.      0.\n", "Nastran"},
    {"INPUTVERSION 2018\nANALYSIS EXPLICIT\n", "PAM-CRASH"},
    {"$ comment\nNODE  /        1             0.0\n", "PAM-CRASH"},
    {"/PREP7\nN,1,0,0,0\n", "ANSYS"},
    {"/COM,ANSYS RELEASE 19\n", "ANSYS"},
    {"! a remark\nET,1,181\n", "ANSYS"},
    {"solid part\n facet normal 0 0 1\n", "STL"},
    {std::string(80, ' ') + "\1\0\0\0"s + std::string(50, '\0'), "STL"},
    {"# vtk DataFile Version 3.0\ntitle\nASCII\n", "VTK"},
    {"<?xml version=\"1.0\"?>\n<VTKFile>\n", "XML"},
    {"<VTKFile type=\"UnstructuredGrid\">\n", "VTK"},
    {"$MeshFormat\n4.1 0 8\n", "Gmsh"},
    {"v 0 0 0\nv 1 0 0\nf 1 2 3\n", "OBJ"},
    {"ply\nformat ascii 1.0\n", "PLY"},
    {"    -1\n  2411\n", "universal"},
    {"ISO-10303-21;\n", "STEP"},
    {"\x1f\x8b\x08\0"s, "gzip"},
    {"PK\x03\x04\0\0"s, "zip"},
    {"%PDF-1.7\n", "PDF"},
    {"\x89PNG\r\n\x1a\n"s, "PNG"},
    {"{\n \"nodes\": 3\n}\n", "JSON"},
    {"[1, 2, 3]\n", "JSON"},
    {"[case]\nname = \"x\"\n", "TOML"},
    {"tolerance = 1e-3\n", "TOML"},
    {"time,FX,FY\n0,1,2\n", "CSV"},
    {"\"time\";\"FX\"\n0;1\n", "CSV"},
    {"\xff\xfe/\0B\0"s, "UTF-16"},
    {"\0\0\0\x54\0\0\x0b\xe0"s + std::string(100, 'x'), "T01"},
    {"\0\0\x54\x2c"s + std::string(100, '\0'), "A001"},
    {"#!/bin/sh\necho\n", "script"},
    {"import numpy\n", "Python"},
};

TEST(ForeignFiles, AreNamedForWhatTheyAreInOneError) {
    for (const auto& [bytes, name] : foreign_files) {
        const TempFolder folder;
        Problems problems;
        const Deck deck = read_deck(folder.write("x_0000.rad", bytes), problems);
        EXPECT_EQ(problems.list().size(), 1U) << name << '\n' << all_of(problems);
        EXPECT_TRUE(problems.has_errors()) << name;
        EXPECT_NE(all_of(problems).find(name), std::string::npos) << name << '\n' << all_of(problems);
        EXPECT_TRUE(deck.starter.empty()) << name;
    }
}

TEST(ForeignFiles, ABinaryFileIsNamedByItsEnding) {
    EXPECT_EQ(foreign_format("ab\0c"s, "dir/model.hm", 4), "a HyperMesh model");
    EXPECT_EQ(foreign_format("ab\0c"s, "dir/part.CATPart", 4), "a CATIA part");
    EXPECT_EQ(foreign_format("ab\0c"s, "dir/model_0000.rad", 4), "");
    EXPECT_EQ(foreign_format("/BEGIN\n", "model.hm", 7), "") << "the ending of a text says nothing";
}

TEST(ForeignFiles, APieceOfARadiossDeckIsNoForeignFile) {
    for (const std::string text :
         {"#RADIOSS STARTER\n/BEGIN\n", "         1                 0.0                 0.0                 1.0\n",
          "$ remark\n# remark\n\n/NODE\n", "", "# only a remark\n", "/TITLE\na, b\n", "blank\n         1\n",
          "         1         2         3\n", "-1\n"})
        EXPECT_EQ(foreign_format(text, "x_0000.rad", text.size()), "") << text;
}

TEST(ForeignFiles, AnotherProgramsFileMayBeIncluded) {
    const TempFolder folder;
    folder.write("mesh.k", "*KEYWORD\n*NODE\n");
    Problems problems;
    read_deck(folder.write("x_0000.rad", "/BEGIN\n#include mesh.k\n/END\n"), problems);
    ASSERT_EQ(problems.list().size(), 1U) << all_of(problems);
    EXPECT_NE(problems.list()[0].rule.find("LS-DYNA"), std::string::npos);
    EXPECT_EQ(problems.list()[0].place.line, 2);
}

TEST(ForeignFiles, AnEngineDeckInPlaceOfTheStarterDeck) {
    const TempFolder folder;
    Problems problems;
    const Deck deck =
        read_deck(folder.write("x_0001.rad", "#RADIOSS ENGINE\n/VERS/2025\n/RUN/x/1\n0.1\n/TFILE\n0\n"), problems);
    ASSERT_EQ(problems.list().size(), 1U) << all_of(problems);
    EXPECT_NE(problems.list()[0].rule.find("engine deck"), std::string::npos);
    EXPECT_TRUE(deck.starter.empty());
}

TEST(ForeignFiles, TextWithoutAnyCard) {
    const TempFolder folder;
    Problems problems;
    read_deck(folder.write("x_0000.rad", "Dear colleague\nthe deck comes tomorrow\n"), problems);
    ASSERT_EQ(problems.list().size(), 1U) << all_of(problems);
    EXPECT_NE(problems.list()[0].rule.find("no Radioss deck"), std::string::npos);
}

}  // namespace
}  // namespace type21
