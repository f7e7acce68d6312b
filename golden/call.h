// What every call of the C interface does: refuse with one line, and let nothing escape.
#pragma once

#include <fmt/format.h>
#include <pineda/golden.h>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace pineda::golden {

/// A call is refused.
struct Refused : std::runtime_error {
  Refused(pineda_status why, const std::string& what) : std::runtime_error(what), status(why) {}
  pineda_status status;
};

template <class... Args>
[[noreturn]] void refuse(pineda_status status, const char* format, const Args&... args) {
  throw Refused(status, fmt::format(fmt::runtime(format), args...));
}

inline void require_pointer(const void* pointer, const char* name) {
  if (pointer == nullptr) refuse(PINEDA_NULL_POINTER, "{}: expected a pointer, got null", name);
}

/// Runs what checks the i-th of some things; what it refuses is called "NAME[I].what it says".
template <class Work>
auto checked(const char* name, size_t i, Work&& work) {
  try {
    return work();
  } catch (const Refused& refused) {
    throw Refused(refused.status, fmt::format("{}[{}].{}", name, i, refused.what()));
  }
}

/// Keeps the text for pineda_last_error(), as much of it as there is room for.
void keep_error(const char* text) noexcept;

/// Runs what a call does; the status of what it throws.
template <class Work>
pineda_status call(Work&& work) noexcept {
  try {
    work();
    return PINEDA_OK;
  } catch (const Refused& refused) {
    keep_error(refused.what());
    return refused.status;
  } catch (const std::bad_alloc&) {
    keep_error("out of memory");
    return PINEDA_OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    keep_error("out of memory");
    return PINEDA_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    keep_error(error.what());
    return PINEDA_INTERNAL;
  } catch (...) {
    keep_error("an exception of no known type");
    return PINEDA_INTERNAL;
  }
}

}  // namespace pineda::golden
