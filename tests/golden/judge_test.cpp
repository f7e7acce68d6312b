// The judge behind the C interface.
#include "tests/golden/support.h"

namespace pineda::test {
namespace {

/// A frame that persp has drawn, to be judged.
class GoldenJudge : public testing::Test {
 protected:
  GoldenJudge()
      : scene_(spec::contract(*spec::find_design("persp")), "hard/near_plane"),
        frame_(stated(scene_.frame)),
        hits_(scene_.buffer.hits),
        depth_(scene_.buffer.depth) {
    for (const uint16_t c : scene_.buffer.color) rgba_.push_back(static_cast<uint8_t>(c));
    dump_ = {hits_.data(), depth_.data(), rgba_.data(), hits_.size()};
  }

  pineda_verdict judged(std::vector<uint8_t>* wrong = nullptr) {
    const pineda_tolerance tolerance = pineda_default_tolerance();
    pineda_verdict verdict{};
    if (wrong != nullptr) wrong->assign(hits_.size(), 7);
    EXPECT_OK(pineda_judge(&frame_, &tolerance, scene_.screen.data(), scene_.screen.size(), &dump_,
                           &verdict, wrong != nullptr ? wrong->data() : nullptr));
    return verdict;
  }

  DrawnScene scene_;
  pineda_frame frame_;
  std::vector<uint16_t> hits_;
  std::vector<uint32_t> depth_;
  std::vector<uint8_t> rgba_;
  pineda_dump dump_{};
};

TEST_F(GoldenJudge, OwnFrameHolds) {
  std::vector<uint8_t> wrong;
  EXPECT_EQ(judged(&wrong).samples_wrong, 0U);
  EXPECT_EQ(wrong, std::vector<uint8_t>(hits_.size(), 0));
}

TEST_F(GoldenJudge, ChangedSampleIsNamed) {
  const size_t sample = 1234;
  hits_[sample] += 1;
  std::vector<uint8_t> wrong;
  const pineda_verdict verdict = judged(&wrong);
  EXPECT_EQ(verdict.samples_wrong, 1U);
  EXPECT_EQ(verdict.x, static_cast<int32_t>(sample) % frame_.width);
  EXPECT_EQ(verdict.y, static_cast<int32_t>(sample) / frame_.width);
  EXPECT_EQ(wrong[sample], 1);
  EXPECT_NE(std::string(verdict.what), "");
}

TEST_F(GoldenJudge, ValueBeyondItsToleranceIsNamed) {
  const size_t sample = 700;
  depth_[sample] += 5;
  EXPECT_EQ(judged().rule, PINEDA_RULE_DEPTH_VALUE);
  depth_[sample] -= 5;
  rgba_[4 * sample] ^= 0x40;
  const pineda_verdict verdict = judged();
  EXPECT_EQ(verdict.rule, PINEDA_RULE_COLOR_VALUE);
  EXPECT_GE(verdict.triangle, 0);
}

TEST_F(GoldenJudge, ColourAloneIsJudged) {
  dump_.hits = nullptr;
  dump_.depth = nullptr;
  EXPECT_EQ(judged().samples_wrong, 0U);
  rgba_[0] ^= 0x80;
  EXPECT_EQ(judged().samples_wrong, 1U);
}

TEST_F(GoldenJudge, BadInputIsRefused) {
  pineda_verdict verdict{};
  verdict.x = 99;
  const auto judge = [&](const pineda_tolerance& tolerance, const pineda_dump& dump) {
    return pineda_judge(&frame_, &tolerance, scene_.screen.data(), scene_.screen.size(), &dump,
                        &verdict, nullptr);
  };
  pineda_tolerance tolerance = pineda_default_tolerance();
  pineda_dump dump = dump_;
  dump.samples -= 1;
  EXPECT_EQ(judge(tolerance, dump), PINEDA_WRONG_SIZE);
  dump = {nullptr, nullptr, nullptr, dump_.samples};
  EXPECT_EQ(judge(tolerance, dump), PINEDA_NULL_POINTER);
  tolerance.depth_ulp = -1;
  EXPECT_EQ(judge(tolerance, dump_), PINEDA_OUT_OF_RANGE);
  tolerance = pineda_default_tolerance();
  tolerance.subpixel_bits = 13;
  EXPECT_EQ(judge(tolerance, dump_), PINEDA_OUT_OF_RANGE);
  EXPECT_EQ(std::string(pineda_last_error()), "tolerance: subpixel_bits is 13, must be 4 to 12");
  tolerance = pineda_default_tolerance();
  scene_.screen[3].v[1].w = 0;
  EXPECT_EQ(judge(tolerance, dump_), PINEDA_OUT_OF_RANGE);
  EXPECT_EQ(std::string(pineda_last_error()),
            "triangles[3].v[1].w: expected a normal number above 0, got 0");
  EXPECT_EQ(verdict.x, 99);
}

}  // namespace
}  // namespace pineda::test
