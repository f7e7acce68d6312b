// The waveform of unit states: its values, and that VCD and FST files both hold them.
#include "studies/seeing/state_trace.h"

#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <sstream>

namespace pineda::test {
namespace {

using studies::StateTrace;
using studies::Window;
using timing::Cause;
using timing::Cycle;
using timing::Fifo;
using timing::Unit;

// Each signal's changes as "cycle=value ", numbers in decimal.
using Values = std::map<std::string, std::string>;

std::string decimal(const std::string& digits) {
  if (digits.find_first_not_of("01") != std::string::npos) return digits.substr(0, 1);
  return std::to_string(std::stoull(digits, nullptr, 2));
}

// A small reader of VCD.
Values read_vcd(const std::string& text) {
  std::map<std::string, std::string> names;  // by code
  std::istringstream in(text);
  std::string scope;
  Values values;
  int64_t now = -1;
  for (std::string word; in >> word;) {
    if (word == "$scope") {
      in >> word >> word;
      scope += word + ".";
    } else if (word == "$upscope") {
      scope.erase(scope.rfind('.', scope.size() - 2) + 1);
    } else if (word == "$var") {
      std::string kind, bits, code, name;
      in >> kind >> bits >> code >> name;
      names[code] = scope + name;
    } else if (word[0] == '#') {
      const int64_t cycle = std::stoll(word.substr(1));
      EXPECT_GT(cycle, now);
      now = cycle;
    } else if (word[0] == 's' || word[0] == 'b') {
      const std::string value = word[0] == 's' ? word.substr(1) : decimal(word.substr(1));
      in >> word;
      values[names.at(word)] += std::to_string(now) + "=" + value + " ";
    } else if (word.size() == 2 && now >= 0) {
      values[names.at(word.substr(1))] += std::to_string(now) + "=" + word[0] + " ";
    }
  }
  return values;
}

struct FstRead {
  std::map<fstHandle, std::string> names;
  std::map<fstHandle, bool> is_text;
  Values values;
};

void take_text(void* user, uint64_t cycle, fstHandle handle, const unsigned char* value,
               uint32_t size) {
  auto& read = *static_cast<FstRead*>(user);
  const std::string text(reinterpret_cast<const char*>(value), size);
  read.values[read.names.at(handle)] +=
      std::to_string(cycle) + "=" + (read.is_text.at(handle) ? text : decimal(text)) + " ";
}

void take_bits(void* user, uint64_t cycle, fstHandle handle, const unsigned char* value) {
  const auto* text = reinterpret_cast<const char*>(value);
  take_text(user, cycle, handle, value, static_cast<uint32_t>(std::string(text).size()));
}

// Reads an FST file with the library that GTKWave uses.
Values read_fst(const std::string& path) {
  void* file = fstReaderOpen(path.c_str());
  if (file == nullptr) return {};
  FstRead read;
  EXPECT_EQ(fstReaderGetTimescale(file), -9);
  std::string scope;
  while (const fstHier* item = fstReaderIterateHier(file)) {
    if (item->htyp == FST_HT_SCOPE) scope += std::string(item->u.scope.name) + ".";
    if (item->htyp == FST_HT_UPSCOPE) scope.erase(scope.rfind('.', scope.size() - 2) + 1);
    if (item->htyp != FST_HT_VAR) continue;
    const std::string name = item->u.var.name;
    read.names[item->u.var.handle] = scope + name.substr(0, name.find(' '));
    read.is_text[item->u.var.handle] = item->u.var.typ == FST_VT_GEN_STRING;
  }
  fstReaderSetFacProcessMaskAll(file);
  fstReaderIterBlocks2(file, take_bits, take_text, &read, nullptr);
  fstReaderClose(file);
  return read.values;
}

class StateTraceFiles : public testing::Test {
 protected:
  ~StateTraceFiles() override { std::filesystem::remove(path_); }

  std::string vcd(const StateTrace& trace) {
    std::FILE* file = std::fopen(path_.c_str(), "wb+");
    const auto waveform = studies::vcd_waveform(file, StateTrace::signals());
    trace.write(waveform.get());
    EXPECT_TRUE(waveform->finish());
    std::string text(static_cast<size_t>(std::ftell(file)), '\0');
    std::rewind(file);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
    std::fclose(file);
    return text;
  }

  Values fst(const StateTrace& trace) {
    const auto waveform = studies::fst_waveform(path_, StateTrace::signals());
    trace.write(waveform.get());
    EXPECT_TRUE(waveform->finish());
    return read_fst(path_);
  }

