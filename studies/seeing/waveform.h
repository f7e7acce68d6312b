// Waveform files: VCD and FST.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace pineda::studies {

/// A signal in a scope of its own below "pineda".
struct Signal {
  std::string scope;  // consecutive signals of one scope are grouped in it
  std::string name;
  int bits = 0;  // 0: text
};

/// A waveform being written; a nanosecond a cycle.
class Waveform {
 public:
  Waveform() = default;
  virtual ~Waveform() = default;
  Waveform(const Waveform&) = delete;
  Waveform& operator=(const Waveform&) = delete;

  /// Starts a cycle; cycles grow. In the first one every signal must get a value.
  virtual void cycle(int64_t cycle) = 0;
  /// Sets a signal: a word, or `bits` digits 0, 1 or x, the highest first.
  virtual void value(size_t signal, const std::string& value) = 0;
  /// Ends the file. False when it could not be written completely.
  virtual bool finish() = 0;
};

/// A Value Change Dump (IEEE 1364), with text as GTKWave reads it; at most 94 signals. The caller
/// owns the file.
std::unique_ptr<Waveform> vcd_waveform(std::FILE* file, const std::vector<Signal>& signals);

/// GTKWave's Fast Signal Trace, written by its own library. Null where the file cannot be opened.
std::unique_ptr<Waveform> fst_waveform(const std::string& path, const std::vector<Signal>& signals);

}  // namespace pineda::studies
