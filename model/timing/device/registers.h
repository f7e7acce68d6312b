// The registers of a RasterDevice: one table, for the device, its test and docs/device.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace pineda::timing {

enum class Access : uint8_t { kRead, kWrite, kReadWrite };

/// Each of 32 bits; a value of 64 bits takes two, the low word first.
enum class Register : uint8_t {
  kId,
  kVersion,
  kControl,
  kStatus,
  kInterruptEnable,
  kInterruptPending,
  kFrameSize,
  kState,
  kScissorMin,
  kScissorMax,
  kBiasConstant,
  kBiasConstantHigh,
  kBiasSlope,
  kClearDepth,
  kDepthBase,
  kDepthBaseHigh,
  kColorBase,
  kColorBaseHigh,
  kTriangleBase,
  kTriangleBaseHigh,
  kTriangleCount,
  kTriangleWords,
  kTriangleData,
  kFramesDone,
  kCycles,
};

struct RegisterRow {
  Register value;
  uint32_t offset;
  const char* name;
  Access access;
  uint32_t reset;
  const char* meaning;
};

inline constexpr uint32_t kDeviceId = 0x50494e45;  // "PINE"
inline constexpr uint32_t kDeviceVersion = 1;

inline constexpr RegisterRow kRegisters[] = {
    {Register::kId, 0x00, "id", Access::kRead, kDeviceId, "0x50494e45"},
    {Register::kVersion, 0x04, "version", Access::kRead, kDeviceVersion, "of this table"},
    {Register::kControl, 0x08, "control", Access::kWrite, 0,
     "bit 0: start a frame of triangles in memory; bit 1: reset; bit 2: start one of the triangles "
     "written to triangle_data"},
    {Register::kStatus, 0x0c, "status", Access::kRead, 0,
     "bit 0: busy; bit 1: full, no frame can be started; bit 2: a frame failed since the reset; "
     "bits 8-15: frames started and not done"},
    {Register::kInterruptEnable, 0x10, "interrupt_enable", Access::kReadWrite, 0,
     "bit 0: a frame is done; bit 1: a frame failed"},
    {Register::kInterruptPending, 0x14, "interrupt_pending", Access::kReadWrite, 0,
     "the same bits; a 1 that is written clears its bit"},
    {Register::kFrameSize, 0x18, "frame_size", Access::kReadWrite, 0x00010001,
     "bits 0-15: width, bits 16-31: height, px"},
    {Register::kState, 0x1c, "state", Access::kReadWrite, 1U << 8,
     "bits 0-1: cull (none, back, front); bits 4-7: depth function (less, lequal, off, never, "
     "equal, greater, notequal, gequal, always); bit 8: depth write; bit 9: flat shading"},
    {Register::kScissorMin, 0x20, "scissor_min", Access::kReadWrite, 0,
     "bits 0-15: first column, bits 16-31: first row, px"},
    {Register::kScissorMax, 0x24, "scissor_max", Access::kReadWrite, 0xffffffff,
     "the same of the column and the row behind the last"},
    {Register::kBiasConstant, 0x28, "bias_constant", Access::kReadWrite, 0,
     "low word, signed with the high one, depth codes"},
    {Register::kBiasConstantHigh, 0x2c, "bias_constant_high", Access::kReadWrite, 0, "high word"},
    {Register::kBiasSlope, 0x30, "bias_slope", Access::kReadWrite, 0,
     "-32768 to 32767, units of 1/256"},
    {Register::kClearDepth, 0x34, "clear_depth", Access::kReadWrite, 0x3f800000,
     "binary32, 0 to 1: what the depths were cleared to"},
    {Register::kDepthBase, 0x38, "depth_base", Access::kReadWrite, 0, "address, low word"},
    {Register::kDepthBaseHigh, 0x3c, "depth_base_high", Access::kReadWrite, 0, "high word"},
    {Register::kColorBase, 0x40, "color_base", Access::kReadWrite, 0, "address, low word"},
    {Register::kColorBaseHigh, 0x44, "color_base_high", Access::kReadWrite, 0, "high word"},
    {Register::kTriangleBase, 0x48, "triangle_base", Access::kReadWrite, 0, "address, low word"},
    {Register::kTriangleBaseHigh, 0x4c, "triangle_base_high", Access::kReadWrite, 0, "high word"},
    {Register::kTriangleCount, 0x50, "triangle_count", Access::kReadWrite, 0, "of those in memory"},
    {Register::kTriangleWords, 0x54, "triangle_words", Access::kRead, 0,
     "words of a packed triangle, by the design"},
    {Register::kTriangleData, 0x58, "triangle_data", Access::kWrite, 0,
     "the next word of a triangle for a frame that is started by bit 2 of control"},
    {Register::kFramesDone, 0x5c, "frames_done", Access::kRead, 0, "since the reset"},
    {Register::kCycles, 0x60, "cycles", Access::kRead, 0, "of the last frame done, low word"},
};
inline constexpr size_t kRegisterCount = std::size(kRegisters);

constexpr const RegisterRow& row_of(Register reg) { return kRegisters[static_cast<size_t>(reg)]; }
constexpr uint32_t offset_of(Register reg) { return row_of(reg).offset; }

// Bits of control
inline constexpr uint32_t kStart = 1, kReset = 2, kStartPushed = 4;
// Bits of status
inline constexpr uint32_t kStatusBusy = 1, kStatusFull = 2, kStatusFailed = 4;
inline constexpr int kStatusQueuedShift = 8;
// Bits of the interrupts
inline constexpr uint32_t kInterruptDone = 1, kInterruptFailed = 2;

}  // namespace pineda::timing
