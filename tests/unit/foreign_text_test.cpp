// SPDX-License-Identifier: MIT
// OBJ, OFF and PLY as other programs write them: each kind of spelling, and its relatives.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "planish/io/obj.hpp"
#include "planish/io/off.hpp"
#include "planish/io/ply.hpp"
#include "support/mesh_builders.hpp"
#include "support/small_files.hpp"

namespace planish {
namespace {

using testing::four_panel_faces;
using testing::four_panel_vertices;
using testing::four_panels;
using testing::group_text;
using testing::outcome;
using testing::same_bits;

constexpr const char* kWhole = "9 points, 4 faces";

/// The four panels as OBJ, with `lines[k]` before face k and `last` behind all.
std::string obj(const std::vector<std::string>& lines, const std::string& last = "") {
  std::string text = four_panel_vertices();
  for (std::size_t f = 0; f < 4; ++f) {
    if (f < lines.size()) text += lines[f];
    text += "f " + four_panel_faces()[f] + "\n";
  }
  return text + last;
}

bool is_four_panels(const ReadResult& result) {
  const auto* file = std::get_if<MeshFile>(&result);
  if (!file) return false;
  Mesh mesh = file->mesh;
  mesh.groups.clear();
  return same_bits(mesh, four_panels());
}

TEST(ForeignObj, ABackslashOfACommentOrANameJoinsNothing) {
  for (const std::string& file :
       {"# written to C:\\projects\\roof\\\n" + obj({}), obj({"# below\\\n"}),
        obj({"usemtl glass\\matt\\\n"}), obj({"g roof\\\n", "o wall\\\n"}),
        obj({"mtllib C:\\roof\\\r\n", "s off \\\r\n"}), obj({"# a \\ \n", "", "#\\\n"}),
        obj({"usemtl a\\\n\tusemtl b\\\n\n"}), obj({"vt 0 0 \\\n", "vn 0 0 1\\\n"}),
        obj({}, "# the end \\")}) {
    const ReadResult result = read_obj(file);
    EXPECT_EQ(outcome(result), kWhole) << file;
    EXPECT_TRUE(is_four_panels(result)) << file;
  }
}

TEST(ForeignObj, ABackslashJoinsNumbersAlsoBeforeBlanks) {
  std::string file = obj({});
  const std::size_t face = file.find("f 1 2 5 4");
  for (const char* broken : {"f 1 2 \\ \n 5 4\n", "f 1 2 \\\t\r\n5 4\n", "f \\\n1 \\ \n2 \\\n5 4\n",
                             "f 1 2\\\n5 4\\\n", "f 1 2 5 4 \\ \n"}) {
    std::string text = file;
    text.replace(face, 10, broken);
    EXPECT_TRUE(is_four_panels(read_obj(text))) << broken << outcome(read_obj(text));
  }
  EXPECT_TRUE(is_four_panels(read_obj("v 0 \\ \n 0 1.5\n" + file.substr(file.find('\n') + 1))));
}

TEST(ForeignObj, AHashWithinANameIsPartOfIt) {
  const ReadResult result =
      read_obj(obj({"g Panel #1\n", "g Panel #2\n", "o #3\n", "g Panel#4 # the last\n"}));
  EXPECT_EQ(group_text(result), "Panel #1:0 Panel #2:1 #3:2 Panel#4:3");
  EXPECT_EQ(group_text(read_obj(write_obj(std::get<MeshFile>(result).mesh))), group_text(result));
  EXPECT_TRUE(is_four_panels(read_obj(obj({"#1\n", "s 1 #2\n", "\t#3\n"}))));
}

TEST(ForeignObj, AnObjectHasOneNameAGroupSeveral) {
  const ReadResult result =
      read_obj(obj({"o North roof\n", "", "g South roof\n", "o  Bay\t #2 # third\n"}));
  EXPECT_EQ(group_text(result), "North_roof:0 South roof:2 Bay\t_#2:3");
  const std::string written = write_obj(std::get<MeshFile>(result).mesh);
  EXPECT_NE(written.find("o North roof\nf"), std::string::npos);
  EXPECT_NE(written.find("g South roof\nf"), std::string::npos);
  EXPECT_NE(write_obj(std::get<MeshFile>(read_obj(obj({"o house\n"}))).mesh).find("g house\n"),
            std::string::npos);
}

TEST(ForeignObj, FacesLeftOutSayThatNamesShift) {
  const std::string first =
      "9 points, 4 faces | 1 face has fewer than 3 different corners (first: "
      "line 10); left out, so each panel after it has a number and name one "
      "lower than in the file";
  EXPECT_EQ(outcome(read_obj(obj({"f 1 1 2\n"}))), first);
  EXPECT_EQ(outcome(read_obj(obj({"f 1 2\n"}))), first);
  EXPECT_EQ(outcome(read_obj(obj({"f 3\n"}))), first);
  EXPECT_EQ(
      outcome(read_obj(obj({"f 1 2\n", "f 4 5 4\n"}))),
      "9 points, 4 faces | 2 faces have fewer than 3 different corners (first: line 10); left "
      "out, so panels after them have lower numbers and names than in the file");
  EXPECT_EQ(outcome(read_obj(obj({}, "f 1 2\n"))),
            "9 points, 4 faces | 1 face has fewer than 3 different corners (first: line 14); left "
            "out");
  EXPECT_EQ(outcome(read_obj(obj({"f\n"}))), "line 10: face 1 has 0 vertices; it needs 3 or more");
}

TEST(ForeignOff, FacesLeftOutSayThatNamesShift) {
  for (const char* face : {"2 0 1", "1 0", "3 0 1 0", "4 0 0 1 1"}) {
    const std::string file =
        "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + std::string(face) + "\n4 0 1 2 3\n";
    EXPECT_EQ(outcome(read_off(file)),
              "4 points, 1 faces | 1 face has fewer than 3 different corners (first: line 7); left "
              "out, so each panel after it has a number and name one lower than in the file")
        << face;
  }
}

TEST(ForeignObj, AFaceGivenTwiceIsNamed) {
  EXPECT_EQ(outcome(read_obj(obj({}, "f 5 4 1 2\n"))),
            "line 14: face 5 has the same corners as face 1 (from 1); a panel can be given once");
  EXPECT_EQ(outcome(read_obj(obj({"f 9 8 5 6\n"}))),
            "line 14: face 5 has the same corners as face 1 (from 1); a panel can be given once");
  EXPECT_EQ(outcome(read_off("OFF 4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 2 1 0\n")),
            "line 8: face 2 has the same corners as face 0; a panel can be given once");
}

/// Points and faces from 0, a line each.
std::string rows(const std::string& behind_points = "", const std::string& behind_faces = "") {
  std::string text;
  for (const char* line : {"0 0 1.5", "2 0 1.8", "4 0 1.5", "0 1.5 1.7", "2 1.5 2", "4 1.5 1.7",
                           "0 3 1.5", "2 3 1.8", "4 3 1.5"}) {
    text += std::string(line) + behind_points + "\n";
  }
  for (const char* line : {"4 0 1 4 3", "4 1 2 5 4", "4 3 4 7 6", "4 4 5 8 7"}) {
    text += std::string(line) + behind_faces + "\n";
  }
  return text;
}

TEST(ForeignOff, KeywordsOfEverySpelling) {
  for (const char* header : {"OFF9 4 0\n", "off\n9 4 0\n", "coff 9 4\n", "OFF\n\n# a\n9 4\n"}) {
    EXPECT_TRUE(is_four_panels(read_off(header + rows()))) << header;
  }
}

TEST(ForeignOff, OtherDimensionsAndBinaryFilesAreNamed) {
  for (const char* word : {"4OFF", "nOFF", "C4OFF", "4nOFF"}) {
    EXPECT_EQ(outcome(read_off(word + ("\n9 4 0\n" + rows()))),
              "line 1: OFF with points of other than 3 coordinates is not supported")
        << word;
  }
  for (const char* start : {"OFF BINARY\n", "# a comment\nCOFF BINARY \n", "off binary\r\n"}) {
    EXPECT_NE(
        outcome(read_off(start + std::string("\0\0\0\1", 4))).find("binary OFF is not supported"),
        std::string::npos);
  }
}

TEST(ForeignOff, LinesMayBreakAnywhere) {
  const std::string whole = "OFF\n9 4 0\n" + rows();
  const auto with = [&](std::string from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const std::string& file :
       {with("4 0 1 4 3", "4 0 1\n  4 3"), with("4 0 1 4 3", "4\n0\n1\n4\n3"),
        with("4 0 1 4 3", "4 0 1\n4 3 255 0 0"), with("4 0 1 4 3\n", "4 0 1 4 3 "),
        with("2 0 1.8\n", "2 0 1.8 "), with("2 0 1.8", "2\n0 1.8")}) {
    EXPECT_TRUE(is_four_panels(read_off(file))) << file << outcome(read_off(file));
  }
  std::string one_line = whole;
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  EXPECT_TRUE(is_four_panels(read_off(one_line))) << outcome(read_off(one_line));
  EXPECT_TRUE(is_four_panels(read_off("OFF 9 4 0\n" + rows(" 0.5 0.5 0.5", " 1 0 0"))));
  EXPECT_EQ(outcome(read_off(with("4 0 1 4 3", "4 0 1 4"))),
            "line 12: the face has 4 vertices, but the line holds 3");
}

std::string ply(const std::string& header_lines, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header_lines +
         "element vertex 9\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
         body;
}

TEST(ForeignPly, RowsLongerThanDeclaredAreReadALineEach) {
  const auto longer = [](int line) {
    return "9 points, 4 faces | rows hold more values than the header declares (first: line " +
           std::to_string(line) + "); the rest is passed over";
  };
  for (const auto& [body, line] :
       {std::pair(rows("", " 3 1 1 1"), 19), std::pair(rows(" 0.5"), 10),
        std::pair(rows(" 0 0 1", " 255 0 0 255"), 10), std::pair(rows("", " 0 \n"), 19)}) {
    const ReadResult result = read_ply(ply("", body));
    EXPECT_EQ(outcome(result), longer(line));
    EXPECT_TRUE(is_four_panels(result));
  }
}

TEST(ForeignPly, RowsThatFollowWordByWordStayReadable) {
  std::string one_line = rows();
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  std::string a_word_a_line = rows();
  for (char& c : a_word_a_line) c = c == ' ' ? '\n' : c;
  for (const std::string& body : {one_line, a_word_a_line, rows() + "\n\n", rows() + "0 0 0\n"}) {
    EXPECT_TRUE(is_four_panels(read_ply(ply("", body)))) << body;
    EXPECT_EQ(outcome(read_ply(ply("", body))), kWhole);
  }
}

TEST(ForeignPly, AHeaderLineWithoutCommentIsPassedOver) {
  EXPECT_EQ(outcome(read_ply(ply("Made by hand\n", rows()))),
            "9 points, 4 faces | line 3: \"Made\" does not belong in a PLY header; passed over");
  EXPECT_EQ(
      outcome(read_ply(ply("Created 1\nby 2\n", rows()))),
      "9 points, 4 faces | line 3: \"Created\" does not belong in a PLY header; passed over | "
      "line 4: \"by\" does not belong in a PLY header; passed over");
  std::string file = ply("", rows());
  file.insert(file.find("element face"), "proprety float w\n");
  EXPECT_EQ(outcome(read_ply(file)), "line 7: \"proprety\" does not belong in a PLY header");
  EXPECT_EQ(outcome(read_ply(ply("elment vertex 9\nproperty float x\n", rows()))),
            "line 4: a property stands before any element");
}

}  // namespace
}  // namespace planish
