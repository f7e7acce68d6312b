// The page of a study: fronts, designs, triangle sizes. It opens from a file.
#pragma once

#include <string>
#include <vector>

#include "studies/run/results.h"

namespace pineda::cli {

/// Where Debian's libjs-d3 has the library that the page's plots are drawn with.
inline constexpr const char* kD3File = "/usr/share/javascript/d3/d3.min.js";

/// `rows`: of the study, in its order.
///
/// Errors   UsageError: the library or a part of the page is not there.
std::string study_page_html(const studies::Study& study, const std::vector<studies::Row>& rows);

}  // namespace pineda::cli
