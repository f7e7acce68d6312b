#include "model/memory/kinds.h"

#include <vector>

namespace pineda::memory {

std::string kinds_text() {
  std::vector<std::string> texts;
  for (const KindName& kind : kKindNames) {
    const std::string meaning = kind.meaning;
    texts.push_back(kind.word + (meaning.empty() ? "" : " (" + meaning + ")"));
  }
  return spec::joined(texts, ", ", " or ");
}

}  // namespace pineda::memory
