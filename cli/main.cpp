// pineda: a bit-exact, cycle-approximate hardware rasterizer. One program, a command a task.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <new>
#include <systemc>

#include "cli/options.h"
#include "cli/output.h"
#include "model/files/unfinished.h"
#include "model/spec/design_file.h"
#include "tb/rtl.h"

namespace {

bool is_command(const CLI::App& program, const std::string& name) {
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return true;
  }
  return false;
}

int run(int argc, char** argv) {
  using namespace pineda;
  CLI::App program{
      "A bit-exact, cycle-approximate hardware rasterizer: functional model, SystemC "
      "model and Verilated RTL.\nExit: 0 = it holds, 1 = a mismatch or a bound broken, "
      "2 = bad usage or bad input.",
      "pineda"};
  program.set_version_flag("--version", "pineda " PINEDA_VERSION);
  program.require_subcommand(1);
  program.get_formatter()->column_width(28);
  int exit_code = cli::kHolds;
  cli::add_check(&program, &exit_code);
  cli::add_render(&program, &exit_code);
  cli::add_time(&program, &exit_code);
  cli::add_rtl(&program, &exit_code);
  cli::add_error(&program, &exit_code);
  cli::add_study(&program, &exit_code);
  cli::add_judge(&program, &exit_code);
  cli::add_vectors(&program, &exit_code);
  cli::add_needs(&program, &exit_code);
  cli::add_walk(&program, &exit_code);
  cli::add_designs(&program, &exit_code);
  cli::add_scenes(&program, &exit_code);
  try {
    if (argc < 2) throw cli::UsageError("expected a command (see pineda --help)");
    if (argv[1][0] != '-' && !is_command(program, argv[1])) {
      throw cli::UsageError(
          fmt::format("expected a command, got '{}' (see pineda --help)", argv[1]));
    }
    program.parse(argc, argv);
    cli::flush_stdout();
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "pineda: {} (see pineda --help)\n", error.what());
    return cli::kBadInput;
  } catch (const cli::UsageError& error) {
    fmt::print(stderr, "pineda: {}\n", error.what());
    return cli::kBadInput;
  } catch (const spec::DesignFileError& error) {
    fmt::print(stderr, "pineda: {}\n", error.what());
    return cli::kBadInput;
  } catch (const scene::InputError& error) {
    fmt::print(stderr, "pineda: {}\n", error.what());
    return cli::kBadInput;
  } catch (const tb::PluginError& error) {
    fmt::print(stderr, "pineda: RTL: {}\n", error.what());
    return cli::kBadInput;
  } catch (const tb::RtlError& error) {
    fmt::print(stderr, "pineda: RTL: {}\n", error.what());
    return cli::kMismatch;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "pineda: not enough memory for this scene\n");
    return cli::kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pineda: {}\n", error.what());
    return cli::kBadInput;
  }
  return exit_code;
}

}  // namespace

// SystemC calls this from sc_elab_and_sim().
int sc_main(int argc, char** argv) { return run(argc, argv); }

int main(int argc, char** argv) {
  // SystemC's banner must not appear in a command's output.
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  pineda::files::remove_unfinished_on_signals();
  return sc_core::sc_elab_and_sim(argc, argv);
}
