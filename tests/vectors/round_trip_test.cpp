// Writing and reading back.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

template <class Case>
class RoundTrip : public testing::Test {
 protected:
  // Each test its own folder: they run at the same time.
  const std::string folder_ = testing::TempDir() + "pineda_vectors_" + spec::name_of(Case::kUnit) +
                              "_" + testing::UnitTest::GetInstance()->current_test_info()->name();
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
};
using Cases = testing::Types<SetupCase, TraversalCase, InterpZtestCase, FrameCase>;
TYPED_TEST_SUITE(RoundTrip, Cases);

TYPED_TEST(RoundTrip, ReadingBackGivesTheSameBytes) {
  const std::string text = write_text(sample_file<TypeParam>());
  const auto file = read_text<TypeParam>("memory", text);
  EXPECT_EQ(write_text(file), text);
  EXPECT_EQ(file.seed, 5u);
  ASSERT_EQ(file.cases.size(), 2u);
  EXPECT_EQ(difference(kContract, sample_case<TypeParam>(), file.cases[1]), std::nullopt);
  // The inputs came back, too: the model gives the same outputs from them.
  EXPECT_EQ(difference(kContract, file.cases[0], run_model(kContract, file.cases[0])),
            std::nullopt);
}

TYPED_TEST(RoundTrip, ClearedDepthIsALineWhereItIsNotTheGreatest) {
  File<TypeParam> file = sample_file<TypeParam>();
  const std::string plain = write_text(file);
  EXPECT_EQ(plain.find("clear_depth"), std::string::npos);
  file.cases[0].frame.clear_depth = 1 / 3.f;
  const std::string text = write_text(file);
  EXPECT_NE(text.find("\nclear_depth 555555\n"), std::string::npos);
  const auto read = read_text<TypeParam>("memory", text);
  EXPECT_EQ(write_text(read), text);
  EXPECT_EQ(spec::cleared_depth(kContract.design, read.cases[0].frame), 0x555555u);
  EXPECT_EQ(read.cases[1].frame.clear_depth, 1);
}

TYPED_TEST(RoundTrip, FileIsWrittenWholeAndNothingBesideIt) {
  const std::string path = this->folder_ + "/a.txt";
  write(path, sample_file<TypeParam>());
  write(path, sample_file<TypeParam>());  // over an existing file
  EXPECT_EQ(write_text(read<TypeParam>(path)), write_text(sample_file<TypeParam>()));
  const std::filesystem::directory_iterator files(this->folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TYPED_TEST(RoundTrip, PathThatCannotBeWrittenIsRefusedByName) {
  const std::string path = this->folder_ + "/absent/a.txt";
  try {
    write(path, sample_file<TypeParam>());
    FAIL() << "written";
  } catch (const Refused& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace pineda::vectors
