# Builds the bench plug-in of one design: its top alone, as fast as it can be simulated. No
# assertions, no waveform, no taps, no counters.
#
#   make -f tb/bench_plugin.mk DESIGN=high_tile EMIT=build/bin/emit_package WORK=dir OUT=file.so CXX=g++
SOURCE ?= $(abspath $(dir $(lastword $(MAKEFILE_LIST)))/..)
VERILATOR ?= verilator
CXXFLAGS ?= -O3
# As in plugin.mk.
VERILATOR_WARNINGS ?= -Wall -Wno-fatal
RTL := $(SOURCE)/rtl
# The package comes first; every design has its own.
RTL_SOURCES := $(addprefix $(RTL)/,$(filter-out pineda_pkg.sv,$(shell cat $(RTL)/files.f)))
SELF := $(firstword $(MAKEFILE_LIST))

VERILATOR_ROOT := $(shell $(VERILATOR) --getenv VERILATOR_ROOT)
FLAGS := --cc -O3 --unroll-count 256 --x-assign fast --x-initial fast $(VERILATOR_WARNINGS)
# What the design has, as the package says.
PARTS = $(shell sed -n 's/^`define \(PINEDA_[A-Z_]*\)$$/-D\1/p' $(WORK)/pineda_pkg.sv)
RUNTIME := $(VERILATOR_ROOT)/include/verilated.cpp $(VERILATOR_ROOT)/include/verilated_threads.cpp

.PHONY: all
all: $(OUT)

COMPILE = $(CXX) -std=c++17 $(CXXFLAGS) -fPIC -fno-plt -fno-semantic-interposition -w \
  -DVM_TRACE=0 -DVM_SC=0 -DVM_COVERAGE=0 -I$(SOURCE) -I$(WORK) -I$(WORK)/top \
  -isystem $(VERILATOR_ROOT)/include -isystem $(VERILATOR_ROOT)/include/vltstd

# A triangle's number has 32 bits in simulation.
$(WORK)/package_constants.inc: $(EMIT)
	mkdir -p $(WORK)
	$(EMIT) $(DESIGN) $(WORK) --bench
	sed -n -e '/ ID_BITS *=/d' -e 's/ID_BITS/32/' \
	  -e 's/^  localparam int unsigned \([A-Z0-9_]*\) *= \([0-9 +]*\);.*/constexpr int \1 = \2;/p' \
	  $(WORK)/pineda_pkg.sv > $@

$(WORK)/top.stamp: $(WORK)/package_constants.inc $(RTL_SOURCES) $(RTL)/lint/waivers.vlt $(SELF)
	$(VERILATOR) $(FLAGS) --prefix Vraster_top --Mdir $(WORK)/top --top-module raster_top \
	  $(RTL)/lint/waivers.vlt $(WORK)/pineda_pkg.sv $(RTL_SOURCES)
	touch $@

# All of it is one source, so that the compiler sees the loop, the evaluation and the model at once.
$(WORK)/bench.cpp: $(WORK)/top.stamp
	for file in $(WORK)/top/*.cpp $(SOURCE)/tb/bench_plugin.cpp; do \
	  echo "#include \"$$file\""; done > $@

# Only the plug-in's one symbol leaves it: two plug-ins must not share Verilator's globals.
$(OUT): $(WORK)/bench.cpp $(SOURCE)/tb/bench_plugin.cpp $(SOURCE)/tb/bench_plugin.h
	mkdir -p $(dir $(OUT))
	$(COMPILE) $(PARTS) -DPINEDA_RTL_DESIGN='"$(DESIGN)"' -shared -Wl,-Bsymbolic \
	  -Wl,--version-script=$(SOURCE)/tb/plugin.map $< $(RUNTIME) -lpthread -latomic -o $(OUT).part
	mv $(OUT).part $(OUT)
