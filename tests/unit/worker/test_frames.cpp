// Cutting a stream into frames, however it arrives and whatever it holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "frames/frames.hpp"

namespace foothold::server {
namespace {

msg::Bytes frame_of(frame::WorkerFrame kind, std::uint64_t run, std::size_t size, int fill) {
  msg::Bytes frame(kFrameHeader + size, static_cast<std::byte>(fill));
  seal_frame(kind, run, frame);
  return frame;
}

void put(FrameReader& reader, std::span<const std::byte> octets) {
  while (!octets.empty()) {
    const auto room = reader.room();
    const std::size_t count = std::min(room.size(), octets.size());
    std::copy_n(octets.begin(), count, room.begin());
    reader.filled(count);
    octets = octets.subspan(count);
  }
}

TEST(Frames, ArriveWholeHoweverTheStreamIsCut) {
  std::mt19937 random(3);
  const std::size_t sizes[] = {0, 1, 17, 4096, 65536, 3u << 20, 5};
  msg::Bytes stream;
  for (std::size_t i = 0; i < std::size(sizes); ++i) {
    const auto frame = frame_of(frame::STEP, i, sizes[i], static_cast<int>(i));
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  for (int attempt = 0; attempt < 20; ++attempt) {
    FrameReader reader;
    std::size_t next = 0, at = 0;
    const std::size_t largest_cut = attempt % 2 == 0 ? 7000 : 200000;
    while (at < stream.size()) {
      const std::size_t cut = std::min(stream.size() - at, 1 + random() % largest_cut);
      const auto room = reader.room();
      ASSERT_FALSE(room.empty());
      const std::size_t count = std::min(cut, room.size());
      std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), count, room.begin());
      reader.filled(count);
      at += count;
      while (const auto frame = reader.next()) {
        ASSERT_LT(next, std::size(sizes));
        EXPECT_EQ(frame->kind, frame::STEP);
        EXPECT_EQ(frame->run, next);
        ASSERT_EQ(frame->payload.size(), sizes[next]);
        EXPECT_TRUE(std::ranges::all_of(frame->payload, [&](std::byte b) { return b == static_cast<std::byte>(next); }));
        ++next;
      }
    }
    EXPECT_EQ(next, std::size(sizes));
    EXPECT_TRUE(reader.empty());
  }
}

TEST(Frames, ALengthBeyondTheLargestIsRefusedBeforeItsOctetsCome) {
  msg::Bytes header = frame_of(frame::REPORT, 1, 0, 0);
  const std::uint32_t length = kLargestPayload + 1;
  std::memcpy(header.data(), &length, sizeof(length));
  FrameReader reader;
  put(reader, header);
  try {
    reader.next();
    ADD_FAILURE() << "was taken";
  } catch (const FrameFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("REPORT frame of 16777217 octets"), std::string::npos) << fault.what();
  }
}

TEST(Frames, AnUnknownKindIsRefused) {
  FrameReader reader;
  put(reader, frame_of(static_cast<frame::WorkerFrame>(8), 1, 0, 0));
  EXPECT_THROW(reader.next(), FrameFault);
}

TEST(Frames, NoiseIsRefusedOrWaitedForAndItsPromisesTakeNoMemory) {
  std::mt19937 random(5);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    FrameReader reader;
    msg::Bytes noise(200);
    for (std::byte& octet : noise) octet = static_cast<std::byte>(random() % (attempt % 2 == 0 ? 256 : 8));
    put(reader, noise);
    try {
      while (reader.next()) {
      }
      EXPECT_LE(reader.room().size(), 128u << 10);
    } catch (const FrameFault&) {
    }
  }
}

TEST(Frames, AStepsHeadIsReadInPlace) {
  msg::Step step;
  step.request(msg::random_id());
  step.index(4711);
  step.label("something");
  const auto head = peek_step(msg::encode(step));
  ASSERT_TRUE(head.has_value());
  EXPECT_EQ(head->request, step.request());
  EXPECT_EQ(head->index, 4711u);
}

TEST(Frames, WhatIsNoLittleEndianCdrOfAStepHasNoHead) {
  msg::Bytes octets = msg::encode(msg::Step{});
  EXPECT_FALSE(peek_step(std::span(octets).first(23)).has_value());
  octets[1] = std::byte{0};
  EXPECT_FALSE(peek_step(octets).has_value());
}

}  // namespace
}  // namespace foothold::server
