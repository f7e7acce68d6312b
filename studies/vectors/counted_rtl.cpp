#include "studies/vectors/counted_rtl.h"

#include "tb/work_folder.h"

namespace pineda::vectors {

const char* module_of(Unit unit) {
  switch (unit) {
    case Unit::kSetup:
      return "setup_unit";
    case Unit::kTraversal:
      return "traversal_unit";
    case Unit::kInterpZtest:
      return "interp_ztest_unit";
    case Unit::kFrame:
      break;
  }
  return "raster_top";
}

void add_counts(const std::function<bool(const std::string&)>& write, CodeCounts* counts) {
  const tb::WorkFolder folder(tb::plugin_cache_folder(), "coverage");
  const std::string file = folder.path() / "coverage.dat";
  if (write(file)) counts->add(file);
}

}  // namespace pineda::vectors
