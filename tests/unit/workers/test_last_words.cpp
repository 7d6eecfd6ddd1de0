// What is kept of a worker's words, and what of them reaches the log.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "workers/last_words.hpp"

namespace foothold::server {
namespace {

struct Log {
  std::vector<std::string> lines;
  LastWords words{[this](std::string_view line) { lines.emplace_back(line); }};
};

TEST(LastWords, LinesArriveWholeHoweverTheyAreCut) {
  Log log;
  for (const char* piece : {"one\ntw", "o", "\n\nfour"}) log.words.hear(piece, 1);
  EXPECT_EQ(log.lines, (std::vector<std::string>{"one", "two", ""}));
  EXPECT_EQ(log.words.text(), "one | two |  | four");
}

TEST(LastWords, OnlyTheLastLinesAreKept) {
  Log log;
  for (int i = 0; i < 1000; ++i) log.words.hear(std::to_string(i) + "\n", i);
  const std::string text = log.words.text();
  EXPECT_TRUE(text.ends_with(" | 998 | 999"));
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '|')), LastWords::kLines - 1);
}

TEST(LastWords, ALongLineIsCutAndSaysSo) {
  Log log;
  log.words.hear(std::string(100000, 'x') + "\n", 1);
  EXPECT_EQ(log.lines.at(0), std::string(LastWords::kLineOctets, 'x') + " [...]");
}

TEST(LastWords, WhatNoMessageMayHoldIsEscaped) {
  Log log;
  log.words.hear(std::string("caf\xc3\xa9 \xff\x1b[1m\0|\n", 14), 1);
  EXPECT_EQ(log.lines.at(0), "caf\xc3\xa9 \\xff\\x1b[1m\\x00|");
  EXPECT_EQ(log.words.text(), log.lines.at(0));
}

TEST(LastWords, AFloodIsLoggedInPartAndCounted) {
  Log log;
  for (int i = 0; i < 1000; ++i) log.words.hear("flood\n", 7);
  EXPECT_EQ(log.lines.size(), LastWords::kLoggedPerSecond);
  log.words.hear("later\n", 8);
  EXPECT_EQ(log.lines.at(LastWords::kLoggedPerSecond), "(950 more lines left out)");
  EXPECT_EQ(log.lines.back(), "later");
}

}  // namespace
}  // namespace foothold::server
