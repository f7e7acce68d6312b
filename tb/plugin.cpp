// The Verilated units of one design behind the C face of plugin.h. The only source that sees a
// Verilator header.
#include "tb/plugin.h"

#include <memory>
#include <string>
#include <vector>

// Tests build plug-ins of some units.
#if __has_include("Vsetup_unit.h")
#include "Vsetup_unit.h"
#define PINEDA_HAS_SETUP
#endif
#if __has_include("Vraster_top.h")
#include "Vraster_top.h"
#include "Vraster_top___024root.h"
#define PINEDA_HAS_TOP
#endif
#if __has_include("Vloopback.h")
#include "Vloopback.h"
#define PINEDA_HAS_LOOPBACK
#endif
#if __has_include("Vtraversal_unit.h")
#include "Vtraversal_unit.h"
#define PINEDA_HAS_TRAVERSAL
#endif
#if __has_include("Vinterp_ztest_unit.h")
#include "Vinterp_ztest_unit.h"
#define PINEDA_HAS_INTERP_ZTEST
#endif
#include "verilated.h"
#if VM_COVERAGE
#include "verilated_cov.h"
#endif
#if VM_TRACE
#include "verilated_fst_c.h"
#endif

struct PinedaRtl {
  virtual ~PinedaRtl() = default;
  virtual void settle() = 0;
  virtual void clock() = 0;
  virtual bool trace(const char*) { return false; }

  VerilatedContext context;
  std::vector<PinedaRtlPort> ports;
};

namespace {

template <class Storage>
PinedaRtlPort port(const char* name, Storage& storage) {
  return {name, &storage, static_cast<uint32_t>(sizeof(storage))};
}

// A unit without waveform.
template <class Model>
struct Unit : PinedaRtl {
  Unit() : model(std::make_unique<Model>(&context)) {
    // Assertions are counted, not fatal: the bench reports them with the case.
    context.errorLimit(1 << 30);
    context.fatalOnError(false);
  }
  ~Unit() override {
    model->final();
    model.reset();
    Verilated::threadContextp(Verilated::defaultContextp());
  }
  void settle() override { model->eval(); }
  void clock() override {
    model->clk_i = 1;
    model->eval();
    model->clk_i = 0;
  }

