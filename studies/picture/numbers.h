// Figures as a table or a picture shows them.
#pragma once

#include <cstdint>
#include <string>

namespace pineda::studies {

/// Three significant digits, in five characters at most up to 9.9e9: "0", "<.001", "0.544", "12.3",
/// "4211", "1.2e5". `value` is not negative.
std::string figure(double value);

/// A count, exact up to six digits: "123,456", "1.2e6".
std::string count_figure(uint64_t count);

/// "1,234,567".
std::string grouped(uint64_t count);

}  // namespace pineda::studies
