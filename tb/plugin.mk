# Builds the plug-in of one design: package -> Verilator -> shared library. CMake calls it for the
# named designs.
#
#   make -f tb/plugin.mk DESIGN=high_tile EMIT=build/bin/emit_package WORK=dir OUT=file.so
#
# COVERAGE=1: with counters of lines and of bits that change, without waveforms.
SOURCE ?= $(abspath $(dir $(lastword $(MAKEFILE_LIST)))/..)
VERILATOR ?= verilator
CXXFLAGS ?= -O3
# -Wall makes each of its warnings fatal. Other versions have others: those fail no user's build.
VERILATOR_WARNINGS ?= -Wall -Wno-fatal
RTL := $(SOURCE)/rtl
# A plug-in has the units that it is built from.
UNITS ?= setup_unit traversal_unit interp_ztest_unit raster_top loopback
# The package comes first; every design has its own.
RTL_SOURCES := $(addprefix $(RTL)/,$(filter-out pineda_pkg.sv,$(shell cat $(RTL)/files.f)))
LINT := $(RTL)/lint/waivers.vlt
SELF := $(firstword $(MAKEFILE_LIST))

VERILATOR_ROOT := $(shell $(VERILATOR) --getenv VERILATOR_ROOT)
# Loops over the in-flight table are longer than what Verilator unrolls by itself.
FLAGS := --cc -O3 --unroll-count 256 --x-assign fast --x-initial fast --assert $(VERILATOR_WARNINGS) \
  $(if $(COVERAGE),--coverage-line --coverage-toggle) --prefix
# What the design has, as the package says.
PARTS = $(shell sed -n 's/^`define \(PINEDA_[A-Z_]*\)$$/-D\1/p' $(WORK)/pineda_pkg.sv)
RUNTIME := verilated verilated_threads $(if $(COVERAGE),verilated_cov,verilated_fst_c)
TRACE := $(if $(COVERAGE),0,1)

# A second make, once the generated sources exist and can be listed.
ifneq ($(STAGE),objects)

.PHONY: all
all: $(UNITS:%=$(WORK)/%.stamp)
	+$(MAKE) --no-print-directory -f $(SELF) STAGE=objects $(OUT)

# What stays the same keeps its time, so that not every change of the contract builds every design.
$(WORK)/pineda_pkg.sv: $(EMIT)
	mkdir -p $(WORK)/emitted
	$(EMIT) $(DESIGN) $(WORK)/emitted --bench
	cd $(WORK)/emitted && for file in *; do cmp -s $$file ../$$file || cp $$file ..; done

# A unit's sources become two, since most of their time goes into the headers that each includes. What runs
# once a model stands apart: optimizing it takes half of a build and gains nothing.
define bundle
	cd $(@:.stamp=) && ls *.cpp | grep -v -e __Slow.cpp -e __Syms.cpp | sed 's/.*/#include "&"/' > often.cc
	cd $(@:.stamp=) && ls *.cpp | grep -e __Slow.cpp -e __Syms.cpp | sed 's/.*/#include "&"/' > once.cc
	touch $@
endef

# With counters of what the cycles are spent on. Sources of an earlier run must not be compiled again.
$(WORK)/raster_top.stamp: $(WORK)/pineda_pkg.sv $(RTL_SOURCES) $(LINT) $(RTL)/lint/taps.vlt $(SELF)
	rm -f $(WORK)/raster_top/*.cpp
	$(VERILATOR) $(FLAGS) Vraster_top $(if $(COVERAGE),,--trace-fst) -DPINEDA_COUNTERS --Mdir $(WORK)/raster_top \
	  --top-module raster_top $(LINT) $(RTL)/lint/taps.vlt $< $(RTL_SOURCES)
	$(bundle)

$(WORK)/loopback.stamp: $(WORK)/pineda_pkg.sv $(SELF)
	rm -f $(WORK)/loopback/*.cpp
	$(VERILATOR) $(FLAGS) Vloopback -Wno-UNUSEDSIGNAL --Mdir $(WORK)/loopback \
	  --top-module loopback $(LINT) $< $(WORK)/loopback.sv
	$(bundle)

$(WORK)/%.stamp: $(WORK)/pineda_pkg.sv $(RTL_SOURCES) $(LINT) $(SELF)
	rm -f $(WORK)/$*/*.cpp
	$(VERILATOR) $(FLAGS) V$* --Mdir $(WORK)/$* --top-module $* $(LINT) $< $(RTL_SOURCES)
	$(bundle)

else

OFTEN := $(UNITS:%=$(WORK)/%/often.o)
ONCE := $(UNITS:%=$(WORK)/%/once.o)
# Verilator's library: who builds several plug-ins brings it as an archive.
RUNTIME_OBJECTS ?= $(RUNTIME:%=$(WORK)/%.o)
OBJECTS := $(OFTEN) $(ONCE) $(WORK)/plugin.o $(RUNTIME_OBJECTS)
COMPILE = $(CXX) -std=c++17 $(CXXFLAGS) -fPIC -w -DVM_TRACE=$(TRACE) -DVM_TRACE_FST=$(TRACE) -DVM_SC=0 \
  -DVM_COVERAGE=$(if $(COVERAGE),1,0) -I$(SOURCE) -I$(WORK) $(UNITS:%=-I$(WORK)/%) \
  -isystem $(VERILATOR_ROOT)/include -isystem $(VERILATOR_ROOT)/include/vltstd

# Only the plug-in's one symbol leaves it: two plug-ins must not share Verilator's globals.
$(OUT): $(OBJECTS)
	mkdir -p $(dir $(OUT))
	$(CXX) -shared -Wl,-Bsymbolic -Wl,--version-script=$(SOURCE)/tb/plugin.map $^ -lz -lpthread \
	  -o $(OUT).part
	mv $(OUT).part $(OUT)

$(WORK)/plugin.o: $(SOURCE)/tb/plugin.cpp $(SOURCE)/tb/plugin.h $(UNITS:%=$(WORK)/%.stamp)
	$(COMPILE) $(PARTS) -DPINEDA_RTL_DESIGN='"$(DESIGN)"' -c $< -o $@

$(RUNTIME:%=$(WORK)/%.o): $(WORK)/%.o: $(VERILATOR_ROOT)/include/%.cpp
	$(COMPILE) -c $< -o $@

$(OFTEN): %.o: %.cc
	$(COMPILE) -c $< -o $@

$(ONCE): %.o: %.cc
	$(COMPILE) -O0 -c $< -o $@

endif