  std::unique_ptr<Model> model;
};

#define PORT(name) ports.push_back(port(#name, model->name));

// Which of the mutants in a netlist of them runs; 0: none.
#ifdef PINEDA_MUTANTS
#define MUTANT_PORT PORT(mutant_i)
#else
#define MUTANT_PORT
#endif

#ifdef PINEDA_HAS_SETUP
struct Setup : Unit<Vsetup_unit> {
  Setup() {
    PORT(rst_ni)
    MUTANT_PORT
    PORT(frame_i)
    PORT(tri_valid_i)
    PORT(tri_ready_o)
    PORT(tri_i)
    PORT(prim_valid_o)
    PORT(prim_ready_i)
    PORT(prim_o)
    PORT(idle_o)
  }
};
#endif

#ifdef PINEDA_HAS_TRAVERSAL
struct Traversal : Unit<Vtraversal_unit> {
  Traversal() {
    PORT(rst_ni)
    MUTANT_PORT
    PORT(prim_valid_i)
    PORT(prim_ready_o)
    PORT(prim_i)
#ifdef PINEDA_HIERARCHICAL_Z
    PORT(hides_i)
    PORT(z_max_i)
#endif
    PORT(stamp_valid_o)
    PORT(stamp_ready_i)
    PORT(stamp_o)
    PORT(idle_o)
  }
};
#endif

#ifdef PINEDA_DEPTH
#define DEPTH_PORTS       \
  PORT(depth_rd_valid_o)  \
  PORT(depth_rd_ready_i)  \
  PORT(depth_rd_o)        \
  PORT(depth_rsp_valid_i) \
  PORT(depth_rsp_ready_o) \
  PORT(depth_rsp_i)       \
  PORT(depth_wr_valid_o)  \
  PORT(depth_wr_ready_i)  \
  PORT(depth_wr_o)
#else
#define DEPTH_PORTS
#endif
#define MEMORY_PORTS     \
  DEPTH_PORTS            \
  PORT(color_wr_valid_o) \
  PORT(color_wr_ready_i) \
  PORT(color_wr_o)

#ifdef PINEDA_HAS_INTERP_ZTEST
struct InterpZtest : Unit<Vinterp_ztest_unit> {
  InterpZtest() {
    PORT(rst_ni)
    MUTANT_PORT
#ifdef PINEDA_DEPTH
    PORT(depth_func_i)
    PORT(depth_write_i)
#endif
#ifdef PINEDA_HIERARCHICAL_Z
    PORT(frame_width_i)
    PORT(frame_height_i)
#endif
    PORT(stamp_valid_i)
    PORT(stamp_ready_o)
    PORT(stamp_i)
    MEMORY_PORTS
    PORT(idle_o)
  }
};
#endif

#ifdef PINEDA_HAS_LOOPBACK
struct Loopback : Unit<Vloopback> {
  Loopback() {
#include "loopback_ports.inc"
  }
};
#endif

#ifdef PINEDA_HAS_TOP
// The streams between the units of the top, read only.
#define TAP(name) ports.push_back(port(#name, model->rootp->raster_top__DOT__##name));

// Counters of what happened in it: an array of 64-bit counts by kind.
#define COUNTERS(name, where) \
  ports.push_back(port(name, model->rootp->raster_top__DOT__##where##__DOT__count_q.m_storage));

struct Top : Unit<Vraster_top> {
  Top() {
#if VM_TRACE
    context.traceEverOn(true);
#endif
    PORT(rst_ni)
    PORT(frame_valid_i)
    PORT(frame_ready_o)
    PORT(frame_i)
    PORT(end_valid_i)
    PORT(end_ready_o)
    PORT(clear_valid_o)
    PORT(clear_ready_i)
#ifdef PINEDA_DEPTH
    PORT(clear_depth_o)
#endif
    PORT(idle_o)
    PORT(tri_valid_i)
    PORT(tri_ready_o)
    PORT(tri_i)
    MEMORY_PORTS
    TAP(prim_valid)
    TAP(prim_ready)
    TAP(prim)
    TAP(stamp_valid)
    TAP(stamp_ready)
    TAP(stamp)
    COUNTERS("setup_cycles", u_setup__DOT__u_cycles)
    COUNTERS("setup_drops", u_setup__DOT__u_style__DOT__u_drop__DOT__u_drops)
    COUNTERS("tiles_cycles", u_traversal__DOT__u_tiles__DOT__u_cycles)
    COUNTERS("tiles_tests", u_traversal__DOT__u_tiles__DOT__u_tests)
    COUNTERS("coverage_cycles", u_traversal__DOT__u_coverage__DOT__u_cycles)
    COUNTERS("stamps_cycles", u_traversal__DOT__u_stamps__DOT__u_cycles)
    COUNTERS("stamps_sent", u_traversal__DOT__u_stamps__DOT__u_sent)
    COUNTERS("interp_ztest_cycles", u_interp_ztest__DOT__u_cycles)
    COUNTERS("samples_passed", u_interp_ztest__DOT__u_passed)
    COUNTERS("samples_failed", u_interp_ztest__DOT__u_failed)
#ifdef PINEDA_DEPTH
    COUNTERS("depth_read_stalls", u_interp_ztest__DOT__u_depth_read_stalls)
    COUNTERS("depth_write_stalls", u_interp_ztest__DOT__u_depth_write_stalls)
#endif
    COUNTERS("color_write_stalls", u_interp_ztest__DOT__u_color_write_stalls)
    COUNTERS("prims_levels", u_prim_levels)
    COUNTERS("tiles_levels", u_traversal__DOT__u_levels)
    COUNTERS("stamps_levels", u_interp_ztest__DOT__u_levels)
  }
#if VM_TRACE
  ~Top() override {
    if (fst) fst->close();
  }
  void settle() override {
    Unit::settle();
    if (fst) fst->dump(2 * time);
  }
  void clock() override {
    model->clk_i = 1;
    model->eval();
    if (fst) fst->dump(2 * time + 1);
    ++time;
    model->clk_i = 0;
  }
  bool trace(const char* file) override {
    fst = std::make_unique<VerilatedFstC>();
    model->trace(fst.get(), 99);
    fst->open(file);
    return fst->isOpen();
  }

  std::unique_ptr<VerilatedFstC> fst;
  uint64_t time = 0;
#endif
};
#endif

int write_coverage(PinedaRtl* rtl, const char* file) {
#if VM_COVERAGE
  rtl->context.coveragep()->forcePerInstance(true);
  rtl->context.coveragep()->write(file);
  return 1;
#else
  static_cast<void>(rtl);
  static_cast<void>(file);
  return 0;
#endif
}

PinedaRtl* open_unit(const char* name) {
  const std::string unit = name;
  std::unique_ptr<PinedaRtl> rtl;
#ifdef PINEDA_HAS_SETUP
  if (unit == "setup") rtl = std::make_unique<Setup>();
#endif
#ifdef PINEDA_HAS_TRAVERSAL
  if (unit == "traversal") rtl = std::make_unique<Traversal>();
#endif
#ifdef PINEDA_HAS_INTERP_ZTEST
  if (unit == "interp_ztest") rtl = std::make_unique<InterpZtest>();
#endif
#ifdef PINEDA_HAS_LOOPBACK
  if (unit == "loopback") rtl = std::make_unique<Loopback>();
#endif
#ifdef PINEDA_HAS_TOP
  if (unit == "top") rtl = std::make_unique<Top>();
#endif
  if (rtl) rtl->ports.push_back({nullptr, nullptr, 0});
  return rtl.release();
}

const PinedaRtlPlugin kPlugin = {
    kPinedaRtlAbi,
    PINEDA_RTL_DESIGN,
#include "package_hash.inc"
    ,
    open_unit,
    [](PinedaRtl* rtl) { delete rtl; },
    [](PinedaRtl* rtl) -> const PinedaRtlPort* { return rtl->ports.data(); },
    [](PinedaRtl* rtl) { rtl->settle(); },
    [](PinedaRtl* rtl) { rtl->clock(); },
    [](PinedaRtl* rtl) { return static_cast<uint64_t>(rtl->context.errorCount()); },
    [](PinedaRtl* rtl, const char* file) { return rtl->trace(file) ? 1 : 0; },
    write_coverage,
};

}  // namespace

const PinedaRtlPlugin* pineda_rtl_plugin(void) { return &kPlugin; }
