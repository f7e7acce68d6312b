// Checks of SVG and HTML for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace pineda::studies {

/// How often `part` occurs.
int count(const std::string& text, const std::string& part);

/// Every element is closed, in order, and has its attributes in pairs of quotes.
testing::AssertionResult is_well_formed(const std::string& svg);

/// A name that would act as markup, a script and two paths if it were not escaped.
inline constexpr const char* kHostileName = "../<script>\"&'\n</svg>";

}  // namespace pineda::studies
