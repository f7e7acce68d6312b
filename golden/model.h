// What stands behind a handle of pineda/golden.h.
#pragma once

#include <mutex>
#include <optional>

#include "golden/call.h"
#include "model/fast/renderer.h"

struct pineda_model {
  explicit pineda_model(const pineda::spec::Design& design)
      : contract(pineda::spec::contract(design)) {}

  std::mutex mutex;
  pineda::spec::Contract contract;
  std::optional<pineda::fast::Renderer> renderer;  // of the frame
};

namespace pineda::golden {

/// A call on a model, alone on it.
template <class Work>
pineda_status call_on(pineda_model* model, Work&& work) noexcept {
  return call([&] {
    require_pointer(model, "model");
    const std::lock_guard<std::mutex> lock(model->mutex);
    work(model->contract);
  });
}

}  // namespace pineda::golden
