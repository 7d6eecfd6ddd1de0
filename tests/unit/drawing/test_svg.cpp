// Numbers and text of the picture.
#include <gtest/gtest.h>

#include "svg.hpp"

namespace foothold::drawing {
namespace {

TEST(Svg, NumbersHaveThreeDecimalsAtMostAndNoExponent) {
  EXPECT_EQ(compact(1.5), "1.5");
  EXPECT_EQ(compact(-12.12549), "-12.125");
  EXPECT_EQ(compact(100.0), "100");
  EXPECT_EQ(compact(1e15), "1000000000000000");
  EXPECT_EQ(compact(1e-9), "0");
}

TEST(Svg, ZeroHasNoSign) {
  EXPECT_EQ(compact(-0.0), "0");
  EXPECT_EQ(compact(-0.0001), "0");
}

TEST(Svg, TextIsEscaped) { EXPECT_EQ(escaped("<a b='c' d=\"e\">&"), "&lt;a b=&#39;c&#39; d=&quot;e&quot;&gt;&amp;"); }

TEST(Svg, ValidUtf8IsKept) {
  EXPECT_EQ(escaped("Pi\xC3\xB1"
                    "a \xE2\x82\xAC \xF0\x9F\xA6\xBF"),
            "Pi\xC3\xB1"
            "a \xE2\x82\xAC \xF0\x9F\xA6\xBF");
}

TEST(Svg, WhatXmlForbidsIsReplaced) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped(std::string("a\0b", 3)), "a" + mark + "b");
  EXPECT_EQ(escaped("\x1B[31m"), mark + "[31m");
  EXPECT_EQ(escaped("\xFF"), mark);
  EXPECT_EQ(escaped("\xC0\xAF"), mark + mark);                        // overlong
  EXPECT_EQ(escaped("\xED\xA0\x80"), mark + mark + mark);             // a surrogate
  EXPECT_EQ(escaped("\xEF\xBF\xBE"), mark + mark + mark);             // U+FFFE
  EXPECT_EQ(escaped("\xF4\x90\x80\x80"), mark + mark + mark + mark);  // beyond U+10FFFF
  EXPECT_EQ(escaped("x\xE2\x82"), "x" + mark + mark);                 // cut off
}

TEST(Svg, ShortenedTextEndsInAnEllipsisAndKeepsCharactersWhole) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abcde\xE2\x80\xA6");
  EXPECT_EQ(shortened("\xC3\xB1\xC3\xB1\xC3\xB1", 2), "\xC3\xB1\xE2\x80\xA6");
}

TEST(Svg, WrappedTextBreaksAtSpacesAndLosesNothingThatFits) {
  EXPECT_EQ(wrapped("one two three", 7, 5), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("onetwothree", 4, 5), (std::vector<std::string>{"onet", "woth", "ree"}));
  EXPECT_EQ(wrapped("one two three four", 4, 2), (std::vector<std::string>{"one", "two\xE2\x80\xA6"}));
}

TEST(Svg, PathsAreClosedOrOpen) {
  EXPECT_EQ(closed_path({{0, 0, 9}, {1, 0.5, 9}, {2, -1, 9}}), "M0 0L1 0.5L2 -1Z");
  EXPECT_EQ(open_path({{0, 0, 9}, {1, 0.5, 9}}), "M0 0L1 0.5");
}

}  // namespace
}  // namespace foothold::drawing
