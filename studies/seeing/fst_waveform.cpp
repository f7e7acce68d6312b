#include <fmt/format.h>
#include <gtkwave/fstapi.h>

#include <utility>

#include "studies/seeing/waveform.h"

namespace pineda::studies {
namespace {

constexpr int kNanoseconds = -9;  // the timescale's power of ten

class FstWaveform final : public Waveform {
 public:
  FstWaveform(std::string path, void* writer, const std::vector<Signal>& signals)
      : path_(std::move(path)), writer_(writer) {
    fstWriterSetTimescale(writer_, kNanoseconds);
    fstWriterSetPackType(writer_, FST_WR_PT_LZ4);
    fstWriterSetScope(writer_, FST_ST_VCD_MODULE, "pineda", nullptr);
    std::string scope;
    for (const Signal& signal : signals) {
      if (signal.scope != scope) {
        if (!scope.empty()) fstWriterSetUpscope(writer_);
        scope = signal.scope;
        fstWriterSetScope(writer_, FST_ST_VCD_MODULE, scope.c_str(), nullptr);
      }
      declare(signal);
    }
    fstWriterSetUpscope(writer_);
    fstWriterSetUpscope(writer_);
  }
  ~FstWaveform() override { close(); }

  void cycle(int64_t cycle) override {
    end_ = static_cast<uint64_t>(cycle);
    fstWriterEmitTimeChange(writer_, end_);
  }

  void value(size_t signal, const std::string& value) override {
    const Variable& variable = variables_[signal];
    if (variable.text) {
      fstWriterEmitVariableLengthValueChange(writer_, variable.handle, value.data(),
                                             static_cast<uint32_t>(value.size()));
    } else {
      fstWriterEmitValueChange(writer_, variable.handle, value.data());
    }
  }

  // The library does not report failed writes, so the file is read back and its end checked.
  bool finish() override {
    close();
    void* reader = fstReaderOpen(path_.c_str());
    const bool whole = reader != nullptr && fstReaderGetEndTime(reader) == end_;
    if (reader != nullptr) fstReaderClose(reader);
    return whole;
  }

 private:
  struct Variable {
    fstHandle handle;
    bool text;
  };

  void declare(const Signal& signal) {
    const bool text = signal.bits == 0;
    const std::string name =
        signal.bits > 1 ? fmt::format("{} [{}:0]", signal.name, signal.bits - 1) : signal.name;
    variables_.push_back(
        {fstWriterCreateVar(writer_, text ? FST_VT_GEN_STRING : FST_VT_VCD_WIRE, FST_VD_IMPLICIT,
                            static_cast<uint32_t>(signal.bits), name.c_str(), 0),
         text});
  }

  void close() {
    if (writer_ != nullptr) fstWriterClose(writer_);
    writer_ = nullptr;
  }

  std::string path_;
  void* writer_;
  uint64_t end_ = 0;
  std::vector<Variable> variables_;
};

}  // namespace

std::unique_ptr<Waveform> fst_waveform(const std::string& path,
                                       const std::vector<Signal>& signals) {
  void* writer = fstWriterCreate(path.c_str(), 1);
  if (writer == nullptr) return nullptr;
  return std::make_unique<FstWaveform>(path, writer, signals);
}

}  // namespace pineda::studies
