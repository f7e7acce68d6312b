#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "studies/seeing/waveform.h"

namespace pineda::studies {
namespace {

class VcdWaveform final : public Waveform {
 public:
  VcdWaveform(std::FILE* file, const std::vector<Signal>& signals) : file_(file) {
    if (signals.size() > kCodes) throw std::invalid_argument("vcd: too many signals");
    put("$timescale 1 ns $end\n$scope module pineda $end\n");
    std::string scope;
    for (const Signal& signal : signals) {
      if (signal.scope != scope) {
        if (!scope.empty()) put("$upscope $end\n");
        scope = signal.scope;
        put(fmt::format("$scope module {} $end\n", scope));
      }
      declare(signal);
    }
    put("$upscope $end\n$upscope $end\n$enddefinitions $end\n");
  }

  void cycle(int64_t cycle) override { put(fmt::format("#{}\n", cycle)); }

  void value(size_t signal, const std::string& value) override {
    const char code = code_of(signal);
    const int bits = bits_[signal];
    if (bits == 0) {
      put(fmt::format("s{} {}\n", value, code));
    } else if (bits == 1) {
      put(fmt::format("{}{}\n", value, code));
    } else {
      // VCD allows a value without its leading zeros, and a single x for a value that is all x.
      const size_t first = value[0] == 'x' ? value.size() - 1 : value.find('1');
      put(fmt::format("b{} {}\n", value.substr(std::min(first, value.size() - 1)), code));
    }
  }

  bool finish() override { return std::fflush(file_) == 0 && written_; }

 private:
  static constexpr size_t kCodes = 94;  // the printable characters
  static char code_of(size_t signal) { return static_cast<char>('!' + signal); }

  void declare(const Signal& signal) {
    const char code = code_of(bits_.size());
    const std::string range = signal.bits > 1 ? fmt::format(" [{}:0]", signal.bits - 1) : "";
    put(signal.bits == 0
            ? fmt::format("$var string 1 {} {} $end\n", code, signal.name)
            : fmt::format("$var wire {} {} {}{} $end\n", signal.bits, code, signal.name, range));
    bits_.push_back(signal.bits);
  }
  void put(const std::string& text) {
    written_ &= std::fwrite(text.data(), 1, text.size(), file_) == text.size();
  }

  std::FILE* file_;
  std::vector<int> bits_;
  bool written_ = true;
};

}  // namespace

std::unique_ptr<Waveform> vcd_waveform(std::FILE* file, const std::vector<Signal>& signals) {
  return std::make_unique<VcdWaveform>(file, signals);
}

}  // namespace pineda::studies
