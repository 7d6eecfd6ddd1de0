// Messages to bytes and back; broken bytes give nothing and no crash.
#include <gtest/gtest.h>

#include <foothold.h>

#include <random>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::msg {
namespace {

Step sample_step() {
  Step step;
  step.request(random_id());
  step.index(7);
  step.label("half cycle 7");
  step.joints({0.103, 0.130});
  step.placed().resize(2);
  step.placed()[1].limb("B");
  step.margins().resize(3);
  step.margins()[2].value(0.5);
  return step;
}

TEST(Cdr, DecodeGivesBackWhatWasEncoded) {
  const Step step = sample_step();
  const auto back = decode<Step>(encode(step));
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(*back == step);
}

// Steps are compared octet for octet after a restart (P22): padding must not hold what the buffer held before.
TEST(Cdr, ABufferThatWasUsedBeforeGivesTheSameOctets) {
  const Step step = sample_step();
  Bytes used(100000, std::byte{0xa5});
  encode_into(step, used);
  EXPECT_EQ(used, encode(step));
  Bytes with_prefix(100000, std::byte{0xa5});
  encode_into(step, with_prefix, 16);
  EXPECT_EQ(with_prefix[15], std::byte{0xa5});
  EXPECT_EQ(Bytes(with_prefix.begin() + 16, with_prefix.end()), encode(step));
}

TEST(Cdr, EveryTruncationIsRefused) {
  const Bytes bytes = encode(sample_step());
  for (std::size_t size = 0; size + 4 < bytes.size(); ++size)
    EXPECT_FALSE(decode<Step>(std::span(bytes).first(size)).has_value()) << "of " << bytes.size() << " octets the first " << size;
}

TEST(Cdr, MutatedBytesNeverThrow) {
  std::mt19937 random(1);
  const Bytes bytes = encode(sample_step());
  for (int run = 0; run < 20000; ++run) {
    Bytes broken = bytes;
    for (int i = 0; i < 4; ++i) broken[random() % broken.size()] = static_cast<std::byte>(random());
    EXPECT_NO_THROW((void)decode<Step>(broken));
  }
}

TEST(Ids, HexadecimalFormRoundsTrip) {
  const Id id = random_id();
  EXPECT_EQ(id_from_hex(to_hex(id)), id);
  EXPECT_EQ(id_from_hex("12"), std::nullopt);
  EXPECT_EQ(id_from_hex(std::string(32, 'g')), std::nullopt);
}

TEST(Ids, Sha256AgreesWithThePublishedVector) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace foothold::msg
