// A program that is ended by a signal leaves no unfinished file behind, and its exit status names
// the signal.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "tests/cli/program.h"
#include "tests/cli/running.h"

namespace pineda::test {
namespace {

namespace fs = std::filesystem;

/// How many files of the scratch have a temporary name.
std::ptrdiff_t temporary_files(const Scratch& scratch) {
  const auto files = scratch.files();
  return std::count_if(files.begin(), files.end(), [](const std::string& file) {
    return file.find(".partial-") != std::string::npos;
  });
}

class EverySignal : public testing::TestWithParam<int> {};

TEST_P(EverySignal, TakesTheWaveformOfTheRtlAlong) {
  const Scratch scratch;
  Running rtl({"rtl", "teapot", "--size", "1920x1080", "--trace", scratch.path("new/a/rtl.fst")});
  ASSERT_TRUE(rtl.comes_to([&] { return temporary_files(scratch) == 2; }));  // one is GTKWave's
  EXPECT_EQ(rtl.end_by(GetParam()), GetParam());
  EXPECT_TRUE(fs::is_empty(scratch.path("")));
}

TEST_P(EverySignal, TakesWhatShowsTimeAlongAndLeavesOlderFiles) {
  const Scratch scratch;
  scratch.write("old.json", "older");
  Running time({"time", "teapot", "--size", "4000x4000", "--tessellate", "200", "--timeline",
                scratch.path("old.json"), "--heat-map", scratch.path("map.png"), "--trace",
                scratch.path("new/time.fst")});
  ASSERT_TRUE(time.comes_to([&] { return temporary_files(scratch) == 4; }));
  EXPECT_EQ(time.end_by(GetParam()), GetParam());
  EXPECT_EQ(scratch.files(), std::vector<std::string>{"old.json"});
  EXPECT_EQ(read_bytes(scratch.path("old.json")), "older");
  EXPECT_FALSE(fs::exists(scratch.path("new")));
}

INSTANTIATE_TEST_SUITE_P(Signal, EverySignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

// The mutant: a signal that cannot be caught leaves the file, and the check sees it.
TEST(Signal, ThatCannotBeCaughtLeavesTheFile) {
  const Scratch scratch;
  Running rtl({"rtl", "teapot", "--size", "1920x1080", "--trace", scratch.path("rtl.fst")});
  ASSERT_TRUE(rtl.comes_to([&] { return temporary_files(scratch) == 2; }));
  EXPECT_EQ(rtl.end_by(SIGKILL), SIGKILL);
  EXPECT_FALSE(fs::is_empty(scratch.path("")));
}

/// The folders of a cache of plug-ins.
std::vector<std::string> folders_in(const std::string& cache) {
  std::vector<std::string> all;
  if (!fs::exists(cache)) return all;
  for (const auto& entry : fs::directory_iterator(cache)) {
    if (entry.is_directory()) all.push_back(entry.path().filename());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Is there a folder in which a design of this name is verilated?
bool verilates(const std::string& cache, const std::string& name) {
  const auto folders = folders_in(cache);
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    return folder.rfind(name + "_", 0) == 0 && fs::exists(cache + "/" + folder + "/objects");
  });
}

TEST(PluginCache, VerilationEndedByASignalLeavesNoFolder) {
  const Scratch scratch;
  const std::string cache = scratch.path("cache");
  const Environment place("PINEDA_CACHE", cache);
  const std::string design = scratch.write("mine.toml", "depth_bits = 20\n");
  Running rtl({"rtl", "triangle", "--design", design});
  ASSERT_TRUE(rtl.comes_to([&] { return verilates(cache, "mine"); }));
  EXPECT_EQ(rtl.end_by(SIGINT), SIGINT);
  EXPECT_TRUE(fs::is_empty(cache));
}

// One folder is locked by a living process, here this one; one was not made by the cache.
TEST(PluginCache, FoldersOfProcessesThatAreGoneAreSweptAtTheNextStart) {
  const Scratch scratch;
  const std::string cache = scratch.path("cache");
  const Environment place("PINEDA_CACHE", cache);
  scratch.write("cache/gone_0123456789abcdef.AbC123/objects/a.o", "");
  scratch.write("cache/busy_0123456789abcdef.AbC123/objects/a.o", "");
  scratch.write("cache/my_own_folder/a.o", "");
  const int busy =
      open((cache + "/busy_0123456789abcdef.AbC123").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(busy, LOCK_EX), 0);
  const std::string design = scratch.write("mine.toml", "depth_bits = 20\n");
  Running killed({"rtl", "triangle", "--design", design});
  ASSERT_TRUE(killed.comes_to([&] { return verilates(cache, "mine"); }));
  EXPECT_EQ(folders_in(cache).size(), 3u);
  EXPECT_EQ(killed.end_by(SIGKILL), SIGKILL);
  EXPECT_EQ(folders_in(cache).size(), 3u);  // SIGKILL: the program could not remove it

  Running next({"rtl", "triangle", "--design", scratch.write("next.toml", "depth_bits = 21\n")});
  ASSERT_TRUE(next.comes_to([&] { return verilates(cache, "next"); }));
  EXPECT_EQ(next.end_by(SIGTERM), SIGTERM);
  EXPECT_EQ(folders_in(cache),
            (std::vector<std::string>{"busy_0123456789abcdef.AbC123", "my_own_folder"}));
  close(busy);
}

}  // namespace
}  // namespace pineda::test