  const std::string path_ = testing::TempDir() + "pineda_trace-" + std::to_string(::getpid());
};

// Setup alone to cycle 9, then interpolation behind it; they report unit by unit.
void feed(timing::Listener* to) {
  to->spent(Unit::kSetup, Cause::kBusy, 2, 5, 0);
  to->spent(Unit::kSetup, Cause::kBusy, 5, 8, 1);
  to->spent(Unit::kSetup, Cause::kBlocked, 8, 9, 1);
  to->slot(Fifo::kStamps, 10, 11);
  to->slot(Fifo::kStamps, 11, 12);
  to->slot(Fifo::kStamps, 13, 16);
  to->spent(Unit::kInterpZtest, Cause::kBusy, 11, 12, 0);
  to->spent(Unit::kInterpZtest, Cause::kBusy, 12, 13, 0);
  to->spent(Unit::kInterpZtest, Cause::kHazard, 14, 16, 1);
  to->spent(Unit::kInterpZtest, Cause::kBusy, 16, 17, 1);
  to->spent(Unit::kInterpZtest, Cause::kBusy, 18, 19, 1);
  to->depth(14, {});
  to->depth(15, {});
  to->color(19, {});
}

TEST_F(StateTraceFiles, HoldStatesLevelsAndPorts) {
  StateTrace trace({}, true);
  feed(&trace);
  trace.finish(20);
  const Values values = read_vcd(vcd(trace));
  EXPECT_EQ(values.at("pineda.setup.state"), "0=starved 2=busy 8=blocked 9=starved ");
  EXPECT_EQ(values.at("pineda.setup.triangle"), "0=x 2=0 5=1 9=x ");
  EXPECT_EQ(values.at("pineda.tiles.state"), "0=starved ");
  EXPECT_EQ(values.at("pineda.interp_ztest.state"),
            "0=starved 11=busy 13=starved 14=hazard 16=busy 17=starved 18=busy 19=starved ");
  EXPECT_EQ(values.at("pineda.interp_ztest.triangle"), "0=x 11=0 13=x 14=1 19=x ");
  EXPECT_EQ(values.at("pineda.fifos.stamps"), "0=0 11=1 13=0 14=1 17=0 ");
  EXPECT_EQ(values.at("pineda.memory.depth_read"), "0=0 11=1 13=0 16=1 17=0 ");
  EXPECT_EQ(values.at("pineda.memory.depth_write"), "0=0 14=1 16=0 ");
  EXPECT_EQ(values.at("pineda.memory.color_write"), "0=0 19=1 ");
  EXPECT_EQ(values.size(), StateTrace::signals().size());
}

TEST_F(StateTraceFiles, WindowBeginsWithTheValuesThere) {
  StateTrace trace({8, 15}, true);
  feed(&trace);
  trace.finish(20);
  const std::string text = vcd(trace);
  const Values values = read_vcd(text);
  EXPECT_EQ(values.at("pineda.setup.state"), "8=blocked 9=starved ");
  EXPECT_EQ(values.at("pineda.setup.triangle"), "8=1 9=x ");
  EXPECT_EQ(values.at("pineda.interp_ztest.state"), "8=starved 11=busy 13=starved 14=hazard ");
  EXPECT_EQ(values.at("pineda.memory.color_write"), "8=0 ");
  EXPECT_EQ(text.substr(text.size() - 5), "\n#15\n");
}

TEST_F(StateTraceFiles, WithoutDepthTestNoDepthIsRead) {
  StateTrace trace({}, false);
  feed(&trace);
  trace.finish(20);
  EXPECT_EQ(read_vcd(vcd(trace)).at("pineda.memory.depth_read"), "0=0 ");
}

// Long enough that the FST file has many values to a signal.
TEST_F(StateTraceFiles, FstHoldsWhatVcdHolds) {
  StateTrace trace({}, true);
  Cycle now = 0;
  for (uint32_t id = 0; id < 2000; ++id) {
    trace.spent(Unit::kTiles, Cause::kBusy, now, now + 3, id);
    trace.spent(Unit::kTiles, Cause::kBlocked, now + 3, now + 4 + id % 3, id);
    trace.slot(Fifo::kTiles, now + 2, now + 3);
    trace.color(now + 1, {});
    now += 7;
  }
  trace.finish(now);
  const Values values = read_vcd(vcd(trace));
  EXPECT_GT(values.at("pineda.tiles.triangle").size(), 20000);
  EXPECT_EQ(fst(trace), values);
}

TEST_F(StateTraceFiles, FstOfNothingCanBeRead) {
  StateTrace trace({}, true);
  trace.finish(3);
  const Values values = fst(trace);
  EXPECT_EQ(values.size(), StateTrace::signals().size());
  EXPECT_EQ(values.at("pineda.setup.state"), "0=starved ");
}

// The mutant: an FST file that lost its end is refused.
TEST_F(StateTraceFiles, CutFstIsNotTakenForTheWhole) {
  StateTrace trace({}, true);
  feed(&trace);
  trace.finish(20);
  const Values whole = fst(trace);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
  EXPECT_NE(read_fst(path_), whole);
}

TEST(Waveforms, FullDiskIsNotSilent) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  EXPECT_FALSE(studies::vcd_waveform(full, StateTrace::signals())->finish());
  std::fclose(full);
  EXPECT_EQ(studies::fst_waveform("/dev/null/none.fst", StateTrace::signals()), nullptr);
}

TEST(GtkwaveSave, NamesEverySignalOnce) {
  const std::string save = studies::gtkwave_save("frame.fst");
  EXPECT_EQ(save.rfind("[dumpfile] \"frame.fst\"\n", 0), 0);
  for (const auto& signal : StateTrace::signals()) {
    std::string name = "\npineda." + signal.scope + "." + signal.name;
    if (signal.bits > 1) name += "[" + std::to_string(signal.bits - 1) + ":0]";
    const size_t at = save.find(name + "\n");
    ASSERT_NE(at, std::string::npos) << name;
    EXPECT_EQ(save.find(name + "\n", at + 1), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace pineda::test
